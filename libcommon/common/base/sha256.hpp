#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

// OpenSSL's, which this header does not include.
struct evp_md_ctx_st;

namespace rockslope {

/// The SHA-256 digest (FIPS 180-4) of bytes that come in pieces, by OpenSSL.
class Sha256 {
  public:
    /// Begins with no bytes. @throws std::bad_alloc
    Sha256();
    Sha256(const Sha256& other);
    Sha256(Sha256&&) noexcept = default;
    Sha256& operator=(const Sha256& other);
    Sha256& operator=(Sha256&&) noexcept = default;
    ~Sha256() = default;

    /// Takes further bytes.
    void add(std::string_view bytes);
    /// The digest of the bytes so far in lower-case hexadecimal, as sha256sum prints it.
    std::string digest() const;

  private:
    struct Free {
        void operator()(evp_md_ctx_st* context) const;
    };
    std::unique_ptr<evp_md_ctx_st, Free> context_;
};

/// Takes the first bytes of a file. @throws OutputError when the file cannot be read so far.
Sha256 sha256_of_beginning(const std::filesystem::path& file, std::uintmax_t length);

/// The SHA-256 digest of the bytes, see Sha256::digest().
std::string sha256(std::string_view bytes);

}  // namespace rockslope
