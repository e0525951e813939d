#include <algorithm>
#include <cmath>

#include "blockgen/sampling/set_sampler.hpp"
#include "blockgen/sampling/trace_index.hpp"

namespace rockslope::blockgen {

namespace {

/// Extends the traces that end on the boundary of a box, as lines that cross it do, straight on beyond it.
std::vector<Trace> extended_beyond_box(std::vector<Trace> traces, const Bounds& box, double length) {
    const double near = 1e-9 * std::hypot(box.high.x - box.low.x, box.high.y - box.low.y);
    const auto extend = [&](Point& end, const Point& before) {
        const double distance_to_boundary =
            std::min({end.x - box.low.x, box.high.x - end.x, end.y - box.low.y, box.high.y - end.y});
        const double piece = std::hypot(end.x - before.x, end.y - before.y);
        if (std::abs(distance_to_boundary) > near || !(piece > 0)) return;
        end.x += length / piece * (end.x - before.x);
        end.y += length / piece * (end.y - before.y);
    };
    for (Trace& trace : traces) {
        const std::size_t n = trace.points.size();
        if (n < 2) continue;
        extend(trace.points[0], trace.points[1]);
        extend(trace.points[n - 1], trace.points[n - 2]);
    }
    return traces;
}

/// Divides lines into pieces at the joints where they end, and offsets each piece laterally at random. Lines
/// outside the box are included when the offset may move a piece into it, because as many are moved out.
class CrossJointSampler {
  public:
    CrossJointSampler(SetSampler& sampler, const std::vector<Trace>& others)
        : sampler_(sampler),
          max_offset_(sampler.set().spacing.untruncated_mean() * sampler.set().stagger),
          box_(sampler.bounds().expanded(2 * max_offset_)),
          trace_index_(extended_beyond_box(others, sampler.bounds(), 2 * sampler.radius() + 8 * max_offset_),
                       box_) {}

    std::vector<Trace> run() {
        for (const SetLine& line : spaced_lines(sampler_, max_offset_)) add_line(line);
        return std::move(traces_);
    }

  private:
    /// Divides a line into pieces. The line passes each joint that it meets with the probability
    /// 1 - termination, and otherwise a piece ends there.
    void add_line(const SetLine& line) {
        const std::vector<double> intersections =
            trace_index_.intersections(line.middle, line.u, line.low, line.high);
        double from = line.low;
        int passed = 0;
        std::int64_t piece = 0;
        for (std::size_t k = 0; k < intersections.size(); ++k) {
            if (sampler_.draws().draw(draw_termination, line.number, k) > sampler_.set().termination) {
                ++passed;
                continue;
            }
            add_piece(line, piece++, from, intersections[k], passed);
            from = intersections[k];
            passed = 0;
        }
        add_piece(line, piece, from, line.high, passed);
    }

    /// Adds the piece from `from` to `to` with a lateral offset. After the offset it extends from its centre
    /// to the nearest joint behind, and forward past `passed` joints to the next one.
    void add_piece(const SetLine& line, std::int64_t piece, double from, double to, int passed) {
        sampler_.count_draw();
        if (!(from < to)) return;
        const double offset =
            max_offset_ *
            (2 * sampler_.draws().draw(draw_stagger, line.number, static_cast<std::uint64_t>(piece)) - 1);
        // The offset is applied at the middle of the first bed, not of the piece, so that the piece stays in
        // the same bed.
        const double start = middle_of_first_bed(line, from, to);
        const Point centre{line.middle.x + start * line.u.x - offset * line.u.y,
                           line.middle.y + start * line.u.y + offset * line.u.x};
        const auto inside = box_.clip(centre, line.u);
        if (!inside || inside->first > 0 || inside->second < 0) return;
        const std::vector<double> back = trace_index_.intersections(centre, line.u, inside->first, 0);
        const std::vector<double> ahead = trace_index_.intersections(centre, line.u, 0, inside->second);
        const double low = back.empty() ? inside->first : back.back();
        const auto last = static_cast<std::size_t>(passed);
        const double high = ahead.size() <= last ? inside->second : ahead[last];
        const auto in_set = sampler_.bounds().clip(centre, line.u);
        if (!in_set || in_set->first >= high || in_set->second <= low) return;
        traces_.push_back(sampler_.trace(line.number, {centre.x + low * line.u.x, centre.y + low * line.u.y},
                                         {centre.x + high * line.u.x, centre.y + high * line.u.y}));
    }

    double middle_of_first_bed(const SetLine& line, double from, double to) const {
        const std::vector<double> within = trace_index_.intersections(line.middle, line.u, from, to);
        const auto next =
            std::upper_bound(within.begin(), within.end(), from + 1e-9 * std::max(1.0, sampler_.radius()));
        return next == within.end() ? (from + to) / 2 : (from + *next) / 2;
    }

    SetSampler& sampler_;
    double max_offset_;  ///< m
    Bounds box_;         ///< contains all pieces after their offsets
    TraceIndex trace_index_;
    std::vector<Trace> traces_;
};

}  // namespace

std::vector<Trace> sample_cross_joints(SetSampler& sampler, const std::vector<Trace>& others) {
    return CrossJointSampler(sampler, others).run();
}

}  // namespace rockslope::blockgen
