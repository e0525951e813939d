#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "dda/analysis/run.hpp"

namespace rockslope::bench {

/// What one stage of a run took. Counts are of accepted steps, but iterations and factorizations include
/// refused attempts.
struct StageStatistics {
    std::string stage;
    double step = 0;  ///< s, the largest allowed
    long long steps = 0;
    long long iterations = 0;
    long long factorizations = 0;
    long long cuts = 0;
    double wall_time = 0;     ///< s
    double residual = 0;      ///< J/m, of the energy balance, at the stage's end, since the run's start
    double input_energy = 0;  ///< J/m, see `StageRecorder`
};

/// Counts a run stage by stage and hands everything on to another observer, if there is one.
/// The input energy is the largest external work so far; in a run without external work, the largest gravity
/// energy released.
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

/// Of several runs of the same scene the one whose total wall time is the median.
/// @pre at least one run.
std::vector<StageStatistics> median_run(std::vector<std::vector<StageStatistics>> runs);

}  // namespace rockslope::bench
