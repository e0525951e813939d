#include "folder_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <string>

#include "common/base/input_error.hpp"
#include "common/base/output_error.hpp"

namespace rockslope {

namespace fs = std::filesystem;

namespace {

/// The first line of an open file.
std::string first_line(int descriptor) {
    std::array<char, 256> text{};
    const ssize_t count = ::pread(descriptor, text.data(), text.size(), 0);
    const std::string whole(text.data(), count > 0 ? static_cast<std::size_t>(count) : 0);
    return whole.substr(0, whole.find('\n'));
}

[[noreturn]] void refuse(const fs::path& folder, const std::string& owner) {
    throw InputError({folder.string()},
                     "another run writes its results here: " + (owner.empty() ? "it just began" : owner),
                     "another folder, or that run to end");
}

/// Whether the open file is still the one of this name: a run that ends removes its file.
bool is_named(int descriptor, const fs::path& file) {
    struct stat open {};
    struct stat named {};
    return ::fstat(descriptor, &open) == 0 && ::stat(file.c_str(), &named) == 0 &&
           open.st_dev == named.st_dev && open.st_ino == named.st_ino;
}

/// Notes who has the lock. On a full disk nobody can be told.
void name_owner(int descriptor) {
    std::array<char, 200> host{};
    ::gethostname(host.data(), host.size() - 1);
    const std::string owner = "process " + std::to_string(::getpid()) + " on " + host.data() + "\n";
    if (::ftruncate(descriptor, 0) == 0 && ::pwrite(descriptor, owner.data(), owner.size(), 0) < 0) return;
}

}  // namespace

FolderLock::FolderLock(const fs::path& folder) : file_(folder / ".dda-run.lock") {
    do {
        if (descriptor_ >= 0) ::close(descriptor_);
        descriptor_ = ::open(file_.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
        if (descriptor_ < 0)
            throw OutputError(file_, std::string("cannot be written: ") + std::strerror(errno));
        if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) continue;
        const std::string owner = first_line(descriptor_);
        ::close(descriptor_);
        refuse(folder, owner);
    } while (!is_named(descriptor_, file_));
    name_owner(descriptor_);
}

FolderLock::~FolderLock() {
    ::unlink(file_.c_str());
    ::close(descriptor_);
}

}  // namespace rockslope
