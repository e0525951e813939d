#include "blockgen/cut/cut_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "blockgen/arrangement/arrange.hpp"
#include "blockgen/cut/add_base.hpp"
#include "blockgen/cut/apply_block_selectors.hpp"
#include "blockgen/cut/check_boundaries.hpp"
#include "blockgen/cut/merge_blocks.hpp"
#include "blockgen/cut/simplify_boundaries.hpp"
#include "blockgen/faces/cut_context.hpp"
#include "blockgen/faces/mark_edges.hpp"
#include "blockgen/input/domain.hpp"
#include "blockgen/mesh/check_mesh.hpp"
#include "common/base/disjoint_sets.hpp"
#include "common/base/text.hpp"
#include "common/geometry/polygon.hpp"

namespace rockslope::blockgen {

namespace {

/// Number of bounded faces of a planar graph by Euler's formula: E - V + connected components.
std::size_t count_bounded_faces(const NodedEdges& noded) {
    DisjointSets sets(noded.vertices.size());
    std::size_t components = noded.vertices.size();
    for (const auto& [a, b] : noded.edges) components -= sets.unite(a, b);
    return noded.edges.size() + components - noded.vertices.size();
}

/// The subdivision by CGAL's plane sweep, which also checks the noding. Larger networks, for which the sweep
/// would take most of the time, use walk_faces(). verify_area() checks both; --verify always sweeps.
Subdivision subdivide(const NodedEdges& noded) {
    constexpr std::size_t max_swept_edges = 100'000;
    return noded.edges.size() <= max_swept_edges ? arrange(noded) : walk_faces(noded);
}

[[noreturn]] void fail_too_many(const SlopeModel& model, double count, std::size_t limit) {
    throw InputError(model.domain_location,
                     "the joints make about " + std::to_string(std::llround(count)) + " blocks",
                     "at most " + std::to_string(limit) + " (--max-blocks sets the limit)");
}

/// Numbers joints and their materials in the order in which the edges of the blocks use them, which does not
/// depend on the order of the joints.
class EdgesInUse {
  public:
    explicit EdgesInUse(const EdgeMarks& edges)
        : edges_(edges),
          joint_(edges.joints.size(), JointIndex::none()),
          material_(edges.joint_materials.size(), JointMaterialIndex::none()) {}

    EdgeMark mark(EdgeIndex edge) {
        EdgeMark mark = edges_.marks[edge];
        if (mark.joint_material.exists())
            mark.joint_material =
                number(mark.joint_material, edges_.joint_materials, material_, joint_materials);
        if (mark.joint.exists()) mark.joint = number(mark.joint, edges_.joints, joint_, joints);
        return mark;
    }

    PerJointMaterial<std::string> joint_materials;
    PerJoint<Joint> joints;

  private:
    template <class Index, class All>
    static Index number(Index old, const All& all, IndexedVector<Index, Index>& numbers, All& used) {
        if (!numbers[old].exists()) {
            numbers[old] = used.size();
            used.push_back(all[old]);
        }
        return numbers[old];
    }

    const EdgeMarks& edges_;
    PerJoint<JointIndex> joint_;
    PerJointMaterial<JointMaterialIndex> material_;
};

class Cutter {
  public:
    Cutter(const SlopeModel& model, const std::vector<Trace>& traces, const CutOptions& options)
        : model_(model),
          traces_(traces),
          table_(model),
          noded_(node(options)),
          subdivision_(subdivide(noded_)),
          faces_(classify_and_merge_faces()),
          boundary_(noded_, subdivision_, faces_),
          edges_(mark_edges(context_of(faces_), boundary_)) {}

    CutResult cut(const CutOptions& options) {
        blocks_ = block_rings(noded_, subdivision_, faces_, boundary_);
        removed_ = redundant_vertices(noded_, subdivision_, faces_, boundary_, edges_.marks);
        CutResult result;
        fill_mesh(result.mesh);
        result.report.warnings = model_.notes;
        add_excavations(result);
        apply_block_selectors(result.mesh, model_, result.report.warnings);
        for (const auto& warnings :
             {boundary_warnings(result.mesh, model_), region_warnings(context_of(faces_))})
            result.report.warnings.insert(result.report.warnings.end(), warnings.begin(), warnings.end());
        check(result.mesh);
        fill_report(result);
        verify_area(result.report);
        add_network(result.report);
        if (options.verify) verify(result.report);
        return result;
    }

