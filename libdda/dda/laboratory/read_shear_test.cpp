#include "dda/laboratory/read_shear_test.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "dda/input/read_materials.hpp"
#include "dda/laboratory/shear_table.hpp"

namespace rockslope::dda {

namespace {

constexpr double max_rows = 1e7;

const JointMaterial& read_joint_material(const ConfigTable& table,
                                         const std::vector<JointMaterial>& materials) {
    std::vector<std::string> names;
    for (const JointMaterial& material : materials) names.push_back(material.name);
    const std::string name = table.choice("joint_material", names, names.front());
    return materials[std::find(names.begin(), names.end(), name) - names.begin()];
}

/// The path of a test, with the table that it was read from, if any.
struct Path {
    std::vector<double> displacement;  ///< m
    std::optional<ShearTable> table;
};

Path read_path(const ConfigTable& table, std::vector<std::filesystem::path>& files) {
    Path path;
    if (table.is_table("path")) {
        const ConfigTable source = table.table("path");
        files.push_back(source.file_path("file"));
        path.table = read_shear_table(files.back());
        path.displacement = path.table->displacement;
    } else {
        path.displacement = table.numbers("path", Dimension::length);
    }
    if (std::all_of(path.displacement.begin(), path.displacement.end(), [](double d) { return d == 0; }))
        table.fail("path", "'path' in [" + table.path() + "] has no displacement other than 0",
                   "displacements to be reached in turn, such as [\"15 mm\", 0, \"-15 mm\"]");
    return path;
}

/// The normal stress at each point of the path, from `path_stress` or from the table of the path.
std::vector<double> read_path_stress(const ConfigTable& table, const Path& path) {
    const char* key = "path_stress";
    std::vector<double> stress;
    if (table.has(key))
        stress = table.numbers(key, Dimension::stress);
    else if (path.table)
        stress = path.table->normal_stress;
    if (stress.empty())
        table.fail(key,
                   "'boundary' in [" + table.path() + "] is \"prescribed-stress\", but no stress is given",
                   path.table ? "a column 'normal stress' in the file of 'path', or 'path_stress'"
                              : "'path_stress', such as [\"1 MPa\", \"0.5 MPa\"]");
    if (stress.size() != path.displacement.size())
        table.fail(key,
                   "'" + std::string(key) + "' in [" + table.path() + "] has " +
                       std::to_string(stress.size()) + " stresses for " +
                       std::to_string(path.displacement.size()) + " points of 'path'",
                   "one for each point");
    if (std::any_of(stress.begin(), stress.end(), [](double s) { return s < 0; }))
        table.fail(key, "a normal stress along the path in [" + table.path() + "] is negative",
                   "zero, for an open joint, or a positive number");
    return stress;
}

double largest_displacement(const std::vector<double>& path) {
    double distance = 0;
    for (const double displacement : path) distance = std::max(distance, std::abs(displacement));
    return distance;
}

double length_of(const std::vector<double>& path) {
    double length = 0, from = 0;
    for (const double to : path) {
        length += std::abs(to - from);
        from = to;
    }
    return length;
}

void read_boundary(const ConfigTable& table, const Path& path, ShearTest& test) {
    const std::string boundary = table.choice(
        "boundary", {"constant-stress", "constant-stiffness", "constant-volume", "prescribed-stress"},
        "constant-stress");
    if (boundary == "prescribed-stress") {
        test.boundary = NormalBoundary::prescribed_stress;
        test.path_stress = read_path_stress(table, path);
    } else if (boundary == "constant-stiffness") {
        test.boundary = NormalBoundary::constant_stiffness;
        test.boundary_stiffness = positive(table, "boundary_stiffness", Dimension::joint_stiffness);
    } else if (boundary == "constant-volume") {
        test.boundary = NormalBoundary::constant_volume;
        if (test.material.normal_stiffness == 0)
            table.fail("boundary",
                       "'boundary' in [" + table.path() + "] is \"constant-volume\", but the joint " +
                           "cannot be compressed",
                       "'normal_stiffness' in [joint_material." + test.material.name + "]");
    }
}

}  // namespace

ShearTestInput read_shear_test(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
    const ConfigTable config = ConfigTable::from_file(file, overrides);
    const std::vector<JointMaterial> materials = read_joint_materials(config);
    const ConfigTable table = config.table("shear_test");
    ShearTestInput input;
    input.files.push_back(file);
    ShearTest& test = input.test;
    test.material = read_joint_material(table, materials);
    input.material = test.material.name;
    test.length = positive(table, "length", Dimension::length);
    test.normal_stress = positive(table, "normal_stress", Dimension::stress);
    const Path path = read_path(table, input.files);
    test.path = path.displacement;
    read_boundary(table, path, test);
    test.increment = positive(table, "increment", Dimension::length, largest_displacement(test.path) / 500);
    if (length_of(test.path) / test.increment > max_rows)
        table.fail("increment", "'increment' in [" + table.path() + "] gives more than 1e7 rows",
                   "a larger increment");
    const std::string key = "shear_stiffness";
    if (table.has(key)) test.material.shear_stiffness = positive(table, key, Dimension::joint_stiffness);
    if (!(shear_stiffness(test) > 0))
        table.fail(key,
                   "neither the law of '" + input.material + "' nor the material gives a shear stiffness",
                   "'shear_stiffness' in [" + table.path() + "], such as \"10 GPa/m\"");
    config.finish();
    return input;
}

std::string shear_test_template() {
    return R"(# A direct shear test of joint-shear: one joint, no blocks. SI units; a number may carry a unit in quotes.
# Keys that are commented out show their default.

[joint_material.granite]           # as in a run of dda-run
law = "cyclic-barton-bandis"
residual_friction_angle = "34.6 deg"
jrc = 12.8
jcs = "151 MPa"
peak_displacement = "1.25 mm"
damage = 1
# normal_stiffness = "50 GPa/m"    # of the joint; required for "constant-volume"
# largest_closure = "0.2 mm"       # the joint closes along a hyperbola; normal_stiffness is its initial slope

[[joint_material.granite.cycle]]
forward_advance = [[0, 0], [1, 1], [2, 0.5], [4, 0.3], [8, 0.15]]
forward_return = [[0, -0.4], [1, -0.38], [2, -0.3]]
backward_advance = [[1, 0.5], [2, 0.45], [4, 0.4], [8, 0.2], [20, 0.15]]
backward_return = [[1, -0.4], [2, -0.4], [4, -0.3]]

[shear_test]
# joint_material = "granite"       # default: the first in this file
length = 0.1                       # m, of the joint
normal_stress = "1 MPa"            # at the start
# boundary = "constant-stress"     # or "constant-stiffness", "constant-volume", "prescribed-stress"
# boundary_stiffness = "5 GPa/m"   # for constant-stiffness
path = ["15 mm", 0, "-15 mm", 0]   # displacements to be reached in turn; or { file = "lab.csv" }
# path_stress = ["1 MPa", 0, "2 MPa", 0]   # for prescribed-stress: normal stress at each point of the path;
#                                  default: the column 'normal stress' of the path's file
increment = "0.025 mm"             # largest between two rows; default: the largest displacement over 500
# shear_stiffness = "10 GPa/m"     # required if neither law nor material has one
)";
}

}  // namespace rockslope::dda
