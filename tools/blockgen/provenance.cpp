#include "provenance.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "blockgen/base/output_error.hpp"
#include "blockgen/base/read_file.hpp"

namespace blockgen_tool {

namespace {

/// FNV-1a of 64 bits: tells inputs apart, protects against nothing.
std::uint64_t hashed(std::uint64_t hash, const std::string& text) {
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
    return hash;
}

std::string escaped_for_make(const std::filesystem::path& path) {
    std::string text;
    for (const char c : path.string()) {
        if (c == ' ' || c == '#' || c == '\\') text += '\\';
        if (c == '$') text += '$';
        text += c;
    }
    return text;
}

}  // namespace

std::vector<std::string> provenance(const blockgen::SlopeModel& model, const blockgen::ConfigTable& config) {
    std::filesystem::path folder = std::filesystem::path(config.place().file).parent_path();
    if (folder.empty()) folder = ".";
    std::uint64_t hash = hashed(0xcbf29ce484222325u, config.effective_text(folder));
    for (const auto& file : model.files) hash = hashed(hash, blockgen::read_text_file(file));
    char text[32];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
    return {"blockgen " ROCKSLOPE_VERSION, "seed " + std::to_string(model.seed),
            std::string("input ") + text};
}

std::string make_rule(const Options& options, const blockgen::SlopeModel& model) {
    std::string inputs = escaped_for_make(options.model), phony;
    for (const auto& file : model.files) {
        inputs += " \\\n  " + escaped_for_make(file);
        phony += "\n" + escaped_for_make(file) + ":\n";
    }
    // An empty rule for each file keeps Make going when one is renamed.
    return escaped_for_make(options.output) + ": " + inputs + "\n" + phony;
}

void check_writable(const Options& options) {
    for (const auto* path : {&options.output, &options.picture, &options.report, &options.depfile}) {
        if (path->empty()) continue;
        const std::filesystem::path folder =
            path->has_parent_path() ? path->parent_path() : std::filesystem::path(".");
        if (std::filesystem::is_directory(*path))
            throw blockgen::OutputError(*path, "this is a folder; expected a file name");
        if (!std::filesystem::is_directory(folder))
            throw blockgen::OutputError(*path, "cannot be written: no such folder");
        if (::access(folder.c_str(), W_OK) != 0)
            throw blockgen::OutputError(*path, std::string("cannot be written: ") + std::strerror(errno));
    }
}

}  // namespace blockgen_tool
