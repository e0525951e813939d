#include "frame_layout.hpp"

#include <algorithm>

#include "colour_bar.hpp"

namespace {

constexpr double widest_plot = 520, highest_plot = 640;
/// What the time and the key to the contacts need side by side.
constexpr double least_header = 290;
/// The least height of a drawing for a bar with its title beside it.
constexpr double least_standing_bar = 170;

blockgen::Point point_at(const dda::GridFrame& frame, std::int64_t index) {
    const auto i = static_cast<std::size_t>(index);
    return {frame.points[3 * i], frame.points[3 * i + 1]};
}

}  // namespace

FrameLayout::FrameLayout(double width, double height) {
    const double scale = std::min(widest_plot / width, highest_plot / height);
    const double header = std::max(scale * width, least_header);
    const double bottom = top + scale * height;
    bar_stands = scale * height >= least_standing_bar;
    header_left = left;
    header_right = left + header;
    upper_left = {left + (header - scale * width) / 2, top};
    lower_right = {upper_left.x + scale * width, bottom};
    page_width = header_right + margin_right;
    if (bar_stands)
        page_width = std::max(page_width, lower_right.x + bar_gap + standing_bar_width + margin_right);
    page_height = bottom + below_axes + (bar_stands ? 0 : lying_bar_height);
}

std::vector<blockgen::Point> cell_points(const dda::GridFrame& frame, std::size_t cell) {
    std::vector<blockgen::Point> points;
    for (auto k = frame.cells.offsets[cell]; k < frame.cells.offsets[cell + 1]; ++k)
        points.push_back(point_at(frame, frame.cells.connectivity[static_cast<std::size_t>(k)]));
    return points;
}
