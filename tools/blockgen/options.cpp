#include "options.hpp"

#include <algorithm>
#include <boost/program_options.hpp>
#include <thread>

#include "blockgen/input/read_slope_model.hpp"
#include "common/drawing/canvas.hpp"
#include "fit_command.hpp"
#include "support/command_page.hpp"
#include "support/parse_arguments.hpp"
#include "support/picture_options.hpp"

namespace rockslope::blockgen_tool {

namespace {

namespace po = boost::program_options;

po::options_description visible_options() {
    po::options_description all("Options");
    auto add = all.add_options();
    add("output,o", po::value<std::string>()->value_name("FILE"),
        "block file to write (default: the model's name with .blocks)");
    add("seed", po::value<std::int64_t>()->value_name("N"),
        "seed of the random draws, overrides the model's");
    add("set", po::value<std::vector<std::string>>()->composing()->value_name("KEY=VALUE"),
        "override a value of the model, e.g. joint_set[0].spacing=2; may be repeated");
    add("picture", po::value<std::string>()->value_name("FILE"), "draw the blocks; .svg, .png or .pdf");
    add("size-picture", po::value<std::string>()->value_name("FILE"), "draw the distribution of block areas");
    add("rose-picture", po::value<std::string>()->value_name("FILE"),
        "draw a rose diagram of the directions of the joints in the rock");
    add("stereonet-picture", po::value<std::string>()->value_name("FILE"),
        "draw the poles of the joints' planes, lower hemisphere, equal area; needs sets with planes in "
        "space");
    add("kinematic-picture", po::value<std::string>()->value_name("FILE"),
        "draw the blocks coloured by the mode of their first movement; needs [kinematics]");
    tool_support::add_picture_options(all);
    add("geojson", po::value<std::string>()->value_name("FILE"),
        "write the blocks and the joints between them as GeoJSON, in the coordinate system of the input");
    add("vtk", po::value<std::string>()->value_name("FILE"),
        "write the blocks and all traces for ParaView; .vtk");
    add("report", po::value<std::string>()->value_name("FILE"),
        "write a report of the cut and the block sizes, as JSON; as tables if the name ends in .txt");
    add("depfile", po::value<std::string>()->value_name("FILE"),
        "write a Make rule that names every file read");
    add("verify", "prove the noding and the faces by exact construction; the noding up to 100000 segments");
    add("max-blocks", po::value<std::int64_t>()->value_name("N")->default_value(1'000'000),
        "largest number of blocks; a model with more is refused");
    add("threads", po::value<int>()->value_name("N"),
        "number of threads (default: all cores); results do not depend on it");
    add("template", "print a commented model file and stop");
    add("print-config", "print the model with overrides and defaults and stop");
    add("version", "print the version and stop");
    add("help,h", "print this and stop");
    return all;
}

tool_support::CommandPage command_page() {
    return {.name = "blockgen",
            .version = ROCKSLOPE_VERSION,
            .synopsis = "SLOPE.toml [options]",
            .purpose = "Cuts a rock section by its joints into blocks and writes a block file for dda-run",
            .description = "",
            .options = visible_options(),
            .subcommands = {{"fit", fit_purpose}},
            .exit_codes = {{"0", "done"}, {"1", "cutting failed"}, {"2", "bad command line or input"}}};
}

/// Largest limit: a network of four times so many faces still has indices of 32 bits.
constexpr std::int64_t most_blocks = 100'000'000;

std::string path_or_empty(const po::variables_map& given, const char* name) {
    if (!given.count(name)) return {};
    auto path = given[name].as<std::string>();
    if (path.empty()) throw UsageError(std::string("--") + name + " is empty; expected a file name");
    return path;
}

void check_picture(const char* option, const std::filesystem::path& picture) {
    if (!picture.empty() && !picture_format(picture))
        throw UsageError(option + (" " + picture.string()) +
                         ": expected a name that ends in .svg, .png or .pdf");
}

int threads_of(const po::variables_map& given) {
    constexpr int max_threads = 1024;
    if (!given.count("threads"))
        return std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, max_threads);
    const int threads = given["threads"].as<int>();
    if (threads < 1 || threads > max_threads)
        throw UsageError("--threads is " + std::to_string(threads) + "; expected a number from 1 to 1024");
    return threads;
}

Options read_options(const po::variables_map& given) {
    Options options;
    options.model = tool_support::model_file_of("blockgen", given, "blockgen SLOPE.toml [options]");
    options.output = path_or_empty(given, "output");
    if (options.output.empty())
        options.output = std::filesystem::path(options.model).replace_extension(".blocks");
    options.picture = path_or_empty(given, "picture");
    options.report = path_or_empty(given, "report");
    options.depfile = path_or_empty(given, "depfile");
    options.geojson = path_or_empty(given, "geojson");
    options.vtk = path_or_empty(given, "vtk");
    if (!options.vtk.empty() && options.vtk.extension() != ".vtk")
        throw UsageError("--vtk " + options.vtk.string() + ": expected a name that ends in .vtk");
    if (given.count("seed")) options.seed = given["seed"].as<std::int64_t>();
    if (options.seed && *options.seed < 0) throw UsageError("--seed: expected an integer of zero or more");
    if (given.count("set")) options.overrides = given["set"].as<std::vector<std::string>>();
    const auto max_blocks = given["max-blocks"].as<std::int64_t>();
    if (max_blocks < 1 || max_blocks > most_blocks)
        throw UsageError("--max-blocks is " + std::to_string(max_blocks) + "; expected a number from 1 to " +
                         std::to_string(most_blocks));
    options.max_blocks = max_blocks;
    options.threads = threads_of(given);
    options.verify = given.count("verify") > 0;
    options.print_config = given.count("print-config") > 0;
    options.size_picture = path_or_empty(given, "size-picture");
    options.rose_picture = path_or_empty(given, "rose-picture");
    options.stereonet_picture = path_or_empty(given, "stereonet-picture");
    options.kinematic_picture = path_or_empty(given, "kinematic-picture");
    options.picture_style = tool_support::picture_style(given, "blockgen");
    check_picture("--picture", options.picture);
    check_picture("--size-picture", options.size_picture);
    check_picture("--rose-picture", options.rose_picture);
    check_picture("--stereonet-picture", options.stereonet_picture);
    check_picture("--kinematic-picture", options.kinematic_picture);
    return options;
}

}  // namespace

Options parse_options(int argc, const char* const* argv) {
    const tool_support::CommandPage page = command_page();
    const std::vector<std::string> arguments = tool_support::arguments_of(argc, argv);
    Options options;
    options.text = requested_text(page, arguments).value_or("");
    if (!options.text.empty()) return options;
    const po::variables_map given = tool_support::parse_arguments("blockgen", arguments, page.options);
    if (given.count("template")) options.text = blockgen::slope_model_template();
    if (!options.text.empty()) return options;
    return read_options(given);
}

}  // namespace rockslope::blockgen_tool
