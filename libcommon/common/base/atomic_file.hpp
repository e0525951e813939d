#pragma once

#include <filesystem>
#include <string_view>

#include "common/base/function_ref.hpp"

namespace rockslope {

/// A file that takes a name when it is complete. Until then it has a random name in the same folder, which no
/// other file and no link had. A reader, or Make, never sees a partial file, and an existing file survives a
/// failure.
class PendingFile {
  public:
    /// Opens the file under its random name. @throws OutputError with `path` and the system's reason.
    explicit PendingFile(std::filesystem::path path);
    /// Removes the file unless it was put in place.
    ~PendingFile();
    PendingFile(const PendingFile&) = delete;
    PendingFile& operator=(const PendingFile&) = delete;

    /// Where the file is until it is put in place.
    const std::filesystem::path& temporary() const { return temporary_; }
    /// Writes at the end of the file. @throws OutputError.
    void append(std::string_view bytes);
    /// Gives the file its name once its bytes are on the disk, and returns when the name is. @throws
    /// OutputError.
    void put_in_place();

  private:
    [[noreturn]] void fail() const;

    std::filesystem::path path_;
    std::filesystem::path temporary_;
    int descriptor_ = -1;
};

/// Writes a whole file as a PendingFile. The bytes are exactly `content`. A path that exists and is not a
/// regular file (a terminal, a pipe, a device) is written to directly.
/// @throws OutputError with the path and the system's reason (not writable, disk full, no such directory).
void write_file_atomically(const std::filesystem::path& path, std::string_view content);

/// As above, from pieces, so that the whole content need not be in memory: write_pieces(append) calls append
/// with one piece after the other.
void write_pieces_atomically(const std::filesystem::path& path,
                             FunctionRef<void(FunctionRef<void(std::string_view)> append)> write_pieces);

/// Waits until the bytes of a file are on the disk, also those that another program wrote. Not every file
/// system can do this. @throws OutputError.
void sync_file(const std::filesystem::path& path);

/// Removes the files that killed programs left in a folder under the random names of a PendingFile. No other
/// program may be writing there.
void remove_abandoned_files(const std::filesystem::path& folder);

}  // namespace rockslope
