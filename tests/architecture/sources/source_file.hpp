#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "declarations.hpp"

namespace rockslope::sources {

/// A source file with what it declares.
struct SourceFile {
    std::string path;  ///< below the root, with slashes
    Tokens tokens;
    std::vector<Declaration> declarations;

    bool is_header() const { return path.ends_with(".hpp"); }
    /// Whether the file lies in one of the libraries.
    bool is_in_library() const { return path.starts_with("lib"); }
    /// The path without its ending: the same for a header and the file with its functions.
    std::string stem() const { return path.substr(0, path.rfind('.')); }
    /// The path by which other files include this one.
    std::string include_path() const;
};

/// The comments of a declaration, joined: the lines right above it, and those behind its lines before the
/// body.
/// @param mark what the comments begin with: "///" for docstrings only.
std::string docstring(const SourceFile& file, const Declaration& declaration, std::string_view mark = "///");

/// Reads all sources below `root`: libraries, tools, bench and tests, without the trees of planted faults.
/// Throws std::runtime_error if there is none.
std::vector<SourceFile> read_sources(const std::filesystem::path& root);

/// The text of a file. Throws std::runtime_error if it cannot be read.
std::string read_file(const std::filesystem::path& path);

}  // namespace rockslope::sources
