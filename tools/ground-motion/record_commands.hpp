#pragma once

#include <string>
#include <vector>

namespace rockslope {

/// A subcommand that reads a record and shows it or makes another of it.
struct RecordCommand {
    const char* name;
    const char* purpose;  ///< for the list of subcommands
    /// @param arguments of the command line after the subcommand. @returns the exit code.
    /// @throws boost::program_options::error, std::invalid_argument, InputError, OutputError.
    int (*run)(const std::vector<std::string>& arguments);
};

/// All but synthesise: a new one is a function and a row.
const std::vector<RecordCommand>& record_commands();

}  // namespace rockslope
