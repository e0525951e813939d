#include "dda/analysis/line_search.hpp"

#include <algorithm>
#include <cmath>

namespace dda {

namespace {

/// Evaluations of the potential's slope; each halves the bracket.
constexpr int line_search_evaluations = 40;

/// A measure along the way: `end` at the target.
struct Line {
    double end = 0;
    double rate = 0;
    double at(double share) const { return end - (1 - share) * rate; }
};

/// A contact's measures, the forces that the linear system gives it at the target, and its laws.
struct ContactLine {
    Line opening;
    Line shearing;
    Forces linear;
    ContactLaw law;
};

class Way {
  public:
    Way(const StepProblem& problem, const TrialContacts& trials, std::span<const Vec6> from,
        std::span<const Vec6> target)
        : trials_(trials) {
        std::vector<Vec6> way(target.size());
        for (std::size_t r = 0; r < target.size(); ++r) {
            way[r] = target[r] - from[r];
            curvature_ += way[r].dot(problem.base.stiffness[r] * way[r]);
        }
        const auto line = [&](const PairRows& rows, const Relative& relative) {
            return Line{rows.measure(relative, target), rows.measure(relative, way) - relative.known};
        };
        contacts_.reserve(problem.springs.size());
        for (std::size_t k = 0; k < problem.springs.size(); ++k) {
            const ContactSprings& s = problem.springs[k];
            const Line opening = line(s.rows, s.normal);
            const Line shearing = line(s.rows, s.shear);
            contacts_.push_back(
                {opening, shearing, trials.linear_forces(k, opening.end, shearing.end), trials.law(k)});
        }
        for (const BoltSpring& b : problem.bolts) elongation_.push_back(line(b.rows, b.elongation));
    }

    /// Between the laws' forces and the linear ones, at the target.
    double largest_difference() const {
        double largest = 0;
        for (const auto& [opening, shearing, linear, law] : contacts_) {
            const Forces forces = law.forces(opening.end, shearing.end);
            largest = std::max(
                {largest, std::abs(forces.normal - linear.normal), std::abs(forces.shear - linear.shear)});
        }
        return largest;
    }

    double slope(double share) const {
        double sum = -(1 - share) * curvature_;
        for (const auto& [opening, shearing, linear, law] : contacts_) {
            const Forces forces = law.forces(opening.at(share), shearing.at(share));
            sum += -(forces.normal - linear.normal) * opening.rate +
                   (forces.shear - linear.shear) * shearing.rate;
        }
        for (std::size_t k = 0; k < elongation_.size(); ++k) {
            sum += (trials_.law_bolt_force(k, elongation_[k].at(share)) -
                    trials_.linear_bolt_force(k, elongation_[k].end)) *
                   elongation_[k].rate;
        }
        return sum;
    }

  private:
    const TrialContacts& trials_;
    double curvature_ = 0;
    std::vector<ContactLine> contacts_;
    std::vector<Line> elongation_;
};

}  // namespace

double line_search(const StepProblem& problem, const TrialContacts& trials, std::span<const Vec6> from,
                   std::span<const Vec6> target) {
    const Way way(problem, trials, from, target);
    // Where the law agrees with the linear system its solution is the minimum, whatever rounding makes of the
    // slope.
    if (way.largest_difference() <= trials.tolerance() || way.slope(1) <= 0) return 1;
    double low = 0;
    double high = 1;
    for (int k = 0; k < line_search_evaluations && high - low > 1e-6; ++k) {
        const double middle = (low + high) / 2;
        (way.slope(middle) > 0 ? high : low) = middle;
    }
    return high;
}

}  // namespace dda
