#include <algorithm>
#include <cmath>

#include "blockgen/input/trace_length.hpp"
#include "blockgen/sampling/rock_domain.hpp"
#include "blockgen/sampling/set_sampler.hpp"

namespace rockslope::blockgen {

namespace {

using Measure = StopRule::Measure;

/// Sum of the stop rule's measure over the traces sampled so far.
class StopRuleProgress {
  public:
    StopRuleProgress(const JointSet& set, const RockDomain& rock) : set_(set), rock_(rock) {
        const double mean = set.orientation.mean_angle();
        u_ = {std::cos(mean), std::sin(mean)};
        const bool per_area = set.stop.measure != Measure::count;
        target_ = set.stop.target * (per_area ? rock.area() : 1);
    }

    /// Contribution of a group of traces: one trace of a Baecher set, or the traces of one line of a
    /// Veneziano set.
    double contribution_of(const std::vector<Trace>& group, bool is_line) const {
        double sum = 0;
        for (const Trace& trace : group) {
            if (is_counted() && !is_line)
                sum += rock_.contains(middle_of(trace));
            else
                for (std::size_t k = 0; k + 1 < trace.points.size(); ++k)
                    sum += measure_of(trace.points[k], trace.points[k + 1]);
        }
        return is_line && is_counted() ? sum > 0 : sum;
    }

    /// Contribution of mapped traces. A trace counts as a line of its own; where traces run along each other
    /// their length counts once.
    double contribution_of_mapped(const std::vector<Trace>& mapped, bool lines) const {
        double sum = 0;
        for (const Trace& trace : mapped) sum += contribution_of({trace}, lines);
        if (is_counted() || mapped.empty()) return sum;
        for (const auto& [a, b] : rock_.repeated_pieces(mapped)) sum -= measure_of(a, b);
        return sum;
    }

    /// Whether the sum is nearer to the target with a contribution than without it.
    bool accepts(double contribution) const {
        return std::abs(sum_ + contribution - target_) <= std::abs(sum_ - target_);
    }
    void add(double contribution) { sum_ += contribution; }
    bool is_met_with(double contribution) const { return sum_ + contribution >= target_; }
    bool is_met() const { return sum_ > 0 && is_met_with(0); }

  private:
    bool is_counted() const {
        return set_.stop.measure == Measure::count || set_.stop.measure == Measure::p20;
    }

    /// What a piece of a trace adds to P21, or to P10.
    double measure_of(const Point& a, const Point& b) const {
        const double length = std::hypot(b.x - a.x, b.y - a.y);
        if (!(length > 0)) return 0;
        const double along = std::abs((b.x - a.x) * u_.x + (b.y - a.y) * u_.y);
        return rock_.length_in(a, b) * (set_.stop.measure == Measure::p10 ? along / length : 1);
    }

    const JointSet& set_;
    const RockDomain& rock_;
    Point u_;
    double target_ = 0, sum_ = 0;
};

/// Adds groups of traces in the order of their numbers until, with the mapped traces, the stop rule is met.
template <class Group>
std::vector<Trace> sample_until_complete(SetSampler& sampler, const RockDomain& rock, bool lines,
                                         const std::vector<Trace>& mapped, const Group& group) {
    StopRuleProgress progress(sampler.set(), rock);
    progress.add(progress.contribution_of_mapped(mapped, lines));
    std::vector<Trace> all;
    if (progress.is_met()) return all;
    for (std::int64_t k = 0;; ++k) {
        sampler.count_draw();
        std::vector<Trace> traces = group(k);
        const double contribution = progress.contribution_of(traces, lines);
        const bool last = progress.is_met_with(contribution);
        if (!last || progress.accepts(contribution)) {
            progress.add(contribution);
            std::move(traces.begin(), traces.end(), std::back_inserter(all));
        }
        if (last) return all;
    }
}

}  // namespace

Bounds baecher_window(const SetSampler& sampler) {
    // The window contains the midpoint of each trace that may reach the box, except for lengths above the
    // quantile 1 - 1e-6.
    const Distribution& length = *sampler.set().trace_length;
    const double longest = length.law == Law::constant ? length.mean : length.quantile(1 - 1e-6);
    return sampler.bounds().expanded(longest / 2);
}

std::vector<Trace> sample_baecher(SetSampler& sampler, const RockDomain& rock,
                                  const std::vector<Trace>& mapped) {
    const Distribution& length = *sampler.set().trace_length;
    const Bounds window = baecher_window(sampler);
    const RandomStream& draws = sampler.draws();
    return sample_until_complete(sampler, rock, false, mapped, [&](std::int64_t k) {
        const Point middle{window.low.x + draws.draw(draw_place, k, 0) * (window.high.x - window.low.x),
                           window.low.y + draws.draw(draw_place, k, 1) * (window.high.y - window.low.y)};
        const Point u = sampler.direction(k);
        const double half = length.quantile(draws.draw(draw_trace, k, 0)) / 2;
        return std::vector<Trace>{sampler.trace(k, {middle.x - half * u.x, middle.y - half * u.y},
                                                {middle.x + half * u.x, middle.y + half * u.y})};
    });
}

std::vector<Trace> sample_veneziano(SetSampler& sampler, const RockDomain& rock,
                                    const std::vector<Trace>& mapped) {
    // Lines through the circle around the box, at a uniformly distributed signed distance from its centre.
    return sample_until_complete(sampler, rock, true, mapped, [&](std::int64_t k) {
        const Point u = sampler.direction(k);
        const double shift = (2 * sampler.draws().draw(draw_place, k, 0) - 1) * sampler.radius();
        const Point middle{sampler.centre().x - shift * u.y, sampler.centre().y + shift * u.x};
        std::vector<Trace> traces;
        if (const auto inside = sampler.bounds().clip(middle, u))
            sampler.add_traces(k, middle, u, inside->first, inside->second, traces);
        return traces;
    });
}

}  // namespace rockslope::blockgen
