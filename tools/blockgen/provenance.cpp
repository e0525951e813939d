#include "provenance.hpp"

#include <cstdio>

#include "common/base/command_text.hpp"
#include "common/base/output_check.hpp"
#include "common/base/read_file.hpp"

namespace rockslope::blockgen_tool {

namespace {

/// FNV-1a hash, 64 bits: distinguishes inputs, not cryptographically secure.
std::uint64_t hashed(std::uint64_t hash, const std::string& text) {
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
    return hash;
}

}  // namespace

std::vector<std::string> provenance(const blockgen::SlopeModel& model, const ConfigTable& config) {
    std::filesystem::path folder = std::filesystem::path(config.place().file).parent_path();
    if (folder.empty()) folder = ".";
    std::uint64_t hash = hashed(0xcbf29ce484222325u, config.effective_text(folder));
    for (const auto& file : model.files) hash = hashed(hash, read_text_file(file));
    char text[32];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
    return {"blockgen " ROCKSLOPE_VERSION, "seed " + std::to_string(model.seed),
            std::string("input ") + text};
}

std::string make_rule(const Options& options, const blockgen::SlopeModel& model) {
    std::string inputs = make_escaped(options.model), phony;
    for (const auto& file : model.files) {
        inputs += " \\\n  " + make_escaped(file);
        phony += "\n" + make_escaped(file) + ":\n";
    }
    // An empty rule for each file lets Make continue when a file has been renamed.
    return make_escaped(options.output) + ": " + inputs + "\n" + phony;
}

void check_outputs(const Options& options, const blockgen::SlopeModel& model) {
    std::vector<std::filesystem::path> inputs = {options.model};
    inputs.insert(inputs.end(), model.files.begin(), model.files.end());
    const std::vector<std::filesystem::path> outputs = {
        options.output,       options.picture,           options.size_picture,
        options.rose_picture, options.stereonet_picture, options.kinematic_picture,
        options.report,       options.depfile,           options.geojson,
        options.vtk};
    for (const std::filesystem::path& path : outputs)
        if (!path.empty()) check_output(path, inputs);
    check_distinct(outputs);
}

}  // namespace rockslope::blockgen_tool
