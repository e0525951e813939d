#pragma once

#include <filesystem>

namespace rockslope {

/// The right of one run to write into a folder, for the life of this object. It ends with the process, also
/// when that is killed. The file `.dda-run.lock` in the folder names the machine and the process meanwhile.
class FolderLock {
  public:
    /// @param folder exists. @throws InputError with the process of the other run where there is one,
    /// OutputError where the file cannot be made.
    explicit FolderLock(const std::filesystem::path& folder);
    /// Removes the file.
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

  private:
    std::filesystem::path file_;
    int descriptor_ = -1;
};

}  // namespace rockslope
