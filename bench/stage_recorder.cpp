#include "stage_recorder.hpp"

#include <algorithm>
#include <numeric>

namespace rockslope::bench {

void StageRecorder::stage_begins(const dda::Model& model, const dda::State& state, const dda::Stage& stage,
                                 int index) {
    StageStatistics figures;
    figures.stage = stage.name;
    figures.step = stage.control.step;
    stages_.push_back(figures);
    start_ = Clock::now();
    if (next_) next_->stage_begins(model, state, stage, index);
}

bool StageRecorder::step_done(const dda::Model& model, const dda::State& state, const dda::Stage& stage,
                              const dda::StepReport& report) {
    StageStatistics& figures = stages_.back();
    ++figures.steps;
    figures.iterations += report.iterations;
    figures.factorizations += report.factorizations;
    figures.cuts += report.cuts;
    max_work_ = std::max(max_work_, state.energy.external_work);
    max_gravity_energy_ = std::max(max_gravity_energy_, -state.energy.gravity);
    return !next_ || next_->step_done(model, state, stage, report);
}

void StageRecorder::stage_ends(const dda::Model& model, const dda::State& state, const dda::Stage& stage,
                               int index) {
    if (next_) next_->stage_ends(model, state, stage, index);
    StageStatistics& figures = stages_.back();
    figures.wall_time = std::chrono::duration<double>(Clock::now() - start_).count();
    figures.residual = state.energy.residual();
    figures.input_energy = max_work_ > 0 ? max_work_ : max_gravity_energy_;
}

std::vector<StageStatistics> median_run(std::vector<std::vector<StageStatistics>> runs) {
    const auto total = [](const std::vector<StageStatistics>& run) {
        return std::accumulate(run.begin(), run.end(), 0.0,
                               [](double sum, const StageStatistics& f) { return sum + f.wall_time; });
    };
    const auto middle = runs.begin() + static_cast<std::ptrdiff_t>(runs.size() / 2);
    std::nth_element(runs.begin(), middle, runs.end(),
                     [&](const auto& a, const auto& b) { return total(a) < total(b); });
    return *middle;
}

}  // namespace rockslope::bench
