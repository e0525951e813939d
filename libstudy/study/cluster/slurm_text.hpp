#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rockslope::study {

/// What a user may choose of the jobs of a study.
struct SlurmOptions {
    int most_tasks = 64;            ///< of an array that run at once
    double row_time = 60;           ///< s, expected wall time of a row
    double batch_time = 1800;       ///< s, expected wall time of a task
    double time_limit = 7200;       ///< s, of a task; it is stopped and queued again a minute before
    int threads = 1;                ///< of a row
    int rows_at_once = 1;           ///< in a task
    std::vector<std::string> more;  ///< options of sbatch
};

/// Lists of Make targets, one for each task of an array.
using Batches = std::vector<std::vector<std::string>>;

/// Targets in batches of the expected time of a task, as many rows at once as the options say; no more
/// batches than an array has in Slurm's usual configuration.
Batches make_batches(const std::vector<std::string>& targets, const SlurmOptions& options);

/// Threads for a row of this number of blocks: one, since rows beside each other use processors better than
/// threads do; two from ten thousand blocks on, where a single row lasts hours.
int threads_for(int blocks);

/// The script of a task: make computes the targets of its list. On SIGTERM, which Slurm sends a minute before
/// the time limit, runs write their checkpoints and the task is queued again.
std::string job_script(const SlurmOptions& options);

/// The script that submits the arrays: what rows share first, if there is any, then the rows.
/// @param folder of the study, absolute.
std::string submit_script(const std::filesystem::path& folder, const SlurmOptions& options,
                          std::size_t shared, std::size_t rows);

/// The name of the list of a task, counted from 0: "000001".
std::string list_name(std::size_t index);

}  // namespace rockslope::study
