#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

#include "options.hpp"
#include "row.hpp"
#include "scenes.hpp"

using namespace rockslope;

namespace {

constexpr const char* usage =
    "bench_scenes --wall COLUMNSxROWS [--step S] [--duration S] | --model RUN.toml --blocks FILE --out "
    "FOLDER\n"
    "    [--threads N] [--repeat N] [--commit NAME] [--no-heading]\n"
    "Runs a scene N times and prints the median run as CSV, one row per stage.\n";

using bench::Options;
using bench::read_number;

/// Smallest allowed step and duration, s.
constexpr double min_time = 1e-9;

bench::Outcome run_once(const Options& options, int threads) {
    if (options.count("--model"))
        return bench::run_model(options.at("--model"), options.at("--blocks"), options.at("--out"), threads);
    const bench::WallSize size = bench::read_wall_size(options.at("--wall"));
    return bench::run_wall(size.columns, size.rows, read_number(options.at("--step"), min_time),
                           read_number(options.at("--duration"), min_time), threads);
}

void measure(const Options& options) {
    const int threads = read_number(options.at("--threads"), 1);
    const bench::Conditions conditions = bench::present_conditions(options.at("--commit"), threads);
    bench::Outcome outcome;
    std::vector<std::vector<bench::StageStatistics>> runs;
    for (int i = read_number(options.at("--repeat"), 1); i > 0; --i) {
        outcome = run_once(options, threads);
        runs.push_back(outcome.stages);
    }
    if (!options.count("--no-heading")) std::fputs(bench::csv_heading().c_str(), stdout);
    for (const bench::StageStatistics& figures : bench::median_run(runs))
        std::fputs(bench::csv_row(outcome.scene, outcome.blocks, figures, conditions).c_str(), stdout);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        measure(bench::read_options(argc, argv,
                                    {{"--step", "0.005"},
                                     {"--duration", "1"},
                                     {"--threads", "1"},
                                     {"--repeat", "1"},
                                     {"--commit", "unnamed"}}));
    } catch (const std::logic_error&) {
        std::fputs(usage, stderr);
        return 2;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_scenes: %s\n", error.what());
        return 1;
    }
    return 0;
}
