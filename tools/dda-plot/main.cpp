#include <boost/program_options.hpp>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <exception>
#include <iostream>
#include <optional>

#include "common/base/input_error.hpp"
#include "common/base/output_check.hpp"
#include "common/base/output_error.hpp"
#include "common/base/text.hpp"
#include "frame_picture.hpp"
#include "history_table.hpp"
#include "joint_pictures.hpp"
#include "support/command_page.hpp"
#include "support/parse_arguments.hpp"

using namespace rockslope;

namespace po = boost::program_options;
namespace fs = std::filesystem;

namespace {

po::options_description visible_options() {
    po::options_description options("Options");
    auto add = options.add_options();
    add("frames", po::value<std::string>()->value_name("LIST"),
        "frames to draw, separated by commas: numbers from 0, first, middle, last, or all (default: "
        "first,middle,last)");
    add("largest", po::value<double>()->value_name("METRES"),
        "displacement at which the colours end (default: a round length that covers 99 % of the free "
        "blocks' area in every frame drawn)");
    add("history", "draw the history only, or with --frames too");
    add("roughness",
        "draw only the frames with joints coloured by their mobilised roughness (without options they are "
        "drawn if there is any)");
    add("joint", po::value<std::string>()->value_name("NAME"),
        "draw only the histories of this measured joint, for all given folders in one picture");
    add("reference", po::value<std::vector<std::string>>()->composing()->value_name("FILE"),
        "with --joint: a table of time (s) and displacement (m), drawn dashed; may be repeated");
    add("worst-contact",
        "draw only the contact at which the run failed to converge, which summary.json names, and its "
        "surroundings (without options it is drawn if there is one)");
    add("format", po::value<std::string>()->default_value("png")->value_name("EXT"), "png, svg or pdf");
    add("output,o", po::value<std::string>()->value_name("FOLDER"),
        "folder of the pictures (default: the result folder)");
    add("version", "print the version and stop");
    add("help,h", "print this text and stop");
    return options;
}

tool_support::CommandPage command_page() {
    return {.name = "dda-plot",
            .version = ROCKSLOPE_VERSION,
            .synopsis = "OUT [options]",
            .purpose =
                "Draws the results of dda-run: blocks coloured by displacement, and the histories of the "
                "measured points",
            .description = "",
            .options = visible_options()};
}

std::int64_t frame_number(const std::string& word, std::int64_t count) {
    if (word == "first") return 0;
    if (word == "middle") return count / 2;
    if (word == "last") return count - 1;
    std::int64_t number = -1;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc{} || end != word.data() + word.size() || number < 0 || number >= count)
        throw InputError({"dda-plot"}, "there is no frame '" + word + "'",
                         "a number from 0 to " + std::to_string(count - 1) + ", first, middle, last or all");
    return number;
}

std::vector<std::int64_t> frame_numbers(const std::string& list, std::int64_t count) {
    std::vector<std::int64_t> numbers;
    if (list == "all")
        for (std::int64_t k = 0; k < count; ++k) numbers.push_back(k);
    for (std::size_t start = 0; list != "all" && start <= list.size();) {
        const std::size_t end = std::min(list.find(',', start), list.size());
        numbers.push_back(frame_number(list.substr(start, end - start), count));
        start = end + 1;
    }
    return numbers;
}

std::vector<std::int64_t> chosen_frames(const RunFrames& run, const std::string& list) {
    const auto count = static_cast<std::int64_t>(run.times().size());
    if (count == 0)
        throw InputError({run.name() + ".vtkhdf"}, "contains no frames yet", "a run that has begun");
    return frame_numbers(list, count);
}

void draw_frames(const RunFrames& run, const std::vector<std::int64_t>& numbers, const fs::path& output,
                 const std::string& extension, std::optional<double> largest) {
    const PictureScale scale = common_scale(run, numbers, largest);
    for (const std::int64_t number : numbers) {
        char suffix[32];
        std::snprintf(suffix, sizeof suffix, ".frame-%04lld.", static_cast<long long>(number));
        draw_frame(run, number, scale).write(output / (run.name() + suffix + extension));
    }
}

/// The worst contact to draw. @param requested by --worst-contact: a missing contact is an error. @param all
/// no options are given: the contact is drawn if the summary names one.
std::optional<dda::WorstContact> worst_contact_to_draw(const fs::path& folder, bool requested, bool all) {
    const fs::path summary = folder / "summary.json";
    if (!requested && !(all && fs::exists(summary))) return std::nullopt;
    std::optional<dda::WorstContact> worst = dda::read_worst_contact(summary);
    if (requested && !worst)
        throw InputError({summary.string()}, "names no worst contact", "a run that did not converge");
    return worst;
}

/// Two views of the last frame: the whole section and the surroundings of the worst contact.
struct WorstContactViews {
    dda::WorstContact contact;
    std::int64_t frame;
    PictureScale whole, near;

