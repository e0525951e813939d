#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <variant>

#include "dda/joint/barton_bandis.hpp"
#include "dda/joint/bilinear.hpp"
#include "dda/joint/continuously_yielding.hpp"
#include "dda/joint/cyclic_barton_bandis.hpp"
#include "dda/joint/elastic.hpp"
#include "dda/joint/mohr_coulomb.hpp"
#include "dda/joint/normal_closure.hpp"
#include "dda/joint/plesha.hpp"
#include "dda/joint/stressed_asperities.hpp"
#include "dda/joint/two_order_asperities.hpp"
#include "dda/joint/velocity_weakening.hpp"
#include "dda/joint/weakening.hpp"

namespace rockslope::dda {

/// The list of joint laws: a new law is one file in this folder and one word here. A law must have `fresh`,
/// `strength` and `advance`; it may have a `strength` that looks at the displacement being tried, and
/// `strength_slope`, `dilation`, `shear_stiffness` and `record`. The functions below find out which.
using JointLaw =
    std::variant<MohrCoulomb, Elastic, BartonBandis, CyclicBartonBandis, Weakening, Bilinear, Plesha,
                 TwoOrderAsperities, StressedAsperities, VelocityWeakening, ContinuouslyYielding>;

namespace detail {
template <class... Laws>
std::variant<typename Laws::History...> histories_of(const std::variant<Laws...>&);
}
/// What a joint remembers: the alternative has the same index as its law in JointLaw.
using JointHistory = decltype(detail::histories_of(std::declval<JointLaw>()));

/// The history of a joint that has not moved yet. @param intact false for a contact between faces that met
/// later: it bears neither cohesion nor tension.
JointHistory fresh_history(const JointLaw& law, bool intact);
/// What the joint can bear now, or at the end of the displacement tried. @param normal_force N per metre,
/// compression positive; @param length m.
Strength strength(const JointLaw& law, const JointHistory& history, double normal_force, double length,
                  const ShearTrial& trial = {});
/// The history after an accepted step.
JointHistory advance(const JointLaw& law, const JointHistory& history, const ContactMotion& motion);

/// Derivative of the strengths of a joint at rest with respect to the normal force, dimensionless, if the law
/// offers it.
std::optional<Strength> strength_slope(const JointLaw& law, const JointHistory& history, double normal_force,
                                       double length);
/// m, by which shearing has moved the faces apart: the rest gap of the normal spring. 0 for laws without.
double dilation(const JointLaw& law, const JointHistory& history);
/// N/m per metre, the stiffness of the shear spring that the law prescribes to a contact; 0: none.
double shear_stiffness(const JointLaw& law, const JointHistory& history, double normal_force, double length);
JointRecord record(const JointLaw& law, const JointHistory& history);
/// Whether the history is that of a pair of faces, shared by the contacts at their ends; other laws keep one
/// at each contact.
bool has_segment_history(const JointLaw& law);
/// Whether shearing may move the faces apart.
bool dilates(const JointLaw& law);

/// A joint material of the model file: its law and, where given, springs of its own.
struct JointMaterial {
    std::string name;
    JointLaw law;
    double normal_penalty = 0;  ///< N/m per metre per contact; 0: the analysis' value
    double shear_penalty = 0;   ///< likewise
    /// Stiffness of the joint itself, Pa/m: a contact's spring is this times its length, Eq. (43). 0: the
    /// penalty.
    double normal_stiffness = 0;
    double shear_stiffness = 0;  ///< likewise
    /// m, the length that a contact is given at least where the joint has a stiffness of its own: corners on
    /// faces share no length. Normally a hundredth of a block; the smaller, the deeper corners sink in.
    double corner_length = 0.01;
    /// m, by which a joint with a stiffness of its own closes at most; 0: without a limit, linear.
    double largest_closure = 0;

    /// A contact's normal spring, with its stiffness in N/m per metre. @param analysis_value the penalty of
    /// the analysis; @param length m, the contact's share of the joint.
    NormalClosure normal_spring(double analysis_value, double length) const {
        if (normal_stiffness > 0)
            return {normal_stiffness * std::max(length, corner_length), largest_closure};
        return {normal_penalty > 0 ? normal_penalty : analysis_value, 0};
    }
    /// @param law_stiffness what `dda::shear_stiffness` says: it goes behind the material's and before the
    /// analysis'.
    double shear_spring(double analysis_value, double length, double law_stiffness = 0) const {
        if (shear_stiffness > 0) return shear_stiffness * std::max(length, corner_length);
        if (shear_penalty > 0) return shear_penalty;
        return law_stiffness > 0 ? law_stiffness : analysis_value;
    }
};

}  // namespace rockslope::dda
