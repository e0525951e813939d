#include "common/base/atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

#include "common/base/output_error.hpp"

namespace rockslope {

namespace {

/// An open file descriptor that is closed at the end of its scope.
class Descriptor {
  public:
    Descriptor(const std::filesystem::path& path, int flags)
        : number_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {}
    ~Descriptor() {
        if (number_ >= 0) ::close(number_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    bool open() const { return number_ >= 0; }
    bool write(std::string_view content) const {
        while (!content.empty()) {
            const ssize_t count = ::write(number_, content.data(), content.size());
            if (count < 0 && errno == EINTR) continue;
            if (count < 0) return false;
            content.remove_prefix(count);
        }
        return true;
    }
    bool sync() const { return ::fsync(number_) == 0; }
    bool close() {
        const int number = number_;
        number_ = -1;
        return ::close(number) == 0;
    }

  private:
    int number_;
};

[[noreturn]] void fail(const std::filesystem::path& path) {
    throw OutputError(path, std::string("cannot be written: ") + std::strerror(errno));
}

bool is_special(const std::filesystem::path& path) {
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    return std::filesystem::exists(status) && !std::filesystem::is_regular_file(status);
}

void write_in_place(const std::filesystem::path& path, std::string_view content) {
    Descriptor file(path, O_WRONLY);
    if (!file.open() || !file.write(content) || !file.close()) fail(path);
}

}  // namespace

void write_file_atomically(const std::filesystem::path& path, std::string_view content) {
    if (is_special(path)) return write_in_place(path, content);
    const std::filesystem::path temporary = path.string() + ".tmp" + std::to_string(::getpid());
    Descriptor file(temporary, O_WRONLY | O_CREAT | O_TRUNC);
    if (!file.open()) fail(path);
    const bool written = file.write(content) && file.sync() && file.close();
    if (!written || ::rename(temporary.c_str(), path.c_str()) != 0) {
        const int reason = errno;
        ::unlink(temporary.c_str());
        errno = reason;
        fail(path);
    }
}

}  // namespace rockslope
