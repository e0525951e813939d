#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace rockslope {

/// A file that was read, and the SHA-256 digest of the bytes that were read.
struct InputFile {
    std::filesystem::path path;
    std::string sha256;
};

/// The files that read_text_file() reads in this thread during the life of the log, in the order of their
/// first reading. A digest of the bytes themselves cannot be that of a file that changed after it was read.
/// @throws InputError, from the reading, when a file that is read again has changed.
class ReadLog {
  public:
    /// Begins to note the files that this thread reads.
    ReadLog();
    ~ReadLog();
    ReadLog(const ReadLog&) = delete;
    ReadLog& operator=(const ReadLog&) = delete;

    /// The files read so far.
    const std::vector<InputFile>& files() const { return files_; }
    /// The digest of a file read under this path; empty if there is none.
    std::string digest_of(const std::filesystem::path& path) const;

    /// Adds a file to the log of this thread, if there is one.
    static void add(const std::filesystem::path& path, std::string_view bytes);

  private:
    ReadLog* outer_;
    std::vector<InputFile> files_;
};

}  // namespace rockslope
