#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "dda/analysis/run_observer.hpp"

namespace rockslope::bench {

/// Statistics of one stage of a run. Steps and cuts count accepted steps; iterations and factorizations
/// include rejected attempts.
struct StageStatistics {
    std::string stage;
    double step = 0;  ///< s, the largest allowed step
    long long steps = 0;
    long long iterations = 0;
    long long factorizations = 0;
    long long cuts = 0;
    double wall_time = 0;     ///< s
    double residual = 0;      ///< J/m, residual of the energy balance since the start of the run
    double input_energy = 0;  ///< J/m, see `StageRecorder`
};

/// Records the statistics of a run by stages, and forwards all events to another observer, if there is one.
/// The input energy is the largest external work so far or, in a run without external work, the largest
/// gravity energy released.
class StageRecorder : public dda::RunObserver {
  public:
    explicit StageRecorder(dda::RunObserver* next = nullptr) : next_(next) {}

    void stage_begins(const dda::Model& model, const dda::State& state, const dda::Stage& stage,
                      int index) override;
    bool step_done(const dda::Model& model, const dda::State& state, const dda::Stage& stage,
                   const dda::StepReport& report) override;
    void stage_ends(const dda::Model& model, const dda::State& state, const dda::Stage& stage,
                    int index) override;

    const std::vector<StageStatistics>& stages() const { return stages_; }

  private:
    using Clock = std::chrono::steady_clock;

    dda::RunObserver* next_;
    std::vector<StageStatistics> stages_;
    Clock::time_point start_;
    double max_work_ = 0;
    double max_gravity_energy_ = 0;
};

/// The run with the median total wall time, of several runs of the same scene. @pre at least one run.
std::vector<StageStatistics> median_run(std::vector<std::vector<StageStatistics>> runs);

}  // namespace rockslope::bench
