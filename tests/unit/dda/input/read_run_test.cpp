#include "dda/input/read_run.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <numbers>

#include "common/base/read_file.hpp"
#include "dda/input/base_acceleration.hpp"
#include "unit/dda/input/model_text.hpp"

namespace rockslope::dda::read_run_test {
namespace {

using io_test::error_of;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr double degree = std::numbers::pi / 180;

const char* const full_model = R"(blocks = "two.blocks"
[block_material.rock]
density = "2.6 t/m3"
youngs_modulus = "5 GPa"
poissons_ratio = 0.25
initial_stress = ["-1 MPa", 0, 0]
[joint_material.smooth]
law = "mohr-coulomb"
friction_angle = 0
[joint_material.bedding]
law = "mohr-coulomb"
friction_angle = "35 deg"
cohesion = "0.1 MPa"
residual_friction_angle = "30 deg"
shear_penalty = "20 GPa"
[analysis]
plane = "stress"
gravity = [0, "-1 g"]
default_joint_material = "bedding"
[[point_load]]
measured_point = "crest"
force = ["1 kN", 0]
history = { times = [0, 1], values = [0, 2] }
[[point_load]]
at = [2, 1.5]
force = [0, -1]
[[body_load]]
at = [2, 1.5]
acceleration = ["0.1 g", 0]
[[fixed_point]]
at = [0.5, 0.5]
direction = "x"
[[initial_velocity]]
block = 1
velocity = [1, 0]
angular_velocity = 0.5
[[stage]]
name = "settle"
kind = "static"
tolerance = 1e-7
[[stage]]
kind = "dynamic"
duration = "2 s"
step = "5 ms"
iteration_limit = 20
[stage.base_motion]
block = "base"
x = { file = "r.csv", scale = 2.0, baseline = "drift" }
y = { times = [0, 1], values = [0, "0.1 g"] }
[output]
frames = 10
)";

namespace fs = std::filesystem;

class ReadRun : public io_test::ModelTextTest {
  protected:
    ReadRun() : ModelTextTest(full_model) {
        folder.write("r.csv", "time (s),acceleration (m/s2)\n0,0\n0.01,1\n0.02,-3\n0.03,1\n0.04,0\n");
    }
};

void expect_same_model(const RunInput& a, const RunInput& b) {
    EXPECT_EQ(a.model.vertices, b.model.vertices);
    EXPECT_EQ(a.model.topology.joint_material, b.model.topology.joint_material);
    EXPECT_EQ(a.model.normal_penalty, b.model.normal_penalty);
    EXPECT_EQ(a.model.shear_penalty, b.model.shear_penalty);
    EXPECT_EQ(a.model.fixed_point_penalty, b.model.fixed_point_penalty);
    EXPECT_EQ(a.model.default_joint_material, b.model.default_joint_material);
    EXPECT_EQ(a.model.gravity, b.model.gravity);
    EXPECT_EQ(a.model.loads.size(), b.model.loads.size());
    EXPECT_EQ(a.model.initial_velocity, b.model.initial_velocity);
    ASSERT_EQ(a.model.joint_materials.size(), b.model.joint_materials.size());
    for (std::size_t i = 0; i < a.model.joint_materials.size(); ++i) {
        const auto& x = std::get<MohrCoulomb>(a.model.joint_materials[i].law);
        const auto& y = std::get<MohrCoulomb>(b.model.joint_materials[i].law);
        EXPECT_EQ(x.friction_angle, y.friction_angle);
        EXPECT_EQ(x.residual_friction_angle, y.residual_friction_angle);
        EXPECT_EQ(x.cohesion, y.cohesion);
        EXPECT_EQ(a.model.joint_materials[i].shear_penalty, b.model.joint_materials[i].shear_penalty);
    }
    ASSERT_EQ(a.stages.size(), b.stages.size());
    for (std::size_t i = 0; i < a.stages.size(); ++i) {
        EXPECT_EQ(a.stages[i].name, b.stages[i].name);
        EXPECT_EQ(a.stages[i].duration, b.stages[i].duration);
        EXPECT_EQ(a.stages[i].control.cut, b.stages[i].control.cut);
        EXPECT_EQ(a.stages[i].control.step, b.stages[i].control.step);
        ASSERT_EQ(a.stages[i].base_motions.size(), b.stages[i].base_motions.size());
        for (std::size_t k = 0; k < a.stages[i].base_motions.size(); ++k) {
            EXPECT_EQ(a.stages[i].base_motions[k].x.values(), b.stages[i].base_motions[k].x.values());
            EXPECT_EQ(a.stages[i].base_motions[k].y.values(), b.stages[i].base_motions[k].y.values());
        }
    }
    EXPECT_EQ(a.output.name, b.output.name);
    EXPECT_EQ(a.output.frames, b.output.frames);
}

TEST_F(ReadRun, ReadsEveryKey) {
    const RunInput input = read(full_model);
    const Model& model = input.model;
    EXPECT_EQ(model.block_count(), 2);
    EXPECT_EQ(model.vertices.size(), 10u) << "every block owns its corners";
    EXPECT_EQ(model.block_materials[0].density, 2600);
    EXPECT_EQ(model.block_materials[0].initial_stress[0], -1e6);
    EXPECT_EQ(model.motion[0], Motion::prescribed);
    EXPECT_EQ(model.block_name[0], "base");
    EXPECT_EQ(model.topology.joint_material[3], 1) << "'bedding' is the second material of the model file";
    EXPECT_EQ(model.topology.joint_material[0], -1);
    EXPECT_EQ(model.topology.joint[3], 0);
    EXPECT_EQ(model.plane, Plane::stress);
    EXPECT_DOUBLE_EQ(model.gravity.y(), -9.80665);
    EXPECT_EQ(model.normal_penalty, 5e10) << "10 E";
    EXPECT_EQ(model.shear_penalty, 5e10);
    EXPECT_EQ(model.default_joint_material, 1);
    const auto& law = std::get<MohrCoulomb>(model.joint_materials[1].law);
    EXPECT_DOUBLE_EQ(law.friction_angle, 35 * degree);
    EXPECT_DOUBLE_EQ(law.residual_friction_angle, 30 * degree);
    EXPECT_DOUBLE_EQ(law.cohesion, 1e5);
    EXPECT_EQ(model.joint_materials[1].shear_penalty, 2e10);
    EXPECT_EQ(std::get<MohrCoulomb>(model.joint_materials[0].law).residual_friction_angle, 0);

    ASSERT_EQ(model.loads.size(), 3u);
    const auto& first = std::get<PointLoad>(model.loads[0]);
    EXPECT_EQ(first.point, model.measured_points[0].point);
    EXPECT_EQ(first.force, Vec2(1000, 0));
    EXPECT_EQ(first.history.at(0.5), 1);
    EXPECT_EQ(model.material_points[std::get<PointLoad>(model.loads[1]).point].block, 1);
    EXPECT_EQ(std::get<BodyLoad>(model.loads[2]).block, 1);
    EXPECT_TRUE(model.fixed_points[0].hold_x);
    EXPECT_FALSE(model.fixed_points[0].hold_y);
    EXPECT_EQ(model.initial_velocity[1][0], 1);
    EXPECT_EQ(model.initial_velocity[1][2], 0.5);

    ASSERT_EQ(input.stages.size(), 2u);
    EXPECT_EQ(input.stages[0].kind, StageKind::static_equilibrium);
    EXPECT_EQ(input.stages[0].tolerance, 1e-7);
    EXPECT_EQ(input.stages[1].name, "stage 2");
    EXPECT_EQ(input.stages[1].control.step, 0.005);
    EXPECT_EQ(input.stages[1].control.iteration_limit, 20);
    const BaseMotion& base = input.stages[1].base_motions.at(0);
    EXPECT_NEAR(base.x.at(0.02), -6, 2.1) << "twice the sample, less the drift line";
    EXPECT_DOUBLE_EQ(base.y.at(1), 0.980665);
    EXPECT_EQ(input.output.frames, 10);
    EXPECT_EQ(input.output.name, "run");
    EXPECT_EQ(input.files.size(), 3u);
}

TEST_F(ReadRun, TheEffectiveModelReadsBackToTheSameRun) {
    fs::create_directories(folder / "out");
    RunReadOptions options;
    options.echo_folder = folder / "out";
    const RunInput first = read(full_model, options);
    folder.write("out/run.toml", first.effective);
    const RunInput second = read_run(folder / "out/run.toml", options);
    expect_same_model(first, second);
    EXPECT_EQ(read_text_file(folder / "out/run.toml"), first.effective);
    EXPECT_THAT(first.effective, HasSubstr("blocks = \"../two.blocks\""));
    EXPECT_THAT(first.effective, HasSubstr("growth = 1.3  # default"));
}

TEST_F(ReadRun, AppliesOverridesAndBlockFileOfTheCommandLine) {
    fs::rename(folder / "two.blocks", folder / "other.blocks");
    RunReadOptions options;
    options.blocks = folder / "other.blocks";
    options.overrides = {"stage[1].base_motion.x.scale=0", "joint_material.bedding.friction_angle=20 deg"};
    const RunInput input = read(full_model, options);
    EXPECT_EQ(input.stages[1].base_motions[0].x.at(0.02), 0);
    EXPECT_DOUBLE_EQ(std::get<MohrCoulomb>(input.model.joint_materials[1].law).friction_angle, 20 * degree);
}

TEST_F(ReadRun, ChoosesTheSolver) {
    EXPECT_EQ(read(full_model).model.solver, SolverKind::multifrontal);
    for (const auto& [name, kind] :
         {std::pair{"simplicial", SolverKind::simplicial}, std::pair{"refined", SolverKind::refined},
          std::pair{"multifrontal", SolverKind::multifrontal}}) {
        RunReadOptions options;
        options.overrides = {std::string("analysis.solver=") + name};
        EXPECT_EQ(read(full_model, options).model.solver, kind) << name;
    }
    EXPECT_THAT(error_with("plane = \"stress\"", "solver = \"mumps\""),
                StartsWith("run.toml:17:10: 'solver' in [analysis] is \"mumps\"; expected one of"));
    EXPECT_THAT(error_with("plane = \"stress\"", "solver = \"simplical\""), HasSubstr("simplicial"));
    EXPECT_THAT(error_with("plane = \"stress\"", "solver = 2"), StartsWith("run.toml:17:10: 'solver'"));
}

TEST_F(ReadRun, BadInputIsOneLineWithItsPlace) {
    EXPECT_EQ(error_with("cohesion =", "cohesoin ="),
              "run.toml:13:12: unknown key 'cohesoin' in [joint_material.bedding]; did you mean 'cohesion'?");
    EXPECT_EQ(error_with("\"5 GPa\"", "-5"),
              "run.toml:4:18: 'youngs_modulus' in [block_material.rock] is -5; expected a positive number");
    EXPECT_EQ(
        error_with("0.25", "0.5"),
        "run.toml:5:18: 'poissons_ratio' in [block_material.rock] is 0.5; expected a number in [0, 0.5)");
    EXPECT_EQ(error_with("[joint_material.bedding]", "[joint_material.beding]").substr(0, 30),
              "run.toml:19:26: 'default_joint");
    EXPECT_EQ(error_with("[block_material.rock]", "[block_material.rok]"),
              "two.blocks: needs the block_material 'rock', which the model file does not have (it has "
              "'rok'); expected a table [block_material.rock]");
    EXPECT_THAT(error_with("law = \"mohr-coulomb\"", "law = \"mohr-colomb\""),
                StartsWith("run.toml:8:7: 'law' in [joint_material.smooth] is \"mohr-colomb\"; did you mean "
                           "\"mohr-coulomb\"?"));
    EXPECT_EQ(error_with("at = [2, 1.5]", "at = [2, 5]"),
              "run.toml:25:6: 'at' in [point_load[1]] is [2, 5], where there is no block; expected a point "
              "inside a block");
    EXPECT_EQ(
        error_with("\"crest\"", "\"crst\""),
        "run.toml:21:18: there is no measured point 'crst' in the block file; expected perhaps 'crest'");
    EXPECT_EQ(error_with("block = \"base\"", "block = \"bass\""),
              "run.toml:47:9: there is no prescribed block 'bass' in the block file; expected one of base");
    EXPECT_EQ(error_with("block = 1", "block = 2"),
              "run.toml:34:9: 'block' in [initial_velocity[0]] is 2; expected an index from 0 to 1");
    EXPECT_EQ(error_with("block = 1", "block = 0"),
              "run.toml:35:12: 'velocity' in [initial_velocity[0]] is of block 0, whose motion is fixed or "
              "prescribed; expected a block that is free to move");
    EXPECT_THAT(error_with("tolerance = 1e-7", "duration = 3"),
                StartsWith("run.toml:40:12: unknown key 'duration' in [stage[0]]; expected one of"));
    EXPECT_THAT(error_with("\"r.csv\"", "\"none.csv\""),
                StartsWith("none.csv: cannot be read: No such file"));
    EXPECT_THAT(error_with("two.blocks", "no.blocks"), StartsWith("no.blocks: cannot be read: No such file"));
    EXPECT_THAT(error_with("kind = \"dynamic\"\nduration = \"2 s\"", "kind = \"dynamic\""),
                HasSubstr("there is no key 'duration' in [stage[1]]"));
    EXPECT_THAT(error_with("frames = 10", "frames = nan"), HasSubstr("expected a whole number"));
    EXPECT_THAT(error_with("frames = 10", "static_frame_interval = -1"),
                HasSubstr("'static_frame_interval' in [output] is -1; expected a whole number from 0"));
    EXPECT_THAT(error_with("frames = 10", "static_frame_interval = 2.5"), HasSubstr("static_frame_interval"));
    EXPECT_THAT(error_with("scale = 2.0", "scale = inf"), HasSubstr("not a finite number"));
    EXPECT_THAT(error_with("times = [0, 1], values = [0, 2]", "times = [0, 0], values = [0, 2]"),
                HasSubstr("strictly increasing times"));
    for (const std::string& name :
         std::vector<std::string>{"a/b", "..", ".hidden", "a\\nb", "a\\u0000b", std::string(201, 'x')})
        EXPECT_THAT(error_with("frames = 10", "name = \"" + name + "\""), HasSubstr("without '/'")) << name;
    EXPECT_THAT(error_with("frames = 10", "history_interval = 1e-300"), HasSubstr("1e-9 s or more"));
}

TEST_F(ReadRun, ABaseMotionMayBeDelayedOrABodyForce) {
    const RunInput late = read(changed("block = \"base\"", "block = \"base\"\ndelay = \"30 ms\""));
    const BaseMotion& motion = late.stages[1].base_motions.at(0);
    EXPECT_DOUBLE_EQ(motion.y.times()[0], 0.03);
    EXPECT_DOUBLE_EQ(motion.y.times()[1], 1.03);
    EXPECT_DOUBLE_EQ(motion.x.times()[0], 0.03);
    const FinalBaseState end = integrate_base_motion(motion.x, 0.005);
    EXPECT_NEAR(end.velocity, 0, 1e-12) << "a delayed record is drift-corrected too";
    EXPECT_NEAR(end.displacement, 0, 1e-12);

    const RunInput body_force = read(changed("block = \"base\"", "way = \"body-force\""));
    EXPECT_TRUE(body_force.stages[1].base_motions.empty());
    ASSERT_EQ(body_force.stages[1].frame_motions.size(), 1u);
    EXPECT_DOUBLE_EQ(body_force.stages[1].frame_motions[0].y.at(1), 0.1 * 9.80665);
    EXPECT_THAT(error_with("block = \"base\"", "block = \"base\"\nway = \"body-force\""),
                HasSubstr("unknown key 'block'"));
    EXPECT_THAT(error_with("block = \"base\"", "way = \"felt\""), HasSubstr("'way'"));
    EXPECT_THAT(error_with("block = \"base\"", "delay = -1"), HasSubstr("'delay'"));
}

TEST_F(ReadRun, RelativeMotionsReferToTheBaseByDefault) {
    EXPECT_EQ(read(full_model).output.relative_to, "base");
    EXPECT_EQ(read(changed("frames = 10", "relative_to = \"crest\"")).output.relative_to, "crest");
    EXPECT_EQ(read(changed("frames = 10", "relative_to = \"\"")).output.relative_to, "");
    EXPECT_THAT(error_with("frames = 10", "relative_to = \"crust\""), HasSubstr("perhaps 'crest'"));
    EXPECT_EQ(read(changed("frames = 10", "slip_threshold = \"2 mm\"")).output.slip_threshold, 2e-3);
    for (const char* bad : {"0", "-1", "nan", "\"3 s\""})
        EXPECT_THAT(error_with("frames = 10", std::string("slip_threshold = ") + bad),
                    HasSubstr("slip_threshold"));
}

TEST_F(ReadRun, AStageMayStopAtADisplacement) {
    const std::string region = R"([[measured_region]]
name = "upper"
polygon = [[0, 1], [4, 1], [4, 2], [0, 2]]
block_material = "rock"
)";
    const std::string stages = R"([[stage]]
kind = "dynamic"
duration = 1
[stage.stop]
displacement = "20 cm"
)";
    const auto stop_of = [&](const std::string& more) {
        return *read(std::string(full_model) + region + stages + more).stages.back().stop;
    };
    const StopLimit any = stop_of("share = 0.1\n");
    EXPECT_DOUBLE_EQ(any.displacement, 0.2);
    EXPECT_EQ(any.share, 0.1);
    EXPECT_EQ(any.reference_block, 0) << "the prescribed base";
    EXPECT_FALSE(any.point.exists());
    EXPECT_EQ(stop_of("region = \"upper\"\n").blocks, (std::vector<BlockIndex>{1}));
    const StopLimit point = stop_of("point = \"crest\"\nrelative_to = \"\"\n");
    EXPECT_TRUE(point.point.exists());
    EXPECT_FALSE(point.reference_block.exists());
    const auto refused = [&](const std::string& more) { return error_of([&] { stop_of(more); }); };
    EXPECT_THAT(refused("point = \"crst\"\n"),
                HasSubstr("no measured point 'crst'; expected perhaps 'crest'"));
    EXPECT_THAT(refused("region = \"uper\"\n"),
                HasSubstr("no measured region 'uper'; expected perhaps 'upper'"));
    EXPECT_THAT(refused("region = \"upper\"\npoint = \"crest\"\n"), HasSubstr("has 'point' and 'region'"));
    EXPECT_THAT(refused("share = 1\n"), HasSubstr("expected a share from 0 to below 1"));
    EXPECT_THAT(error_of([&] {
                    read(std::string(full_model) +
                         "[[measured_region]]\nname = \"far\"\npolygon = [[9, 9], [10, 9], [9, 10]]\n");
                }),
                HasSubstr("'far' has no block that is free to move"));
}

