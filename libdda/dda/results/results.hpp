#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "dda/analysis/run_observer.hpp"
#include "dda/checkpoint/checkpoint.hpp"
#include "dda/model/output_spec.hpp"
#include "dda/monitor/point_motion.hpp"
#include "dda/writers/result_writer.hpp"

namespace rockslope::dda {

/// Where a strength reduction is.
struct TrialProgress {
    int number = 1;     ///< of the trial, from 1
    double factor = 1;  ///< strengths are divided by it
    std::optional<int> left =
        std::nullopt;  ///< trials after this one; nothing before the factor is bracketed
};

/// Progress of a run, for a progress line.
struct Progress {
    const Stage& stage;
    const State& state;
    const StepReport& report;
    double done = 0;                                    ///< s, computed part of the dynamic stages
    double total = 0;                                   ///< s, duration of the dynamic stages
    double wall_time = 0;                               ///< s, since this program started the run
    std::optional<TrialProgress> trial = std::nullopt;  ///< of a strength reduction
};

/// Called after every step; false asks the run to stop, which it does after writing a checkpoint.
using ProgressFunction = std::function<bool(const Progress&)>;

struct ResultsOptions {
    std::filesystem::path folder;  ///< must exist
    bool pvd = false;
    std::string input_hash;  ///< stored in checkpoints
    ProgressFunction progress = [](const Progress&) { return true; };
    bool begins_stage = false;            ///< the state to resume from was saved at the end of a stage
    std::string fingerprint = {};         ///< of the run's input, for states saved at the end of stages
    std::optional<int> save_end_of = {};  ///< index of a stage whose end is saved in any case
};

/// Writes the results of a run: calls the enabled writers of writer_table() when their output is due, and
/// writes checkpoints.
class Results : public RunObserver {
  public:
    /// Opens the result files; with a checkpoint, goes on in them from its positions. What a killed run wrote
    /// beyond them stays until it is written again, or the run is over. @throws OutputError.
    Results(const Model& model, const std::vector<Stage>& stages, const OutputSpec& output,
            ResultsOptions options, const Checkpoint* resume_from = nullptr);
    ~Results() override;

    void stage_begins(const Model& model, const State& state, const Stage& stage, int stage_index) override;
    bool step_done(const Model& model, const State& state, const Stage& stage,
                   const StepReport& report) override;
    void stage_ends(const Model& model, const State& state, const Stage& stage, int stage_index) override;
    bool trial_step_done(const Model& model, const State& state, const Stage& stage,
                         const StepReport& report) override;
    void trial_done(const Model& model, const State& state, const Stage& stage,
                    const ReductionTrial& trial) override;
    void mechanism_found(const Model& model, const State& state, const Stage& stage) override;
    void stage_fails(const Model& model, const State& state, const Stage& stage, int stage_index) override;

    const ResultsState& state() const { return progress_; }
    const std::vector<TrackedPoint>& points() const { return points_; }
    /// Index in points() of the reference of relative motions; nothing if there is none.
    const std::optional<std::size_t>& reference() const { return reference_; }
    /// s of wall time, of this and the earlier parts of the run.
    double wall_time() const;

  private:
    bool frame_is_due(const State& state, const Stage& stage);
    bool is_due(std::int64_t& next, double interval, double stage_time) const;
    void write_frame(const State& state, const Stage& stage);
    void write_history(const State& state, const Stage& stage);
    void end_files();
    void update_peaks(const State& state, double step);
    void update_sliding(const State& state, const StepReport& report);
    Checkpoint checkpoint_of(const State& state) const;
    bool checkpoint_is_due() const;
    void save_checkpoint(const State& state);
    void save(const Checkpoint& checkpoint, const std::string& file);
    void save_end_of_stage(const State& state, int stage_index);
    Progress progress_of(const State& state, const Stage& stage, const StepReport& report) const;
    TrialProgress trial_progress(const Model& weakened, const Stage& stage) const;

    using Clock = std::chrono::steady_clock;
    struct NamedWriter {
        std::string name;
        std::unique_ptr<ResultWriter> writer;
    };

    const Model& model_;
    const std::vector<Stage>& stages_;
    OutputSpec output_;
    ResultsOptions options_;
    std::vector<TrackedPoint> points_;
    std::optional<std::size_t> reference_;
    std::vector<NamedWriter> writers_;
    ResultsState progress_;
    double frame_interval_ = 0;  ///< s; 0: no frames within stages
    bool resuming_;
    Clock::time_point start_;
    Clock::time_point last_checkpoint_;
    double checkpoint_time_ = 0;  ///< s of wall time that the last one took
};

/// Estimated size on disk of the frames of a run, bytes, without those inside static stages. It is correct to
/// a factor of two.
double estimated_bytes(const Model& model, const std::vector<Stage>& stages, const OutputSpec& output);
/// Upper bound of the size on disk of the frames inside static stages, bytes: every static stage takes all
/// the steps of its limit.
double max_static_frame_bytes(const Model& model, const std::vector<Stage>& stages, const OutputSpec& output);

}  // namespace rockslope::dda
