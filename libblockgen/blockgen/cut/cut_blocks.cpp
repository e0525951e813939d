#include "blockgen/cut/cut_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <stdexcept>

#include "blockgen/arrangement/arrange.hpp"
#include "blockgen/arrangement/prove_noding.hpp"
#include "blockgen/cut/add_base.hpp"
#include "blockgen/cut/apply_block_selectors.hpp"
#include "blockgen/cut/check_boundaries.hpp"
#include "blockgen/cut/fill_mesh.hpp"
#include "blockgen/cut/merge_blocks.hpp"
#include "blockgen/cut/simplify_boundaries.hpp"
#include "blockgen/faces/cut_context.hpp"
#include "blockgen/faces/mark_edges.hpp"
#include "blockgen/input/domain.hpp"
#include "blockgen/mesh/check_mesh.hpp"
#include "blockgen/report/dropped_traces.hpp"
#include "blockgen/report/repeated_joints.hpp"
#include "common/base/text.hpp"
#include "common/geometry/polygon.hpp"

namespace rockslope::blockgen {

namespace {

/// The subdivision by CGAL's plane sweep, which also checks the noding. Larger networks, for which the sweep
/// would take most of the time, use walk_faces(). verify_area() checks both; --verify always sweeps.
Subdivision subdivide(const NodedEdges& noded, const ThreadPool& pool) {
    constexpr std::size_t max_swept_edges = 100'000;
    return noded.edges.size() <= max_swept_edges ? arrange(noded) : walk_faces(noded, pool);
}

/// @throws InputError when there are more blocks than the limit allows.
void check_block_count(const SlopeModel& model, std::size_t count, std::size_t limit) {
    if (count > limit)
        throw InputError(model.domain_location, "the joints make " + std::to_string(count) + " blocks",
                         "at most " + std::to_string(limit) + " (--max-blocks)");
}

/// Before blocks are known: bounds the faces of the network in the box round the domain, of which a part may
/// lie outside the rock. @throws InputError when they are so many that noding and faces would take too long.
void check_face_count(const SlopeModel& model, double count, std::size_t max_blocks) {
    const double limit = 4.0 * static_cast<double>(max_blocks) + 1000;
    if (count > limit)
        throw InputError(model.domain_location,
                         "the joints make about " + std::to_string(std::llround(count)) +
                             " blocks in the box round the domain",
                         "at most " + std::to_string(std::llround(limit)) + " (four times --max-blocks, " +
                             std::to_string(max_blocks) + ", and 1000 more)");
}

/// Sums of twice the rock's area, in cells.
struct RockArea {
    Int128 of_faces = 0;     ///< within the edges between rock and no rock
    Int128 of_outlines = 0;  ///< within the noded outlines, each in its own direction
};

class Cutter {
  public:
    Cutter(const SlopeModel& model, const std::vector<Trace>& traces, const CutOptions& options)
        : model_(model),
          traces_(traces),
          options_(options),
          pool_(options.threads),
          table_(model),
          noded_(node()),
          subdivision_(subdivide_checked()),
          faces_(classify_and_merge_faces()),
          boundary_(noded_, subdivision_, faces_, pool_) {
        pass("blocks");
    }

    CutResult cut() {
        CutResult result;
        CutReport& report = result.report;
        EdgeMarks edges = mark_edges(context_of(faces_), boundary_);
        PerNode<char> removed = redundant_vertices(context_of(faces_), boundary_, edges.marks);
        report.merged_vertices = std::count(removed.begin(), removed.end(), 1);
        pass("edges");
        BlockRings rings = block_rings(noded_, subdivision_, faces_, boundary_);
        RockMaterials materials(context_of(faces_), rings);
        pass("rings");
        const Warnings warnings = report_network(rings, result);
        pass("network");
        free_subdivision();
        FilledMesh filled = fill_mesh(noded_, rings, edges, removed, std::move(materials), pool_);
        filled.mesh.excavations = std::move(result.mesh.excavations);
        result.mesh = std::move(filled.mesh);
        if (filled.twice_area != rock_area_.of_faces)
            throw std::logic_error("the areas of the blocks do not sum to the area of the rock");
        noded_.edges = {};
        noded_.vertices = {};
        rings = {};
        edges = {};
        removed = {};
        pass("mesh");
        finish(warnings, result);
        pass("checks");
        return result;
    }