  private:
    /// An invalid mesh is an error of this program, not of its input.
    static void check(const BlockMesh& mesh) {
        try {
            check_mesh(mesh, "the cut mesh");
        } catch (const InputError& error) {
            throw std::logic_error(error.what());
        }
    }

    NodedEdges node(const CutOptions& options) const {
        const std::vector<SourceSegment> segments = source_segments(model_, traces_, table_);
        const double estimate = estimated_blocks(model_, segments, table_);
        if (estimate > 4.0 * static_cast<double>(options.max_blocks) + 1000)
            fail_too_many(model_, estimate, options.max_blocks);
        NodedEdges noded = node_joints(segments, model_.grid);
        const std::size_t faces = count_bounded_faces(noded);
        if (faces > options.max_blocks) fail_too_many(model_, static_cast<double>(faces), options.max_blocks);
        return noded;
    }

    /// The block of each face, after small blocks are merged and islands filled as the model requires.
    FaceBlocks classify_and_merge_faces() {
        FaceBlocks faces = classify_faces(noded_, subdivision_, model_, table_);
        if (faces.material.empty())
            throw InputError(model_.domain_location, "no rock is left",
                             "a domain larger than its holes and tunnels");
        if (model_.small_blocks.policy != SmallBlockPolicy::keep)
            faces = merge_small_blocks(context_of(faces), merges_);
        if (model_.islands == IslandPolicy::fill) {
            const BlockBoundary boundary(noded_, subdivision_, faces);
            faces =
                fill_islands(context_of(faces), block_rings(noded_, subdivision_, faces, boundary), merges_);
        }
        return faces;
    }

    CutContext context_of(const FaceBlocks& faces) const {
        return {.noded = noded_,
                .subdivision = subdivision_,
                .faces = faces,
                .model = model_,
                .traces = traces_,
                .table = table_};
    }
    FaceBlockIndex block_of(HalfEdgeIndex half_edge) const {
        return faces_.block[subdivision_.face[half_edge]];
    }
    const GridPoint& start(HalfEdgeIndex half_edge) const {
        return noded_.vertices[boundary_.origin[half_edge]];
    }

    /// Index of a block's material in the mesh. Only materials that a block has are written to the file.
    BlockMaterialIndex material_index(BlockMesh& mesh, FaceBlockIndex block) const {
        const std::string& name = material_of(faces_, model_, block);
        const auto found = std::find(mesh.block_materials.begin(), mesh.block_materials.end(), name);
        if (found == mesh.block_materials.end()) {
            mesh.block_materials.push_back(name);
            return mesh.block_materials.size() - 1;
        }
        return found - mesh.block_materials.begin();
    }

    void fill_mesh(BlockMesh& mesh) {
        PerNode<VertexIndex> number(noded_.vertices.size(), VertexIndex::none());
        std::vector<VertexIndex> ring;
        std::vector<EdgeMark> marks;
        EdgesInUse in_use(edges_);
        for (const BlockRings& block : blocks_) {
            mesh.begin_block(material_index(mesh, block.block));
            for (const auto& half_edges : block.rings) {
                ring.clear();
                marks.clear();
                for (const HalfEdgeIndex h : half_edges) {
                    const NodeIndex v = boundary_.origin[h];
                    if (removed_[v]) continue;
                    if (!number[v].exists()) {
                        number[v] = mesh.vertices.size();
                        mesh.vertices.push_back(noded_.frame.position(noded_.vertices[v]));
                        grid_points_.push_back(noded_.vertices[v]);
                    }
                    ring.push_back(number[v]);
                    marks.push_back(in_use.mark(edge_of(h)));
                }
                mesh.add_ring(ring, marks);
                twice_block_area_ += twice_ring_area(ring);
            }
        }
        mesh.joint_materials = std::move(in_use.joint_materials);
        mesh.joints = std::move(in_use.joints);
    }

    /// Adds the excavations that remove rock, in the order of the model.
    void add_excavations(CutResult& result) const {
        std::vector<ExcavatedBlocks> excavations;
        for (const Excavation& e : model_.excavations) excavations.push_back({e.name, e.stage, {}});
        for (const BlockIndex b : blocks_.indices())
            if (const ExcavationIndex k = faces_.excavation[blocks_[b].block]; k.exists())
                excavations[k].blocks.push_back(b);
        for (ExcavatedBlocks& e : excavations) {
            if (e.blocks.empty())
                result.report.warnings.push_back("excavation '" + e.name + "' removes no rock");
            else
                result.mesh.excavations.push_back(std::move(e));
        }
    }

