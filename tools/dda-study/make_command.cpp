#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "command_options.hpp"
#include "common/base/command_text.hpp"
#include "common/base/output_check.hpp"
#include "study/folder/study_folder.hpp"
#include "study_commands.hpp"

namespace rockslope {

namespace fs = std::filesystem;
namespace po = boost::program_options;

namespace {

/// The folder of this program, where the others are too.
fs::path program_folder() {
    return fs::read_symlink("/proc/self/exe").parent_path();
}

/// The number of different addresses among the rows.
std::size_t different_rows(const study::PlannedStudy& planned) {
    std::vector<std::string> addresses;
    for (const study::PlannedRow& row : planned.rows) addresses.push_back(row.address);
    std::sort(addresses.begin(), addresses.end());
    return static_cast<std::size_t>(std::unique(addresses.begin(), addresses.end()) - addresses.begin());
}

/// "1 row", "2 rows".
std::string counted(std::size_t count, const std::string& what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

}  // namespace

int run_make(const std::vector<std::string>& arguments) {
    CommandOptions line(
        "make PLAN.toml -o STUDY [options]",
        "Writes the folder of a study: a table of its rows and a Makefile that computes them. Nothing is "
        "computed yet;\nresults that are there stay, and those of rows that have not changed are not "
        "computed again.");
    line.options().add_options()("output,o", po::value<std::string>()->value_name("STUDY"),
                                 "folder of the study");
    if (!line.parse(arguments)) return study_done;
    const fs::path plan_file = line.argument("the plan");
    const fs::path folder =
        fs::absolute(line.required("output", "the folder of the study")).lexically_normal();
    const study::Plan plan = study::read_plan(plan_file);
    check_output_folder(folder);
    make_output_folder(folder);
    const fs::path place = fs::canonical(folder);
    const study::PlannedStudy planned = study::plan_study(plan, place);
    study::write_study_folder(planned, place, {program_folder()});
    const std::string shown = line.required("output", "");
    std::printf("%s: %s", shown.c_str(), counted(planned.rows.size(), "row").c_str());
    if (const std::size_t different = different_rows(planned); different < planned.rows.size())
        std::printf(", %zu of them different", different);
    if (!plan.slope.empty()) std::printf(", of %s", counted(planned.cuts.size(), "cut").c_str());
    if (planned.branch_stages > 0)
        std::printf(", from %s at the end of stage '%s'", counted(planned.starts.size(), "state").c_str(),
                    planned.last_start_stage.c_str());
    std::printf("; make -C %s -j computes them\n", shell_quoted(shown).c_str());
    return study_done;
}

}  // namespace rockslope
