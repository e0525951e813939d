#include <algorithm>
#include <nlohmann/json.hpp>
#include <numbers>

#include "blockgen/report/cut_report.hpp"
#include "common/base/degree.hpp"

namespace rockslope::blockgen {

const char* label_of(BlockMode mode) {
    switch (mode) {
        case BlockMode::enclosed:
            return "enclosed";
        case BlockMode::tapered:
            return "tapered";
        case BlockMode::stable:
            return "stable";
        case BlockMode::falling:
            return "falling";
        case BlockMode::sliding:
            return "sliding";
        case BlockMode::sliding_two_faces:
            return "sliding on two faces";
    }
    return "";
}

namespace {

nlohmann::ordered_json areas_json(const AreaSummary& s) {
    return {{"smallest", s.smallest_area},
            {"d10", s.d10},
            {"d50", s.d50},
            {"d90", s.d90},
            {"largest", s.largest_area}};
}

nlohmann::ordered_json deciles_json(const Deciles& d) {
    return {{"p10", d.p10}, {"p50", d.p50}, {"p90", d.p90}};
}

nlohmann::ordered_json kinematics_json(const KinematicReport& report) {
    using Json = nlohmann::ordered_json;
    Json counts = Json::object(), blocks = Json::array();
    for (const BlockMode mode : {BlockMode::enclosed, BlockMode::tapered, BlockMode::stable,
                                 BlockMode::falling, BlockMode::sliding, BlockMode::sliding_two_faces})
        counts[label_of(mode)] = std::count(report.mode.begin(), report.mode.end(), mode);
    for (const KeyBlock& b : report.blocks) {
        Json row = {{"block", b.block.value()},
                    {"mode", label_of(b.mode)},
                    {"factor_of_safety", b.factor_of_safety},
                    {"direction", {b.direction.x, b.direction.y}},
                    {"area_m2", b.area}};
        if (b.joint.exists()) row["joint"] = b.joint.value();
        blocks.push_back(std::move(row));
    }
    return {{"counts", counts}, {"blocks", blocks}};
}

nlohmann::ordered_json changes_json(const std::vector<Change>& changes) {
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const Change& c : changes) {
        nlohmann::ordered_json row = {{"what", label_of(c.kind)}, {"at", {c.at.x, c.at.y}}};
        if (c.area > 0) row["area_m2"] = c.area;
        row["length_m"] = c.length;
        if (!c.joint.empty()) row["joint"] = c.joint;
        if (!c.other.empty()) row["to"] = c.other;
        rows.push_back(std::move(row));
    }
    return rows;
}

nlohmann::ordered_json joints_json(const std::vector<JointBalance>& balances) {
    using Json = nlohmann::ordered_json;
    Json joints = Json::array();
    for (const JointBalance& b : balances) {
        Json asked = Json::object();
        if (b.p10_target > 0) asked["p10_per_m"] = b.p10_target;
        if (b.p20_target > 0) asked["p20_per_m2"] = b.p20_target;
        if (b.p21_target > 0) asked["p21_m_per_m2"] = b.p21_target;
        if (b.count_target > 0) asked["count"] = b.count_target;
        Json row = {{"name", b.name},
                    {"traces", b.traces},
                    {"input_m", b.input},
                    {"retained_m", b.retained},
                    {"pruned_m", b.pruned},
                    {"on_boundary_m", b.on_boundary},
                    {"outside_m", b.outside},
                    {"p10_per_m", b.p10},
                    {"p20_per_m2", b.p20},
                    {"p21_m_per_m2", b.p21},
                    {"length_by_direction_m", b.length_by_direction},
                    {"asked", asked}};
        if (b.repeated > 0) row["repeated_m"] = b.repeated;
        if (b.weighted_by_section) row["weighting"] = "section";
        joints.push_back(std::move(row));
    }
    return joints;
}

nlohmann::ordered_json noding_json(const NodingProof& p) {
    nlohmann::ordered_json row = {{"segments", p.segments},         {"collapsed_segments", p.collapsed},
                                  {"faces_before", p.faces_before}, {"faces_after", p.faces_after},
                                  {"equal_faces", p.equal_faces},   {"changed_nodes", p.changed_nodes}};
    if (p.changed_nodes > 0) row["first_change"] = {p.first_change.x, p.first_change.y};
    return row;
}

nlohmann::ordered_json planes_json(const std::vector<JointPlanes>& sets) {
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const JointPlanes& set : sets) {
        nlohmann::ordered_json row = {{"name", set.name},
                                      {"planes", set.planes.size()},
                                      {"mean_dip_deg", set.mean.dip / degree},
                                      {"mean_dip_direction_deg", set.mean.dip_direction / degree}};
        if (set.k) row["fisher_k"] = *set.k;
        if (set.asked_k > 0) row["asked_fisher_k"] = set.asked_k;
        rows.push_back(std::move(row));
    }
    return rows;
}

