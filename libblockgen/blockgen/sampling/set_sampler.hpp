#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "blockgen/input/slope_model.hpp"
#include "blockgen/sampling/random_stream.hpp"
#include "common/geometry/clip_line.hpp"

namespace rockslope::blockgen {

/// What every kind of set is sampled with: its draws, the box that it must fill, and a limit on the work.
class SetSampler {
  public:
    /// The box is the domain's, or that of the set's region.
    SetSampler(const JointSet& set, const SlopeModel& model, std::size_t max_draws);

    const JointSet& set() const { return set_; }
    const RandomStream& draws() const { return draws_; }
    const Bounds& bounds() const { return bounds_; }
    const Point& centre() const { return centre_; }
    /// Half the diagonal of the box.
    double radius() const { return radius_; }

    /// The direction of joint `line`, a unit vector.
    Point direction(std::int64_t line) const;
    Trace trace(const Point& a, const Point& b) const;

    /// Alternates trace and rock bridge along `middle` + t u and adds the traces that reach into [low, high],
    /// whole, so that their middles tell how many there are; or one from `low` to `high` when the set's
    /// joints are unlimited. The pattern starts some cycles before, where it has forgotten how.
    void add_traces(std::int64_t line, const Point& middle, const Point& u, double low, double high,
                    std::vector<Trace>& traces);

    std::size_t max_draws() const { return max_draws_; }
    std::size_t draw_count() const { return draw_count_; }
    /// Counts a line or trace. @throws InputError beyond the limit.
    void count_draw();
    /// @param count of lines and traces, in words. @throws InputError always.
    [[noreturn]] void fail_too_many(const std::string& count) const;

  private:
    const JointSet& set_;
    RandomStream draws_;
    Bounds bounds_;
    std::size_t max_draws_;
    std::size_t draw_count_ = 0;
    Point centre_;
    double radius_ = 0;
};

/// A line of a parallel or cross-jointed set: middle + t u for t in [low, high].
struct SetLine {
    std::int64_t number = 0;
    Point middle, u;
    double low = 0, high = 0;
};

/// A unit vector across the mean direction of a set.
Point mean_normal(const JointSet& set);

/// A point of the scanline across the mean direction on which the spacings are measured: the set's origin, or
/// what of the box is nearest to it; without one the middle of the box.
Point scanline_point(const SetSampler& sampler);

/// The distances along mean_normal() within which lines cross the scanline that may meet the box, and that of
/// the set's origin, where it has one; otherwise `origin` is the lower of them.
struct OffsetRange {
    double low = 0, high = 0, origin = 0;
};
/// @param max_deviation_tangent tangent between a line and the mean direction. @param margin by which the box
/// is widened, m.
OffsetRange offset_range(const SetSampler& sampler, double max_deviation_tangent, double margin = 0);

/// The lines of a set that meet the box. They cross the scanline at the set's spacings, counted from the
/// origin to both sides, each in a direction of its own. Where they cross and how they lie are independent,
/// so that every other line across the mean direction is met as often, by 1 / mean spacing: their P10,
/// however their directions scatter. Their P21 is that times the mean of 1 / cos of the angle to the mean
/// direction.
/// @param margin by which the box is widened, m.
std::vector<SetLine> spaced_lines(SetSampler& sampler, double margin = 0);

std::vector<Trace> sample_parallel(SetSampler& sampler);
/// Where the middles of Baecher's traces lie: the box, widened so that its rim is as densely jointed as its
/// middle.
Bounds baecher_window(const SetSampler& sampler);
/// Where the points of Voronoi cells lie: the box and ten cells more, which bound those that reach into it.
Bounds voronoi_window(const SetSampler& sampler, double rock_area);
/// Traces and lines anywhere, until the stop rule is met as nearly as it can be. @param rock the area and the
/// length of a trace that count for it.
std::vector<Trace> sample_baecher(SetSampler& sampler, const class RockDomain& rock);
std::vector<Trace> sample_veneziano(SetSampler& sampler, const class RockDomain& rock);
/// @param others the traces at which the joints may end.
std::vector<Trace> sample_cross_joints(SetSampler& sampler, const std::vector<Trace>& others);
std::vector<Trace> sample_voronoi(SetSampler& sampler, const class RockDomain& rock);

}  // namespace rockslope::blockgen
