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

std::string rock_text(const FaceBlocks& faces, const SlopeModel& model, FaceBlockIndex block) {
    const ExcavationIndex k = faces.excavation[block];
    return "'" + material_of(faces, model, block) + "'" +
           (k.exists() ? " in excavation '" + model.excavations[k].name + "'" : "");
}

/// Renumbers the merged blocks consecutively, in the order of their smallest old numbers.
FaceBlocks renumbered(FaceBlocks faces, DisjointSets& sets) {
    PerFaceBlock<FaceBlockIndex> number(faces.material.size(), FaceBlocks::outside);
    PerFaceBlock<RockIndex> materials;
    PerFaceBlock<ExcavationIndex> excavations;
    for (const FaceBlockIndex b : number.indices()) {
        const FaceBlockIndex root = sets.root(b);  // the smallest block of the set, so numbered before b
        if (root == b) {
            number[b] = materials.size();
            materials.push_back(faces.material[b]);
            excavations.push_back(faces.excavation[b]);
        } else {
            number[b] = number[root];
        }
    }
    for (FaceBlockIndex& block : faces.block)
        if (block != FaceBlocks::outside) block = number[block];
    faces.material = std::move(materials);
    faces.excavation = std::move(excavations);
    return faces;
}

/// One side of an edge between two blocks, or between a block and the outside.
struct Side {
    FaceBlockIndex neighbour;
    JointTraceIndex joint;  ///< the first of its joints, or none
    double length;          ///< grid steps
};

/// Contribution of edge a-b to 6 A c, with the area A and the centroid c of its face. @param twice twice the
/// signed area of the triangle origin, a, b.
Point moment_of(const GridPoint& a, const GridPoint& b, double twice) {
    return {twice * static_cast<double>(a.x + b.x), twice * static_cast<double>(a.y + b.y)};
}

/// The first of an edge's joints, or none.
JointTraceIndex first_joint(const NodedEdges& noded, EdgeIndex edge, const SourceTable& table) {
    for (const EdgeSource& s : noded.sources_of(edge))
        if (table.is_joint(s.source)) return table.trace_of(s.source);
    return JointTraceIndex::none();
}

/// The length along which each joint parts blocks, grid steps.
PerJointTrace<double> lengths_between_blocks(const CutContext& cut) {
    PerJointTrace<double> lengths(cut.traces.size(), 0);
    for (const EdgeIndex e : cut.noded.edges.indices()) {
        const JointTraceIndex joint = first_joint(cut.noded, e, cut.table);
        if (!joint.exists() || cut.block_of(forward_half(e)) == cut.block_of(backward_half(e))) continue;
        const GridPoint& a = cut.noded.vertices[cut.noded.edges[e].first];
        const GridPoint& b = cut.noded.vertices[cut.noded.edges[e].second];
        lengths[joint] += std::hypot(static_cast<double>(b.x - a.x), static_cast<double>(b.y - a.y));
    }
    return lengths;
}

/// Twice the area of each block, in cells. Each thread sums over a range of the edges; the sums are integers.
PerFaceBlock<Int128> twice_areas(const CutContext& cut) {
    const std::size_t edges = cut.noded.edges.size(), blocks = cut.faces.material.size();
    const std::size_t ranges = cut.pool.size();
    std::vector<PerFaceBlock<Int128>> sums(ranges);
    cut.pool.parallel_for_dynamic(ranges, [&](std::size_t k, std::size_t) {
        PerFaceBlock<Int128>& sum = sums[k];
        sum.assign(blocks, 0);
        for (const EdgeIndex e : indices<EdgeIndex>(edges * k / ranges, edges * (k + 1) / ranges)) {
            const FaceBlockIndex left = cut.block_of(forward_half(e)), right = cut.block_of(backward_half(e));
            if (left == right) continue;
            const auto& [a, b] = cut.noded.edges[e];
            const Int128 area = twice_area({0, 0}, cut.noded.vertices[a], cut.noded.vertices[b]);
            if (left != FaceBlocks::outside) sum[left] += area;
            if (right != FaceBlocks::outside) sum[right] -= area;
        }
    });
    for (std::size_t k = 1; k < ranges; ++k)
        for (const FaceBlockIndex b : sums[0].indices()) sums[0][b] += sums[k][b];
    return std::move(sums[0]);
}

