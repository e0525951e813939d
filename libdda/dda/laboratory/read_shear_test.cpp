#include "dda/laboratory/read_shear_test.hpp"

#include <algorithm>
#include <cmath>

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

std::vector<double> read_path(const ConfigTable& table, std::vector<std::filesystem::path>& files) {
    std::vector<double> path;
    if (table.is_table("path")) {
        const ConfigTable source = table.table("path");
        files.push_back(source.file_path("file"));
        path = read_shear_table(files.back()).displacement;
    } else {
        path = table.numbers("path", Dimension::length);
    }
    if (std::all_of(path.begin(), path.end(), [](double d) { return d == 0; }))
        table.fail("path", "'path' in [" + table.path() + "] has no displacement other than 0",
                   "displacements to be reached in turn, such as [\"15 mm\", 0, \"-15 mm\"]");
    return path;
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

void read_boundary(const ConfigTable& table, ShearTest& test) {
    const std::string boundary = table.choice(
        "boundary", {"constant-stress", "constant-stiffness", "constant-volume"}, "constant-stress");
    if (boundary == "constant-stiffness") {
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
    read_boundary(table, test);
    test.path = read_path(table, input.files);
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
# boundary = "constant-stress"     # or "constant-stiffness", "constant-volume"
# boundary_stiffness = "5 GPa/m"   # for constant-stiffness
path = ["15 mm", 0, "-15 mm", 0]   # displacements to be reached in turn; or { file = "lab.csv" }
increment = "0.025 mm"             # largest between two rows; default: the largest displacement over 500
# shear_stiffness = "10 GPa/m"     # required if neither law nor material has one
)";
}

}  // namespace rockslope::dda
