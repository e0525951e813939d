#include "dda/monitor/blocks_on_planes.hpp"

#include <algorithm>
#include <cmath>

#include "dda/analysis/base_motion.hpp"
#include "dda/terms/loads.hpp"

namespace rockslope::dda {

namespace {

constexpr double min_support_ratio = 0.95;              // of normal force: the plane's to the block's
const double min_cosine_same_plane = std::cos(0.0524);  // 3 degrees

constexpr double level = 1e-6;  // rad, dip below which a plane has no downhill direction

/// A contact that supports a block.
struct Support {
    const Contact* contact = nullptr;
    BlockIndex other;
    Vec2 normal = Vec2::Zero();  ///< unit, into the block
};

PerBlock<std::vector<Support>> supports_of(const Model& model, const State& state) {
    PerBlock<std::vector<Support>> supports(model.block_count());
    for (const Contact& contact : state.contacts.contacts) {
        if (!(contact.normal_force > 0)) continue;
        supports[contact.corner_block].push_back({&contact, contact.edge_block, contact.normal});
        supports[contact.edge_block].push_back({&contact, contact.corner_block, -contact.normal});
    }
    return supports;
}

/// Adds the peak and residual strength of a contact on the plane, per mass of the block.
/// @param fraction the contact's normal force over that of the plane.
void add_strength(const Model& model, const Contact& contact, double fraction, double mass,
                  BlockOnPlane& plane) {
    const JointLaw& law = model.joint_material_at(contact.joint_material).law;
    if (const auto envelope = coulomb_envelope(law)) {
        plane.peak.friction += fraction * envelope->peak.friction;
        plane.peak.adhesion += envelope->peak.cohesion * contact.length / mass;
        plane.residual.friction += fraction * envelope->residual.friction;
        plane.residual.adhesion += envelope->residual.cohesion * contact.length / mass;
        return;
    }
    const Strength bound = strength(law, contact.history, contact.normal_force, contact.length);
    const double friction = std::min(bound.forward, bound.backward) / contact.normal_force;
    plane.peak.friction += fraction * friction;
    plane.residual.friction += fraction * friction;
}

void reduce(double factor, record::PlaneStrength& strength) {
    strength.friction /= factor;
    strength.adhesion /= factor;
}

/// Finds the plane of a fixed or prescribed block on which a block rests. @return whether there is one.
bool find_plane(const Model& model, const State& state, const std::vector<Support>& supports,
                BlockOnPlane& plane) {
    if (supports.empty()) return false;
    const auto largest = std::max_element(supports.begin(), supports.end(), [](const auto& a, const auto& b) {
        return a.contact->normal_force < b.contact->normal_force;
    });
    plane.base = largest->other;
    const Vec2 normal = largest->normal;
    const bool moves_by_itself = model.motion[plane.base] == Motion::free;
    if (moves_by_itself || normal.dot(model.gravity) >= 0) return false;

    double all = 0, on_plane = 0;
    std::vector<const Contact*> contacts;
    for (const Support& support : supports) {
        all += support.contact->normal_force;
        if (support.other != plane.base || support.normal.dot(normal) < min_cosine_same_plane) continue;
        on_plane += support.contact->normal_force;
        contacts.push_back(support.contact);
    }
    if (on_plane < min_support_ratio * all) return false;

    const double mass = state.blocks.mass[plane.block];
    for (const Contact* contact : contacts)
        add_strength(model, *contact, contact->normal_force / on_plane, mass, plane);
    if (!std::isfinite(plane.peak.friction + plane.peak.adhesion)) return false;  // glued to its base
    reduce(model.strength_reduction, plane.peak);
    reduce(model.strength_reduction, plane.residual);
    const Vec2 along(normal.y(), -normal.x());
    const double fall = along.dot(model.gravity) / model.gravity.norm();
    const bool is_level = std::abs(fall) < level;
    plane.downhill = (is_level ? along.x() : fall) < 0 ? Vec2(-along) : along;
    plane.dip = std::acos(std::clamp(-normal.dot(model.gravity.normalized()), -1.0, 1.0));
    return true;
}

TimeTable history_of(const Load& load) {
    return std::visit([](const auto& l) { return l.history; }, load);
}

Vec2 load_acceleration(const std::vector<LoadOnBlock>& loads, double dynamic_time) {
    Vec2 sum = Vec2::Zero();
    for (const LoadOnBlock& load : loads) sum += load.history.at(dynamic_time) * load.acceleration;
    return sum;
}

/// Acceleration of a rigid block by gravity and the motions of its base, in the frame of the base, m/s2.
Vec2 gravity_and_motion_at(const Model& model, const Stage& stage, const BlockOnPlane& plane,
                           double stage_time) {
    return model.gravity - frame_acceleration(stage, stage_time) -
           base_acceleration(model, stage, plane.base, stage_time);
}

Vec2 plane_inward_normal(const BlockOnPlane& plane, const Vec2& gravity) {
    const Vec2 across = perpendicular(plane.downhill);
    return across.dot(gravity) < 0 ? Vec2(-across) : across;
}

}  // namespace

std::vector<BlockOnPlane> find_blocks_on_planes(const Model& model, const State& state) {
    std::vector<BlockOnPlane> planes;
    if (model.gravity.isZero(0)) return planes;
    const auto supports = supports_of(model, state);
    for (const BlockIndex block : model.blocks()) {
        if (model.motion[block] != Motion::free || !state.is_present(block)) continue;
        BlockOnPlane plane;
        plane.block = block;
        if (find_plane(model, state, supports[block], plane)) planes.push_back(plane);
    }
    return planes;
}

std::vector<LoadOnBlock> loads_on(const Model& model, const BlockOnPlane& plane) {
    std::vector<LoadOnBlock> loads;
    if (model.loads.empty()) return loads;
    const RowMap rows(model.motion);
    const BlockSystem blocks = initial_block_system(model);
    const std::vector<Vec6> still(blocks.velocity.size(), Vec6::Zero());
    const MidStep mid = predict_mid_step(model, blocks, still, ThreadPool(1));
    for (const Load& load : model.loads) {
        const PerRow<Vec6> forces = unit_load_forces(model, rows, blocks, mid, load);
        const Vec2 force = forces[rows.row_of[plane.block]].head<2>();
        if (!force.isZero(0)) loads.push_back({force / blocks.mass[plane.block], history_of(load)});
    }
    return loads;
}

/// At yield under the acceleration k g, with the accelerations a_t downhill and a_n into the plane by loads:
/// g sin + a_t + k g cos = mu (g cos + a_n - k g sin) + adhesion.
double yield_coefficient(const Model& model, const BlockOnPlane& plane) {
    const double gravity = model.gravity.norm();
    const Vec2 loads = load_acceleration(loads_on(model, plane), 0) / gravity;
    const double drive = std::sin(plane.dip) + loads.dot(plane.downhill);
    const double pressure = std::cos(plane.dip) + loads.dot(plane_inward_normal(plane, model.gravity));
    const double friction = plane.peak.friction;
    return (friction * pressure - drive + plane.peak.adhesion / gravity) /
           (std::cos(plane.dip) + friction * std::sin(plane.dip));
}

double rigid_slip(const Model& model, std::span<const Stage> stages, const BlockOnPlane& plane,
                  double dynamic_time) {
    record::RigidSlider block(plane.peak, plane.residual);
    const std::vector<LoadOnBlock> loads = loads_on(model, plane);
    const Vec2 down = plane_inward_normal(plane, model.gravity);
    double stage_start = 0;  // s of dynamic time
    for (const Stage& stage : stages) {
        if (stage.is_static()) continue;
        const double length = std::min(stage.duration, dynamic_time - stage_start);
        if (!(length > 0)) break;
        const auto steps = static_cast<std::int64_t>(std::ceil(length / record::max_sliding_substep));
        const double dt = length / static_cast<double>(steps);
        for (std::int64_t k = 0; k < steps; ++k) {
            const double time = (static_cast<double>(k) + 0.5) * dt;
            const Vec2 field = gravity_and_motion_at(model, stage, plane, time) +
                               load_acceleration(loads, stage_start + time);
            block.advance(field.dot(plane.downhill), field.dot(down), dt);
        }
        stage_start += stage.duration;
    }
    return block.slip();
}

std::vector<std::string> ignored_by_estimate(const Model& model, const BlockOnPlane& plane) {
    std::vector<std::string> ignored;
    const auto holds = [&](PointIndex point) { return model.material_points[point].block == plane.block; };
    const auto add_if_any = [&](const char* what, const auto& all, const auto& acts_on_block) {
        if (std::any_of(all.begin(), all.end(), acts_on_block)) ignored.emplace_back(what);
    };
    add_if_any("bolts", model.bolts,
               [&](const BoltSpec& bolt) { return holds(bolt.first) || holds(bolt.second); });
    add_if_any("fixed points", model.fixed_points,
               [&](const FixedPoint& fixed) { return holds(fixed.point); });
    add_if_any("viscous boundaries", model.viscous_boundaries, [&](const ViscousBoundary& boundary) {
        return std::any_of(boundary.faces.begin(), boundary.faces.end(), [&](const FacePart& face) {
            return model.topology.block_of_edge(face.edge) == plane.block;
        });
    });
    if (!model.initial_velocity.empty() && !model.initial_velocity[plane.block].isZero(0))
        ignored.emplace_back("initial velocities");
    return ignored;
}

double simulated_slip(const State& state, const BlockOnPlane& plane) {
    const auto moved = [&](BlockIndex block) {
        return Vec2(state.blocks.centroid(block) - state.centroid_origin[block]);
    };
    return (moved(plane.block) - moved(plane.base)).dot(plane.downhill);
}

}  // namespace rockslope::dda
