#pragma once

#include "dda/joint/cyclic_barton_bandis.hpp"

namespace rockslope::dda {

/// Which roughness of a cyclic joint is at work where: the tables of Eqs. (63) and (64) by the side of the
/// origin, the way the joint goes there, its cycle, and what it has worn off before.
class CyclicRoughness {
  public:
    struct Place {
        double distance;  ///< m, from the origin
        int side;         ///< of the origin: 1 forward, -1 backward
        bool away;        ///< moving away from the origin
    };

    /// @param history may change meanwhile: what is told is told of the present one.
    CyclicRoughness(const CyclicBartonBandis& law, const CyclicBartonBandis::History& history)
        : law_(law), history_(history) {}

    /// Whether the joint has not slipped yet.
    bool is_fresh() const { return history_.forward == 0; }
    /// @param position in the contact's direction of slip, m; @param direction of motion, +1 or -1.
    Place place(double position, int direction) const;
    /// m, how far from the origin the joint has been in this cycle.
    double furthest(int side) const {
        return side > 0 ? history_.furthest_forward : history_.furthest_backward;
    }
    const RoughnessTable& roughness_table(const Place& place) const;
    /// The one that bounds the shear force.
    const RoughnessTable& bound_table(const Place& place) const;
    /// On the first way out the joint is locked up to the peak, and the table counts from there.
    bool is_before_first_peak(const Place& place, double distance) const {
        return history_.cycle == 1 && place.side > 0 && (place.away || is_fresh()) &&
               distance < law_.peak_displacement;
    }
    /// Whether roughness was worn off further out in this cycle, which is not there again unless the joint
    /// heals.
    bool is_worn(const Place& place) const {
        return !law_.heal && place.away && place.distance < furthest(place.side);
    }
    /// Of the way out, whichever way the joint goes.
    double advance_ratio(const Place& place) const;
    static JointStage stage(const Place& place, bool sliding);
    /// Ratio that the results tell where the joint has moved to. @param unloading_ratio of the advance where
    /// it turned round last, or here if it advances.
    double mobilised_ratio(const Place& place, bool sliding, double unloading_ratio) const;
    /// Mobilised ratio that bounds the motion, reversals and cycles included.
    double bound_ratio(const Place& place) const;
    /// m, the nearest distance ahead at which a table bends, a cap ends, or the origin lies. @param dilating
    /// whether the table of the dilation counts.
    double next_knot(const Place& place, bool dilating) const;

  private:
    const CyclicBartonBandis::Cycle& cycle() const;

    const CyclicBartonBandis& law_;
    const CyclicBartonBandis::History& history_;
};

}  // namespace rockslope::dda
