#include <algorithm>
#include <cstdio>
#include <map>

#include "command_options.hpp"
#include "common/base/atomic_file.hpp"
#include "common/base/input_error.hpp"
#include "study/folder/study_folder.hpp"
#include "study/table/profiles.hpp"
#include "study/table/sqlite_file.hpp"
#include "study/table/study_table.hpp"
#include "study_commands.hpp"

namespace rockslope {

namespace fs = std::filesystem;
using study::RowState;

namespace {

constexpr RowState all_states[] = {RowState::completed, RowState::collapsed, RowState::not_needed,
                                   RowState::failed,    RowState::stopped,   RowState::running,
                                   RowState::waiting};

std::map<RowState, std::size_t> count_states(const study::StudyRows& rows) {
    std::map<RowState, std::size_t> counts;
    for (const study::RowResult& result : rows.results) ++counts[result.state];
    return counts;
}

std::size_t count_done(const study::StudyRows& rows) {
    return static_cast<std::size_t>(
        std::count_if(rows.results.begin(), rows.results.end(),
                      [](const auto& result) { return study::is_done(result.state); }));
}

/// "2400 rows: 2390 completed, 6 collapsed, 4 failed".
std::string counts_text(const study::StudyRows& rows) {
    std::string text =
        std::to_string(rows.results.size()) + (rows.results.size() == 1 ? " row: " : " rows: ");
    bool is_first = true;
    const auto counts = count_states(rows);
    for (const RowState state : all_states) {
        const auto found = counts.find(state);
        if (found == counts.end()) continue;
        text += (is_first ? "" : ", ") + std::to_string(found->second) + " " + study::state_name(state);
        is_first = false;
    }
    return text;
}

/// A line for each cause of failure: the number of rows, the first of them, and what it said.
std::string failures_text(const study::StudyRows& rows) {
    struct Failure {
        std::size_t count = 0, first = 0;
    };
    std::map<std::string, Failure> failures;
    for (std::size_t k = 0; k < rows.results.size(); ++k) {
        if (rows.results[k].state != RowState::failed) continue;
        Failure& failure = failures[rows.results[k].cause];
        if (failure.count++ == 0) failure.first = k;
    }
    std::string text;
    for (const auto& [cause, failure] : failures)
        text += "failed, " + cause + ": " + std::to_string(failure.count) +
                (failure.count == 1 ? " row" : " rows") + ", the first is " +
                rows.runs.rows[failure.first][0] + ": " + rows.results[failure.first].message + "\n";
    return text;
}

std::string duration_text(double seconds) {
    char text[32];
    if (seconds < 90)
        std::snprintf(text, sizeof text, "%.0f s", seconds);
    else if (seconds < 5400)
        std::snprintf(text, sizeof text, "%.0f min", seconds / 60);
    else
        std::snprintf(text, sizeof text, "%.1f h", seconds / 3600);
    return text;
}

/// The time that the rows left take, from the mean of those that are done, on as many processes as run now.
std::string time_left_text(const study::StudyRows& rows) {
    double sum = 0;
    std::size_t measured = 0, left = 0, running = 0;
    for (const study::RowResult& result : rows.results) {
        if (result.wall_time > 0) {
            sum += result.wall_time;
            ++measured;
        }
        if (!study::is_done(result.state) && result.state != RowState::failed) ++left;
        if (result.state == RowState::running) ++running;
    }
    if (left == 0) return "";
    if (measured == 0) return "expected time left: not known before a row is done\n";
    const double mean = sum / static_cast<double>(measured);
    const double time =
        mean * static_cast<double>(left) / static_cast<double>(std::max<std::size_t>(running, 1));
    return "a row takes " + duration_text(mean) + "; expected time left: " + duration_text(time) +
           (running == 0   ? ", one at a time\n"
            : running == 1 ? ", one runs now\n"
                           : ", " + std::to_string(running) + " run now\n");
}

/// Says so where rows were computed by programs of different commits.
std::string commits_text(const study::StudyRows& rows) {
    std::map<std::string, std::size_t> commits;
    for (const study::RowResult& result : rows.results)
        if (!result.commit.empty()) ++commits[result.commit];
    if (commits.size() < 2) return "";
    std::string text = "rows are of different programs:";
    for (const auto& [commit, count] : commits)
        text += " " + std::to_string(count) + " of commit " + commit + ",";
    text.back() = '\n';
    return text;
}

/// Says so where rows were computed from other files than there are now.
std::string outdated_text(const std::vector<study::OutdatedRow>& outdated) {
    if (outdated.empty()) return "";
    const study::OutdatedRow& first = outdated.front();
    return std::to_string(outdated.size()) + (outdated.size() == 1 ? " row was" : " rows were") +
           " computed from other input than there is now; the first is " + first.row + ", for changes in " +
           first.files + ". make computes them; where it finds nothing to do, remove results/" +
           first.address + "\n";
}

int exit_code_of(const study::StudyRows& rows) {
    return count_done(rows) == rows.results.size() ? study_done : rows_failed;
}

}  // namespace

int run_status(const std::vector<std::string>& arguments) {
    CommandOptions line(
        "status STUDY [options]",
        "Says how many rows are done, run, wait and failed, why, and how long the rest takes.\n"
        "Exit code 0 when all rows are done, 1 otherwise.");
    line.options().add_options()("failures", "print only what is wrong: for the study's Makefile");
    if (!line.parse(arguments)) return study_done;
    const study::StudyRows rows =
        study::read_study(line.argument("the folder of the study"), study::Reading::states);
    const int code = exit_code_of(rows);
    if (line.has("failures") && code == study_done) {
        std::printf("%s\n", counts_text(rows).c_str());
        return code;
    }
    std::FILE* const out = line.has("failures") ? stderr : stdout;
    std::fprintf(out, "%s\n%s%s%s", counts_text(rows).c_str(), failures_text(rows).c_str(),
                 time_left_text(rows).c_str(), commits_text(rows).c_str());
    return code;
}

int run_collect(const std::vector<std::string>& arguments) {
    CommandOptions line("collect STUDY [options]",
                        "Writes STUDY/results.csv, one row a run, and STUDY/results.sqlite with the same "
                        "table; with [profile] in the "
                        "plan also the\nprofile of each row, STUDY/runs/NUMBER/profile.csv, and all of them "
                        "as STUDY/profiles.csv.");
    if (!line.parse(arguments)) return study_done;
    const fs::path folder = line.argument("the folder of the study");
    study::StudyRows rows = study::read_study(folder);
    const std::vector<study::OutdatedRow> outdated = study::mark_outdated(folder, rows);
    const study::TextTable table = study::results_table(rows);
    const study::TextTable profiles = study::write_profiles(folder, rows);
    write_file_atomically(folder / "results.csv", study::csv_text(table));
    std::vector<study::NamedTable> tables = {{"results", table}};
    if (!profiles.heading.empty()) {
        write_file_atomically(folder / "profiles.csv", study::csv_text(profiles));
        tables.push_back({"profiles", profiles});
    }
    study::write_sqlite(folder / "results.sqlite", tables);
    std::printf("%s\n%s%s%s", counts_text(rows).c_str(), failures_text(rows).c_str(),
                commits_text(rows).c_str(), outdated_text(outdated).c_str());
    return outdated.empty() ? exit_code_of(rows) : rows_failed;
}

int run_skip(const std::vector<std::string>& arguments) {
    CommandOptions line("skip STUDY ROW",
                        "For the Makefile of an incremental study: exit code 0 if the row of this number is "
                        "not needed, for one of "
                        "a smaller\nintensity has failed; 1 if it is to be computed.");
    if (!line.parse(arguments)) return study_done;
    const std::vector<std::string> words = line.arguments();
    if (words.size() != 2) throw InputError({"dda-study skip"}, "there are not two arguments", "STUDY ROW");
    return study::is_row_needed(words[0], words[1]) ? rows_failed : study_done;
}

const std::vector<StudyCommand>& study_commands() {
    static const std::vector<StudyCommand> commands = {
        {"make", "write the folder of a study from a plan", run_make},
        {"slurm", "submit the rows that are not done to a Slurm cluster", run_slurm},
        {"status", "which rows are done, run, wait, and why others failed", run_status},
        {"collect", "gather the results of all rows in a table", run_collect},
        {"fragility", "the probability of failure against an intensity, with its band", run_fragility},
        {"sensitivity", "what a measure depends on: Sobol' indices, effects, a tornado, spreads",
         run_sensitivity},
        {"profile", "the surface of a slope at the end of a run, over stations of x", run_profile},
        {"report", "a page of HTML with all of it", run_report},
        {"skip", "for the Makefile of an incremental study", run_skip}};
    return commands;
}

}  // namespace rockslope
