#include "frame_picture.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "blockgen/base/input_error.hpp"
#include "blockgen/picture/axes.hpp"
#include "length_unit.hpp"

namespace {

constexpr double left = 52, top = 34, plot_width = 520, bar_width = 14, margin_right = 98, margin_bottom = 44;
constexpr double lowest_plot = 150, highest_plot = 640;

// The columns that a picture needs, and their places in the frames.
const std::vector<std::string> block_columns = {"displacement", "motion"};
const std::vector<std::string> contact_columns = {"state"};
constexpr float prescribed = 2, state_open = 0, state_sliding = 1;

const blockgen::Colour sliding_colour{0.84, 0.37, 0.0};
const blockgen::Colour open_colour{0.0, 0.45, 0.70};

struct Vector {
    double x = 0, y = 0;
};

Vector displacement_of(const dda::GridFrame& frame, std::size_t block) {
    return {frame.columns[0][3 * block], frame.columns[0][3 * block + 1]};
}

/// The displacement that the others are counted from: that of the first prescribed block, else none.
Vector base_displacement(const dda::GridFrame& frame) {
    const auto& motion = frame.columns[1];
    const auto base = std::find(motion.begin(), motion.end(), prescribed);
    return base == motion.end() ? Vector{}
                                : displacement_of(frame, static_cast<std::size_t>(base - motion.begin()));
}

std::vector<double> magnitudes(const dda::GridFrame& frame) {
    const Vector base = base_displacement(frame);
    std::vector<double> result;
    for (std::size_t block = 0; block < frame.cells.count(); ++block) {
        const Vector u = displacement_of(frame, block);
        result.push_back(std::hypot(u.x - base.x, u.y - base.y));
    }
    return result;
}

blockgen::Point point_at(const dda::GridFrame& frame, std::int64_t index) {
    const auto i = static_cast<std::size_t>(index);
    return {frame.points[3 * i], frame.points[3 * i + 1]};
}

std::vector<blockgen::Point> cell_points(const dda::GridFrame& frame, std::size_t cell) {
    std::vector<blockgen::Point> points;
    for (auto k = frame.cells.offsets[cell]; k < frame.cells.offsets[cell + 1]; ++k)
        points.push_back(point_at(frame, frame.cells.connectivity[static_cast<std::size_t>(k)]));
    return points;
}

void draw_blocks(blockgen::Canvas& canvas, const blockgen::Axes& axes, const dda::GridFrame& frame,
                 double largest) {
    const std::vector<double> moved = magnitudes(frame);
    for (std::size_t block = 0; block < frame.cells.count(); ++block) {
        const blockgen::Ring ring = axes.to_page(cell_points(frame, block));
        canvas.polygon(std::span(&ring, 1), blockgen::scale_colour(moved[block] / largest),
                       blockgen::Stroke{blockgen::black, 0.25});
    }
}

void draw_contacts(blockgen::Canvas& canvas, const blockgen::Axes& axes, const dda::GridFrame& frame) {
    for (std::size_t cell = 0; cell < frame.cells.count(); ++cell) {
        const float state = frame.columns[0][cell];
        if (state != state_open && state != state_sliding) continue;
        const blockgen::Colour colour = state == state_sliding ? sliding_colour : open_colour;
        std::vector<blockgen::Point> points = cell_points(frame, cell);
        for (blockgen::Point& point : points) point = axes.to_page(point);
        if (points.size() == 1)
            canvas.circle(points.front(), 1.2, colour, std::nullopt);
        else
            canvas.polyline(points, {colour, 1.1});
    }
}

void draw_colour_bar(blockgen::Canvas& canvas, const blockgen::Axes& axes, const PictureScale& scale) {
    const LengthUnit unit = readable_unit(scale.largest);
    const double x = axes.lower_right().x + 16;
    const double low = axes.lower_right().y, high = axes.upper_left().y;
    constexpr int shades = 64;
    for (int i = 0; i < shades; ++i) {
        const double from = low + (high - low) * i / shades, to = low + (high - low) * (i + 1) / shades - 0.3;
        const blockgen::Ring strip = {{x, from}, {x + bar_width, from}, {x + bar_width, to}, {x, to}};
        canvas.polygon(std::span(&strip, 1), blockgen::scale_colour((i + 0.5) / shades), std::nullopt);
    }
    const blockgen::Ring frame = {{x, low}, {x + bar_width, low}, {x + bar_width, high}, {x, high}};
    canvas.polygon(std::span(&frame, 1), std::nullopt, blockgen::Stroke{blockgen::black, 0.5});
    const double largest = scale.largest * unit.per_metre;
    const std::vector<double> ticks = blockgen::round_ticks({0, largest}, 6);
    const double step = ticks.size() > 1 ? ticks[1] - ticks[0] : largest;
    for (const double tick : ticks) {
        const double y = low + (high - low) * tick / largest;
        canvas.polyline(std::vector<blockgen::Point>{{x + bar_width, y}, {x + bar_width + 3, y}},
                        {blockgen::black, 0.5});
        canvas.text({x + bar_width + 5, y}, blockgen::tick_text(tick, step),
                    {8, blockgen::black, blockgen::Anchor::start, blockgen::Anchor::middle});
    }
    const std::string title =
        std::string(scale.relative_to_base ? "displacement from the base" : "displacement") + " (" +
        unit.name + ")";
    canvas.text(
        {x + bar_width + 42, (low + high) / 2}, title,
        {9, blockgen::black, blockgen::Anchor::middle, blockgen::Anchor::middle, false, 1.5707963267948966});
}

void draw_contact_key(blockgen::Canvas& canvas, double right) {
    const double y = top - 12;
    canvas.polyline(std::vector<blockgen::Point>{{right - 170, y - 3}, {right - 150, y - 3}},
                    {sliding_colour, 1.6});
    canvas.text({right - 146, y}, "sliding contact", {8.5});
    canvas.polyline(std::vector<blockgen::Point>{{right - 74, y - 3}, {right - 54, y - 3}},
                    {open_colour, 1.6});
    canvas.text({right - 50, y}, "open joint", {8.5});
}

}  // namespace

