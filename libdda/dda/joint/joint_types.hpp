#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>  // IWYU pragma: export

namespace rockslope::dda {

class ParameterTable;

/// -1, 0 or 1.
inline int sign_of(double value) {
    return value > 0 ? 1 : value < 0 ? -1 : 0;
}

/// How the shear force of a locked joint follows its normal force N, Eq. (77): S = f + (N - N_ref) t, with
/// the force f of its spring, and t the derivative of its dilation with respect to its displacement.
struct LockedDilation {
    double slope = 0;            ///< t, positive where the joint opens in forward motion
    double reference_force = 0;  ///< N_ref of the joint, N per metre; 0 once the joint has slipped

    /// The second term of Eq. (77), N per metre. @param normal_force N per metre, on a part of the joint;
    /// @param share of that part in the joint, 0 to 1.
    double shear_force(double normal_force, double share) const {
        return (normal_force - reference_force * share) * slope;
    }
    /// The energy that the spring stores, Eq. (78), J per metre. @param spring_force f, N per metre; @param
    /// stiffness N/m per metre; @param dilation m.
    double stored_energy(double spring_force, double stiffness, double dilation, double share) const {
        return spring_force * spring_force / (2 * stiffness) - reference_force * share * dilation;
    }
};

/// The locked dilation at the end of a displacement: only a joint that had not slipped before changes its
/// slope while it is locked. @param before and after the displacement, by the law.
inline LockedDilation after_displacement(const LockedDilation& before, const LockedDilation& after) {
    if (after.reference_force > 0) return after;
    return before.reference_force > 0 ? LockedDilation{after.slope, before.reference_force} : before;
}

/// How shearing opens or closes a joint.
enum class Dilates : std::uint8_t {
    never,
    with_displacement,  ///< also while the joint is locked
    with_slip           ///< only with plastic slip
};

/// Which contacts one history of a joint law covers.
enum class HistoryScope : std::uint8_t {
    contact,       ///< each contact has its own history
    joint_segment  ///< the contacts at both ends of two faces on each other share one history
};

/// Strength of a joint at a contact, N per metre of thickness; no component is negative.
struct Strength {
    double forward = 0;   ///< largest shear force against slip in the positive tangential direction
    double backward = 0;  ///< largest shear force against slip in the negative tangential direction
    double tensile = 0;   ///< largest tensile normal force before the contact opens

    friend Strength operator*(double factor, const Strength& s) {
        return {factor * s.forward, factor * s.backward, factor * s.tensile};
    }
};

/// How the shear strengths of a joint grow with a shear displacement in their direction, N/m per metre.
struct Hardening {
    double forward = 0;
    double backward = 0;

    /// Whether a strength grows.
    bool any() const { return forward > 0 || backward > 0; }
    friend Hardening operator*(double factor, const Hardening& h) {
        return {factor * h.forward, factor * h.backward};
    }
};

/// A shear strength that is a straight line over the normal stress, Eq. (31): tau = c + sigma_n tan(phi).
struct CoulombLine {
    double friction = 0;            ///< tan(phi)
    double cohesion = 0;            ///< c, Pa
    bool holds_in_tension = false;  ///< the line continues below zero normal force, down to zero strength

    /// Shear strength by Eq. (31), N per metre. @param normal_force N per metre, compression positive; @param
    /// length m.
    double strength(double normal_force, double length) const {
        const double effective_force = holds_in_tension ? normal_force : std::max(normal_force, 0.0);
        return std::max(effective_force * friction + cohesion * length, 0.0);
    }
    friend bool operator==(const CoulombLine&, const CoulombLine&) = default;
};

/// The first and the last strength line of a law whose strength falls once, at the first slip or opening.
struct CoulombEnvelope {
    CoulombLine peak;
    CoulombLine residual;
};

/// Return type of `common_histories` for a law whose histories have many different values.
template <class History>
using NoCommonHistories = std::array<History, 0>;

/// The shear spring of a contact at the start of a displacement.
struct ShearSpring {
    double stiffness = 0;  ///< N/m per metre; 0: unknown
    double force = 0;      ///< N per metre
};

/// A trial tangential displacement. A law whose strength depends on the position evaluates it at the end of
/// the displacement; other laws ignore it.
struct ShearTrial {
    double displacement = 0;  ///< total tangential displacement of the step, m, positive forward
    double shear_force = 0;   ///< at the start of the step, N per metre
    double stiffness = 0;     ///< of the shear spring, N/m per metre; 0: unknown
};

/// The time that a step takes. A step of a static stage takes none: its size is pseudo-time.
class StepTime {
  public:
    /// That of a static step: none.
    constexpr StepTime() = default;
    /// That of a dynamic step. @param duration s.
    constexpr explicit StepTime(double duration) : duration_(duration), is_static_(false) {}

