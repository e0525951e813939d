#include "provenance.hpp"

#include "common/base/command_text.hpp"
#include "common/base/output_check.hpp"
#include "common/base/read_file.hpp"
#include "common/base/sha256.hpp"

namespace rockslope::blockgen_tool {

std::vector<std::string> provenance(const blockgen::SlopeModel& model, const ConfigTable& config,
                                    const ReadLog& log) {
    std::filesystem::path folder = std::filesystem::path(config.place().file).parent_path();
    if (folder.empty()) folder = ".";
    std::string input = config.effective_text(folder);
    for (const auto& file : model.files) {
        // GDAL reads its files itself.
        if (log.digest_of(file).empty()) read_text_file(file);
        input += log.digest_of(file) + '\n';
    }
    return {"blockgen " ROCKSLOPE_VERSION, "seed " + std::to_string(model.seed),
            "input " + sha256(input).substr(0, 16)};
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
