#include "blockgen/report/geojson_text.hpp"

#include <map>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "blockgen/mesh/measures.hpp"
#include "blockgen/report/water_line_across.hpp"
#include "common/base/text.hpp"

namespace rockslope::blockgen {

namespace {

std::string json_text(const std::string& text) {
    return nlohmann::json(text).dump();
}

const char* label_of(BlockMotion motion) {
    return motion == BlockMotion::fixed ? "fixed" : motion == BlockMotion::prescribed ? "prescribed" : "free";
}

void append_position(std::string& text, const Point& p) {
    text += "[" + shortest_text(p.x) + "," + shortest_text(p.y) + "]";
}

void append_feature(std::string& text, const std::string& properties, const char* type,
                    const std::string& coordinates) {
    if (!text.ends_with('\n')) text += ",\n";
    text += R"({"type":"Feature","properties":{)" + properties + R"(},"geometry":{"type":")" + type +
            R"(","coordinates":)" + coordinates + "}}";
}

void append_polygon(std::string& text, const BlockMesh& mesh, BlockIndex block) {
    std::string rings;
    for (std::size_t r = 0; r < mesh.ring_count(block); ++r) {
        rings += rings.empty() ? "[[" : ",[";
        const auto ring = mesh.ring(block, r);
        for (const VertexIndex v : ring) {
            append_position(rings, mesh.vertices[v]);
            rings += ",";
        }
        append_position(rings, mesh.vertices[ring.front()]);
        rings += "]";
    }
    std::string properties =
        R"("what":"block","block":)" + std::to_string(block.value()) + R"(,"block_material":)" +
        json_text(mesh.block_materials[mesh.block_material[block]]) + R"(,"area_m2":)" +
        shortest_text(block_area(mesh, block)) + R"(,"motion":")" + label_of(mesh.motion[block]) + "\"";
    if (!mesh.motion_name[block].empty()) properties += ",\"name\":" + json_text(mesh.motion_name[block]);
    append_feature(text, properties, "Polygon", rings + "]");
}

void append_water_table(std::string& text, const BlockMesh& mesh) {
    std::string line;
    for (const Point& p : water_line_across(mesh)) {
        line += line.empty() ? "[" : ",";
        append_position(line, p);
    }
    if (!line.empty()) append_feature(text, R"("what":"water_table")", "LineString", line + "]");
}

using EndPair = std::pair<VertexIndex, VertexIndex>;

/// The edges between blocks by joint and joint material, each once.
std::map<std::pair<JointIndex, JointMaterialIndex>, std::vector<EndPair>> edges_of_joints(
    const BlockMesh& mesh) {
    std::map<std::pair<JointIndex, JointMaterialIndex>, std::vector<EndPair>> edges;
    for (const BlockIndex block : mesh.blocks())
        for (std::size_t r = 0; r < mesh.ring_count(block); ++r) {
            const auto ring = mesh.ring(block, r);
            const auto marks = mesh.ring_marks(block, r);
            for (std::size_t k = 0; k < ring.size(); ++k) {
                const VertexIndex a = ring[k], b = ring[(k + 1) % ring.size()];
                // Each of these edges belongs to two blocks, in both directions.
                if (marks[k].joint_material.exists() && a < b)
                    edges[{marks[k].joint, marks[k].joint_material}].emplace_back(a, b);
            }
        }
    return edges;
}

}  // namespace

std::string geojson_text(const BlockMesh& mesh, const std::string& crs) {
    std::string text = R"({"type":"FeatureCollection",)";
    if (!crs.empty()) text += R"("crs":{"type":"name","properties":{"name":)" + json_text(crs) + "}},";
    text += "\"features\":[\n";
    for (const BlockIndex block : mesh.blocks()) append_polygon(text, mesh, block);
    for (const auto& [mark, edges] : edges_of_joints(mesh)) {
        std::string lines;
        for (const auto& [a, b] : edges) {
            lines += lines.empty() ? "[[" : ",[";
            append_position(lines, mesh.vertices[a]);
            lines += ",";
            append_position(lines, mesh.vertices[b]);
            lines += "]";
        }
        const auto& [joint, material] = mark;
        std::string properties = R"("what":"joint",)";
        if (joint.exists()) properties += "\"joint\":" + std::to_string(joint.value()) + ",";
        properties += "\"name\":" + json_text(joint.exists() ? mesh.joints[joint].set : "outline") +
                      ",\"joint_material\":" + json_text(mesh.joint_materials[material]);
        append_feature(text, properties, "MultiLineString", lines + "]");
    }
    append_water_table(text, mesh);
    return text + "\n]}\n";
}

}  // namespace rockslope::blockgen
