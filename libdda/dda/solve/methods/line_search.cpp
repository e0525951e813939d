#include "dda/solve/methods/line_search.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace rockslope::dda {

namespace {

/// Width of the bracket of step lengths at which bisection ends.
constexpr double step_length_tolerance = 1e-6;

}  // namespace

LineSearch::LineSearch(const StepProblem& problem, const TrialContacts& trials, const ThreadPool& pool)
    : p_(problem), trials_(trials), pool_(pool) {
    contacts_.reserve(p_.springs.size());  // one allocation a step, however many contacts have a kink
    kinked_.reserve(p_.springs.size());
}

LineSearch::Sample LineSearch::ContactLine::at(double step_length) const {
    const double o = opening.at(step_length);
    const double s = shearing.at(step_length);
    Sample sample;
    if (law.may_close)
        sample.piece = {law.normal(o) > law.least_normal, law.shear_piece(s),
                        law.largest(s) < law.smallest(s)};
    const Forces forces = law.forces(o, s);
    sample.work =
        (forces.shear - linear.shear) * shearing.rate - (forces.normal - linear.normal) * opening.rate;
    return sample;
}

bool LineSearch::ContactLine::is_linear(const Piece& from, const Piece& to) const {
    return from == to && !from.crossed && (law.normal_law.is_linear() || !from.active);
}

double LineSearch::ContactLine::shear_stiffness(ShearPiece piece) const {
    if (!law.may_close) return 0;
    if (piece == ShearPiece::locked) return law.shear_stiffness;
    return piece == ShearPiece::forward ? law.hardening.forward : law.hardening.backward;
}

double LineSearch::ContactLine::rate(const Piece& piece) const {
    return (piece.active ? law.normal_stiffness() * opening.rate * opening.rate : 0) +
           shear_stiffness(piece.shear) * shearing.rate * shearing.rate;
}

/// The step length of Eq. (34), by bisection.
double LineSearch::step_length(RowSpan<const Vec6> from, RowSpan<const Vec6> target) {
    set_search_direction(from, target);
    const Ends ends = evaluate_ends(target);  // of contacts; bolts are added below
    // Where laws and linear system agree the target is the minimum; the slope would be mere rounding.
    if (ends.largest_difference <= trials_.tolerance()) return 1;
    if (ends.at_target + bolt_work(1) <= 0) return 1;
    if (ends.at_start + bolt_work(0) - curvature_ >= 0) return step_length_tolerance;
    collect_kinked(target);
    double low = 0;
    double high = 1;
    while (high - low > step_length_tolerance) {
        const double middle = (low + high) / 2;
        const bool is_upper = slope(middle) > 0;
        (is_upper ? high : low) = middle;
        shrink_bracket(is_upper, middle);
    }
    return high;
}

void LineSearch::set_search_direction(RowSpan<const Vec6> from, RowSpan<const Vec6> target) {
    search_direction_.resize(target.size());
    const auto curvature_of_rows = [&](std::size_t begin, std::size_t end) {
        double sum = 0;
        for (const RowIndex r : indices<RowIndex>(begin, end)) {
            search_direction_[r] = target[r] - from[r];
            sum += search_direction_[r].dot(p_.base.stiffness[r] * search_direction_[r]);
        }
        return sum;
    };
    curvature_ = pool_.parallel_reduce(target.size(), 0.0, curvature_of_rows, std::plus<>());
    elongation_.clear();
    for (const BoltSpring& b : p_.bolts)
        elongation_.push_back({b.rows.measure(b.elongation, target),
                               b.elongation.direction.dot(b.rows.relative_displacement(search_direction_))});
}

LineSearch::ContactLine LineSearch::line_of(ContactIndex contact, RowSpan<const Vec6> target) const {
    const ContactSprings& s = p_.springs[contact];
    const Vec2 there = s.rows.relative_displacement(target);
    const Vec2 rate = s.rows.relative_displacement(search_direction_);
    ContactLine line;
    const RelativeMeasure normal = trials_.normal_measure(contact);
    line.opening = {normal.at(there), normal.direction.dot(rate)};
    line.shearing = {s.shear.at(there), s.shear.direction.dot(rate)};
    line.linear = trials_.linear_forces(contact, line.opening.end, line.shearing.end);
    line.law = trials_.law(contact);
    return line;
}

