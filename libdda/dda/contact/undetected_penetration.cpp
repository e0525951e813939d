#include "dda/contact/undetected_penetration.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "common/base/parallel_parts.hpp"
#include "dda/contact/detect.hpp"
#include "dda/contact/inherited_penetration.hpp"

namespace rockslope::dda {

namespace {

/// The candidates of one corner against one block.
using CornerCandidates = std::span<const CornerEdge>;

/// Where a corner crosses an edge.
struct Crossing {
    double time = 0;  ///< fraction of the step
    bool inwards = false;
};

/// Largest sine of the angle at a corner that is taken to be straight but for rounding.
constexpr double straight_tolerance = 1e-12;

/// Tests the corners of a step, one against one block at a time, for penetration.
class PenetrationSearch {
  public:
    PenetrationSearch(const Topology& topology, CornerSpan<const Vec2> before, CornerSpan<const Vec2> after,
                      double search_radius)
        : topology_(topology), before_(before), after_(after), search_radius_(search_radius) {}

    /// Whether a line through an edge of a convex block keeps the corner out of it: during the whole step the
    /// corner is no deeper behind the line than half of `allowed`, and the edge hardly turns.
    bool stays_out(CornerCandidates corner_candidates, double allowed) const {
        return std::any_of(corner_candidates.begin(), corner_candidates.end(), [&](const CornerEdge& pair) {
            const Course course(*this, pair);
            if (4 * course.along_rate.squaredNorm() > course.along.squaredNorm()) return false;
            const double most = course.most();
            return most <= 0 || most <= allowed * course.along.norm() / 2;
        });
    }

    /// Whether the corner is deeper than `allowed` in the block, or passed through it deeper than
    /// `clip_depth`.
    bool penetrates(CornerCandidates corner_candidates, double allowed, double clip_depth,
                    UndetectedPenetration& found) const {
        const Location end = locate(corner_candidates, 1);
        found.depth = end.depth;
        const bool inside = found.depth > allowed && found.depth < search_radius_;
        double first_in = 2;
        double last_out = -1;
        bool passed = false;              // entered by one edge and left by another
        std::pair entrance(false, -1.0);  // (passes the angle test, time); the largest is the entrance
        for (const CornerEdge& pair : corner_candidates) {
            int inwards = 0;
            for_crossings(pair, allowed, [&](const Crossing& crossing) {
                inwards += crossing.inwards ? 1 : -1;
                if (!crossing.inwards) {
                    last_out = std::max(last_out, crossing.time);
                    return;
                }
                first_in = std::min(first_in, crossing.time);
                const std::pair candidate(passes_angle_test(pair), crossing.time);
                if (candidate <= entrance) return;
                entrance = candidate;
                found.pair = pair;
            });
            passed = passed || inwards != 0;
        }
        if (inside && !entrance.first) {
            // The corner was inside before, or slid around another corner and entered through an edge that
            // fails the angle test.
            const double deepest = std::max(found.depth, locate(corner_candidates, 0).depth) + allowed;
            if (const CornerEdge* nearest = nearest_possible_entrance(corner_candidates, deepest))
                found.pair = *nearest;
            else if (entrance.second < 0)
                found.pair = end.nearest;
        }
        if (inside) return entrance.second >= 0 || found.depth > locate(corner_candidates, 0).depth + allowed;
        if (!passed || first_in >= last_out) return false;
        found.passed_through = true;
        found.depth = locate(corner_candidates, (first_in + last_out) / 2).depth;
        return found.depth > std::max(allowed, clip_depth);
    }

  private:
    CornerIndex end_of(EdgeIndex edge) const { return topology_.end_of(edge); }
    const Vec2& before(CornerIndex corner) const { return before_[corner]; }
    const Vec2& after(CornerIndex corner) const { return after_[corner]; }
    /// Position of a corner after a fraction of the step, m.
    Vec2 at(CornerIndex corner, double time) const {
        return before(corner) + time * (after(corner) - before(corner));
    }

    /// How a corner passes a line through an edge in a step, all points moving on straight lines: cross(edge,
    /// corner - first end) = a t^2 + b t + c at the fraction t of the step, positive behind the line.
    struct Course {
        Vec2 arm, along, arm_rate, along_rate;
        double a, b, c;

        Course(const PenetrationSearch& search, const CornerEdge& pair)
            : arm(search.before(pair.corner) - search.before(start_of(pair.edge))),
              along(search.before(search.end_of(pair.edge)) - search.before(start_of(pair.edge))),
              arm_rate(search.after(pair.corner) - search.after(start_of(pair.edge)) - arm),
              along_rate(search.after(search.end_of(pair.edge)) - search.after(start_of(pair.edge)) - along),
              a(cross(along_rate, arm_rate)),
              b(cross(along, arm_rate) + cross(along_rate, arm)),
              c(cross(along, arm)) {}

