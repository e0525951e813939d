#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "dda/terms/springs.hpp"

namespace rockslope::dda {

/// The elastic forces of a contact: those that its springs would bear without limits, N per metre, in
/// compression and in the direction of the shear displacement.
struct ElasticForces {
    double normal = 0;
    double shear = 0;

    /// Both: normal, shear.
    Vec2 vector() const { return {normal, shear}; }
    friend ElasticForces operator+(const ElasticForces& a, const ElasticForces& b) {
        return {a.normal + b.normal, a.shear + b.shear};
    }
};

/// A shear bound over the normal force: N per metre at no normal force, and its slope.
struct ForceLine {
    double cohesion = 0;
    double slope = 0;

    /// The bound under a normal force, N per metre.
    double at(double normal) const { return cohesion + slope * normal; }
};

/// The linear piece that a contact is on, Eq. (98).
struct Piece {
    /// Where the elastic normal force is: below the least normal force that the contact bears; above that,
    /// but where the shear bounds fall no further; above that.
    enum class Normal : std::uint8_t { least, low, pressed };
    Normal normal = Normal::least;
    int slides = 0;  ///< 1: at the forward bound, -1: at the backward one, 0: its shear spring is locked

    friend bool operator==(const Piece&, const Piece&) = default;
};

/// Forces that are linear on a piece: constant + slope * elastic forces (normal, shear).
struct PieceForces {
    Eigen::Matrix2d slope = Eigen::Matrix2d::Zero();
    Vec2 constant = Vec2::Zero();

    /// Normal and shear force, N per metre.
    Vec2 at(const ElasticForces& elastic) const { return constant + slope * elastic.vector(); }

    friend bool operator==(const PieceForces&, const PieceForces&) = default;
};

/// The borders of a piece, at most four: lines in the plane of the elastic forces. Inside the piece
/// normal . elastic + constant is negative for each.
struct PieceBorders {
    Eigen::Array4d normal = Eigen::Array4d::Zero();  ///< by the normal elastic force; no border: zero
    Eigen::Array4d shear = Eigen::Array4d::Zero();   ///< by the shear one
    Eigen::Array4d constant = Eigen::Array4d::Zero();
    std::array<Piece, 4> beyond;
    int count = 0;

    /// The distances of the borders on a straight way, as multiples of the rate; infinite if the way does not
    /// lead there.
    Eigen::Array4d distances(const ElasticForces& from, const ElasticForces& rate) const {
        const Eigen::Array4d speed = normal * rate.normal + shear * rate.shear;
        const Eigen::Array4d depth = -(normal * from.normal + shear * from.shear + constant);
        return (speed > 0).select((depth / speed).max(0.0), std::numeric_limits<double>::infinity());
    }
    /// Adds a border. @param direction by the normal and the shear elastic force. @param piece_beyond of the
    /// contact behind it.
    void add(const Vec2& direction, double constant_part, const Piece& piece_beyond) {
        normal[count] = direction.x();
        shear[count] = direction.y();
        constant[count] = constant_part;
        beyond[count++] = piece_beyond;
    }
};

/// The border of a piece that is reached first on a straight way.
struct Border {
    double distance = 0;  ///< multiple of the rate; infinite if there is none
    Vec2 normal = Vec2::Zero();
    Piece beyond;
};

/// A contact in a step whose laws are frozen but for their limits, Eq. (98): linear springs, a least normal
/// force, and shear bounds that are lines over the normal force. Its forces are continuous and linear in
/// pieces. Forces in N per metre.
struct LimitedContact {
    const BlockPair* rows = nullptr;
    Vec2 opening = Vec2::Zero();   ///< direction of the normal spring, Eq. (83)
    Vec2 shearing = Vec2::Zero();  ///< direction of the shear spring
    double normal_stiffness = 0;   ///< N/m per metre
    double shear_stiffness = 0;    ///< N/m per metre
    ElasticForces origin;          ///< elastic forces without a displacement
    bool may_close = true;         ///< false: bears no force
    double least_normal = 0;       ///< minus infinity where it bears any tension
    double floor = 0;              ///< the normal force below which the bounds fall no further
    double tilt = 0;               ///< the shear force here is that of the contact less tilt times normal
    ForceLine forward;             ///< not negative at the floor
    ForceLine backward;
    Hardening hardening;  ///< the part of the elastic shear force beyond each bound that it bears,
                          ///< below 1

    /// The elastic forces at a displacement, per row, m.
    ElasticForces elastic_at(RowSpan<const Vec6> d) const {
        return origin + change_by(rows->relative_displacement(d));
    }
    /// The change of the elastic forces by a relative displacement, m.
    ElasticForces change_by(const Vec2& relative) const {
        return {-normal_stiffness * opening.dot(relative), shear_stiffness * shearing.dot(relative)};
    }
    /// The piece that elastic forces are on.
    Piece piece_at(const ElasticForces& elastic) const;
    /// The forces on a piece; also beyond its borders.
    PieceForces on(const Piece& piece) const;
    /// The borders of a piece.
    PieceBorders borders(const Piece& piece) const;
    /// The first border of a piece on the way from elastic forces inside it.
    /// @param rate change of the elastic forces over the distance.
    Border first_border(const Piece& piece, const ElasticForces& from, const ElasticForces& rate) const;

  private:
    /// A shear bound on a piece, as a line over the elastic normal force. @param direction 1 or -1: the
    /// bound is the largest or the smallest shear force.
    ForceLine bound(Piece::Normal normal, int direction) const;
    double hardening_of(int direction) const {
        return direction > 0 ? hardening.forward : hardening.backward;
    }
    /// Whether both bounds are zero where the contact bears its least normal force.
    bool ends_in_apex() const;
};

}  // namespace rockslope::dda
