#include "dda/monitor/plausibility.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/scene.hpp"

namespace rockslope::plausibility_test {
namespace {

using namespace scene;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A block of 1 m on a floor.
Scene block_on_floor() {
    Scene s;
    s.friction(30);
    s.box({0, -1}, 1, 1, dda::Motion::fixed);
    s.box({0, 0}, 1, 1);
    return s;
}

/// A stage of 10 s in steps of 5 ms under a record of 10 s at 5 ms, of which the first second shakes.
dda::Stage shaken() {
    dda::Stage stage;
    stage.name = "shake";
    stage.duration = 10;
    stage.control.step = 0.005;
    std::vector<double> times, values;
    for (int k = 0; k <= 2000; ++k) {
        times.push_back(0.005 * k);
        values.push_back(k > 0 && k <= 200 ? 1.0 : 0.0);
    }
    stage.base_motions.push_back({"", dda::TimeTable(times, values), dda::TimeTable({0.0}, {0.0})});
    return stage;
}

TEST(Plausibility, SaysNothingOfAnOrdinaryModel) {
    EXPECT_THAT(dda::implausible(block_on_floor().model, {shaken()}), IsEmpty());
}

TEST(Plausibility, FindsMissingUnits) {
    Scene s = block_on_floor();
    s.model.block_materials[dda::BlockMaterialIndex(0)].youngs_modulus = 20;
    s.model.block_materials[dda::BlockMaterialIndex(0)].density = 2.65;
    EXPECT_THAT(dda::implausible(s.model, {}),
                ElementsAre(AllOf(HasSubstr("youngs_modulus"), HasSubstr("20 Pa"), HasSubstr("\"20 GPa\"")),
                            AllOf(HasSubstr("density"), HasSubstr("2.65 kg/m3"))));
}

TEST(Plausibility, FindsWallStrengthsOfNoJoint) {
    Scene s = block_on_floor();
    const auto of = [&](double jrc, double jcs) {
        dda::BartonBandis law;
        law.barton = {jrc, jcs, scene::radians(30)};
        s.model.joint_materials[0].law = law;
        return dda::implausible(s.model, {});
    };
    EXPECT_THAT(of(8, 50), ElementsAre(AllOf(HasSubstr("jcs of joint material 'joint' is 50 Pa"),
                                             HasSubstr("\"50 MPa\""))));
    EXPECT_THAT(of(8, 50e9), ElementsAre(HasSubstr("5e+10 Pa")));
    EXPECT_THAT(of(8, 50e6), IsEmpty());
    EXPECT_THAT(of(0, 0), IsEmpty()) << "flat";
}

TEST(Plausibility, FindsFrictionAnglesOfNoJoint) {
    Scene s = block_on_floor();
    auto& law = s.model.joint_materials[0].law;
    const auto of = [&](double degrees, double cohesion) {
        law = dda::MohrCoulomb{.friction_angle = degrees * M_PI / 180, .cohesion = cohesion};
        return dda::implausible(s.model, {});
    };
    EXPECT_THAT(of(0, 0), ElementsAre(HasSubstr("nothing holds blocks on it")));
    EXPECT_THAT(of(0, 1e4), IsEmpty()) << "clay that is not drained";
    s.model.gravity = {0, 0};
    EXPECT_THAT(of(0, 0), IsEmpty()) << "nothing pulls";
    EXPECT_THAT(of(0.6, 1e4),
                ElementsAre(AllOf(HasSubstr("is 0.6 deg"), HasSubstr("\"0.6 rad\": they are 34.4 deg"))));
    EXPECT_THAT(of(2, 0), IsEmpty());
    EXPECT_THAT(of(70, 0), IsEmpty());
    EXPECT_THAT(of(80, 0), ElementsAre(HasSubstr("80 deg, which no joint has")));
    dda::Plesha rough;
    rough.friction_angle = 75 * M_PI / 180;
    law = rough;
    EXPECT_THAT(dda::implausible(s.model, {}), ElementsAre(HasSubstr("75 deg"))) << "of any law";
}

TEST(Plausibility, FindsTensionBeyondTheEndOfTheShearStrength) {
    Scene s = block_on_floor();
    auto& law = s.model.joint_materials[0].law;
    const auto of = [&](double cohesion, double tension) {
        law = dda::MohrCoulomb{.friction_angle = M_PI / 4, .cohesion = cohesion, .tensile_strength = tension};
        return dda::implausible(s.model, {});
    };
    EXPECT_THAT(of(1e5, 1e5), IsEmpty());
    EXPECT_THAT(of(1e5, 2e5), ElementsAre(AllOf(HasSubstr("tensile_strength"), HasSubstr("2e+05 Pa"),
                                                HasSubstr("1e+05 Pa"))));
    EXPECT_THAT(of(0, 1e5), IsEmpty()) << "blocks that are glued";
}

TEST(Plausibility, FindsHeadsBelowAllFaces) {
    Scene s = block_on_floor();
    s.model.origin = {0, 100};
    const auto of = [&](double height) {
        const dda::HeadWater water{
            {dda::EdgeIndex(0), dda::EdgeIndex(1)}, {{0, height}}, 9810, dda::TimeTable()};
        s.model.loads = {water};
        return dda::implausible(s.model, {});
    };
    EXPECT_THAT(of(-0.5), IsEmpty()) << "the floor begins at -1";
    EXPECT_THAT(of(-2), ElementsAre(AllOf(HasSubstr("[[head_water]]"), HasSubstr("y = 98 m"),
                                          HasSubstr("y = 99 m"))));
}

TEST(Plausibility, FindsBlocksTooSmallForTheSection) {
    Scene s;
    s.friction(30);
    s.box({0, 0}, 40, 40, dda::Motion::fixed);
    s.box({0, 40}, 0.003, 0.003);
    EXPECT_THAT(dda::implausible(s.model, {}), ElementsAre(HasSubstr("median size 0.003 m")));
}

TEST(Plausibility, FindsChipsAmongLargeBlocks) {
    Scene s = block_on_floor();
    s.box({2, 0}, 1, 1);
    const int chip = s.box({4, 0}, 2e-3, 2e-3);
    const std::string where = "block " + std::to_string(chip) + " at (4.001, 0.001) with 4e-06 m2";
    EXPECT_THAT(dda::implausible(s.model, {}),
                ElementsAre(AllOf(HasSubstr("1 block is smaller than 1e-05"), HasSubstr(where))));
    s.box({5, 0}, 3e-3, 3e-3);
    s.box({6, 0}, 2, 2);
    EXPECT_THAT(dda::implausible(s.model, {}),
                ElementsAre(AllOf(HasSubstr("2 blocks are smaller"), HasSubstr(where))));
    s.box({8, 0}, 4e-3, 4e-3);
    EXPECT_THAT(dda::implausible(s.model, {}), ElementsAre(HasSubstr("2 blocks are"))) << "of 16e-6 m2";
}

TEST(Plausibility, FindsStepsAndStagesThatMissPartsOfTheRecord) {
    dda::Stage coarse = shaken();
    coarse.control.step = 0.02;
    EXPECT_THAT(dda::implausible(block_on_floor().model, {coarse}),
                ElementsAre(AllOf(HasSubstr("steps of 0.02 s"), HasSubstr("the record, 0.005 s"))));
    dda::Stage cut = shaken();
    cut.duration = 0.5;
    EXPECT_THAT(dda::implausible(block_on_floor().model, {cut}),
                ElementsAre(AllOf(HasSubstr("50 % of its energy is cut off"), HasSubstr("\"record\""))));
    cut.duration = 0.001;
    EXPECT_THAT(dda::implausible(block_on_floor().model, {cut}),
                ElementsAre(HasSubstr(": 100 % of its energy is cut off")))
        << "in digits, without an exponent";
    dda::Stage rest = shaken();
    rest.duration = 5;
    EXPECT_THAT(dda::implausible(block_on_floor().model, {rest}), IsEmpty())
        << "the rest of the record is still";
}

}  // namespace
}  // namespace rockslope::plausibility_test
