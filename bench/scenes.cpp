#include "scenes.hpp"

#include <stdexcept>

#include "dda/input/read_run.hpp"
#include "dda/results/results.hpp"
#include "support/walls.hpp"

namespace rockslope::bench {

namespace {

/// Runs the stages. The time of the writing observer, if given, is included.
std::vector<StageStatistics> timed(const dda::Model& model, const std::vector<dda::Stage>& stages,
                                   int threads, dda::RunObserver* writer) {
    StageRecorder recorder(writer);
    dda::State state = dda::initial_state(model);
    const dda::RunOutcome outcome = dda::run(model, stages, state, recorder, {threads, 0, false});
    if (outcome.status != dda::RunStatus::completed) throw std::runtime_error(outcome.message);
    return recorder.stages();
}

}  // namespace

Outcome run_wall(int columns, int rows, double step, double duration, int threads) {
    const scene::Scene wall = scene::running_bond_wall(columns, rows, 10);
    dda::Stage settle;
    settle.name = "settle";
    settle.kind = dda::StageKind::static_equilibrium;
    dda::Stage stand;
    stand.name = "stand";
    stand.duration = duration;
    stand.control.step = step;
    const int blocks = wall.model.block_count();
    return {"wall-" + std::to_string(blocks - 1), blocks,
            timed(wall.model, {settle, stand}, threads, nullptr)};
}

Outcome run_model(const std::filesystem::path& run_file, const std::filesystem::path& blocks,
                  const std::filesystem::path& folder, int threads) {
    const dda::RunInput input = dda::read_run(run_file, {{}, blocks, folder});
    std::filesystem::create_directories(folder);
    dda::Results results(input.model, input.stages, input.output, {folder, false, "bench"});
    return {input.output.name, input.model.block_count(),
            timed(input.model, input.stages, threads, &results)};
}

}  // namespace rockslope::bench