    /// s; 0 in a static step.
    constexpr double duration() const { return duration_; }
    /// Whether the step is one of a static stage.
    constexpr bool is_static() const { return is_static_; }

  private:
    double duration_ = 0;
    bool is_static_ = true;
};

/// Motion of a contact during an accepted step.
struct ContactMotion {
    double slip = 0;             ///< plastic tangential slip of the step, m, positive forward
    double displacement = 0;     ///< total tangential displacement of the step, m
    double normal_force = 0;     ///< at the end of the step, N per metre, compression positive
    double length = 0;           ///< the contact's share of the joint, m
    bool opened = false;         ///< the contact was bonded and the bond broke
    double shear_force = 0;      ///< at the start of the step, N per metre
    double stiffness = 0;        ///< of the shear spring, N/m per metre; 0: unknown
    StepTime time = {};          ///< of the step
    bool closing = false;        ///< the contact was open at the start of the step; its cohesion did not act
    bool spring_of_law = false;  ///< the spring is that of the law, not one that the model gives
    bool bond_holds = false;     ///< the slip does not break the bond, see `Stage::bonds_break_at_rest`
};

/// Weight of the first of two contacts in their mean displacement, 0 to 1: the ratio of the shear
/// stiffnesses, or of the lengths where a stiffness is unknown.
double weight_of_first(const ContactMotion& a, const ContactMotion& b);
/// Mean of two displacements, m. @param weight of the first, 0 to 1.
inline double weighted_mean(double first, double second, double weight) {
    return weight * first + (1 - weight) * second;
}
/// Motion of two contacts of one joint segment: forces, lengths and stiffnesses are sums, displacements are
/// means. @param weight of the first contact in the means, `weight_of_first(a, b)`.
ContactMotion combine(const ContactMotion& a, const ContactMotion& b, double weight);

/// Side of the origin on which a joint is, and its motion there. A joint advances away from the origin.
/// Towards the origin, it unloads while locked and returns while sliding.
enum class JointStage : std::uint8_t {
    none,  ///< the law has no stages, or the joint has not moved
    forward_advance,
    forward_unloading,
    forward_return,
    backward_advance,
    backward_unloading,
    backward_return
};

/// Name of a stage in the result tables: "forward advance" and so on.
const char* stage_name(JointStage stage);

/// The slip of a joint since its direction last changed, without slip the other way in between.
struct CounterSlip {
    double amount = 0;     ///< m, so far; 0: there is none, or the joint has slipped the other way since
    double least = 0;      ///< m, the amount above which it is a reversal; 0: reversals do not wear the joint
    bool counted = false;  ///< it has become a reversal
};

/// The part of a joint's history that the results contain. A law leaves the entries that it does not have.
struct JointRecord {
    JointStage stage = JointStage::none;
    double mobilised_ratio = 0;  ///< mobilised over peak roughness, negative where it helps the slip
    double dilation = 0;         ///< m, opening of the joint by shearing; negative: contraction
    int reversals = 0;           ///< changes of slip direction so far
    int cycle = 0;               ///< of shearing, from 1
    CounterSlip counter_slip{};  ///< against the direction that the next reversal is counted from, or of the
                                 ///< last one
};

}  // namespace rockslope::dda
