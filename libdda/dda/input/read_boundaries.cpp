#include <algorithm>
#include <stdexcept>

#include "common/base/magnitude.hpp"
#include "common/base/text.hpp"
#include "dda/input/find_faces.hpp"
#include "dda/input/read_materials.hpp"
#include "dda/input/read_stages.hpp"
#include "record/differentiate.hpp"

namespace rockslope::dda {

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
    for (const FaceAlongLine& found : read_faces(table, model).faces) boundary.faces.push_back(found.face);
    boundary.normal_impedance = not_negative(table, "normal_impedance", Dimension::none, 0);
    boundary.shear_impedance = not_negative(table, "shear_impedance", Dimension::none, 0);
    boundary.hold = hold_of_name(table.choice("hold", {"both", "normal", "none"}, "both"));
    return boundary;
}

/// The velocity of a record, m/s; an acceleration is integrated from rest.
TimeTable velocity_of(const record::Record& record) {
    const std::vector<double> velocity = record::velocity_samples(record);
    std::vector<double> times;
    for (std::size_t k = 0; k < velocity.size(); ++k) times.push_back(static_cast<double>(k) * record.dt);
    return {std::move(times), velocity};
}

/// One axis of a wave: velocities or tractions over time, or a record in any format.
struct WaveAxis {
    TimeTable table = {{0.0}, {0.0}};
    bool is_traction = false;
};

WaveAxis read_wave_axis(const ConfigTable& axis, double delay, InputFiles& files) {
    WaveAxis wave;
    const bool is_record = axis.has("file") && axis.has("quantity") && axis.string("quantity") != "stress";
    if (is_record) {
        const record::Record record = read_axis_record(axis, files);
        if (record.quantity == record::Quantity::displacement &&
            record.values.size() < record::min_spline_samples)
            axis.fail("file", "the record has " + std::to_string(record.values.size()) + " samples",
                      "at least 5 to differentiate a displacement");
        wave.table = velocity_of(record);
    } else {
        wave.is_traction = axis.choice("quantity", {"velocity", "stress"}, "velocity") == "stress";
        wave.table = read_time_table(axis, wave.is_traction ? Dimension::stress : Dimension::velocity, files);
    }
    const double scale = axis.number("scale", Dimension::none, 1.0);
    std::vector<double> values = wave.table.values();
    for (double& value : values) value *= scale;
    if (!std::all_of(values.begin(), values.end(), is_in_allowed_range))
        axis.fail("scale", "the values of [" + axis.path() + "] are too large", "magnitudes up to 1e30");
    wave.table = delayed({wave.table.times(), std::move(values)}, delay);
    return wave;
}

/// Checks that a name is that of a viscous boundary through which a wave can enter. A boundary with a free
/// field admits none.
void check_boundary(const ConfigTable& table, const char* key, const std::string& name, const Model& model) {
    const std::vector<std::string> names = names_of(model.viscous_boundaries);
    if (names.empty())
        table.fail(key, "there is no viscous boundary, so no wave can come in",
                   "a [[viscous_boundary]] in this file");
    if (name.empty()) return;
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
        const auto nearest = nearest_word(name, names);
        table.fail(key, "there is no viscous boundary '" + name + "'",
                   "perhaps '" + nearest.value_or(names.front()) + "'");
    }
    if (model.viscous_boundaries[found - names.begin()].free_field)
        table.fail(key, "the boundary '" + name + "' has a free field, so no wave can enter through it",
                   "the viscous boundary at the base of the model");
}

void read_free_field(const ConfigTable& table, const Model& model, ViscousBoundary& boundary) {
    const double layer = not_negative(table, "free_field_layer", Dimension::length, 0);
    try {
        boundary.free_field = make_free_field(model, boundary.faces, table.string("free_field"), layer);
    } catch (const std::invalid_argument& error) {
        table.fail("free_field", "the free field of '" + boundary.name + "' cannot be made: " + error.what(),
                   "an upright side without gaps");
    }
}

void check_below(const ConfigTable& table, const Model& model, const ViscousBoundary& boundary) {
    if (!boundary.free_field) return;
    if (boundary.free_field->base_boundary.empty())
        table.fail("free_field", "'free_field' is empty",
                   "the name of the viscous boundary at the base of the model");
    check_boundary(table, "free_field", boundary.free_field->base_boundary, model);
}

}  // namespace

void read_boundaries(const ConfigTable& run, Model& model) {
    const std::vector<ConfigTable> tables = run.array_of_tables("viscous_boundary");
    for (const ConfigTable& table : tables) model.viscous_boundaries.push_back(read_boundary(table, model));
    for (std::size_t k = 0; k < tables.size(); ++k)
        if (tables[k].has("free_field")) read_free_field(tables[k], model, model.viscous_boundaries[k]);
    for (std::size_t k = 0; k < tables.size(); ++k)
        check_below(tables[k], model, model.viscous_boundaries[k]);
}

std::vector<IncidentWave> read_incident_waves(const ConfigTable& stage, const Model& model,
                                              InputFiles& files) {
    std::vector<IncidentWave> waves;
    for (const ConfigTable& table : stage.array_of_tables("incident_wave")) {
        const std::string boundary = table.string("boundary", "");
        check_boundary(table, "boundary", boundary, model);
        const double delay = not_negative(table, "delay", Dimension::time, 0);
        WaveAxis x, y;
        if (const auto axis = table.optional_table("x")) x = read_wave_axis(*axis, delay, files);
        if (const auto axis = table.optional_table("y")) y = read_wave_axis(*axis, delay, files);
        waves.push_back({boundary, x.table, y.table, x.is_traction, y.is_traction});
    }
    return waves;
}

}  // namespace rockslope::dda
