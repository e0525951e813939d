#pragma once

#include <array>
#include <cstddef>

#include "dda/joint/angle_piece.hpp"
#include "dda/joint/cyclic_roughness.hpp"

namespace dda {

/// tan(angle), with the angles asked for last kept: on an even piece of a way, which most are, the bound at
/// its start, at its end and against the way back have one angle.
class Tangents {
  public:
    double operator()(double angle) const;

  private:
    struct Known {
        double angle = 0;  ///< rad
        double tangent = 0;
    };
    mutable std::array<Known, 4> known_;
    mutable std::size_t oldest_ = 0;
};

/// What a displacement does to a cyclic joint under a constant normal force. The way is walked in pieces on
/// which strength and dilation angle are smooth, and each piece in phases, locked or sliding, that are solved
/// in closed form or to rounding: the outcome does not depend on how a path is cut into displacements.
class CyclicWalk {
  public:
    /// What is to be known at the end. Strengths are asked for in every iteration and need neither the
    /// dilation nor what the results tell; a history has both.
    enum class Purpose { strength, history };

    /// @param normal_force N per metre, positive; @param stiffness N/m per metre, of the shear spring.
    CyclicWalk(const CyclicBartonBandis& law, const CyclicBartonBandis::History& history, double normal_force,
               double length, double stiffness, double shear_force, Purpose purpose);
    CyclicWalk(const CyclicWalk&) = delete;
    CyclicWalk& operator=(const CyclicWalk&) = delete;

    /// Displaces the joint by so many metres.
    void go(double displacement);
    /// The same without a spring: all of the way is locked or sliding. @param slip m, its plastic part.
    void go_as_told(double displacement, double slip);

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
        double end;        ///< m, distance from the origin where it ends
        bool whole;        ///< it ends there, and not before, where an angle meets a limit
        AnglePiece bound;  ///< total angle that bounds the shear force
        AnglePiece open;   ///< dilation angle while advancing or sliding back
        double unloading;  ///< dilation angle while unloading
    };

    Place place(int direction) const { return at_.place(history_.position, direction); }
    double factor() const;
    double resisting(int direction, double angle) const;
    AnglePiece bound_angles(const Place& place, double end) const;
    AnglePiece dilation_angles(const Place& place, double end) const;
    double dilation_angle(double ratio) const;
    Piece piece(const Place& place, double target) const;
    double cross(const Place& place, const Piece& piece);
    double slide(const Place& place, const Piece& piece, double along, bool& interrupted);
    void move(const Place& place, const Piece& piece, double from, double to, bool sliding);
    bool begin_slip(const Place& place, int direction);
    bool count_slip(int direction, double amount);
    void turn_round();
    void arrive(const Place& place, double distance);
    void finish();

    const CyclicBartonBandis& law_;
    CyclicBartonBandis::History history_;
    CyclicRoughness at_;  ///< where the history is
    double normal_force_;
    double stiffness_;
    double damage_;      ///< M of Eq. (58), 0 where nobody asks for the dilation
    double roughness_;   ///< rad, i of Eq. (51)
    double force_;       ///< N per metre
    double target_ = 0;  ///< m, position to be reached
    int direction_ = 1;  ///< of motion
    bool slipped_ = false;
    bool told_ = false;      ///< whether the joint slides is told, not found
    double told_share_ = 0;  ///< plastic slip over displacement where it is
    int last_side_ = 0;      ///< where it moved last, 0 if it did not
    bool last_away_ = false;
    Purpose purpose_;
    Tangents tan_;
    Strength bounds_;
};

}  // namespace dda
