// Compares cutting by blockgen and by GEOS, each in a separate process to measure its memory. Prints CSV.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "blockgen/cut/cut_blocks.hpp"
#include "blockgen/mesh/block_file.hpp"
#include "peer/geos_blocks.hpp"
#include "peer/joint_families.hpp"

using namespace rockslope;

namespace {

using namespace blockgen;
using peer::Family;

/// Result that the child process sends to its parent.
struct ChildResult {
    std::size_t blocks = 0;
    double wall = 0;  ///< s
};

/// Samples the joints, cuts, checks and writes the block file. @return the number of blocks.
std::size_t cut_and_write(const SlopeModel& model, const std::string& file) {
    CutOptions options;
    options.max_blocks = 4'000'000;
    const CutResult result = cut_blocks(model, peer::traces_across_boundary(model), options);
    write_block_file(file, result.mesh);
    return result.mesh.block_count();
}

std::size_t polygonize(const SlopeModel& model) {
    return peer::geos_blocks(model.outline, peer::traces_across_boundary(model)).size();
}

/// Time and memory of one run of a route (blockgen or GEOS).
struct Sample {
    std::size_t blocks = 0;
    double wall = 0, cpu = 0;  ///< s
    double bytes = 0;          ///< peak memory
};

/// Runs one route in a child process. @return nothing when it failed.
std::optional<Sample> run_once(const std::string& route, Family family, double blocks,
                               const std::string& file) {
    int pipe_ends[2];
    if (pipe(pipe_ends) != 0) return std::nullopt;
    const pid_t child = fork();
    if (child == 0) {
        const SlopeModel model = peer::family_slope(family, blocks);
        const auto start = std::chrono::steady_clock::now();
        ChildResult figures;
        figures.blocks = route == "blockgen" ? cut_and_write(model, file) : polygonize(model);
        figures.wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        _exit(write(pipe_ends[1], &figures, sizeof figures) == sizeof figures ? 0 : 1);
    }
    close(pipe_ends[1]);
    ChildResult figures;
    const bool complete = read(pipe_ends[0], &figures, sizeof figures) == sizeof figures;
    close(pipe_ends[0]);
    int status = 0;
    rusage usage{};
    wait4(child, &status, 0, &usage);
    if (!complete || status != 0) return std::nullopt;
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    return Sample{figures.blocks, figures.wall, seconds(usage.ru_utime) + seconds(usage.ru_stime),
                  static_cast<double>(usage.ru_maxrss) * 1024};
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

void print_row(const std::string& route, Family family, double blocks, const std::vector<Sample>& samples) {
    std::vector<double> wall, cpu, bytes;
    for (const Sample& s : samples) {
        wall.push_back(s.wall);
        cpu.push_back(s.cpu);
        bytes.push_back(s.bytes);
    }
    const auto n = static_cast<double>(samples[0].blocks);
    std::printf("%s,%s,%g,%zu,%zu,%.3f,%.3f,%.2f,%.0f\n", route.c_str(), peer::name_of(family).c_str(),
                blocks, samples[0].blocks, samples.size(), median(wall), median(cpu), 1e6 * median(cpu) / n,
                median(bytes) / n);
    std::fflush(stdout);
}

/// Runs both routes alternately, so that both see the same load of the machine. GEOS cuts a million blocks
/// only once, because it takes much longer. @return false when a run failed.
bool measure(Family family, double blocks, double largest_of_geos, int repeats, const std::string& file) {
    std::vector<Sample> ours, peers;
    const int peer_repeats = blocks > largest_of_geos ? 0 : blocks >= 1e6 ? 1 : repeats;
    bool good = true;
    for (int k = 0; k < repeats; ++k) {
        if (const auto sample = run_once("blockgen", family, blocks, file))
            ours.push_back(*sample);
        else
            good = false;
        if (k >= peer_repeats) continue;
        if (const auto sample = run_once("geos", family, blocks, file))
            peers.push_back(*sample);
        else
            good = false;
    }
    if (!ours.empty()) print_row("blockgen", family, blocks, ours);
    if (!peers.empty()) print_row("geos", family, blocks, peers);
    return good;
}

}  // namespace

/// bench_cutting FILE [LARGEST [LARGEST_OF_GEOS [REPEATS]]]: cuts 1e4, 1e5, ... blocks and prints the medians
/// of the repeats.
int main(int argc, char** argv) {
    if (argc < 2) {
        std::fputs("bench_cutting SCRATCH.blocks [LARGEST [LARGEST_OF_GEOS [REPEATS]]]\n", stderr);
        return 2;
    }
    const double largest = argc > 2 ? std::atof(argv[2]) : 1e6;
    const double largest_of_geos = argc > 3 ? std::atof(argv[3]) : 1e5;
    const int repeats = argc > 4 ? std::max(1, std::atoi(argv[4])) : 5;
    std::puts("route,joints,asked,blocks,repeats,wall_s,cpu_s,us_per_block,bytes_per_block");
    std::fflush(stdout);
    bool good = true;
    for (double blocks = 1e4; blocks <= largest; blocks *= 10)
        for (const Family family : peer::families)
            good = measure(family, blocks, largest_of_geos, repeats, argv[1]) && good;
    std::remove(argv[1]);
    if (!good) std::fputs("bench_cutting: a run failed\n", stderr);
    return good ? 0 : 1;
}
