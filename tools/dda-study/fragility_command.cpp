#include <cstdio>
#include <filesystem>

#include "command_options.hpp"
#include "common/base/atomic_file.hpp"
#include "common/base/input_error.hpp"
#include "study/folder/study_folder.hpp"
#include "study/picture/fragility_picture.hpp"
#include "study/picture/report_page.hpp"
#include "study_commands.hpp"

namespace rockslope {

namespace fs = std::filesystem;
namespace po = boost::program_options;

namespace {

void add_fragility_options(CommandOptions& line) {
    auto add = line.options().add_options();
    add("measure", po::value<std::string>()->value_name("NAME"),
        "column of the demand: a measure of the plan");
    add("limit", po::value<double>()->value_name("X"),
        "a row has failed beyond this demand, or when it collapsed");
    add("intensity", po::value<std::string>()->value_name("NAME"),
        "column of the intensity: PGA, PGV, Arias, Sa(0.5), ...");
    add("method", po::value<std::string>()->default_value("outcomes")->value_name("WORD"),
        "outcomes: which rows failed, by maximum likelihood; demands: regression of the logarithms, "
        "collapsed rows as "
        "lower bounds");
    add("group", po::value<std::vector<std::string>>()->composing()->value_name("NAME"),
        "column whose equal rows belong together in the bootstrap, at most two (default: records and "
        "realisations of "
        "the plan)");
    add("samples", po::value<int>()->default_value(1000)->value_name("N"),
        "bootstrap samples of each grouping");
    add("seed", po::value<int>()->default_value(1)->value_name("N"), "of the bootstrap");
    add("confidence", po::value<double>()->default_value(0.95)->value_name("X"), "of the bands");
    add("output,o", po::value<std::string>()->value_name("FILE.csv"), "write the curve and its band");
    add("picture", po::value<std::string>()->value_name("FILE"),
        "draw them, with the rows; .svg, .png or .pdf");
    add("convergence", po::value<std::string>()->value_name("FILE"),
        "draw the median and its band against the number of groups, of the first grouping; .csv, .svg, .png "
        "or .pdf");
}

study::FragilityRequest request_of(const CommandOptions& line) {
    study::FragilityRequest request;
    request.measure = line.required("measure", "a column of the results");
    request.intensity = line.required("intensity", "a column of the results, such as PGA");
    if (!line.has("limit"))
        throw InputError({line.program()}, "--limit is not given",
                         "the demand beyond which a row has failed");
    request.limit = line.get<double>("limit");
    if (!(request.limit > 0))
        throw InputError({line.program()}, "--limit is not positive", "a positive demand");
    const auto& method = line.get<std::string>("method");
    if (method != "outcomes" && method != "demands")
        throw InputError({line.program()}, "--method is '" + method + "'", "outcomes or demands");
    if (method == "demands") request.method = study::FragilityMethod::demands;
    if (line.has("group")) request.groups = line.get<std::vector<std::string>>("group");
    if (request.groups.size() > 2)
        throw InputError({line.program()}, "there are more than two --group", "at most two");
    request.bootstrap.samples = line.get<int>("samples");
    request.bootstrap.confidence = line.get<double>("confidence");
    request.bootstrap.seed = static_cast<std::uint64_t>(line.get<int>("seed"));
    if (request.bootstrap.samples < 2 || request.bootstrap.samples > 1'000'000)
        throw InputError({line.program()}, "--samples is out of range", "2 to 1000000");
    if (!(request.bootstrap.confidence > 0) || !(request.bootstrap.confidence < 1))
        throw InputError({line.program()}, "--confidence is out of range", "a number between 0 and 1");
    return request;
}

/// The table of results of a study as it is now, or a table that was given.
study::TextTable table_of(const fs::path& place, study::FragilityRequest& request) {
    if (!fs::is_directory(place)) return study::read_csv(place);
    const study::StudyRows rows = study::read_study(place);
    if (request.groups.empty()) request.groups = study::fragility_groups(rows.plan);
    return study::results_table(rows);
}

void check_picture(const CommandOptions& line, const char* option) {
    const auto file = line.path(option);
    if (!file || picture_format(*file) || file->extension() == ".csv") return;
    throw InputError({line.program()}, std::string("--") + option + " is no picture",
                     "a name that ends in .svg, .png or .pdf");
}

void write_convergence(const fs::path& file, const study::Fragility& fragility) {
    const study::TextTable table = study::convergence_table(fragility);
    if (file.extension() == ".csv")
        write_file_atomically(file, study::csv_text(table));
    else
        study::draw_convergence(fragility, table).write(file);
}

}  // namespace

int run_fragility(const std::vector<std::string>& arguments) {
    CommandOptions line(
        "fragility STUDY --measure NAME --limit X --intensity NAME [options]",
        "Fits P(demand > limit | intensity) as a lognormal distribution function, with bands by the "
        "bootstrap over records and\nrealisations. STUDY is the folder of a study, or a table (CSV).");
    add_fragility_options(line);
    if (!line.parse(arguments)) return study_done;
    const fs::path place = line.argument("the study");
    study::FragilityRequest request = request_of(line);
    for (const char* option : {"picture", "convergence"}) check_picture(line, option);
    const study::TextTable table = table_of(place, request);
    const study::Fragility fragility = study::fit_fragility(table, place.string(), request);
    std::fputs(study::fragility_text(fragility).c_str(), stdout);
    if (const auto file = line.path("output"))
        write_file_atomically(*file, study::csv_text(study::fragility_table(fragility)));
    if (const auto file = line.path("picture")) study::draw_fragility(fragility).write(*file);
    if (const auto file = line.path("convergence")) write_convergence(*file, fragility);
    return study_done;
}

int run_sensitivity(const std::vector<std::string>& arguments) {
    CommandOptions line(
        "sensitivity STUDY --measure NAME [options]",
        "Says what a measure depends on, by the design: Sobol' indices (full designs, and \"sobol\" with "
        "indices = true),\nelementary effects (\"morris\"), a tornado (\"one-at-a-time\"). With --spread, of "
        "any "
        "design: how much it varies with\neach factor alone, and from run to run.");
    auto add = line.options().add_options();
    add("measure", po::value<std::string>()->value_name("NAME"), "a measure of the plan");
    add("spread", "the standard deviation of the logarithm over rows that differ in one factor alone");
    add("output,o", po::value<std::string>()->value_name("FILE.csv"), "write the table");
    add("picture", po::value<std::string>()->value_name("FILE"), "draw bars; .svg, .png or .pdf");
    if (!line.parse(arguments)) return study_done;
    const std::string measure = line.required("measure", "a measure of the plan");
    check_picture(line, "picture");
    const study::StudyRows rows = study::read_study(line.argument("the folder of the study"));
    if (line.has("spread")) {
        const std::string text = study::csv_text(study::spread_table(rows, measure));
        std::fputs(text.c_str(), stdout);
        if (const auto file = line.path("output")) write_file_atomically(*file, text);
        return study_done;
    }
    const study::SensitivityStudy result = study::study_sensitivity(rows, measure);
    const std::string text = study::csv_text(result.table);
    std::printf("%s of %s\n%s", result.kind.c_str(), result.measure_heading.c_str(), text.c_str());
    if (result.left_out > 0) std::printf("left out for rows without a value: %zu\n", result.left_out);
    if (const auto file = line.path("output")) write_file_atomically(*file, text);
    if (const auto file = line.path("picture")) study::draw_sensitivity(result).write(*file);
    return study_done;
}

int run_report(const std::vector<std::string>& arguments) {
    CommandOptions line(
        "report STUDY -o FILE.html",
        "Writes a report of a study as one page of HTML: rows, distributions of the measures, spreads, the "
        "fragility curves of the plan,\nand what the measures depend on.");
    line.options().add_options()("output,o", po::value<std::string>()->value_name("FILE.html"), "the page");
    if (!line.parse(arguments)) return study_done;
    const std::string file = line.required("output", "a file name");
    const study::StudyRows rows = study::read_study(line.argument("the folder of the study"));
    write_file_atomically(file,
                          study::report_page(rows, rows.plan.file.stem().string() + ": report of a study"));
    return study_done;
}

}  // namespace rockslope
