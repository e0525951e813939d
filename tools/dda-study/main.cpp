#include <cstdio>
#include <exception>

#include "common/base/input_error.hpp"
#include "common/base/output_error.hpp"
#include "common/base/text.hpp"
#include "study/plan/plan.hpp"
#include "study_commands.hpp"
#include "support/commit.hpp"

using namespace rockslope;

namespace {

std::string usage() {
    std::string text =
        "dda-study SUBCOMMAND [options]\n"
        "Plans, runs and evaluates studies of many runs: joint realisations, records, strengths.\n\n";
    for (const StudyCommand& command : study_commands()) {
        const std::string name = command.name;
        text += "  " + name + std::string(14 - name.size(), ' ') + command.purpose + "\n";
    }
    return text +
           "\ndda-study --template prints a commented plan. dda-study SUBCOMMAND --help lists the options.\n"
           "Exit codes: 0 done; 1 rows have failed, or are not done; 2 bad command line or input.\n";
}

int print(const std::string& text) {
    if (std::fputs(text.c_str(), stdout) >= 0 && std::fflush(stdout) == 0) return study_done;
    std::fputs("dda-study: the standard output cannot be written\n", stderr);
    return rows_failed;
}

int run(const std::vector<std::string>& arguments) {
    const std::string command = arguments.empty() ? "" : arguments.front();
    if (command == "--help" || command == "-h") return print(usage());
    if (command == "--version")
        return print("dda-study " ROCKSLOPE_VERSION ", commit " + tool_support::commit() + "\n");
    if (command == "--template") return print(study::plan_template());
    std::vector<std::string> names;
    for (const StudyCommand& known : study_commands()) {
        if (command == known.name) return known.run({arguments.begin() + 1, arguments.end()});
        names.emplace_back(known.name);
    }
    const auto nearest = nearest_word(command, names);
    throw InputError({"dda-study"},
                     command.empty() ? "no subcommand is given" : "unknown subcommand '" + command + "'",
                     nearest ? "perhaps '" + *nearest + "'" : "one that dda-study --help lists");
}

}  // namespace

int main(int argc, char** argv) {
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
