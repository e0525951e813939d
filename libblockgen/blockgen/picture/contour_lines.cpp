#include "blockgen/picture/contour_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace rockslope::blockgen {

namespace {

/// A side of a cell: the numbers of its nodes, ascending.
using GridSide = std::pair<std::size_t, std::size_t>;

/// The contour as a graph of points on sides of cells, each joined to one in each cell beside it.
class Contour {
  public:
    Contour(const DiscGrid& grid, const std::vector<double>& values, double level)
        : grid_(grid), values_(values), level_(level) {
        for (std::size_t ring = 0; ring < grid.rings; ++ring)
            for (std::size_t spoke = 0; spoke < grid.spokes; ++spoke) add_cell(ring, spoke);
    }

    std::vector<std::vector<Point>> lines() {
        std::vector<std::vector<Point>> lines;
        // Lines with ends first, then closed ones.
        for (const bool from_ends : {true, false})
            for (const auto& [side, next] : joined_)
                if (!next.empty() && (next.size() == 1) == from_ends) lines.push_back(line_from(side));
        return lines;
    }

  private:
    bool is_above(std::size_t node) const { return values_[node] > level_; }

    void add_cell(std::size_t ring, std::size_t spoke) {
        const std::array<std::size_t, 4> nodes = {grid_.index(ring, spoke), grid_.index(ring + 1, spoke),
                                                  grid_.index(ring + 1, spoke + 1),
                                                  grid_.index(ring, spoke + 1)};
        std::vector<GridSide> crossed;
        double middle = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            middle += values_[nodes[k]] / 4;
            if (is_above(nodes[k]) != is_above(nodes[(k + 1) % 4]))
                crossed.push_back(std::minmax(nodes[k], nodes[(k + 1) % 4]));
        }
        if (crossed.empty()) return;
        // Of four crossed sides those beside the corners that differ from the middle belong together.
        const std::size_t shift = crossed.size() == 4 && is_above(nodes[0]) == (middle > level_) ? 0 : 1;
        for (std::size_t k = 0; k < crossed.size(); k += 2)
            join(crossed[(k + shift) % crossed.size()], crossed[(k + shift + 1) % crossed.size()]);
    }

    void join(const GridSide& a, const GridSide& b) {
        joined_[a].push_back(b);
        joined_[b].push_back(a);
    }

    /// Follows a line and takes it out of the graph.
    std::vector<Point> line_from(GridSide side) {
        std::vector<Point> line = {point_on(side)};
        while (!joined_[side].empty()) {
            const GridSide next = joined_[side].back();
            joined_[side].pop_back();
            std::erase(joined_[next], side);
            line.push_back(point_on(next));
            side = next;
        }
        return line;
    }

    Point point_on(const GridSide& side) const {
        const auto node = [&](std::size_t k) { return grid_.node(k / grid_.spokes, k % grid_.spokes); };
        const Point a = node(side.first), b = node(side.second);
        const double t = (level_ - values_[side.first]) / (values_[side.second] - values_[side.first]);
        return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
    }

    const DiscGrid& grid_;
    const std::vector<double>& values_;
    double level_;
    std::map<GridSide, std::vector<GridSide>> joined_;
};

}  // namespace

Point DiscGrid::node(std::size_t ring, std::size_t spoke) const {
    const double radius = static_cast<double>(ring) / static_cast<double>(rings);
    const double azimuth = 2 * std::numbers::pi * static_cast<double>(spoke) / static_cast<double>(spokes);
    return {radius * std::sin(azimuth), radius * std::cos(azimuth)};
}

std::vector<std::vector<Point>> contour_lines(const DiscGrid& grid, const std::vector<double>& values,
                                              double level) {
    return Contour(grid, values, level).lines();
}

}  // namespace rockslope::blockgen
