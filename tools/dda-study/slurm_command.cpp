#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>

#include "blockgen/mesh/block_file.hpp"
#include "command_options.hpp"
#include "common/base/atomic_file.hpp"
#include "common/base/command_text.hpp"
#include "common/base/input_error.hpp"
#include "common/base/output_check.hpp"
#include "study/cluster/slurm_text.hpp"
#include "study/folder/study_folder.hpp"
#include "study/table/study_table.hpp"
#include "study_commands.hpp"

namespace rockslope {

namespace fs = std::filesystem;
namespace po = boost::program_options;

namespace {

constexpr double minute = 60;
/// The limit of a task over its expected time, and what is added for slow rows, s.
constexpr double limit_ratio = 2, limit_more = 600;

void add_slurm_options(CommandOptions& line) {
    auto add = line.options().add_options();
    add("max", po::value<int>()->default_value(64)->value_name("N"), "tasks that run at once");
    add("dry-run", "write the scripts and submit nothing");
    add("row-time", po::value<double>()->value_name("S"),
        "expected wall time of a row, s (default: the mean of the rows that are done, then the plan's "
        "row_time, then 60)");
    add("batch-time", po::value<double>()->default_value(30)->value_name("MIN"),
        "expected wall time of a task, min");
    add("time-limit", po::value<double>()->value_name("MIN"),
        "limit of a task, min, at which it is stopped and queued again (default: twice the batch time and "
        "10)");
    add("threads", po::value<int>()->value_name("N"), "of a row (default: by the number of blocks)");
    add("rows", po::value<int>()->default_value(1)->value_name("N"), "rows at once in a task");
    add("sbatch", po::value<std::vector<std::string>>()->composing()->value_name("OPTION"),
        "more options of sbatch, e.g. --sbatch=--partition=short (may be repeated)");
}

double row_time_of(const CommandOptions& line, const study::StudyRows& rows) {
    if (line.has("row-time")) return line.get<double>("row-time");
    double sum = 0;
    int count = 0;
    for (const study::RowResult& result : rows.results)
        if (result.wall_time > 0) {
            sum += result.wall_time;
            ++count;
        }
    if (count > 0) return sum / count;
    return rows.plan.row_time > 0 ? rows.plan.row_time : minute;
}

/// The number of blocks of the first cut that is there; 0 where none is.
int blocks_of(const fs::path& folder, const study::StudyRows& rows) {
    std::vector<fs::path> files = {rows.plan.blocks};
    const std::size_t cut = *rows.runs.find(study::cut_column);
    for (const auto& run : rows.runs.rows) files.push_back(folder / "cuts" / (run[cut] + ".blocks"));
    for (const fs::path& file : files)
        if (!file.empty() && fs::is_regular_file(file)) return blockgen::read_block_file(file).block_count();
    return 0;
}

void check_positive(const CommandOptions& line, const char* option, double value) {
    if (!(value > 0))
        throw InputError({line.program()}, std::string("--") + option + " is not positive",
                         "a positive number");
}

study::SlurmOptions options_of(const CommandOptions& line, const fs::path& folder,
                               const study::StudyRows& rows) {
    study::SlurmOptions options;
    options.most_tasks = line.get<int>("max");
    options.row_time = row_time_of(line, rows);
    options.batch_time = minute * line.get<double>("batch-time");
    options.time_limit = line.has("time-limit") ? minute * line.get<double>("time-limit")
                                                : limit_ratio * options.batch_time + limit_more;
    options.threads =
        line.has("threads") ? line.get<int>("threads") : study::threads_for(blocks_of(folder, rows));
    options.rows_at_once = line.get<int>("rows");
    if (line.has("sbatch")) options.more = line.get<std::vector<std::string>>("sbatch");
    check_positive(line, "max", options.most_tasks);
    check_positive(line, "row-time", options.row_time);
    check_positive(line, "batch-time", options.batch_time);
    check_positive(line, "time-limit", options.time_limit);
    check_positive(line, "threads", options.threads);
    check_positive(line, "rows", options.rows_at_once);
    return options;
}

/// The targets of the rows that are not done, and of what they share and is not there.
struct Targets {
    std::vector<std::string> shared, rows;
    std::size_t row_count = 0;  ///< rows that the targets compute
};

/// Of an incremental study, the rows that are the last of their series: make computes those of smaller
/// intensities before them, so that no two tasks compute the same row.
std::set<std::size_t> last_of_series(const study::StudyRows& rows) {
    const std::size_t block = *rows.runs.find(study::block_column),
                      replicate = *rows.runs.find(study::replicate_column);
    std::map<std::pair<std::string, std::string>, std::size_t> last;
    for (std::size_t k = 0; k < rows.results.size(); ++k)
        if (!study::is_done(rows.results[k].state))
            last[{rows.runs.rows[k][block], rows.runs.rows[k][replicate]}] = k;
    std::set<std::size_t> rows_asked;
    for (const auto& [series, row] : last) rows_asked.insert(row);
    return rows_asked;
}

Targets targets_of(const fs::path& folder, const study::StudyRows& rows) {
    const std::size_t address = *rows.runs.find(study::address_column),
                      start = *rows.runs.find(study::start_column), cut = *rows.runs.find(study::cut_column);
    Targets targets;
    std::set<std::string> known;
    const bool is_incremental = rows.plan.design.kind == study::DesignKind::incremental;
    const std::set<std::size_t> last = is_incremental ? last_of_series(rows) : std::set<std::size_t>{};
    for (std::size_t k = 0; k < rows.results.size(); ++k) {
        if (study::is_done(rows.results[k].state)) continue;
        const std::vector<std::string>& run = rows.runs.rows[k];
        if (known.insert(run[address]).second) {
            ++targets.row_count;
            if (!is_incremental || last.contains(k))
                targets.rows.push_back("results/" + run[address] + "/summary.json");
        }
        const std::string shared = !run[start].empty() ? study::start_target(folder, run[start])
                                   : !run[cut].empty() ? "cuts/" + run[cut] + ".blocks"
                                                       : "";
        if (!shared.empty() && !fs::exists(folder / shared) && known.insert(shared).second)
            targets.shared.push_back(shared);
    }
    return targets;
}

void write_lists(const fs::path& folder, const study::Batches& batches) {
    std::error_code ignored;
    fs::remove_all(folder, ignored);
    make_output_folder(folder);
    for (std::size_t k = 0; k < batches.size(); ++k) {
        std::string text;
        for (const std::string& target : batches[k]) text += target + "\n";
        write_file_atomically(folder / study::list_name(k), text);
    }
}

}  // namespace

int run_slurm(const std::vector<std::string>& arguments) {
    CommandOptions line(
        "slurm STUDY [options]",
        "Writes STUDY/slurm and submits the rows that are not done as job arrays: what they share first, "
        "then "
        "the rows, in batches\nby expected time. A task near its time limit writes checkpoints and is queued "
        "again; so are the tasks of a node that dies.");
    add_slurm_options(line);
    if (!line.parse(arguments)) return study_done;
    const fs::path folder = fs::absolute(line.argument("the folder of the study")).lexically_normal();
    const study::StudyRows rows = study::read_study(folder, study::Reading::states);
    study::SlurmOptions options = options_of(line, folder, rows);
    const Targets targets = targets_of(folder, rows);
    if (targets.rows.empty()) {
        std::printf("all %zu rows are done\n", rows.results.size());
        return study_done;
    }
    const study::Batches shared = study::make_batches(targets.shared, options);
    options.row_time *= static_cast<double>(targets.row_count) / static_cast<double>(targets.rows.size());
    const study::Batches batches = study::make_batches(targets.rows, options);
    write_lists(folder / "slurm" / "shared", shared);
    write_lists(folder / "slurm" / "rows", batches);
    write_file_atomically(folder / "slurm" / "job.sh", study::job_script(options));
    write_file_atomically(folder / "slurm" / "submit.sh",
                          study::submit_script(folder, options, shared.size(), batches.size()));
    std::printf("%zu rows in %zu tasks, %zu shared results in %zu; %d thread%s a row\n", targets.row_count,
                batches.size(), targets.shared.size(), shared.size(), options.threads,
                options.threads == 1 ? "" : "s");
    std::fflush(stdout);
    if (line.has("dry-run")) return study_done;
    const std::string command = "sh " + shell_quoted((folder / "slurm" / "submit.sh").string());
    if (std::system(command.c_str()) == 0) return study_done;  // NOLINT(cert-env33-c): the script is ours
    throw InputError({line.program()}, "the jobs were not submitted, see above",
                     "a machine with sbatch; or --dry-run");
}

}  // namespace rockslope
