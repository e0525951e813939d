#pragma once

#include <span>
#include <vector>

#include "common/base/thread_pool.hpp"
#include "dda/contact/contact.hpp"
#include "dda/terms/system.hpp"

namespace rockslope::dda {

/// A scalar measure of the relative displacement of two blocks, linear in their unknowns: the displacement of
/// a point of the first along a direction, less that of a point of the second, see BlockPair.
struct RelativeMeasure {
    Vec2 direction = Vec2::Zero();
    double prescribed = 0;  ///< m, the share of blocks without unknowns

    /// @param relative_displacement see BlockPair.
    double at(const Vec2& relative_displacement) const {
        return prescribed + direction.dot(relative_displacement);
    }
};

/// The springs between two blocks work on measures of their relative displacement; this is the pair, the
/// points that the springs are fastened to and the pair's rows. Gradients are made of arm and direction each
/// time: that reads less than half of what keeping them would.
struct BlockPair {
    int first = -1;                  ///< row of the first block, or -1
    int second = -1;                 ///< row of the second block, or -1
    Vec2 first_arm = Vec2::Zero();   ///< m, from the first block's centroid to its point
    Vec2 second_arm = Vec2::Zero();  ///< likewise

    /// Gradients of a measure with respect to the blocks' unknowns.
    Vec6 gradient_first(const RelativeMeasure& relative) const {
        return project(relative.direction, first_arm);
    }
    Vec6 gradient_second(const RelativeMeasure& relative) const {
        return -project(relative.direction, second_arm);
    }

    /// What a force between the two points, along its direction on the first, is in a row's unknowns.
    Vec6 project_on_row(int row, const Vec2& force) const {
        return row == first ? project(force, first_arm) : Vec6(-project(force, second_arm));
    }

    /// The displacement of the first block's point less that of the second's, m, of blocks with unknowns.
    Vec2 relative_displacement(std::span<const Vec6> d) const {
        Vec2 sum = Vec2::Zero();
        if (first >= 0) sum += displacement_at(first_arm, d[static_cast<std::size_t>(first)]);
        if (second >= 0) sum -= displacement_at(second_arm, d[static_cast<std::size_t>(second)]);
        return sum;
    }
    double measure(const RelativeMeasure& relative, std::span<const Vec6> d) const {
        return relative.at(relative_displacement(d));
    }
    /// Adds a force that works on the measure.
    void add_force(const RelativeMeasure& relative, double force, std::span<Vec6> load) const;
};

/// A contact as the equations see it: normal and tangential displacement of its corner relative to its edge.
struct ContactSprings {
    BlockPair rows;
    RelativeMeasure normal;       ///< along the contact's normal at mid-step: opening positive
    RelativeMeasure shear;        ///< along its tangent at mid-step
    NormalClosure normal_law;     ///< the normal spring
    double normal_stiffness = 0;  ///< N/m per metre, of the normal spring at the step's start
    double shear_stiffness = 0;   ///< N/m per metre
};

/// @param prescribed displacement of the step, per block; used for blocks without unknowns.
std::vector<ContactSprings> contact_springs(const Model& model, const RowMap& rows, const MidStep& mid,
                                            std::span<const Vec6> prescribed,
                                            std::span<const Contact> contacts, const ThreadPool& pool);

/// A bolt as the equations see it: the elongation of the bar.
struct BoltSpring {
    BlockPair rows;
    RelativeMeasure elongation;
    double stiffness = 0;  ///< N/m per metre
};

std::vector<BoltSpring> bolt_springs(const Model& model, const RowMap& rows, const MidStep& mid,
                                     std::span<const Vec6> prescribed);

/// The largest stiffness of contacts' springs, N/m per metre; 0 without contacts.
double max_spring_stiffness(std::span<const ContactSprings> springs);

}  // namespace rockslope::dda
