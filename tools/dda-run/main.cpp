#include <cstdio>
#include <exception>
#include <limits>

#include "command_line.hpp"
#include "common/base/input_error.hpp"
#include "dda/input/read_run.hpp"
#include "simulate.hpp"
#ifdef __GLIBC__  // known once a header of the library has been read
#include <malloc.h>
#endif

using namespace rockslope;

namespace {

ExitCode print(const std::string& text) {
    if (std::fputs(text.c_str(), stdout) >= 0 && std::fflush(stdout) == 0) return done;
    std::fputs("dda-run: the standard output cannot be written\n", stderr);
    return analysis_failed;
}

ExitCode act(const CommandLine& line) {
    switch (line.action) {
        case CommandLine::Action::print_help:
            return print(help_text());
        case CommandLine::Action::print_version:
            return print("dda-run " ROCKSLOPE_VERSION "\n");
        case CommandLine::Action::print_template:
            return print(dda::run_template());
        case CommandLine::Action::print_config:
            return print(
                dda::read_run(line.run_file, {line.overrides, line.blocks, std::filesystem::current_path()})
                    .effective);
        default:
            return simulate(line, ROCKSLOPE_VERSION);
    }
}

/// A step's vectors come and go, megabytes of them. Memory that goes back to the system each time is cleared
/// page by page when it comes again, a tenth of a run's time. What is larger than a run of some ten thousand
/// blocks asks for goes back all the same: kept, it leaves gaps that nothing fits into, a fifth of the memory
/// of a hundred thousand blocks.
void disable_heap_trimming() {
#ifdef __GLIBC__
    mallopt(M_MMAP_THRESHOLD, 32 << 20);
    mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
#endif
}

}  // namespace

int main(int argc, char** argv) {
    try {
        disable_heap_trimming();
        return act(parse_command_line(argc, argv));
    } catch (const InputError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return bad_input;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return analysis_failed;
    }
}
