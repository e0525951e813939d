#include "dda/laboratory/read_shear_test.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "unit/dda/input/small_models.hpp"

namespace rockslope::dda::read_shear_test_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class ReadShearTest : public testing::Test {
  protected:
    ReadShearTest() { folder.write("test.toml", shear_test_template()); }
    ShearTest read(const std::vector<std::string>& overrides) const {
        return read_shear_test(folder / "test.toml", overrides).test;
    }
    std::string error(const std::vector<std::string>& overrides) const {
        return io_test::error_of([&] { read(overrides); });
    }
    std::string path_from(const std::string& file) const {
        return "shear_test.path={file=\"" + (folder / file).string() + "\"}";
    }
    const std::string prescribed = "shear_test.boundary=\"prescribed-stress\"";
    io_test::Folder folder;
};

TEST_F(ReadShearTest, TheTemplateHasAConstantStress) {
    const ShearTest test = read({});
    EXPECT_EQ(test.boundary, NormalBoundary::constant_stress);
    EXPECT_TRUE(test.path_stress.empty());
}

TEST_F(ReadShearTest, TheStressAlongThePathIsAListOrAColumnOfItsFile) {
    const ShearTest listed =
        read({prescribed, "shear_test.path_stress=[\"1 MPa\", 0, \"500 kPa\", \"2 MPa\"]"});
    EXPECT_EQ(listed.boundary, NormalBoundary::prescribed_stress);
    EXPECT_THAT(listed.path_stress, ElementsAre(1e6, 0, 5e5, 2e6));
    folder.write("lab.csv", "time (s),displacement (mm),normal stress (MPa)\n0,0,1\n2,5,1.5\n3,5,0\n");
    const ShearTest measured = read({prescribed, path_from("lab.csv")});
    EXPECT_THAT(measured.path, ElementsAre(0, 5e-3, 5e-3));
    EXPECT_THAT(measured.path_stress, ElementsAre(1e6, 1.5e6, 0));
}

TEST_F(ReadShearTest, AWrongStressAlongThePathIsRefusedWithItsPlace) {
    EXPECT_THAT(error({prescribed}), HasSubstr("no stress is given; expected 'path_stress'"));
    EXPECT_THAT(error({prescribed, "shear_test.path_stress=[1e6, 0]"}),
                HasSubstr("has 2 stresses for 4 points of 'path'"));
    EXPECT_THAT(error({prescribed, "shear_test.path_stress=[1e6, 0, -1, 0]"}), HasSubstr("is negative"));
    EXPECT_THAT(error({"shear_test.path_stress=[1e6, 0, 1, 0]"}), HasSubstr("path_stress"))
        << "under another boundary";
    folder.write("lab.csv", "displacement (mm)\n1\n");
    EXPECT_THAT(error({prescribed, path_from("lab.csv")}), HasSubstr("a column 'normal stress'"));
    folder.write("broken.toml", shear_test_template() + "boundary = \"prescribed-stress\"\n");
    EXPECT_THAT(io_test::error_of([&] { read_shear_test(folder / "broken.toml"); }),
                HasSubstr("broken.toml:"));
}

}  // namespace
}  // namespace rockslope::dda::read_shear_test_test