    Int128 twice_ring_area(const std::vector<VertexIndex>& ring) const {
        Int128 sum = 0;
        const auto corner = [&](std::size_t k) { return grid_points_[ring[k]]; };
        for (std::size_t k = 1; k + 1 < ring.size(); ++k)
            sum += twice_area(corner(0), corner(k), corner(k + 1));
        return sum;
    }

    /// Checks in exact integers that the areas of the blocks sum to the area of the rock. When no hole or
    /// tunnel crosses the outline or overlaps another one, the area enclosed by the noded outlines must be
    /// the same.
    void verify_area(CutReport& report) const {
        Int128 twice_rock = 0, twice_outlines = 0;
        for (const EdgeIndex e : noded_.edges.indices()) {
            const Int128 area = twice_area({0, 0}, start(forward_half(e)), start(backward_half(e)));
            const int left = block_of(forward_half(e)) != FaceBlocks::outside,
                      right = block_of(backward_half(e)) != FaceBlocks::outside;
            twice_rock += area * (left - right);
            for (const EdgeSource& s : noded_.sources_of(e)) {
                const bool is_void = (s.source >= table_.first_hole && s.source < table_.first_region) ||
                                     (s.source >= table_.first_tunnel && s.source < table_.first_joint);
                if (s.source == 0 || is_void) twice_outlines += (s.reversed != is_void ? -1 : 1) * area;
            }
        }
        if (twice_rock != twice_block_area_)
            throw std::logic_error("the areas of the blocks do not sum to the area of the rock");
        if (faces_.has_disjoint_voids && twice_rock != twice_outlines)
            throw std::logic_error("the area of the rock differs from the area that the outlines enclose");
        report.domain_area = static_cast<double>(twice_rock) / 2 * noded_.frame.step * noded_.frame.step;
        report.area_proved = true;
    }

    void verify(CutReport& report) const {
        const ArrangementSummary exact = arrange_exactly(noded_), ours = summarize(noded_, subdivision_);
        if (exact.vertices != ours.vertices || exact.edges != ours.edges ||
            exact.twice_areas != ours.twice_areas || exact.adjacency != ours.adjacency)
            throw std::logic_error("an arrangement with exact construction has " +
                                   std::to_string(exact.twice_areas.size()) + " faces, the cut has " +
                                   std::to_string(ours.twice_areas.size()) +
                                   ", or areas or adjacency differ");
        report.verified = true;
    }

    void add_network(CutReport& report) const {
        const CutContext cut = context_of(faces_);
        NetworkReport network = measure_network(cut, report.domain_area - model_.unjointed_area);
        report.joints = std::move(network.joints);
        report.nodes = network.nodes;
        report.changes = joint_changes(cut);
        report.changes.insert(report.changes.end(), merges_.changes.begin(), merges_.changes.end());
        report.warnings.insert(report.warnings.end(), network.warnings.begin(), network.warnings.end());
        for (const std::size_t k : faces_.idle_tunnels)
            report.warnings.push_back("tunnel '" + model_.tunnels[k].name +
                                      "' lies outside the outline and removes nothing");
    }

    void fill_report(CutResult& result) const {
        CutReport& report = result.report;
        const BlockMesh& mesh = result.mesh;
        report.blocks = mesh.block_count();
        report.merges = merges_;
        report.trace_ends = model_.trace_ends;
        report.noding_rounds = noded_.rounds;
        report.largest_snap = noded_.largest_snap;
        report.merged_vertices = std::count(removed_.begin(), removed_.end(), 1);
        for (const EdgeMark& mark : mesh.edge_marks)
            ++(mark == EdgeMark{} ? report.boundary_edges : report.interior_edges);
        report.interior_edges /= 2;
        report.sizes = size_summary(mesh);
        report.free_sizes = size_summary(mesh, true);
        report.shapes = shape_summary(mesh);
        for (const ExcavatedBlocks& e : mesh.excavations) {
            report.excavations.push_back({e.name, e.stage, e.blocks.size(), 0});
            for (const BlockIndex b : e.blocks) report.excavations.back().area += block_area(mesh, b);
        }
        for (const BlockIndex b : mesh.blocks())
            report.slivers += block_roundness(mesh, b) < model_.small_blocks.below_roundness;
        count_islands(report);
        if (model_.kinematics)
            report.kinematics = screen_blocks(mesh, *model_.kinematics, domain_bounds(model_), model_.grid);
    }