LineSearch::Ends LineSearch::evaluate_ends(RowSpan<const Vec6> target) {
    has_kink_.resize(p_.springs.size());
    const auto chunk_value = [&](std::size_t first, std::size_t last) {
        Ends ends;
        for (const ContactIndex k : indices<ContactIndex>(first, last)) {
            const ContactLine line = line_of(k, target);
            const Forces forces = line.law.forces(line.opening.end, line.shearing.end);
            ends.largest_difference =
                std::max({ends.largest_difference, std::abs(forces.normal - line.linear.normal),
                          std::abs(forces.shear - line.linear.shear)});
            const Sample start = line.at(0);
            const Sample end = line.at(1);
            ends.at_start += start.work;
            ends.at_target += end.work;
            const bool is_linear = line.is_linear(start.piece, end.piece);
            has_kink_[k] = is_linear ? 0 : 1;
            if (is_linear) {
                ends.linear_work.end += end.work;
                ends.linear_work.rate += line.rate(end.piece);
            }
        }
        return ends;
    };
    const auto combine = [](const Ends& a, const Ends& b) {
        return Ends{std::max(a.largest_difference, b.largest_difference),
                    a.at_start + b.at_start,
                    a.at_target + b.at_target,
                    {a.linear_work.end + b.linear_work.end, a.linear_work.rate + b.linear_work.rate}};
    };
    const Ends ends = pool_.parallel_reduce(has_kink_.size(), Ends(), chunk_value, combine);
    linear_work_ = ends.linear_work;
    return ends;
}

/// Few contacts have a kink, and a ContactLine needs more memory than any other data of a contact. Computing
/// these few lines again is cheaper than storing the lines of all contacts.
void LineSearch::collect_kinked(RowSpan<const Vec6> target) {
    kinked_.clear();
    for (const ContactIndex k : has_kink_.indices())
        if (has_kink_[k] != 0) kinked_.push_back(k);
    contacts_.resize(kinked_.size());
    pool_.parallel_for(kinked_.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            ContactLine& line = contacts_[i];
            line = line_of(kinked_[i], target);
            line.low = line.at(0).piece;
            line.high = line.at(1).piece;
            kinked_[i] = i;
        }
    });
}

/// The derivative of the potential, Eq. (33), along the step.
double LineSearch::slope(double step_length) {
    const auto chunk_value = [&](std::size_t begin, std::size_t end) {
        double sum = 0;
        for (std::size_t i = begin; i < end; ++i) {
            ContactLine& line = contacts_[kinked_[i]];
            line.middle = line.at(step_length);
            sum += line.middle.work;
        }
        return sum;
    };
    const double without_kinked =
        linear_work_.at(step_length) - (1 - step_length) * curvature_ + bolt_work(step_length);
    return pool_.parallel_reduce(kinked_.size(), without_kinked, chunk_value, std::plus<>());
}

void LineSearch::shrink_bracket(bool is_upper, double step_length) {
    std::size_t kinked_count = 0;
    for (const std::size_t k : kinked_) {
        ContactLine& line = contacts_[k];
        (is_upper ? line.high : line.low) = line.middle.piece;
        if (line.is_linear(line.low, line.high)) {
            const double rate = line.rate(line.low);
            linear_work_.end += line.middle.work + (1 - step_length) * rate;
            linear_work_.rate += rate;
        } else {
            kinked_[kinked_count++] = k;
        }
    }
    kinked_.resize(kinked_count);
}

double LineSearch::bolt_work(double step_length) const {
    double sum = 0;
    for (std::size_t k = 0; k < elongation_.size(); ++k) {
        sum += (trials_.bolts().law_force(k, elongation_[k].at(step_length)) -
                trials_.bolts().linear_force(k, elongation_[k].end)) *
               elongation_[k].rate;
    }
    return sum;
}

}  // namespace rockslope::dda
