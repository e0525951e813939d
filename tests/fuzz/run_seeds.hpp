#pragma once

#include <csignal>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <fstream>

namespace rockslope::fuzz {

/// Number of inputs rejected by InputError.
inline unsigned long refused = 0;
/// Set by a signal. The run then ends and still prints its summary.
inline volatile std::sig_atomic_t is_stopped = 0;

/// The main function of a fuzzer: PROGRAM SECONDS [FIRST_SEED [STEP]] runs until the CPU time is used up,
/// PROGRAM --seeds FILE replays seeds, one per line. A step equal to the number of kinds of input stays with
/// one kind.
/// @param passes runs one seed and prints what is wrong with it. @return the exit code.
template <class Passes>
int run_seeds(int argc, char** argv, const Passes& passes) {
    if (argc < 2) {
        std::fprintf(stderr, "%s SECONDS [FIRST_SEED [STEP]] | --seeds FILE\n", argv[0]);
        return 2;
    }
    bool good = true;
    if (std::strcmp(argv[1], "--seeds") == 0 && argc == 3) {
        std::ifstream file(argv[2]);
        int count = 0;
        for (unsigned long seed = 0; file >> seed; ++count) good = passes(seed) && good;
        std::printf("%d seeds, %lu of them refused\n", count, refused);
        return good && count > 0 ? 0 : 1;
    }
    const double end = std::atof(argv[1]) * CLOCKS_PER_SEC;
    for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, [](int) { is_stopped = 1; });
    unsigned long seed = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 1;
    const unsigned long step = argc > 3 ? std::strtoul(argv[3], nullptr, 10) : 1;
    unsigned long count = 0;
    for (; !is_stopped && static_cast<double>(std::clock()) < end; seed += step, ++count)
        good = passes(seed) && good;
    std::printf("%lu inputs, %lu of them refused, %.0f s\n", count, refused,
                static_cast<double>(std::clock()) / CLOCKS_PER_SEC);
    return good ? 0 : 1;
}

}  // namespace rockslope::fuzz
