#pragma once

#include <algorithm>
#include <cmath>

#include "dda/joint/barton.hpp"
#include "dda/joint/joint_types.hpp"
#include "dda/joint/peak_spring.hpp"
#include "dda/joint/roughness_table.hpp"

namespace rockslope::dda {

/// Barton-Bandis for shearing in one direction: Eq. (57) with the mobilised roughness of Eq. (59) at the
/// largest distance from the origin so far. With a damage coefficient the joint dilates, Eq. (60). Source:
/// Barton and Bandis (1982), Barton (1985). Limit: a joint that is sheared back keeps the strength of the
/// farthest point in both directions, and contracts with its spring only; use the cyclic law there.
struct BartonBandis {
    static constexpr const char* name = "barton-bandis";
    static constexpr HistoryScope history_scope = HistoryScope::joint_segment;

    BartonStrength barton;
    double peak_displacement = 0;  ///< m, at which peak roughness is mobilised; 0: always
    RoughnessTable mobilisation;   ///< unused without a peak displacement
    bool from_zero_angle = false;  ///< the table's first entry is a total angle of zero, as in Barton (1985)
    double damage = 0;             ///< M of Eq. (60), 1 to 2; 0: no dilation

    struct History {
        double position = 0;      ///< m, displacement from the fresh joint's position
        double furthest = 0;      ///< m, largest distance from there
        double dilation = 0;      ///< m
        double ratio = 0;         ///< mobilised over peak roughness
        double locked_slope = 0;  ///< derivative of the dilation while the joint is locked
        double slipped = 0;       ///< m, plastic slip so far, either way
        PeakSpring spring;
        friend bool operator==(const History&, const History&) = default;
    };

    static constexpr NoCommonHistories<History> common_histories() { return {}; }

    static BartonBandis read(const ParameterTable& table);
    Dilates dilates() const { return damage > 0 ? Dilates::with_displacement : Dilates::never; }
    std::optional<CoulombEnvelope> coulomb_envelope() const { return std::nullopt; }
    History fresh(bool) const { return {}; }
    Strength strength(const History& history, double normal_force, double length,
                      const ShearTrial& trial) const;
    Strength strength_slope(const History& history, double normal_force, double length) const;
    std::optional<CoulombLine> bound_line(const History&) const { return std::nullopt; }
    History advance(const History& history, const ContactMotion& motion) const;
    /// Beyond the largest distance the walls of an open joint part along the mobilised roughness, and meet
    /// again on the way back. A joint that has not slipped stays so up to its peak displacement.
    History fly(const History& history, const ContactMotion& motion) const;
    /// Eq. (58), for a part of the joint with this length; 0 without a peak displacement. @param normal_force
    /// used only if the joint has not been loaded yet.
    double shear_stiffness(const History& history, double normal_force, double length) const;
    LockedDilation locked_dilation(const History& history) const;
    JointRecord record(const History& history) const;

  private:
    /// Whether the joint has not slipped, but for rounding.
    bool is_fresh(const History& history) const;
    /// Distance from the origin from where further motion outwards parts the walls, m: where the joint wore
    /// last, or flew to.
    static double outline(const History& history) {
        return std::max(history.furthest, std::abs(history.position));
    }
    /// Dilation of a joint that has not slipped, at a distance from its origin, m. @param roughness rad, of
    /// the reference stress.
    double fresh_dilation(double distance, double roughness) const;
    /// Its derivative by the distance.
    double fresh_rate(double distance, double roughness) const;
    double angle(double distance, double roughness) const;
    template <class Visit>
    void visit_pieces(double from, double to, double roughness, Visit visit) const;
    /// The dilation between two distances from the origin, Eq. (60). @param climb the largest rate over the
    /// distance, Eq. (79), 1/m.
    double dilation_between(double from, double to, double roughness, double climb) const;
    /// The dilation rate at a distance from the origin, not negative.
    double dilation_rate(double distance, double roughness) const;
    double largest_climb(double roughness) const;
    void dilate(const History& history, const ContactMotion& motion, History& after) const;
    /// The locked slope under a normal force, no steeper than the strength.
    double slope_under(const History& history, double normal_force, double length) const;
    /// Roughness angle of the stress at which the spring was found, rad.
    double reference_roughness(const History& history) const;
    double strength_at(double furthest, double normal_force, double length) const;
};

}  // namespace rockslope::dda
