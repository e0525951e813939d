#include "common/base/read_file.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "common/base/input_error.hpp"
#include "common/base/read_log.hpp"

namespace rockslope {

std::string read_text_file(const std::filesystem::path& path) {
    const auto fail = [&](int error) {
        throw InputError({path.string()}, std::string("cannot be read: ") + std::strerror(error),
                         "a readable file");
    };
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) fail(EISDIR);
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
    if (!file) fail(errno);

    std::string content;
    char buffer[1 << 16];
    while (const std::size_t count = std::fread(buffer, 1, sizeof buffer, file.get()))
        content.append(buffer, count);
    if (std::ferror(file.get())) fail(errno);
    ReadLog::add(path, content);
    return content;
}

}  // namespace rockslope
