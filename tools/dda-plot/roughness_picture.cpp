#include "frame_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "common/drawing/axes.hpp"
#include "common/drawing/fitted_text.hpp"
#include "frame_layout.hpp"

namespace rockslope {

namespace {

// Columns of the frames that the picture reads, and a value in them.
const std::vector<std::string> columns = {"state", "mobilised_ratio"};

const Colour rock_colour{0.95, 0.94, 0.92}, smooth_colour{0.62, 0.62, 0.62};
constexpr double joint_width = 2.6, smooth_width = 0.8;

/// Number of classes of the ratio's magnitude.
constexpr int classes = 5;
constexpr double entry_width = 64;

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

/// Classes of the key side by side: fewer on a narrow page.
int classes_in_row(const FrameLayout& layout) {
    const double room = layout.page_width - layout.header_left;
    return std::clamp(static_cast<int>(room / entry_width), 1, classes);
}

double height_of_key(const FrameLayout& layout) {
    const int rows = (classes - 1) / classes_in_row(layout) + 1;
    return 26 + 14.0 * rows;
}

void draw_key(Canvas& canvas, const FrameLayout& layout) {
    constexpr double edge = 8;
    const std::string title = "mobilised over peak roughness (grey: none, or open)";
    const double top = layout.lower_right.y + layout.below_axes + 8;
    const bool fits = canvas.text_width(title, {8.5}) < layout.page_width - layout.header_left - edge;
    canvas.text({fits ? layout.header_left : edge, top},
                shortened(canvas, title, {8.5}, layout.page_width - 2 * edge), {8.5});
    const int in_row = classes_in_row(layout);
    for (int k = 0; k < classes; ++k) {
        const int row = k / in_row;
        const double x = layout.header_left + k % in_row * entry_width, y = top + 16 + 14.0 * row;
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
                      const PageStyle& style) {
    FrameLayout layout(scale.right - scale.left, scale.top - scale.bottom, style);
    layout.page_width = layout.header_right + 16;
    layout.page_height = layout.lower_right.y + layout.below_axes + height_of_key(layout);
    Canvas canvas(layout.page_width, layout.page_height, style);
    const Axes axes(layout.upper_left, layout.lower_right, {scale.left, scale.right},
                    {scale.bottom, scale.top});
    canvas.clip(axes.upper_left(), axes.lower_right());
    draw_rock(canvas, axes, run.blocks(index));
    draw_joints(canvas, axes, run.contacts(index, columns));
    canvas.unclip();
    axes.draw(canvas, "x (m)", "y (m)");
    draw_key(canvas, layout);
    canvas.text({layout.header_left, layout.top - 12}, run.title(index),
                {11, black, Anchor::start, Anchor::start, true});
    return canvas;
}

}  // namespace rockslope
