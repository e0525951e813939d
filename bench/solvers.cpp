// Times the linear solvers on the first step of running-bond walls: bench_solvers STEP PENALTY
// COLUMNSxROWS...

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <limits>
#include <stdexcept>
#include <vector>

#include "cholmod_solver.hpp"
#include "dda/linear/linear_solver.hpp"
#include "dda/linear/multifrontal_factor.hpp"
#include "options.hpp"
#include "support/step_system.hpp"
#include "support/walls.hpp"

using namespace rockslope;

namespace {

constexpr int repeats = 5;

/// CPU time of this thread, us.
double cpu_time() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

/// Smallest CPU time of several calls, us; other load on the machine can only increase it.
template <class Call>
double min_time(const Call& call) {
    double smallest = std::numeric_limits<double>::infinity();
    for (int k = 0; k < repeats; ++k) {
        const double start = cpu_time();
        call();
        smallest = std::min(smallest, cpu_time() - start);
    }
    return smallest;
}

struct Row {
    double analysis = 0, factor = 0, solution = 0;  ///< us
    double bytes = 0;                               ///< 0 when the solver does not report it
};

void print(const scene::StepSystem& system, const char* solver, const Row& row) {
    const double blocks = system.pattern.size;
    std::printf("%.0f,%s,%.3g,%.3g,%.3g,%.3g\n", blocks, solver, row.analysis / blocks, row.factor / blocks,
                row.solution / blocks, 1e-3 * row.bytes / blocks);
    std::fflush(stdout);
}

Row cholmod(const scene::StepSystem& system) {
    const auto solver = bench::make_cholmod_solver();
    Row row;
    std::vector<dda::Vec6> x;
    const double start = cpu_time();
    solver->analyze(system.pattern);
    row.analysis = cpu_time() - start;
    row.factor = min_time([&] { solver->factorize(system.matrix); });
    row.solution = min_time([&] { solver->solve(x = system.load); });
    return row;
}

template <class Scalar>
Row multifrontal(const scene::StepSystem& system) {
    const ThreadPool one_thread(1);
    dda::MultifrontalFactor<Scalar> factor;
    Row row;
    std::vector<dda::Vec6> x;
    const double start = cpu_time();
    factor.analyze(system.pattern,
                   dda::find_supernodes(system.pattern, dda::fill_reducing_order(system.pattern)));
    row.analysis = cpu_time() - start;
    row.factor = min_time([&] { factor.factorize(system.matrix, one_thread); });
    row.solution = min_time([&] { factor.solve(x = system.load); });
    const dda::SymbolicFactor& plan = factor.symbolic();
    row.bytes =
        static_cast<double>((plan.factor_size + plan.subtree_space + plan.shared_space) * sizeof(Scalar));
    return row;
}

void measure(double step, double penalty, const bench::WallSize& size) {
    const scene::StepSystem system =
        scene::step_system(scene::running_bond_wall(size.columns, size.rows, penalty).model, step);
    print(system, "CHOLMOD", cholmod(system));
    print(system, "multifrontal", multifrontal<double>(system));
    print(system, "multifrontal in single precision", multifrontal<float>(system));
}

}  // namespace

int main(int argc, char** argv) {
    try {
        if (argc < 4) throw std::invalid_argument("walls");
        const double step = bench::read_number(argv[1], 1e-9);
        const double penalty = bench::read_number(argv[2], 1e-9);
        std::vector<bench::WallSize> walls;
        for (int k = 3; k < argc; ++k) walls.push_back(bench::read_wall_size(argv[k]));
        std::puts("blocks,solver,analysis (us/block),factor (us/block),solution (us/block),kB/block");
        for (const bench::WallSize& wall : walls) measure(step, penalty, wall);
    } catch (const std::invalid_argument&) {
        std::fputs("usage: bench_solvers STEP PENALTY/E COLUMNSxROWS...\n", stderr);
        return 2;
    }
    return 0;
}
