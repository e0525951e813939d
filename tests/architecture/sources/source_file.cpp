#include "source_file.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace rockslope::sources {

namespace {

constexpr const char* folders[] = {"libcommon", "libblockgen", "libdda", "libstudy",
                                   "tools",     "bench",       "tests"};

bool is_source(const std::filesystem::path& path) {
    return path.extension() == ".hpp" || path.extension() == ".cpp";
}

}  // namespace

std::string SourceFile::include_path() const {
    const bool below_folder = is_in_library() || path.starts_with("tests/") || path.starts_with("tools/");
    return below_folder ? path.substr(path.find('/') + 1) : path;
}

std::string docstring(const SourceFile& file, const Declaration& declaration, std::string_view mark) {
    const auto& comments = file.tokens.comments;
    std::string text;
    const auto add = [&](int line) {
        const auto comment = comments.find(line);
        if (comment != comments.end() && comment->second.starts_with(mark))
            text += comment->second.substr(mark.size()) + " ";
    };
    int above = declaration.first_line;
    while (comments.contains(above - 1) && file.tokens.fills_line.at(above - 1)) --above;
    const int last = declaration.body_lines > 0 ? declaration.first_line : declaration.last_line;
    for (int line = above; line <= last; ++line) add(line);
    return text;
}

std::string read_file(const std::filesystem::path& path) {
    std::ifstream file(path);
    if (!file) throw std::runtime_error("cannot read " + path.string());
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

std::vector<SourceFile> read_sources(const std::filesystem::path& root) {
    std::vector<SourceFile> files;
    for (const char* folder : folders) {
        if (!std::filesystem::exists(root / folder)) continue;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder)) {
            const std::string path = entry.path().lexically_relative(root).generic_string();
            if (!is_source(entry.path()) || path.find("/planted") != std::string::npos) continue;
            SourceFile file;
            file.path = path;
            file.tokens = tokenize(read_file(entry.path()));
            file.declarations = find_declarations(file.tokens);
            files.push_back(std::move(file));
        }
    }
    if (files.empty()) throw std::runtime_error("no sources below " + root.string());
    std::ranges::sort(files, {}, &SourceFile::path);
    return files;
}

}  // namespace rockslope::sources
