#include "dda/input/read_materials.hpp"

#include "common/base/magnitude.hpp"
#include "common/base/text.hpp"

namespace rockslope::dda {

namespace {

BlockMaterial read_block_material(const std::string& name, const ConfigTable& table) {
    BlockMaterial material;
    material.name = name;
    material.density = positive(table, "density", Dimension::mass_density);
    material.youngs_modulus = positive(table, "youngs_modulus", Dimension::stress);
    material.poissons_ratio = table.checked(
        "poissons_ratio", table.number("poissons_ratio"), [](double v) { return v >= 0 && v < 0.5; },
        "a number in [0, 0.5)");
    material.damping_ratio = not_negative(table, "damping_ratio", Dimension::none, material.damping_ratio);
    if (table.has("initial_stress")) {
        const std::vector<double> stress = table.numbers("initial_stress", Dimension::stress);
        if (stress.size() != 3)
            table.fail("initial_stress",
                       "'initial_stress' in [" + table.path() + "] has " + std::to_string(stress.size()) +
                           " entries",
                       "three stresses, [sx, sy, txy], tension positive");
        material.initial_stress = {stress[0], stress[1], stress[2]};
    }
    return material;
}

}  // namespace

double positive(const ConfigTable& table, std::string_view key, Dimension dimension) {
    const double value = table.number(key, dimension);
    return table.checked(
        key, value, [](double v) { return v >= smallest_positive; },
        value > 0 ? "a number above " + shortest_text(smallest_positive) : "a positive number");
}

double positive(const ConfigTable& table, std::string_view key, Dimension dimension, double fallback) {
    return table.has(key) ? positive(table, key, dimension) : table.number(key, dimension, fallback);
}

double not_negative(const ConfigTable& table, std::string_view key, Dimension dimension, double fallback) {
    const double value = table.number(key, dimension, fallback);
    return table.has(key) ? table.checked(
                                key, value, [](double v) { return v >= 0; }, "zero or a positive number")
                          : value;
}

std::vector<BlockMaterial> read_block_materials(const ConfigTable& run) {
    std::vector<BlockMaterial> materials;
    if (run.has("block_material"))
        for (const auto& [name, table] : run.table("block_material").named_tables())
            materials.push_back(read_block_material(name, table));
    if (materials.empty())
        throw InputError(run.place(), "there is no block material", "a table [block_material.NAME]");
    return materials;
}

std::vector<BoltMaterial> read_bolt_materials(const ConfigTable& run) {
    std::vector<BoltMaterial> materials;
    if (!run.has("bolt_material")) return materials;
    for (const auto& [name, table] : run.table("bolt_material").named_tables())
        materials.push_back({name, positive(table, "axial_stiffness", Dimension::force),
                             not_negative(table, "pretension", Dimension::force, 0),
                             not_negative(table, "yield_force", Dimension::force, 0)});
    return materials;
}

}  // namespace rockslope::dda
