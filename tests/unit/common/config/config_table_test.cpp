#include "common/config/config_table.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <numbers>
#include <string>

#include "support/error_of.hpp"

namespace rockslope::config_table_test {
namespace {

using Reader = std::function<void(const ConfigTable&)>;

std::string error_of(const std::string& text, const Reader& read,
                     const std::vector<std::string>& overrides = {}) {
    return rockslope::error_of([&] {
        const ConfigTable table = ConfigTable::from_text(text, "m.toml", overrides);
        read(table);
        table.finish();
    });
}

Reader number(Dimension dimension = Dimension::none) {
    return [dimension](const ConfigTable& t) { t.number("a", dimension); };
}

TEST(ConfigTable, ConvertsUnitsToSi) {
    const ConfigTable t = ConfigTable::from_text(
        "a = '35 deg'\nb = '2.5 GPa'\nc = '0.3 g'\nd = '5mm'\ne = 2600\nf = '-1.5 rad'\ng = 0\nh = '2e3 "
        "kN/m'\n"
        "p = ['1 cm', 2]\n",
        "m.toml");
    EXPECT_DOUBLE_EQ(t.number("a", Dimension::angle), 35 * std::numbers::pi / 180);
    EXPECT_DOUBLE_EQ(t.number("b", Dimension::stress), 2.5e9);
    EXPECT_DOUBLE_EQ(t.number("c", Dimension::acceleration), 0.3 * 9.80665);
    EXPECT_DOUBLE_EQ(t.number("d", Dimension::length), 0.005);
    EXPECT_DOUBLE_EQ(t.number("e", Dimension::mass_density), 2600);
    EXPECT_DOUBLE_EQ(t.number("f", Dimension::angle), -1.5);
    EXPECT_DOUBLE_EQ(t.number("g", Dimension::angle), 0) << "zero is the same in every unit";
    EXPECT_DOUBLE_EQ(t.number("h", Dimension::stiffness), 2e6);
    EXPECT_DOUBLE_EQ(t.pair("p", Dimension::length)[0], 0.01);
    EXPECT_NO_THROW(t.finish());
}

TEST(ConfigTable, RejectsValuesOfTheWrongTypeWithTheirLocation) {
    const std::string angle = "expected an angle with its unit such as \"35 deg\" (rad, deg)";
    EXPECT_EQ(error_of("\n a = 35", number(Dimension::angle)),
              "m.toml:2:6: 'a' is 35, without a unit; " + angle);
    EXPECT_EQ(error_of("a = '35 MPa'", number(Dimension::angle)),
              "m.toml:1:5: 'a' is \"35 MPa\", whose unit does not fit; " + angle);
    EXPECT_EQ(error_of("a = nan", number()),
              "m.toml:1:5: 'a' is nan, which is not a finite number; expected a number");
    EXPECT_EQ(error_of("a = -inf", number()),
              "m.toml:1:5: 'a' is -inf, which is not a finite number; expected a number");
    EXPECT_EQ(error_of("a = '1'", number()), "m.toml:1:5: 'a' is the string \"1\"; expected a number");
    EXPECT_EQ(error_of("a = true", number()), "m.toml:1:5: 'a' is true or false; expected a number");
    EXPECT_NE(error_of("a = '1e308 GPa'", number(Dimension::stress)).find("too large"), std::string::npos);
    EXPECT_NE(error_of("a = '7'", number(Dimension::length)).find("no unit"), std::string::npos);
    EXPECT_EQ(error_of("a = [[0, 1], [2, 'x']]", [](const ConfigTable& t) { t.pairs("a"); }),
              "m.toml:1:18: 'a' (entry 2) (entry 2) is the string \"x\"; expected a number");
    EXPECT_EQ(error_of("a = [1, 2, 3]", [](const ConfigTable& t) { t.pair("a"); }),
              "m.toml:1:5: 'a' is an array of 3; expected two numbers, [x, y]");
    EXPECT_EQ(error_of("a = 1.5", [](const ConfigTable& t) { t.integer("a"); }),
              "m.toml:1:5: 'a' is a number; expected a whole number");
    EXPECT_EQ(error_of("a = 1", [](const ConfigTable& t) { t.table("a"); }),
              "m.toml:1:5: 'a' is a whole number; expected a table");
    EXPECT_EQ(error_of("a = [1]", [](const ConfigTable& t) { t.array_of_tables("a"); }),
              "m.toml:1:6: 'a' (entry 1) is a whole number; expected a table");
}

TEST(ConfigTable, NamesTheNearestKey) {
    const Reader read = [](const ConfigTable& t) {
        t.table("joint_material").table("bedding").number("friction_angle", Dimension::angle, 0.0);
    };
    EXPECT_EQ(error_of("[joint_material.bedding]\nfrcition_angle = '3 deg'", read),
              "m.toml:2:18: unknown key 'frcition_angle' in [joint_material.bedding]; did you mean "
              "'friction_angle'?");
    EXPECT_EQ(error_of("[joint_material.bedding]\nwet = true", read),
              "m.toml:2:7: unknown key 'wet' in [joint_material.bedding]; expected one of friction_angle");
    EXPECT_EQ(error_of("densty = 3", [](const ConfigTable& t) { t.number("density"); }),
              "m.toml:1:10: unknown key 'densty'; did you mean 'density'?")
        << "a missing key is explained by the misspelt one";
    EXPECT_EQ(error_of("[t]\n", [](const ConfigTable& t) { t.table("t").number("density"); }),
              "m.toml:1:1: there is no key 'density' in [t]; expected a number");
}

TEST(ConfigTable, ChoicesAndRanges) {
    const Reader read = [](const ConfigTable& t) { t.choice("plane", {"strain", "stress"}); };
    EXPECT_EQ(error_of("plane = 'stran'", read),
              "m.toml:1:9: 'plane' is \"stran\"; did you mean \"strain\"?; expected one of strain, stress");
    EXPECT_EQ(error_of("density = -5",
                       [](const ConfigTable& t) {
                           t.checked(
                               "density", t.number("density"), [](double v) { return v > 0; },
                               "a positive number");
                       }),
              "m.toml:1:11: 'density' is -5; expected a positive number");
}

TEST(ConfigTable, SyntaxErrorsHaveALocation) {
    EXPECT_EQ(error_of("a = 1\nb = [1, ", number()).substr(0, 9), "m.toml:2:");
    EXPECT_EQ(error_of("a = 1\na = 2", number()).substr(0, 9), "m.toml:2:");
}

TEST(ConfigTable, NamesWithBlanksNeedQuotes) {
    const std::string hint = "needs quotes, as in [table.\"two words\"]";
    EXPECT_NE(error_of("[joint.bed ding]\na = 1", number()).find(hint), std::string::npos);
    EXPECT_NE(error_of("bed ding = 1", number()).find(hint), std::string::npos);
    for (const char* other : {"a = 1\na = 2", "a = [1, ", "a = ", "[a\n", "a = \"b\nc"})
        EXPECT_EQ(error_of(other, number()).find("quotes"), std::string::npos) << error_of(other, number());
}

TEST(ConfigTable, OverridesReplaceAndMakeKeys) {
    const std::string text = "a = 1\n[[stage]]\nstep = 1\n[[stage]]\nstep = 2\n";
    const ConfigTable t = ConfigTable::from_text(
        text, "m.toml",
        {"a=-25 deg", "stage[1].step=0.5", "new.deep.word=out/x.blocks", "stage[0].at=[1, 2]"});
    EXPECT_DOUBLE_EQ(t.number("a", Dimension::angle), -25 * std::numbers::pi / 180);
    const auto stages = t.array_of_tables("stage");
    EXPECT_EQ(stages[0].number("step"), 1);
    EXPECT_EQ(stages[0].pair("at")[1], 2);
    EXPECT_EQ(stages[1].number("step"), 0.5);
    EXPECT_EQ(t.table("new").table("deep").string("word"), "out/x.blocks");
    EXPECT_NO_THROW(t.finish());
}

TEST(ConfigTable, ErrorsOfOverridesNameThem) {
    EXPECT_EQ(error_of("a = 1", number(), {"a=nan"}),
              "--set a=nan: 'a' is nan, which is not a finite number; expected a number");
    EXPECT_EQ(error_of("a = 1", number(), {"bb=2"}), "--set bb=2: unknown key 'bb'; expected one of a");
    EXPECT_EQ(error_of("a = 1", number(), {"a.b=2"}),
              "--set a.b=2: 'a' is a whole number; expected a table before a key");
    EXPECT_EQ(error_of("a = [1]", number(), {"a[1]=2"}),
              "--set a[1]=2: 'a' is an array of 1; expected an index below that, counted from 0");
    for (const char* bad : {"a", "=1", "a..b=1", "a[=1", "a[x]=1", "a[0]b=1", "\"a=1", "a=[1,"})
        EXPECT_EQ(error_of("a = [1]", number(), {bad}).substr(0, 6), "--set ") << bad;
}

TEST(ConfigTable, PathsAreRelativeToTheModelFileOrTheWorkingDirectory) {
    const ConfigTable t = ConfigTable::from_text("a = 'x/../r.at2'", "m.toml", {"b=r.at2"});
    EXPECT_EQ(t.file_path("a"), std::filesystem::current_path() / "r.at2");
    EXPECT_EQ(t.file_path("b"), std::filesystem::current_path() / "r.at2");
    EXPECT_EQ(t.effective_text(std::filesystem::current_path() / "out"),
              "a = \"../r.at2\"\nb = \"../r.at2\"\n");
}

TEST(ConfigTable, EffectiveTextReadsBackWithItsDefaults) {
    const auto read = [](const ConfigTable& t) {
        std::vector<double> values = {t.number("angle", Dimension::angle, 0.6),
                                      t.number("e", Dimension::stress, 1.0 / 3),
                                      t.number("huge", Dimension::none, 9.2233720368547758e18)};
        for (const auto& [name, material] : t.table("material").named_tables())
            values.push_back(material.number("density", Dimension::mass_density));
        for (const ConfigTable& stage : t.array_of_tables("stage")) {
            values.push_back(stage.number("step", Dimension::time, 0.005));
            if (const auto motion = stage.optional_table("motion")) values.push_back(motion->numbers("x")[1]);
        }
        t.finish();
        return values;
    };
    const ConfigTable first = ConfigTable::from_text(
        "e = '2.5 GPa'\n[material.'hard rock']\ndensity = '2.6 t/m3'\n[material.a]\ndensity = "
        "1\n[[stage]]\n[[stage]]\n"
        "step = 0.1\nmotion = {x = [0, 1e-3]}\n",
        "m.toml");
    const std::vector<double> values = read(first);
    const ConfigTable second = ConfigTable::from_text(first.effective_text(), "echo.toml");
    EXPECT_EQ(read(second), values);
    EXPECT_EQ(values[3], 2600) << "named tables come in the order of the file";
    EXPECT_NE(first.effective_text().find("[[stage]]\nstep = 0.005  # default\n"), std::string::npos);
}

}  // namespace
}  // namespace rockslope::config_table_test
