#include "dda/input/read_face_loads.hpp"

#include <algorithm>

#include "common/base/text.hpp"
#include "common/geometry/polygon.hpp"
#include "dda/input/find_faces.hpp"

namespace rockslope::dda {

namespace {

void check_known(const ConfigTable& table, const char* key, std::vector<std::string> names,
                 const std::string& name) {
    if (std::find(names.begin(), names.end(), name) != names.end()) return;
    const auto nearest = nearest_word(name, names);
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    std::string list;
    for (const std::string& each : names) list += (list.empty() ? "" : ", ") + each;
    table.fail(key, "there is no " + std::string(key) + " '" + name + "'",
               nearest         ? "perhaps '" + *nearest + "'"
               : names.empty() ? "no '" + std::string(key) + "', for the block file has none"
                               : "one of " + list);
}

/// Selects the faces that water wets, from the keys of a table.
class WettedFaceFilter {
  public:
    WettedFaceFilter(const ConfigTable& table, const Model& model, bool free_faces_too) : model_(model) {
        if (table.has("joint_material")) {
            material_ = table.string("joint_material");
            std::vector<std::string> names;
            for (const JointMaterial& material : model.joint_materials) names.push_back(material.name);
            check_known(table, "joint_material", names, material_);
        }
        if (table.has("joint_set")) {
            set_ = table.string("joint_set");
            check_known(table, "joint_set", model.joint_sets, set_);
        }
        if (table.has("region")) {
            for (const auto& [x, y] : table.pairs("region", Dimension::length))
                region_.push_back({x - model.origin.x(), y - model.origin.y()});
            if (region_.size() < 3)
                table.fail("region", "'region' in [" + table.path() + "] has fewer than three points",
                           "three points or more");
        }
        free_faces_ = free_faces_too && table.boolean("free_faces", true);
    }

    bool is_wet(EdgeIndex edge) const {
        const Topology& topology = model_.topology;
        if (model_.motion[topology.block_of_edge(edge)] != Motion::free) return false;
        const Vec2& start = model_.vertices[start_of(edge)];
        const Vec2 middle = (start + model_.vertices[topology.end_of(edge)]) / 2;
        if (!region_.empty() && side_of_ring(region_, {middle.x(), middle.y()}) < 0) return false;
        const JointMaterialIndex material = topology.joint_material[edge];
        if (!material.exists()) return free_faces_;
        if (!material_.empty() && model_.joint_material_at(material).name != material_) return false;
        const JointIndex joint = topology.joint[edge];
        return set_.empty() || (joint.exists() && model_.joint_sets[joint] == set_);
    }

  private:
    const Model& model_;
    std::string material_;
    std::string set_;
    Ring region_;  ///< m, in the model's coordinates
    bool free_faces_ = false;
};

}  // namespace

LineLoad read_line_load(const ConfigTable& table, const Model& model, InputFiles& files) {
    const FacesAlongLine line = read_faces(table, model);
    if (!table.has("pressure") && !table.has("traction"))
        table.fail("pressure", "[" + table.path() + "] has neither 'pressure' nor 'traction'", "one of them");
    const double pressure = table.number("pressure", Dimension::stress, 0);
    const double pressure_end = table.number("pressure_end", Dimension::stress, pressure);
    const std::array<double, 2> traction = table.pair("traction", Dimension::stress, {0, 0});
    const std::array<double, 2> traction_end = table.pair("traction_end", Dimension::stress, traction);
    LineLoad load;
    for (const FaceAlongLine& found : line.faces) {
        const auto pressure_at = [&](double along) {
            return pressure + along / line.length * (pressure_end - pressure);
        };
        const auto traction_at = [&](double along) {
            const double fraction = along / line.length;
            return Vec2(traction[0] + fraction * (traction_end[0] - traction[0]),
                        traction[1] + fraction * (traction_end[1] - traction[1]));
        };
        load.faces.push_back({found.face, pressure_at(found.start), pressure_at(found.end),
                              traction_at(found.start), traction_at(found.end)});
    }
    load.history = read_history(table, files);
    return load;
}

std::vector<EdgeIndex> read_wetted_faces(const ConfigTable& table, const Model& model, bool free_faces_too) {
    const WettedFaceFilter filter(table, model, free_faces_too);
    std::vector<EdgeIndex> edges;
    for (const EdgeIndex edge : model.topology.edges()) {
        if (filter.is_wet(edge)) edges.push_back(edge);
    }
    if (edges.empty())
        table.fail("region", "[" + table.path() + "] wets no face of a block that can move",
                   "joints, free faces or a region with such faces");
    return edges;
}

std::vector<Vec2> read_head(const ConfigTable& table, std::span<const Point> water_table,
                            const Model& model) {
    std::vector<Vec2> head;
    if (!table.has("head") || table.is_string("head")) {
        if (const std::string word = table.string("head", "section"); word != "section")
            table.fail("head", "'head' in [" + table.path() + "] is \"" + word + "\"",
                       "[[x, y], ...], or \"section\" for the water table of the slope model");
        if (water_table.empty())
            table.fail("head", "the block file has no water table to be the head of [" + table.path() + "]",
                       "'head' as [[x, y], ...], or [water_table] in the slope model");
        for (const Point& point : water_table) head.push_back(Vec2(point.x, point.y) - model.origin);
        return head;
    }
    for (const auto& [x, y] : table.pairs("head", Dimension::length)) {
        const Vec2 point = Vec2(x, y) - model.origin;
        if (!head.empty() && point.x() <= head.back().x())
            table.fail("head", "'head' in [" + table.path() + "] does not have increasing x",
                       "points with increasing x");
        head.push_back(point);
    }
    if (head.empty())
        table.fail("head", "'head' in [" + table.path() + "] is empty", "one point or more, [[x, y], ...]");
    return head;
}

}  // namespace rockslope::dda
