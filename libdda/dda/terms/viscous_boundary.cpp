#include "dda/terms/viscous_boundary.hpp"

#include <cmath>

#include "dda/terms/face_points.hpp"

namespace rockslope::dda {

namespace {

/// Normal and shear impedance of a face, Eq. (47), Pa s/m: density times wave speed, sqrt(density * modulus).
Vec2 impedance(const Model& model, const ViscousBoundary& boundary, BlockIndex block) {
    const BlockMaterial& rock = model.material_of(block);
    const Mat3 modulus = elasticity(rock, model.plane);
    return {
        boundary.normal_impedance > 0 ? boundary.normal_impedance : std::sqrt(rock.density * modulus(0, 0)),
        boundary.shear_impedance > 0 ? boundary.shear_impedance : std::sqrt(rock.density * modulus(2, 2))};
}

/// normal n n^T + shear t t^T.
Eigen::Matrix2d along_face(const FacePoint& point, double normal, double shear) {
    return normal * point.normal * point.normal.transpose() +
           shear * point.tangent * point.tangent.transpose();
}

/// The stiffness matrix of the springs that hold a point in static stages, N/m per metre.
Eigen::Matrix2d restraint_stiffness(const Model& model, const ViscousBoundary& boundary,
                                    const FacePoint& point) {
    const double k = model.fixed_point_penalty;
    return along_face(point, boundary.hold == Hold::none ? 0 : k, boundary.hold == Hold::both ? k : 0);
}

/// The dashpots of a face, and the motion of the rock beyond it.
struct FaceDashpots {
    Vec2 impedance;              ///< normal and shear, Pa s/m
    const ColumnMotion& column;  ///< beside the face; empty without a free field
    IncidentMotion wave;
};

/// The dashpots of a point: their force on the rock is drive - damping * velocity, N per metre.
struct DashpotForce {
    Eigen::Matrix2d damping = Eigen::Matrix2d::Zero();  ///< N s/m per metre
    Vec2 drive = Vec2::Zero();                          ///< N per metre, by incident wave or free field
};

/// Eq. (48) where waves come in, Eq. (53) beside a free field.
/// @param height of the point, m.
DashpotForce dashpot_force(const Model& model, const ViscousBoundary& boundary, const FaceDashpots& dashpots,
                           const FacePoint& point, double height) {
    DashpotForce force;
    force.damping = point.weight * along_face(point, dashpots.impedance[0], dashpots.impedance[1]);
    if (!boundary.free_field) {
        force.drive = 2 * (force.damping * dashpots.wave.velocity + point.weight * dashpots.wave.traction);
        return force;
    }
    const FieldPoint field = field_at(model, *boundary.free_field, dashpots.column, height);
    const double outward = point.normal.x() < 0 ? -1 : 1;
    force.drive = force.damping * field.velocity + point.weight * outward * field.traction;
    return force;
}

/// Calls visit(boundary, face, index of the face's first reaction).
template <class Visit>
void for_faces(const Model& model, const Visit& visit) {
    std::size_t reaction = 0;
    for (const ViscousBoundary& boundary : model.viscous_boundaries) {
        for (const FacePart& face : boundary.faces) {
            visit(boundary, face, reaction);
            reaction += 2;
        }
    }
}

}  // namespace

BoundaryReactions no_reactions(const Model& model) {
    std::size_t count = 0;
    for (const ViscousBoundary& boundary : model.viscous_boundaries) count += 2 * boundary.faces.size();
    return BoundaryReactions(count, Vec2::Zero());
}

std::vector<BoundaryTerm> boundary_terms(const Model& model, const RowMap& rows, const MidStep& mid,
                                         const StageInstant& end, const BoundaryReactions& reactions,
                                         const FreeFieldMotions& fields) {
    const bool dynamic = !end.stage.is_static();
    std::vector<BoundaryTerm> terms;
    for_faces(model, [&](const ViscousBoundary& boundary, const FacePart& face, std::size_t reaction) {
        const BlockIndex block = model.topology.block_of_edge(face.edge);
        BoundaryTerm term;
        term.row = rows.row_of[block];
        if (!term.row.exists()) return;
        const FaceDashpots dashpots{.impedance = impedance(model, boundary, block),
                                    .column = fields[&boundary - model.viscous_boundaries.data()],
                                    .wave = incident_motion(end, boundary.name)};
        for (const FacePoint& point : face_points(model, mid, face)) {
            const auto t = displacement_matrix(point.arm);
            Vec2 force = reactions[reaction++];
            if (dynamic) {
                const double height = mid.centroid[block].y() + point.arm.y();
                // The dashpots in the equations, Eq. (49).
                const DashpotForce at_point = dashpot_force(model, boundary, dashpots, point, height);
                term.damping += t.transpose() * at_point.damping * t;
                force += at_point.drive;
            } else {
                term.stiffness += t.transpose() * restraint_stiffness(model, boundary, point) * t;
            }
            term.force += t.transpose() * force;
        }
        terms.push_back(term);
    });
    return terms;
}

void add_boundaries(std::span<const BoundaryTerm> terms, const RowMap& rows, const BlockSystem& blocks,
                    const Newmark& newmark, BaseSystem& base) {
    for (const BoundaryTerm& term : terms) {
        const BlockIndex b = rows.block_of[term.row];
        base.stiffness[term.row] += term.stiffness + newmark.velocity_rate() * term.damping;
        base.load[term.row] += term.force - term.damping * newmark.velocity_at_zero_displacement(
                                                               blocks.velocity[b], blocks.acceleration[b]);
    }
}

BoundaryReactions advance_reactions(const Model& model, const MidStep& mid, const Stage& stage,
                                    BlockSpan<const Vec6> displacement, BoundaryReactions reactions) {
    if (!stage.is_static()) return reactions;
    for_faces(model, [&](const ViscousBoundary& boundary, const FacePart& face, std::size_t reaction) {
        for (const FacePoint& point : face_points(model, mid, face)) {
            const Vec2 moved = displacement_matrix(point.arm) * displacement[point.block];
            // The forces of the held face, Eq. (50).
            reactions[reaction++] -= restraint_stiffness(model, boundary, point) * moved;
        }
    });
    return reactions;
}

}  // namespace rockslope::dda
