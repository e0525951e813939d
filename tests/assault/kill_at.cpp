// A library to be loaded before others (LD_PRELOAD), which kills the program at a chosen moment: in the call
// number ASSAULT_KILL_AT among those that change a file below the folder ASSAULT_FOLDER, or one there whose
// path has the text ASSAULT_FILE. Of a write, the odd ones among the calls, the first half happens.
// ASSAULT_DISK names a folder that gets what would be on the disk after a power cut: of each file the bytes
// of its last fsync, by the number of its inode, and in `names` those that the last fsync of its folder made
// last, each with its inode.
// ASSAULT_TRACE names a file that gets, at the end, the number of calls and, of a killed program, the call
// and its file.

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <climits>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

namespace {

std::atomic<long> calls{0};

const char* folder() {
    static const char* const path = std::getenv("ASSAULT_FOLDER");
    return path;
}

long moment() {
    static const char* const text = std::getenv("ASSAULT_KILL_AT");
    static const long number = text != nullptr ? std::atol(text) : LONG_MAX;
    return number;
}

template <class Function>
Function* original(const char* name) {
    return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

bool is_watched(const char* path) {
    if (folder() == nullptr) return false;
    const std::size_t length = std::strlen(folder());
    char whole[PATH_MAX];
    if (path[0] != '/') {
        char here[PATH_MAX / 2];
        if (::getcwd(here, sizeof here) == nullptr) return false;
        std::snprintf(whole, sizeof whole, "%s/%.2000s", here, path);
        path = whole;
    }
    static const char* const file = std::getenv("ASSAULT_FILE");
    return std::strncmp(path, folder(), length) == 0 &&
           (file == nullptr || std::strstr(path, file) != nullptr);
}

void trace(const char* call, const char* path) {
    const char* const file = std::getenv("ASSAULT_TRACE");
    if (file == nullptr) return;
    static auto* const really_write = original<ssize_t(int, const void*, size_t)>("write");
    char line[PATH_MAX + 100];
    const int length = std::snprintf(line, sizeof line, "%ld %s %s\n", calls.load(), call, path);
    const int descriptor = ::open(file, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (descriptor >= 0 && really_write(descriptor, line, static_cast<std::size_t>(length)) == length)
        ::close(descriptor);
}

/// Counts a call. @return whether it is the one to be killed in.
bool is_moment(const char* path) {
    return is_watched(path) && ++calls == moment();
}

[[noreturn]] void die(const char* call, const char* path) {
    trace(call, path);
    std::raise(SIGKILL);
    std::abort();
}

bool find_path(int descriptor, char (&path)[PATH_MAX]) {
    char link[64];
    std::snprintf(link, sizeof link, "/proc/self/fd/%d", descriptor);
    const ssize_t length = ::readlink(link, path, sizeof path - 1);
    if (length < 0) return false;
    path[length] = '\0';
    return true;
}

bool is_moment_of(int descriptor, char (&path)[PATH_MAX]) {
    return find_path(descriptor, path) && is_moment(path);
}

/// Notes what an fsync brought to the disk.
void note_synced(int descriptor) {
    static const char* const disk = std::getenv("ASSAULT_DISK");
    char path[PATH_MAX];
    if (disk == nullptr || !find_path(descriptor, path) ||
        std::strncmp(path, folder(), std::strlen(folder())) != 0)
        return;
    namespace fs = std::filesystem;
    struct stat status {};
    ::fstat(descriptor, &status);
    if (!S_ISDIR(status.st_mode)) {
        fs::copy_file(path, fs::path(disk) / std::to_string(status.st_ino),
                      fs::copy_options::overwrite_existing);
        return;
    }
    std::ofstream names(fs::path(disk) / "names");
    for (const fs::directory_entry& entry : fs::directory_iterator(path)) {
        struct stat file {};
        ::stat(entry.path().c_str(), &file);
        names << file.st_ino << ' ' << entry.path().filename().string() << '\n';
    }
}

const struct AtEnd {
    ~AtEnd() { trace("end", "-"); }
} at_end;

}  // namespace

// The functions of the C library that are watched.
#define WATCHED_WRITE(name, call_arguments, size, ...)                    \
    extern "C" ssize_t name(__VA_ARGS__) {                                \
        static auto* const next = original<ssize_t(__VA_ARGS__)>(#name);  \
        char path[PATH_MAX];                                              \
        if (!is_moment_of(descriptor, path)) return next call_arguments;  \
        if (calls % 2 != 0) {                                             \
            size /= 2;                                                    \
            if (next call_arguments < 0) die(#name " that failed", path); \
        }                                                                 \
        die(#name, path);                                                 \
    }
#define WATCHED_FILE(name, call_arguments, ...)                      \
    extern "C" int name(__VA_ARGS__) {                               \
        static auto* const next = original<int(__VA_ARGS__)>(#name); \
        char path[PATH_MAX];                                         \
        if (is_moment_of(descriptor, path)) die(#name, path);        \
        return next call_arguments;                                  \
    }
#define WATCHED_NAME(name, call_arguments, ...)                      \
    extern "C" int name(__VA_ARGS__) noexcept {                      \
        static auto* const next = original<int(__VA_ARGS__)>(#name); \
        if (is_moment(path)) die(#name, path);                       \
        return next call_arguments;                                  \
    }

WATCHED_WRITE(write, (descriptor, data, size), size, int descriptor, const void* data, size_t size)
WATCHED_WRITE(pwrite, (descriptor, data, size, at), size, int descriptor, const void* data, size_t size,
              off_t at)
WATCHED_WRITE(pwrite64, (descriptor, data, size, at), size, int descriptor, const void* data, size_t size,
              off64_t at)
extern "C" int fsync(int descriptor) {
    static auto* const next = original<int(int)>("fsync");
    char path[PATH_MAX];
    if (is_moment_of(descriptor, path)) die("fsync", path);
    const int result = next(descriptor);
    note_synced(descriptor);
    return result;
}
extern "C" int ftruncate(int descriptor, off_t size) noexcept {
    static auto* const next = original<int(int, off_t)>("ftruncate");
    char path[PATH_MAX];
    if (is_moment_of(descriptor, path)) die("ftruncate", path);
    return next(descriptor, size);
}
extern "C" int ftruncate64(int descriptor, off64_t size) noexcept {
    static auto* const next = original<int(int, off64_t)>("ftruncate64");
    char path[PATH_MAX];
    if (is_moment_of(descriptor, path)) die("ftruncate64", path);
    return next(descriptor, size);
}
WATCHED_FILE(fallocate, (descriptor, mode, at, size), int descriptor, int mode, off_t at, off_t size)
WATCHED_FILE(fallocate64, (descriptor, mode, at, size), int descriptor, int mode, off64_t at, off64_t size)
WATCHED_NAME(rename, (path, to), const char* path, const char* to)
WATCHED_NAME(remove, (path), const char* path)
WATCHED_NAME(unlink, (path), const char* path)
WATCHED_NAME(mkdir, (path, mode), const char* path, mode_t mode)
