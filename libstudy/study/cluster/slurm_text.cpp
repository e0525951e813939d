#include "study/cluster/slurm_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "common/base/command_text.hpp"

namespace rockslope::study {

namespace {

/// Slurm's default MaxArraySize, less one.
constexpr double most_batches = 1000;
constexpr double minute = 60;
/// Time between the signal and the limit, for checkpoints, s.
constexpr int warning_time = 60;
/// Number of blocks from which a row has two threads. They take 0.65, 0.69 and 0.62 of the time of one at 1
/// 041, 10 051 and 100 015 blocks (docs/design/performance.md), so that rows beside each other on one thread
/// each get done 1.2 to 1.4 times as fast at every size. A row of ten thousand blocks lasts hours on one
/// thread, and a task should not: that is when the time of a single row counts. More threads were not
/// measured.
constexpr int blocks_for_two_threads = 10'000;

std::string numbered(const char* format, std::size_t number) {
    char text[32];
    std::snprintf(text, sizeof text, format, number);
    return text;
}

}  // namespace

Batches make_batches(const std::vector<std::string>& targets, const SlurmOptions& options) {
    const double in_time =
        std::floor(options.batch_time / std::max(options.row_time, 1e-3)) * options.rows_at_once;
    const double for_array = std::ceil(static_cast<double>(targets.size()) / most_batches);
    // Where there are few rows, all tasks that may run at once get some.
    const double for_all = std::ceil(static_cast<double>(targets.size()) / options.most_tasks);
    const auto size = static_cast<std::size_t>(std::max({1.0, std::min(in_time, for_all), for_array}));
    Batches batches;
    for (std::size_t k = 0; k < targets.size(); k += size)
        batches.emplace_back(
            targets.begin() + static_cast<std::ptrdiff_t>(k),
            targets.begin() + static_cast<std::ptrdiff_t>(std::min(k + size, targets.size())));
    return batches;
}

int threads_for(int blocks) {
    return blocks < blocks_for_two_threads ? 1 : 2;
}

std::string job_script(const SlurmOptions& options) {
    return "#!/bin/sh\n"
           "# A task of a study: computes the targets of the list of its number. Written by dda-study "
           "slurm.\n"
           "#   job.sh shared|rows\n"
           "set -u\n"
           "list=slurm/$1/$(printf '%06d' \"$SLURM_ARRAY_TASK_ID\")\n"
           "stop() {\n"
           "    # Runs write their checkpoints, and end with code 75; make waits for them.\n"
           "    echo \"$(date '+%F %T') asked to stop: runs write checkpoints, the task is queued again\"\n"
           "    kill -TERM \"$make\" 2>/dev/null\n"
           "    wait \"$make\"\n"
           "    scontrol requeue \"$SLURM_JOB_ID\"\n"
           "    exit 75\n"
           "}\n"
           "trap stop TERM\n"
           "# shellcheck disable=SC2046\n"
           "make -k -j" +
           std::to_string(options.rows_at_once) + " THREADS=" + std::to_string(options.threads) +
           " $(cat \"$list\") &\n"
           "make=$!\n"
           "wait \"$make\"\n";
}

std::string submit_script(const std::filesystem::path& folder, const SlurmOptions& options,
                          std::size_t shared, std::size_t rows) {
    const auto limit = static_cast<std::size_t>(std::ceil(options.time_limit / minute));
    std::string common = "--requeue --open-mode=append --signal=B:TERM@" + std::to_string(warning_time) +
                         " --time=" + std::to_string(limit) +
                         " --cpus-per-task=" + std::to_string(options.threads * options.rows_at_once) +
                         " --chdir=" + shell_quoted(folder.string());
    for (const std::string& option : options.more) common += " " + shell_quoted(option);
    const auto array = [&](const char* what, std::size_t tasks) {
        return std::string("sbatch --parsable ") + common + " --job-name=" + what + " --output=slurm/" +
               what + "-%a.log --array=1-" + std::to_string(tasks) + "%" + std::to_string(options.most_tasks);
    };
    std::string text =
        "#!/bin/sh\n"
        "# Submits a study to Slurm: what rows share, then the rows. Written by dda-study slurm.\n"
        "set -eu\n"
        "cd " +
        shell_quoted(folder.string()) + "\n";
    std::string after;
    if (shared > 0) {
        text += "shared=$(" + array("shared", shared) + " slurm/job.sh shared)\necho \"$shared\"\n";
        after = " --dependency=afterany:\"$shared\"";
    }
    return text + array("rows", rows) + after + " slurm/job.sh rows\n";
}

std::string list_name(std::size_t index) {
    return numbered("%06zu", index + 1);
}

}  // namespace rockslope::study
