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

/// Largest and smallest principal stress in the plane, tension positive.
Vec2 principal(const Vec3& stress) {
    const double mean = (stress[0] + stress[1]) / 2;
    const double radius = std::hypot((stress[0] - stress[1]) / 2, stress[2]);
    return {mean + radius, mean - radius};
}

/// The end of a contact's share of its joint: the share runs from the corner along that of its block's faces
/// that lies along the edge, and not past the edge's ends.
Vec2 overlap_end(const BlockSystem& blocks, const Topology& topology, const Contact& contact) {
    const auto along = [&](int corner) {
        const Vec2& from = blocks.vertices[static_cast<std::size_t>(contact.corner)];
        return (blocks.vertices[static_cast<std::size_t>(corner)] - from).dot(contact.tangent);
    };
    const auto corner = static_cast<std::size_t>(contact.corner);
    const Vec2& from = blocks.vertices[corner];
    const auto slope = [&](int other) {
        return along(other) / (blocks.vertices[static_cast<std::size_t>(other)] - from).norm();
    };
    const double next = slope(topology.next[corner]);
    const double previous = slope(topology.previous[corner]);
    const double heading = std::abs(next) > std::abs(previous) ? next : previous;
    const double first = along(contact.edge);
    const double last = along(topology.next[static_cast<std::size_t>(contact.edge)]);
    const double end =
        std::clamp(std::copysign(contact.length, heading), std::min(first, 0.0), std::max(last, 0.0));
    return from + end * contact.tangent;
}

/// Faces that lie side by side are shown also when they do not touch: they are the open joints.
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
    for (int block = 0; block < model.block_count(); ++block) {
        const auto b = static_cast<std::size_t>(block);
        const Vec3& stress = state.blocks.stress[b];
        const Vec2 extremes = principal(stress);
        append(frame.columns[0], Vec2(state.blocks.centroid(block) - state.centroid_origin[b]));
        append(frame.columns[1], Vec2(state.blocks.velocity[b].head<2>()));
        for (int i = 0; i < 3; ++i) append(frame.columns[2], stress[i]);
        append(frame.columns[3], extremes[0]);
        append(frame.columns[3], extremes[1]);
        append(frame.columns[4], state.blocks.rotation[b]);
        append(frame.columns[5], block);
        append(frame.columns[6], model.block_material[b]);
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
    for (int block = 0; block < model.block_count(); ++block) {
        if (!state.is_present(block)) continue;
        const auto b = static_cast<std::size_t>(block);
        std::vector<std::int64_t> ring;
        for (auto k = static_cast<std::size_t>(cells.offsets[b]);
             k < static_cast<std::size_t>(cells.offsets[b + 1]); ++k) {
            const auto corner = static_cast<std::size_t>(cells.connectivity[k]);
            if (number[corner] < 0) {
                number[corner] = static_cast<std::int64_t>(frame.points.size() / 3);
                for (std::size_t i = 0; i < 3; ++i) frame.points.push_back(all.points[3 * corner + i]);
            }
            ring.push_back(number[corner]);
        }
        frame.cells.add(ring, cells.types[b]);
        for (std::size_t i = 0; i < columns.size(); ++i) {
            const auto width = static_cast<std::size_t>(columns[i].width);
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
        append(frame.points, state.blocks.vertices[static_cast<std::size_t>(contact.corner)] + model.origin);
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
                                 static_cast<double>(contact.joint_material),
                                 static_cast<double>(contact.joint),
                                 static_cast<double>(joint.stage),
                                 joint.mobilised_ratio,
                                 joint.dilation,
                                 static_cast<double>(joint.reversals)};
        for (std::size_t i = 0; i < std::size(values); ++i) append(frame.columns[i], values[i]);
    }
    return frame;
}

}  // namespace rockslope::dda
