#pragma once

#include <cstdint>
#include <vector>

#include "dda/joint/barton.hpp"
#include "dda/joint/joint_types.hpp"
#include "dda/joint/peak_spring.hpp"
#include "dda/joint/roughness_table.hpp"

namespace rockslope::dda {

/// A rough joint that wears in cyclic shearing, Eqs. (63) to (66): Barton's strength, Eq. (57), with a
/// mobilised roughness that depends on the side of the origin, on whether the joint moves away from it or
/// back, on the cycle and on the reversals so far. Source: Ma et al. (2017) after Jing et al. (1993); theory
/// sec. 15 states what they leave open. Forward is the direction of the first slip.
///
/// The dilation angle is that of the normal stress at which the spring was found, Eq. (58); the strength is
/// that of the present one. Until the first slip the joint dilates and contracts on one curve. Limits: a
/// joint that returns contracts more than it dilated before, unless `floor_dilation` is set.
struct CyclicBartonBandis {
    static constexpr const char* name = "cyclic-barton-bandis";
    static constexpr HistoryScope history_scope = HistoryScope::joint_segment;

    /// Mobilised over peak roughness of one cycle, over the distance from the origin on either side. In the
    /// return tables it is negative where the asperities help the joint back.
    struct Cycle {
        RoughnessTable forward_advance;
        RoughnessTable forward_return;
        RoughnessTable backward_advance;
        RoughnessTable backward_return;
    };

    BartonStrength barton;
    double peak_displacement = 0;     ///< m, positive
    std::vector<Cycle> cycles;        ///< at least one; further cycles are like the last
    double further_cycle_factor = 1;  ///< on the ratios, for each cycle beyond the last given
    double reversal_factor = 1;       ///< on the ratios, for each change of the slip direction
    double min_slip = 1e-4;           ///< m, slip in the other direction that counts as a reversal
    bool heal = false;                ///< roughness worn in an excursion is restored for the next advance
    bool unsigned_ratios = false;     ///< ratios are magnitudes and resist every motion
    bool asymmetric = false;          ///< with unsigned_ratios: roughness resists forward motion only
    double damage = 0;                ///< M of Eq. (60), 1 to 2; 0: no dilation
    bool floor_dilation = false;      ///< the dilation is never negative
    double contact_length = 0;        ///< m, for the stress of Eq. (57); 0: the contact's present length

    struct History {
        double position = 0;           ///< m, in the contact's positive tangential direction
        double furthest_forward = 0;   ///< m, distance from the origin in this cycle
        double furthest_backward = 0;  ///< m
        double unloading_ratio = 0;    ///< of the advance at the last reversal point
        double mobilised_ratio = 0;    ///< as in JointRecord
        double dilation = 0;           ///< m
        double locked_slope = 0;       ///< derivative of the dilation while the joint is locked
        double reverse_slip = 0;       ///< m, against slip_direction, since the last slip along it
        double reversal_slip = 0;      ///< m, of the last reversal, up to the first slip against it; then 0
        PeakSpring spring;
        double wear = 1;           ///< f of Eq. (63), by the reversals and cycles below
        std::int64_t crossed = 0;  ///< sign of the shear force with which the joint crossed its origin
                                   ///< locked, and still stands there, Eq. (82); 0: it did not
        std::int64_t opened = 0;   ///< 1 once the joint has been open after bearing a force: its spring is
                                   ///< released, and it no longer dilates and contracts on one curve
        std::int32_t cycle = 1;
        std::int32_t reversals = 0;
        std::int32_t forward = 0;         ///< sign of the first slip; 0 before it
        std::int32_t slip_direction = 0;  ///< sign of the slip that reversals are counted from
        std::int32_t stage = 0;    ///< JointStage; an integer, for the bytes are written to checkpoints
        std::int32_t sliding = 0;  ///< in the last displacement
        friend bool operator==(const History&, const History&) = default;
    };

    static constexpr NoCommonHistories<History> common_histories() { return {}; }

    static CyclicBartonBandis read(const ParameterTable& table);
    Dilates dilates() const { return damage > 0 ? Dilates::with_displacement : Dilates::never; }
    std::optional<CoulombEnvelope> coulomb_envelope() const { return std::nullopt; }
    History fresh(bool) const { return {}; }
    /// @param trial with stiffness 0, only the strengths at the end of the displacement are exact.
    Strength strength(const History& history, double normal_force, double length,
                      const ShearTrial& trial) const;
    Strength strength_slope(const History& history, double normal_force, double length) const;
    std::optional<CoulombLine> bound_line(const History&) const { return std::nullopt; }
    /// @param motion with stiffness 0, the whole displacement counts as sliding if there was slip.
    History advance(const History& history, const ContactMotion& motion) const;
    /// A joint that has not slipped stays so up to its peak displacement: its asperities still match.
    History fly(const History& history, const ContactMotion& motion) const;
    /// Eq. (58), for a part of the joint with this length. @param normal_force used only if the joint has not
    /// been loaded yet.
    double shear_stiffness(const History& history, double normal_force, double length) const;
    LockedDilation locked_dilation(const History& history) const;
    JointRecord record(const History& history) const;

    /// Length that the stress is computed with, m.
    double stressed_length(double length) const { return contact_length > 0 ? contact_length : length; }

  private:
    /// The history after a motion with the spring of `loaded`.
    History displaced(History loaded, const ContactMotion& motion) const;
};

}  // namespace rockslope::dda
