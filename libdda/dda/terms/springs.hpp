#pragma once

#include <vector>

#include "common/base/thread_pool.hpp"
#include "dda/contact/contact.hpp"
#include "dda/terms/system.hpp"

namespace rockslope::dda {

/// A component of the relative displacement of two blocks, linear in their unknowns: the displacement of a
/// point of the first block along a direction, less that of a point of the second. BlockPair holds the
/// points.
struct RelativeMeasure {
    Vec2 direction = Vec2::Zero();
    double prescribed = 0;  ///< m, contribution of blocks without unknowns

    /// @param relative_displacement see BlockPair.
    double at(const Vec2& relative_displacement) const {
        return prescribed + direction.dot(relative_displacement);
    }
};

/// Two blocks connected by springs: their rows and the points to which the springs are attached. Gradients
/// are computed from arm and direction on each call: this reads less than half the memory that stored
/// gradients would need.
struct BlockPair {
    RowIndex first = RowIndex::none();   ///< row of the first block, or -1
    RowIndex second = RowIndex::none();  ///< row of the second block, or -1
    Vec2 first_arm = Vec2::Zero();       ///< m, from the centroid of the first block to its point
    Vec2 second_arm = Vec2::Zero();      ///< m, from the centroid of the second block to its point

    /// Gradient of a measure with respect to the unknowns of the first or second block.
    Vec6 gradient_first(const RelativeMeasure& relative) const {
        return project(relative.direction, first_arm);
    }
    Vec6 gradient_second(const RelativeMeasure& relative) const {
        return -project(relative.direction, second_arm);
    }

    /// The generalised force on the unknowns of a row. `force` acts on the first point, its reaction on the
    /// second.
    Vec6 project_on_row(RowIndex row, const Vec2& force) const {
        return row == first ? project(force, first_arm) : Vec6(-project(force, second_arm));
    }

    /// The displacement of the first point less that of the second, m; blocks without unknowns count as zero.
    Vec2 relative_displacement(RowSpan<const Vec6> d) const {
        Vec2 sum = Vec2::Zero();
        if (first.exists()) sum += displacement_at(first_arm, d[first]);
        if (second.exists()) sum -= displacement_at(second_arm, d[second]);
        return sum;
    }
    /// The opening or the shear displacement, Eq. (20), m, with the part that is prescribed.
    double measure(const RelativeMeasure& relative, RowSpan<const Vec6> d) const {
        return relative.at(relative_displacement(d));
    }
    /// Adds the generalised forces of a force along the measure's direction to the load.
    void add_force(const RelativeMeasure& relative, double force, RowSpan<Vec6> load) const;
};

/// The normal and shear spring of a contact, on the relative displacement of its corner and its edge.
struct ContactSprings {
    BlockPair rows;
    RelativeMeasure normal;       ///< along the contact normal at mid-step, opening positive
    RelativeMeasure shear;        ///< along the contact tangent at mid-step
    NormalClosure normal_law;     ///< law of the normal spring
    double normal_stiffness = 0;  ///< N/m per metre, tangent of the normal law at the start of the step
    double shear_stiffness = 0;   ///< N/m per metre
};

/// The springs of all contacts. @param prescribed displacement of the step, per block; used for blocks
/// without unknowns.
PerContact<ContactSprings> contact_springs(const Model& model, const RowMap& rows, const MidStep& mid,
                                           BlockSpan<const Vec6> prescribed,
                                           ContactSpan<const Contact> contacts, const ThreadPool& pool);

/// The axial spring of a bolt.
struct BoltSpring {
    BlockPair rows;
    RelativeMeasure elongation;
    double stiffness = 0;  ///< N/m per metre
};

/// The springs of all bolts, along the bolt at mid-step. @param prescribed displacement of the step, per
/// block.
std::vector<BoltSpring> bolt_springs(const Model& model, const RowMap& rows, const MidStep& mid,
                                     BlockSpan<const Vec6> prescribed);

/// The largest stiffness of a contact spring, N/m per metre; 0 without contacts.
double max_spring_stiffness(ContactSpan<const ContactSprings> springs);

}  // namespace rockslope::dda