    void count_islands(CutReport& report) const {
        for (const BlockRings& block : blocks_)
            for (std::size_t r = 1; r < block.rings.size(); ++r) {
                ++report.holes;
                if (!encloses_rock(block.rings[r], subdivision_, faces_)) continue;
                ++report.islands;
                if (model_.islands == IslandPolicy::keep) warn_of_island(block.rings[r], report);
                if (model_.islands != IslandPolicy::error) continue;
                const HalfEdgeIndex h = block.rings[r][0];
                const Point p = noded_.frame.position(start(h));
                throw InputError(
                    model_.domain_location,
                    "one block encloses others at (" + shortest_text(p.x) + ", " + shortest_text(p.y) + ")",
                    "joints that connect them to the block around them, or islands = \"keep\", \"cut\" or "
                    "\"fill\"");
            }
    }

    /// Warns of each of the first islands that are kept; one more warning refers to the count in the report.
    void warn_of_island(const std::vector<HalfEdgeIndex>& hole, CutReport& report) const {
        constexpr std::size_t max_named = 5;
        if (report.islands > max_named + 1) return;
        if (report.islands == max_named + 1) {
            report.warnings.push_back("further islands are kept: 'islands' in the report counts them");
            return;
        }
        const GridPoint first = start(hole[0]);
        Int128 twice = 0;
        for (std::size_t k = 1; k + 1 < hole.size(); ++k)
            twice -= twice_area(first, start(hole[k]), start(hole[k + 1]));
        char area[32];
        std::snprintf(area, sizeof area, "%.4g",
                      static_cast<double>(twice) / 2 * noded_.frame.step * noded_.frame.step);
        const Point p = noded_.frame.position(first);
        report.warnings.push_back(std::string("an island of ") + area + " m2 at (" + shortest_text(p.x) +
                                  ", " + shortest_text(p.y) + ") is kept within one block");
    }

    const SlopeModel& model_;
    const std::vector<Trace>& traces_;
    SourceTable table_;
    NodedEdges noded_;
    Subdivision subdivision_;
    MergeReport merges_;
    FaceBlocks faces_;
    BlockBoundary boundary_;
    EdgeMarks edges_;
    PerBlock<BlockRings> blocks_;
    PerNode<char> removed_;
    PerVertex<GridPoint> grid_points_;  ///< of the mesh
    Int128 twice_block_area_ = 0;
};

Change island_cut_change(const Trace& cut) {
    const Point &a = cut.points.front(), &b = cut.points.back();
    return {ChangeKind::island_cut,
            {(a.x + b.x) / 2, (a.y + b.y) / 2},
            0,
            std::hypot(b.x - a.x, b.y - a.y),
            cut.name,
            {}};
}

}  // namespace

CutResult cut_blocks(const SlopeModel& model, const std::vector<Trace>& traces, const CutOptions& options) {
    // A cut may divide a block that contains another island; the next round finds that island.
    constexpr int max_rounds = 20;
    if (model.base) {
        const SlopeWithBase slope = add_base(model, traces);
        return cut_blocks(slope.model, slope.traces, options);
    }
    std::vector<Trace> all = traces;
    for (int round = 0;; ++round) {
        CutResult result = Cutter(model, all, options).cut(options);
        result.report.island_cuts = all.size() - traces.size();
        for (std::size_t k = traces.size(); k < all.size(); ++k)
            result.report.changes.push_back(island_cut_change(all[k]));
        sort_changes(result.report.changes);
        if (model.islands != IslandPolicy::cut || result.report.islands == 0) return result;
        const std::vector<Trace> cuts = island_cuts(result.mesh);
        if (cuts.empty() || round == max_rounds) {
            result.report.warnings.push_back(std::to_string(result.report.islands) +
                                             " islands could not be connected to the block around them "
                                             "by a cut and are kept");
            return result;
        }
        all.insert(all.end(), cuts.begin(), cuts.end());
    }
}

}  // namespace rockslope::blockgen
