#include <algorithm>
#include <boost/program_options.hpp>
#include <cmath>
#include <cstdio>
#include <exception>
#include <iostream>
#include <optional>

#include "common/base/atomic_file.hpp"
#include "common/base/input_error.hpp"
#include "common/base/output_check.hpp"
#include "common/base/output_error.hpp"
#include "dda/laboratory/read_shear_test.hpp"
#include "dda/laboratory/shear_table.hpp"
#include "shear_picture.hpp"
#include "support/command_page.hpp"
#include "support/parse_arguments.hpp"
#include "support/picture_options.hpp"
#include "support/standard_streams.hpp"

using namespace rockslope;

namespace po = boost::program_options;

namespace {

po::options_description visible_options() {
    po::options_description options("Options");
    auto add = options.add_options();
    add("output,o", po::value<std::string>()->value_name("FILE"), "write the computed rows, CSV");
    add("picture", po::value<std::string>()->value_name("FILE"), "also draw them; .svg, .png or .pdf");
    add("compare", po::value<std::string>()->value_name("LAB.csv"),
        "measured points: draw them too and print the misfit");
    add("joint", po::value<std::string>()->value_name("NAME"),
        "with --compare: the measured joint of that name in the joints.csv of a run");
    add("set", po::value<std::vector<std::string>>()->composing()->value_name("KEY=VALUE"),
        "override a key of the model file; may be repeated");
    tool_support::add_picture_options(options);
    add("template", "print a commented model file and stop");
    add("version", "print the version and stop");
    add("help,h", "print this text and stop");
    return options;
}

tool_support::CommandPage command_page() {
    return {.name = "joint-shear",
            .version = ROCKSLOPE_VERSION,
            .synopsis = "TEST.toml -o ROWS.csv [options]",
            .purpose =
                "Shears one joint along a displacement path, without blocks, to test a joint law or to fit "
                "it to a laboratory test",
            .description = "",
            .options = visible_options()};
}

std::string text_of(const po::variables_map& values, const char* key) {
    return values.count(key) ? values[key].as<std::string>() : std::string{};
}

void print_misfit(const char* name, const std::optional<dda::Misfit>& misfit, double factor,
                  const char* unit) {
    if (!misfit) return;
    std::printf("misfit of %s: rms %.4g %s, largest %.4g %s at %.4g mm\n", name,
                misfit->root_mean_square * factor, unit, misfit->largest * factor, unit, misfit->at * 1e3);
}

void print_summary(const dda::ShearTestInput& input, const std::vector<dda::ShearTestRow>& rows) {
    const auto by_stress = [](const dda::ShearTestRow& a, const dda::ShearTestRow& b) {
        return std::abs(a.shear_stress) < std::abs(b.shear_stress);
    };
    const dda::ShearTestRow& peak = *std::max_element(rows.begin(), rows.end(), by_stress);
    std::printf(
        "%s: %zu rows; largest shear stress %.5g MPa at %.4g mm; at the end %.5g MPa, dilation %.4g mm\n",
        input.material.c_str(), rows.size(), std::abs(peak.shear_stress) / 1e6, peak.displacement * 1e3,
        rows.back().shear_stress / 1e6, rows.back().dilation * 1e3);
    std::printf("work at the end %.6g J/m2; energy created %.3g J/m2\n", rows.back().work,
                dda::created_energy(rows));
}

/// The points of a picture; nothing without --compare.
std::optional<ComparedPoints> compared_points(const po::variables_map& values,
                                              const std::optional<dda::ShearTable>& table) {
    if (!table) return std::nullopt;
    return ComparedPoints{*table, values.count("joint") ? "blocks" : "measured"};
}

int run(const po::variables_map& values) {
    const std::string file =
        tool_support::model_file_of("joint-shear", values, "joint-shear TEST.toml -o ROWS.csv [options]");
    const std::string output = text_of(values, "output"), picture = text_of(values, "picture");
    const std::string measured_file = text_of(values, "compare");
    if (output.empty()) throw InputError({"joint-shear"}, "--output is missing", "--output ROWS.csv");
    if (!picture.empty() && !picture_format(picture))
        throw InputError({"joint-shear"}, "--picture is '" + picture + "'",
                         "a name that ends in .svg, .png or .pdf");
    if (values.count("joint") && !values.count("compare"))
        throw InputError({"joint-shear"}, "--joint is given without --compare", "--compare joints.csv");
    const PageStyle style = tool_support::picture_style(values, "joint-shear");
    const dda::ShearTestInput input =
        dda::read_shear_test(file, values.count("set") ? values["set"].as<std::vector<std::string>>()
                                                       : std::vector<std::string>{});
    std::vector<std::filesystem::path> read = input.files;
    std::optional<dda::ShearTable> measured;
    if (values.count("compare")) {
        measured = values.count("joint") ? dda::read_measured_joint(measured_file, text_of(values, "joint"))
                                         : dda::read_shear_table(measured_file);
        read.emplace_back(measured_file);
        if (input.test.boundary == dda::NormalBoundary::prescribed_stress && measured->normal_stress.empty())
            throw InputError({measured_file}, "has no column 'normal stress', but 'boundary' prescribes it",
                             "the normal stress at each measured point");
    }
    for (const std::string& result : {output, picture})
        if (!result.empty()) check_output(result, read);
    check_distinct({output, picture});

    const std::vector<dda::ShearTestRow> rows = dda::run_shear_test(input.test);
    write_file_atomically(output, dda::shear_rows_csv(rows));
    print_summary(input, rows);
    if (measured) {
        const dda::Comparison comparison = dda::compare(input.test, *measured);
        print_misfit("shear stress", comparison.shear_stress, 1e-6, "MPa");
        print_misfit("dilation", comparison.dilation, 1e3, "mm");
        print_misfit("normal stress", comparison.normal_stress, 1e-6, "MPa");
    }
    if (!picture.empty())
        draw_shear_test(input, rows, compared_points(values, measured), style).write(picture);
    return 0;
}

/// Does what the arguments ask for; prints why it failed. @return the exit code.
int act_on_arguments(int argc, char** argv) {
    try {
        const tool_support::CommandPage page = command_page();
        const std::vector<std::string> arguments = tool_support::arguments_of(argc, argv);
        if (const auto code = tool_support::print_requested_text(page, arguments)) return *code;
        const po::variables_map values = tool_support::parse_arguments(page.name, arguments, page.options);
        if (values.count("template")) {
            std::cout << dda::shear_test_template();
            return 0;
        }
        return run(values);
    } catch (const InputError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    } catch (const OutputError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}

}  // namespace

int main(int argc, char** argv) {
    return tool_support::run_program("joint-shear", [&] { return act_on_arguments(argc, argv); });
}
