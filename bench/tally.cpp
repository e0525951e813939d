#include "tally.hpp"

#include <algorithm>
#include <numeric>

namespace bench {

void Tally::stage_begins(const dda::Model& model, const dda::State& state, const dda::Stage& stage,
                         int index) {
    StageFigures figures;
    figures.stage = stage.name;
    figures.step = stage.control.step;
    stages_.push_back(figures);
    start_ = Clock::now();
    if (next_) next_->stage_begins(model, state, stage, index);
}

bool Tally::step_done(const dda::Model& model, const dda::State& state, const dda::Stage& stage,
                      const dda::StepReport& report) {
    StageFigures& figures = stages_.back();
    ++figures.steps;
    figures.iterations += report.iterations;
    figures.factorizations += report.factorizations;
    figures.cuts += report.cuts;
    most_work_ = std::max(most_work_, state.energy.external_work);
    most_fallen_ = std::max(most_fallen_, -state.energy.gravity);
    return !next_ || next_->step_done(model, state, stage, report);
}

void Tally::stage_ends(const dda::Model& model, const dda::State& state, const dda::Stage& stage, int index) {
    if (next_) next_->stage_ends(model, state, stage, index);
    StageFigures& figures = stages_.back();
    figures.wall_time = std::chrono::duration<double>(Clock::now() - start_).count();
    figures.residual = state.energy.residual();
    figures.input_energy = most_work_ > 0 ? most_work_ : most_fallen_;
}

std::vector<StageFigures> median_run(std::vector<std::vector<StageFigures>> runs) {
    const auto total = [](const std::vector<StageFigures>& run) {
        return std::accumulate(run.begin(), run.end(), 0.0,
                               [](double sum, const StageFigures& f) { return sum + f.wall_time; });
    };
    const auto middle = runs.begin() + static_cast<std::ptrdiff_t>(runs.size() / 2);
    std::nth_element(runs.begin(), middle, runs.end(),
                     [&](const auto& a, const auto& b) { return total(a) < total(b); });
    return *middle;
}

}  // namespace bench
