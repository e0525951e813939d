#include <algorithm>
#include <cmath>

#include "blockgen/sampling/rock_domain.hpp"
#include "blockgen/sampling/set_sampler.hpp"

namespace rockslope::blockgen {

namespace {

using Measure = StopRule::Measure;

/// Adds up what the stop rule counts, trace by trace.
class StopRuleProgress {
  public:
    StopRuleProgress(const JointSet& set, const RockDomain& rock) : set_(set), rock_(rock) {
        const double mean = set.orientation.mean_angle();
        u_ = {std::cos(mean), std::sin(mean)};
        const bool per_area = set.stop.measure != Measure::count;
        target_ = set.stop.target * (per_area ? rock.area() : 1);
    }

    /// What a group of traces adds: one trace of Baecher's, the traces of one line of Veneziano's.
    double contribution_of(const std::vector<Trace>& group, bool is_line) const {
        double share = 0;
        for (const Trace& trace : group) {
            const Point &a = trace.points[0], &b = trace.points[1];
            const double length = std::hypot(b.x - a.x, b.y - a.y);
            const double along = std::abs((b.x - a.x) * u_.x + (b.y - a.y) * u_.y);
            if (is_counted() && !is_line)
                share += rock_.contains({(a.x + b.x) / 2, (a.y + b.y) / 2});
            else if (length > 0)
                share += rock_.length_in(a, b) * (set_.stop.measure == Measure::p10 ? along / length : 1);
        }
        return is_line && is_counted() ? share > 0 : share;
    }

    /// Whether a group belongs to the set: while the sum is nearer to the target with it than without.
    bool accepts(double share) const { return std::abs(sum_ + share - target_) <= std::abs(sum_ - target_); }
    void add(double share) { sum_ += share; }
    bool is_met(double share) const { return sum_ + share >= target_; }

  private:
    bool is_counted() const {
        return set_.stop.measure == Measure::count || set_.stop.measure == Measure::p20;
    }

    const JointSet& set_;
    const RockDomain& rock_;
    Point u_;
    double target_ = 0, sum_ = 0;
};

/// Takes groups in the order of their numbers until the stop rule is met.
template <class Group>
std::vector<Trace> sample_until_complete(SetSampler& sampler, const RockDomain& rock, bool lines,
                                         const Group& group) {
    StopRuleProgress counter(sampler.set(), rock);
    std::vector<Trace> all;
    for (std::int64_t k = 0;; ++k) {
        sampler.count_draw();
        std::vector<Trace> traces = group(k);
        const double share = counter.contribution_of(traces, lines);
        const bool last = counter.is_met(share);
        if (!last || counter.accepts(share)) {
            counter.add(share);
            std::move(traces.begin(), traces.end(), std::back_inserter(all));
        }
        if (last) return all;
    }
}

}  // namespace

Bounds baecher_window(const SetSampler& sampler) {
    // It holds the middle of every trace that may reach the box, but for one in a million by length.
    const Distribution& length = *sampler.set().trace_length;
    const double longest = length.law == Law::constant ? length.mean : length.quantile(1 - 1e-6);
    return sampler.bounds().expanded(longest / 2);
}

std::vector<Trace> sample_baecher(SetSampler& sampler, const RockDomain& rock) {
    const Distribution& length = *sampler.set().trace_length;
    const Bounds window = baecher_window(sampler);
    const RandomStream& draws = sampler.draws();
    return sample_until_complete(sampler, rock, false, [&](std::int64_t k) {
        const Point middle{window.low.x + draws.draw(draw_place, k, 0) * (window.high.x - window.low.x),
                           window.low.y + draws.draw(draw_place, k, 1) * (window.high.y - window.low.y)};
        const Point u = sampler.direction(k);
        const double half = length.quantile(draws.draw(draw_trace, k, 0)) / 2;
        return std::vector<Trace>{sampler.trace({middle.x - half * u.x, middle.y - half * u.y},
                                                {middle.x + half * u.x, middle.y + half * u.y})};
    });
}

std::vector<Trace> sample_veneziano(SetSampler& sampler, const RockDomain& rock) {
    // Lines across the circle round the box, at a distance from its middle that is anywhere on the diameter.
    return sample_until_complete(sampler, rock, true, [&](std::int64_t k) {
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
