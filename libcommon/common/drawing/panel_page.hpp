#pragma once

#include <string>
#include <vector>

#include "common/drawing/axes.hpp"

namespace rockslope {

/// What a page of panels is laid out for. Lengths in units of the page.
struct PanelLayout {
    double usual_width = 640;  ///< of a page without a width of its own, pt
    double panel_height = 150;
    double gap = 22;  ///< between panels, for which the abscissa is the same
    std::string title = {};
    std::size_t panels = 1;
    std::vector<std::vector<std::string>> legends = {};  ///< names in the legends that will be drawn
};

/// The names of the entries of a legend.
std::vector<std::string> names_of(const std::vector<LegendEntry>& entries);

/// A page of panels one above the other. The legends stand beside the panels, or all of them below where the
/// page is narrow; long names are shortened.
class PanelPage {
  public:
    /// A page with its title. @param layout at least one panel.
    PanelPage(const PanelLayout& layout, const PageStyle& style);

    /// The axes of a panel, counted from the top.
    Axes axes(std::size_t panel, const Range& x, const Range& y) const;
    /// Draws the legend of a panel, with the names of the layout. Legends are drawn in the order of the
    /// panels.
    void draw_legend(std::size_t panel, const std::vector<LegendEntry>& entries);

    Canvas canvas;  ///< to draw the panels on

  private:
    std::size_t rows_of(std::size_t names) const;
    double top_of(std::size_t panel) const;

    PanelLayout layout_;
    double right_;  ///< end of the panels
    bool legend_is_beside_;
    double column_;        ///< width of a column of a legend
    std::size_t columns_;  ///< of a legend below the panels
    double next_legend_;   ///< y of the next legend below the panels
};

}  // namespace rockslope
