#include "plot_options.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "common/base/input_error.hpp"
#include "common/base/text.hpp"
#include "ffmpeg.hpp"
#include "support/picture_options.hpp"

namespace rockslope {

namespace po = boost::program_options;

namespace {

void add_choices(po::options_description& options) {
    auto add = options.add_options();
    add("frames", po::value<std::string>()->value_name("LIST"),
        "frames to draw, separated by commas: numbers from 0, first, middle, last, or all (default: "
        "first,middle,last; of a film: all)");
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
    add("report", po::value<std::string>()->value_name("FILE"),
        "write a page instead, .html, in which the run plays, with histories, tables and checks; one file "
        "that "
        "needs no network");
    add("movie", po::value<std::string>()->value_name("FILE"),
        "make a film instead, .mp4, .webm or .gif, by the program ffmpeg");
    add("speed", po::value<double>()->value_name("FACTOR"),
        "seconds of the run in a second of the film (default: 1)");
    add("fps", po::value<double>()->value_name("N"), "pictures in a second of the film (default: 25)");
}

void add_looks(po::options_description& options) {
    auto add = options.add_options();
    add("field", po::value<std::string>()->value_name("NAME"),
        ("what the colours show: " + frame_field_names() + " (default: displacement)").c_str());
    add("largest", po::value<double>()->value_name("VALUE"),
        "value at which the colours end, SI unit (default: a round value that covers 99 % of the free "
        "blocks' area, or of the contacts' length, in every frame drawn)");
    add("scale", po::value<double>()->value_name("FACTOR"),
        "multiply the displacements of the blocks' corners, which shows small motions (default: 1)");
    add("labels", po::value<std::vector<std::string>>()->composing()->value_name("WHAT"),
        "write the numbers of the blocks or the names of the joints: blocks or joints; may be repeated");
    tool_support::add_picture_options(options);
    add("format", po::value<std::string>()->default_value("png")->value_name("EXT"), "png, svg or pdf");
    add("output,o", po::value<std::string>()->value_name("FOLDER"),
        "folder of the pictures (default: the result folder)");
    add("version", "print the version and stop");
    add("help,h", "print this text and stop");
}

std::optional<std::string> text_of(const po::variables_map& values, const char* key) {
    if (!values.count(key)) return std::nullopt;
    return values[key].as<std::string>();
}

std::vector<std::string> texts_of(const po::variables_map& values, const char* key) {
    return values.count(key) ? values[key].as<std::vector<std::string>>() : std::vector<std::string>{};
}

/// A positive number of an option. @throws InputError that says it is none, with what is expected.
std::optional<double> positive(const po::variables_map& values, const std::string& key,
                               const std::string& expected) {
    if (!values.count(key)) return std::nullopt;
    const double value = values[key].as<double>();
    if (!(value > 0) || !std::isfinite(value))
        throw InputError({"dda-plot"}, "--" + key + " is " + shortest_text(value), expected);
    return value;
}

[[noreturn]] void refuse(const std::string& what, const std::string& expected) {
    throw InputError({"dda-plot"}, what, expected);
}

void read_folders(const po::variables_map& values, PlotOptions& options) {
    for (const std::string& folder : texts_of(values, "file")) options.folders.emplace_back(folder);
    for (const std::string& file : texts_of(values, "reference")) options.references.emplace_back(file);
    options.joint = text_of(values, "joint");
    if (!options.references.empty() && !options.joint)
        refuse("--reference is given without --joint", "--joint NAME");
    if (options.joint ? options.folders.empty() : options.folders.size() != 1)
        refuse(std::to_string(options.folders.size()) + " folders are given", "one: dda-plot OUT [options]");
    options.output = text_of(values, "output").value_or(options.folders.front().string());
    options.extension = values["format"].as<std::string>();
    if (!picture_format("x." + options.extension))
        refuse("--format is '" + options.extension + "'", "png, svg or pdf");
    if (options.output.empty()) refuse("--output is empty", "a folder");
}

void read_content(const po::variables_map& values, FrameContent& content) {
    if (const auto field = text_of(values, "field")) content.field = &frame_field(*field);
    content.exaggeration = positive(values, "scale", "a positive factor").value_or(1);
    for (const std::string& label : texts_of(values, "labels")) {
        if (label != "blocks" && label != "joints") refuse("--labels is '" + label + "'", "blocks or joints");
        (label == "blocks" ? content.labels_blocks : content.labels_joints) = true;
    }
    if (content.exaggeration != 1 && (content.field->kind == FieldKind::contacts || content.labels_joints))
        refuse("--scale moves blocks, not joints", "a field of blocks, and no labels of joints");
}

void read_movie(const po::variables_map& values, PlotOptions& options) {
    constexpr double most_per_second = 120;
    options.movie = text_of(values, "movie");
    for (const char* key : {"speed", "fps"})
        if (values.count(key) && !options.movie)
            refuse(std::string("--") + key + " is given without --movie", "--movie FILE");
    if (options.movie && !is_movie(*options.movie))
        refuse("--movie is '" + options.movie->string() + "'", "a name that ends in .mp4, .webm or .gif");
    options.timing.speed = positive(values, "speed", "a positive factor").value_or(1);
    options.timing.frames_per_second = positive(values, "fps", "a positive number").value_or(25);
    if (options.timing.frames_per_second > most_per_second)
        refuse("--fps is " + shortest_text(options.timing.frames_per_second), "at most 120");
}

std::int64_t frame_number(const std::string& word, std::int64_t count) {
    if (word == "first") return 0;
    if (word == "middle") return count / 2;
    if (word == "last") return count - 1;
    std::int64_t number = -1;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc{} || end != word.data() + word.size() || number < 0 || number >= count)
        refuse("there is no frame '" + word + "'",
               "a number from 0 to " + std::to_string(count - 1) + ", first, middle, last or all");
    return number;
}

}  // namespace

tool_support::CommandPage command_page() {
    tool_support::CommandPage page{
        .name = "dda-plot",
        .version = ROCKSLOPE_VERSION,
        .synopsis = "OUT [options]",
        .purpose =
            "Draws the results of dda-run: blocks coloured by displacement or another quantity, and the "
            "histories of the measured points",
        .description =
            "Without options that choose pictures, it draws the first, the middle and the last frame, "
            "the histories and the measured joints."};
    add_choices(page.options);
    add_looks(page.options);
    return page;
}

PlotOptions read_options(const po::variables_map& values) {
    PlotOptions options;
    read_folders(values, options);
    read_content(values, options.content);
    options.style = tool_support::picture_style(values, "dda-plot");
    read_movie(values, options);
    options.report = text_of(values, "report");
    if (options.report && options.report->extension() != ".html")
        refuse("--report is '" + options.report->string() + "'", "a name that ends in .html");
    options.frames = text_of(values, "frames");
    options.largest = positive(values, "largest", "a positive value in SI units");
    options.history = values.count("history") > 0;
    options.roughness = values.count("roughness") > 0;
    options.worst_contact = values.count("worst-contact") > 0;
    options.draws_all = !options.frames && !options.history && !options.worst_contact && !options.roughness;
    return options;
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

}  // namespace rockslope
