#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "dda/analysis/run.hpp"
#include "dda/checkpoint/checkpoint.hpp"
#include "dda/model/output_spec.hpp"
#include "dda/monitor/point_motion.hpp"
#include "dda/writers/result_writer.hpp"

namespace rockslope::dda {

/// Where a run is, for a progress line.
struct Progress {
    const Stage& stage;
    const State& state;
    const StepReport& report;
    double done = 0;       ///< s, of the dynamic stages
    double total = 0;      ///< s, likewise
    double wall_time = 0;  ///< s, since this program started the run
};

/// Called after every step; false asks the run to stop, which it does after writing a checkpoint.
using ProgressFunction = std::function<bool(const Progress&)>;

struct ResultsOptions {
    std::filesystem::path folder;  ///< exists already
    bool pvd = false;
    std::string input_hash;  ///< stored in checkpoints
    ProgressFunction progress = [](const Progress&) { return true; };
};

/// Writes the results of a run as it goes: composes the writers of the table, keeps their rhythm, and writes
/// checkpoints.
class Results : public RunObserver {
  public:
    /// Opens the result files; with a checkpoint, cuts them back to it. @throws OutputError.
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
    /// The point that relative motions count from, among points(); nothing where there is none.
    const std::optional<std::size_t>& reference() const { return reference_; }
    /// s of wall time, of this and the earlier parts of the run.
    double wall_time() const;

  private:
    bool frame_is_due(const State& state, const Stage& stage);
    bool is_due(std::int64_t& next, double interval, double stage_time) const;
    void write_frame(const State& state);
    void write_history(const State& state, const Stage& stage);
    void update_peaks(const State& state);
    void update_sliding(const State& state, const StepReport& report);
    void save_checkpoint(const State& state);
    Progress progress_of(const State& state, const Stage& stage, const StepReport& report) const;

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
};

/// The size that the frames of a run will take on disk, bytes, but for those within static stages: an
/// estimate, good to a factor of two.
double estimated_bytes(const Model& model, const std::vector<Stage>& stages, const OutputSpec& output);
/// What the frames within static stages add if every one of these takes all the steps it may: by how many
/// steps it settles is not known before.
double max_static_frame_bytes(const Model& model, const std::vector<Stage>& stages, const OutputSpec& output);

}  // namespace rockslope::dda