TEST_F(ReadRun, ARecordIsReadAsItsKeysDeclare) {
    EXPECT_EQ(error_with("scale = 2.0", "format = \"csv\", channel = 1"), "no error");
    EXPECT_THAT(error_with("scale = 2.0", "format = \"knet\""), StartsWith("r.csv:1: the header has no"));
    EXPECT_THAT(error_with("scale = 2.0", "format = \"k-net\""), HasSubstr("did you mean \"knet\"?"));
    EXPECT_THAT(error_with("scale = 2.0", "channel = 0"), HasSubstr("expected a whole number from 1"));
    EXPECT_THAT(error_with("scale = 2.0", "channel = 2"), StartsWith("r.csv: there is no channel 2"));
}

TEST_F(ReadRun, NumbersOutsideTheAllowedRangeAreRefused) {
    EXPECT_EQ(error_with("\"5 GPa\"", "1e31"),
              "run.toml:4:18: 'youngs_modulus' in [block_material.rock] is 1e+31, which is too large; "
              "expected a stress "
              "such as \"2.5 GPa\" (Pa, kPa, MPa, GPa)");
    EXPECT_THAT(error_with("\"5 GPa\"", "\"1e30 GPa\""), HasSubstr("which is too large"));
    EXPECT_THAT(error_with("\"5 GPa\"", "1e-300"), HasSubstr("expected a number above 1e-30"));
    EXPECT_THAT(error_with("scale = 2.0", "scale = 1e30"), HasSubstr("too large"));
}

