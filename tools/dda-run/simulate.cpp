#include "simulate.hpp"

#include <algorithm>
#include <cstdio>
#include <optional>

#include "common/base/atomic_file.hpp"
#include "common/base/command_text.hpp"
#include "common/base/input_error.hpp"
#include "common/base/output_check.hpp"
#include "common/base/output_error.hpp"
#include "common/base/read_file.hpp"
#include "common/base/sha256.hpp"
#include "common/base/text.hpp"
#include "dda/analysis/run.hpp"
#include "dda/checkpoint/resume_check.hpp"
#include "dda/checkpoint/start_of_run.hpp"
#include "dda/input/read_run.hpp"
#include "dda/linear/front_kernels.hpp"
#include "dda/results/block_table.hpp"
#include "dda/results/read_summary.hpp"
#include "dda/results/results.hpp"
#include "dda/results/summary.hpp"
#include "progress_line.hpp"
#include "stop_request.hpp"
#include "support/commit.hpp"
#include "tell.hpp"
#include "warnings.hpp"

namespace rockslope {

namespace fs = std::filesystem;

namespace {

/// @throws InputError when a result cannot be written or would overwrite an input file.
void check_outputs(const CommandLine& line, const dda::RunInput& input) {
    check_output_folder(line.output);
    std::vector<fs::path> results;
    for (const std::string& name : dda::result_files(input.output.name))
        results.push_back(line.output / name);
    for (const fs::path& file : results) check_output(file, input.files, line.output);
    if (!line.depfile) return;
    check_output(*line.depfile, input.files, line.output);
    results.push_back(*line.depfile);
    check_distinct(results);
}

/// What a run begins with: the initial state, a checkpoint of its own, or a state that another run saved at
/// the end of a stage.
struct Beginning {
    std::optional<dda::Checkpoint> checkpoint;
    bool is_saved_stage = false;
};

dda::Checkpoint checkpoint_of(const CommandLine& line, const dda::RunInput& input, const std::string& hash) {
    const fs::path path = line.output / "checkpoint.h5";
    dda::Checkpoint checkpoint = dda::read_checkpoint(path);
    if (checkpoint.input_hash != hash)
        throw InputError({path.string()}, "belongs to a run of other input",
                         "the same model, block file and records as the stopped run");
    dda::check_resumable(checkpoint, dda::writer_context(input.model, line.output, input.output, line.pvd));
    return checkpoint;
}

/// The checkpoint to continue from. For Make: none where it cannot be continued from, after saying why.
std::optional<dda::Checkpoint> find_checkpoint(const CommandLine& line, const dda::RunInput& input,
                                               const std::string& hash) {
    if (line.resume) return checkpoint_of(line, input, hash);
    if (!line.make || !fs::exists(line.output / "checkpoint.h5")) return std::nullopt;
    try {
        return checkpoint_of(line, input, hash);
    } catch (const InputError& error) {
        std::fprintf(stderr, "dda-run: begins anew: %s\n", error.what());
        return std::nullopt;
    }
}

/// @throws InputError if the results would overwrite those of the saved run, or its own are damaged.
std::optional<dda::Checkpoint> read_saved(const CommandLine& line, const dda::RunInput& input) {
    if (!line.from) return std::nullopt;
    std::error_code ignored;
    if (fs::equivalent(line.from->parent_path().empty() ? "." : line.from->parent_path(), line.output,
                       ignored))
        throw InputError({line.output.string()}, "is the folder of the run that --from begins with",
                         "another folder for the results");
    dda::Checkpoint saved =
        dda::read_saved_state(*line.from, input.fingerprint, static_cast<int>(input.stages.size()));
    dda::check_earlier_results(line.from->parent_path(),
                               dda::writer_context(input.model, line.output, input.output, line.pvd), saved);
    return saved;
}

/// For Make: where the run that should have saved the state for --from has collapsed before, this one has
/// collapsed with it, and takes over its summary. @return whether that is so.
bool has_collapsed_before(const CommandLine& line) {
    if (!line.make || !line.from || fs::exists(*line.from)) return false;
    const fs::path summary = line.from->parent_path() / "summary.json";
    if (!fs::exists(summary) || dda::read_status(summary) != "collapsed") return false;
    make_output_folder(line.output);
    write_file_atomically(line.output / "summary.json", read_text_file(summary));
    std::fprintf(stderr, "dda-run: has collapsed with the run in %s\n", line.from->parent_path().c_str());
    return true;
}

/// The file that --from names, with the digest of its bytes.
std::optional<InputFile> saved_file(const CommandLine& line) {
    if (!line.from) return std::nullopt;
    return InputFile{*line.from, sha256(read_text_file(*line.from))};
}

dda::Provenance provenance_of(const CommandLine& line, const dda::RunInput& input, const std::string& version,
                              const Warnings& warnings) {
    return {.version = version,
            .commit = tool_support::commit(),
            .inputs = input.digests,
            .fingerprint = sha256(input.fingerprint),
            .overrides = line.overrides,
            .saved_state = saved_file(line),
            .threads = line.threads,
            .kernel = dda::chosen_front_kernels<double>().name,
            .fused = dda::chosen_front_kernels<double>().fused,
            .warnings = warnings.lines()};
}

/// Hash of all input. A checkpoint can be continued from only with the same hash.
std::string input_hash(const dda::RunInput& input, const std::optional<dda::Checkpoint>& saved) {
    return sha256(input.fingerprint + (saved ? "from stage " + std::to_string(saved->results.stage) : ""));
}

/// Index of the last stage to run; nothing: all stages.
std::optional<int> last_stage(const CommandLine& line, const std::vector<dda::Stage>& stages, int first) {
    if (!line.until) return std::nullopt;
    std::vector<std::string> names;
    for (const dda::Stage& stage : stages) names.push_back(stage.name);
    const auto found = std::find(names.begin() + first, names.end(), *line.until);
    if (found != names.end()) return static_cast<int>(found - names.begin());
    const auto nearest = nearest_word(*line.until, names);
    throw InputError({"dda-run"}, "--until: no stage '" + *line.until + "' is left to run",
                     nearest ? "perhaps '" + *nearest + "'" : "the name of a later stage");
}

void remove_earlier_results(const fs::path& folder) {
    std::error_code ignored;
    for (const char* name : {"summary.json", "blocks.csv", "checkpoint.h5", "stop"})
        fs::remove(folder / name, ignored);
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
        if (entry.path().filename().string().ends_with(".saved.h5")) fs::remove(entry.path(), ignored);
}

/// Makes the output folder, removes earlier results unless they are continued from a checkpoint, and copies
/// those of the saved run. @return what the run begins with.
Beginning prepare_folder(const CommandLine& line, const dda::RunInput& input,
                         const std::optional<dda::Checkpoint>& saved,
                         const std::optional<dda::Checkpoint>& checkpoint, std::optional<FolderLock>& lock) {
    make_output_folder(line.output);
    if (!lock) lock.emplace(line.output);
    remove_abandoned_files(line.output);
    std::error_code ignored;
    fs::remove(line.output / "failed.json", ignored);
    if (checkpoint) return {checkpoint, false};
    remove_earlier_results(line.output);
    Beginning beginning{saved, saved.has_value()};
    if (saved)
        dda::copy_earlier_results(line.from->parent_path(),
                                  dda::writer_context(input.model, line.output, input.output, line.pvd),
                                  *beginning.checkpoint);
    return beginning;
}

/// The first stage to run, and whether it is entered in its middle.
dda::RunOptions run_options(const CommandLine& line, const Beginning& beginning, std::optional<int> last) {
    if (!beginning.checkpoint) return {line.threads, 0, false, last};
    const int stage = beginning.checkpoint->results.stage;
    if (beginning.is_saved_stage) return {line.threads, stage + 1, false, last};
    return {line.threads, stage, true, last};
}

/// A Make rule: the summary depends on every file read. Each of these is also a target without a recipe, so
/// that Make accepts a file that no longer exists.
std::string depfile_text(const fs::path& summary, const std::vector<fs::path>& files) {
    std::string text = make_escaped(summary) + ":";
    for (const fs::path& file : files)
        text += " \\\n  " + make_escaped(file.lexically_proximate(fs::current_path()));
    text += "\n";
    for (const fs::path& file : files)
        text += "\n" + make_escaped(file.lexically_proximate(fs::current_path())) + ":\n";
    return text;
}

ExitCode exit_code_of(const dda::RunOutcome& outcome) {
    switch (outcome.status) {
        case dda::RunStatus::completed:
        case dda::RunStatus::collapsed:
            return done;
        case dda::RunStatus::stopped:
            return stopped;
        default:
            return analysis_failed;
    }
}

/// Runs the simulation. A run whose results cannot be written ends with the status not_written, which the
/// small summary file records.
dda::RunOutcome run_until_write_error(const dda::RunInput& input, dda::State& state, dda::Results& results,
                                      const dda::RunOptions& options) {
    try {
        return dda::run(input.model, input.stages, state, results, options);
    } catch (const OutputError& error) {
        return {dda::RunStatus::not_written, error.what(), {}};
    }
}

/// Writes the block table and the summary. After an earlier write error, further write errors are ignored:
/// the outcome already states the reason.
void write_summary_files(const CommandLine& line, const dda::RunOutcome& outcome, const std::string& blocks,
                         const std::string& summary) {
    try {
        const bool is_target = !line.make || exit_code_of(outcome) == done;
        write_file_atomically(line.output / "blocks.csv", blocks);
        write_file_atomically(line.output / (is_target ? "summary.json" : "failed.json"), summary);
        std::error_code ignored;
        if (line.make && is_target) fs::remove(line.output / "checkpoint.h5", ignored);
    } catch (const OutputError&) {
        if (outcome.status != dda::RunStatus::not_written) throw;
    }
}

}  // namespace

ExitCode simulate(const CommandLine& line, const std::string& version, std::optional<FolderLock>& lock) {
    install_signal_handlers();
    dda::chosen_front_kernels<double>();  // refused before anything is touched
    if (has_collapsed_before(line)) return done;
    const dda::RunInput input = dda::read_run(line.run_file, {line.overrides, line.blocks, line.output});
    check_outputs(line, input);
    const std::optional<dda::Checkpoint> saved = read_saved(line, input);
    const std::string hash = input_hash(input, saved);
    const std::optional<int> last = last_stage(line, input.stages, saved ? saved->results.stage + 1 : 0);
    const Beginning beginning = prepare_folder(line, input, saved, find_checkpoint(line, input, hash), lock);

    write_file_atomically(line.output / "run.toml", input.effective);
    if (line.depfile)
        write_file_atomically(*line.depfile, depfile_text(line.output / "summary.json", input.files));
    Warnings warnings;
    tell_of_plan(input, line.output, warnings);

    ProgressLine progress;
    const fs::path stop_file = line.output / "stop";
    const auto on_step = [&](const dda::Progress& now) {
        progress.show(now);
        return !stop_requested(stop_file);
    };
    const dda::Checkpoint* resume_from = beginning.checkpoint ? &*beginning.checkpoint : nullptr;
    dda::Results results(
        input.model, input.stages, input.output,
        {line.output, line.pvd, hash, on_step, beginning.is_saved_stage, input.fingerprint, last},
        resume_from);
    dda::State state = resume_from ? resume_from->state : dda::initial_state(input.model);
    const dda::RunOptions options = run_options(line, beginning, last);
    const dda::RunOutcome outcome = run_until_write_error(input, state, results, options);
    progress.clear();

    const std::vector<dda::PlaneSlip> slips = dda::plane_slips(input.model, input.stages, state, results);
    tell_of_results(input, state, outcome, results, slips, warnings);
    const dda::Provenance provenance = provenance_of(line, input, version, warnings);
    write_summary_files(line, outcome,
                        dda::block_table(input.model, state, results, slips, line.output / "blocks.csv"),
                        dda::summary_text(input.model, input.stages, state, outcome, results, provenance));
    tell_of_end(outcome, state, results.wall_time(), line.output);
    return exit_code_of(outcome);
}

}  // namespace rockslope
