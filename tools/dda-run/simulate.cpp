#include "simulate.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>

#include "common/base/atomic_file.hpp"
#include "common/base/command_text.hpp"
#include "common/base/input_error.hpp"
#include "common/base/output_check.hpp"
#include "common/base/output_error.hpp"
#include "common/base/read_file.hpp"
#include "common/base/sha256.hpp"
#include "common/base/text.hpp"
#include "dda/analysis/deepest_contact.hpp"
#include "dda/analysis/energy_watch.hpp"
#include "dda/analysis/run.hpp"
#include "dda/checkpoint/resume_check.hpp"
#include "dda/checkpoint/start_of_run.hpp"
#include "dda/input/read_run.hpp"
#include "dda/linear/front_kernels.hpp"
#include "dda/model/glue.hpp"
#include "dda/monitor/plausibility.hpp"
#include "dda/monitor/point_motion.hpp"
#include "dda/monitor/spring_resolution.hpp"
#include "dda/results/block_table.hpp"
#include "dda/results/read_summary.hpp"
#include "dda/results/results.hpp"
#include "dda/results/summary.hpp"
#include "dda/terms/contact_damping.hpp"
#include "progress_line.hpp"
#include "stop_request.hpp"
#include "support/commit.hpp"
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

/// @throws InputError if the results would overwrite those of the saved run.
std::optional<dda::Checkpoint> read_saved(const CommandLine& line, const dda::RunInput& input) {
    if (!line.from) return std::nullopt;
    std::error_code ignored;
    if (fs::equivalent(line.from->parent_path().empty() ? "." : line.from->parent_path(), line.output,
                       ignored))
        throw InputError({line.output.string()}, "is the folder of the run that --from begins with",
                         "another folder for the results");
    return dda::read_saved_state(*line.from, input.fingerprint, static_cast<int>(input.stages.size()));
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

void print_plan(const dda::RunInput& input, const fs::path& folder) {
    const double megabytes = dda::estimated_bytes(input.model, input.stages, input.output) / 1e6;
    const double settling = dda::max_static_frame_bytes(input.model, input.stages, input.output) / 1e6;
    char more[80] = "";
    if (settling > 0)
        std::snprintf(more, sizeof more, ", up to %.2g MB more while static stages settle,", settling);
    std::fprintf(stderr, "dda-run: %d blocks, %zu stages, about %.2g MB of frames%s into %s\n",
                 input.model.block_count(), input.stages.size(), megabytes, more, folder.string().c_str());
}

/// Reports the excavations of stages that this run does not have; their blocks stay.
void warn_of_unreached_excavations(const dda::RunInput& input, Warnings& warnings) {
    for (const dda::Excavation& e : input.model.excavations)
        if (static_cast<std::size_t>(e.stage) > input.stages.size())
            warnings.tell("excavation '%s' is not removed: its stage is %d, the run has %zu stages",
                          e.name.c_str(), e.stage, input.stages.size());
}

/// Tells of blocks that cannot bend with the body that they are glued to.
void warn_of_glued_polygons(const dda::Model& model, Warnings& warnings) {
    const std::optional<dda::GluedPolygons> glued = dda::glued_polygons(model);
    if (!glued) return;
    const dda::Vec2 at = model.vertices[model.topology.block_corners[glued->first]] + model.origin;
    warnings.tell(
        "%d blocks of more than three corners are glued, the first is block %d with a corner "
        "at (%g, %g), joint material %s: a body of them is many times too stiff in bending; cut it "
        "into triangles",
        glued->blocks, glued->first.value(), at.x(), at.y(),
        model.joint_material_at(glued->joint_material).name.c_str());
}

/// Tells of a contact_damping that the steps are too long for.
void warn_of_ineffective_damping(const dda::RunInput& input, Warnings& warnings) {
    const auto found = dda::ineffective_damping(input.model, input.stages);
    if (!found) return;
    const dda::JointMaterial& material = input.model.joint_material_at(found->joint_material);
    const dda::Stage& stage = input.stages[found->stage];
    warnings.tell(
        "contact_damping %g of joint material '%s' has no effect in stage '%s': steps of %g s "
        "damp impacts more (omega dt is %.3g for a block of median mass); see docs/guide/impacts.md",
        material.contact_damping, material.name.c_str(), stage.name.c_str(), stage.control.step,
        found->frequency_step);
}

/// Tells of shear springs whose swing the steps damp.
void warn_of_lost_swings(const dda::RunInput& input, Warnings& warnings) {
    for (const dda::SpringResolution& found : dda::spring_resolutions(input.model, input.stages)) {
        if (!dda::loses_swing(found)) continue;
        const dda::Stage& stage = input.stages[found.stage];
        warnings.tell(
            "stage '%s': a swing of the shear spring of joint material '%s' loses %.2g %% in each "
            "period, of %.0f steps; slips may be too small. Steps of %.2g s lose %g %%",
            stage.name.c_str(), input.model.joint_material_at(found.joint_material).name.c_str(),
            100 * found.lost_per_period, found.shear_period_steps, dda::step_that_keeps_swing(found, stage),
            100 * dda::largest_lost_per_period);
    }
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

/// Prints the factor of safety of a strength reduction: between the largest stable and the smallest failing
/// reduction factor.
void print_factor_of_safety(const std::vector<dda::ReductionTrial>& trials) {
    double stands = 0;
    double fails = std::numeric_limits<double>::infinity();
    for (const dda::ReductionTrial& trial : trials) {
        if (trial.stands)
            stands = std::max(stands, trial.factor);
        else
            fails = std::min(fails, trial.factor);
    }
    if (trials.empty()) return;
    if (stands == 0)
        std::fprintf(stderr, "dda-run: factor of safety below %.4g\n", fails);
    else if (std::isinf(fails))
        std::fprintf(stderr, "dda-run: factor of safety above %.4g\n", stands);
    else
        std::fprintf(stderr, "dda-run: factor of safety %.4g, between %.4g (stands) and %.4g (fails)\n",
                     std::sqrt(stands * fails), stands, fails);
}

/// Tells of energy that came from nowhere.
void warn_of_energy(const dda::Model& model, const dda::Energy& energy, Warnings& warnings) {
    for (const std::string& line : dda::energy_from_nowhere(model, energy))
        warnings.tell("%s. Displacements may be wrong by more than that share", line.c_str());
}

/// Says which blocks still moved when a static stage ended.
void warn_of_left_moving(const std::vector<dda::LeftMoving>& left, const std::vector<dda::Stage>& stages,
                         Warnings& warnings) {
    for (std::size_t k = 0; k < stages.size(); ++k) {
        int count = 0;
        double share = 0;
        const dda::LeftMoving* farthest = nullptr;
        for (const dda::LeftMoving& block : left) {
            if (static_cast<std::size_t>(block.stage) != k) continue;
            ++count;
            share += block.share;
            if (!farthest || block.displacement > farthest->displacement) farthest = &block;
        }
        if (!farthest) continue;
        warnings.tell(
            "stage '%s' is at rest but for %d small block%s, %.2g of the mass; block %d at (%.6g, "
            "%.6g) has moved farthest, %.3g m. %s; see moving_at_rest in summary.json",
            stages[k].name.c_str(), count, count == 1 ? "" : "s", share, farthest->block.value(),
            farthest->centroid.x(), farthest->centroid.y(), farthest->displacement,
            stages[k].remove_moving ? "Removed" : "Kept");
    }
}

/// Tells of a block that is inside another one.
void warn_of_deep_contact(const dda::DeepestContact& deepest, Warnings& warnings) {
    if (!(deepest.share > dda::deep_share)) return;
    warnings.tell(
        "block %d was inside block %d by %.3g m at t = %.6g s, %.2g %% of the smaller one; a stiffer contact "
        "or a penetration_tolerance keeps it out",
        deepest.corner_block.value(), deepest.edge_block.value(), deepest.depth, deepest.time,
        100 * deepest.share);
}

/// Tells of the blocks that have left the ground.
void warn_of_lost_blocks(const dda::Model& model, const std::vector<dda::LostBlock>& lost,
                         Warnings& warnings) {
    if (lost.empty()) return;
    const dda::LostBlock& first = lost.front();
    const dda::Vec2 at = first.centroid + model.origin;
    warnings.tell(
        "%zu %s left the ground, below all fixed and prescribed blocks, and %s; the first is block %d at "
        "t = %.6g s and (%.6g, %.6g)",
        lost.size(), lost.size() == 1 ? "block has" : "blocks have",
        model.removes_lost_blocks ? "was removed there" : "falls on", first.block.value(), first.time, at.x(),
        at.y());
}

/// Says which points still move at the end of a dynamic stage.
void warn_of_still_moving(const dda::Model& model, const dda::State& state, const dda::Stage& last,
                          const dda::Results& results, Warnings& warnings) {
    constexpr double at_rest = 0.01;  // m/s
    if (last.kind != dda::StageKind::dynamic) return;
    const dda::PointMotion from = results.reference()
                                      ? dda::motion_of(model, state, results.points()[*results.reference()])
                                      : dda::PointMotion{};
    for (const dda::TrackedPoint& point : results.points()) {
        const double speed = (dda::motion_of(model, state, point).velocity - from.velocity).norm();
        if (point.material_point.exists() && speed > at_rest)
            warnings.tell(
                "'%s' still moves at %.2g m/s at the end; a longer stage shows where it comes to rest",
                point.name.c_str(), speed);
    }
}

/// Says how many bonds static stages could not hold.
void print_broken_bonds(const dda::BrokenBonds& broken) {
    if (broken.events == 0) return;
    std::fprintf(stderr,
                 "dda-run: the bonds of %lld contacts could not be held at rest and broke, the worst first "
                 "(events: %lld)\n",
                 static_cast<long long>(broken.contacts), static_cast<long long>(broken.events));
}

/// Says how many reversals hang on `min_slip`.
void warn_of_close_reversals(const dda::CloseReversals& close, Warnings& warnings) {
    if (close.counted + close.not_counted == 0) return;
    warnings.tell(
        "%lld reversals of slip that counted and %lld that did not are within a factor of %g "
        "of min_slip; the wear depends on it. See reversals_close_to_min_slip in summary.json",
        static_cast<long long>(close.counted), static_cast<long long>(close.not_counted),
        dda::CloseReversals::factor);
}

void print_outcome(const dda::RunOutcome& outcome, const dda::State& state, double wall_time,
                   const fs::path& folder) {
    const char* where = folder.c_str();
    if (outcome.status == dda::RunStatus::completed)
        std::fprintf(stderr, "dda-run: done, %lld steps to t = %.6g s in %.3g s; results in %s\n",
                     static_cast<long long>(state.step_count), state.time, wall_time, where);
    else if (outcome.status == dda::RunStatus::stopped)
        std::fprintf(stderr, "dda-run: stopped at t = %.6g s; --resume continues from the checkpoint in %s\n",
                     state.time, where);
    else
        std::fprintf(stderr, "dda-run: %s; results so far are in %s\n", outcome.message.c_str(), where);
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
    print_plan(input, line.output);
    Warnings warnings;
    warn_of_unreached_excavations(input, warnings);
    warn_of_glued_polygons(input.model, warnings);
    warn_of_ineffective_damping(input, warnings);
    warn_of_lost_swings(input, warnings);
    for (const std::string& warning : dda::implausible(input.model, input.stages))
        warnings.tell("%s", warning.c_str());

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
    std::fputs(dda::outcome_table(input.model, state, results, slips).c_str(), stdout);
    print_factor_of_safety(results.state().trials);
    warn_of_left_moving(results.state().left_moving, input.stages, warnings);
    warn_of_lost_blocks(input.model, state.lost_blocks, warnings);
    warn_of_deep_contact(state.deepest_contact, warnings);
    if (outcome.status == dda::RunStatus::completed)
        warn_of_still_moving(input.model, state, input.stages.back(), results, warnings);
    print_broken_bonds(state.broken_bonds);
    if (outcome.status != dda::RunStatus::energy_created) warn_of_energy(input.model, state.energy, warnings);
    warn_of_close_reversals(dda::with_present(results.state().close_reversals, input.model, state), warnings);
    const dda::Provenance provenance = provenance_of(line, input, version, warnings);
    write_summary_files(line, outcome,
                        dda::block_table(input.model, state, results, slips, line.output / "blocks.csv"),
                        dda::summary_text(input.model, input.stages, state, outcome, results, provenance));
    print_outcome(outcome, state, results.wall_time(), line.output);
    return exit_code_of(outcome);
}

}  // namespace rockslope
