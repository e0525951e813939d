// Cutting beside GEOS, each in a process of its own so that its memory can be told: rows of CSV.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "blockgen/cut_blocks.hpp"
#include "blockgen/mesh/block_file.hpp"
#include "peer/geos_blocks.hpp"
#include "peer/joint_families.hpp"

namespace {

using namespace blockgen;
using peer::Family;

struct Figures {
    std::size_t blocks = 0;
    double wall = 0;
};

/// Sampling, cutting, proof, and the block file.
std::size_t cut_and_write(const SlopeModel& model, const std::string& file) {
    CutOptions options;
    options.max_blocks = 4'000'000;
    const CutResult result = cut_blocks(model, peer::traces_across_rim(model), options);
    write_block_file(file, result.mesh);
    return result.mesh.block_count();
}

std::size_t polygonize(const SlopeModel& model) {
    return peer::geos_blocks(model.outline, peer::traces_across_rim(model)).size();
}

/// Runs one route in a child; prints a row. @return false when the child failed.
bool measure(const std::string& route, Family family, double blocks, const std::string& file) {
    int pipe_ends[2];
    if (pipe(pipe_ends) != 0) return false;
    const pid_t child = fork();
    if (child == 0) {
        const SlopeModel model = peer::family_slope(family, blocks);
        const auto start = std::chrono::steady_clock::now();
        Figures figures;
        figures.blocks = route == "blockgen" ? cut_and_write(model, file) : polygonize(model);
        figures.wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        _exit(write(pipe_ends[1], &figures, sizeof figures) == sizeof figures ? 0 : 1);
    }
    close(pipe_ends[1]);
    Figures figures;
    const bool complete = read(pipe_ends[0], &figures, sizeof figures) == sizeof figures;
    close(pipe_ends[0]);
    int status = 0;
    rusage usage{};
    wait4(child, &status, 0, &usage);
    if (!complete || status != 0) {
        std::printf("%s,%s,%g,failed,,,,\n", route.c_str(), peer::name_of(family).c_str(), blocks);
        return false;
    }
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    const double cpu = seconds(usage.ru_utime) + seconds(usage.ru_stime);
    const auto n = static_cast<double>(figures.blocks);
    std::printf("%s,%s,%g,%zu,%.3f,%.3f,%.2f,%.0f\n", route.c_str(), peer::name_of(family).c_str(), blocks,
                figures.blocks, figures.wall, cpu, 1e6 * cpu / n,
                static_cast<double>(usage.ru_maxrss) * 1024 / n);
    std::fflush(stdout);
    return true;
}

}  // namespace

/// bench_cutting FILE [LARGEST [LARGEST_OF_GEOS]]: 1e4 blocks and ten times as many each time.
int main(int argc, char** argv) {
    if (argc < 2) {
        std::fputs("bench_cutting SCRATCH.blocks [LARGEST [LARGEST_OF_GEOS]]\n", stderr);
        return 2;
    }
    const double largest = argc > 2 ? std::atof(argv[2]) : 1e6;
    const double largest_of_geos = argc > 3 ? std::atof(argv[3]) : 1e5;
    std::puts("route,joints,asked,blocks,wall_s,cpu_s,us_per_block,bytes_per_block");
    std::fflush(stdout);
    bool good = true;
    for (double blocks = 1e4; blocks <= largest; blocks *= 10)
        for (const Family family : peer::families) {
            good = measure("blockgen", family, blocks, argv[1]) && good;
            if (blocks <= largest_of_geos) good = measure("geos", family, blocks, argv[1]) && good;
        }
    std::remove(argv[1]);
    return good ? 0 : 1;
}
