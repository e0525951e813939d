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

/// Adjacency graph of the blocks, with areas and centroids; a union-find merges blocks.
class BlockGraph {
  public:
    explicit BlockGraph(const CutContext& cut)
        : sets_(cut.faces.material.size()),
          twice_area_(cut.faces.material.size()),
          moment_(cut.faces.material.size()),
          sides_(cut.faces.material.size()) {
        const NodedEdges& noded = cut.noded;
        for (const EdgeIndex e : noded.edges.indices()) {
            const FaceBlockIndex left = cut.block_of(forward_half(e));
            const FaceBlockIndex right = cut.block_of(backward_half(e));
            if (left == right) continue;
            const GridPoint& a = noded.vertices[noded.edges[e].first];
            const GridPoint& b = noded.vertices[noded.edges[e].second];
            const double length = std::hypot(static_cast<double>(b.x - a.x), static_cast<double>(b.y - a.y));
            const Int128 area = twice_area({0, 0}, a, b);
            const JointTraceIndex joint = first_joint(noded, e, cut.table);
            if (joint.exists()) length_of_joint_[joint] += length;
            const Point moment = moment_of(a, b, static_cast<double>(area));
            if (left != FaceBlocks::outside) add(left, area, moment, {right, joint, length});
            if (right != FaceBlocks::outside)
                add(right, -area, {-moment.x, -moment.y}, {left, joint, length});
        }
    }

    FaceBlockIndex root(FaceBlockIndex block) { return sets_.root(block); }
    Int128 twice_area_of(FaceBlockIndex root) const { return twice_area_[root]; }
    /// In grid steps.
    Point centroid_of(FaceBlockIndex root) const {
        const double six_areas = 3 * static_cast<double>(twice_area_[root]);
        return {moment_[root].x / six_areas, moment_[root].y / six_areas};
    }
    double length_of_joint(JointTraceIndex joint) const { return length_of_joint_.at(joint); }

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
    static JointTraceIndex first_joint(const NodedEdges& noded, EdgeIndex edge, const SourceTable& table) {
        for (const EdgeSource& s : noded.sources_of(edge))
            if (table.is_joint(s.source)) return table.trace_of(s.source);
        return JointTraceIndex::none();
    }

    void add(FaceBlockIndex block, Int128 area, const Point& moment, const Side& side) {
        twice_area_[block] += area;
        moment_[block].x += moment.x;
        moment_[block].y += moment.y;
        sides_[block].push_back(side);
    }

    DisjointSets sets_;
    PerFaceBlock<Int128> twice_area_;
    PerFaceBlock<Point> moment_;  ///< 6 area * centroid
    PerFaceBlock<std::vector<Side>> sides_;
    std::map<JointTraceIndex, double> length_of_joint_;
};

/// The blocks with which a small block is merged, and the boundary between them.
struct MergeTargets {
    std::vector<FaceBlockIndex> blocks;
    double length = 0;                                ///< of the boundary that disappears, grid steps
    JointTraceIndex joint = JointTraceIndex::none();  ///< the joint whose piece is dropped, or none
};

class SmallBlockMerger {
  public:
    explicit SmallBlockMerger(const CutContext& cut)
        : faces_(cut.faces),
          model_(cut.model),
          traces_(cut.traces),
          graph_(cut),
          frame_(cut.noded.frame),
          cell_(cut.noded.frame.step * cut.noded.frame.step) {}

    FaceBlocks run(MergeReport& report) {
        below_area_ =
            std::max(model_.small_blocks.below_area, model_.small_blocks.below_share * median_area());
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
    /// The median area of the blocks before merging, m2.
    double median_area() const {
        std::vector<Int128> areas;
        for (const FaceBlockIndex b : faces_.material.indices()) areas.push_back(graph_.twice_area_of(b));
        const auto middle = areas.begin() + static_cast<std::ptrdiff_t>(areas.size() / 2);
        std::nth_element(areas.begin(), middle, areas.end());
        return area_of(*middle);
    }

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
        return std::pair(graph_.length_of_joint(joint), joint) <
               std::pair(graph_.length_of_joint(other), other);
    }

    const FaceBlocks& faces_;
    const SlopeModel& model_;
    const std::vector<Trace>& traces_;
    BlockGraph graph_;
    GridFrame frame_;
    double cell_;            ///< area of a grid cell, m2
    double below_area_ = 0;  ///< m2, a block with less is small
};

/// The change for a filled hole. Its ring is clockwise. The area includes holes of the islands.
Change filled_hole(const std::vector<HalfEdgeIndex>& hole, const NodedEdges& noded) {
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
    return SmallBlockMerger(cut).run(report);
}

bool encloses_rock(const std::vector<HalfEdgeIndex>& ring, const Subdivision& subdivision,
                   const FaceBlocks& faces) {
    return std::any_of(ring.begin(), ring.end(), [&](HalfEdgeIndex h) {
        return faces.block[subdivision.face[twin(h)]] != FaceBlocks::outside;
    });
}

FaceBlocks fill_islands(const CutContext& cut, const std::vector<BlockRings>& blocks, MergeReport& report) {
    const FaceBlocks& faces = cut.faces;
    const NodedEdges& noded = cut.noded;
    const SlopeModel& model = cut.model;
    PerFaceBlock<std::vector<FaceBlockIndex>> neighbours(faces.material.size());
    for (const HalfEdgeIndex h : cut.subdivision.face.indices())
        if (const FaceBlockIndex b = cut.block_of(h), n = cut.block_of(twin(h));
            b != n && b != FaceBlocks::outside && n != FaceBlocks::outside)
            neighbours[b].push_back(n);

    DisjointSets sets(faces.material.size());
    for (const BlockRings& block : blocks)
        for (std::size_t r = 1; r < block.rings.size(); ++r) {
            const std::size_t before = report.filled_islands;
            // Blocks in the hole have no neighbour outside it except the enclosing block.
            std::vector<FaceBlockIndex> front;
            for (const HalfEdgeIndex h : block.rings[r])
                if (const FaceBlockIndex n = cut.block_of(twin(h)); n != FaceBlocks::outside)
                    front.push_back(n);
            while (!front.empty()) {
                const FaceBlockIndex b = front.back();
                front.pop_back();
                const FaceBlockIndex host = block.block;
                if (sets.root(b) == sets.root(host)) continue;
                if (!have_same_rock(faces, model, b, host)) {
                    const GridPoint& at = noded.vertices[noded.edges[edge_of(block.rings[r][0])].first];
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
                    if (n != block.block) front.push_back(n);
            }
            if (report.filled_islands > before) report.changes.push_back(filled_hole(block.rings[r], noded));
        }
    return report.filled_islands > 0 ? renumbered(faces, sets) : faces;
}

}  // namespace rockslope::blockgen
