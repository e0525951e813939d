#include "dda/io/read_boundaries.hpp"

#include <algorithm>

#include "blockgen/base/text.hpp"
#include "dda/io/find_faces.hpp"
#include "dda/io/read_materials.hpp"

namespace dda {

using blockgen::ConfigTable;
using blockgen::Dimension;

namespace {

Hold hold_of_name(const std::string& name) {
    return name == "both" ? Hold::both : name == "normal" ? Hold::normal : Hold::none;
}

std::vector<std::string> names_of(const std::vector<ViscousBoundary>& boundaries) {
    std::vector<std::string> names;
    for (const ViscousBoundary& boundary : boundaries) names.push_back(boundary.name);
    return names;
}

ViscousBoundary read_boundary(const ConfigTable& table, const Model& model) {
    ViscousBoundary boundary;
    boundary.name = table.string("name");
    const std::vector<std::string> others = names_of(model.viscous_boundaries);
    if (std::find(others.begin(), others.end(), boundary.name) != others.end())
        table.fail("name", "there are two viscous boundaries '" + boundary.name + "'", "another name");
    for (const FaceOnLine& found : read_faces(table, model).faces) boundary.faces.push_back(found.face);
    boundary.normal_impedance = not_negative(table, "normal_impedance", Dimension::none, 0);
    boundary.shear_impedance = not_negative(table, "shear_impedance", Dimension::none, 0);
    boundary.hold = hold_of_name(table.choice("hold", {"both", "normal", "none"}, "both"));
    return boundary;
}

TimeTable read_velocity(const ConfigTable& axis, InputFiles& files) {
    const double scale = axis.number("scale", Dimension::none, 1.0);
    const TimeTable table = read_time_table(axis, Dimension::velocity, files);
    std::vector<double> values = table.values();
    for (double& value : values) value *= scale;
    return {table.times(), std::move(values)};
}

void check_boundary(const ConfigTable& table, const std::string& name, const Model& model) {
    const std::vector<std::string> names = names_of(model.viscous_boundaries);
    if (names.empty())
        table.fail("boundary", "there is no viscous boundary, so no wave can come in",
                   "a [[viscous_boundary]] in this file");
    if (name.empty() || std::find(names.begin(), names.end(), name) != names.end()) return;
    const auto nearest = blockgen::nearest_word(name, names);
    table.fail("boundary", "there is no viscous boundary '" + name + "'",
               "perhaps '" + nearest.value_or(names.front()) + "'");
}

}  // namespace

void read_boundaries(const ConfigTable& run, Model& model) {
    for (const ConfigTable& table : run.array_of_tables("viscous_boundary"))
        model.viscous_boundaries.push_back(read_boundary(table, model));
}

std::vector<IncidentWave> read_incident_waves(const ConfigTable& stage, const Model& model,
                                              InputFiles& files) {
    std::vector<IncidentWave> waves;
    for (const ConfigTable& table : stage.array_of_tables("incident_wave")) {
        const TimeTable at_rest({0.0}, {0.0});
        IncidentWave wave{table.string("boundary", ""), at_rest, at_rest};
        check_boundary(table, wave.boundary, model);
        if (const auto axis = table.optional_table("x")) wave.x = read_velocity(*axis, files);
        if (const auto axis = table.optional_table("y")) wave.y = read_velocity(*axis, files);
        waves.push_back(std::move(wave));
    }
    return waves;
}

}  // namespace dda
