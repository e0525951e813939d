#include "dda/solve/limited_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rockslope::dda {

ForceLine LimitedContact::bound(Piece::Normal normal, int direction) const {
    const ForceLine& line = direction > 0 ? forward : backward;
    const double at_floor = line.cohesion + line.slope * floor;
    if (normal == Piece::Normal::least) return {direction * at_floor - tilt * least_normal, 0};
    if (normal == Piece::Normal::low) return {direction * at_floor, -tilt};
    return {direction * line.cohesion, direction * line.slope - tilt};
}

bool LimitedContact::ends_in_apex() const {
    return forward.cohesion + forward.slope * floor + backward.cohesion + backward.slope * floor <= 0;
}

Piece LimitedContact::piece_at(const ElasticForces& elastic) const {
    Piece piece;
    if (elastic.normal > least_normal)
        piece.normal = elastic.normal > floor ? Piece::Normal::pressed : Piece::Normal::low;
    const double most = bound(piece.normal, 1).at(elastic.normal);
    const double least = bound(piece.normal, -1).at(elastic.normal);
    if (piece.normal != Piece::Normal::pressed && ends_in_apex())
        piece.slides = elastic.shear >= most ? 1 : -1;
    else
        piece.slides = elastic.shear > most ? 1 : (elastic.shear < least ? -1 : 0);
    return piece;
}

/// The forces of Eq. (98).
PieceForces LimitedContact::on(const Piece& piece) const {
    PieceForces forces;
    if (!may_close) return forces;
    const bool is_least = piece.normal == Piece::Normal::least;
    if (is_least)
        forces.constant.x() = least_normal;
    else
        forces.slope(0, 0) = 1;
    if (piece.slides == 0) {
        forces.slope(1, 1) = 1;
        return forces;
    }
    const ForceLine line = bound(piece.normal, piece.slides);
    forces.slope(1, 0) = line.slope;
    forces.constant.y() = line.cohesion;
    return forces;
}

Border LimitedContact::first_border(const Piece& piece, const ElasticForces& from,
                                    const ElasticForces& rate) const {
    Border first;
    first.distance = std::numeric_limits<double>::infinity();
    if (!may_close) return first;
    // The piece ends where normal * elastic + constant is zero; inside it is negative.
    const auto end_at = [&](const Vec2& normal, double constant, const Piece& beyond) {
        const double speed = normal.dot(rate.vector());
        if (!(speed > 0)) return;
        const double distance = std::max(-(normal.dot(from.vector()) + constant) / speed, 0.0);
        if (distance < first.distance) first = {distance, normal, beyond};
    };
    const bool is_pressed = piece.normal == Piece::Normal::pressed;
    const bool has_apex = ends_in_apex();
    for (const int direction : {1, -1}) {
        if (piece.slides == -direction || (has_apex && !is_pressed)) continue;
        const ForceLine line = bound(piece.normal, direction);
        const double sign = piece.slides == 0 ? direction : -direction;
        end_at(sign * Vec2(-line.slope, 1), -sign * line.cohesion,
               {piece.normal, piece.slides == 0 ? direction : 0});
    }
    const bool has_low = floor > least_normal;
    // Upwards.
    if (piece.normal == Piece::Normal::least)
        end_at({1, 0}, -least_normal, {has_low ? Piece::Normal::low : Piece::Normal::pressed, piece.slides});
    if (piece.normal == Piece::Normal::low) end_at({1, 0}, -floor, {Piece::Normal::pressed, piece.slides});
    if (has_apex && first.beyond.normal == Piece::Normal::pressed && !is_pressed) {
        const double normal = from.normal + first.distance * rate.normal;
        const double shear = from.shear + first.distance * rate.shear;
        first.beyond.slides = shear >= bound(Piece::Normal::pressed, 1).at(normal) ? 1 : -1;
    }
    // Downwards. A locked contact without cohesion slides before it opens.
    if (is_pressed && has_low && !(has_apex && piece.slides == 0))
        end_at({-1, 0}, floor, {Piece::Normal::low, piece.slides});
    const bool may_open = piece.normal == Piece::Normal::low || (is_pressed && !has_low);
    if (may_open && std::isfinite(least_normal) && !(has_apex && piece.slides == 0))
        end_at({-1, 0}, least_normal, {Piece::Normal::least, piece.slides});
    return first;
}

}  // namespace rockslope::dda
