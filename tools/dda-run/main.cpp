#include <cstdio>
#include <exception>

#include "blockgen/base/input_error.hpp"
#include "command_line.hpp"
#include "dda/io/read_run.hpp"
#include "simulate.hpp"

namespace {

ExitCode act(const CommandLine& line) {
    switch (line.action) {
        case CommandLine::Action::print_help:
            std::fputs(help_text().c_str(), stdout);
            return done;
        case CommandLine::Action::print_version:
            std::puts("dda-run " ROCKSLOPE_VERSION);
            return done;
        case CommandLine::Action::print_template:
            std::fputs(dda::run_template().c_str(), stdout);
            return done;
        case CommandLine::Action::print_config:
            std::fputs(
                dda::read_run(line.run_file, {line.overrides, line.blocks, std::filesystem::current_path()})
                    .effective.c_str(),
                stdout);
            return done;
        default:
            return simulate(line, ROCKSLOPE_VERSION);
    }
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return act(parse_command_line(argc, argv));
    } catch (const blockgen::InputError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return bad_input;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return analysis_failed;
    }
}