  private:
    /// Warnings, by where they come from.
    struct Warnings {
        std::vector<std::string> of_regions, of_islands, of_traces;
    };

    void pass(const char* phase) const {
        if (options_.on_phase) options_.on_phase(phase);
    }

    /// What needs the network: proof, excavations, islands, and the balance of the joints where asked for.
    Warnings report_network(const BlockRings& rings, CutResult& result) {
        CutReport& report = result.report;
        rock_area_ = add_up_rock();
        if (faces_.has_disjoint_voids && rock_area_.of_faces != rock_area_.of_outlines)
            throw std::logic_error("the area of the rock differs from the area that the outlines enclose");
        report.domain_area =
            static_cast<double>(rock_area_.of_faces) / 2 * noded_.frame.step * noded_.frame.step;
        report.area_proved = true;
        report.merges = merges_;
        report.trace_ends = model_.trace_ends;
        report.noding_rounds = noded_.rounds;
        report.largest_snap = noded_.largest_snap;
        report.warnings = model_.notes;
        add_excavations(rings, result);
        Warnings warnings;
        warnings.of_regions = region_warnings(context_of(faces_));
        count_islands(rings, report, warnings.of_islands);
        warnings.of_traces = dropped_trace_warnings(context_of(faces_));
        std::vector<Change> repeated = repeated_joints(context_of(faces_));
        for (std::string& warning : repeated_joint_warnings(repeated))
            warnings.of_traces.push_back(std::move(warning));
        if (options_.full_report) add_network(std::move(repeated), report);
        if (options_.verify) verify(report);
        return warnings;
    }

    /// What needs the mesh: blocks fixed and measured points, checks, sizes.
    void finish(const Warnings& warnings, CutResult& result) const {
        std::vector<std::string>& all = result.report.warnings;
        apply_block_selectors(result.mesh, model_, all);
        const auto append = [&all](const std::vector<std::string>& more) {
            all.insert(all.end(), more.begin(), more.end());
        };
        append(boundary_warnings(result.mesh, model_));
        append(warnings.of_regions);
        check(result.mesh);
        fill_report(result);
        append(warnings.of_islands);
        append(warnings.of_traces);
        for (const std::size_t k : faces_.idle_tunnels)
            all.push_back("tunnel '" + model_.tunnels[k].name +
                          "' lies outside the outline and removes nothing");
    }

    /// Frees what the mesh is not filled from.
    void free_subdivision() {
        subdivision_ = {};
        faces_.block = {};
        boundary_.is_boundary = {};
        noded_.sources = {};
        noded_.first_source = {};
    }

    /// An invalid mesh is an error of this program, not of its input.
    void check(const BlockMesh& mesh) const {
        try {
            check_mesh(mesh, "the cut mesh", pool_);
        } catch (const InputError& error) {
            throw std::logic_error(error.what());
        }
    }

    NodedEdges node() const {
        const std::vector<SourceSegment> segments = source_segments(model_, traces_, table_);
        check_face_count(model_, estimated_blocks(model_, segments, table_), options_.max_blocks);
        pass("segments");
        NodedEdges noded = node_joints(segments, model_.grid, pool_);
        // By Euler's formula a connected network has E - V + 1 bounded faces, and others more.
        check_face_count(
            model_, static_cast<double>(noded.edges.size()) + 1 - static_cast<double>(noded.vertices.size()),
            options_.max_blocks);
        pass("noding");
        return noded;
    }

    Subdivision subdivide_checked() const {
        Subdivision subdivision = subdivide(noded_, pool_);
        check_face_count(model_, subdivision.face_count - 1, options_.max_blocks);
        pass("faces");
        return subdivision;
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
        check_block_count(model_, faces.material.size(), options_.max_blocks);
        return faces;
    }

