#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "common/base/sha256.hpp"

namespace rockslope::dda {

/// Builds a row of a CSV file.
class CsvRow {
  public:
    explicit CsvRow(const std::filesystem::path& path) : path_(path) {}

    CsvRow& text(std::string_view value);  ///< quoted if it has a comma, quote or line break
    CsvRow& integer(std::int64_t value);
    /// Appends the shortest decimal that reads back to the same double. @throws OutputError that names `what`
    /// if the value is not finite.
    CsvRow& number(double value, std::string_view what);
    std::string line() const { return line_ + '\n'; }

  private:
    CsvRow& field(std::string_view value);

    const std::filesystem::path& path_;
    std::string line_;
    bool first_ = true;
};

/// A text file that grows by whole lines. append() writes without buffering; lines that do not fit on the
/// disk are removed again.
class CsvFile {
  public:
    /// Creates a file or, with `resume_from`, goes on in an existing one from so many bytes on. Lines that it
    /// has beyond stay as long as append() writes the same ones, and are cut off before the first other one.
    /// @throws OutputError.
    CsvFile(std::filesystem::path path, std::optional<std::int64_t> resume_from);
    ~CsvFile();
    CsvFile(const CsvFile&) = delete;
    CsvFile& operator=(const CsvFile&) = delete;

    void append(std::string_view lines);
    /// Cuts off the lines of an earlier run that were not written again.
    void cut();
    /// Waits until the lines are on the disk.
    void sync();
    std::int64_t size() const { return size_; }
    /// The digest of these bytes.
    std::string digest() const { return written_.digest(); }
    const std::filesystem::path& path() const { return path_; }
    CsvRow row() const { return CsvRow(path_); }

  private:
    bool has_next(std::string_view lines) const;
    void write_at_end(std::string_view lines);
    [[noreturn]] void fail(const std::string& what, int reason) const;

    std::filesystem::path path_;
    int descriptor_ = -1;
    std::int64_t size_ = 0;      ///< bytes written, or found as they would be written
    Sha256 written_;             ///< of these bytes
    std::int64_t old_size_ = 0;  ///< where the file that a resumed run found ends; 0 once it is cut
};

}  // namespace rockslope::dda
