#include <cstdio>
#include <exception>

#include "common/base/input_error.hpp"
#include "common/base/output_error.hpp"
#include "common/base/text.hpp"
#include "study/plan/plan.hpp"
#include "study_commands.hpp"
#include "support/command_page.hpp"
#include "support/commit.hpp"
#include "support/standard_streams.hpp"

using namespace rockslope;

namespace {

tool_support::CommandPage command_page() {
    tool_support::CommandPage page{
        .name = "dda-study",
        .version = ROCKSLOPE_VERSION ", commit " + tool_support::commit(),
        .synopsis = "SUBCOMMAND [options]",
        .purpose = "Plans, runs and evaluates studies of many runs: joint realisations, records, strengths",
        .description = "",
        .exit_codes = {
            {"0", "done"}, {"1", "rows have failed, or are not done"}, {"2", "bad command line or input"}}};
    for (const StudyCommand& command : study_commands())
        page.subcommands.push_back({command.name, command.purpose});
    auto add = page.options.add_options();
    add("template", "print a commented plan and stop");
    add("version", "print the version and stop");
    add("help,h", "print this text and stop");
    return page;
}

int print(const std::string& text) {
    if (std::fputs(text.c_str(), stdout) >= 0 && std::fflush(stdout) == 0) return study_done;
    std::fputs("dda-study: the standard output cannot be written\n", stderr);
    return rows_failed;
}

int run(const std::vector<std::string>& arguments) {
    const std::string command = arguments.empty() ? "" : arguments.front();
    if (command == "--template") return print(study::plan_template());
    std::vector<std::string> names;
    for (const StudyCommand& known : study_commands()) {
        if (command == known.name) return known.run({arguments.begin() + 1, arguments.end()});
        names.emplace_back(known.name);
    }
    if (const auto code = tool_support::print_requested_text(command_page(), arguments)) return *code;
    const auto nearest = nearest_word(command, names);
    throw InputError({"dda-study"},
                     command.empty() ? "no subcommand is given" : "unknown subcommand '" + command + "'",
                     nearest ? "perhaps '" + *nearest + "'" : "one that dda-study --help lists");
}

/// Does what the arguments ask for; prints why it failed. @return the exit code.
int act_on_arguments(int argc, char** argv) {
    try {
        return run({argv + 1, argv + argc});
    } catch (const InputError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return study_bad_input;
    } catch (const OutputError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return rows_failed;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "dda-study: %s\n", error.what());
        return rows_failed;
    }
}

}  // namespace

int main(int argc, char** argv) {
    return tool_support::run_program("dda-study", [&] { return act_on_arguments(argc, argv); });
}
