#include "dda/laboratory/shear_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/cyclic_joints.hpp"
#include "unit/dda/input/small_models.hpp"

namespace rockslope::dda::shear_table_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

namespace fs = std::filesystem;

class ShearTableTest : public testing::Test {
  protected:
    ShearTable read(const std::string& text) const { return read_shear_table(folder.write("lab.csv", text)); }
    std::string error(const std::string& text) const {
        return io_test::error_of([&] { read(text); });
    }
    io_test::Folder folder;
};

TEST_F(ShearTableTest, ColumnsAreFoundByNameAndConvertedByUnit) {
    const ShearTable table = read(
        "# a test\n\ntime (s); shear stress (kPa) ;\"displacement (mm)\";note\r\n"
        "0;1.5;-2;start\r\n1;3;0.5;\r\n");
    EXPECT_THAT(table.displacement, ElementsAre(-2e-3, 0.5e-3));
    EXPECT_THAT(table.shear_stress, ElementsAre(1500, 3000));
    EXPECT_TRUE(table.dilation.empty());
    EXPECT_TRUE(table.normal_stress.empty());
}

TEST_F(ShearTableTest, BadTablesAreRefusedWithTheirPlace) {
    EXPECT_THAT(error(""), HasSubstr("has no data rows"));
    EXPECT_THAT(error("displacement (mm)\n"), HasSubstr("has no data rows"));
    EXPECT_THAT(error("shear stress (MPa)\n1\n"), HasSubstr("lab.csv:1: there is no column 'displacement'"));
    EXPECT_THAT(error("displacement\n1\n"), HasSubstr("column 'displacement' has no unit"));
    EXPECT_THAT(error("displacement (MPa)\n1\n"), HasSubstr("is in 'MPa'"));
    EXPECT_THAT(error("displacement (mm),displacement (m)\n1,1\n"), HasSubstr("two columns 'displacement'"));
    EXPECT_THAT(error("displacement (mm),dilation (mm)\n1,1\n2\n"), HasSubstr("lab.csv:3: '' in column 2"));
    EXPECT_THAT(error("displacement (mm)\nnan\n"), HasSubstr("'nan' in column 1 is not a finite number"));
    EXPECT_THAT(error("displacement (mm)\n1e31\n"), HasSubstr("a number below 1e30"));
}

ShearTest granite_test() {
    ShearTest test;
    test.material.law = joint_tests::granite();
    test.length = 0.1;
    test.normal_stress = 1e6;
    test.path = {5e-3, -2e-3};
    test.increment = 1e-4;
    return test;
}

TEST_F(ShearTableTest, RowsReadBackAsATable) {
    const auto rows = run_shear_test(granite_test());
    const ShearTable table = read(shear_rows_csv(rows));
    ASSERT_EQ(table.displacement.size(), rows.size());
    for (std::size_t k = 0; k < rows.size(); ++k) {
        EXPECT_EQ(table.displacement[k], rows[k].displacement);
        EXPECT_EQ(table.shear_stress[k], rows[k].shear_stress);
        EXPECT_EQ(table.dilation[k], rows[k].dilation);
        EXPECT_EQ(table.normal_stress[k], rows[k].normal_stress);
    }
}

TEST_F(ShearTableTest, AMeasuredJointIsReadFromWhereDisplacementsAreZeroed) {
    const fs::path file = folder.write(
        "joints.csv",
        "time (s),stage,bed displacement (m),bed shear stress over bearing length (Pa),bed state,"
        "fault displacement (m)\n"
        "0,settle,0,0,locked,0\n0.5,settle,7,8,locked,9\n"
        "0.5,shake,0,8,locked,0\n0.6,shake,0.001,9,sliding,0.002\n");
    const ShearTable bed = read_measured_joint(file, "bed"), fault = read_measured_joint(file, "fault");
    EXPECT_THAT(bed.displacement, ElementsAre(0, 0.001));
    EXPECT_THAT(bed.shear_stress, ElementsAre(8, 9));
    EXPECT_THAT(fault.displacement, ElementsAre(0, 0.002));
    EXPECT_TRUE(fault.shear_stress.empty());
    EXPECT_THAT(io_test::error_of([&] { read_measured_joint(file, "bet"); }),
                HasSubstr("there is no column 'bet displacement'"));
}

TEST_F(ShearTableTest, TheMisfitIsThatAtTheMeasuredPoints) {
    ShearTable measured;
    measured.displacement = {1.25e-3, 5e-3, 4e-3};
    const ShearTest test = granite_test();
    for (const ShearTestRow& row : compare(test, measured).rows) {
        measured.shear_stress.push_back(row.shear_stress);
        measured.dilation.push_back(row.dilation);
    }
    measured.shear_stress[1] += 3e3;
    measured.shear_stress[2] -= 4e3;
    const Comparison comparison = compare(test, measured);
    EXPECT_NEAR(comparison.shear_stress->root_mean_square, std::sqrt((9e6 + 16e6) / 3), 1e-6);
    EXPECT_NEAR(comparison.shear_stress->largest, 4e3, 1e-6);
    EXPECT_EQ(comparison.shear_stress->at, 4e-3);
    EXPECT_EQ(comparison.dilation->largest, 0);
    EXPECT_FALSE(comparison.normal_stress);
}

}  // namespace
}  // namespace rockslope::dda::shear_table_test
