#include "common/base/atomic_file.hpp"

#include <fcntl.h>
#include <sys/random.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>

#include "common/base/output_error.hpp"

namespace rockslope {

namespace fs = std::filesystem;

namespace {

/// The end of a random name: ".tmp" and so many hexadecimal digits.
constexpr std::string_view mark = ".tmp";
constexpr std::size_t random_digits = 12;

std::string random_ending() {
    std::uint64_t bits = 0;
    // Without a source of random numbers the address and the process have to do; O_EXCL still holds.
    if (::getrandom(&bits, sizeof bits, 0) != sizeof bits)
        bits = reinterpret_cast<std::uintptr_t>(&bits) * 0x9e3779b97f4a7c15u + ::getpid();
    std::string ending(mark);
    for (std::size_t k = 0; k < random_digits; ++k, bits >>= 4u) ending += "0123456789abcdef"[bits & 15u];
    return ending;
}

bool is_random_name(const std::string& name) {
    constexpr std::size_t length = mark.size() + random_digits;
    if (name.size() <= length || name.compare(name.size() - length, mark.size(), mark) != 0) return false;
    return name.find_first_not_of("0123456789abcdef", name.size() - random_digits) == std::string::npos;
}

bool write_all(int descriptor, std::string_view content) {
    while (!content.empty()) {
        const ssize_t count = ::write(descriptor, content.data(), content.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return false;
        content.remove_prefix(static_cast<std::size_t>(count));
    }
    return true;
}

[[noreturn]] void cannot_write(const fs::path& path) {
    throw OutputError(path, std::string("cannot be written: ") + std::strerror(errno));
}

bool is_special(const fs::path& path) {
    std::error_code error;
    const auto status = fs::status(path, error);
    return fs::exists(status) && !fs::is_regular_file(status);
}

/// Writes to an existing file, terminal, pipe or device, and closes it.
class FileInPlace {
  public:
    explicit FileInPlace(const fs::path& path)
        : path_(path), descriptor_(::open(path.c_str(), O_WRONLY | O_CLOEXEC)) {
        if (descriptor_ < 0) cannot_write(path_);
    }
    ~FileInPlace() {
        if (descriptor_ >= 0) ::close(descriptor_);
    }
    FileInPlace(const FileInPlace&) = delete;
    FileInPlace& operator=(const FileInPlace&) = delete;

    void append(std::string_view bytes) const {
        if (!write_all(descriptor_, bytes)) cannot_write(path_);
    }
    void close() {
        if (::close(std::exchange(descriptor_, -1)) != 0) cannot_write(path_);
    }

  private:
    const fs::path& path_;
    int descriptor_;
};

/// Waits until the names in a folder are on the disk. Not every file system can do this for a folder.
bool sync_folder(const fs::path& folder) {
    const int descriptor = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) return errno == EACCES;  // a folder may be written to and not be read
    const bool is_synced = ::fsync(descriptor) == 0 || errno == EINVAL || errno == ENOTSUP || errno == EBADF;
    const int reason = errno;
    ::close(descriptor);
    errno = reason;
    return is_synced;
}

}  // namespace

PendingFile::PendingFile(fs::path path) : path_(std::move(path)) {
    do {
        temporary_ = path_.string() + random_ending();
        descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    } while (descriptor_ < 0 && errno == EEXIST);
    if (descriptor_ < 0) fail();
}

PendingFile::~PendingFile() {
    if (descriptor_ < 0) return;
    ::close(descriptor_);
    ::unlink(temporary_.c_str());
}

void PendingFile::fail() const {
    cannot_write(path_);
}

void PendingFile::append(std::string_view bytes) {
    if (::lseek(descriptor_, 0, SEEK_END) < 0 || !write_all(descriptor_, bytes)) fail();
}

void PendingFile::put_in_place() {
    if (::fsync(descriptor_) != 0 || ::rename(temporary_.c_str(), path_.c_str()) != 0) fail();
    if (::close(std::exchange(descriptor_, -1)) != 0 || !sync_folder(path_.parent_path())) fail();
}

void write_file_atomically(const fs::path& path, std::string_view content) {
    write_pieces_atomically(path, [&](FunctionRef<void(std::string_view)> append) { append(content); });
}

void write_pieces_atomically(const fs::path& path,
                             FunctionRef<void(FunctionRef<void(std::string_view)>)> write_pieces) {
    if (is_special(path)) {
        FileInPlace file(path);
        write_pieces([&](std::string_view bytes) { file.append(bytes); });
        file.close();
        return;
    }
    PendingFile file(path);
    write_pieces([&](std::string_view bytes) { file.append(bytes); });
    file.put_in_place();
}

void sync_file(const fs::path& path) {
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) cannot_write(path);
    const bool is_synced = ::fsync(descriptor) == 0 || errno == EINVAL || errno == ENOTSUP;
    const int reason = errno;
    ::close(descriptor);
    errno = reason;
    if (!is_synced) cannot_write(path);
}

void remove_abandoned_files(const fs::path& folder) {
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
        if (is_random_name(entry.path().filename().string())) fs::remove(entry.path(), ignored);
}

}  // namespace rockslope