/// Adjacency graph of blocks that may be merged, with centroids, and the areas of all blocks; a union-find
/// merges blocks.
class BlockGraph {
  public:
    /// @param may_merge flag per block: only these have sides and centroids.
    BlockGraph(const CutContext& cut, PerFaceBlock<Int128> twice_areas, const PerFaceBlock<char>& may_merge)
        : sets_(cut.faces.material.size()),
          twice_area_(std::move(twice_areas)),
          moment_(cut.faces.material.size(), Point{0, 0}),
          sides_(cut.faces.material.size()) {
        const NodedEdges& noded = cut.noded;
        for (const EdgeIndex e : noded.edges.indices()) {
            const FaceBlockIndex left = cut.block_of(forward_half(e)), right = cut.block_of(backward_half(e));
            if (left == right) continue;
            const bool adds_left = left != FaceBlocks::outside && may_merge[left];
            const bool adds_right = right != FaceBlocks::outside && may_merge[right];
            if (!adds_left && !adds_right) continue;
            const GridPoint& a = noded.vertices[noded.edges[e].first];
            const GridPoint& b = noded.vertices[noded.edges[e].second];
            const double length = std::hypot(static_cast<double>(b.x - a.x), static_cast<double>(b.y - a.y));
            const Point moment = moment_of(a, b, static_cast<double>(twice_area({0, 0}, a, b)));
            const JointTraceIndex joint = first_joint(noded, e, cut.table);
            if (adds_left) add(left, moment, {right, joint, length});
            if (adds_right) add(right, {-moment.x, -moment.y}, {left, joint, length});
        }
    }

    FaceBlockIndex root(FaceBlockIndex block) { return sets_.root(block); }
    Int128 twice_area_of(FaceBlockIndex root) const { return twice_area_[root]; }
    /// In grid steps.
    Point centroid_of(FaceBlockIndex root) const {
        const double six_areas = 3 * static_cast<double>(twice_area_[root]);
        return {moment_[root].x / six_areas, moment_[root].y / six_areas};
    }

    /// The sides of a merged block; drops those that have become interior.
    const std::vector<Side>& sides(FaceBlockIndex root) {
        std::vector<Side>& sides = sides_[root];
        std::erase_if(sides, [&](const Side& s) {
            return s.neighbour != FaceBlocks::outside && sets_.root(s.neighbour) == root;
        });
        return sides;
    }

    /// 4 pi area over the square of the perimeter: 1 for a circle.
    double roundness(FaceBlockIndex root) {
        double perimeter = 0;
        for (const Side& s : sides(root)) perimeter += s.length;
        return 2 * std::numbers::pi * static_cast<double>(twice_area_[root]) / (perimeter * perimeter);
    }

    void unite(FaceBlockIndex a, FaceBlockIndex b) {
        a = sets_.root(a);
        b = sets_.root(b);
        if (!sets_.unite(a, b)) return;
        const FaceBlockIndex stays = std::min(a, b), goes = std::max(a, b);
        twice_area_[stays] += twice_area_[goes];
        moment_[stays].x += moment_[goes].x;
        moment_[stays].y += moment_[goes].y;
        if (sides_[stays].size() < sides_[goes].size()) sides_[stays].swap(sides_[goes]);
        sides_[stays].insert(sides_[stays].end(), sides_[goes].begin(), sides_[goes].end());
        sides_[goes] = {};
    }

    DisjointSets& sets() { return sets_; }

  private:
    void add(FaceBlockIndex block, const Point& moment, const Side& side) {
        moment_[block].x += moment.x;
        moment_[block].y += moment.y;
        sides_[block].push_back(side);
    }

    DisjointSets sets_;
    PerFaceBlock<Int128> twice_area_;
    PerFaceBlock<Point> moment_;  ///< 6 area * centroid
    PerFaceBlock<std::vector<Side>> sides_;
};

/// The blocks with which a small block is merged, and the boundary between them.
struct MergeTargets {
    std::vector<FaceBlockIndex> blocks;
    double length = 0;                                ///< of the boundary that disappears, grid steps
    JointTraceIndex joint = JointTraceIndex::none();  ///< the joint whose piece is dropped, or none
};

/// The area below which a block is small, m2. @param cell area of a grid cell, m2.
double small_area(const SmallBlocks& limits, const PerFaceBlock<Int128>& twice_areas, double cell) {
    if (!(limits.below_share > 0)) return limits.below_area;
    std::vector<Int128> sorted = twice_areas;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    return std::max(limits.below_area, limits.below_share * (static_cast<double>(*middle) / 2 * cell));
}

