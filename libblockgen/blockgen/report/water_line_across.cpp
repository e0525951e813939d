#include "blockgen/report/water_line_across.hpp"

#include <algorithm>

#include "blockgen/input/height_line.hpp"

namespace rockslope::blockgen {

std::vector<Point> water_line_across(const BlockMesh& mesh) {
    if (mesh.water_table.empty() || mesh.vertices.empty()) return {};
    const auto [left, right] = std::minmax_element(mesh.vertices.begin(), mesh.vertices.end(),
                                                   [](const Point& p, const Point& q) { return p.x < q.x; });
    return height_line(mesh.water_table, left->x, right->x);
}

}  // namespace rockslope::blockgen
