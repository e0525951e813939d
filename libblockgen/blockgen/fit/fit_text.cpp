#include "blockgen/fit/fit_text.hpp"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>

#include "common/base/text.hpp"

namespace rockslope::blockgen {

namespace {

constexpr double degrees = 180 / std::numbers::pi;
/// A set that scatters less has one direction.
constexpr double least_scatter = 0.1 / degrees;

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.5g", value);
    return text;
}

std::string number_of_degrees(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2f", value);
    return text;
}

Estimate in_degrees(const Estimate& e) {
    return {e.value * degrees, e.low * degrees, e.high * degrees};
}

const char* word_of(SetPattern pattern) {
    if (pattern == SetPattern::through) return "through the map";
    return pattern == SetPattern::on_lines ? "on lines" : "anywhere";
}

const char* word_of(Law law) {
    if (law == Law::constant) return "constant";
    return law == Law::lognormal ? "lognormal" : "exponential";
}

/// One estimate of a set, by the name that table, JSON and comments use.
struct Row {
    std::string name, unit;
    Estimate estimate;
};

std::vector<Row> rows_of(const FittedSet& set) {
    std::vector<Row> rows = {{"direction", "deg", in_degrees(set.direction)},
                             {"scatter", "deg", in_degrees(set.scatter)}};
    const auto add = [&rows](const char* name, const char* unit, const std::optional<Estimate>& estimate) {
        if (estimate) rows.push_back({name, unit, *estimate});
    };
    add("trace_length", "m", set.length);
    add("trace_length_sd", "m", set.length_sd);
    if (set.pattern != SetPattern::through) add("p20", "1/m2", set.p20);
    add("p21", "1/m", set.p21);
    add("spacing", "m", set.spacing);
    add("spacing_sd", "m", set.spacing_sd);
    add("persistence", "1", set.persistence);
    return rows;
}

/// "{ law = "lognormal", mean = 2.1, sd = 0.8 }"
std::string law_text(Law law, double mean, const std::optional<Estimate>& sd) {
    if (law == Law::constant) return number(mean);
    std::string text = std::string("{ law = \"") + word_of(law) + "\", mean = " + number(mean);
    if (law == Law::lognormal && sd) text += ", sd = " + number(sd->value);
    return text + " }";
}

std::string angle_text(const FittedSet& set) {
    std::string mean = "\"" + number_of_degrees(set.direction.value * degrees) + " deg\"";
    if (set.scatter.value < least_scatter) return mean;
    return "{ law = \"normal\", mean = " + mean + ", sd = \"" +
           number_of_degrees(set.scatter.value * degrees) + " deg\" }";
}

std::string set_text(const FittedSet& set) {
    std::string text = "\n[[joint_set]]\nname = \"" + set.name + "\"\n";
    text += "# " + std::to_string(set.pieces) + " traces " + word_of(set.pattern) + ", " +
            std::to_string(set.cut) + " ends cut off by the edge of the map; in 9 cases of 10:\n";
    for (const Row& row : rows_of(set))
        text += "#   " + row.name + " " + number(row.estimate.low) + " to " + number(row.estimate.high) +
                (row.unit == "1" ? "" : " " + row.unit) + "\n";
    if (set.pattern == SetPattern::anywhere) text += "kind = \"baecher\"\n";
    text += "angle = " + angle_text(set) + "\n";
    if (set.length)
        text += "trace_length = " + law_text(set.length_law, set.length->value, set.length_sd) + "\n";
    if (set.pattern == SetPattern::anywhere) return text + "p21 = " + number(set.p21.value) + "\n";
    text += "spacing = " + law_text(set.spacing_law, set.spacing.value, set.spacing_sd) + "\n";
    if (set.persistence)
        text += "persistence = " + number(std::clamp(set.persistence->value, 1e-3, 1.0)) + "\n";
    return text;
}

std::string ring_text(const Ring& ring) {
    std::string text = "[";
    for (const Point& p : ring)
        text += (text.size() > 1 ? ", [" : "[") + shortest_text(p.x) + ", " + shortest_text(p.y) + "]";
    return text + "]";
}

std::string rings_text(const std::vector<Ring>& rings) {
    std::string text = "[";
    for (const Ring& ring : rings) text += (text.size() > 1 ? ",\n    " : "") + ring_text(ring);
    return text + "]";
}

}  // namespace

std::string fitted_model_text(const MapFit& fit, const JointMap& map, const std::string& source) {
    const MapWindow& window = map.window;
    std::string text = "# Joint sets estimated from " + source +
                       " by blockgen fit. The domain is the mapped area: put the slope's here.\nseed = 1\n\n"
                       "[domain]\n";
    text += window.outer.size() == 1 ? "outline = " + ring_text(window.outer[0]) + "\n"
                                     : "outlines = " + rings_text(window.outer) + "\n";
    if (!window.holes.empty()) text += "holes = " + rings_text(window.holes) + "\n";
    text += "block_material = \"rock\"\n";
    for (const FittedSet& set : fit.sets) text += set_text(set);
    return text;
}

std::string fit_table(const MapFit& fit) {
    std::string text;
    char line[200];
    for (const FittedSet& set : fit.sets) {
        std::snprintf(line, sizeof line, "%s: %zu traces %s, %zu ends cut off\n", set.name.c_str(),
                      set.pieces, word_of(set.pattern), set.cut);
        text += line;
        if (set.length) text += std::string("  lengths are ") + word_of(set.length_law) + "\n";
        if (set.pattern != SetPattern::anywhere)
            text += std::string("  spacings are ") + word_of(set.spacing_law) + "\n";
        for (const Row& row : rows_of(set)) {
            std::snprintf(line, sizeof line, "  %-16s %10.4g  (%.4g to %.4g)%s%s\n", row.name.c_str(),
                          row.estimate.value, row.estimate.low, row.estimate.high, row.unit == "1" ? "" : " ",
                          row.unit == "1" ? "" : row.unit.c_str());
            text += line;
        }
    }
    return text;
}

std::string fit_json(const MapFit& fit) {
    using Json = nlohmann::ordered_json;
    Json sets = Json::array();
    for (const FittedSet& set : fit.sets) {
        Json estimates = Json::object();
        for (const Row& row : rows_of(set))
            estimates[row.name] = {{"value", row.estimate.value},
                                   {"low", row.estimate.low},
                                   {"high", row.estimate.high},
                                   {"unit", row.unit}};
        Json entry = {{"name", set.name},
                      {"pattern", word_of(set.pattern)},
                      {"traces", set.pieces},
                      {"ends_cut_off", set.cut}};
        if (set.length) entry["length_law"] = word_of(set.length_law);
        if (set.pattern != SetPattern::anywhere) entry["spacing_law"] = word_of(set.spacing_law);
        entry["estimates"] = std::move(estimates);
        sets.push_back(std::move(entry));
    }
    const Json root = {{"area_m2", fit.area}, {"sets", std::move(sets)}, {"notes", fit.notes}};
    return root.dump(2) + "\n";
}

}  // namespace rockslope::blockgen
