#include "dda/path/limited_contact.hpp"

#include <algorithm>
#include <cmath>

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
    const double part = hardening_of(piece.slides);
    forces.slope(1, 1) = part;
    forces.slope(1, 0) = (1 - part) * line.slope;
    forces.constant.y() = (1 - part) * line.cohesion;
    return forces;
}

PieceBorders LimitedContact::borders(const Piece& piece) const {
    PieceBorders found;
    if (!may_close) return found;
    const bool is_pressed = piece.normal == Piece::Normal::pressed;
    const bool has_apex = ends_in_apex();
    for (const int direction : {1, -1}) {
        const bool is_on_apex = has_apex && !is_pressed;
        if (piece.slides == -direction || (is_on_apex && !hardening.any())) continue;
        const ForceLine line = bound(piece.normal, direction);
        const double sign = piece.slides == 0 ? direction : -direction;
        const int beyond = is_on_apex ? -direction : 0;
        found.add(sign * Vec2(-line.slope, 1), -sign * line.cohesion,
                  {piece.normal, piece.slides == 0 ? direction : beyond});
    }
    const bool has_low = floor > least_normal;
    // Upwards.
    if (piece.normal == Piece::Normal::least)
        found.add({1, 0}, -least_normal,
                  {has_low ? Piece::Normal::low : Piece::Normal::pressed, piece.slides});
    if (piece.normal == Piece::Normal::low) found.add({1, 0}, -floor, {Piece::Normal::pressed, piece.slides});
    // Downwards. A locked contact without cohesion slides before it opens.
    if (has_apex && piece.slides == 0) return found;
    if (is_pressed && has_low) found.add({-1, 0}, floor, {Piece::Normal::low, piece.slides});
    const bool may_open = piece.normal == Piece::Normal::low || (is_pressed && !has_low);
    if (may_open && std::isfinite(least_normal))
        found.add({-1, 0}, least_normal, {Piece::Normal::least, piece.slides});
    return found;
}

Border LimitedContact::first_border(const Piece& piece, const ElasticForces& from,
                                    const ElasticForces& rate) const {
    const PieceBorders all = borders(piece);
    Eigen::Index first = 0;
    Border border;
    border.distance = all.distances(from, rate).minCoeff(&first);
    if (!std::isfinite(border.distance)) return border;
    border.normal = {all.normal[first], all.shear[first]};
    border.beyond = all.beyond[first];
    // Beyond an apex a contact slides to the side that it comes from. Where bounds harden it knows that side.
    if (!hardening.any() && ends_in_apex() && piece.normal != Piece::Normal::pressed &&
        border.beyond.normal == Piece::Normal::pressed) {
        const double normal = from.normal + border.distance * rate.normal;
        const double shear = from.shear + border.distance * rate.shear;
        border.beyond.slides = shear >= bound(Piece::Normal::pressed, 1).at(normal) ? 1 : -1;
    }
    return border;
}

}  // namespace rockslope::dda
