#pragma once

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>

namespace fuzz {

/// The command line of a fuzzer, PROGRAM SECONDS [FIRST_SEED] or PROGRAM --seeds FILE, which replays seeds,
/// one a line.
/// @param passes runs one seed and prints what is wrong with it. @returns the exit code.
template <class Passes>
int run_seeds(int argc, char** argv, const Passes& passes) {
    if (argc < 2) {
        std::fprintf(stderr, "%s SECONDS [FIRST_SEED] | --seeds FILE\n", argv[0]);
        return 2;
    }
    bool good = true;
    if (std::strcmp(argv[1], "--seeds") == 0 && argc == 3) {
        std::ifstream file(argv[2]);
        int count = 0;
        for (unsigned long seed = 0; file >> seed; ++count) good = passes(seed) && good;
        std::printf("%d seeds\n", count);
        return good && count > 0 ? 0 : 1;
    }
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(std::atof(argv[1]));
    unsigned long seed = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 1;
    const unsigned long first = seed;
    for (; std::chrono::steady_clock::now() < end; ++seed) good = passes(seed) && good;
    std::printf("%lu files\n", seed - first);
    return good ? 0 : 1;
}

}  // namespace fuzz
