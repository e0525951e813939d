#include "dda/contact/intrusion.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "dda/contact/detect.hpp"
#include "dda/contact/known_depth.hpp"

namespace dda {

namespace {

/// The candidates of one corner against one block.
using Encounter = std::span<const CornerEdge>;

/// Where a corner crosses an edge.
struct Crossing {
    double time = 0;  ///< share of the step
    bool inwards = false;
};

class Search {
  public:
    Search(const Topology& topology, std::span<const Vec2> before, std::span<const Vec2> after, double reach)
        : topology_(topology), before_(before), after_(after), reach_(reach) {}

    /// Whether the corner got deeper than `allowed` into the block, or than `clipped` through it.
    bool intrudes(Encounter encounter, double allowed, double clipped, Intrusion& found) const {
        const Place end = place(encounter, 1);
        found.depth = end.depth;
        const bool inside = found.depth > allowed && found.depth < reach_;
        double first_in = 2;
        double last_out = -1;
        bool passed = false;              // in by one edge and out by another
        std::pair entrance(false, -1.0);  // one that it could touch, then the latest
        for (const CornerEdge& pair : encounter) {
            int inwards = 0;
            for_crossings(pair, allowed, [&](const Crossing& crossing) {
                inwards += crossing.inwards ? 1 : -1;
                if (!crossing.inwards) {
                    last_out = std::max(last_out, crossing.time);
                    return;
                }
                first_in = std::min(first_in, crossing.time);
                const std::pair candidate(could_touch(pair), crossing.time);
                if (candidate <= entrance) return;
                entrance = candidate;
                found.pair = pair;
            });
            passed = passed || inwards != 0;
        }
        if (inside && !entrance.first) {
            // It was inside before, or slipped round a corner into a face that is not turned to it.
            if (const CornerEdge* touched = nearest_that_it_could_touch(encounter))
                found.pair = *touched;
            else if (entrance.second < 0)
                found.pair = end.nearest;
        }
        if (inside) return entrance.second >= 0 || found.depth > place(encounter, 0).depth + allowed;
        if (!passed || first_in >= last_out) return false;
        found.through = true;
        found.depth = place(encounter, (first_in + last_out) / 2).depth;
        return found.depth > std::max(allowed, clipped);
    }

  private:
    static std::size_t index(int k) { return static_cast<std::size_t>(k); }
    int next(int corner) const { return topology_.next[index(corner)]; }
    const Vec2& before(int corner) const { return before_[index(corner)]; }
    const Vec2& after(int corner) const { return after_[index(corner)]; }
    /// A corner's place after a share of the step.
    Vec2 at(int corner, double time) const {
        return before(corner) + time * (after(corner) - before(corner));
    }

    struct Place {
        double depth = 0;    ///< m, inside the block; zero outside
        CornerEdge nearest;  ///< the edge that it is nearest to
    };

    /// Where the corner is after a share of the step. Inside and outside are told apart at the nearest point
    /// of the surface: on an edge by its side, at a corner by whether that is a reflex one.
    Place place(Encounter encounter, double time) const {
        Place place;
        const Vec2 corner = at(encounter.front().corner, time);
        double least = std::numeric_limits<double>::infinity();
        bool inside = false;
        for (const CornerEdge& pair : encounter) {
            const int edge = pair.edge;
            const Vec2 first = at(edge, time);
            const Vec2 along = at(next(edge), time) - first;
            const double share = (corner - first).dot(along) / along.squaredNorm();
            const double clamped = std::clamp(share, 0.0, 1.0);
            const double square = (corner - first - clamped * along).squaredNorm();
            if (square >= least) continue;
            least = square;
            place.nearest = pair;
            inside = share == clamped ? cross(along, corner - first) > 0
                                      : is_reflex(share < 0 ? edge : next(edge), time);
        }
        if (inside) place.depth = std::sqrt(least);
        return place;
    }

    bool is_reflex(int corner, double time) const {
        const Vec2 here = at(corner, time);
        return cross(here - at(topology_.previous[index(corner)], time), at(next(corner), time) - here) < 0;
    }

    /// The corner's ways through the edge, all points moving straight: where
    /// cross(edge, corner - first end), quadratic in time, changes its sign between the edge's ends. A corner
    /// no deeper than `allowed` before the step is taken to be on the edge.
    template <class Visit>
    void for_crossings(const CornerEdge& pair, double allowed, const Visit& visit) const {
        const Vec2 arm = before(pair.corner) - before(pair.edge);
        const Vec2 along = before(next(pair.edge)) - before(pair.edge);
        const Vec2 arm_rate = after(pair.corner) - after(pair.edge) - arm;
        const Vec2 along_rate = after(next(pair.edge)) - after(pair.edge) - along;
        const double a = cross(along_rate, arm_rate);
        const double b = cross(along, arm_rate) + cross(along_rate, arm);
        double c = cross(along, arm);
        if (c > 0 && c <= allowed * along.norm()) c = 0;
        if (c < 0 && c + b + a < 0 && (b <= 0 || a >= 0)) return;  // outside all the time
        const double square = b * b - 4 * a * c;
        if (square < 0) return;
        const double q = -(b + std::copysign(std::sqrt(square), b)) / 2;
        for (const double time : {q / a, c / q}) {
            if (!(time >= 0 && time <= 1)) continue;
            const Vec2 direction = along + time * along_rate;
            const double share = (arm + time * arm_rate).dot(direction) / direction.squaredNorm();
            if (share >= 0 && share <= 1) visit(Crossing{time, 2 * a * time + b > 0});
        }
    }

