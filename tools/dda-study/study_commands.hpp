#pragma once

#include <string>
#include <vector>

namespace rockslope {

/// The exit codes of dda-study.
enum StudyExitCode { study_done = 0, rows_failed = 1, study_bad_input = 2 };

/// A subcommand.
struct StudyCommand {
    const char* name;
    const char* purpose;  ///< for the list of subcommands
    /// @param arguments after the subcommand on the command line. @returns the exit code.
    /// @throws InputError, OutputError.
    int (*run)(const std::vector<std::string>& arguments);
};

/// All subcommands, in the order in which a study needs them.
const std::vector<StudyCommand>& study_commands();

// Subcommands in files of their own. @param arguments, @returns and @throws as for StudyCommand::run.

/// `dda-study make`: writes the folder of a study from a plan.
int run_make(const std::vector<std::string>& arguments);
/// `dda-study status`: says which rows are done, running, waiting, and why others failed.
int run_status(const std::vector<std::string>& arguments);
/// `dda-study collect`: writes the table of results, as CSV and as an SQLite database.
int run_collect(const std::vector<std::string>& arguments);
/// `dda-study fragility`: fits a fragility curve.
int run_fragility(const std::vector<std::string>& arguments);
/// `dda-study sensitivity`: says what a measure depends on.
int run_sensitivity(const std::vector<std::string>& arguments);
/// `dda-study slurm`: submits a study to a Slurm cluster.
int run_slurm(const std::vector<std::string>& arguments);
/// `dda-study profile`: the surface of a slope at the end of a run.
int run_profile(const std::vector<std::string>& arguments);
/// `dda-study report`: writes a report as a page of HTML.
int run_report(const std::vector<std::string>& arguments);
/// `dda-study skip`: for the Makefile of an incremental study.
int run_skip(const std::vector<std::string>& arguments);

}  // namespace rockslope
