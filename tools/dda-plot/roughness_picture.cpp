#include "frame_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "common/drawing/axes.hpp"
#include "frame_layout.hpp"

namespace rockslope {

namespace {

// Columns of the frames that the picture reads, and a value in them.
const std::vector<std::string> columns = {"state", "mobilised_ratio"};

const Colour rock_colour{0.95, 0.94, 0.92}, smooth_colour{0.62, 0.62, 0.62};
constexpr double joint_width = 2.6, smooth_width = 0.8;

/// Number of classes of the ratio's magnitude.
constexpr int classes = 5;
constexpr double header_entry_width = 64;

int class_of(double ratio) {
    return std::clamp(static_cast<int>(std::ceil(std::abs(ratio) * classes)) - 1, 0, classes - 1);
}
/// Colour of a class. The palest quarter of the scale is skipped, because it would not be visible as a line.
Colour class_colour(int number) {
    return scale_colour(0.25 + 0.75 * number / (classes - 1));
}
std::string class_text(int number) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f–%.1f", double{1} * number / classes,
                  double{1} * (number + 1) / classes);
    return text;
}

void draw_rock(Canvas& canvas, const Axes& axes, const dda::GridFrame& blocks) {
    for (std::size_t block = 0; block < blocks.cells.count(); ++block) {
        const Ring ring = axes.to_page(cell_points(blocks, block));
        canvas.polygon(std::span(&ring, 1), rock_colour, Stroke{smooth_colour, 0.25});
    }
}

void draw_joints(Canvas& canvas, const Axes& axes, const dda::GridFrame& contacts) {
    for (std::size_t cell = 0; cell < contacts.cells.count(); ++cell) {
        std::vector<Point> points = cell_points(contacts, cell);
        if (points.size() < 2) continue;
        for (Point& point : points) point = axes.to_page(point);
        const double ratio = contacts.columns[1][cell];
        if (ratio == 0 || contacts.columns[0][cell] == state_open)
            canvas.polyline(points, {smooth_colour, smooth_width});
        else
            canvas.polyline(points, {class_colour(class_of(ratio)), joint_width});
    }
}

void draw_key(Canvas& canvas, const FrameLayout& layout) {
    const double y = layout.page_height - 8;
    canvas.text({layout.header_left, y - 16 * layout.letters},
                "mobilised over peak roughness (grey: none, or open)", {8.5});
    for (int k = 0; k < classes; ++k) {
        const double x = layout.header_left + k * header_entry_width * layout.letters;
        canvas.polyline(std::vector<Point>{{x, y - 3}, {x + 18, y - 3}}, {class_colour(k), joint_width});
        canvas.text({x + 22, y}, class_text(k), {8.5});
    }
}

}  // namespace

bool has_roughness(const RunFrames& run, std::int64_t index) {
    const dda::GridFrame contacts = run.contacts(index, columns);
    return std::any_of(contacts.columns[1].begin(), contacts.columns[1].end(),
                       [](float ratio) { return ratio != 0; });
}

Canvas draw_roughness(const RunFrames& run, std::int64_t index, const PictureScale& scale,
                      const PictureStyle& style) {
    FrameLayout layout(scale.right - scale.left, scale.top - scale.bottom, style);
    layout.page_height = layout.lower_right.y + layout.below_axes + 40 * layout.letters;
    layout.page_width = std::max(layout.header_right + 16,
                                 layout.header_left + classes * header_entry_width * layout.letters);
    Canvas canvas(layout.page_width, layout.page_height, style.lettering);
    const Axes axes(layout.upper_left, layout.lower_right, {scale.left, scale.right},
                    {scale.bottom, scale.top});
    canvas.clip(axes.upper_left(), axes.lower_right());
    draw_rock(canvas, axes, run.blocks(index));
    draw_joints(canvas, axes, run.contacts(index, columns));
    canvas.unclip();
    axes.draw(canvas, "x (m)", "y (m)");
    draw_key(canvas, layout);
    canvas.text({layout.header_left, layout.top - 12 * layout.letters}, run.title(index),
                {11, black, Anchor::start, Anchor::start, true});
    return canvas;
}

}  // namespace rockslope
