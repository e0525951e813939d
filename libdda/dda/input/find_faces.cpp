#include "dda/input/find_faces.hpp"

#include <algorithm>
#include <cmath>

#include "dda/input/read_loads.hpp"
#include "dda/input/read_materials.hpp"

namespace rockslope::dda {

namespace {

/// Largest distance of a face from the line that selects it, m. Lines are read off drawings, and the corners
/// of blocks lie on a grid of about a micrometre.
constexpr double default_tolerance = 1e-3;

/// The part of an edge from p to q along a segment that starts at `origin` with the unit vector `along`.
std::optional<FaceAlongLine> overlap(const Vec2& p, const Vec2& q, const Vec2& origin, const Vec2& along,
                                     double length, double tolerance) {
    if (std::abs(cross(along, p - origin)) > tolerance || std::abs(cross(along, q - origin)) > tolerance)
        return std::nullopt;
    const double at_p = along.dot(p - origin);
    const double at_q = along.dot(q - origin);
    const double low = std::max(0.0, std::min(at_p, at_q));
    const double high = std::min(length, std::max(at_p, at_q));
    if (high - low <= tolerance) return std::nullopt;
    FaceAlongLine found;
    found.start = at_p < at_q ? low : high;
    found.end = at_p < at_q ? high : low;
    found.face.from = std::clamp((found.start - at_p) / (at_q - at_p), 0.0, 1.0);
    found.face.to = std::clamp((found.end - at_p) / (at_q - at_p), 0.0, 1.0);
    return found;
}

bool is_selectable(const Model& model, EdgeIndex edge, std::optional<BlockIndex> block) {
    const BlockIndex owner = model.topology.block_of_edge(edge);
    if (model.motion[owner] != Motion::free) return false;
    return block ? owner == *block : !model.topology.joint_material[edge].exists();
}

/// The line `along`, in the model's coordinates.
std::vector<Vec2> read_line(const ConfigTable& table, const Model& model) {
    std::vector<Vec2> line;
    for (const auto& [x, y] : table.pairs("along", Dimension::length)) {
        const Vec2 point = Vec2(x, y) - model.origin;
        if (line.empty() || point != line.back()) line.push_back(point);
    }
    if (line.size() < 2)
        table.fail("along", "'along' in [" + table.path() + "] has no length",
                   "a line of two points or more");
    return line;
}

}  // namespace

std::vector<FaceAlongLine> faces_along_line(const Model& model, std::span<const Vec2> line, double tolerance,
                                            std::optional<BlockIndex> block) {
    std::vector<FaceAlongLine> found;
    double before = 0;
    for (std::size_t k = 0; k + 1 < line.size(); ++k) {
        const double length = (line[k + 1] - line[k]).norm();
        const Vec2 along = (line[k + 1] - line[k]) / length;
        for (const EdgeIndex edge : model.topology.edges()) {
            if (!is_selectable(model, edge, block)) continue;
            const Vec2& q = model.vertices[model.topology.end_of(edge)];
            auto part = overlap(model.vertices[start_of(edge)], q, line[k], along, length, tolerance);
            if (!part) continue;
            part->face.edge = edge;
            part->start += before;
            part->end += before;
            found.push_back(*part);
        }
        before += length;
    }
    return found;
}

FacesAlongLine read_faces(const ConfigTable& table, const Model& model) {
    const std::vector<Vec2> line = read_line(table, model);
    const double tolerance = positive(table, "tolerance", Dimension::length, default_tolerance);
    std::optional<BlockIndex> block;
    if (table.has("block") || table.has("at")) block = read_block(table, model);
    FacesAlongLine result{faces_along_line(model, line, tolerance, block), 0};
    for (std::size_t k = 0; k + 1 < line.size(); ++k) result.length += (line[k + 1] - line[k]).norm();
    if (result.faces.empty())
        table.fail("along", "no face lies on 'along' in [" + table.path() + "]",
                   block ? "a line along a face of that block, which can move"
                         : "a line along free faces of blocks that can move");
    return result;
}

}  // namespace rockslope::dda
