#pragma once

#include "dda/joint/joint_types.hpp"

namespace rockslope::dda {

/// A joint that neither opens nor slips, Eq. (45): only its springs give. With the joint's own normal and
/// shear stiffness it is the linear displacement discontinuity of wave studies [pyraknolte1990]; with stiff
/// springs it glues blocks together. Faces that meet later in the run have no glue: they part freely, and
/// stick without slip while pressed. Limit: tension has no bound, so it is no model of rock that could fail.
struct Elastic {
    static constexpr const char* name = "elastic";

    struct History {
        bool bonded = false;
        friend bool operator==(const History&, const History&) = default;
    };

    History fresh(bool intact) const { return {intact}; }
    Strength strength(const History& history, double normal_force, double length) const;
    /// Nothing wears.
    History advance(const History& history, const ContactMotion&) const { return history; }
};

}  // namespace rockslope::dda
