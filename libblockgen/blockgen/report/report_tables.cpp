#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <numbers>

#include "blockgen/report/cut_report.hpp"
#include "common/base/degree.hpp"

namespace rockslope::blockgen {

namespace {

constexpr std::size_t max_rows_per_kind = 20;

/// Lines of text, formatted as printf does.
class Page {
  public:
    __attribute__((format(printf, 2, 3))) void line(const char* format, ...) {
        char text[512];
        va_list values;
        va_start(values, format);
        std::vsnprintf(text, sizeof text, format, values);
        va_end(values);
        text_ += text;
        text_ += '\n';
    }
    const std::string& text() const { return text_; }

  private:
    std::string text_;
};

/// A name padded to 20 characters; longer names are not truncated.
std::string padded(const std::string& name) {
    return name + std::string(name.size() < 20 ? 20 - name.size() : 1, ' ');
}

std::string target_text(double value) {
    if (value == 0) return "-";
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}

void blocks_table(Page& page, const CutReport& r) {
    page.line("Blocks");
    page.line("  number                    %zu", r.blocks);
    page.line("  rock                      %.9g m2, %s", r.domain_area,
              r.area_proved ? "filled exactly by the blocks" : "not verified");
    if (r.verified) page.line("  exact construction        agrees");
    if (r.noding) {
        page.line("  noding proved             %zu segments; %zu faces before, %zu after, %zu of them equal",
                  r.noding->segments, r.noding->faces_before, r.noding->faces_after, r.noding->equal_faces);
        page.line("  nodes changed by it       %zu; %zu segments too short for the grid",
                  r.noding->changed_nodes, r.noding->collapsed);
    }
    page.line("  D10, D50, D90 by area     %.4g, %.4g, %.4g m2", r.sizes.d10, r.sizes.d50, r.sizes.d90);
    if (r.free_sizes.area < r.sizes.area)
        page.line("  of those not held         %.4g, %.4g, %.4g m2", r.free_sizes.d10, r.free_sizes.d50,
                  r.free_sizes.d90);
    page.line("  smallest, largest         %.4g, %.4g m2", r.sizes.smallest_area, r.sizes.largest_area);
    page.line("  roundness P10, P50, P90   %.3f, %.3f, %.3f", r.shapes.roundness.p10, r.shapes.roundness.p50,
              r.shapes.roundness.p90);
    page.line("  width/length P10 to P90   %.3f, %.3f, %.3f", r.shapes.aspect.p10, r.shapes.aspect.p50,
              r.shapes.aspect.p90);
    page.line("  corners of a block        %.2f", r.shapes.mean_corners);
    page.line("  smallest edge             %.4g m", r.corners.smallest_edge);
    page.line("  smallest angle            %.4g deg", r.corners.smallest_angle * 180 / std::numbers::pi);
    page.line("  slivers                   %zu", r.slivers);
    page.line("  largest snap              %.3g m", r.largest_snap);
}

void changes_table(Page& page, const CutReport& r) {
    page.line("\nChanges");
    page.line("  straight vertices removed     %zu", r.merged_vertices);
    page.line("  small blocks found, merged    %zu, %zu (%.4g m2)", r.merges.small_blocks,
              r.merges.merged_blocks, r.merges.merged_area);
    page.line("  largest small block merged    %s m2", target_text(r.merges.largest_merged).c_str());
    page.line("  small blocks kept             %zu", r.merges.kept_small);
    page.line("  islands kept, cuts, filled    %zu, %zu, %zu", r.islands, r.island_cuts,
              r.merges.filled_islands);
    page.line("  ends moved by snap, short     %zu, %zu within %s m", r.trace_ends.joined.size(),
              r.trace_ends.near_misses.size(), target_text(r.trace_ends.reach).c_str());
    if (!r.changes.empty())
        page.line(
            "\n  what                                      x m           y m    area m2   length m   joint");
    std::size_t listed = 0;
    for (std::size_t k = 0; k < r.changes.size(); ++k) {
        const Change& c = r.changes[k];
        listed = k > 0 && r.changes[k - 1].kind == c.kind ? listed + 1 : 0;
        if (listed < max_rows_per_kind)
            page.line("  %-33s %12.3f  %12.3f %10s %10s   %s%s%s", label_of(c.kind), c.at.x, c.at.y,
                      target_text(c.area).c_str(), target_text(c.length).c_str(), c.joint.c_str(),
                      c.other.empty() ? "" : " to ", c.other.c_str());
        const bool is_last = k + 1 == r.changes.size() || r.changes[k + 1].kind != c.kind;
        if (is_last && listed >= max_rows_per_kind)
            page.line("  %-33s and %zu more; the JSON report lists all", label_of(c.kind),
                      listed + 1 - max_rows_per_kind);
    }
}

/// Length by direction of the joints of each name.
void directions_table(Page& page, const CutReport& r) {
    if (r.joints.empty()) return;
    page.line("\nDirections (m in the rock, from -90 to 90 deg by 10)");
    for (const JointBalance& b : r.joints) {
        std::string row;
        for (const double length : b.length_by_direction) {
            char text[32];
            std::snprintf(text, sizeof text, " %.4g", length);
            row += text;
        }
        page.line("  %s%s", padded(b.name).c_str(), row.c_str());
    }
}

/// Mean planes in space of the sets.
void planes_table(Page& page, const CutReport& r) {
    if (r.planes.empty()) return;
    page.line("\nPlanes in space       number  mean dip  dip direction   Fisher K   asked for");
    for (const JointPlanes& set : r.planes)
        page.line("  %s%6zu %9.2f %14.2f %10s  %10s", padded(set.name).c_str(), set.planes.size(),
                  set.mean.dip / degree, set.mean.dip_direction / degree,
                  target_text(set.k.value_or(0)).c_str(), target_text(set.asked_k).c_str());
    if (!r.densest_planes) return;
    const DensestPlanes& d = *r.densest_planes;
    page.line(
        "  Densest of %zu poles: %.2f/%06.2f, %.3g %% of them for 1 %% of the area (uniform: 1, sd %.2f)",
        d.count, d.plane.dip / degree, d.plane.dip_direction / degree, d.density, d.uniform_deviation);
}

void joints_table(Page& page, const CutReport& r) {
    page.line("\nJoints (m)            traces      input   retained     pruned   free face    outside");
    for (const JointBalance& b : r.joints)
        page.line("  %s%6zu %10.2f %10.2f %10.2f  %10.2f %10.2f", padded(b.name).c_str(), b.traces, b.input,
                  b.retained, b.pruned, b.on_boundary, b.outside);
    for (const JointBalance& b : r.joints)
        if (b.repeated > 0)
            page.line("  %s%.4g m more in the rock along earlier joints, where they count",
                      padded(b.name).c_str(), b.repeated);
    page.line("\nDensities             P10 1/m   target     P20 1/m2   target     P21 1/m   target");
    for (const JointBalance& b : r.joints)
        page.line("  %s%7.4g %8s   %10.4g %8s   %9.4g %8s", padded(b.name).c_str(), b.p10,
                  target_text(b.p10_target).c_str(), b.p20, target_text(b.p20_target).c_str(), b.p21,
                  target_text(b.p21_target).c_str());
    directions_table(page, r);
    planes_table(page, r);
    for (const JointBalance& b : r.joints)
        if (b.weighted_by_section)
            page.line("  %sweighted by the chance that the section meets its planes (Terzaghi)",
                      padded(b.name).c_str());
    const NodeCounts& n = r.topology.nodes;
    page.line("\nNodes: %zu tips (I), %zu abutments (Y), %zu crossings (X), %zu at free faces", n.i, n.y, n.x,
              n.edge);
    page.line("Network: %zu branches in %zu clusters, of which the largest has %.3g %% of the length",
              r.topology.branches, r.topology.clusters, 100 * r.topology.largest_cluster);
}

void scanlines_table(Page& page, const CutReport& r) {
    if (!r.joints.empty())
        page.line("Volumetric joint count: %.4g joints per m3, if all sets strike across the section",
                  volumetric_joint_count(r.joints));
    if (r.scanlines.empty()) return;
    page.line("\nScanlines              rock m  joints   per m   RQD %%   RQD %% of random joints");
    for (const ScanlineCount& s : r.scanlines)
        page.line("  %s%9.2f %7zu %7.3g %7.1f   %7.1f", padded(s.name).c_str(), s.rock, s.joints,
                  s.frequency(), s.rock_quality(), s.random_rock_quality());
}

void kinematics_table(Page& page, const KinematicReport& k) {
    page.line("\nKinematics");
    for (const BlockMode mode : {BlockMode::enclosed, BlockMode::tapered, BlockMode::stable,
                                 BlockMode::falling, BlockMode::sliding, BlockMode::sliding_two_faces})
        page.line("  %s%6td", padded(label_of(mode)).c_str(), std::count(k.mode.begin(), k.mode.end(), mode));
    if (k.blocks.empty()) return;
    page.line("  block   mode                      safety    area m2");
    for (const KeyBlock& b : k.blocks)
        page.line("  %5d   %s %10.3f %10.4g", b.block.value(), (padded(label_of(b.mode)) + "  ").c_str(),
                  b.factor_of_safety, b.area);
}

}  // namespace

std::string report_tables(const CutReport& report) {
    Page page;
    blocks_table(page, report);
    changes_table(page, report);
    if (!report.excavations.empty()) page.line("\nExcavations            stage  blocks    area m2");
    for (const ExcavationReport& e : report.excavations)
        page.line("  %s%7d %7zu %10.4g", padded(e.name).c_str(), e.stage, e.blocks, e.area);
    joints_table(page, report);
    scanlines_table(page, report);
    if (report.kinematics) kinematics_table(page, *report.kinematics);
    if (!report.warnings.empty()) page.line("\nWarnings");
    for (const std::string& warning : report.warnings) page.line("  %s", warning.c_str());
    return page.text();
}

}  // namespace rockslope::blockgen