    WorstContactViews(const RunFrames& run, dda::WorstContact worst, std::optional<double> largest)
        : contact(std::move(worst)),
          frame(chosen_frames(run, "last").front()),
          whole(common_scale(run, {frame}, largest)),
          near(scale_around_contact(contact, run, frame, whole)) {}

    void draw(const RunFrames& run, const fs::path& output, const std::string& extension) const {
        const std::string stem = run.name() + ".worst-contact";
        draw_frame(run, frame, whole, contact).write(output / (stem + "." + extension));
        draw_frame(run, frame, near, contact).write(output / (stem + "-near." + extension));
    }
};

std::optional<double> largest_of(const po::variables_map& values) {
    if (!values.count("largest")) return std::nullopt;
    const double largest = values["largest"].as<double>();
    if (!(largest > 0) || !std::isfinite(largest))
        throw InputError({"dda-plot"}, "--largest is " + shortest_text(largest),
                         "a positive length in metres");
    return largest;
}

void draw_roughness_frames(const RunFrames& run, const std::vector<std::int64_t>& numbers,
                           const fs::path& output, const std::string& extension) {
    const PictureScale scale = common_scale(run, numbers);
    for (const std::int64_t number : numbers) {
        char suffix[40];
        std::snprintf(suffix, sizeof suffix, ".roughness-%04lld.", static_cast<long long>(number));
        draw_roughness(run, number, scale).write(output / (run.name() + suffix + extension));
    }
}

/// A joint's name with characters that are safe in a file name.
std::string file_safe_name(std::string name) {
    for (char& c : name)
        if (c == '/' || c == ' ') c = '-';
    return name;
}

void write_joint(const JointPicture& picture, const fs::path& output, const std::string& extension) {
    picture.canvas.write(output / ("joint-" + file_safe_name(picture.joint) + "." + extension));
}

std::vector<std::string> texts_of(const po::variables_map& values, const char* key) {
    return values.count(key) ? values[key].as<std::vector<std::string>>() : std::vector<std::string>{};
}

std::vector<fs::path> paths_of(const std::vector<std::string>& texts) {
    return {texts.begin(), texts.end()};
}

int plot(const po::variables_map& values) {
    const std::vector<std::string> folders = texts_of(values, "file");
    const bool joint_only = values.count("joint");
    if (values.count("reference") && !joint_only)
        throw InputError({"dda-plot"}, "--reference is given without --joint", "--joint NAME");
    if (joint_only ? folders.empty() : folders.size() != 1)
        throw InputError({"dda-plot"}, std::to_string(folders.size()) + " folders are given",
                         "one: dda-plot OUT [options]");
    const fs::path folder = folders.front();
    const fs::path output = values.count("output") ? fs::path(values["output"].as<std::string>()) : folder;
    const std::string extension = values["format"].as<std::string>();
    if (!picture_format("x." + extension))
        throw InputError({"dda-plot"}, "--format is '" + extension + "'", "png, svg or pdf");
    if (output.empty()) throw InputError({"dda-plot"}, "--output is empty", "a folder");
    check_output_folder(output);
    const bool worst_only = values.count("worst-contact");
    const bool roughness_only = values.count("roughness");
    const bool all = !values.count("frames") && !values.count("history") && !worst_only && !roughness_only;
    if (joint_only) {
        const JointPicture picture = picture_of_joint(values["joint"].as<std::string>(), paths_of(folders),
                                                      paths_of(texts_of(values, "reference")));
        make_output_folder(output);
        write_joint(picture, output, extension);
        return 0;
    }
    const RunFrames run(folder);
    // All input is read before the first picture is written.
    std::optional<HistoryTable> history;
    if (all || values.count("history")) history = read_history(folder / "history.csv");
    std::vector<std::int64_t> frames;
    if (all || roughness_only || values.count("frames"))
        frames = chosen_frames(
            run, values.count("frames") ? values["frames"].as<std::string>() : "first,middle,last");
    const std::optional<double> largest = largest_of(values);
    std::optional<WorstContactViews> worst;
    if (const auto contact = worst_contact_to_draw(folder, worst_only, all))
        worst.emplace(run, *contact, largest);
    const std::vector<JointPicture> joints = all ? pictures_of_joints(folder) : std::vector<JointPicture>{};
    const bool roughness = roughness_only || (all && has_roughness(run, frames.back()));
    make_output_folder(output);
    if (!frames.empty() && !roughness_only) draw_frames(run, frames, output, extension, largest);
    if (roughness) draw_roughness_frames(run, frames, output, extension);
    for (const JointPicture& joint : joints) write_joint(joint, output, extension);
    if (worst) worst->draw(run, output, extension);
    if (history) draw_history(*history).write(output / (run.name() + ".history." + extension));
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const tool_support::CommandPage page = command_page();
        const std::vector<std::string> arguments = tool_support::arguments_of(argc, argv);
        if (const auto code = tool_support::print_requested_text(page, arguments)) return *code;
        const po::variables_map values = tool_support::parse_arguments(page.name, arguments, page.options);
        return plot(values);
    } catch (const InputError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    } catch (const OutputError& error) {  // also thrown for results that cannot be read
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