    CutContext context_of(const FaceBlocks& faces) const {
        return {.noded = noded_,
                .subdivision = subdivision_,
                .faces = faces,
                .model = model_,
                .traces = traces_,
                .table = table_,
                .pool = pool_};
    }
    FaceBlockIndex block_of(HalfEdgeIndex half_edge) const {
        return faces_.block[subdivision_.face[half_edge]];
    }
    const GridPoint& start(HalfEdgeIndex half_edge) const {
        return noded_.vertices[boundary_.origin(half_edge)];
    }

    /// Adds the excavations that remove rock, in the order of the model.
    void add_excavations(const BlockRings& rings, CutResult& result) const {
        std::vector<ExcavatedBlocks> excavations;
        for (const Excavation& e : model_.excavations) excavations.push_back({e.name, e.stage, {}});
        for (const BlockIndex b : rings.blocks())
            if (const ExcavationIndex k = faces_.excavation[rings.block[b]]; k.exists())
                excavations[k].blocks.push_back(b);
        for (ExcavatedBlocks& e : excavations) {
            if (e.blocks.empty())
                result.report.warnings.push_back("excavation '" + e.name + "' removes no rock");
            else
                result.mesh.excavations.push_back(std::move(e));
        }
    }

    /// In exact integers. When no hole or tunnel crosses the outline or overlaps another one, both sums must
    /// be the same.
    RockArea add_up_rock() const {
        const auto part = [&](std::size_t begin, std::size_t end) {
            RockArea sum;
            for (const EdgeIndex e : indices<EdgeIndex>(begin, end)) add_edge(e, sum);
            return sum;
        };
        return pool_.parallel_reduce(
            noded_.edges.size(), RockArea{}, part, [](const RockArea& a, const RockArea& b) {
                return RockArea{a.of_faces + b.of_faces, a.of_outlines + b.of_outlines};
            });
    }

    void add_edge(EdgeIndex e, RockArea& sum) const {
        const int left = block_of(forward_half(e)) != FaceBlocks::outside,
                  right = block_of(backward_half(e)) != FaceBlocks::outside;
        const auto area = [&] { return twice_area({0, 0}, start(forward_half(e)), start(backward_half(e))); };
        if (left != right) sum.of_faces += area() * (left - right);
        for (const EdgeSource& s : noded_.sources_of(e)) {
            if (table_.is_joint(s.source)) break;  // sources are sorted, and those of outlines come first
            const bool is_void = (s.source >= table_.first_hole && s.source < table_.first_region) ||
                                 (s.source >= table_.first_tunnel && s.source < table_.first_joint);
            if (s.source == 0 || is_void) sum.of_outlines += (s.reversed != is_void ? -1 : 1) * area();
        }
    }

    /// Proves the subdivision of the noded edges, and the noding where the segments are not too many.
    void verify(CutReport& report) const {
        const ArrangementSummary exact = arrange_exactly(noded_), ours = summarize(noded_, subdivision_);
        if (exact.vertices != ours.vertices || exact.edges != ours.edges ||
            exact.twice_areas != ours.twice_areas || exact.adjacency != ours.adjacency)
            throw std::logic_error("an arrangement with exact construction has " +
                                   std::to_string(exact.twice_areas.size()) + " faces, the cut has " +
                                   std::to_string(ours.twice_areas.size()) +
                                   ", or areas or adjacency differ");
        report.verified = true;
        const std::vector<SourceSegment> segments = source_segments(model_, traces_, table_);
        if (segments.size() <= options_.most_proved)
            report.noding = prove_noding(segments, noded_, subdivision_);
        else
            report.warnings.push_back("--verify proved the noded edges, not the noding: there are " +
                                      std::to_string(segments.size()) + " segments, more than " +
                                      std::to_string(options_.most_proved));
    }

    void add_network(std::vector<Change> repeated, CutReport& report) const {
        const CutContext cut = context_of(faces_);
        NetworkReport network = measure_network(cut, report.domain_area - model_.unjointed_area);
        report.joints = std::move(network.joints);
        report.planes = joint_planes(cut);
        if (!report.planes.empty()) report.densest_planes = densest_planes(report.planes);
        report.topology = topology_of(cut);
        report.scanlines = count_along_scanlines(cut);
        report.changes = joint_changes(cut);
        std::move(repeated.begin(), repeated.end(), std::back_inserter(report.changes));
        report.changes.insert(report.changes.end(), merges_.changes.begin(), merges_.changes.end());
    }