TEST_F(ReadRun, BlocksThatCannotBeSimulatedAreRefused) {
    const auto error_of_blocks = [&](const auto& change) {
        blockgen::BlockMesh mesh = io_test::two_block_mesh();
        change(mesh);
        blockgen::write_block_file(folder / "two.blocks", mesh);
        return error_with("frames = 10", "frames = 10");
    };
    EXPECT_EQ(error_of_blocks([](auto&) {}), "no error");
    EXPECT_THAT(error_of_blocks([](auto& mesh) { std::swap(mesh.corners[6], mesh.corners[7]); }),
                StartsWith("two.blocks: block 1 at"));
    EXPECT_THAT(error_of_blocks([](auto& mesh) {
                    mesh.measured_points[0].position = {9, 9};
                }),
                HasSubstr("lies outside its block"));
    EXPECT_THAT(error_of_blocks([](auto& mesh) { mesh.motion[1] = blockgen::BlockMotion::fixed; }),
                HasSubstr("every block is fixed or prescribed; expected a block that is free to move"));
    EXPECT_THAT(error_of_blocks([](auto& mesh) { mesh.vertices[6].x = 1e31; }),
                HasSubstr("'1e+31' is too large"));
    EXPECT_THAT(error_of_blocks([](auto& mesh) { mesh = {}; }), HasSubstr("has no block"));
}

