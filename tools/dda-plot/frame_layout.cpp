#include "frame_layout.hpp"

#include <algorithm>

#include "colour_bar.hpp"

namespace rockslope {

namespace {

constexpr double max_plot_width = 520, max_plot_height = 640;
/// Width of the time and the legend of the contacts side by side.
constexpr double min_header_width = 290;
/// Smallest height of a drawing with a vertical colour bar.
constexpr double min_vertical_bar_length = 170;

Point point_at(const dda::GridFrame& frame, std::int64_t index) {
    const std::size_t i = index;
    return {frame.points[3 * i], frame.points[3 * i + 1]};
}

}  // namespace

FrameLayout::FrameLayout(double width, double height) {
    const double scale = std::min(max_plot_width / width, max_plot_height / height);
    const double header = std::max(scale * width, min_header_width);
    const double bottom = top + scale * height;
    bar_is_vertical = scale * height >= min_vertical_bar_length;
    header_left = left;
    header_right = left + header;
    upper_left = {left + (header - scale * width) / 2, top};
    lower_right = {upper_left.x + scale * width, bottom};
    page_width = header_right + margin_right;
    if (bar_is_vertical)
        page_width = std::max(page_width, lower_right.x + bar_gap + vertical_bar_width + margin_right);
    page_height = bottom + below_axes + (bar_is_vertical ? 0 : horizontal_bar_height);
}

std::vector<Point> cell_points(const dda::GridFrame& frame, std::size_t cell) {
    std::vector<Point> points;
    for (auto k = frame.cells.offsets[cell]; k < frame.cells.offsets[cell + 1]; ++k)
        points.push_back(point_at(frame, frame.cells.connectivity[k]));
    return points;
}

}  // namespace rockslope
