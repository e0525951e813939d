#include "frame_layout.hpp"

#include <algorithm>

#include "colour_bar.hpp"

namespace rockslope {

namespace {

constexpr double margin_left = 60, margin_right = 16;
constexpr double max_plot_width = 520, max_plot_height = 640;
/// Width of the time and the legend of the contacts side by side.
constexpr double min_header_width = 290;
/// Smallest height of a drawing with a vertical colour bar, and smallest width of such a page.
constexpr double min_vertical_bar_length = 170, min_vertical_bar_page = 380;

}  // namespace

FrameLayout::FrameLayout(double width, double height, const PageStyle& style) {
    const double bar = bar_gap + vertical_bar_width;
    const double page = style.width.value_or(0) / style.unit;
    const double room = style.width ? page - margin_left - margin_right : max_plot_width / style.unit;
    const auto scale_in = [&](double plot_width) {
        return std::min(plot_width / width, max_plot_height / style.unit / height);
    };
    double scale = scale_in(style.width ? room - bar : room);
    bar_is_vertical =
        scale * height >= min_vertical_bar_length && (!style.width || page >= min_vertical_bar_page);
    if (!bar_is_vertical) scale = scale_in(room);
    const double header = style.width ? room : std::max(scale * width, min_header_width);
    const double drawn = bar_is_vertical && style.width ? header - bar : header;
    header_left = margin_left;
    header_right = margin_left + header;
    upper_left = {margin_left + (drawn - scale * width) / 2, top};
    lower_right = {upper_left.x + scale * width, top + scale * height};
    page_width = header_right + margin_right;
    if (bar_is_vertical && !style.width)
        page_width = std::max(page_width, lower_right.x + bar + margin_right);
    page_height = lower_right.y + below_axes + (bar_is_vertical ? 0 : horizontal_bar_height);
}

}  // namespace rockslope
