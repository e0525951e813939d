// Times the phases of steps: bench_steps --wall COLUMNSxROWS | --model RUN.toml --blocks FILE, see `usage`.

#include <malloc.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "dda/analysis/run_stage.hpp"
#include "dda/analysis/step.hpp"
#include "dda/input/read_run.hpp"
#include "options.hpp"
#include "support/walls.hpp"

using namespace rockslope;

namespace {

constexpr const char* usage =
    "bench_steps --wall COLUMNSxROWS [--penalty TIMES-E] | --model RUN.toml --blocks FILE [--name SCENE]\n"
    "    [--step S] [--steps N] [--warm N] [--iterations N] [--threads N]\n"
    "    [--solver multifrontal|refined|simplicial] [--no-heading]\n"
    "Runs all stages of the model except the last, then WARM steps of the last stage, then N timed steps.\n"
    "Prints the times of their phases as CSV, in us per block and step: CPU time on one thread, wall time\n"
    "on several. `at four` is the time of a step of four open-close iterations: the phases of the iteration\n"
    "are scaled to four iterations, the other phases are as measured.\n"
    "With --iterations, WARM steps are accepted after their first iteration; the equations of the next step\n"
    "are then iterated that number of times. This is repeated N times.\n";

using bench::Options;
using bench::read_number;
using dda::Phase;

double cpu_time() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double wall_time() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double peak_bytes() {
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    return 1024.0 * static_cast<double>(used.ru_maxrss);
}

struct Scene {
    std::string name;
    dda::Model model;
    dda::Stage stage;
    std::vector<dda::Stage> before;  ///< stages to run before the timed one
};

Scene wall(const Options& options) {
    const bench::WallSize size = bench::read_wall_size(options.at("--wall"));
    Scene scene;
    scene.model =
        scene::running_bond_wall(size.columns, size.rows, read_number(options.at("--penalty"), 0.0)).model;
    const int iterations = read_number(options.at("--iterations"), 0);
    scene.name = iterations > 0 ? "wall of " + options.at("--iterations") + " iterations"
                                : "wall after " + options.at("--warm") + " steps";
    return scene;
}

Scene slope(const Options& options) {
    const dda::RunInput input = dda::read_run(options.at("--model"), {{}, options.at("--blocks"), {}});
    Scene scene{options.count("--name") ? options.at("--name") : input.output.name, input.model,
                input.stages.back(), input.stages};
    scene.before.pop_back();
    return scene;
}

/// The state at the start of the timed stage.
dda::State prepared(const Scene& scene, int threads) {
    dda::State state = dda::initial_state(scene.model);
    dda::RunObserver no_observer;
    const dda::RunOutcome outcome = dda::run(scene.model, scene.before, state, no_observer, {threads});
    if (outcome.status != dda::RunStatus::completed) throw std::runtime_error(outcome.message);
    dda::begin_stage(state);
    return state;
}

/// Sums over the timed steps.
struct Figures {
    int steps = 0;
    double iterations = 0;
    double factorizations = 0;
    double substitutions = 0;
    dda::PhaseTimes::Clock clock;
    dda::PhaseTimes times{clock};
    double update = 0;      ///< s, updates that are not in `times`
    double peak_bytes = 0;  ///< peak memory of the process up to the last timed step

