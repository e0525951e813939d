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

FrameLayout::FrameLayout(double width, double height, const PictureStyle& style)
    : letters(style.lettering.scale), top(34 * letters), below_axes(44 * letters) {
    const double side = margin_left * letters, bar = bar_gap + vertical_bar_width * letters;
    const double room = style.width ? *style.width - side - margin_right : max_plot_width;
    const auto scale_in = [&](double plot_width) {
        return std::min(plot_width / width, max_plot_height / height);
    };
    double scale = scale_in(style.width ? room - bar : room);
    bar_is_vertical = scale * height >= min_vertical_bar_length * letters &&
                      (!style.width || *style.width >= min_vertical_bar_page * letters);
    if (!bar_is_vertical) scale = scale_in(room);
    const double header = style.width ? room : std::max(scale * width, min_header_width * letters);
    const double drawn = bar_is_vertical && style.width ? header - bar : header;
    header_left = side;
    header_right = side + header;
    upper_left = {side + (drawn - scale * width) / 2, top};
    lower_right = {upper_left.x + scale * width, top + scale * height};
    page_width = header_right + margin_right;
    if (bar_is_vertical && !style.width)
        page_width = std::max(page_width, lower_right.x + bar + margin_right);
    page_height = lower_right.y + below_axes + (bar_is_vertical ? 0 : horizontal_bar_height * letters);
}

}  // namespace rockslope
