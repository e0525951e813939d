#include "blockgen/cut/merge_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "common/base/disjoint_sets.hpp"
#include "common/base/text.hpp"

namespace rockslope::blockgen {

namespace {

std::string rock_text(const FaceBlocks& faces, const SlopeModel& model, std::size_t block) {
    const std::int32_t k = faces.excavation[block];
    return "'" + material_of(faces, model, block) + "'" +
           (k < 0 ? "" : " in excavation '" + model.excavations[k].name + "'");
}

/// Renumbers the merged blocks consecutively, in the order of their smallest old numbers.
void renumber(FaceBlocks& faces, DisjointSets& sets) {
    std::vector<std::int32_t> number(faces.material.size(), FaceBlocks::outside);
    std::vector<std::int32_t> materials, excavations;
    for (std::size_t b = 0; b < number.size(); ++b) {
        const std::size_t root = sets.root(b);  // the smallest block of the set, so numbered before b
        if (root == b) {
            number[b] = materials.size();
            materials.push_back(faces.material[b]);
            excavations.push_back(faces.excavation[b]);
        } else {
            number[b] = number[root];
        }
    }
    for (std::int32_t& block : faces.block)
        if (block != FaceBlocks::outside) block = number[block];
    faces.material = std::move(materials);
    faces.excavation = std::move(excavations);
}

/// One side of an edge between two blocks, or between a block and the outside.
struct Side {
    std::int32_t neighbour;
    std::int32_t joint;  ///< the first of its joints, -1 when it has none
    double length;       ///< grid steps
};

/// Contribution of edge a-b to 6 A c, with the area A and the centroid c of its face. @param twice twice the
/// signed area of the triangle origin, a, b.
Point moment_of(const GridPoint& a, const GridPoint& b, double twice) {
    return {twice * static_cast<double>(a.x + b.x), twice * static_cast<double>(a.y + b.y)};
}

/// Adjacency graph of the blocks, with areas and centroids; a union-find merges blocks.
class BlockGraph {
  public:
    BlockGraph(const FaceBlocks& faces, const NodedEdges& noded, const Subdivision& subdivision,
               const SourceTable& table)
        : sets_(faces.material.size()),
          twice_area_(faces.material.size()),
          moment_(faces.material.size()),
          sides_(faces.material.size()) {
        for (std::size_t e = 0; e < noded.edges.size(); ++e) {
            const std::int32_t left = faces.block[subdivision.face[2 * e]];
            const std::int32_t right = faces.block[subdivision.face[2 * e + 1]];
            if (left == right) continue;
            const GridPoint& a = noded.vertices[noded.edges[e].first];
            const GridPoint& b = noded.vertices[noded.edges[e].second];
            const double length = std::hypot(static_cast<double>(b.x - a.x), static_cast<double>(b.y - a.y));
            const Int128 area = twice_area({0, 0}, a, b);
            const std::int32_t joint = first_joint(noded, e, table);
            if (joint >= 0) length_of_joint_[joint] += length;
            const Point moment = moment_of(a, b, static_cast<double>(area));
            if (left != FaceBlocks::outside) add(left, area, moment, {right, joint, length});
            if (right != FaceBlocks::outside)
                add(right, -area, {-moment.x, -moment.y}, {left, joint, length});
        }
    }

    std::size_t root(std::size_t block) { return sets_.root(block); }
    Int128 twice_area_of(std::size_t root) const { return twice_area_[root]; }
    /// In grid steps.
    Point centroid_of(std::size_t root) const {
        const double six_areas = 3 * static_cast<double>(twice_area_[root]);
        return {moment_[root].x / six_areas, moment_[root].y / six_areas};
    }
    double length_of_joint(std::int32_t joint) const { return length_of_joint_.at(joint); }

    /// The sides of a merged block; drops those that have become interior.
    const std::vector<Side>& sides(std::size_t root) {
        std::vector<Side>& sides = sides_[root];
        std::erase_if(sides, [&](const Side& s) {
            return s.neighbour != FaceBlocks::outside && sets_.root(s.neighbour) == root;
        });
        return sides;
    }

    /// 4 pi area over the square of the perimeter: 1 for a circle.
    double roundness(std::size_t root) {
        double perimeter = 0;
        for (const Side& s : sides(root)) perimeter += s.length;
        return 2 * std::numbers::pi * static_cast<double>(twice_area_[root]) / (perimeter * perimeter);
    }

    void unite(std::size_t a, std::size_t b) {
        a = sets_.root(a);
        b = sets_.root(b);
        if (!sets_.unite(a, b)) return;
        const std::size_t stays = std::min(a, b), goes = std::max(a, b);
        twice_area_[stays] += twice_area_[goes];
        moment_[stays].x += moment_[goes].x;
        moment_[stays].y += moment_[goes].y;
        if (sides_[stays].size() < sides_[goes].size()) sides_[stays].swap(sides_[goes]);
        sides_[stays].insert(sides_[stays].end(), sides_[goes].begin(), sides_[goes].end());
        sides_[goes] = {};
    }

