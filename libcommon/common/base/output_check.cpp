#include "common/base/output_check.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

#include "common/base/input_error.hpp"

namespace rockslope {

namespace fs = std::filesystem;

namespace {

/// The canonical spelling of a path. Links are followed as far as the path exists.
fs::path resolved(const fs::path& path) {
    std::error_code error;
    const fs::path result = fs::weakly_canonical(fs::absolute(path), error);
    return error ? fs::absolute(path, error).lexically_normal() : result;
}

bool is_same(const fs::path& a, const fs::path& b) {
    std::error_code ignored;
    return fs::equivalent(a, b, ignored) || resolved(a) == resolved(b);
}

bool is_folder(const fs::path& path) {
    std::error_code ignored;
    return fs::is_directory(path, ignored);
}

[[noreturn]] void fail(const fs::path& path, const std::string& reason, const std::string& expected) {
    throw InputError({path.string()}, "cannot be written: " + reason, expected);
}

void check_access(const fs::path& shown, const fs::path& path, int mode, const std::string& expected) {
    if (::access(path.c_str(), mode) != 0) fail(shown, std::strerror(errno), expected);
}

}  // namespace

void check_output(const fs::path& file, const std::vector<fs::path>& inputs, const fs::path& created_later) {
    const std::string expected = "a file in a folder that can be written";
    if (file.filename().empty() || is_folder(file)) fail(file, "this is a folder", "a file name");
    for (const fs::path& input : inputs)
        if (is_same(file, input))
            fail(file,
                 "this would overwrite the " + std::string(&input == &inputs.front() ? "model" : "input") +
                     " file " + input.string(),
                 "another name");
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (fs::exists(status) && !fs::is_regular_file(status)) return check_access(file, file, W_OK, expected);
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    if (!created_later.empty() && is_same(folder, created_later)) return;
    if (!is_folder(folder)) fail(file, "no such folder", expected);
    check_access(file, folder, W_OK | X_OK, expected);
    // PendingFile appends ".tmp" and twelve digits to the name.
    constexpr std::size_t longest_name = 255 - 16;
    if (file.filename().string().size() > longest_name) fail(file, std::strerror(ENAMETOOLONG), expected);
}

void check_output_folder(const fs::path& folder) {
    const std::string expected = "a folder for the results";
    std::error_code error;
    fs::path nearest_existing = fs::absolute(folder, error).lexically_normal();
    if (error) fail(folder, error.message(), expected);
    while (!fs::exists(fs::status(nearest_existing, error))) {
        if (error && error != std::errc::no_such_file_or_directory) fail(folder, error.message(), expected);
        if (nearest_existing == nearest_existing.parent_path()) break;
        nearest_existing = nearest_existing.parent_path();
    }
    if (!is_folder(nearest_existing)) fail(folder, std::strerror(ENOTDIR), expected);
    check_access(folder, nearest_existing, W_OK | X_OK, expected);
}

void make_output_folder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) fail(folder, error.message(), "a folder for the results");
}

void check_distinct(const std::vector<fs::path>& results) {
    for (std::size_t i = 0; i < results.size(); ++i)
        for (std::size_t k = i + 1; k < results.size(); ++k)
            if (!results[i].empty() && !results[k].empty() && is_same(results[i], results[k]))
                throw InputError({results[k].string()}, "two results are the same file", "different names");
}

}  // namespace rockslope
