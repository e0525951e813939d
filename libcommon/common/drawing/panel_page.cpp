#include "common/drawing/panel_page.hpp"

#include <algorithm>
#include <cmath>

#include "common/drawing/fitted_text.hpp"

namespace rockslope {

namespace {

constexpr double panels_left = 64, right = 16, panels_top = 30, below_axes = 44;
/// Narrowest page with legends beside the panels, and the part of it that they may take.
constexpr double least_page_beside = 480, largest_legend = 0.4;
/// A row of a legend, the mark before a name, and the room after it.
constexpr double row = 14, mark = 22, after_name = 14;
/// Lowest panel over its width: a panel of a narrow page is less high.
constexpr double flattest = 0.75;

const TextStyle title_style{11, black, Anchor::start, Anchor::start, true};

double widest_name(const Canvas& ruler, const std::vector<std::vector<std::string>>& legends) {
    double width = 0;
    for (const auto& names : legends)
        for (const std::string& name : names) width = std::max(width, ruler.text_width(name));
    return width;
}

}  // namespace

std::vector<std::string> names_of(const std::vector<LegendEntry>& entries) {
    std::vector<std::string> names;
    for (const LegendEntry& entry : entries) names.push_back(entry.text);
    return names;
}

PanelPage::PanelPage(const PanelLayout& layout, const PageStyle& style)
    : canvas(1, 1, style), layout_(layout) {
    const double width = style.width_in_units(layout.usual_width);
    column_ = mark + widest_name(canvas, layout.legends) + after_name;
    const bool has_legend = column_ > mark + after_name;
    legend_is_beside_ = has_legend && width >= least_page_beside && column_ <= largest_legend * width;
    right_ = width - (legend_is_beside_ ? column_ + 12 : right);
    layout_.panel_height = std::min(layout.panel_height, flattest * (right_ - panels_left));
    const double panels =
        static_cast<double>(layout.panels) * (layout_.panel_height + layout.gap) - layout.gap;
    next_legend_ = panels_top + panels + below_axes;
    columns_ = std::max<std::size_t>(1, static_cast<std::size_t>((width - 2 * right) / column_));
    column_ = std::min(column_, width - 2 * right);
    std::size_t rows = 0;
    if (!legend_is_beside_)
        for (const auto& names : layout.legends) rows += rows_of(names.size());
    canvas = Canvas(width, next_legend_ + row * static_cast<double>(rows), style);
    const std::string title = shortened(canvas, layout.title, title_style, width - 2 * right);
    const bool fits = canvas.text_width(title, title_style) <= width - panels_left - right;
    canvas.text({fits ? panels_left : right, panels_top - 12}, title, title_style);
}

std::size_t PanelPage::rows_of(std::size_t names) const {
    return (names + columns_ - 1) / columns_;
}

double PanelPage::top_of(std::size_t panel) const {
    return panels_top + static_cast<double>(panel) * (layout_.panel_height + layout_.gap);
}

Axes PanelPage::axes(std::size_t panel, const Range& x, const Range& y) const {
    const double upper = top_of(panel);
    return {{panels_left, upper}, {right_, upper + layout_.panel_height}, x, y};
}

void PanelPage::draw_legend(std::size_t panel, const std::vector<LegendEntry>& entries) {
    for (std::size_t k = 0; k < entries.size(); ++k) {
        const auto line = static_cast<double>(legend_is_beside_ ? k : k / columns_);
        const auto column = static_cast<double>(legend_is_beside_ ? 0 : k % columns_);
        const Point place = legend_is_beside_ ? Point{right_ + 12, top_of(panel) + 4 + row * line}
                                              : Point{right + column * column_, next_legend_ + row * line};
        draw_legend_entry(canvas, place, entries[k], column_ - mark);
    }
    if (!legend_is_beside_) next_legend_ += row * static_cast<double>(rows_of(entries.size()));
}

}  // namespace rockslope