    void fill_report(CutResult& result) const {
        CutReport& report = result.report;
        const BlockMesh& mesh = result.mesh;
        report.blocks = mesh.block_count();
        report.boundary_edges = std::count(mesh.edge_marks.begin(), mesh.edge_marks.end(), EdgeMark{});
        report.interior_edges = (mesh.edge_marks.size() - report.boundary_edges) / 2;
        const PerBlock<double> areas = block_areas(mesh, pool_);
        report.sizes = area_summary(areas, pool_);
        std::vector<double> free_areas;
        for (const BlockIndex b : areas.indices())
            if (mesh.motion[b] == BlockMotion::free) free_areas.push_back(areas[b]);
        report.free_sizes =
            free_areas.size() == areas.size() ? report.sizes : area_summary(std::move(free_areas), pool_);
        for (const ExcavatedBlocks& e : mesh.excavations) {
            report.excavations.push_back({e.name, e.stage, e.blocks.size(), 0});
            for (const BlockIndex b : e.blocks) report.excavations.back().area += areas[b];
        }
        report.slivers = count_slivers(mesh);
        if (options_.full_report) {
            report.shapes = shape_summary(mesh, pool_);
            report.corners = corner_summary(mesh, pool_);
        }
        if (model_.kinematics)
            report.kinematics = screen_blocks(mesh, *model_.kinematics, domain_bounds(model_), model_.grid);
    }

    std::size_t count_slivers(const BlockMesh& mesh) const {
        const auto part = [&](std::size_t begin, std::size_t end) {
            std::size_t slivers = 0;
            for (const BlockIndex b : indices<BlockIndex>(begin, end))
                slivers += block_roundness(mesh, b) < model_.small_blocks.below_roundness;
            return slivers;
        };
        return pool_.parallel_reduce(mesh.block_count(), std::size_t{0}, part,
                                     [](std::size_t a, std::size_t b) { return a + b; });
    }

    void count_islands(const BlockRings& rings, CutReport& report, std::vector<std::string>& warnings) const {
        for (const BlockIndex block : rings.blocks())
            for (std::size_t r = 1; r < rings.ring_count(block); ++r) {
                const RingSpan ring = rings.ring(block, r);
                ++report.holes;
                if (!encloses_rock(ring, subdivision_, faces_)) continue;
                ++report.islands;
                if (model_.islands == IslandPolicy::keep) warn_of_island(ring, report.islands, warnings);
                if (model_.islands != IslandPolicy::error) continue;
                const Point p = noded_.frame.position(start(ring[0]));
                throw InputError(
                    model_.domain_location,
                    "one block encloses others at (" + shortest_text(p.x) + ", " + shortest_text(p.y) + ")",
                    "joints that connect them to the block around them, or islands = \"keep\", \"cut\" or "
                    "\"fill\"");
            }
    }

    /// Warns of each of the first islands that are kept; one more warning refers to the count in the report.
    void warn_of_island(RingSpan hole, std::size_t islands, std::vector<std::string>& warnings) const {
        constexpr std::size_t max_named = 5;
        if (islands > max_named + 1) return;
        if (islands == max_named + 1) {
            warnings.push_back("further islands are kept: 'islands' in the report counts them");
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
        warnings.push_back(std::string("an island of ") + area + " m2 at (" + shortest_text(p.x) + ", " +
                           shortest_text(p.y) + ") is kept within one block");
    }

    const SlopeModel& model_;
    const std::vector<Trace>& traces_;
    const CutOptions& options_;
    ThreadPool pool_;
    SourceTable table_;
    NodedEdges noded_;
    Subdivision subdivision_;
    MergeReport merges_;
    FaceBlocks faces_;
    BlockBoundary boundary_;
    RockArea rock_area_;
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
        CutResult result = Cutter(model, all, options).cut();
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