/// Flags the blocks that may be small, alone or merged: those of a small area, or all where slivers count.
PerFaceBlock<char> candidates(const SmallBlocks& limits, const PerFaceBlock<Int128>& twice_areas, double cell,
                              double below_area) {
    PerFaceBlock<char> flags(twice_areas.size(), limits.merges_slivers && limits.below_roundness > 0);
    for (const FaceBlockIndex b : flags.indices())
        if (static_cast<double>(twice_areas[b]) / 2 * cell < below_area) flags[b] = 1;
    return flags;
}

class SmallBlockMerger {
  public:
    SmallBlockMerger(const CutContext& cut, PerFaceBlock<Int128> twice_areas,
                     const PerFaceBlock<char>& may_merge, double below_area)
        : faces_(cut.faces),
          model_(cut.model),
          traces_(cut.traces),
          graph_(cut, std::move(twice_areas), may_merge),
          frame_(cut.noded.frame),
          cell_(cut.noded.frame.step * cut.noded.frame.step),
          below_area_(below_area) {
        if (model_.small_blocks.policy == SmallBlockPolicy::drop)
            length_of_joint_ = lengths_between_blocks(cut);
    }

    FaceBlocks run(MergeReport& report) {
        std::set<std::pair<Int128, FaceBlockIndex>> small;
        for (const FaceBlockIndex b : faces_.material.indices())
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
            for (const FaceBlockIndex target : targets.blocks) graph_.unite(b, target);
            report.merged_blocks += targets.blocks.size();
            report.merged_area += area_of(twice_area);
            report.largest_merged = std::max(report.largest_merged, area_of(twice_area));
            const FaceBlockIndex merged = graph_.root(b);
            if (is_small(merged)) small.emplace(graph_.twice_area_of(merged), merged);
        }
        return report.merged_blocks > 0 ? renumbered(faces_, graph_.sets()) : faces_;
    }

  private:
    double area_of(Int128 twice_area) const { return static_cast<double>(twice_area) / 2 * cell_; }  ///< m2
    bool is_small(FaceBlockIndex b) {
        const SmallBlocks& limits = model_.small_blocks;
        return area_of(graph_.twice_area_of(b)) < below_area_ ||
               (limits.merges_slivers && limits.below_roundness > 0 &&
                graph_.roundness(b) < limits.below_roundness);
    }

    bool may_merge(const Side& side, FaceBlockIndex b) {
        return side.neighbour != FaceBlocks::outside && have_same_rock(faces_, model_, side.neighbour, b);
    }

    Change change_of(FaceBlockIndex b, const MergeTargets& targets) const {
        const Point c = graph_.centroid_of(b);
        Change change;
        change.kind = targets.joint.exists() ? ChangeKind::piece_dropped : ChangeKind::block_merged;
        change.at = {frame_.origin.x + frame_.step * c.x, frame_.origin.y + frame_.step * c.y};
        change.area = static_cast<double>(graph_.twice_area_of(b)) / 2 * cell_;
        change.length = targets.length * frame_.step;
        if (targets.joint.exists()) change.joint = traces_[targets.joint].name;
        return change;
    }

    MergeTargets merge_targets_of(FaceBlockIndex b) {
        return model_.small_blocks.policy == SmallBlockPolicy::merge ? across_longest(b)
                                                                     : across_shortest_joint(b);
    }

    MergeTargets across_longest(FaceBlockIndex b) {
        std::map<FaceBlockIndex, double> common;
        for (const Side& s : graph_.sides(b))
            if (may_merge(s, b)) common[graph_.root(s.neighbour)] += s.length;
        const auto longest = std::max_element(
            common.begin(), common.end(), [](const auto& x, const auto& y) { return x.second < y.second; });
        if (longest == common.end()) return {};
        return {{longest->first}, longest->second, JointTraceIndex::none()};
    }

    MergeTargets across_shortest_joint(FaceBlockIndex b) {
        MergeTargets targets;
        JointTraceIndex& shortest = targets.joint;
        for (const Side& s : graph_.sides(b))
            if (s.joint.exists() && may_merge(s, b) && (!shortest.exists() || is_shorter(s.joint, shortest)))
                shortest = s.joint;
        if (!shortest.exists()) return {};
        std::set<FaceBlockIndex> blocks;
        for (const Side& s : graph_.sides(b)) {
            if (s.joint != shortest || !may_merge(s, b)) continue;
            blocks.insert(graph_.root(s.neighbour));
            targets.length += s.length;
        }
        targets.blocks.assign(blocks.begin(), blocks.end());
        return targets;
    }

    bool is_shorter(JointTraceIndex joint, JointTraceIndex other) const {
        return std::pair(length_of_joint_[joint], joint) < std::pair(length_of_joint_[other], other);
    }

    const FaceBlocks& faces_;
    const SlopeModel& model_;
    const std::vector<Trace>& traces_;
    BlockGraph graph_;
    GridFrame frame_;
    double cell_;                            ///< area of a grid cell, m2
    double below_area_;                      ///< m2, a block with less is small
    PerJointTrace<double> length_of_joint_;  ///< between blocks, grid steps; empty unless the policy needs it
};

