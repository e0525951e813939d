#pragma once

#include <array>
#include <cstddef>

#include "dda/joint/cyclic_roughness.hpp"
#include "dda/joint/linear_angle.hpp"

namespace rockslope::dda {

/// tan(angle), with the angles asked for last kept: on an even piece of a way, which most are, the bound at
/// its start, at its end and against the way back have one angle.
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

/// What a displacement does to a cyclic joint under a constant normal force. The way is walked in pieces on
/// which strength and dilation angle are smooth, and each piece in phases, locked or sliding, that are solved
/// in closed form or to rounding: the outcome does not depend on how a path is cut into displacements.
class CyclicShearPath {
  public:
    /// What is to be entry at the end. Strengths are asked for in every iteration and need neither the
    /// dilation nor what the results tell; a history has both.
    enum class Purpose { strength, history };

    /// @param normal_force N per metre, positive; @param stiffness N/m per metre, of the shear spring.
    CyclicShearPath(const CyclicBartonBandis& law, const CyclicBartonBandis::History& history,
                    double normal_force, double length, double stiffness, double shear_force,
                    Purpose purpose);
    CyclicShearPath(const CyclicShearPath&) = delete;
    CyclicShearPath& operator=(const CyclicShearPath&) = delete;

    /// Displaces the joint by so many metres.
    void displace(double displacement);
    /// The same without a spring: all of the way is locked or sliding. @param slip m, its plastic part.
    void prescribe_slip(double displacement, double slip);

    const CyclicBartonBandis::History& history() const { return history_; }
    double shear_force() const { return force_; }
    bool slipped() const { return slipped_; }
    /// Mobilised ratio that bounds motion in the direction +1 or -1 from here, reversals and cycles included.
    double bound_ratio(int direction) const;
    /// Largest shear force against motion in that direction from here, N per metre.
    double bound(int direction) const;
    /// Both bounds where the way has ended, forward and backward in the contact's direction.
    const Strength& bounds_at_end() const { return bounds_; }

  private:
    using Place = CyclicRoughness::Place;
    struct Piece {
        double end;            ///< m, distance from the origin where it ends
        bool reaches_end;      ///< it ends there, and not before, where an angle meets a limit
        LinearAngle bound;     ///< total angle that bounds the shear force
        LinearAngle dilation;  ///< dilation angle while advancing or sliding back
        double unloading;      ///< dilation angle while unloading
    };

    Place place(int direction) const { return mobilised_.place(history_.position, direction); }
    double wear_factor() const;
    double resisting_angle(int direction, double angle) const;
    LinearAngle bound_angles(const Place& place, double end) const;
    LinearAngle dilation_angles(const Place& place, double end) const;
    double dilation_angle(double ratio) const;
    Piece piece(const Place& place, double target) const;
    double traverse(const Place& place, const Piece& piece);
    double slide(const Place& place, const Piece& piece, double along, bool& interrupted);
    void record_motion(const Place& place, const Piece& piece, double from, double to, bool sliding);
    bool begin_slip(const Place& place, int direction);
    bool count_slip(int direction, double amount);
    void count_reversal();
    void update_position(const Place& place, double distance);
    void finish();

    const CyclicBartonBandis& law_;
    CyclicBartonBandis::History history_;
    CyclicRoughness mobilised_;  ///< where the history is
    double normal_force_;
    double stiffness_;
    double damage_;      ///< M of Eq. (64), 0 where nobody asks for the dilation
    double roughness_;   ///< rad, i of Eq. (57)
    double force_;       ///< N per metre
    double target_ = 0;  ///< m, position to be reached
    int direction_ = 1;  ///< of motion
    bool slipped_ = false;
    bool slip_prescribed_ = false;  ///< whether the joint slides is told, not found
    double slip_ratio_ = 0;         ///< plastic slip over displacement where it is
    int last_side_ = 0;             ///< where it moved last, 0 if it did not
    bool last_away_ = false;
    Purpose purpose_;
    TangentCache tan_;
    Strength bounds_;
};

}  // namespace rockslope::dda
