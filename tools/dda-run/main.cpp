#include <cstdio>
#include <exception>
#include <filesystem>
#include <limits>
#include <optional>

#include "command_line.hpp"
#include "common/base/input_error.hpp"
#include "common/base/output_check.hpp"
#include "dda/input/read_run.hpp"
#include "folder_lock.hpp"
#include "run_log.hpp"
#include "simulate.hpp"
#include "support/parse_arguments.hpp"
#include "support/standard_streams.hpp"
#ifdef __GLIBC__  // defined by any header of the C library
#include <malloc.h>
#endif

using namespace rockslope;

namespace {

ExitCode print(const std::string& text) {
    if (std::fputs(text.c_str(), stdout) >= 0 && std::fflush(stdout) == 0) return done;
    std::fputs("dda-run: the standard output cannot be written\n", stderr);
    return analysis_failed;
}

/// Does something; prints why it failed. @return the exit code.
template <class Action>
ExitCode reported(const Action& action) {
    try {
        return action();
    } catch (const InputError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return bad_input;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return analysis_failed;
    }
}

/// Simulates while no other run writes into the folder.
ExitCode simulate_alone(const CommandLine& line) {
    std::optional<FolderLock> lock;
    check_output_folder(line.output);
    if (line.log_title) make_output_folder(line.output);
    if (std::filesystem::is_directory(line.output)) lock.emplace(line.output);
    if (!line.log_title) return simulate(line, ROCKSLOPE_VERSION, lock);
    const RunLog log(line.output, *line.log_title);
    const ExitCode code = reported([&] { return simulate(line, ROCKSLOPE_VERSION, lock); });
    log.finish(code);
    return code;
}

ExitCode act(const CommandLine& line) {
    switch (line.action) {
        case CommandLine::Action::print_template:
            return print(dda::run_template());
        case CommandLine::Action::print_config:
            return print(
                dda::read_run(line.run_file, {line.overrides, line.blocks, std::filesystem::current_path()})
                    .effective);
        default:
            return simulate_alone(line);
    }
}

/// Keeps freed memory in the process. Each step allocates and frees megabytes of vectors; memory returned to
/// the system is cleared page by page when it is allocated again, which takes a tenth of the run time.
/// Allocations above 32 MiB, more than a run of ten thousand blocks makes, are still returned: kept, they
/// would fragment the heap, by a fifth of the memory for a hundred thousand blocks.
void disable_heap_trimming() {
#ifdef __GLIBC__
    mallopt(M_MMAP_THRESHOLD, 32 << 20);
    mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
#endif
}

ExitCode act_on_arguments(int argc, char** argv) {
    if (const auto code = tool_support::print_requested_text(command_page(ROCKSLOPE_VERSION),
                                                             tool_support::arguments_of(argc, argv)))
        return static_cast<ExitCode>(*code);
    const CommandLine line = parse_command_line(argc, argv);
    return act(line);
}

}  // namespace

int main(int argc, char** argv) {
    return tool_support::run_program("dda-run", [&]() -> int {
        return reported([&] {
            disable_heap_trimming();
            return act_on_arguments(argc, argv);
        });
    });
}