/// The change for a filled hole. Its ring is clockwise. The area includes holes of the islands.
Change filled_hole(RingSpan hole, const NodedEdges& noded) {
    Int128 twice = 0;
    Point moment{0, 0};
    for (const HalfEdgeIndex h : hole) {
        const EdgeEnds& edge = noded.edges[edge_of(h)];
        const bool forward = is_forward(h);
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

FaceBlocks merge_small_blocks(const CutContext& cut, MergeReport& report) {
    const SmallBlocks& limits = cut.model.small_blocks;
    const double cell = cut.noded.frame.step * cut.noded.frame.step;
    PerFaceBlock<Int128> areas = twice_areas(cut);
    const double below_area = small_area(limits, areas, cell);
    const PerFaceBlock<char> may_merge = candidates(limits, areas, cell, below_area);
    if (std::find(may_merge.begin(), may_merge.end(), 1) == may_merge.end()) return cut.faces;
    return SmallBlockMerger(cut, std::move(areas), may_merge, below_area).run(report);
}

bool encloses_rock(RingSpan ring, const Subdivision& subdivision, const FaceBlocks& faces) {
    return std::any_of(ring.begin(), ring.end(), [&](HalfEdgeIndex h) {
        return faces.block[subdivision.face[twin(h)]] != FaceBlocks::outside;
    });
}

FaceBlocks fill_islands(const CutContext& cut, const BlockRings& blocks, MergeReport& report) {
    const FaceBlocks& faces = cut.faces;
    const NodedEdges& noded = cut.noded;
    const SlopeModel& model = cut.model;
    PerFaceBlock<std::vector<FaceBlockIndex>> neighbours(faces.material.size());
    for (const HalfEdgeIndex h : cut.subdivision.face.indices())
        if (const FaceBlockIndex b = cut.block_of(h), n = cut.block_of(twin(h));
            b != n && b != FaceBlocks::outside && n != FaceBlocks::outside)
            neighbours[b].push_back(n);

    DisjointSets sets(faces.material.size());
    for (const BlockIndex block : blocks.blocks())
        for (std::size_t r = 1; r < blocks.ring_count(block); ++r) {
            const RingSpan ring = blocks.ring(block, r);
            const std::size_t before = report.filled_islands;
            // Blocks in the hole have no neighbour outside it except the enclosing block.
            std::vector<FaceBlockIndex> front;
            for (const HalfEdgeIndex h : ring)
                if (const FaceBlockIndex n = cut.block_of(twin(h)); n != FaceBlocks::outside)
                    front.push_back(n);
            while (!front.empty()) {
                const FaceBlockIndex b = front.back();
                front.pop_back();
                const FaceBlockIndex host = blocks.block[block];
                if (sets.root(b) == sets.root(host)) continue;
                if (!have_same_rock(faces, model, b, host)) {
                    const GridPoint& at = noded.vertices[noded.edges[edge_of(ring[0])].first];
                    const Point p = noded.frame.position(at);
                    throw InputError(model.domain_location,
                                     "a block of " + rock_text(faces, model, host) + " encloses others of " +
                                         rock_text(faces, model, b) + " near (" + shortest_text(p.x) + ", " +
                                         shortest_text(p.y) + ")",
                                     "islands of one rock to fill, or islands = \"keep\" or \"cut\"");
                }
                sets.unite(b, host);
                ++report.filled_islands;
                for (const FaceBlockIndex n : neighbours[b])
                    if (n != host) front.push_back(n);
            }
            if (report.filled_islands > before) report.changes.push_back(filled_hole(ring, noded));
        }
    return report.filled_islands > 0 ? renumbered(faces, sets) : faces;
}

}  // namespace rockslope::blockgen
