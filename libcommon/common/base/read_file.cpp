#include "common/base/read_file.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <new>

#include "common/base/input_error.hpp"
#include "common/base/read_log.hpp"

namespace rockslope {

namespace {

// Bytes that are read of a file, and of a pipe or a device, which may have no end.
constexpr std::size_t largest_file = std::size_t{4} << 30;
constexpr std::size_t largest_stream = std::size_t{256} << 20;

}  // namespace

std::string read_text_file(const std::filesystem::path& path) {
    const auto fail = [&](int error) {
        throw InputError({path.string()}, std::string("cannot be read: ") + std::strerror(error),
                         "a readable file");
    };
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) fail(EISDIR);
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
    if (!file) fail(errno);

    const std::size_t limit = std::filesystem::is_regular_file(path, ignored) ? largest_file : largest_stream;
    const auto is_too_large = [&](const char* what) {
        throw InputError({path.string()}, what,
                         "a file of at most " + std::to_string(limit >> 20) + " MiB that fits the memory");
    };
    std::string content;
    char buffer[1 << 16];
    try {
        // Room for the file and some more, so that the content is not copied as it grows.
        const std::uintmax_t size = std::filesystem::file_size(path, ignored);
        if (!ignored && size <= limit) content.reserve(size + sizeof buffer);
        while (const std::size_t count = std::fread(buffer, 1, sizeof buffer, file.get())) {
            if (content.size() + count > limit) is_too_large("is too large, or has no end");
            content.append(buffer, count);
        }
    } catch (const std::bad_alloc&) {
        content = std::string();
        is_too_large("takes more memory than there is");
    }
    if (std::ferror(file.get())) fail(errno);
    ReadLog::add(path, content);
    return content;
}

}  // namespace rockslope