nlohmann::ordered_json densest_planes_json(const DensestPlanes& d) {
    return {{"poles", d.count},
            {"percent_per_percent_of_area", d.density},
            {"uniform_deviation", d.uniform_deviation},
            {"dip_deg", d.plane.dip / degree},
            {"dip_direction_deg", d.plane.dip_direction / degree}};
}

nlohmann::ordered_json scanlines_json(const std::vector<ScanlineCount>& scanlines) {
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const ScanlineCount& s : scanlines)
        rows.push_back({{"name", s.name},
                        {"rock_m", s.rock},
                        {"joints", s.joints},
                        {"joints_per_m", s.frequency()},
                        {"rqd_percent", s.rock_quality()},
                        {"rqd_of_random_joints_percent", s.random_rock_quality()},
                        {"sound_length_m", s.sound_length}});
    return rows;
}

nlohmann::ordered_json excavations_json(const std::vector<ExcavationReport>& excavations) {
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const ExcavationReport& e : excavations)
        rows.push_back({{"name", e.name}, {"stage", e.stage}, {"blocks", e.blocks}, {"area_m2", e.area}});
    return rows;
}

}  // namespace

std::string report_text(const CutReport& report) {
    using Json = nlohmann::ordered_json;
    const AreaSummary& s = report.sizes;
    const NodeCounts& n = report.topology.nodes;
    Json root = {{"blocks", report.blocks},
                 {"holes", report.holes},
                 {"islands", report.islands},
                 {"island_cuts", report.island_cuts},
                 {"filled_islands", report.merges.filled_islands},
                 {"small_blocks",
                  {{"found", report.merges.small_blocks},
                   {"merged", report.merges.merged_blocks},
                   {"merged_area_m2", report.merges.merged_area},
                   {"largest_merged_m2", report.merges.largest_merged},
                   {"kept", report.merges.kept_small}}},
                 {"interior_edges", report.interior_edges},
                 {"boundary_edges", report.boundary_edges},
                 {"slivers", report.slivers},
                 {"merged_vertices", report.merged_vertices},
                 {"noding_rounds", report.noding_rounds},
                 {"largest_snap_m", report.largest_snap},
                 {"domain_area_m2", report.domain_area},
                 {"area_proved", report.area_proved},
                 {"verified_exactly", report.verified},
                 {"block_area_m2", areas_json(s)},
                 {"free_block_area_m2", areas_json(report.free_sizes)},
                 {"roundness", deciles_json(report.shapes.roundness)},
                 {"aspect", deciles_json(report.shapes.aspect)},
                 {"mean_corners", report.shapes.mean_corners},
                 {"smallest_edge_m", report.corners.smallest_edge},
                 {"smallest_angle_deg", report.corners.smallest_angle * 180 / std::numbers::pi},
                 {"joints", joints_json(report.joints)},
                 {"nodes", {{"i", n.i}, {"y", n.y}, {"x", n.x}, {"edge", n.edge}}},
                 {"branches", report.topology.branches},
                 {"clusters", report.topology.clusters},
                 {"largest_cluster", report.topology.largest_cluster},
                 {"joints_per_m3", volumetric_joint_count(report.joints)},
                 {"scanlines", scanlines_json(report.scanlines)},
                 {"trace_ends",
                  {{"moved_by_snap", report.trace_ends.joined.size()},
                   {"stop_short", report.trace_ends.near_misses.size()},
                   {"within_m", report.trace_ends.reach},
                   {"suggested_snap_m", report.trace_ends.suggested_snap}}},
                 {"excavations", excavations_json(report.excavations)},
                 {"changes", changes_json(report.changes)},
                 {"warnings", report.warnings}};
    if (report.noding) root["noding_proof"] = noding_json(*report.noding);
    if (!report.planes.empty()) root["planes"] = planes_json(report.planes);
    if (report.densest_planes) root["densest_planes"] = densest_planes_json(*report.densest_planes);
    if (report.kinematics) root["kinematics"] = kinematics_json(*report.kinematics);
    return root.dump(2) + "\n";
}

}  // namespace rockslope::blockgen
