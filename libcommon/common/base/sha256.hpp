#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace rockslope {

/// The SHA-256 digest (FIPS 180-4) of bytes that come in pieces.
class Sha256 {
  public:
    /// Begins with no bytes.
    Sha256();
    /// Takes further bytes.
    void add(std::string_view bytes);
    /// The digest of the bytes so far in lower-case hexadecimal, as sha256sum prints it.
    std::string digest() const;

  private:
    std::array<std::uint32_t, 8> state_;
    std::uint64_t length_ = 0;  ///< bytes so far
    std::string rest_;          ///< bytes after the last whole block
};

/// Takes the first bytes of a file. @throws OutputError when the file cannot be read so far.
Sha256 sha256_of_beginning(const std::filesystem::path& file, std::uintmax_t length);

/// The SHA-256 digest of the bytes, see Sha256::digest().
std::string sha256(std::string_view bytes);

}  // namespace rockslope
