// Compares cutting by blockgen, on one thread and on two, and by GEOS, each in a separate process to measure
// its memory. Prints CSV.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

#include "blockgen/cut/cut_blocks.hpp"
#include "blockgen/mesh/block_file.hpp"
#include "heap.hpp"
#include "peer/geos_blocks.hpp"
#include "peer/joint_families.hpp"

using namespace rockslope;

namespace {

using namespace blockgen;
using peer::Family;

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// What takes the time: the phases of cut_blocks(), with sampling before and the block file after.
constexpr std::array phases = {"sampling", "segments", "noding", "faces",  "blocks", "edges",
                               "rings",    "network",  "mesh",   "checks", "file"};

/// Wall time of a phase, and the memory of the process when it is done.
struct PhaseFigures {
    double wall = 0;   ///< s
    double bytes = 0;  ///< resident
};

/// Result that the child process sends to its parent.
struct ChildResult {
    std::size_t blocks = 0;
    double wall = 0;  ///< s
    std::array<PhaseFigures, phases.size()> phase;
};

double resident_bytes() {
    long pages = 0, resident = 0;
    std::FILE* file = std::fopen("/proc/self/statm", "r");
    if (file == nullptr) return 0;
    const int read = std::fscanf(file, "%ld %ld", &pages, &resident);
    std::fclose(file);
    return read == 2 ? static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE)) : 0;
}

/// Samples the joints, cuts, checks and writes the block file. @param result gets all but the time in all.
void cut_and_write(const SlopeModel& model, int threads, const std::string& file, ChildResult& result) {
    Clock::time_point start = Clock::now();
    const auto pass = [&](const char* name) {
        for (std::size_t k = 0; k < phases.size(); ++k)
            if (std::strcmp(phases[k], name) == 0) {
                result.phase[k].wall += seconds_since(start);
                result.phase[k].bytes = resident_bytes();
            }
        start = Clock::now();
    };
    CutOptions options;
    options.max_blocks = 4'000'000;
    options.threads = threads;
    options.full_report = false;
    options.on_phase = pass;
    const std::vector<Trace> traces = peer::traces_across_boundary(model);
    pass("sampling");
    const CutResult cut = cut_blocks(model, traces, options);
    write_block_file(file, cut.mesh, ThreadPool(threads));
    pass("file");
    result.blocks = cut.mesh.block_count();
}

std::size_t polygonize(const SlopeModel& model) {
    return peer::geos_blocks(model.outline, peer::traces_across_boundary(model)).size();
}

/// Time and memory of one run of a route (blockgen or GEOS).
struct Sample {
    std::size_t blocks = 0;
    double wall = 0, cpu = 0;  ///< s
    double bytes = 0;          ///< peak memory
    std::array<PhaseFigures, phases.size()> phase = {};
};

/// A route: blockgen on a number of threads, or GEOS.
struct Route {
    const char* name;
    int threads;
};
constexpr Route geos{"geos", 1};

/// Runs one route in a child process. @return nothing when it failed.
std::optional<Sample> run_once(const Route& route, Family family, double blocks, const std::string& file) {
    int pipe_ends[2];
    if (pipe(pipe_ends) != 0) return std::nullopt;
    const pid_t child = fork();
    if (child == 0) {
        const SlopeModel model = peer::family_slope(family, blocks);
        const Clock::time_point start = Clock::now();
        ChildResult figures;
        if (route.name == geos.name)
            figures.blocks = polygonize(model);
        else
            cut_and_write(model, route.threads, file, figures);
        figures.wall = seconds_since(start);
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
                  static_cast<double>(usage.ru_maxrss) * 1024, figures.phase};
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

void print_row(const Route& route, Family family, double blocks, const std::vector<Sample>& samples) {
    if (samples.empty()) return;
    std::vector<double> wall, cpu, bytes;
    for (const Sample& s : samples) {
        wall.push_back(s.wall);
        cpu.push_back(s.cpu);
        bytes.push_back(s.bytes);
    }
    const auto n = static_cast<double>(samples[0].blocks);
    std::printf("%s,%d,%s,%g,%zu,%zu,%.3f,%.3f,%.2f,%.0f", route.name, route.threads,
                peer::name_of(family).c_str(), blocks, samples[0].blocks, samples.size(), median(wall),
                median(cpu), 1e6 * median(cpu) / n, median(bytes) / n);
    for (std::size_t k = 0; k < phases.size(); ++k) {
        std::vector<double> phase_wall;
        double most = 0;
        for (const Sample& s : samples) {
            phase_wall.push_back(s.phase[k].wall);
            most = std::max(most, s.phase[k].bytes);
        }
        std::printf(",%.3f,%.0f", median(phase_wall), most / n);
    }
    std::puts("");
    std::fflush(stdout);
}

/// Runs all routes alternately, so that they see the same load of the machine. GEOS cuts a million blocks
/// only once, because it takes much longer. @return false when a run failed.
bool measure(Family family, double blocks, double largest_of_geos, int repeats, const std::string& file) {
    constexpr std::array routes = {Route{"blockgen", 1}, Route{"blockgen", 2}, geos};
    std::array<std::vector<Sample>, routes.size()> samples;
    const int peer_repeats = blocks > largest_of_geos ? 0 : blocks >= 1e6 ? 1 : repeats;
    bool good = true;
    for (int k = 0; k < repeats; ++k)
        for (std::size_t r = 0; r < routes.size(); ++r) {
            if (routes[r].name == geos.name && k >= peer_repeats) continue;
            if (const auto sample = run_once(routes[r], family, blocks, file))
                samples[r].push_back(*sample);
            else
                good = false;
        }
    for (std::size_t r = 0; r < routes.size(); ++r) print_row(routes[r], family, blocks, samples[r]);
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
    use_large_pages();
    const double largest = argc > 2 ? std::atof(argv[2]) : 1e6;
    const double largest_of_geos = argc > 3 ? std::atof(argv[3]) : 1e5;
    const int repeats = argc > 4 ? std::max(1, std::atoi(argv[4])) : 5;
    std::fputs("route,threads,joints,asked,blocks,repeats,wall_s,cpu_s,us_per_block,bytes_per_block", stdout);
    for (const char* phase : phases) std::printf(",%s_s,%s_bytes_per_block", phase, phase);
    std::puts("");
    std::fflush(stdout);
    bool good = true;
    for (double blocks = 1e4; blocks <= largest; blocks *= 10)
        for (const Family family : peer::families)
            good = measure(family, blocks, largest_of_geos, repeats, argv[1]) && good;
    std::remove(argv[1]);
    if (!good) std::fputs("bench_cutting: a run failed\n", stderr);
    return good ? 0 : 1;
}
