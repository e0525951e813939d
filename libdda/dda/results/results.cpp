#include "dda/results/results.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "dda/checkpoint/start_of_run.hpp"
#include "dda/monitor/farthest_block.hpp"

namespace rockslope::dda {

namespace {

/// Output is due this fraction of an interval before its time, because of rounding.
constexpr double due_tolerance = 1e-6;

double dynamic_duration(const std::vector<Stage>& stages, std::size_t count) {
    double duration = 0;
    for (std::size_t i = 0; i < count; ++i)
        if (!stages[i].is_static()) duration += stages[i].duration;
    return duration;
}

double seconds(std::chrono::steady_clock::duration duration) {
    return std::chrono::duration<double>(duration).count();
}

void update_peak(double value, double time, double& peak, double& peak_time) {
    if (value <= peak) return;
    peak = value;
    peak_time = time;
}

/// Whether a step ends a static stage. The report of the step decides, and a checkpoint does not contain it:
/// no checkpoint is written between that step and the stage's end.
bool ends_stage(const State& state, const Stage& stage, const StepReport& report) {
    return stage.is_static() && (report.at_rest || state.stage_steps >= stage.step_limit);
}

/// Whether displacements are zeroed at the end of a stage.
bool resets_displacements(const Stage& stage) {
    return stage.is_static() && stage.reset_displacements;
}

}  // namespace

Results::Results(const Model& model, const std::vector<Stage>& stages, const OutputSpec& output,
                 ResultsOptions options, const Checkpoint* resume_from)
    : model_(model),
      stages_(stages),
      output_(output),
      options_(std::move(options)),
      points_(tracked_points(model)),
      reference_(find_point(points_, output.relative_to)),
      resuming_(resume_from != nullptr && !options_.begins_stage),
      start_(Clock::now()),
      last_checkpoint_(start_) {
    if (output_.frames > 0) frame_interval_ = dynamic_duration(stages_, stages_.size()) / output_.frames;
    if (resume_from) progress_ = resume_from->results;
    progress_.peaks.resize(points_.size());
    progress_.regions.resize(model_.measured_regions.size());
    progress_.first_slips.resize(model.block_count());
    for (const WriterEntry& entry : writer_table()) {
        WriterContext context = writer_context(model_, options_.folder, output_, options_.pvd);
        if (!entry.is_enabled(context)) continue;
        if (resume_from && resume_from->positions.contains(entry.name))
            context.resume_from = resume_from->positions.at(entry.name);
        writers_.push_back({entry.name, entry.make(context)});
    }
    // What the files of the saved run have beyond its state is of another run.
    if (options_.begins_stage) end_files();
}

Results::~Results() = default;

double Results::wall_time() const {
    return progress_.wall_time + seconds(Clock::now() - start_);
}

bool Results::is_due(std::int64_t& next, double interval, double stage_time) const {
    const double intervals = stage_time / interval + due_tolerance;
    if (intervals < static_cast<double>(next)) return false;
    next = static_cast<std::int64_t>(std::floor(intervals)) + 1;
    return true;
}

bool Results::frame_is_due(const State& state, const Stage& stage) {
    if (!stage.is_static())
        return frame_interval_ > 0 && is_due(progress_.next_frame, frame_interval_, state.stage_time);
    return output_.static_frame_interval > 0 && state.stage_steps % output_.static_frame_interval == 0;
}

void Results::write_frame(const State& state, const Stage& stage) {
    if (progress_.last_frame_step == state.step_count) return;
    progress_.last_frame_step = state.step_count;
    for (const NamedWriter& entry : writers_) entry.writer->frame(state, stage);
}

void Results::write_history(const State& state, const Stage& stage) {
    if (progress_.last_history_step == state.step_count) return;
    progress_.last_history_step = state.step_count;
    for (const NamedWriter& entry : writers_) entry.writer->history(state, stage);
}

/// Removes what a run that is over does not have of those that it was resumed from.
void Results::end_files() {
    for (const NamedWriter& entry : writers_) {
        entry.writer->cut();
        entry.writer->sync();
    }
}

void Results::update_peaks(const State& state, double step) {
    const Vec2 from =
        reference_ ? motion_of(model_, state, points_[*reference_]).displacement : Vec2(Vec2::Zero());
    for (std::size_t i = 0; i < points_.size(); ++i) {
        const PointMotion motion = motion_of(model_, state, points_[i]);
        Peaks& peaks = progress_.peaks[i];
        update_peak(motion.displacement.norm(), state.time, peaks.displacement, peaks.displacement_time);
        update_peak(motion.velocity.norm(), state.time, peaks.velocity, peaks.velocity_time);
        update_peak(motion.acceleration.norm(), state.time, peaks.acceleration, peaks.acceleration_time);
        update_peak((motion.displacement - from).norm(), state.time, peaks.relative, peaks.relative_time);
        peaks.smooth_acceleration = std::max(
            peaks.smooth_acceleration, peaks.smooth.pass(motion.acceleration, step, smooth_corner).norm());
    }
    for (std::size_t i = 0; i < model_.measured_regions.size(); ++i)
        progress_.regions[i].add(displacement_of(state, model_.measured_regions[i], from), state.time);
    const auto farthest = farthest_block(model_, state, from);
    if (farthest && (!progress_.farthest || farthest->displacement > progress_.farthest->displacement))
        progress_.farthest = farthest;
}

/// Finds the blocks on planes after the first dynamic step, since before it there may be no contacts, and
/// updates the first slips.
void Results::update_sliding(const State& state, const StepReport& report) {
    const bool is_first = state.dynamic_time <= report.step * (1 + 1e-9);
    if (is_first) progress_.planes = find_blocks_on_planes(model_, state);
    update_first_slips(model_, state, report, output_.slip_threshold, progress_.first_slips);
}

Checkpoint Results::checkpoint_of(const State& state) const {
    Checkpoint checkpoint{state, progress_, {}, {}, options_.input_hash};
    checkpoint.results.wall_time = wall_time();
    for (const NamedWriter& entry : writers_) {
        checkpoint.positions[entry.name] = entry.writer->position();
        if (const std::string digest = entry.writer->digest(); !digest.empty())
            checkpoint.digests[entry.name] = digest;
    }
    return checkpoint;
}

/// A disk that takes long to say that the bytes are on it takes a fifth of the run at most.
bool Results::checkpoint_is_due() const {
    constexpr double times_between = 4;  // over the time that a checkpoint takes
    return seconds(Clock::now() - last_checkpoint_) >=
           std::max(output_.checkpoint_interval, times_between * checkpoint_time_);
}

void Results::save_checkpoint(const State& state) {
    const Clock::time_point begin = Clock::now();
    save(checkpoint_of(state), "checkpoint.h5");
    last_checkpoint_ = Clock::now();
    checkpoint_time_ = seconds(last_checkpoint_ - begin);
}

/// Saves the state for runs that branch off here. Their wall time is their own.
void Results::save_end_of_stage(const State& state, int stage_index) {
    if (!output_.save_stages && options_.save_end_of != stage_index) return;
    Checkpoint saved = checkpoint_of(state);
    saved.results.wall_time = 0;
    saved.start_of_run = start_of_run(options_.fingerprint, stage_index + 1);
    save(saved, saved_state_name(stage_index));
}

/// What a checkpoint counts as written is on the disk before the checkpoint is.
void Results::save(const Checkpoint& checkpoint, const std::string& file) {
    for (const NamedWriter& entry : writers_) entry.writer->sync();
    write_checkpoint(options_.folder / file, checkpoint);
}

Progress Results::progress_of(const State& state, const Stage& stage, const StepReport& report) const {
    const double before = dynamic_duration(stages_, static_cast<std::size_t>(progress_.stage));
    const double now = stage.is_static() ? 0 : state.stage_time;
    return {stage,
            state,
            report,
            before + now,
            dynamic_duration(stages_, stages_.size()),
            seconds(Clock::now() - start_),
            std::nullopt};
}

void Results::stage_begins(const Model&, const State& state, const Stage& stage, int stage_index) {
    if (std::exchange(resuming_, false)) return;
    progress_.stage = stage_index;
    progress_.next_frame = progress_.next_history = 1;
    if (stage.strength_reduction) progress_.trials.clear();
    // The last stage zeroed the displacements: write a second row of this time, after the one with its
    // displacements.
    if (stage_index > 0 && resets_displacements(stages_[static_cast<std::size_t>(stage_index) - 1]))
        progress_.last_history_step = -1;
    write_frame(state, stage);
    write_history(state, stage);
}

bool Results::step_done(const Model&, const State& state, const Stage& stage, const StepReport& report) {
    for (const NamedWriter& entry : writers_) entry.writer->step(state, stage, report);
    progress_.fallbacks += report.fallbacks;
    progress_.remaining_dilation = std::max(progress_.remaining_dilation, report.remaining_dilation);
    for (const JointCounterSlip& ended : report.ended_counter_slips)
        progress_.close_reversals.add({state.time, ended});
    if (output_.history_interval == 0 ||
        is_due(progress_.next_history, output_.history_interval, state.stage_time))
        write_history(state, stage);
    const bool ends = ends_stage(state, stage, report);
    if (!ends && frame_is_due(state, stage)) write_frame(state, stage);
    // Peaks are those of dynamic stages.
    if (!stage.is_static()) {
        update_peaks(state, report.step);
        update_sliding(state, report);
    }

    const bool go_on = options_.progress(progress_of(state, stage, report));
    if (ends) return true;
    if (!go_on || checkpoint_is_due()) save_checkpoint(state);
    return go_on;
}

/// The bracket of the factor is halved in its logarithm until it is narrow enough.
TrialProgress Results::trial_progress(const Model& weakened, const Stage& stage) const {
    TrialProgress trial{static_cast<int>(progress_.trials.size()) + 1,
                        weakened.strength_reduction / model_.strength_reduction, std::nullopt};
    double stands = 0, fails = std::numeric_limits<double>::infinity();
    for (const ReductionTrial& past : progress_.trials)
        past.stands ? stands = std::max(stands, past.factor) : fails = std::min(fails, past.factor);
    if (stands > 0 && std::isfinite(fails)) {
        const double width = std::log1p(stage.strength_reduction->width);
        const double halvings = std::log2(std::max(1.0, std::log(fails / stands) / width));
        trial.left = std::max(0, static_cast<int>(std::ceil(halvings)) - 1);
    }
    return trial;
}

bool Results::trial_step_done(const Model& weakened, const State& state, const Stage& stage,
                              const StepReport& report) {
    Progress progress = progress_of(state, stage, report);
    progress.trial = trial_progress(weakened, stage);
    return options_.progress(progress);
}

void Results::trial_done(const Model&, const State&, const Stage&, const ReductionTrial& trial) {
    progress_.trials.push_back(trial);
}

void Results::mechanism_found(const Model&, const State& state, const Stage& stage) {
    write_history(state, stage);
    write_frame(state, stage);
}

void Results::stage_ends(const Model&, const State& state, const Stage& stage, int stage_index) {
    const bool is_last = static_cast<std::size_t>(stage_index) + 1 == stages_.size();
    // mechanism_found wrote the frame of a strength reduction
    if (!stage.strength_reduction) {
        const std::vector<LeftMoving> left = left_moving(model_, state, stage, stage_index);
        progress_.left_moving.insert(progress_.left_moving.end(), left.begin(), left.end());
        write_history(state, stage);
        // A viewer finds a frame by its time: if displacements are zeroed, only the next stage's start is
        // written.
        if (is_last || !resets_displacements(stage)) write_frame(state, stage);
    }
    if (is_last || options_.save_end_of == stage_index) end_files();
    save_end_of_stage(state, stage_index);
}

void Results::stage_fails(const Model&, const State& state, const Stage& stage, int) {
    write_history(state, stage);
    write_frame(state, stage);
    end_files();
}

namespace {

double bytes_per_frame(const Model& model, const OutputSpec& output) {
    constexpr double compressed = 0.6;  // size of the shuffled and deflated floats over the original
    const double bytes_per_corner = model.origin.isZero(0) ? 6 * 4 : 3 * 8 + 3 * 4;  // with displacement
    constexpr double bytes_per_block = 14 * 4;                                       // quantities of a block
    constexpr double bytes_per_contact = 90;  // coordinates, cell and quantities
    constexpr double contacts_per_block = 4;  // typical of a jointed rock mass
    const double blocks =
        bytes_per_corner * static_cast<double>(model.vertices.size()) + model.block_count() * bytes_per_block;
    const double contacts = model.block_count() * contacts_per_block * bytes_per_contact;
    return compressed * blocks + (output.joint_frames ? contacts : 0);
}

}  // namespace

double estimated_bytes(const Model& model, const std::vector<Stage>& stages, const OutputSpec& output) {
    const double frames = (dynamic_duration(stages, stages.size()) > 0 ? output.frames : 0) + 1.0 +
                          static_cast<double>(stages.size());
    return frames * bytes_per_frame(model, output);
}

double max_static_frame_bytes(const Model& model, const std::vector<Stage>& stages,
                              const OutputSpec& output) {
    if (output.static_frame_interval == 0) return 0;
    double frames = 0;
    for (const Stage& stage : stages)
        if (stage.is_static() && !stage.strength_reduction)
            frames += std::floor(static_cast<double>(stage.step_limit) / output.static_frame_interval);
    return frames * bytes_per_frame(model, output);
}

}  // namespace rockslope::dda
