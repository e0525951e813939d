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
    : p_(problem), trials_(trials), crew_(crew) {}

double LineSearch::share(std::span<const Vec6> from, std::span<const Vec6> target) {
    draw(from, target);
    // Where the law agrees with the linear system its solution is the minimum, whatever rounding makes of the
    // slope.
    if (largest_difference() <= trials_.tolerance()) return 1;
    if (slope(1) <= 0) return 1;
    if (slope(0) >= 0) return share_tolerance;
    double low = 0;
    double high = 1;
    while (high - low > share_tolerance) {
        const double middle = (low + high) / 2;
        (slope(middle) > 0 ? high : low) = middle;
    }
    return high;
}

void LineSearch::draw(std::span<const Vec6> from, std::span<const Vec6> target) {
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
    contacts_.resize(p_.springs.size());
    crew_.for_ranges(contacts_.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) contacts_[k] = line_of(k, target);
    });
    elongation_.clear();
    for (const BoltSpring& b : p_.bolts)
        elongation_.push_back(
            {b.rows.measure(b.elongation, target), b.elongation.direction.dot(b.rows.apart(way_))});
}

LineSearch::ContactLine LineSearch::line_of(std::size_t contact, std::span<const Vec6> target) const {
    const ContactSprings& s = p_.springs[contact];
    const Vec2 there = s.rows.apart(target);
    const Vec2 rate = s.rows.apart(way_);
    const Line opening{s.normal.at(there), s.normal.direction.dot(rate)};
    const Line shearing{s.shear.at(there), s.shear.direction.dot(rate)};
    return {opening, shearing, trials_.linear_forces(contact, opening.end, shearing.end),
            trials_.law(contact)};
}

double LineSearch::largest_difference() const {
    const auto of_portion = [&](std::size_t begin, std::size_t end) {
        double largest = 0;
        for (std::size_t k = begin; k < end; ++k) {
            const auto& [opening, shearing, linear, law] = contacts_[k];
            const Forces forces = law.forces(opening.end, shearing.end);
            largest = std::max(
                {largest, std::abs(forces.normal - linear.normal), std::abs(forces.shear - linear.shear)});
        }
        return largest;
    };
    return crew_.taken_together(contacts_.size(), 0.0, of_portion,
                                [](double a, double b) { return std::max(a, b); });
}

double LineSearch::slope(double share) const {
    const auto of_portion = [&](std::size_t begin, std::size_t end) {
        double sum = 0;
        for (std::size_t k = begin; k < end; ++k) {
            const auto& [opening, shearing, linear, law] = contacts_[k];
            const Forces forces = law.forces(opening.at(share), shearing.at(share));
            sum += -(forces.normal - linear.normal) * opening.rate +
                   (forces.shear - linear.shear) * shearing.rate;
        }
        return sum;
    };
    double sum = crew_.taken_together(contacts_.size(), -(1 - share) * curvature_, of_portion, std::plus<>());
    for (std::size_t k = 0; k < elongation_.size(); ++k) {
        sum += (trials_.law_bolt_force(k, elongation_[k].at(share)) -
                trials_.linear_bolt_force(k, elongation_[k].end)) *
               elongation_[k].rate;
    }
    return sum;
}

}  // namespace dda
