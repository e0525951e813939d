#include <set>

#include "blockgen/input/read_shapes.hpp"

namespace rockslope::blockgen {

namespace {

BlockSelector read_selector(const ConfigTable& table, bool prescribed) {
    BlockSelector selector;
    selector.place = table.place();
    selector.prescribed = prescribed;
    selector.name = prescribed ? read_name(table, "name") : table.string("name", "");
    const int given =
        int{table.has("at")} + int{table.has("inside")} + int{table.has("along")} + int{table.has("side")};
    if (given != 1)
        table.fail("at", std::to_string(given) + " selections of the block are given",
                   "exactly one of at, inside, along and side");
    if (table.has("along")) {
        for (const auto& pair : table.pairs("along", Dimension::length))
            selector.along.push_back(point_of(pair));
        if (selector.along.size() != 2 || selector.along[0] == selector.along[1])
            table.fail("along", "a line needs two different points", "[[x1, y1], [x2, y2]]");
    }
    if (table.has("at")) selector.at = point_of(table.pair("at", Dimension::length));
    if (table.has("inside")) selector.inside = read_ring(table, "inside");
    if (table.has("side")) selector.side = table.choice("side", {"bottom", "top", "left", "right"});
    return selector;
}

double read_friction_angle(const ConfigTable& table, const std::string& key) {
    return table.checked(
        key, table.number(key, Dimension::angle), [](double a) { return a >= 0 && a < 1.55; },
        "a friction angle from 0 to 88 deg");
}

/// The joint materials that may occur between two blocks.
std::set<std::string> joint_materials_of(const SlopeModel& model) {
    std::set<std::string> names;
    for (const JointSet& set : model.joint_sets) names.insert(set.joint_material);
    for (const Trace& trace : model.traces) names.insert(trace.joint_material);
    for (const Region& region : model.regions) names.insert(region.joint_material);
    for (const Excavation& excavation : model.excavations) names.insert(excavation.joint_material);
    names.erase("");
    return names;
}

KinematicScreen read_kinematics(const ConfigTable& table, const SlopeModel& model) {
    KinematicScreen screen;
    screen.friction_angle = read_friction_angle(table, "friction_angle");
    if (const auto materials = table.optional_table("friction_angles"))
        for (const std::string& name : joint_materials_of(model))
            if (materials->has(name))
                screen.friction_of_material[name] = read_friction_angle(*materials, name);
    if (table.has("fixed_sides")) screen.fixed_sides = table.strings("fixed_sides");
    for (const std::string& side : screen.fixed_sides)
        if (side != "bottom" && side != "top" && side != "left" && side != "right")
            table.fail("fixed_sides", "there is no side '" + side + "'", "bottom, top, left or right");
    return screen;
}

Scanline read_scanline(const ConfigTable& table) {
    Scanline line{read_name(table, "name"), point_of(table.pair("from", Dimension::length)),
                  point_of(table.pair("to", Dimension::length))};
    if (line.from == line.to)
        table.fail("to", "both ends of the scanline are the same point", "a point other than 'from'");
    line.sound_length = table.checked(
        "sound_length", table.number("sound_length", Dimension::length, line.sound_length),
        [](double length) { return length > 0; }, "a length above zero");
    return line;
}

}  // namespace

void read_block_assignments(const ConfigTable& root, SlopeModel& model) {
    for (const ConfigTable& table : root.array_of_tables("fixed_block"))
        model.selectors.push_back(read_selector(table, false));
    for (const ConfigTable& table : root.array_of_tables("prescribed_block"))
        model.selectors.push_back(read_selector(table, true));
    if (const auto table = root.optional_table("kinematics"))
        model.kinematics = read_kinematics(*table, model);
    for (const ConfigTable& table : root.array_of_tables("measured_point")) {
        model.measured_points.push_back(
            {read_name(table, "name"), point_of(table.pair("at", Dimension::length)), table.place("at")});
        for (std::size_t k = 0; k + 1 < model.measured_points.size(); ++k)
            if (model.measured_points[k].name == model.measured_points.back().name)
                table.fail("name", "a second measured point '" + model.measured_points[k].name + "'",
                           "a name for each measured point");
    }
    for (const ConfigTable& table : root.array_of_tables("scanline"))
        model.scanlines.push_back(read_scanline(table));
    for (const ConfigTable& table : root.array_of_tables("bolt")) {
        model.bolts.push_back({table.string("name", "bolt " + std::to_string(model.bolts.size() + 1)),
                               read_name(table, "material"), point_of(table.pair("from", Dimension::length)),
                               point_of(table.pair("to", Dimension::length)), table.place()});
        if (model.bolts.back().from == model.bolts.back().to)
            table.fail("to", "both ends of the bolt are the same point", "a point other than 'from'");
    }
}

}  // namespace rockslope::blockgen
