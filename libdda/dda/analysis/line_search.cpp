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
        for (const ContactSprings& s : problem.springs) {
            opening_.push_back(line(s.rows, s.normal));
            shearing_.push_back(line(s.rows, s.shear));
        }
        for (const BoltSpring& b : problem.bolts) elongation_.push_back(line(b.rows, b.elongation));
    }

    /// Between the laws' forces and the linear ones, at the target.
    double largest_difference() const {
        double largest = 0;
        for (std::size_t k = 0; k < opening_.size(); ++k) {
            const Forces linear = trials_.linear_forces(k, opening_[k].end, shearing_[k].end);
            const Forces law = trials_.law_forces(k, opening_[k].end, shearing_[k].end);
            largest =
                std::max({largest, std::abs(law.normal - linear.normal), std::abs(law.shear - linear.shear)});
        }
        return largest;
    }

    double slope(double share) const {
        double sum = -(1 - share) * curvature_;
        for (std::size_t k = 0; k < opening_.size(); ++k) {
            const Forces linear = trials_.linear_forces(k, opening_[k].end, shearing_[k].end);
            const Forces law = trials_.law_forces(k, opening_[k].at(share), shearing_[k].at(share));
            sum += -(law.normal - linear.normal) * opening_[k].rate +
                   (law.shear - linear.shear) * shearing_[k].rate;
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
    std::vector<Line> opening_;
    std::vector<Line> shearing_;
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
