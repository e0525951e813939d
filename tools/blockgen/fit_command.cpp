#include "fit_command.hpp"

#include <boost/program_options.hpp>
#include <cstdio>
#include <stdexcept>

#include "blockgen/fit/fit_text.hpp"
#include "blockgen/fit/read_joint_map.hpp"
#include "common/base/atomic_file.hpp"
#include "common/base/output_check.hpp"
#include "options.hpp"
#include "support/command_page.hpp"
#include "support/parse_arguments.hpp"

namespace rockslope::blockgen_tool {

using namespace blockgen;

namespace {

namespace po = boost::program_options;

constexpr const char* synopsis = "MAP [options]";

po::options_description fit_options() {
    po::options_description all("Options");
    auto add = all.add_options();
    add("output,o", po::value<std::string>()->value_name("FILE"),
        "slope model to write (default: the map's name with .toml)");
    add("outline", po::value<std::string>()->value_name("FILE"),
        "outline of the mapped area: .csv, .geojson, .dxf, .shp or .gpkg (default: polygons of the map if it "
        "is "
        "GeoJSON, otherwise the box around the traces)");
    add("sets", po::value<int>()->value_name("N"), "number of sets (default: estimated, at most six)");
    add("edge", po::value<double>()->value_name("M"),
        "an end within so many metres of the outline is cut off there (default: 5e-4 of the area's root)");
    add("crs", po::value<std::string>()->value_name("SYSTEM"),
        "coordinate system of the map where it states none or a wrong one; local: metres");
    add("unit", po::value<std::string>()->value_name("UNIT"), "length unit of a drawing, such as mm");
    add("project", po::value<std::string>()->value_name("SYSTEM"),
        "system in metres to which coordinates are converted, such as EPSG:32634");
    add("report", po::value<std::string>()->value_name("FILE"), "write the estimates as JSON");
    add("help,h", "print this and stop");
    return all;
}

tool_support::CommandPage fit_page() {
    return {
        .name = "blockgen fit",
        .version = ROCKSLOPE_VERSION,
        .synopsis = synopsis,
        .purpose = fit_purpose,
        .description = "Prints each estimate with the interval that holds the truth in nine cases of ten.",
        .options = fit_options(),
        .exit_codes = {{"0", "done"}, {"1", "failed"}, {"2", "bad command line or input"}}};
}

std::string text_or_empty(const po::variables_map& given, const char* name) {
    if (!given.count(name)) return {};
    auto text = given[name].as<std::string>();
    if (text.empty()) throw UsageError(std::string("fit: --") + name + " is empty");
    return text;
}

FitOptions options_of(const po::variables_map& given) {
    FitOptions options;
    if (given.count("sets")) {
        const int sets = given["sets"].as<int>();
        if (sets < 1 || sets > 20) throw UsageError("fit: --sets: expected a number from 1 to 20");
        options.sets = static_cast<std::size_t>(sets);
    }
    if (given.count("edge")) {
        options.edge = given["edge"].as<double>();
        if (!(options.edge > 0)) throw UsageError("fit: --edge: expected a positive length");
    }
    return options;
}

MapFit fit_of(const JointMapFile& file, const FitOptions& options, const std::string& source) {
    try {
        return fit_map(file.map, options);
    } catch (const std::invalid_argument& error) {
        throw InputError({source}, error.what(), "a map with traces within its outline");
    }
}

}  // namespace

int run_fit(const std::vector<std::string>& arguments) {
    const tool_support::CommandPage page = fit_page();
    if (const auto code = tool_support::print_requested_text(page, arguments)) return *code;
    const po::variables_map given = tool_support::parse_arguments("blockgen fit", arguments, page.options);
    MapRequest request;
    request.traces =
        tool_support::model_file_of("blockgen fit", given, std::string("blockgen fit ") + synopsis);
    request.outline = text_or_empty(given, "outline");
    request.crs = text_or_empty(given, "crs");
    request.unit = text_or_empty(given, "unit");
    request.project = text_or_empty(given, "project");
    std::filesystem::path output = text_or_empty(given, "output");
    if (output.empty()) output = std::filesystem::path(request.traces).replace_extension(".toml");
    const std::filesystem::path report = text_or_empty(given, "report");
    std::vector<std::filesystem::path> inputs = {request.traces};
    if (!request.outline.empty()) inputs.push_back(request.outline);
    for (const std::filesystem::path& path : {output, report})
        if (!path.empty()) check_output(path, inputs);
    check_distinct({output, report});

    const FitOptions options = options_of(given);
    const JointMapFile file = read_joint_map(request);
    MapFit fit = fit_of(file, options, request.traces.string());
    fit.notes.insert(fit.notes.begin(), file.notes.begin(), file.notes.end());
    for (const std::string& note : fit.notes) std::fprintf(stderr, "warning: %s\n", note.c_str());
    if (!report.empty()) write_file_atomically(report, fit_json(fit));
    write_file_atomically(output, fitted_model_text(fit, file.map, request.traces.string()));
    std::fputs(fit_table(fit).c_str(), stdout);
    std::printf("%s: %zu joint set%s\n", output.c_str(), fit.sets.size(), fit.sets.size() == 1 ? "" : "s");
    return 0;
}

}  // namespace rockslope::blockgen_tool