    double seconds(Phase phase) const { return times.seconds(phase) + (phase == Phase::update ? update : 0); }
    double total() const {
        double sum = 0;
        for (std::size_t p = 0; p < static_cast<std::size_t>(Phase::count); ++p)
            sum += seconds(static_cast<Phase>(p));
        return sum;
    }
    double at_four() const {
        double of_iteration = 0;
        for (const Phase p : {Phase::assembly, Phase::factorisation, Phase::solution, Phase::evaluation})
            of_iteration += times.seconds(p);
        return total() + of_iteration * (4 * steps / iterations - 1);
    }
};

/// The state after a step that is accepted after its first iteration.
dda::State step_without_tolerance(dda::TimeStepper& stepper, dda::Stage stage, const dda::State& state,
                                  double dt) {
    stage.control.force_tolerance = 1e300;
    dda::StepAttempt attempt = stepper.advance(stage, state, dt);
    if (attempt.rejection != dda::Rejection::none) throw std::runtime_error("a step is rejected");
    return std::move(attempt.state);
}

/// Times the given number of iterations of a step. The time of the update is that of a step accepted after
/// its first iteration.
void iterate(dda::TimeStepper& stepper, dda::Stage stage, const dda::State& state, double dt, int iterations,
             Figures& figures) {
    stage.control.iteration_limit = iterations;
    stepper.time_phases(&figures.times);
    const dda::StepAttempt attempt = stepper.advance(stage, state, dt);
    ++figures.steps;
    figures.iterations += attempt.report.iterations;
    figures.factorizations += attempt.report.factorizations;
    figures.substitutions += attempt.report.substitutions;
    if (attempt.rejection == dda::Rejection::none) return;
    dda::PhaseTimes times_of_update(figures.clock);
    stepper.time_phases(&times_of_update);
    const dda::State next = step_without_tolerance(stepper, stage, state, dt);
    figures.update += times_of_update.seconds(Phase::update);
    figures.peak_bytes = peak_bytes();
    // Repeating the same step would reuse its factor. One iteration of the next step replaces the factor.
    stepper.time_phases(nullptr);
    stage.control.iteration_limit = 1;
    stepper.advance(stage, next, dt);
}

Figures measure(const Scene& scene, const Options& options) {
    const int threads = read_number(options.at("--threads"), 1);
    const double dt = read_number(options.at("--step"), 1e-9);
    dda::TimeStepper stepper(scene.model, threads);
    dda::State state = prepared(scene, threads);
    Figures figures{0, 0, 0, 0, threads == 1 ? cpu_time : wall_time};
    const int warm = read_number(options.at("--warm"), 0);
    const int steps = read_number(options.at("--steps"), 1);
    const int iterations = read_number(options.at("--iterations"), 0);
    for (int k = 0; k < warm + steps; ++k) {
        if (iterations > 0) {
            if (k < warm)
                state = step_without_tolerance(stepper, scene.stage, state, dt);
            else
                iterate(stepper, scene.stage, state, dt, iterations, figures);
            continue;
        }
        if (k == warm) stepper.time_phases(&figures.times);
        const bool is_timed = k >= warm;
        // A rejected step is repeated with a third of its size, as in a run; all attempts are timed.
        dda::StepAttempt attempt;
        for (double size = dt;; size /= 3) {
            if (size < dt / 1000) throw std::runtime_error("step " + std::to_string(k) + " is rejected");
            attempt = stepper.advance(scene.stage, state, size);
            if (is_timed) figures.iterations += attempt.report.iterations;
            if (is_timed) figures.factorizations += attempt.report.factorizations;
            if (is_timed) figures.substitutions += attempt.report.substitutions;
            if (attempt.rejection == dda::Rejection::none) break;
        }
        state = std::move(attempt.state);
        if (is_timed) ++figures.steps;
        figures.peak_bytes = peak_bytes();
    }
    return figures;
}

void print(const Scene& scene, const Options& options, const Figures& f) {
    const double blocks = scene.model.block_count();
    const auto per_block = [&](double seconds) { return 1e6 * seconds / (f.steps * blocks); };
    double load = -1;
    if (getloadavg(&load, 1) != 1) load = -1;
    if (!options.count("--no-heading"))
        std::puts(
            "scene,solver,threads,load,blocks,step (s),penalty,steps,iterations,factorisations,"
            "substitutions,detection,transfer,preparation,analysis,assembly,factorisation,solution,judging,"
            "update,total,at four,peak kB/block");
    std::printf("\"%s\",%s,%s,%.2g,%.0f,%s,%s,%d,%.3g,%.3g,%.3g", scene.name.c_str(),
                options.at("--solver").c_str(), options.at("--threads").c_str(), load, blocks,
                options.at("--step").c_str(), options.count("--wall") ? options.at("--penalty").c_str() : "",
                f.steps, f.iterations / f.steps, f.factorizations / f.steps, f.substitutions / f.steps);
    for (std::size_t p = 0; p < static_cast<std::size_t>(Phase::count); ++p)
        std::printf(",%.3g", per_block(f.seconds(static_cast<Phase>(p))));
    std::printf(",%.3g,%.3g,%.3g\n", per_block(f.total()), per_block(f.at_four()),
                1e-3 * f.peak_bytes / blocks);
}

}  // namespace

int main(int argc, char** argv) {
#ifdef __GLIBC__
    // The same settings as dda-run: freed memory stays in the process.
    mallopt(M_MMAP_THRESHOLD, 32 << 20);
    mallopt(M_TRIM_THRESHOLD, 1 << 30);
#endif
    try {
        const Options options = bench::read_options(argc, argv,
                                                    {{"--penalty", "100"},
                                                     {"--step", "0.005"},
                                                     {"--steps", "20"},
                                                     {"--warm", "1"},
                                                     {"--threads", "1"},
                                                     {"--iterations", "0"},
                                                     {"--solver", "multifrontal"}});
        Scene scene = options.count("--wall") ? wall(options) : slope(options);
        if (const std::string& solver = options.at("--solver"); solver == "simplicial")
            scene.model.solver = dda::SolverKind::simplicial;
        else if (solver == "refined")
            scene.model.solver = dda::SolverKind::refined;
        else if (solver != "multifrontal")
            throw std::invalid_argument(solver);
        print(scene, options, measure(scene, options));
    } catch (const std::logic_error&) {
        std::fputs(usage, stderr);
        return 2;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_steps: %s\n", error.what());
        return 1;
    }
    return 0;
}
