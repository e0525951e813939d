#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <variant>

#include "dda/joint/joint_law_contract.hpp"
#include "dda/joint/joint_law_list.hpp"
#include "dda/joint/normal_closure.hpp"

namespace rockslope::dda {

// JointLaw is the std::variant of all joint laws. A law is one file in this folder, which fulfils
// JointLawContract, and one line in joint_laws.txt; CMake writes joint_law_list.hpp from it.

namespace detail {
template <class... Laws>
std::variant<typename CheckedJointLaw<Laws>::History...> histories_of(const std::variant<Laws...>&);
}
/// History of a joint: the alternative has the same index as its law in JointLaw.
using JointHistory = decltype(detail::histories_of(std::declval<JointLaw>()));

// The functions of JointLawContract for any law of the list; see there.

/// History of a joint that has not moved yet. @param intact false for a contact between faces that met later:
/// it has neither cohesion nor tensile strength.
JointHistory fresh_history(const JointLaw& law, bool intact);
/// Strength at the end of the trial displacement. @param normal_force N per metre, compression positive;
/// @param length m.
Strength strength(const JointLaw& law, const JointHistory& history, double normal_force, double length,
                  const ShearTrial& trial = {});
/// History after an accepted step. A joint segment without a normal force is open, and flies.
JointHistory advance(const JointLaw& law, const JointHistory& history, const ContactMotion& motion);

/// Derivative of the strengths of a joint at rest with respect to the normal force, dimensionless, if the law
/// has it.
std::optional<Strength> strength_slope(const JointLaw& law, const JointHistory& history, double normal_force,
                                       double length);
/// Shear strength as a straight line over the normal force, if it is one.
std::optional<CoulombLine> bound_line(const JointLaw& law, const JointHistory& history);
/// Peak and residual line of a law with Coulomb strength.
std::optional<CoulombEnvelope> coulomb_envelope(const JointLaw& law);
/// Opening of the joint by shearing, m: a change of the stress-free gap of the normal spring.
double dilation(const JointLaw& law, const JointHistory& history);
/// How the shear force of the locked joint follows its normal force, Eq. (77).
LockedDilation locked_dilation(const JointLaw& law, const JointHistory& history);
/// Stiffness of the shear spring that the law gives a contact, N/m per metre; 0: none.
double shear_stiffness(const JointLaw& law, const JointHistory& history, double normal_force, double length);
/// What the results contain of a history: stage, mobilised roughness, dilation and reversals.
JointRecord record(const JointLaw& law, const JointHistory& history);
/// Whether the contacts of a joint segment share one history; otherwise each contact has its own.
bool has_segment_history(const JointLaw& law);
/// Whether a joint may have a shear strength without a normal force, intact or broken.
bool has_cohesion(const JointLaw& law);
/// Whether shearing may open or close the joint.
bool dilates(const JointLaw& law);
/// Whether plastic slip alone opens or closes the joint.
bool dilates_with_slip(const JointLaw& law);

/// A joint material of the model file: its law and its springs.
struct JointMaterial {
    std::string name;
    JointLaw law;
    double normal_penalty = 0;  ///< N/m per metre per contact; 0: the value of the analysis
    double shear_penalty = 0;   ///< N/m per metre per contact; 0: the value of the law or of the analysis
    /// Stiffness of the joint itself, Pa/m: a contact's spring is this times its length, Eq. (43). 0: the
    /// penalty.
    double normal_stiffness = 0;
    double shear_stiffness = 0;  ///< Pa/m, as the normal stiffness
    /// m, smallest contact length for a joint with its own stiffness: a vertex on a face has no length.
    /// Normally 1/100 of a block; a smaller value lets vertices penetrate more.
    double corner_length = 0.01;
    /// m, limit of the closure of a joint with its own stiffness, Eq. (44); 0: no limit, linear.
    double largest_closure = 0;
    /// Damping ratio of a dashpot beside the normal spring in dynamic stages, Eq. (86), a fraction of
    /// critical; 0: none. It sets the restitution of an impact, Eq. (89).
    double contact_damping = 0;

    /// A contact's normal spring, Eqs. (43) and (44), with its stiffness in N/m per metre. @param
    /// analysis_value the penalty of the analysis; @param length m, of the contact.
    NormalClosure normal_spring(double analysis_value, double length) const {
        if (normal_stiffness > 0)
            return {normal_stiffness * std::max(length, corner_length), largest_closure};
        return {normal_penalty > 0 ? normal_penalty : analysis_value, 0};
    }
    /// Whether the model gives the shear spring, which then takes the place of the law's.
    bool has_shear_spring() const { return shear_stiffness > 0 || shear_penalty > 0; }
    /// Stiffness of a contact's shear spring, N/m per metre. The material's value takes precedence over the
    /// law's, and that over the analysis'. @param law_stiffness the value of `dda::shear_stiffness`.
    double shear_spring(double analysis_value, double length, double law_stiffness = 0) const {
        if (shear_stiffness > 0) return shear_stiffness * std::max(length, corner_length);
        if (shear_penalty > 0) return shear_penalty;
        return law_stiffness > 0 ? law_stiffness : analysis_value;
    }
};

}  // namespace rockslope::dda