    CornerEdgeGeometry geometry_after(const CornerEdge& pair) const {
        return corner_edge_geometry(after(pair.corner), after(pair.edge), after(next(pair.edge)));
    }
    bool could_touch(const CornerEdge& pair) const {
        return faces_outwards(topology_, after_, pair.corner, geometry_after(pair).normal);
    }
    /// Of the edges that the corner is behind and within, the nearest that is turned to it; null if none is.
    const CornerEdge* nearest_that_it_could_touch(Encounter encounter) const {
        const CornerEdge* nearest = nullptr;
        double least = reach_;
        for (const CornerEdge& pair : encounter) {
            const CornerEdgeGeometry geometry = geometry_after(pair);
            if (geometry.gap >= 0 || -geometry.gap >= least || geometry.inside() < 0 || !could_touch(pair))
                continue;
            least = -geometry.gap;
            nearest = &pair;
        }
        return nearest;
    }

    const Topology& topology_;
    std::span<const Vec2> before_;
    std::span<const Vec2> after_;
    double reach_;
};

}  // namespace

std::vector<Intrusion> find_intrusions(const Model& model, std::span<const Vec2> before,
                                       std::span<const Vec2> after, std::span<const CornerEdge> candidates,
                                       std::span<const Contact> contacts, double reach, double slack,
                                       double clipped, const Crew& crew) {
    const Topology& topology = model.topology;
    const auto block_of = [&](int corner) { return topology.block_of[static_cast<std::size_t>(corner)]; };
    const KnownDepths known(topology, after, contacts, reach);

    std::vector<std::uint32_t> first;  // candidate of an encounter, and the end
    first.reserve(candidates.size() + 1);
    for (std::size_t k = 0; k < candidates.size(); ++k) {
        if (k == 0 || candidates[k].corner != candidates[k - 1].corner ||
            block_of(candidates[k].edge) != block_of(candidates[k - 1].edge))
            first.push_back(static_cast<std::uint32_t>(k));
    }
    const std::size_t count = first.size();
    first.push_back(static_cast<std::uint32_t>(candidates.size()));

    const Search search(topology, before, after, reach);
    const auto intrudes = [&](std::size_t k, Intrusion& found) {
        const Encounter encounter = candidates.subspan(first[k], first[k + 1] - first[k]);
        const auto& [corner, edge] = encounter.front();
        const double allowed = slack + 2 * known.in_block(corner, block_of(edge));
        return search.intrudes(encounter, allowed, clipped, found);
    };
    // Hardly any does: what is found is not kept for all of them.
    std::vector<char> is_in(count, 0);
    crew.for_ranges(count, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            Intrusion found;
            is_in[k] = intrudes(k, found) ? 1 : 0;
        }
    });
    std::vector<Intrusion> intrusions;
    for (std::size_t k = 0; k < count; ++k) {
        if (is_in[k] != 0) intrudes(k, intrusions.emplace_back());
    }
    return intrusions;
}

Contact deepest_as_contact(const Model& model, std::span<const Vec2> vertices,
                           std::span<const Intrusion> intrusions) {
    const Intrusion& deepest =
        *std::max_element(intrusions.begin(), intrusions.end(),
                          [](const Intrusion& a, const Intrusion& b) { return a.depth < b.depth; });
    Contact contact;
    contact.corner = deepest.pair.corner;
    contact.edge = deepest.pair.edge;
    contact.corner_block = model.topology.block_of[static_cast<std::size_t>(contact.corner)];
    contact.edge_block = model.topology.block_of[static_cast<std::size_t>(contact.edge)];
    contact.point = vertices[static_cast<std::size_t>(contact.corner)];
    contact.gap = -deepest.depth;
    return contact;
}

bool may_be_stopped(std::span<const Intrusion> intrusions) {
    return std::none_of(intrusions.begin(), intrusions.end(), [](const Intrusion& i) { return i.through; });
}

bool add_pairs(std::span<const Intrusion> intrusions, std::vector<CornerEdge>& pairs) {
    const std::size_t known = pairs.size();
    for (const Intrusion& intrusion : intrusions) pairs.push_back(intrusion.pair);
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs.size() > known;
}

}  // namespace dda
