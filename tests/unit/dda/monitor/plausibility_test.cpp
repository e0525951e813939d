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

TEST(Plausibility, FindsBlocksTooSmallForTheSection) {
    Scene s;
    s.box({0, 0}, 40, 40, dda::Motion::fixed);
    s.box({0, 40}, 0.003, 0.003);
    EXPECT_THAT(dda::implausible(s.model, {}), ElementsAre(HasSubstr("median size 0.003 m")));
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
    dda::Stage rest = shaken();
    rest.duration = 5;
    EXPECT_THAT(dda::implausible(block_on_floor().model, {rest}), IsEmpty())
        << "the rest of the record is still";
}

}  // namespace
}  // namespace rockslope::plausibility_test
