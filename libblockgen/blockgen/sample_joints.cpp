#include "blockgen/sample_joints.hpp"

#include <Random123/philox.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "blockgen/clip_line.hpp"

namespace blockgen {

namespace {

/// What a draw is for; a number here is part of every result ever made with a seed.
enum Purpose : std::uint64_t {
    phase = 0,
    spacing_forward = 1,
    spacing_backward = 2,
    trace = 3,
    bridge = 4,
    direction = 5,
    start = 6
};

/// FNV-1a.
std::uint64_t hash_of(const std::string& name) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
    return hash;
}

struct Interval {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    void include(double x) { low = std::min(low, x), high = std::max(high, x); }
};

class ParallelSet {
  public:
    ParallelSet(const JointSet& set, const SlopeModel& model, std::size_t most_draws)
        : set_(set), draws_(model.seed, set.name), bounds_(bounds_of(set, model)), most_draws_(most_draws) {
        const double mean_angle = set.angle.untruncated_mean();
        across_ = {-std::sin(mean_angle), std::cos(mean_angle)};
        centre_ = {(bounds_.low.x + bounds_.high.x) / 2, (bounds_.low.y + bounds_.high.y) / 2};
        radius_ = std::hypot(bounds_.high.x - bounds_.low.x, bounds_.high.y - bounds_.low.y) / 2;
        for (const Point& p : bounds_.corners()) reach_.include(along(across_, p));
        // Lines that are not parallel to the mean direction may enter the box from beyond its own width
        // across the set.
        if (set.angle.law != Law::constant)
            reach_ = {along(across_, centre_) - radius_, along(across_, centre_) + radius_};
    }

    std::vector<Trace> sample() {
        const double first = set_.origin ? along(across_, *set_.origin)
                                         : reach_.low + draws_.draw(phase, 0, 0) *
                                                            set_.spacing.quantile(draws_.draw(phase, 0, 1));
        double offset = first;
        for (std::int64_t line = 0; offset <= reach_.high; ++line) {
            count_draw();
            add_line(line, offset);
            offset +=
                set_.spacing.quantile(draws_.draw(spacing_forward, 0, static_cast<std::uint64_t>(line)));
        }
        offset = first;
        for (std::int64_t line = -1;; --line) {
            count_draw();
            offset -=
                set_.spacing.quantile(draws_.draw(spacing_backward, 0, static_cast<std::uint64_t>(-line)));
            if (offset < reach_.low) break;
            add_line(line, offset);
        }
        return std::move(traces_);
    }

  private:
    static double along(const Point& direction, const Point& p) {
        return direction.x * p.x + direction.y * p.y;
    }

    static Bounds bounds_of(const JointSet& set, const SlopeModel& model) {
        for (const Region& region : model.regions)
            if (region.name == set.region) return Bounds::of(region.polygon);
        return Bounds::of(model.outline);
    }

    /// Counts the lines between the origin and the far side of the box, and the traces on them: what takes
    /// time.
    void count_draw() {
        if (++draw_count_ > most_draws_)
            throw InputError(set_.place,
                             "joint set '" + set_.name + "' needs more than " + std::to_string(most_draws_) +
                                 " lines and traces",
                             "a wider spacing, longer traces or gaps, or an origin nearer to the domain");
    }

    /// The joints of one line, whose distance across the set is `offset`.
    void add_line(std::int64_t line, double offset) {
        if (offset < reach_.low) return;
        const double angle = set_.angle.quantile(draws_.draw(direction, line, 0));
        const Point u{std::cos(angle), std::sin(angle)};
        const double shift = offset - along(across_, centre_);
        const Point middle{centre_.x + shift * across_.x, centre_.y + shift * across_.y};
        const auto inside = bounds_.clip(middle, u);
        if (!inside) return;
        const auto add = [&](double from, double to) {
            if (from < to)
                traces_.push_back({set_.name,
                                   set_.joint_material,
                                   {{middle.x + from * u.x, middle.y + from * u.y},
                                    {middle.x + to * u.x, middle.y + to * u.y}}});
        };
        if (!set_.trace_length) return add(inside->first, inside->second);
        // Some cycles before the box the pattern has forgotten where it began.
        const double cycle = set_.trace_length->untruncated_mean() + set_.gap->untruncated_mean();
        double t = inside->first - (8 + draws_.draw(start, line, 0)) * cycle;
        for (std::uint64_t k = 0; t < inside->second; ++k) {
            count_draw();
            const double end = t + set_.trace_length->quantile(draws_.draw(trace, line, k));
            add(std::max(t, inside->first), std::min(end, inside->second));
            t = end + set_.gap->quantile(draws_.draw(bridge, line, k));
        }
    }

    const JointSet& set_;
    DrawStream draws_;
    Bounds bounds_;
    std::size_t most_draws_;
    std::size_t draw_count_ = 0;
    Point across_, centre_;
    double radius_ = 0;
    Interval reach_;
    std::vector<Trace> traces_;
};

}  // namespace

DrawStream::DrawStream(std::uint64_t seed, const std::string& name) : seed_(seed), name_(hash_of(name)) {}

double DrawStream::draw(std::uint64_t purpose, std::int64_t line, std::uint64_t index) const {
    const r123::Philox4x64::ctr_type counter = {{index, static_cast<std::uint64_t>(line), purpose, 0}};
    const r123::Philox4x64::key_type key = {{seed_, name_}};
    const std::uint64_t bits = r123::Philox4x64()(counter, key)[0];
    return (static_cast<double>(bits >> 12u) + 0.5) * 0x1p-52;
}

std::vector<Trace> sample_joint_set(const JointSet& set, const SlopeModel& model, std::size_t most_draws) {
    std::vector<Trace> traces = ParallelSet(set, model, most_draws).sample();
    for (const Region& region : model.regions) {
        if (region.name != set.region) continue;
        std::vector<Trace> clipped;
        for (const Trace& trace : traces)
            for (const auto& [a, b] : clip_to_ring(trace.points[0], trace.points[1], region.polygon))
                clipped.push_back({trace.name, trace.joint_material, {a, b}});
        return clipped;
    }
    return traces;
}

}  // namespace blockgen
