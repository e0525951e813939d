#include "dda/joint/cyclic_shear_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dda/joint/cyclic_history.hpp"
#include "dda/joint/locked_slope.hpp"

namespace rockslope::dda {

namespace {

using Law = CyclicBartonBandis;

constexpr double no_distance = std::numeric_limits<double>::infinity();

LinearAngle part_of(const LinearAngle& piece, double from, double to) {
    if (from == 0 && to == piece.length && to > 0) return piece;
    return {to - from, piece.angle_at(from), to == piece.length ? piece.last : piece.angle_at(to)};
}

/// Distance along a piece at which the bound N tan(angle) begins to grow faster than the spring's force; the
/// length of the piece if it never does. The slope N angle' / cos^2 grows with the angle.
double spring_overtaken_at(const LinearAngle& piece, double normal_force, double stiffness) {
    if (!(piece.last > piece.first)) return piece.length;
    const double turn = (piece.last - piece.first) / piece.length;
    const double square = normal_force * turn / stiffness;
    if (square >= 1) return 0;
    return std::clamp((std::acos(std::sqrt(square)) - piece.first) / turn, 0.0, piece.length);
}

/// Where a shear force that starts below the bound and climbs with the spring meets it, Eq. (66);
/// `no_distance` if nowhere. Force minus bound is concave up to where the bound overtakes the spring, so
/// Newton's steps from the left approach the root from the left.
double distance_to_slip(double force, const LinearAngle& piece, double normal_force, double stiffness,
                        const TangentCache& tan) {
    const double lowest = normal_force * tan(std::min(piece.first, piece.last));
    if (force + stiffness * piece.length < lowest) return no_distance;
    if (piece.first == piece.last) return std::max((lowest - force) / stiffness, 0.0);
    const double last = spring_overtaken_at(piece, normal_force, stiffness);
    const auto strength_margin = [&](double along) {
        return normal_force * tan(piece.angle_at(along)) - force - stiffness * along;
    };
    if (strength_margin(last) > 0) return no_distance;
    const double turn = (piece.last - piece.first) / piece.length;
    double along = 0;
    for (int k = 0; k < 100; ++k) {
        const double tangent = tan(piece.angle_at(along));
        const double gap = normal_force * tangent - force - stiffness * along;
        const double slope = stiffness - normal_force * turn * (1 + tangent * tangent);
        if (!(gap > 0) || !(slope > 0)) break;
        const double next = along + gap / slope;
        if (next >= last) return last;
        if (next <= along) break;
        along = next;
    }
    return along;
}

/// The least stiffness of a fresh joint that contracts while its normal force is below the reference, over
/// that of its spring.
constexpr double least_stiffness = 1e-3;

}  // namespace

double TangentCache::operator()(double angle) const {
    for (const Entry& entry : entries_)
        if (entry.angle == angle) return entry.tangent;
    const double tangent = std::tan(angle);
    entries_[oldest_] = {angle, tangent};
    oldest_ = (oldest_ + 1) % entries_.size();
    return tangent;
}

CyclicShearPath::CyclicShearPath(const Law& law, const Law::History& history, double normal_force,
                                 double length, const ShearSpring& spring, Purpose purpose)
    : law_(law),
      history_(history),
      mobilised_(law_, history_),
      normal_force_(normal_force),
      stiffness_(spring.stiffness),
      damage_(purpose == Purpose::history ? law.damage : 0),
      roughness_(law.barton.roughness_angle(normal_force, law.stressed_length(length))),
      dilation_roughness_(history.spring.normal_stress > 0
                              ? law.barton.roughness_angle(history.spring.normal_stress, 1)
                              : roughness_),
      force_(spring.force),
      purpose_(purpose) {}

void CyclicShearPath::displace(double displacement) {
    target_ = history_.position + displacement;
    if (displacement != 0) direction_ = displacement > 0 ? 1 : -1;
    while (history_.position != target_) {
        if (history_.position == 0) cross_origin();
        const Place here = place(direction_);
        const bool stays = here.away || sign_of(target_) == sign_of(history_.position);
        const Piece next = piece(here, stays ? std::abs(target_) : 0);
        const double done = traverse(here, next);
        const double distance = here.distance + (here.away ? done : -done);
        const bool reaches_end = done == next.bound.length && next.reaches_end;
        // A part too short to change the position would repeat for ever.
        const bool stuck = done > 0 && distance == here.distance;
        if (done > 0) move_to(law_, here, direction_, reaches_end || stuck ? next.end : distance, history_);
    }
    finish();
}

void CyclicShearPath::prescribe_slip(double displacement, double slip) {
    slip_prescribed_ = true;
    slip_ratio_ = displacement != 0 ? std::abs(slip / displacement) : 0;
    displace(displacement);
}

void CyclicShearPath::fly(double displacement) {
    flying_ = true;
    const double target = history_.position + displacement;
    direction_ = displacement > 0 ? 1 : -1;
    history_.crossed = 0;
    // The asperities of an unslipped joint match up to its peak displacement.
    const auto leave_match = [this] {
        if (mobilised_.is_fresh() && std::abs(history_.position) >= law_.peak_displacement)
            history_.forward = history_.position > 0 ? 1 : -1;
    };
    leave_match();
    while (history_.position != target) {
        const Place here = place(direction_);
        const bool stays = here.away || sign_of(target) == sign_of(history_.position);
        const Piece next = piece(here, stays ? std::abs(target) : 0);
        const double length = next.bound.length;
        const double lowest = std::min(history_.dilation, 0.0);
        record_motion(here, next, 0, length, true);
        history_.dilation = std::max(history_.dilation, lowest);
        const double distance = next.reaches_end ? next.end : here.distance + (here.away ? length : -length);
        // A part too short to change the position would repeat for ever.
        const double end = distance == here.distance ? next.end : distance;
        history_.position = (here.away ? direction_ : -direction_) * end;
        leave_match();
    }
    set_ratios(mobilised_, {std::abs(history_.position), last_side_, last_away_}, history_);
}

// --- bounds

double CyclicShearPath::bound_ratio(int direction) const {
    return mobilised_.bound_ratio(history_.crossed == direction ? mobilised_.place(0, direction)
                                                                : place(direction));
}

/// A joint that has crossed its origin locked keeps the strength it had there, less what its spring has lost
/// since, Eq. (82).
double CyclicShearPath::bound(int direction) const {
    const double here = bound_of_ratio(direction, mobilised_.bound_ratio(place(direction)));
    if (history_.crossed != direction) return here;
    const double at_origin = bound_of_ratio(direction, bound_ratio(direction));
    return std::max(at_origin - stiffness_ * std::abs(history_.position), here);
}

double CyclicShearPath::bound_of_ratio(int direction, double ratio) const {
    const double opposing = law_.barton.free_angle(roughness_, ratio);
    return normal_force_ *
           tan_(std::clamp(resisting_angle(direction, opposing), 0.0, BartonStrength::largest_angle));
}

/// The angle that resists motion in a direction, Eq. (65), from phi_r + ratio i: where only forward motion
/// climbs the roughness, backward motion goes down it.
double CyclicShearPath::resisting_angle(int direction, double angle) const {
    const bool downwards = law_.asymmetric && !mobilised_.is_fresh() && direction != history_.forward;
    return downwards ? std::abs(2 * law_.barton.residual_friction_angle - angle) : angle;
}

// --- pieces of the path

/// Total angle up to `end`, or up to where it stops being linear.
LinearAngle CyclicShearPath::bound_angles(const Place& place, double end) const {
    const double wear = history_.wear;
    const RoughnessTable& table = mobilised_.bound_table(place);
    const bool rising = mobilised_.is_before_first_peak(place, (place.distance + end) / 2);
    const auto angle = [&](double distance) {
        const double ratio = rising ? 1 : table.ratio(distance / law_.peak_displacement);
        return law_.barton.free_angle(roughness_, wear * ratio);
    };
    double highest = BartonStrength::largest_angle;
    if (mobilised_.is_worn(place))
        highest = law_.barton.total_angle(
            roughness_, wear * mobilised_.unworn_bound_ratio(place, mobilised_.furthest(place.side)));
    LinearAngle piece =
        clamp_leading_part({std::abs(end - place.distance), angle(place.distance), angle(end)}, 0, highest);
    const double first = resisting_angle(direction_, piece.first),
                 last = resisting_angle(direction_, piece.last);
    if (first == piece.first && last == piece.last) return piece;
    // The absolute value of Eq. (65) has its kink where friction changes its direction.
    const double kink = 2 * law_.barton.residual_friction_angle;
    if ((piece.first < kink) != (piece.last < kink) && piece.first != kink) {
        const LinearAngle part =
            clamp_leading_part(piece, std::min(piece.first, kink), std::max(piece.first, kink));
        if (part.length < piece.length) return {part.length, first, 0};
    }
    return {piece.length, first, last};
}

/// Dilation angle of a mobilised ratio, wear included: Eq. (60) within the limits of the total angle.
double CyclicShearPath::dilation_angle(double ratio) const {
    const double friction = law_.barton.residual_friction_angle;
    return (law_.barton.total_angle(dilation_roughness_, ratio) - friction) / law_.damage;
}

/// Dilation angle up to `end`, or up to where it stops being linear or changes its sign.
LinearAngle CyclicShearPath::dilation_angles(const Place& place, double end) const {
    const double length = std::abs(end - place.distance);
    if (damage_ == 0) return {length, 0, 0};
    const double friction = law_.barton.residual_friction_angle, wear = history_.wear;
    const RoughnessTable& table = mobilised_.roughness_table(place);
    const double towards = law_.unsigned_ratios && !place.away ? -1 : 1;
    const auto angle = [&](double distance) {
        return law_.barton.free_angle(dilation_roughness_,
                                      towards * wear * table.ratio(distance / law_.peak_displacement));
    };
    double highest = BartonStrength::largest_angle;
    if (mobilised_.is_worn(place)) highest = std::clamp(angle(mobilised_.furthest(place.side)), 0.0, highest);
    LinearAngle piece = clamp_leading_part({length, angle(place.distance), angle(end)}, 0, highest);
    if ((piece.first - friction) * (piece.last - friction) < 0)
        piece = piece.first < friction ? clamp_leading_part(piece, piece.first, friction)
                                       : clamp_leading_part(piece, friction, piece.first);
    return {piece.length, (piece.first - friction) / damage_, (piece.last - friction) / damage_};
}

CyclicShearPath::Piece CyclicShearPath::piece(const Place& place, double target) const {
    const double knot = mobilised_.next_knot(place, damage_ != 0);
    Piece made;
    made.end = place.away ? std::min(knot, target) : std::max(knot, target);
    const double length = std::abs(made.end - place.distance);
    made.bound = bound_angles(place, made.end);
    made.dilation = dilation_angles(place, made.end);
    const double linear = std::min(made.bound.length, made.dilation.length);
    made.reaches_end = linear == length;
    made.bound = part_of(made.bound, 0, linear);
    made.dilation = part_of(made.dilation, 0, linear);
    return made;
}

// --- the origin

/// Marks a locked joint whose force is beyond the strength that it would return with, once it has passed the
/// origin.
void CyclicShearPath::cross_origin() {
    history_.crossed = 0;
    if (mobilised_.is_fresh() || !(direction_ * force_ < 0) || !(stiffness_ > 0)) return;
    const Place behind = {0, mobilised_.place(0, direction_).side, false};
    if (std::abs(force_) > bound_of_ratio(-direction_, mobilised_.bound_ratio(behind)))
        history_.crossed = -direction_;
}

/// A joint that crossed its origin and comes back has a bound that grows with the spring's force, Eq. (82):
/// it slips at once or not until the origin.
double CyclicShearPath::come_back(const Place& place, const Piece& piece) {
    const double held = bound(direction_), excess = direction_ * force_ - held;
    if (excess > 0) {
        force_ = direction_ * held;
        if (count_slip(law_, direction_, excess / stiffness_, history_)) return 0;
    }
    const double length = piece.bound.length;
    record_motion(place, piece, 0, length, excess > 0);
    force_ += direction_ * stiffness_ * length;
    return length;
}

// --- phases

/// Displaces along a piece until its end or until the bounds change. @return the distance, m.
double CyclicShearPath::traverse(const Place& place, const Piece& piece) {
    const double length = piece.bound.length;
    if (slip_prescribed_) {
        if (slip_ratio_ > 0 && begin_slip(place, direction_)) return 0;
        record_motion(place, piece, 0, length, slip_ratio_ > 0);
        count_slip(law_, direction_, length * slip_ratio_, history_);
        return length;
    }
    if (history_.crossed == direction_ &&
        bound(direction_) > bound_of_ratio(direction_, mobilised_.bound_ratio(place)))
        return come_back(place, piece);
    double along = 0;
    bool below = direction_ * force_ < normal_force_ * tan_(piece.bound.first);
    while (along < length) {
        const LinearAngle rest = part_of(piece.bound, along, length);
        if (below || spring_overtaken_at(rest, normal_force_, stiffness_) == 0) {
            const double stiffness = locked_stiffness(place, along, length);
            const double met =
                below ? distance_to_slip(direction_ * force_, rest, normal_force_, stiffness, tan_)
                      : no_distance;
            const double locked = std::min(met, rest.length);
            record_motion(place, piece, along, along + locked, false);
            force_ += direction_ * stiffness * locked;
            along = met < rest.length ? along + locked : length;
            below = false;
        } else {
            bool interrupted = false;
            along = slide(place, piece, along, interrupted);
            if (interrupted) return along;
        }
    }
    return length;
}

/// Slides along a piece until the bound overtakes the spring, or until the slip changes the bounds.
double CyclicShearPath::slide(const Place& place, const Piece& piece, double along, bool& interrupted) {
    const LinearAngle rest = part_of(piece.bound, along, piece.bound.length);
    const double bound = normal_force_ * tan_(rest.first);
    const double drop = (direction_ * force_ - bound) / stiffness_;
    interrupted = begin_slip(place, direction_);
    if (interrupted) return along;
    force_ = direction_ * bound;
    interrupted = count_slip(law_, direction_, std::max(drop, 0.0), history_);
    if (interrupted) return along;
    double end = spring_overtaken_at(rest, normal_force_, stiffness_);
    const bool opposite = history_.slip_direction == -direction_;
    if (opposite) {
        // The slip that is missing for a reversal equals a distance to slip with a force lower by k times it.
        const double left = law_.min_slip - history_.reverse_slip;
        const double turned =
            distance_to_slip(bound - stiffness_ * left, rest, normal_force_, stiffness_, tan_);
        interrupted = turned < end;
        end = std::min(end, turned);
    }
    const double after = normal_force_ * tan_(rest.angle_at(end));
    record_motion(place, piece, along, along + end, true);
    force_ = direction_ * after;
    const double slip = end - (after - bound) / stiffness_;
    if (interrupted)
        count_reversal(law_, history_);
    else
        count_slip(law_, direction_, std::max(slip, 0.0), history_);
    return end == rest.length ? piece.bound.length : along + end;
}

/// The dilation of a part of a piece, Eq. (64).
void CyclicShearPath::record_motion(const Place& place, const Piece& piece, double from, double to,
                                    bool sliding) {
    set_stage(place, sliding, history_);
    last_side_ = place.side;
    last_away_ = place.away;
    if (damage_ == 0) return;
    const double end = place.away ? place.distance + to : place.distance - to;
    const int side = place.away ? direction_ : -direction_;
    if (flying_ ? mobilised_.is_fresh() : mobilised_.is_intact()) {
        history_.dilation += fresh_dilation(place, from, to);
        history_.locked_slope = side * fresh_slope(end);
    } else if (!sliding) {
        history_.dilation += direction_ * (to - from) * history_.locked_slope;
    } else {
        const LinearAngle dilation = part_of(piece.dilation, from, to);
        const LinearAngle bound = part_of(piece.bound, from, to);
        // The dilation angle is that of the reference stress. Under a much larger one, at a corner, the
        // strength may be too small to climb it: friction then takes nothing, and gives nothing.
        const auto climbed = [&](double tangent, double strength) {
            return flying_ ? tangent : std::min(tangent, strength);
        };
        history_.dilation += (to - from) * climbed(mean_tangent(dilation.first, dilation.last),
                                                   mean_tangent(bound.first, bound.last));
        const double here =
            side *
            climbed(dilation_tangent(mobilised_.advance_ratio({end, place.side, true})), tan_(bound.last));
        const double rise = tan_(piece.bound.angle_at(to)) - tan_(piece.bound.angle_at(from));
        history_.locked_slope = flying_ ? here
                                        : slope_paid_by_slip(here, history_.locked_slope, direction_,
                                                             {normal_force_, stiffness_, to - from, rise});
    }
    if (law_.floor_dilation) history_.dilation = std::max(history_.dilation, 0.0);
}

double CyclicShearPath::dilation_tangent(double ratio) const {
    return std::max(std::tan(dilation_angle(history_.wear * ratio)), 0.0);
}

// --- before the first slip

/// The dilation angle of the first advance.
double CyclicShearPath::fresh_angle(double distance) const {
    return dilation_angle(mobilised_.first_advance_ratio(distance));
}

/// The largest dilation rate of a fresh joint over its distance from the origin, Eq. (79): its spring bears
/// no more at the reference force.
double CyclicShearPath::largest_climb() const {
    return std::tan(law_.barton.total_angle(dilation_roughness_, 1)) / law_.peak_displacement;
}

/// The dilation rate of a joint that has not slipped, at a distance from its origin.
double CyclicShearPath::fresh_slope(double distance) const {
    return std::clamp(std::tan(fresh_angle(distance)), 0.0, largest_climb() * distance);
}

/// The dilation between two places of a piece, where the angle of the first advance is linear. It is the same
/// on every way.
double CyclicShearPath::fresh_dilation(const Place& place, double from, double to) const {
    const double sign = place.away ? 1 : -1;
    const double first = place.distance + sign * from, last = place.distance + sign * to;
    const double low = std::min(first, last), high = std::max(first, last);
    return sign *
           dilation_before_slip({high - low, fresh_angle(low), fresh_angle(high)}, low, largest_climb());
}

/// The stiffness of the locked joint on a part of a piece, Eq. (77), N/m per metre.
double CyclicShearPath::locked_stiffness(const Place& place, double from, double to) const {
    if (law_.damage == 0 || !mobilised_.is_intact() || !(to > from)) return stiffness_;
    const double reference = history_.spring.normal_force;
    if (!(reference > 0)) return stiffness_;
    const double sign = place.away ? 1 : -1;
    const double change = fresh_slope(place.distance + sign * to) - fresh_slope(place.distance + sign * from);
    const double stiffness = stiffness_ + (normal_force_ - reference) * change * sign / (to - from);
    return std::max(stiffness, least_stiffness * stiffness_);
}

/// Sets the forward direction at the first slip. @return whether the origin has changed with it.
bool CyclicShearPath::begin_slip(const Place& place, int direction) {
    slipped_ = true;
    if (!mobilised_.is_fresh()) return false;
    history_.forward = direction;
    if (place.away) return false;
    // The joint was displaced in the other direction before and slips before it is back: its origin is here.
    target_ -= history_.position;
    history_.position = 0;
    history_.furthest_forward = 0;
    return true;
}

/// Slips until the force equals a bound that has fallen below it; then sets the ratios of the history.
void CyclicShearPath::finish() {
    bounds_ = {bound(1), bound(-1), 0};
    for (const int direction : {1, -1}) {
        if (slip_prescribed_) break;
        const double excess = direction * force_ - (direction > 0 ? bounds_.forward : bounds_.backward);
        if (!(excess > 1e-14 * std::abs(force_))) continue;
        begin_slip(place(direction), direction);
        force_ = direction * bound(direction);
        count_slip(law_, direction, excess / stiffness_, history_);
        bounds_ = {bound(1), bound(-1), 0};
    }
    if (history_.crossed != 0) {
        const int held = static_cast<int>(history_.crossed);
        const double here = bound_of_ratio(held, mobilised_.bound_ratio(place(held)));
        if (history_.position == 0 || !(bound(held) > here)) history_.crossed = 0;
    }
    if (last_side_ == 0 || purpose_ == Purpose::strength) return;
    set_ratios(mobilised_, {std::abs(history_.position), last_side_, last_away_}, history_);
}

}  // namespace rockslope::dda
