#pragma once

#include <array>
#include <cstddef>

#include "dda/joint/cyclic_roughness.hpp"
#include "dda/joint/linear_angle.hpp"

namespace rockslope::dda {

/// tan(angle) with a cache of the last angles: on most pieces of a path the bounds at both ends and in both
/// directions have the same angle.
class TangentCache {
  public:
    double operator()(double angle) const;

  private:
    struct Entry {
        double angle = 0;  ///< rad
        double tangent = 0;
    };
    mutable std::array<Entry, 4> entries_;
    mutable std::size_t oldest_ = 0;
};

/// Displaces a cyclic joint under a constant normal force. The path is divided into pieces on which strength
/// and dilation angle are smooth, and each piece into locked and sliding phases that are solved in closed
/// form or to rounding: the result does not depend on how a path is divided into displacements.
class CyclicShearPath {
  public:
    /// The wanted result. Strengths are computed in every iteration and need neither the dilation nor the
    /// values for the results; a history contains both.
    enum class Purpose { strength, history };

    /// @param normal_force N per metre, positive; @param length m.
    CyclicShearPath(const CyclicBartonBandis& law, const CyclicBartonBandis::History& history,
                    double normal_force, double length, const ShearSpring& spring, Purpose purpose);
    CyclicShearPath(const CyclicShearPath&) = delete;
    CyclicShearPath& operator=(const CyclicShearPath&) = delete;

    /// Displaces the joint, m.
    void displace(double displacement);
    /// Displaces the joint without a spring, m; @param slip its plastic part, m.
    void prescribe_slip(double displacement, double slip);

    /// Moves the walls of the open joint, m: neither its furthest distances nor its cycle nor its reversals
    /// change, and its dilation not below the mated position.
    void fly(double displacement);

    const CyclicBartonBandis::History& history() const { return history_; }
    double shear_force() const { return force_; }
    bool slipped() const { return slipped_; }
    /// Mobilised ratio that bounds motion in the direction +1 or -1 at the present position, reversals and
    /// cycles included.
    double bound_ratio(int direction) const;
    /// Strength against motion in a direction at the present position, N per metre.
    double bound(int direction) const;
    /// Strengths at the end of the path, forward and backward in the contact's direction.
    const Strength& bounds_at_end() const { return bounds_; }

  private:
    using Place = CyclicRoughness::Place;
    struct Piece {
        double end;            ///< m, distance from the origin where it ends
        bool reaches_end;      ///< false if the piece ends before, where an angle meets a limit
        LinearAngle bound;     ///< total angle of the strength
        LinearAngle dilation;  ///< dilation angle while advancing or sliding back
    };

    Place place(int direction) const { return mobilised_.place(history_.position, direction); }
    double resisting_angle(int direction, double angle) const;
    LinearAngle bound_angles(const Place& place, double end) const;
    LinearAngle dilation_angles(const Place& place, double end) const;
    double dilation_angle(double ratio) const;
    Piece piece(const Place& place, double target) const;
    double traverse(const Place& place, const Piece& piece);
    double slide(const Place& place, const Piece& piece, double along, bool& interrupted);
    void record_motion(const Place& place, const Piece& piece, double from, double to, bool sliding);
    bool begin_slip(const Place& place, int direction);
    double bound_of_ratio(int direction, double ratio) const;
    void cross_origin();
    double come_back(const Place& place, const Piece& piece);
    double fresh_angle(double distance) const;
    double largest_climb() const;
    double fresh_slope(double distance) const;
    double fresh_dilation(const Place& place, double from, double to) const;
    double locked_stiffness(const Place& place, double from, double to) const;
    double dilation_tangent(double ratio) const;
    void finish();

    const CyclicBartonBandis& law_;
    CyclicBartonBandis::History history_;
    CyclicRoughness mobilised_;  ///< where the history is
    double normal_force_;
    double stiffness_;
    double damage_;              ///< M of Eq. (64); 0 if the dilation is not needed
    double roughness_;           ///< rad, i of Eq. (57)
    double dilation_roughness_;  ///< rad, the same at the normal stress at which the spring was found
    double force_;               ///< N per metre
    double target_ = 0;          ///< m, position at the end
    int direction_ = 1;          ///< of motion
    bool flying_ = false;        ///< the joint is open
    bool slipped_ = false;
    bool slip_prescribed_ = false;  ///< the slip is given, not computed
    double slip_ratio_ = 0;         ///< plastic slip over displacement if it is given
    int last_side_ = 0;             ///< side of the last motion, 0 before any
    bool last_away_ = false;
    Purpose purpose_;
    TangentCache tan_;
    Strength bounds_;
};

}  // namespace rockslope::dda
