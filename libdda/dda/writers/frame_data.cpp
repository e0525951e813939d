#include "dda/writers/frame_data.hpp"

#include <algorithm>
#include <cmath>

namespace rockslope::dda {

namespace {

constexpr std::uint8_t vtk_vertex = 1;
constexpr std::uint8_t vtk_line = 3;

template <class Number>
void append(std::vector<Number>& out, const Vec2& v) {
    out.insert(out.end(), {static_cast<Number>(v.x()), static_cast<Number>(v.y()), Number{0}});
}
void append(std::vector<float>& out, double v) {
    out.push_back(static_cast<float>(v));
}

/// Major and minor principal stress in the plane, Pa, tension positive.
Vec2 principal(const Vec3& stress) {
    const double mean = (stress[0] + stress[1]) / 2;
    const double radius = std::hypot((stress[0] - stress[1]) / 2, stress[2]);
    return {mean + radius, mean - radius};
}

/// End point of the line that shows a contact's length: from the corner along the edge, in the direction of
/// that edge of the corner which lies along it, no farther than the edge's ends.
Vec2 overlap_end(const BlockSystem& blocks, const Topology& topology, const Contact& contact) {
    const Vec2& from = blocks.vertices[contact.corner];
    const auto along = [&](CornerIndex corner) {
        return (blocks.vertices[corner] - from).dot(contact.tangent);
    };
    const auto slope = [&](CornerIndex other) {
        return along(other) / (blocks.vertices[other] - from).norm();
    };
    const double next = slope(topology.next[contact.corner]);
    const double previous = slope(topology.previous[contact.corner]);
    const double heading = std::abs(next) > std::abs(previous) ? next : previous;
    const double first = along(start_of(contact.edge));
    const double last = along(topology.end_of(contact.edge));
    const double end =
        std::clamp(std::copysign(contact.length, heading), std::min(first, 0.0), std::max(last, 0.0));
    return from + end * contact.tangent;
}

/// Open contacts between faces that lie side by side are shown too: they are open joints.
bool is_shown(const Contact& contact) {
    return contact.state != ContactState::open || contact.bonded || contact.length > 0;
}

}  // namespace

std::vector<GridColumn> block_columns() {
    return {{"displacement", 3}, {"velocity", 3}, {"stress", 3},   {"principal_stress", 2},
            {"rotation", 1},     {"block", 1},    {"material", 1}, {"motion", 1}};
}

GridFrame block_frame(const Model& model, const State& state) {
    GridFrame frame;
    frame.time = state.time;
    frame.columns.resize(block_columns().size());
    for (const Vec2& vertex : state.blocks.vertices) append(frame.points, vertex + model.origin);
    for (const BlockIndex b : model.blocks()) {
        const Vec3& stress = state.blocks.stress[b];
        const Vec2 extremes = principal(stress);
        append(frame.columns[0], Vec2(state.blocks.centroid(b) - state.centroid_origin[b]));
        append(frame.columns[1], Vec2(state.blocks.velocity[b].head<2>()));
        for (int i = 0; i < 3; ++i) append(frame.columns[2], stress[i]);
        append(frame.columns[3], extremes[0]);
        append(frame.columns[3], extremes[1]);
        append(frame.columns[4], state.blocks.rotation[b]);
        append(frame.columns[5], b.value());
        append(frame.columns[6], model.block_material[b].value());
        append(frame.columns[7], static_cast<double>(model.motion[b]));
    }
    return frame;
}

GridFrame active_block_frame(const Model& model, const State& state, const GridCells& cells) {
    const GridFrame all = block_frame(model, state);
    GridFrame frame;
    frame.time = all.time;
    frame.columns.resize(all.columns.size());
    const std::vector<GridColumn> columns = block_columns();
    std::vector<std::int64_t> number(all.points.size() / 3, -1);
    for (const BlockIndex block : model.blocks()) {
        if (!state.is_present(block)) continue;
        const std::size_t b = block;
        std::vector<std::int64_t> ring;
        for (std::int64_t k = cells.offsets[b]; k < cells.offsets[b + 1]; ++k) {
            const std::int64_t corner = cells.connectivity[k];
            if (number[corner] < 0) {
                number[corner] = static_cast<std::int64_t>(frame.points.size() / 3);
                for (std::size_t i = 0; i < 3; ++i) frame.points.push_back(all.points[3 * corner + i]);
            }
            ring.push_back(number[corner]);
        }
        frame.cells.add(ring, cells.types[b]);
        for (std::size_t i = 0; i < columns.size(); ++i) {
            const std::size_t width = columns[i].width;
            for (std::size_t j = 0; j < width; ++j) frame.columns[i].push_back(all.columns[i][b * width + j]);
        }
    }
    return frame;
}

std::vector<GridColumn> contact_columns() {
    return {{"state", 1},        {"normal_stress", 1},   {"shear_stress", 1},
            {"normal_force", 1}, {"shear_force", 1},     {"slip", 1},
            {"gap", 1},          {"joint_material", 1},  {"joint", 1},
            {"stage", 1},        {"mobilised_ratio", 1}, {"dilation", 1},
            {"reversals", 1}};
}

GridFrame contact_frame(const Model& model, const State& state) {
    GridFrame frame;
    frame.time = state.time;
    frame.columns.resize(contact_columns().size());
    std::int64_t point = 0;
    for (const Contact& contact : state.contacts.contacts) {
        if (!is_shown(contact)) continue;
        const bool has_length = contact.length > 0;
        append(frame.points, state.blocks.vertices[contact.corner] + model.origin);
        if (has_length) {
            append(frame.points, overlap_end(state.blocks, model.topology, contact) + model.origin);
            frame.cells.add({point, point + 1}, vtk_line);
        } else {
            frame.cells.add({point}, vtk_vertex);
        }
        point += has_length ? 2 : 1;
        // A bare vertex has no area to spread its force over: its stress is given as zero.
        const double per_length = has_length ? 1 / contact.length : 0;
        const JointRecord joint =
            record(model.joint_material_at(contact.joint_material).law, contact.history);
        const double values[] = {static_cast<double>(contact.state),
                                 contact.normal_force * per_length,
                                 contact.shear_force * per_length,
                                 contact.normal_force,
                                 contact.shear_force,
                                 contact.slip,
                                 contact.gap,
                                 static_cast<double>(contact.joint_material.value()),
                                 static_cast<double>(contact.joint.value()),
                                 static_cast<double>(joint.stage),
                                 joint.mobilised_ratio,
                                 joint.dilation,
                                 static_cast<double>(joint.reversals)};
        for (std::size_t i = 0; i < std::size(values); ++i) append(frame.columns[i], values[i]);
    }
    return frame;
}

}  // namespace rockslope::dda
