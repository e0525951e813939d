#include <array>
#include <type_traits>
#include <utility>

#include "dda/input/config_parameters.hpp"
#include "dda/input/read_materials.hpp"

namespace rockslope::dda {

namespace {

/// Reads the stiffness of the joint, which replaces the penalties. @throws InputError if both are given.
void read_stiffness(const ConfigTable& table, JointMaterial& material) {
    for (const char* penalty : {"normal_penalty", "shear_penalty"}) {
        if (table.has(penalty))
            table.fail(penalty,
                       "'" + std::string(penalty) + "' and 'normal_stiffness' are both given in [" +
                           table.path() + "]",
                       "one of them");
    }
    material.normal_stiffness = positive(table, "normal_stiffness", Dimension::joint_stiffness);
    material.shear_stiffness =
        positive(table, "shear_stiffness", Dimension::joint_stiffness, material.normal_stiffness);
    material.corner_length = positive(table, "corner_length", Dimension::length, material.corner_length);
    if (table.has("largest_closure"))
        material.largest_closure = positive(table, "largest_closure", Dimension::length);
}

struct LawReader {
    const char* name;
    JointLaw (*read)(const ConfigTable& table);
};

template <class Law>
JointLaw read_as(const ConfigTable& table) {
    return Law::read(ConfigParameters(table));
}

template <class... Laws>
constexpr std::array<LawReader, sizeof...(Laws)> readers_of(std::type_identity<std::variant<Laws...>>) {
    return {LawReader{Laws::name, read_as<Laws>}...};
}

constexpr auto law_readers = readers_of(std::type_identity<JointLaw>{});

JointMaterial read_joint_material(const std::string& name, const ConfigTable& table) {
    std::vector<std::string> names;
    for (const LawReader& reader : law_readers) names.emplace_back(reader.name);
    const std::string law = table.choice("law", names);
    JointMaterial material;
    material.name = name;
    for (const LawReader& reader : law_readers)
        if (law == reader.name) material.law = reader.read(table);
    material.contact_damping = not_negative(table, "contact_damping", Dimension::none, 0);
    if (table.has("normal_stiffness")) {
        read_stiffness(table, material);
        return material;
    }
    if (table.has("shear_stiffness"))
        table.fail("shear_stiffness",
                   "'shear_stiffness' in [" + table.path() + "] has no 'normal_stiffness' beside it", "both");
    material.normal_penalty = not_negative(table, "normal_penalty", Dimension::stiffness, 0);
    material.shear_penalty = not_negative(table, "shear_penalty", Dimension::stiffness, 0);
    return material;
}

}  // namespace

std::vector<JointMaterial> read_joint_materials(const ConfigTable& run) {
    std::vector<JointMaterial> materials;
    if (run.has("joint_material"))
        for (const auto& [name, table] : run.table("joint_material").named_tables())
            materials.push_back(read_joint_material(name, table));
    if (materials.empty())
        throw InputError(run.place(), "there is no joint material", "a table [joint_material.NAME]");
    return materials;
}

}  // namespace rockslope::dda
