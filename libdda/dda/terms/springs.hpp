#pragma once

#include <span>
#include <vector>

#include "dda/base/parallel.hpp"
#include "dda/contact/contact.hpp"
#include "dda/terms/system.hpp"

namespace dda {

/// A scalar measure of the relative displacement of two blocks, linear in their unknowns: first^T d_i +
/// second^T d_j + known, where `known` is the share of blocks without unknowns.
struct Relative {
    Vec6 first = Vec6::Zero();
    Vec6 second = Vec6::Zero();
    double known = 0;
};

/// The springs between two blocks work on measures of their relative displacement; this is the pair and its
/// rows.
struct PairRows {
    int first = -1;   ///< row of the first block, or -1
    int second = -1;  ///< row of the second block, or -1

    double measure(const Relative& relative, std::span<const Vec6> d) const;
    /// Adds a force that works on the measure.
    void add_force(const Relative& relative, double force, std::span<Vec6> load) const;
};

/// A contact as the equations see it: normal and tangential displacement of its corner relative to its edge.
struct ContactSprings {
    PairRows rows;
    Relative normal;              ///< along the contact's normal at mid-step: opening positive
    Relative shear;               ///< along its tangent at mid-step
    NormalClosure closing;        ///< the normal spring
    double normal_stiffness = 0;  ///< N/m per metre, of the normal spring at the step's start
    double shear_stiffness = 0;   ///< N/m per metre
};

/// @param prescribed displacement of the step, per block; used for blocks without unknowns.
std::vector<ContactSprings> contact_springs(const Model& model, const RowMap& rows, const MidStep& mid,
                                            std::span<const Vec6> prescribed,
                                            std::span<const Contact> contacts, const Crew& crew);

/// A bolt as the equations see it: the elongation of the bar.
struct BoltSpring {
    PairRows rows;
    Relative elongation;
    double stiffness = 0;  ///< N/m per metre
};

std::vector<BoltSpring> bolt_springs(const Model& model, const RowMap& rows, const MidStep& mid,
                                     std::span<const Vec6> prescribed);

/// The largest stiffness of contacts' springs, N/m per metre; 0 without contacts.
double stiffest_spring(std::span<const ContactSprings> springs);

}  // namespace dda
