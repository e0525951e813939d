#pragma once

#include <cstdint>
#include <vector>

#include "dda/joint/barton.hpp"
#include "dda/joint/joint_types.hpp"
#include "dda/joint/peak_spring.hpp"
#include "dda/joint/roughness_table.hpp"

namespace rockslope::dda {

/// A rough joint that is sheared to and fro and wears, Eqs. (63) to (66): Barton's strength, Eq. (57), with a
/// mobilised roughness that depends on the side of the origin, on whether the joint moves away from it or
/// back, on the cycle and on the reversals so far. Source: Ma et al. (2017) after Jing et al. (1993); what
/// they leave open is settled in theory sec. 15. Forward is the direction of the first slip.
///
/// Limits: an open joint remembers where it was, and takes up there wherever it closes again. Contraction
/// while unloading at the rate of the reversal point does not undo the dilation before it, so a joint that
/// dilates and is shaken within its peak displacement sinks, unless `floor_dilation` is set.
struct CyclicBartonBandis {
    static constexpr const char* name = "cyclic-barton-bandis";

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
    double min_slip = 1e-4;           ///< m, by which slip must have gone the other way to count as a change
    bool heal = false;                ///< roughness worn off in an excursion is there again on the way out
    bool unsigned_ratios = false;     ///< the sign of a ratio has no meaning: it resists every motion
    bool asymmetric = false;          ///< with unsigned_ratios: roughness works against forward motion only
    double damage = 0;                ///< M of Eq. (60), 1 to 2; 0: no dilation
    bool floor_dilation = false;      ///< the faces never come closer than they were at first
    double contact_length = 0;        ///< m, for the stress of Eq. (57); 0: the contact's present length

    struct History {
        double position = 0;           ///< m, where the joint is, in the contact's direction of slip
        double furthest_forward = 0;   ///< m, distance from the origin in this cycle
        double furthest_backward = 0;  ///< m
        double unloading_ratio = 0;    ///< of the advance at the last reversal point
        double mobilised_ratio = 0;    ///< as in JointRecord
        double dilation = 0;           ///< m
        double reverse_slip = 0;       ///< m, against slip_direction, since the last slip along it
        PeakSpring spring;
        double wear = 1;  ///< f of Eq. (63), by the reversals and cycles below
        std::int32_t cycle = 1;
        std::int32_t reversals = 0;
        std::int32_t forward = 0;         ///< sign of the first slip; 0 before it
        std::int32_t slip_direction = 0;  ///< sign of the slip that reversals are counted from
        std::int32_t stage = 0;    ///< JointStage; an integer, for the bytes are written to checkpoints
        std::int32_t sliding = 0;  ///< in the last displacement
        friend bool operator==(const History&, const History&) = default;
    };

    History fresh(bool) const { return {}; }
    /// @param trial without a stiffness only the strengths at the end of the displacement are exact.
    Strength strength(const History& history, double normal_force, double length,
                      const ShearTrial& trial) const;
    Strength strength_slope(const History& history, double normal_force, double length) const;
    /// Nothing changes while the joint is open. @param motion without a stiffness, all of the displacement
    /// counts as sliding if there was slip.
    History advance(const History& history, const ContactMotion& motion) const;
    /// Eq. (58), of the part of the joint that has this length. @param normal_force counts for a joint that
    /// has borne nothing yet.
    double shear_stiffness(const History& history, double normal_force, double length) const;
    JointRecord record(const History& history) const;

    /// m, that the stress is computed with.
    double stressed_length(double length) const { return contact_length > 0 ? contact_length : length; }
};

}  // namespace rockslope::dda
