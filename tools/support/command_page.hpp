#pragma once

#include <boost/program_options.hpp>
#include <optional>
#include <string>
#include <vector>

namespace rockslope::tool_support {

/// A subcommand or an exit code, and what it means.
struct PageEntry {
    std::string name;
    std::string meaning;
};

/// What a program, or one of its subcommands, says of itself. The help text, the manual page and the
/// completion of the command line are all made from it.
struct CommandPage {
    std::string name;         ///< "dda-run", or "ground-motion scale" for a subcommand
    std::string version;      ///< of the project
    std::string synopsis;     ///< arguments after the name, such as "RUN.toml [options]"
    std::string purpose;      ///< one sentence without a full stop
    std::string description;  ///< further paragraphs; may be empty
    boost::program_options::options_description options{"Options"};
    std::vector<PageEntry> subcommands = {};
    std::vector<PageEntry> exit_codes = {{"0", "done"}, {"1", "failed"}, {"2", "bad command line or input"}};
};

/// The text of --help.
std::string help_text(const CommandPage& page);

/// The text of --help-man: a manual page in the macros of man(7).
std::string man_page(const CommandPage& page);

/// The text of --help-words, which the completion of bash reads: a line for each subcommand, with a space
/// after it, and for each option, followed by '=' if it takes a value.
std::string completion_words(const CommandPage& page);

/// The text that a command line asks for by --help (-h), --help-man, --help-words or --version, whatever else
/// it contains; nothing if it asks for none of them. Arguments after "--" are not looked at.
std::optional<std::string> requested_text(const CommandPage& page, const std::vector<std::string>& arguments);

/// Prints the requested text on the standard output. @returns the exit code, 0, or 1 if the standard output
/// cannot be written; nothing when no text is requested.
std::optional<int> print_requested_text(const CommandPage& page, const std::vector<std::string>& arguments);

}  // namespace rockslope::tool_support