        /// The largest value in the step.
        double most() const {
            const double at_ends = std::max(c, a + b + c);
            const double top = -b / (2 * a);
            return top > 0 && top < 1 ? std::max(at_ends, c + b * top / 2) : at_ends;
        }
    };

    struct Location {
        double depth = 0;    ///< m, inside the block; zero outside
        CornerEdge nearest;  ///< the corner and the nearest edge
    };

    /// Depth of the corner after a fraction of the step. The nearest point of the surface decides whether the
    /// corner is inside: on an edge the side of the edge, at a corner whether that is reflex.
    Location locate(CornerCandidates corner_candidates, double time) const {
        Location location;
        const Vec2 corner = at(corner_candidates.front().corner, time);
        double least = std::numeric_limits<double>::infinity();
        bool inside = false;
        for (const CornerEdge& pair : corner_candidates) {
            const CornerIndex start = start_of(pair.edge), end = end_of(pair.edge);
            const Vec2 first = at(start, time);
            const Vec2 along = at(end, time) - first;
            const double fraction = (corner - first).dot(along) / along.squaredNorm();
            const double clamped = std::clamp(fraction, 0.0, 1.0);
            const double square = (corner - first - clamped * along).squaredNorm();
            if (square >= least) continue;
            least = square;
            location.nearest = pair;
            inside = fraction == clamped ? cross(along, corner - first) > 0
                                         : is_reflex(fraction < 0 ? start : end, time);
        }
        if (inside) location.depth = std::sqrt(least);
        return location;
    }

    bool is_reflex(CornerIndex corner, double time) const {
        const Vec2 here = at(corner, time);
        return cross(here - at(topology_.previous[corner], time), at(topology_.next[corner], time) - here) <
               0;
    }

    /// Calls visit(crossing) where the corner crosses the edge: where its course changes sign between the
    /// ends of the edge. A corner no deeper than `allowed` before the step is taken to be on the edge, c = 0.
    template <class Visit>
    void for_crossings(const CornerEdge& pair, double allowed, const Visit& visit) const {
        const auto [arm, along, arm_rate, along_rate, a, b, start] = Course(*this, pair);
        const double c = start > 0 && start <= allowed * along.norm() ? 0 : start;
        if (c < 0 && c + b + a < 0 && (b <= 0 || a >= 0)) return;  // outside all the time
        const double square = b * b - 4 * a * c;
        if (square < 0) return;
        const double q = -(b + std::copysign(std::sqrt(square), b)) / 2;
        for (const double time : {q / a, c / q}) {
            if (!(time >= 0 && time <= 1)) continue;
            const Vec2 direction = along + time * along_rate;
            const double fraction = (arm + time * arm_rate).dot(direction) / direction.squaredNorm();
            if (fraction >= 0 && fraction <= 1) visit(Crossing{time, 2 * a * time + b > 0});
        }
    }

    double gap_before(const CornerEdge& pair) const {
        return corner_edge_geometry(before(pair.corner), before(start_of(pair.edge)),
                                    before(end_of(pair.edge)))
            .gap;
    }
    CornerEdgeGeometry geometry_after(const CornerEdge& pair) const {
        return corner_edge_geometry(after(pair.corner), after(start_of(pair.edge)), after(end_of(pair.edge)));
    }
    bool passes_angle_test(const CornerEdge& pair) const {
        return passes_entrance_angle_test(topology_, after_, pair.corner, geometry_after(pair).normal);
    }
    /// The nearest edge that the corner is behind, between its ends, and that passes the entrance-angle test;
    /// null if there is none. Before the step the corner was no deeper behind it than `deepest`: it did not
    /// enter by an edge on the far side of the block.
    const CornerEdge* nearest_possible_entrance(CornerCandidates corner_candidates, double deepest) const {
        const CornerEdge* nearest = nullptr;
        double least = search_radius_;
        for (const CornerEdge& pair : corner_candidates) {
            const CornerEdgeGeometry geometry = geometry_after(pair);
            if (geometry.gap >= 0 || -geometry.gap >= least || geometry.end_margin() < 0 ||
                !passes_angle_test(pair) || gap_before(pair) < -deepest)
                continue;
            least = -geometry.gap;
            nearest = &pair;
        }
        return nearest;
    }

