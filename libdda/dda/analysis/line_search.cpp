#include "dda/analysis/line_search.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace dda {

namespace {

/// Of the way; bisection ends there.
constexpr double share_tolerance = 1e-6;

}  // namespace

LineSearch::LineSearch(const StepProblem& problem, const TrialContacts& trials, const Crew& crew)
    : p_(problem), trials_(trials), crew_(crew) {
    contacts_.reserve(p_.springs.size());  // once for the step, however many have a kink
    kinked_.reserve(p_.springs.size());
}

LineSearch::Place LineSearch::ContactLine::at(double share) const {
    const double o = opening.at(share);
    const double s = shearing.at(share);
    Place place;
    if (law.may_close) {
        const double elastic = law.shear_origin + law.shear_stiffness * s;
        place.piece = {law.bonded || law.normal(o) > 0, elastic >= law.backward && elastic <= law.forward,
                       elastic > law.forward};
    }
    const Forces forces = law.forces(o, s);
    place.work =
        (forces.shear - linear.shear) * shearing.rate - (forces.normal - linear.normal) * opening.rate;
    return place;
}

bool LineSearch::ContactLine::is_straight(const Piece& from, const Piece& to) const {
    return from == to && (law.closing.is_linear() || !from.pressed);
}

double LineSearch::ContactLine::rate(const Piece& piece) const {
    return (piece.pressed ? law.closing.stiffness * opening.rate * opening.rate : 0) +
           (piece.locked ? law.shear_stiffness * shearing.rate * shearing.rate : 0);
}

double LineSearch::share(std::span<const Vec6> from, std::span<const Vec6> target) {
    find_way(from, target);
    const Ends ends = find_ends(target);
    // Where the law agrees with the linear system its solution is the minimum, whatever rounding makes of the
    // slope.
    if (ends.largest_difference <= trials_.tolerance()) return 1;
    if (ends.at_target + work_of_bolts(1) <= 0) return 1;
    if (ends.at_start + work_of_bolts(0) - curvature_ >= 0) return share_tolerance;
    keep_kinked(target);
    double low = 0;
    double high = 1;
    while (high - low > share_tolerance) {
        const double middle = (low + high) / 2;
        const bool is_upper = slope(middle) > 0;
        (is_upper ? high : low) = middle;
        narrow(is_upper, middle);
    }
    return high;
}

void LineSearch::find_way(std::span<const Vec6> from, std::span<const Vec6> target) {
    way_.resize(target.size());
    const auto curvature_of_rows = [&](std::size_t begin, std::size_t end) {
        double sum = 0;
        for (std::size_t r = begin; r < end; ++r) {
            way_[r] = target[r] - from[r];
            sum += way_[r].dot(p_.base.stiffness[r] * way_[r]);
        }
        return sum;
    };
    curvature_ = crew_.taken_together(target.size(), 0.0, curvature_of_rows, std::plus<>());
    elongation_.clear();
    for (const BoltSpring& b : p_.bolts)
        elongation_.push_back(
            {b.rows.measure(b.elongation, target), b.elongation.direction.dot(b.rows.apart(way_))});
}

LineSearch::ContactLine LineSearch::line_of(std::size_t contact, std::span<const Vec6> target) const {
    const ContactSprings& s = p_.springs[contact];
    const Vec2 there = s.rows.apart(target);
    const Vec2 rate = s.rows.apart(way_);
    ContactLine line;
    line.opening = {s.normal.at(there), s.normal.direction.dot(rate)};
    line.shearing = {s.shear.at(there), s.shear.direction.dot(rate)};
    line.linear = trials_.linear_forces(contact, line.opening.end, line.shearing.end);
    line.law = trials_.law(contact);
    return line;
}

LineSearch::Ends LineSearch::find_ends(std::span<const Vec6> target) {
    has_kink_.resize(p_.springs.size());
    const auto of_portion = [&](std::size_t begin, std::size_t end) {
        Ends ends;
        for (std::size_t k = begin; k < end; ++k) {
            const ContactLine line = line_of(k, target);
            const Forces forces = line.law.forces(line.opening.end, line.shearing.end);
            ends.largest_difference =
                std::max({ends.largest_difference, std::abs(forces.normal - line.linear.normal),
                          std::abs(forces.shear - line.linear.shear)});
            const Place start = line.at(0);
            const Place there = line.at(1);
            ends.at_start += start.work;
            ends.at_target += there.work;
            const bool straight = line.is_straight(start.piece, there.piece);
            has_kink_[k] = straight ? 0 : 1;
            if (straight) {
                ends.straight.end += there.work;
                ends.straight.rate += line.rate(there.piece);
            }
        }
        return ends;
    };
    const auto both = [](const Ends& a, const Ends& b) {
        return Ends{std::max(a.largest_difference, b.largest_difference),
                    a.at_start + b.at_start,
                    a.at_target + b.at_target,
                    {a.straight.end + b.straight.end, a.straight.rate + b.straight.rate}};
    };
    const Ends ends = crew_.taken_together(has_kink_.size(), Ends(), of_portion, both);
    straight_ = ends.straight;
    return ends;
}

/// Few contacts have a kink, and what is known of them takes more memory than anything else that a contact
/// has: theirs is found once more rather than everyone's kept.
void LineSearch::keep_kinked(std::span<const Vec6> target) {
    kinked_.clear();
    for (std::size_t k = 0; k < has_kink_.size(); ++k)
        if (has_kink_[k] != 0) kinked_.push_back(k);
    contacts_.resize(kinked_.size());
    crew_.for_ranges(kinked_.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            ContactLine& line = contacts_[i];
            line = line_of(kinked_[i], target);
            line.low = line.at(0).piece;
            line.high = line.at(1).piece;
            kinked_[i] = i;
        }
    });
}

double LineSearch::slope(double share) {
    const auto of_portion = [&](std::size_t begin, std::size_t end) {
        double sum = 0;
        for (std::size_t i = begin; i < end; ++i) {
            ContactLine& line = contacts_[kinked_[i]];
            line.middle = line.at(share);
            sum += line.middle.work;
        }
        return sum;
    };
    const double straight = straight_.at(share) - (1 - share) * curvature_ + work_of_bolts(share);
    return crew_.taken_together(kinked_.size(), straight, of_portion, std::plus<>());
}

void LineSearch::narrow(bool is_upper, double share) {
    std::size_t kept = 0;
    for (const std::size_t k : kinked_) {
        ContactLine& line = contacts_[k];
        (is_upper ? line.high : line.low) = line.middle.piece;
        if (line.is_straight(line.low, line.high)) {
            const double rate = line.rate(line.low);
            straight_.end += line.middle.work + (1 - share) * rate;
            straight_.rate += rate;
        } else {
            kinked_[kept++] = k;
        }
    }
    kinked_.resize(kept);
}

double LineSearch::work_of_bolts(double share) const {
    double sum = 0;
    for (std::size_t k = 0; k < elongation_.size(); ++k) {
        sum += (trials_.law_bolt_force(k, elongation_[k].at(share)) -
                trials_.linear_bolt_force(k, elongation_[k].end)) *
               elongation_[k].rate;
    }
    return sum;
}

}  // namespace dda
