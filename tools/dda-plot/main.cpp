#include <cstdio>
#include <exception>
#include <optional>

#include "common/base/input_error.hpp"
#include "common/base/output_check.hpp"
#include "common/base/output_error.hpp"
#include "history_table.hpp"
#include "joint_pictures.hpp"
#include "plot_options.hpp"
#include "report.hpp"
#include "support/parse_arguments.hpp"
#include "support/standard_streams.hpp"

using namespace rockslope;

namespace fs = std::filesystem;

namespace {

std::vector<std::int64_t> chosen_frames(const RunFrames& run, const std::string& list) {
    const auto count = static_cast<std::int64_t>(run.times().size());
    if (count == 0)
        throw InputError({run.name() + ".vtkhdf"}, "contains no frames yet", "a run that has begun");
    return frame_numbers(list, count);
}

/// NAME.KIND-0012.EXT in the output folder.
fs::path picture_path(const RunFrames& run, const PlotOptions& options, const std::string& kind,
                      std::int64_t number) {
    char suffix[32];
    std::snprintf(suffix, sizeof suffix, "-%04lld.", static_cast<long long>(number));
    return options.output / (run.name() + "." + kind + suffix + options.extension);
}

void draw_frames(const RunFrames& run, const std::vector<std::int64_t>& numbers, const PlotOptions& options) {
    const FrameContent& content = options.content;
    const PictureScale scale = common_scale(run, numbers, content, options.largest);
    const bool is_usual = content.field == &frame_fields().front();
    for (const std::int64_t number : numbers)
        draw_frame(run, number, scale, content, options.style)
            .write(picture_path(run, options, is_usual ? "frame" : content.field->name, number));
}

void draw_roughness_frames(const RunFrames& run, const std::vector<std::int64_t>& numbers,
                           const PlotOptions& options) {
    const PictureScale scale = common_scale(run, numbers, {});
    for (const std::int64_t number : numbers)
        draw_roughness(run, number, scale, options.style)
            .write(picture_path(run, options, "roughness", number));
}

/// The worst contact to draw: with --worst-contact a missing contact is an error; without options the contact
/// is drawn if the summary names one.
std::optional<dda::WorstContact> worst_contact_to_draw(const PlotOptions& options) {
    // That of a run for Make which failed has a name of its own.
    const fs::path failed = options.folders.front() / "failed.json";
    const fs::path summary = fs::exists(failed) ? failed : options.folders.front() / "summary.json";
    if (!options.worst_contact && !(options.draws_all && fs::exists(summary))) return std::nullopt;
    std::optional<dda::WorstContact> worst = dda::read_worst_contact(summary);
    if (options.worst_contact && !worst)
        throw InputError({summary.string()}, "names no worst contact", "a run that did not converge");
    return worst;
}

/// Two views of the last frame: the whole section and the surroundings of the worst contact.
struct WorstContactViews {
    dda::WorstContact contact;
    std::int64_t frame;
    PictureScale whole, near;

    WorstContactViews(const RunFrames& run, dda::WorstContact worst, const PlotOptions& options)
        : contact(std::move(worst)),
          frame(chosen_frames(run, "last").front()),
          whole(common_scale(run, {frame}, options.content, options.largest)),
          near(scale_around_contact(contact, run, frame, whole)) {}

    void draw(const RunFrames& run, const PlotOptions& options) const {
        const std::string stem = run.name() + ".worst-contact", extension = "." + options.extension;
        draw_frame(run, frame, whole, options.content, options.style, contact)
            .write(options.output / (stem + extension));
        draw_frame(run, frame, near, options.content, options.style, contact)
            .write(options.output / (stem + "-near" + extension));
    }
};

/// A joint's name with characters that are safe in a file name.
std::string file_safe_name(std::string name) {
    for (char& c : name)
        if (c == '/' || c == ' ') c = '-';
    return name;
}

void write_joint(const JointPicture& picture, const PlotOptions& options) {
    picture.canvas.write(options.output /
                         ("joint-" + file_safe_name(picture.joint) + "." + options.extension));
}

int plot_joint(const PlotOptions& options) {
    check_output_folder(options.output);
    const JointPicture picture =
        picture_of_joint(*options.joint, options.folders, options.references, options.style);
    make_output_folder(options.output);
    write_joint(picture, options);
    return 0;
}

int make_movie(const PlotOptions& options) {
    check_output(*options.movie, {});
    const RunFrames run(options.folders.front());
    const std::vector<std::int64_t> frames = chosen_frames(run, options.frames.value_or("all"));
    const PictureScale scale = common_scale(run, frames, options.content, options.largest);
    write_movie({run, frames, scale, options.content, options.style}, options.timing, *options.movie);
    return 0;
}

int plot_run(const PlotOptions& options) {
    check_output_folder(options.output);
    const fs::path folder = options.folders.front();
    const RunFrames run(folder);
    const bool all = options.draws_all;
    // All input is read before the first picture is written.
    std::optional<HistoryTable> history;
    if (all || options.history) history = read_history(folder / "history.csv");
    std::vector<std::int64_t> frames;
    if (all || options.roughness || options.frames)
        frames = chosen_frames(run, options.frames.value_or("first,middle,last"));
    std::optional<WorstContactViews> worst;
    if (const auto contact = worst_contact_to_draw(options)) worst.emplace(run, *contact, options);
    const std::vector<JointPicture> joints =
        all ? pictures_of_joints(folder, options.style) : std::vector<JointPicture>{};
    const bool roughness = options.roughness || (all && has_roughness(run, frames.back()));
    make_output_folder(options.output);
    if (!frames.empty() && !options.roughness) draw_frames(run, frames, options);
    if (roughness) draw_roughness_frames(run, frames, options);
    for (const JointPicture& joint : joints) write_joint(joint, options);
    if (worst) worst->draw(run, options);
    if (history)
        draw_history(*history, options.style)
            .write(options.output / (run.name() + ".history." + options.extension));
    return 0;
}

/// What the last frame of a strength reduction shows; empty for other runs.
std::string mechanism_of(const fs::path& summary) {
    const std::optional<double> factor = dda::read_factor_of_safety(summary);
    if (!factor) return {};
    char text[64];
    std::snprintf(text, sizeof text, "mechanism, factor of safety %.4g", *factor);
    return text;
}

int plot(PlotOptions options) {
    if (options.joint) return plot_joint(options);
    if (options.report) {
        check_output(*options.report, {});
        write_report(options.folders.front(), *options.report);
        return 0;
    }
    const fs::path summary = options.folders.front() / "summary.json";
    if (fs::exists(summary)) options.content.mechanism = mechanism_of(summary);
    return options.movie ? make_movie(options) : plot_run(options);
}

/// Does what the arguments ask for; prints why it failed. @return the exit code.
int act_on_arguments(int argc, char** argv) {
    try {
        const tool_support::CommandPage page = command_page();
        const std::vector<std::string> arguments = tool_support::arguments_of(argc, argv);
        if (const auto code = tool_support::print_requested_text(page, arguments)) return *code;
        return plot(read_options(tool_support::parse_arguments(page.name, arguments, page.options)));
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

}  // namespace

int main(int argc, char** argv) {
    return tool_support::run_program("dda-plot", [&] { return act_on_arguments(argc, argv); });
}
