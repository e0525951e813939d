#include "command_line.hpp"

#include <algorithm>
#include <boost/program_options.hpp>
#include <thread>

#include "common/base/input_error.hpp"
#include "support/parse_arguments.hpp"

namespace rockslope {

namespace po = boost::program_options;

namespace {

constexpr int max_threads = 1024;

int default_threads() {
    return std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, max_threads);
}

po::options_description visible_options() {
    po::options_description options("Options");
    auto add = options.add_options();
    add("output,o", po::value<std::string>()->value_name("FOLDER"), "result folder (default: out)");
    add("blocks", po::value<std::string>()->value_name("FILE"), "block file, overrides the model file's");
    add("set", po::value<std::vector<std::string>>()->value_name("KEY=VALUE")->composing(),
        "change a key of the model file, e.g. stage[1].step=0.002 (may be repeated)");
    add("from", po::value<std::string>()->value_name("FILE"),
        "begin after the stage whose end another run saved in this file (--until, save_stages)");
    add("until", po::value<std::string>()->value_name("STAGE"),
        "end after the stage of this name and save its end as stage-N.saved.h5, for --from");
    add("resume", "continue from the checkpoint in the output folder");
    add("make",
        "for Makefiles: continue from a checkpoint of the same input where there is one; write the summary "
        "of "
        "a run that fails or is stopped to failed.json, so that summary.json is there only when all is done");
    add("log", po::value<std::string>()->value_name("TITLE"),
        "for the Makefiles of dda-study: print TITLE, and what the run prints into the file log of the "
        "output "
        "folder; of a run that does not end well its last line too. The file running names the process "
        "meanwhile");
    add("threads", po::value<int>()->value_name("N"),
        "number of threads (default: all cores); results do not depend on it");
    add("depfile", po::value<std::string>()->value_name("FILE"),
        "write a Make rule that names every file the run reads");
    add("pvd", "also write .pvd and .vtu files of blocks and joints, for viewers older than ParaView 5.12");
    add("print-config", "print the effective model, defaults included, and stop");
    add("template", "print a commented model file and stop");
    add("version", "print the version and stop");
    add("help,h", "print this text and stop");
    return options;
}

CommandLine::Action action_of(const po::variables_map& values) {
    if (values.count("template")) return CommandLine::Action::print_template;
    if (values.count("print-config")) return CommandLine::Action::print_config;
    return CommandLine::Action::simulate;
}

int threads_of(const po::variables_map& values) {
    if (!values.count("threads")) return default_threads();
    const int threads = values["threads"].as<int>();
    if (threads < 1 || threads > max_threads)
        throw InputError({"dda-run"}, "--threads is " + std::to_string(threads), "a number from 1 to 1024");
    return threads;
}

std::optional<std::filesystem::path> path_of(const po::variables_map& values, const char* name) {
    if (!values.count(name)) return std::nullopt;
    const std::string text = values[name].as<std::string>();
    if (text.empty()) throw InputError({"dda-run"}, std::string("--") + name + " is empty", "a path");
    return text;
}

}  // namespace

CommandLine parse_command_line(int argc, const char* const* argv) {
    const po::variables_map values = tool_support::parse_arguments("dda-run", argc, argv, visible_options());
    CommandLine line;
    line.action = action_of(values);
    const bool needs_file =
        line.action == CommandLine::Action::simulate || line.action == CommandLine::Action::print_config;
    if (!needs_file) return line;
    line.run_file = tool_support::model_file_of("dda-run", values, "dda-run RUN.toml [options]");
    line.output = path_of(values, "output").value_or("out");
    line.blocks = path_of(values, "blocks");
    line.depfile = path_of(values, "depfile");
    if (values.count("set")) line.overrides = values["set"].as<std::vector<std::string>>();
    line.threads = threads_of(values);
    line.from = path_of(values, "from");
    if (values.count("until")) line.until = values["until"].as<std::string>();
    line.resume = values.count("resume") > 0;
    line.make = values.count("make") > 0;
    if (line.resume && line.make)
        throw InputError({"dda-run"}, "--resume and --make are both given",
                         "--make, which resumes what can be resumed");
    if (values.count("log")) line.log_title = values["log"].as<std::string>();
    if (line.log_title && line.action != CommandLine::Action::simulate)
        throw InputError({"dda-run"}, "--log is given with --print-config", "one of them");
    line.pvd = values.count("pvd") > 0;
    return line;
}

tool_support::CommandPage command_page(const std::string& version) {
    return {.name = "dda-run",
            .version = version,
            .synopsis = "RUN.toml [options]",
            .purpose =
                "Simulates a block file made by blockgen by two-dimensional discontinuous deformation "
                "analysis",
            .description = "",
            .options = visible_options(),
            .exit_codes = {{"0", "done, also where a slope has collapsed"},
                           {"1", "the analysis failed, its results are kept"},
                           {"2", "bad command line or input"},
                           {"75",
                            "stopped by a signal, or by a file named 'stop' in the output folder, "
                            "after writing a checkpoint"}}};
}

}  // namespace rockslope
