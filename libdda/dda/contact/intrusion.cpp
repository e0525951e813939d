#include "dda/contact/intrusion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "dda/contact/detect.hpp"

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
        std::pair entrance(false, -1.0);  // one that it could touch, then the latest
        for (const CornerEdge& pair : encounter) {
            for_crossings(pair, allowed, [&](const Crossing& crossing) {
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
        }
        if (inside && entrance.second < 0) {
            found.pair = end.nearest;
            return found.depth > place(encounter, 0).depth + allowed;
        }
        if (inside) return true;
        if (first_in >= last_out) return false;
        found.through = true;
        found.depth = place(encounter, (first_in + last_out) / 2).depth;
        return found.depth > std::max(allowed, clipped);
    }

  private:
    static std::size_t index(int k) { return static_cast<std::size_t>(k); }
    int next(int corner) const { return topology_.next[index(corner)]; }
    /// A corner's place after a share of the step.
    Vec2 at(int corner, double time) const {
        return before_[index(corner)] + time * (after_[index(corner)] - before_[index(corner)]);
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
        const Vec2 arm = at(pair.corner, 0) - at(pair.edge, 0);
        const Vec2 along = at(next(pair.edge), 0) - at(pair.edge, 0);
        const Vec2 arm_rate = at(pair.corner, 1) - at(pair.edge, 1) - arm;
        const Vec2 along_rate = at(next(pair.edge), 1) - at(pair.edge, 1) - along;
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

    bool could_touch(const CornerEdge& pair) const {
        const Vec2 normal = corner_edge_geometry(after_[index(pair.corner)], after_[index(pair.edge)],
                                                 after_[index(next(pair.edge))])
                                .normal;
        return faces_outwards(topology_, after_, pair.corner, normal);
    }

    const Topology& topology_;
    std::span<const Vec2> before_;
    std::span<const Vec2> after_;
    double reach_;
};

/// The depth in a block that closed contacts account for, by (corner, block): of the contact's corner, and of
/// the end of its edge that the corner is near, since only one contact stands for two corners on each other.
class KnownDepths {
  public:
    KnownDepths(const Topology& topology, std::span<const Vec2> vertices, std::span<const Contact> contacts) {
        for (const Contact& contact : contacts) {
            if (contact.state == ContactState::open) continue;
            const int second = topology.next[static_cast<std::size_t>(contact.edge)];
            const double to_first = (contact.point - vertices[static_cast<std::size_t>(contact.edge)]).norm();
            const double to_second = (contact.point - vertices[static_cast<std::size_t>(second)]).norm();
            const int partner = to_first < to_second ? contact.edge : second;
            const double depth = std::max(-contact.gap, contact.rest_gap - contact.gap);
            note({contact.corner, contact.edge_block}, depth);
            note({partner, contact.corner_block}, depth);
        }
    }
    double of(int corner, int block) const {
        const auto found = depths_.find({corner, block});
        return found == depths_.end() ? 0 : found->second;
    }

  private:
    void note(const std::pair<int, int>& key, double depth) {
        double& known = depths_[key];
        known = std::max(known, depth);
    }
    std::map<std::pair<int, int>, double> depths_;
};

}  // namespace

std::vector<Intrusion> find_intrusions(const Model& model, std::span<const Vec2> before,
                                       std::span<const Vec2> after, std::span<const CornerEdge> candidates,
                                       std::span<const Contact> contacts, double reach, double slack,
                                       double clipped, const Crew& crew) {
    const Topology& topology = model.topology;
    const auto block_of = [&](int corner) { return topology.block_of[static_cast<std::size_t>(corner)]; };
    const KnownDepths known(topology, after, contacts);

    std::vector<Encounter> encounters;
    for (std::size_t k = 0; k < candidates.size();) {
        std::size_t end = k + 1;
        while (end < candidates.size() && candidates[end].corner == candidates[k].corner &&
               block_of(candidates[end].edge) == block_of(candidates[k].edge))
            ++end;
        encounters.push_back(candidates.subspan(k, end - k));
        k = end;
    }

    const Search search(topology, before, after, reach);
    std::vector<Intrusion> found(encounters.size());
    std::vector<char> intrudes(encounters.size(), 0);
    crew.for_ranges(encounters.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const auto& [corner, edge] = encounters[k].front();
            const double allowed = slack + 2 * known.of(corner, block_of(edge));
            intrudes[k] = search.intrudes(encounters[k], allowed, clipped, found[k]) ? 1 : 0;
        }
    });
    std::vector<Intrusion> intrusions;
    for (std::size_t k = 0; k < found.size(); ++k) {
        if (intrudes[k] != 0) intrusions.push_back(found[k]);
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
