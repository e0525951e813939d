#include "dda/monitor/blocks_on_planes.hpp"

#include <algorithm>
#include <cmath>

#include "dda/analysis/base_motion.hpp"

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
    reduce(model.strength_reduction, plane.peak);
    reduce(model.strength_reduction, plane.residual);
    const Vec2 along(normal.y(), -normal.x());
    const double fall = along.dot(model.gravity) / model.gravity.norm();
    const bool is_level = std::abs(fall) < level;
    plane.downhill = (is_level ? along.x() : fall) < 0 ? Vec2(-along) : along;
    plane.dip = std::acos(std::clamp(-normal.dot(model.gravity.normalized()), -1.0, 1.0));
    return true;
}

/// Body acceleration of a rigid block in the frame of its base, m/s2.
Vec2 body_acceleration_at(const Model& model, const Stage& stage, const BlockOnPlane& plane,
                          double stage_time, double dynamic_time) {
    Vec2 field = model.gravity - frame_acceleration(stage, stage_time) -
                 base_acceleration(model, stage, plane.base, stage_time);
    for (const Load& load : model.loads) {
        const auto* body = std::get_if<BodyLoad>(&load);
        if (body != nullptr && (body->block < 0 || body->block == plane.block))
            field += body->history.at(dynamic_time) * body->acceleration;
    }
    return field;
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

/// At yield under the acceleration k g: g sin + k g cos = mu (g cos - k g sin) + adhesion.
double yield_coefficient(const BlockOnPlane& plane, double gravity) {
    const double sine = std::sin(plane.dip), cosine = std::cos(plane.dip);
    return (plane.peak.friction * cosine - sine + plane.peak.adhesion / gravity) /
           (cosine + plane.peak.friction * sine);
}

double rigid_slip(const Model& model, std::span<const Stage> stages, const BlockOnPlane& plane,
                  double dynamic_time) {
    record::RigidSlider block(plane.peak, plane.residual);
    const Vec2 down = plane_inward_normal(plane, model.gravity);
    double stage_start = 0;  // s of dynamic time
    for (const Stage& stage : stages) {
        if (stage.kind != StageKind::dynamic) continue;
        const double length = std::min(stage.duration, dynamic_time - stage_start);
        if (!(length > 0)) break;
        const auto steps = static_cast<std::int64_t>(std::ceil(length / record::max_sliding_substep));
        const double dt = length / static_cast<double>(steps);
        for (std::int64_t k = 0; k < steps; ++k) {
            const double time = (static_cast<double>(k) + 0.5) * dt;
            const Vec2 field = body_acceleration_at(model, stage, plane, time, stage_start + time);
            block.advance(field.dot(plane.downhill), field.dot(down), dt);
        }
        stage_start += stage.duration;
    }
    return block.slip();
}

double simulated_slip(const State& state, const BlockOnPlane& plane) {
    const auto moved = [&](BlockIndex block) {
        return Vec2(state.blocks.centroid(block) - state.centroid_origin[block]);
    };
    return (moved(plane.block) - moved(plane.base)).dot(plane.downhill);
}

}  // namespace rockslope::dda