    DisjointSets& sets() { return sets_; }

  private:
    static std::int32_t first_joint(const NodedEdges& noded, std::size_t edge, const SourceTable& table) {
        for (const EdgeSource& s : noded.sources_of(edge))
            if (table.is_joint(s.source)) return s.source - table.first_joint;
        return -1;
    }

    void add(std::int32_t block, Int128 area, const Point& moment, const Side& side) {
        twice_area_[block] += area;
        moment_[block].x += moment.x;
        moment_[block].y += moment.y;
        sides_[block].push_back(side);
    }

    DisjointSets sets_;
    std::vector<Int128> twice_area_;
    std::vector<Point> moment_;  ///< 6 area * centroid
    std::vector<std::vector<Side>> sides_;
    std::map<std::int32_t, double> length_of_joint_;
};

/// The blocks with which a small block is merged, and the boundary between them.
struct MergeTargets {
    std::vector<std::size_t> blocks;
    double length = 0;        ///< of the boundary that disappears, grid steps
    std::int32_t joint = -1;  ///< the joint whose piece is dropped, or -1
};

class SmallBlockMerger {
  public:
    SmallBlockMerger(FaceBlocks& faces, const NodedEdges& noded, const Subdivision& subdivision,
                     const SlopeModel& model, const std::vector<Trace>& traces, const SourceTable& table)
        : faces_(faces),
          model_(model),
          traces_(traces),
          graph_(faces, noded, subdivision, table),
          frame_(noded.frame),
          cell_(noded.frame.step * noded.frame.step) {}

    void run(MergeReport& report) {
        std::set<std::pair<Int128, std::size_t>> small;
        for (std::size_t b = 0; b < faces_.material.size(); ++b)
            if (is_small(b)) small.emplace(graph_.twice_area_of(b), b);
        report.small_blocks += small.size();
        while (!small.empty()) {
            const auto [twice_area, b] = *small.begin();
            small.erase(small.begin());
            // Skip an entry of a block that has been merged since; the merged block has its own entry.
            if (graph_.root(b) != b || graph_.twice_area_of(b) != twice_area) continue;
            const MergeTargets targets = merge_targets_of(b);
            if (targets.blocks.empty()) {
                ++report.kept_small;
                continue;
            }
            report.changes.push_back(change_of(b, targets));
            for (const std::size_t target : targets.blocks) graph_.unite(b, target);
            report.merged_blocks += targets.blocks.size();
            report.merged_area += static_cast<double>(twice_area) / 2 * cell_;
            const std::size_t merged = graph_.root(b);
            if (is_small(merged)) small.emplace(graph_.twice_area_of(merged), merged);
        }
        if (report.merged_blocks > 0) renumber(faces_, graph_.sets());
    }

  private:
    bool is_small(std::size_t b) {
        const SmallBlocks& limits = model_.small_blocks;
        return static_cast<double>(graph_.twice_area_of(b)) / 2 * cell_ < limits.below_area ||
               (limits.below_roundness > 0 && graph_.roundness(b) < limits.below_roundness);
    }

    bool may_merge(const Side& side, std::size_t b) {
        return side.neighbour != FaceBlocks::outside && have_same_rock(faces_, model_, side.neighbour, b);
    }

    Change change_of(std::size_t b, const MergeTargets& targets) const {
        const Point c = graph_.centroid_of(b);
        Change change;
        change.kind = targets.joint < 0 ? ChangeKind::block_merged : ChangeKind::piece_dropped;
        change.at = {frame_.origin.x + frame_.step * c.x, frame_.origin.y + frame_.step * c.y};
        change.area = static_cast<double>(graph_.twice_area_of(b)) / 2 * cell_;
        change.length = targets.length * frame_.step;
        if (targets.joint >= 0) change.joint = traces_[targets.joint].name;
        return change;
    }

    MergeTargets merge_targets_of(std::size_t b) {
        return model_.small_blocks.policy == SmallBlockPolicy::merge ? across_longest(b)
                                                                     : across_shortest_joint(b);
    }

    MergeTargets across_longest(std::size_t b) {
        std::map<std::size_t, double> common;
        for (const Side& s : graph_.sides(b))
            if (may_merge(s, b)) common[graph_.root(s.neighbour)] += s.length;
        const auto longest = std::max_element(
            common.begin(), common.end(), [](const auto& x, const auto& y) { return x.second < y.second; });
        if (longest == common.end()) return {};
        return {{longest->first}, longest->second, -1};
    }