RunFrames::RunFrames(const std::filesystem::path& folder) {
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
        const std::string file = entry.path().filename().string();
        const std::string extension = ".joints.vtkhdf";
        if (file.ends_with(extension)) name_ = file.substr(0, file.size() - extension.size());
    }
    if (name_.empty())
        throw blockgen::InputError({folder.string()}, "holds no NAME.vtkhdf and NAME.joints.vtkhdf",
                                   "the output folder of dda-run");
    blocks_.emplace(folder / (name_ + ".vtkhdf"));
    contacts_.emplace(folder / (name_ + ".joints.vtkhdf"));
}

dda::GridFrame RunFrames::blocks(std::int64_t index) const {
    return blocks_->frame(index, block_columns);
}
dda::GridFrame RunFrames::contacts(std::int64_t index) const {
    return contacts_->frame(index, contact_columns);
}

PictureScale common_scale(const RunFrames& run, const std::vector<std::int64_t>& frames) {
    PictureScale scale{0, 1e300, -1e300, 1e300, -1e300, false};
    for (const std::int64_t index : frames) {
        const dda::GridFrame frame = run.blocks(index);
        for (const double moved : magnitudes(frame)) scale.largest = std::max(scale.largest, moved);
        for (std::size_t i = 0; i + 2 < frame.points.size(); i += 3) {
            scale.left = std::min<double>(scale.left, frame.points[i]);
            scale.right = std::max<double>(scale.right, frame.points[i]);
            scale.bottom = std::min<double>(scale.bottom, frame.points[i + 1]);
            scale.top = std::max<double>(scale.top, frame.points[i + 1]);
        }
        const auto& motion = frame.columns[1];
        scale.relative_to_base = std::find(motion.begin(), motion.end(), prescribed) != motion.end();
    }
    if (scale.largest == 0) scale.largest = 1e-3;
    const double margin = 0.02 * std::max(scale.right - scale.left, scale.top - scale.bottom);
    scale.left -= margin;
    scale.right += margin;
    scale.bottom -= margin;
    scale.top += margin;
    return scale;
}

blockgen::Canvas draw_frame(const RunFrames& run, std::int64_t index, const PictureScale& scale) {
    const double aspect = (scale.top - scale.bottom) / (scale.right - scale.left);
    const double plot_height = std::clamp(plot_width * aspect, lowest_plot, highest_plot);
    blockgen::Canvas canvas(left + plot_width + margin_right, top + plot_height + margin_bottom);
    const blockgen::Axes axes =
        blockgen::Axes::of_equal_scale({left, top}, {left + plot_width, top + plot_height},
                                       {scale.left, scale.right}, {scale.bottom, scale.top});
    canvas.clip(axes.upper_left(), axes.lower_right());
    draw_blocks(canvas, axes, run.blocks(index), scale.largest);
    draw_contacts(canvas, axes, run.contacts(index));
    canvas.unclip();
    axes.draw(canvas, "x (m)", "y (m)");
    draw_colour_bar(canvas, axes, scale);
    draw_contact_key(canvas, left + plot_width);
    char title[64];
    std::snprintf(title, sizeof title, "t = %.3f s", run.times()[static_cast<std::size_t>(index)]);
    canvas.text({left, top - 12}, title,
                {11, blockgen::black, blockgen::Anchor::start, blockgen::Anchor::start, true});
    return canvas;
}