    const Topology& topology_;
    CornerSpan<const Vec2> before_;
    CornerSpan<const Vec2> after_;
    double search_radius_;
};

/// The candidates in [begin, end) that are the first of their corner and block.
std::vector<std::uint32_t> first_candidates(const Topology& topology, std::span<const CornerEdge> candidates,
                                            std::size_t begin, std::size_t end) {
    std::vector<std::uint32_t> first;
    first.reserve(end - begin);
    for (std::size_t k = begin; k < end; ++k) {
        if (k == 0 || candidates[k].corner != candidates[k - 1].corner ||
            topology.block_of_edge(candidates[k].edge) != topology.block_of_edge(candidates[k - 1].edge))
            first.push_back(static_cast<std::uint32_t>(k));
    }
    return first;
}

/// Per block: whether it is convex, 1, or not, 0. A block that moves and strains stays so.
PerBlock<char> convex_blocks(const Topology& topology, CornerSpan<const Vec2> vertices,
                             const ThreadPool& pool) {
    PerBlock<char> convex(topology.block_count(), 1);
    pool.parallel_for(convex.size(), [&](std::size_t begin, std::size_t end) {
        for (const BlockIndex block : indices<BlockIndex>(begin, end)) {
            for (const CornerIndex corner : topology.corners_of(block)) {
                const Vec2 arriving = vertices[corner] - vertices[topology.previous[corner]];
                const Vec2 leaving = vertices[topology.next[corner]] - vertices[corner];
                const double turn = cross(arriving, leaving);
                if (turn < 0 && turn * turn > straight_tolerance * straight_tolerance *
                                                  arriving.squaredNorm() * leaving.squaredNorm())
                    convex[block] = 0;
            }
        }
    });
    return convex;
}

}  // namespace

std::vector<UndetectedPenetration> find_undetected_penetrations(const Model& model,
                                                                const PenetrationTest& test,
                                                                const ThreadPool& pool) {
    const Topology& topology = model.topology;
    const std::span<const CornerEdge> candidates = test.candidates;
    const InheritedPenetrations inherited(topology, test.after, test.contacts, test.search_radius, pool);

    // First candidate of each pair of a corner and a block, then the number of candidates.
    std::vector<std::uint32_t> first;
    first.reserve(candidates.size() + 1);
    const auto firsts = parallel_parts(pool, candidates.size(), [&](std::size_t begin, std::size_t end) {
        return first_candidates(topology, candidates, begin, end);
    });
    for (const std::vector<std::uint32_t>& part : firsts) append(first, part);
    const std::size_t count = first.size();
    first.push_back(static_cast<std::uint32_t>(candidates.size()));

    const PerBlock<char> convex = convex_blocks(topology, test.before, pool);
    const PenetrationSearch search(topology, test.before, test.after, test.search_radius);
    const auto penetrates = [&](std::size_t k, UndetectedPenetration& found) {
        const CornerCandidates corner_candidates = candidates.subspan(first[k], first[k + 1] - first[k]);
        const auto& [corner, edge] = corner_candidates.front();
        const BlockIndex block = topology.block_of_edge(edge);
        const double allowed =
            test.tolerance + 2 * inherited.in_block(corner, block) + inherited.lean_in_block(corner, block);
        if (convex[block] != 0 && search.stays_out(corner_candidates, allowed)) return false;
        return search.penetrates(corner_candidates, allowed, test.clip_depth, found);
    };
    // Penetrations are rare: the first pass stores a flag, the second evaluates the flagged ones again.
    std::vector<char> is_penetrating(count, 0);
    pool.parallel_for(count, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            UndetectedPenetration found;
            is_penetrating[k] = penetrates(k, found) ? 1 : 0;
        }
    });
    std::vector<UndetectedPenetration> undetected_penetrations;
    for (std::size_t k = 0; k < count; ++k) {
        if (is_penetrating[k] != 0) penetrates(k, undetected_penetrations.emplace_back());
    }
    return undetected_penetrations;
}

Contact deepest_penetration_as_contact(const Model& model, CornerSpan<const Vec2> vertices,
                                       std::span<const UndetectedPenetration> undetected_penetrations) {
    const UndetectedPenetration& deepest = *std::max_element(
        undetected_penetrations.begin(), undetected_penetrations.end(),
        [](const UndetectedPenetration& a, const UndetectedPenetration& b) { return a.depth < b.depth; });
    Contact contact;
    contact.corner = deepest.pair.corner;
    contact.edge = deepest.pair.edge;
    contact.corner_block = model.topology.block_of[contact.corner];
    contact.edge_block = model.topology.block_of_edge(contact.edge);
    contact.point = vertices[contact.corner];
    contact.gap = -deepest.depth;
    return contact;
}

bool can_be_prevented(std::span<const UndetectedPenetration> undetected_penetrations) {
    return std::none_of(undetected_penetrations.begin(), undetected_penetrations.end(),
                        [](const UndetectedPenetration& p) { return p.passed_through; });
}

bool merge_pairs(std::span<const UndetectedPenetration> undetected_penetrations,
                 std::vector<CornerEdge>& pairs) {
    const std::size_t old_count = pairs.size();
    for (const UndetectedPenetration& penetration : undetected_penetrations)
        pairs.push_back(penetration.pair);
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs.size() > old_count;
}

}  // namespace rockslope::dda