    MergeTargets across_shortest_joint(std::size_t b) {
        MergeTargets targets;
        std::int32_t& shortest = targets.joint;
        for (const Side& s : graph_.sides(b))
            if (s.joint >= 0 && may_merge(s, b) && (shortest < 0 || is_shorter(s.joint, shortest)))
                shortest = s.joint;
        if (shortest < 0) return {};
        std::set<std::size_t> blocks;
        for (const Side& s : graph_.sides(b)) {
            if (s.joint != shortest || !may_merge(s, b)) continue;
            blocks.insert(graph_.root(s.neighbour));
            targets.length += s.length;
        }
        targets.blocks.assign(blocks.begin(), blocks.end());
        return targets;
    }

    bool is_shorter(std::int32_t joint, std::int32_t other) const {
        return std::pair(graph_.length_of_joint(joint), joint) <
               std::pair(graph_.length_of_joint(other), other);
    }

    FaceBlocks& faces_;
    const SlopeModel& model_;
    const std::vector<Trace>& traces_;
    BlockGraph graph_;
    GridFrame frame_;
    double cell_;  ///< area of a grid cell, m2
};

/// The change for a filled hole. Its ring is clockwise. The area includes holes of the islands.
Change filled_hole(const std::vector<std::int32_t>& hole, const NodedEdges& noded) {
    Int128 twice = 0;
    Point moment{0, 0};
    for (const std::int32_t h : hole) {
        const auto& edge = noded.edges[h / 2];
        const bool forward = h % 2 == 0;
        const GridPoint& a = noded.vertices[forward ? edge.first : edge.second];
        const GridPoint& b = noded.vertices[forward ? edge.second : edge.first];
        const Int128 area = twice_area({0, 0}, a, b);
        const Point edge_moment = moment_of(a, b, static_cast<double>(area));
        twice += area;
        moment = {moment.x + edge_moment.x, moment.y + edge_moment.y};
    }
    const double six_areas = 3 * static_cast<double>(twice), step = noded.frame.step;
    Change change;
    change.kind = ChangeKind::island_filled;
    change.at = {noded.frame.origin.x + step * moment.x / six_areas,
                 noded.frame.origin.y + step * moment.y / six_areas};
    change.area = -static_cast<double>(twice) / 2 * step * step;
    return change;
}

}  // namespace

void merge_small_blocks(FaceBlocks& faces, const NodedEdges& noded, const Subdivision& subdivision,
                        const SlopeModel& model, const std::vector<Trace>& traces, const SourceTable& table,
                        MergeReport& report) {
    SmallBlockMerger(faces, noded, subdivision, model, traces, table).run(report);
}

bool encloses_rock(const std::vector<std::int32_t>& ring, const Subdivision& subdivision,
                   const FaceBlocks& faces) {
    return std::any_of(ring.begin(), ring.end(), [&](std::int32_t h) {
        const std::int32_t face = subdivision.face[h ^ 1];
        return faces.block[face] != FaceBlocks::outside;
    });
}

void fill_islands(FaceBlocks& faces, const std::vector<BlockRings>& blocks, const NodedEdges& noded,
                  const Subdivision& subdivision, const SlopeModel& model, MergeReport& report) {
    const auto block_of = [&](std::size_t h) { return faces.block[subdivision.face[h]]; };
    std::vector<std::vector<std::int32_t>> neighbours(faces.material.size());
    for (std::size_t h = 0; h < subdivision.face.size(); ++h)
        if (const std::int32_t b = block_of(h), n = block_of(h ^ 1u);
            b != n && b != FaceBlocks::outside && n != FaceBlocks::outside)
            neighbours[b].push_back(n);

    DisjointSets sets(faces.material.size());
    for (const BlockRings& block : blocks)
        for (std::size_t r = 1; r < block.rings.size(); ++r) {
            const std::size_t before = report.filled_islands;
            // Blocks in the hole have no neighbour outside it except the enclosing block.
            std::vector<std::int32_t> front;
            for (const std::int32_t h : block.rings[r])
                if (const std::int32_t n = block_of(h ^ 1); n != FaceBlocks::outside) front.push_back(n);
            while (!front.empty()) {
                const std::size_t b = front.back();
                front.pop_back();
                const std::size_t host = block.block;
                if (sets.root(b) == sets.root(host)) continue;
                if (!have_same_rock(faces, model, b, host)) {
                    const GridPoint& at = noded.vertices[noded.edges[block.rings[r][0] / 2].first];
                    const Point p = noded.frame.position(at);
                    throw InputError(model.domain_location,
                                     "a block of " + rock_text(faces, model, host) + " encloses others of " +
                                         rock_text(faces, model, b) + " near (" + shortest_text(p.x) + ", " +
                                         shortest_text(p.y) + ")",
                                     "islands of one rock to fill, or islands = \"keep\" or \"cut\"");
                }
                sets.unite(b, host);
                ++report.filled_islands;
                for (const std::int32_t n : neighbours[b])
                    if (n != block.block) front.push_back(n);
            }
            if (report.filled_islands > before) report.changes.push_back(filled_hole(block.rings[r], noded));
        }
    if (report.filled_islands > 0) renumber(faces, sets);
}

}  // namespace rockslope::blockgen
