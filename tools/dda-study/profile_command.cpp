#include <cstdio>
#include <filesystem>

#include "command_options.hpp"
#include "common/base/atomic_file.hpp"
#include "common/base/input_error.hpp"
#include "study/table/deposit.hpp"
#include "study_commands.hpp"

namespace rockslope {

namespace po = boost::program_options;

namespace {

double positive(const CommandOptions& line, const char* name, const std::string& expected) {
    if (!line.has(name))
        throw InputError({line.program()}, std::string("--") + name + " is not given", expected);
    const auto value = line.get<double>(name);
    if (!(value > 0) || value > 1e9)
        throw InputError({line.program()}, std::string("--") + name + " is no positive length", expected);
    return value;
}

}  // namespace

int run_profile(const std::vector<std::string>& arguments) {
    CommandOptions line("profile RESULTS --interval M --limit M [options]",
                        "Prints the surface of a slope at the end of a run, over that at the start, and the "
                        "thickness of the rock "
                        "that moved, at\nstations of x. RESULTS is the folder of any run of dda-run, such as "
                        "STUDY/runs/000001.");
    auto add = line.options().add_options();
    add("interval", po::value<double>()->value_name("M"),
        "between stations, m: they are its whole multiples");
    add("limit", po::value<double>()->value_name("M"), "of the displacement of the rock that moved, m");
    add("output,o", po::value<std::string>()->value_name("FILE.csv"), "write the table, and print nothing");
    if (!line.parse(arguments)) return study_done;
    const std::filesystem::path results = line.argument("the folder of a run");
    const double interval = positive(line, "interval", "the distance of the stations, m");
    const double limit = positive(line, "limit", "the displacement beyond which rock has moved, m");
    const std::string text =
        study::csv_text(study::Deposit(study::read_outlines(results)).profile(interval, limit));
    if (const auto file = line.path("output"))
        write_file_atomically(*file, text);
    else
        std::fputs(text.c_str(), stdout);
    return study_done;
}

}  // namespace rockslope
