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

/// Single precision unless the model has an origin of its own. It resolves coordinates near zero to
/// micrometres, but those of a national grid only to half a metre.
HdfType type_of_points(const Model& model) {
    return model.origin.isZero(0) ? HdfType::f4 : HdfType::f8;
}

/// "NUMBER NAME" and a line break.
std::string line_of(int number, const std::string& name) {
    return std::to_string(number) + " " + name + "\n";
}

const std::string& name_of(const std::string& name) {
    return name;
}
template <class Material>
const std::string& name_of(const Material& material) {
    return material.name;
}

/// A line for each of the names.
template <class Named>
std::string names_of(const Named& list) {
    std::string lines;
    for (const auto k : list.indices()) lines += line_of(k.value(), name_of(list[k]));
    return lines;
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

GridLayout block_layout(const Model& model) {
    std::string names;
    for (const BlockIndex b : model.blocks())
        if (!model.block_name[b].empty()) names += line_of(b.value(), model.block_name[b]);
    return {.columns = {{"displacement", 3},
                        {"velocity", 3},
                        {"stress", 3},
                        {"principal_stress", 2},
                        {"rotation", 1},
                        {"block", 1},
                        {"material", 1},
                        {"motion", 1}},
            .point_columns = {{"displacement", 3}},
            .texts = {{"units",
                       "displacement: m\nvelocity: m/s\nstress: Pa, xx yy xy, tension positive\n"
                       "principal_stress: Pa, tension positive\nrotation: rad\n"
                       "motion: 0 free, 1 fixed, 2 prescribed\n"},
                      {"block_materials", names_of(model.block_materials)},
                      {"block_names", names}},
            .points = type_of_points(model)};
}

GridFrame block_frame(const Model& model, const State& state) {
    GridFrame frame;
    frame.time = state.time;
    frame.columns.resize(block_layout(model).columns.size());
    frame.point_columns.resize(1);
    for (const CornerIndex c : state.blocks.vertices.indices()) {
        append(frame.points, state.blocks.vertices[c] + model.origin);
        append(frame.point_columns[0], Vec2(state.blocks.vertices[c] - state.vertex_origin[c]));
    }
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
    frame.point_columns.resize(1);
    const std::vector<GridColumn> columns = block_layout(model).columns;
    std::vector<std::int64_t> number(all.points.size() / 3, -1);
    for (const BlockIndex block : model.blocks()) {
        if (!state.is_present(block)) continue;
        const std::size_t b = block;
        std::vector<std::int64_t> ring;
        for (std::int64_t k = cells.offsets[b]; k < cells.offsets[b + 1]; ++k) {
            const std::int64_t corner = cells.connectivity[k];
            if (number[corner] < 0) {
                number[corner] = static_cast<std::int64_t>(frame.points.size() / 3);
                for (std::size_t i = 0; i < 3; ++i) {
                    frame.points.push_back(all.points[3 * corner + i]);
                    frame.point_columns[0].push_back(all.point_columns[0][3 * corner + i]);
                }
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

GridLayout contact_layout(const Model& model) {
    return {.columns = {{"state", 1},
                        {"normal_stress", 1},
                        {"shear_stress", 1},
                        {"normal_force", 1},
                        {"shear_force", 1},
                        {"slip", 1},
                        {"gap", 1},
                        {"joint_material", 1},
                        {"joint", 1},
                        {"stage", 1},
                        {"mobilised_ratio", 1},
                        {"dilation", 1},
                        {"reversals", 1},
                        {"block", 1},
                        {"other_block", 1}},
            .point_columns = {},
            .texts = {{"units",
                       "state: 0 open, 1 sliding, 2 locked\n"
                       "normal_stress: Pa, compression positive\nshear_stress: Pa\n"
                       "normal_force: N/m\nshear_force: N/m\nslip: m\ngap: m\ndilation: m\n"
                       "mobilised_ratio: mobilised over peak roughness\n"},
                      {"joint_materials", names_of(model.joint_materials)},
                      {"joints", names_of(model.joint_sets)}},
            .points = type_of_points(model)};
}

GridFrame contact_frame(const Model& model, const State& state) {
    GridFrame frame;
    frame.time = state.time;
    frame.columns.resize(contact_layout(model).columns.size());
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
                                 static_cast<double>(joint.reversals),
                                 static_cast<double>(model.topology.block_of[contact.corner].value()),
                                 static_cast<double>(model.topology.block_of_edge(contact.edge).value())};
        for (std::size_t i = 0; i < std::size(values); ++i) append(frame.columns[i], values[i]);
    }
    return frame;
}

}  // namespace rockslope::dda
