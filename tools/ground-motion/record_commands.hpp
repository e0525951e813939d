#pragma once

#include <string>
#include <vector>

namespace rockslope {

/// A subcommand.
struct RecordCommand {
    const char* name;
    const char* purpose;  ///< for the list of subcommands
    /// @param arguments after the subcommand on the command line. @returns the exit code.
    /// @throws std::invalid_argument, InputError, OutputError.
    int (*run)(const std::vector<std::string>& arguments);
};

/// All subcommands. To add a subcommand, add a function and a row of the table.
const std::vector<RecordCommand>& record_commands();

// Subcommands in files of their own. @param arguments, @returns and @throws as for RecordCommand::run.

/// `ground-motion synthesise`: writes an artificial accelerogram and prints its measures.
int run_synthesise(const std::vector<std::string>& arguments);
/// `ground-motion plot`: draws one or several records into one picture.
int run_plot(const std::vector<std::string>& arguments);
/// `ground-motion amplification`: ratios of the peaks and spectra of two records.
int run_amplification(const std::vector<std::string>& arguments);
/// `ground-motion compare`: displacement of a measured point in several runs, as a table and a picture.
int run_compare(const std::vector<std::string>& arguments);

}  // namespace rockslope
