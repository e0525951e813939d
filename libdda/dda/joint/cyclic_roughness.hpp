#pragma once

#include "dda/joint/cyclic_barton_bandis.hpp"

namespace rockslope::dda {

/// Mobilised roughness of a cyclic joint: the tables of Eqs. (63) and (64) by the side of the origin, the
/// direction of motion, the cycle, and the previous wear.
class CyclicRoughness {
  public:
    struct Place {
        double distance;  ///< m, from the origin
        int side;         ///< of the origin: 1 forward, -1 backward
        bool away;        ///< moving away from the origin
    };

    /// @param history kept by reference: later changes of it apply.
    CyclicRoughness(const CyclicBartonBandis& law, const CyclicBartonBandis::History& history)
        : law_(law), history_(history) {}

    /// Whether the joint has not slipped yet.
    bool is_fresh() const { return history_.forward == 0; }
    /// Whether the joint has neither slipped nor opened: locked, it dilates and contracts on one curve.
    bool is_intact() const { return is_fresh() && history_.opened == 0; }
    /// @param position in the contact's direction of slip, m; @param direction of motion, +1 or -1.
    Place place(double position, int direction) const;
    /// Largest distance from the origin on a side in this cycle, m.
    double furthest(int side) const {
        return side > 0 ? history_.furthest_forward : history_.furthest_backward;
    }
    const RoughnessTable& roughness_table(const Place& place) const;
    /// The table that bounds the shear force.
    const RoughnessTable& bound_table(const Place& place) const;
    /// In the first advance the joint is locked up to the peak displacement. The table applies beyond it, and
    /// to every later advance.
    bool is_before_first_peak(const Place& place, double distance) const {
        const bool first = place.away && history_.furthest_forward < law_.peak_displacement;
        return history_.cycle == 1 && place.side > 0 && (first || is_fresh()) &&
               distance < law_.peak_displacement;
    }
    /// Whether the roughness at this place was worn at a larger distance in this cycle. Healing restores it.
    bool is_worn(const Place& place) const {
        return !law_.heal && place.away && place.distance < furthest(place.side);
    }
    /// Mobilised ratio of the advance at this distance, for either direction of motion.
    double advance_ratio(const Place& place) const;
    /// Mobilised ratio of the first advance at a distance from the origin, without wear.
    double first_advance_ratio(double distance) const;
    static JointStage stage(const Place& place, bool sliding);
    /// Mobilised ratio for the results. @param unloading_ratio of the advance at the last reversal point, or
    /// here if the joint advances.
    double mobilised_ratio(const Place& place, bool sliding, double unloading_ratio) const;
    /// Mobilised ratio that bounds the motion at a distance from the origin, before any wear.
    double unworn_bound_ratio(const Place& place, double distance) const;
    /// Mobilised ratio that bounds the motion, reversals and cycles included.
    double bound_ratio(const Place& place) const;
    /// The nearest distance ahead with a table entry, the limit of the worn part or the origin, m. @param
    /// dilating whether the entries of the dilation's table count.
    double next_knot(const Place& place, bool dilating) const;

  private:
    const CyclicBartonBandis::Cycle& cycle() const;

    const CyclicBartonBandis& law_;
    const CyclicBartonBandis::History& history_;
};

}  // namespace rockslope::dda