TEST_F(ReadRun, TheTemplateIsACompleteModelFile) {
    blockgen::BlockMesh mesh = io_test::two_block_mesh();
    mesh.joint_materials = {"joint"};
    blockgen::write_block_file(folder / "slope.blocks", mesh);
    const RunInput input = read(run_template());
    EXPECT_EQ(input.stages.size(), 2u);
    // The template uncommented: every key in its comments must be known.
    std::string uncommented;
    for (std::string rest = run_template(); !rest.empty();) {
        std::string line = rest.substr(0, rest.find('\n') + 1);
        rest.erase(0, line.size());
        if (line.starts_with("# ") && (line.find(" = ") != std::string::npos || line.starts_with("# [")) &&
            !line.starts_with("# Keys") && !line.starts_with("# A run"))
            line.erase(0, 2);
        uncommented += line;
    }
    for (const char* block : {"[[point_load]]\nat = [10, 5]", "[[fixed_point]]\nat = [10, 5]",
                              "[[initial_velocity]]\nat = [10, 5]", "[[viscous_boundary]]"})
        EXPECT_THAT(uncommented, HasSubstr(std::string(block).substr(0, 8)));
    for (std::size_t at; (at = uncommented.find("at = [10, 5]")) != std::string::npos;)
        uncommented.replace(at, 12, "at = [2, 1.5]");
    uncommented.replace(uncommented.find("at = [12, 5]"), 12, "at = [2, 1]");
    for (std::size_t at; (at = uncommented.find("[[0, 0], [120, 0]]")) != std::string::npos;)
        uncommented.replace(at, 18, "[[1, 2], [3, 2]]");
    uncommented.replace(uncommented.find("[[0, 0], [0, 60]]"), 17, "[[1, 1], [1, 2]]");
    uncommented.replace(uncommented.find("head = \"section\""), 16, "head = [[0, 20], [60, 35], [120, 50]]");
    uncommented.replace(uncommented.find("record.at2"), 10, "r.csv");
    uncommented.replace(uncommented.find("up.csv"), 6, "r2.csv");
    folder.write("r2.csv", "0,0\n1,1\n");
    EXPECT_EQ(error_of([&] { read(uncommented); }), "no error") << uncommented;
}

}  // namespace
}  // namespace rockslope::dda::read_run_test
