#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "blockgen/input/slope_model.hpp"
#include "blockgen/sampling/random_stream.hpp"
#include "common/geometry/clip_line.hpp"

namespace rockslope::blockgen {

/// Largest number of lines and traces that may be drawn for the sets of a model.
struct DrawLimit {
    std::size_t max_blocks = 1'000'000;  ///< of which it follows: max_blocks + `allowance`
    std::size_t drawn = 0;               ///< by the sets before
    /// Allows many unconnected joints under a small limit. A million lines and traces take about 1.2 GB.
    static constexpr std::size_t allowance = 10'000;

    /// Number that is left.
    std::size_t left() const { return max_blocks + allowance - std::min(max_blocks + allowance, drawn); }
};

/// Context for sampling a joint set of any kind: its random stream, the box to fill, and the limit on draws.
class SetSampler {
  public:
    /// The box is the bounding box of the domain, or of the set's region.
    SetSampler(const JointSet& set, const SlopeModel& model, const DrawLimit& limit);

    /// The joint set that is sampled.
    const JointSet& set() const { return set_; }
    /// The random numbers of the set.
    const RandomStream& draws() const { return draws_; }
    const Bounds& bounds() const { return bounds_; }
    const Point& centre() const { return centre_; }
    /// Half the diagonal of the box, m.
    double radius() const { return radius_; }

    /// The direction of joint `line`, a unit vector.
    Point direction(std::int64_t line) const;
    /// The plane in space of joint `line`, of a set that is given by such planes.
    Pole plane(std::int64_t line) const;
    /// A trace of joint `line`; nothing for a joint without a direction of its own.
    Trace trace(std::optional<std::int64_t> line, const Point& a, const Point& b) const;

    /// Samples alternating traces and rock bridges along `middle` + t u. Adds the traces that overlap
    /// [low, high], unclipped, so that their midpoints give the right number per area. Adds one trace from
    /// `low` to `high` when the joints of the set are persistent. The pattern starts eight to nine mean
    /// cycles before `low`, so that its start has no effect on [low, high].
    void add_traces(std::int64_t line, const Point& middle, const Point& u, double low, double high,
                    std::vector<Trace>& traces);

    /// The limit of lines and traces.
    std::size_t max_draws() const { return limit_.left(); }
    /// Number of lines and traces so far.
    std::size_t draw_count() const { return draw_count_; }
    /// Counts a line or trace. @throws InputError beyond the limit.
    void count_draw();
    /// @param count number of lines and traces, as text. @throws InputError always.
    [[noreturn]] void fail_too_many(const std::string& count) const;

  private:
    const JointSet& set_;
    RandomStream draws_;
    Bounds bounds_;
    DrawLimit limit_;
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

/// A unit vector perpendicular to the mean direction of a set.
Point mean_normal(const JointSet& set);

/// A point of the scanline, which is perpendicular to the mean direction and along which the spacings are
/// measured: the point of the box nearest to the set's origin, or the centre of the box without an origin.
Point scanline_point(const SetSampler& sampler);

/// Range of distances along mean_normal() at which a line that may meet the box crosses the scanline, m.
/// `origin` is the distance of the set's origin; it equals `low` without an origin.
struct OffsetRange {
    double low = 0, high = 0, origin = 0;
};
/// @param max_deviation_tangent tangent of the largest angle between a line and the mean direction.
/// @param margin by which the box is widened, m.
OffsetRange offset_range(const SetSampler& sampler, double max_deviation_tangent, double margin = 0);

/// The lines of a set that meet the box. They cross the scanline at the set's spacings, from the origin to
/// both sides, each with its own direction. Position and direction are independent. Hence P10, the frequency
/// on any line perpendicular to the mean direction, is 1 / mean spacing for any scatter of the directions.
/// P21 is P10 times the mean of 1 / cos of the angle to the mean direction.
/// @param margin by which the box is widened, m.
std::vector<SetLine> spaced_lines(SetSampler& sampler, double margin = 0);

std::vector<Trace> sample_parallel(SetSampler& sampler);
/// Window for the midpoints of a Baecher set: the box, widened to avoid edge effects.
Bounds baecher_window(const SetSampler& sampler);
/// Window for the points of a Voronoi set: the box, widened by ten cells, so that all cells in the box are
/// bounded.
Bounds voronoi_window(const SetSampler& sampler, double rock_area);
/// Random traces or lines until the measure of the stop rule, with that of mapped traces, is as near to its
/// target as possible. @param rock the rock in which areas and lengths are measured.
std::vector<Trace> sample_baecher(SetSampler& sampler, const class RockDomain& rock,
                                  const std::vector<Trace>& mapped);
std::vector<Trace> sample_veneziano(SetSampler& sampler, const class RockDomain& rock,
                                    const std::vector<Trace>& mapped);
/// @param others the traces at which the joints may end.
std::vector<Trace> sample_cross_joints(SetSampler& sampler, const std::vector<Trace>& others);
std::vector<Trace> sample_voronoi(SetSampler& sampler, const class RockDomain& rock);

}  // namespace rockslope::blockgen
