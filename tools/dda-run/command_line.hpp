#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "support/command_page.hpp"

namespace rockslope {

/// The command line of dda-run.
struct CommandLine {
    enum class Action { simulate, print_config, print_template };

    Action action = Action::simulate;
    std::filesystem::path run_file;
    std::filesystem::path output = "out";
    std::optional<std::filesystem::path> blocks;
    std::optional<std::filesystem::path> depfile;
    std::vector<std::string> overrides;
    int threads = 1;
    std::optional<std::filesystem::path> from;  ///< state saved at a stage's end, to begin with
    std::optional<std::string> until;           ///< name of the last stage to run; its end is saved
    bool resume = false;
    bool make = false;                     ///< resume what can be resumed; summary.json only when done
    std::optional<std::string> log_title;  ///< printed before the run, which prints into its log
    bool pvd = false;
};

/// @throws InputError for an invalid command line.
CommandLine parse_command_line(int argc, const char* const* argv);

/// What dda-run says of itself, with its options. @param version of the project.
tool_support::CommandPage command_page(const std::string& version);

}  // namespace rockslope
