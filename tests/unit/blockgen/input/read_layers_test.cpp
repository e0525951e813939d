#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "blockgen/sampling/rock_domain.hpp"
#include "support/error_of.hpp"
#include "unit/blockgen/file_folder.hpp"
#include "unit/blockgen/material_areas.hpp"
#include "unit/blockgen/slopes.hpp"

namespace rockslope::blockgen::read_layers_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pair;

/// A box of 20 m by 10 m of soil.
std::string box(const std::string& more) {
    return "[domain]\noutline = [[0, 0], [20, 0], [20, 10], [0, 10]]\nblock_material = \"soil\"\n" + more;
}

std::string layer(const std::string& name, const std::string& top) {
    return "[[layer]]\nname = \"" + name + "\"\nblock_material = \"" + name +
           "\"\njoint_material = \"contact\"\ntop = " + top + "\n";
}

std::map<std::string, double> areas_of(const std::string& text) {
    return material_areas(cut(slope(text)).mesh);
}

std::string error_in(const std::string& text) {
    return error_of([&] { cut(slope(text)); });
}

TEST(Layers, ReachFromTheirTopsDownToTheNextTop) {
    const SlopeModel model =
        slope(box(layer("sand", "[[0, 8], [20, 6]]") + layer("clay", "[[0, 2], [20, 4]]")));
    EXPECT_THAT(model.notes, IsEmpty());
    const CutResult result = cut(model);
    // Trapezoids: 20 (2 + 4) / 2, 20 (6 + 2) / 2, 20 (2 + 4) / 2.
    EXPECT_THAT(material_areas(result.mesh),
                ElementsAre(Pair("clay", 60), Pair("sand", 80), Pair("soil", 60)));
    EXPECT_THAT(result.mesh.joint_materials, ElementsAre("contact"));
    EXPECT_THAT(result.report.warnings, IsEmpty());
}

TEST(Layers, TopsMayRunInEitherSenseEndInsideAndPassTheSides) {
    const auto expected = ElementsAre(Pair("sand", 20 * 4 + 10 * 2.0 / 2 + 5 * 2), Pair("soil", testing::_));
    EXPECT_THAT(areas_of(box(layer("sand", "[[5, 4], [15, 6]]"))), expected);
    EXPECT_THAT(areas_of(box(layer("sand", "[[15, 6], [15, 6], [5, 4]]"))), expected);
    EXPECT_THAT(areas_of(box(layer("sand", "[[-50, 4], [5, 4], [15, 6], [5e3, 6]]"))), expected);
    EXPECT_THAT(areas_of(box(layer("sand", "[[0, 4], [\"500 cm\", \"4000 mm\"], [15, 6]]"))), expected);
    EXPECT_THAT(areas_of(box(layer("sand", "[[7, 4]]"))), ElementsAre(Pair("sand", 80), Pair("soil", 120)));
    // A fault throws the top by 4 m.
    EXPECT_THAT(areas_of(box(layer("sand", "[[0, 2], [8, 2], [8, 6], [20, 6]]"))),
                ElementsAre(Pair("sand", 8 * 2 + 12 * 6), Pair("soil", 8 * 8 + 12 * 4)));
}

TEST(Layers, AnEarlierTopCutsOffALaterOne) {
    // An unconformity at 6 m over a top that rises from 4 m to 8 m, and meets it in the middle.
    const SlopeModel model =
        slope(box(layer("gravel", "[[0, 6], [20, 6]]") + layer("marl", "[[0, 4], [20, 8]]")));
    EXPECT_THAT(
        model.notes,
        ElementsAre("layer 'marl': its top is cut off by that of layer 'gravel', above which it lies by "
                    "up to 2 m, at x = 20"));
    EXPECT_THAT(material_areas(cut(model).mesh),
                ElementsAre(Pair("gravel", 10), Pair("marl", 110), Pair("soil", 80)));
}

TEST(Layers, ThinOutWhereTopsShareALine) {
    // A lens of two triangles: its top and base share the middle third.
    const SlopeModel model = slope(box(layer("coal", "[[0, 6], [5, 4], [15, 4], [20, 6]]") +
                                       layer("marl", "[[0, 3], [5, 4], [15, 4], [20, 3]]") +
                                       "[[joint_set]]\nname = \"cleat\"\nangle = \"90 deg\"\nspacing = 0.5\n"
                                       "origin = [0.25, 0]\nregion = \"coal\"\n"));
    EXPECT_THAT(model.notes, IsEmpty());
    EXPECT_DOUBLE_EQ(RockDomain(model, "coal").area(), 15);
    const CutResult result = cut(model);
    EXPECT_THAT(material_areas(result.mesh),
                ElementsAre(Pair("coal", testing::DoubleNear(15, 1e-4)), Pair("marl", testing::_),
                            Pair("soil", testing::_)));  // vertices on the grid of 1e-6 m
    // Ten lines in each of both triangles, and none between.
    EXPECT_EQ(model.regions[0].name, "coal");
    EXPECT_THAT(all_traces(model), testing::SizeIs(20));
    EXPECT_EQ(result.mesh.block_count(), 2u + 22u);
}

TEST(Layers, ASetHasItsDensityWithinTheLayer) {
    const SlopeModel model =
        slope("seed = 5\n" + box(layer("sand", "[[0, 9], [20, 6]]") + layer("clay", "[[0, 3], [20, 5]]") +
                                 "[[joint_set]]\nname = \"cracks\"\nkind = \"baecher\"\nangle = \"40 deg\"\n"
                                 "trace_length = 0.5\np21 = 3\nregion = \"sand\"\n"));
    const RockDomain sand(model, "sand");
    EXPECT_DOUBLE_EQ(sand.area(), 20 * (6 + 1) / 2.0);
    double length = 0;
    for (const Trace& t : all_traces(model)) {
        const Point &a = t.points[0], &b = t.points[1], middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
        EXPECT_TRUE(sand.contains(middle));
        length += sand.length_in(a, b);
    }
    EXPECT_NEAR(length / sand.area(), 3, 0.5 / sand.area());  // sampling ends within a trace of its target
}

TEST(Layers, RegionsLieOverLayers) {
    EXPECT_THAT(areas_of(box("[[region]]\nname = \"dyke\"\nblock_material = \"basalt\"\n"
                             "joint_material = \"dyke\"\npolygon = [[9, 0], [11, 0], [11, 10], [9, 10]]\n" +
                             layer("sand", "[[0, 5]]"))),
                ElementsAre(Pair("basalt", 20), Pair("sand", 90), Pair("soil", 90)));
}

TEST(Layers, OfASlopeWithABaseEndAtItsSides) {
    const std::string stepped =
        "[domain]\noutline = [[0, 0], [10, 0], [10, -4], [20, -4], [20, 6], [10, 10], [0, 10]]\n"
        "block_material = \"soil\"\n[base]\nbelow = 3\nbehind = 5\nmaterial = \"bedrock\"\n";
    const CutResult result = cut(slope(stepped + layer("sand", "[[-90, 5], [90, 5]]")));
    EXPECT_THAT(material_areas(result.mesh), ElementsAre(Pair("bedrock", 5 * 14 + 10 * 4 + 3 * 25),
                                                         Pair("sand", 140), Pair("soil", 50 + 30)));
    EXPECT_THAT(result.report.warnings, testing::Each(testing::Not(HasSubstr("no effect"))));
    EXPECT_EQ(result.mesh.block_count(), 3u);
}

TEST(Layers, FaultsAreNamed) {
    EXPECT_THAT(error_in(box(layer("sand", "[[0, 5], [20, 5]]") + layer("clay", "[[0, 8], [20, 7]]"))),
                AllOf(HasSubstr("slope.toml:8:"),
                      HasSubstr("layer 'sand' has no rock between its top and that of layer 'clay'"),
                      HasSubstr("from the highest to the lowest")));
    EXPECT_THAT(error_in(box(layer("sand", "[[0, -3], [20, -5]]"))), HasSubstr("has no rock below its top"));
    EXPECT_THAT(error_in(box(layer("sand", "[[0, 5], [12, 6], [9, 7], [20, 8]]"))),
                AllOf(HasSubstr("turns back before (9, 7)"), HasSubstr("[[region]] may be folded")));
    EXPECT_THAT(error_in(box(layer("sand", "[[3, 5], [3, 8]]"))), HasSubstr("the line is upright at (3, 5)"));
    EXPECT_THAT(error_in(box(layer("sand", "[]"))), HasSubstr("a line without a point"));
    EXPECT_THAT(error_in(box(layer("sand", "[[500100, 5], [500140, 8]]"))),
                HasSubstr("lies beside the domain, from (0, 0) to (20, 10)"));
    EXPECT_THAT(error_in(box("[[layer]]\nname = \"sand\"\n")),
                HasSubstr("'top' and 'top_file' in [layer[0]]"));
    EXPECT_THAT(error_in(box(layer("sand", "[[0, 5]]") + "top_file = \"x.csv\"\n")), HasSubstr("both given"));
    EXPECT_THAT(error_in(box(layer("sand", "[[0, 5]]") + layer("sand", "[[0, 3]]"))),
                HasSubstr("a second layer 'sand'"));
    EXPECT_THAT(error_in(box(layer("sand", "[[0, 5]]") + "depth = 3\n")), HasSubstr("'depth'"));
    EXPECT_THAT(error_in(box("[[layer]]\nname = \"sand\"\nblock_material = \"sand\"\ntop = [[0, 5]]\n")),
                AllOf(HasSubstr("layer 'sand' separates two block materials"),
                      HasSubstr("joint_material in the table of the layer")));
    EXPECT_THAT(
        error_in(box(layer("sand", "[[0, 5]]") +
                     "[[joint_set]]\nname = \"s\"\nangle = \"0 deg\"\nspacing = 1\nregion = \"sandd\"\n")),
        HasSubstr("[[region]], [[layer]] or [weathered] zone"));
}

class LayerFiles : public FileFolder {
  protected:
    /// A box with a layer of which a file of this text is the top.
    std::string with_file(const std::string& name, const std::string& text) const {
        return box(
            "[[layer]]\nname = \"sand\"\nblock_material = \"sand\"\njoint_material = \"contact\"\n"
            "top_file = " +
            file(name, text) + "\n");
    }
};

TEST_F(LayerFiles, OfPointsAndOfOneLineAreTops) {
    const auto expected = ElementsAre(Pair("sand", 100), Pair("soil", 100));
    const SlopeModel model = slope(with_file("top.csv", "x,y\n0,4\n20,6\n"));
    EXPECT_THAT(material_areas(cut(model).mesh), expected);
    EXPECT_THAT(model.files, ElementsAre(folder_ / "top.csv"));
    EXPECT_THAT(
        areas_of(with_file("top.geojson", R"({"type": "LineString", "coordinates": [[20, 6], [0, 4]]})")),
        expected);
    // A drawing in millimetres.
    const SlopeModel drawn = slope(with_file(
        "top.dxf",
        "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n0\nLINE\n8\n0\n"
        "10\n0\n20\n4000\n11\n20000\n21\n6000\n0\nENDSEC\n0\nEOF\n"));
    EXPECT_THAT(material_areas(cut(drawn).mesh), expected);
    EXPECT_THAT(drawn.notes, ElementsAre(HasSubstr("the drawing is in mm")));
}

TEST_F(LayerFiles, FaultsAreNamed) {
    EXPECT_THAT(error_in(with_file(
                    "two.geojson",
                    R"({"type": "MultiLineString", "coordinates": [[[0, 4], [9, 5]], [[9, 6], [20, 6]]]})")),
                AllOf(HasSubstr("two.geojson"), HasSubstr("2 lines"), HasSubstr("one line")));
    EXPECT_THAT(error_in(with_file("none.geojson", R"({"type": "FeatureCollection", "features": []})")),
                HasSubstr("no line"));
    EXPECT_THAT(error_in(with_file("empty.csv", "x,y\n")), HasSubstr("no line"));
    EXPECT_THAT(error_in(with_file("nan.csv", "x,y\n0,nan\n")), HasSubstr("nan.csv:2"));
    EXPECT_THAT(error_in(with_file("degrees.geojson",
                                   R"({"type": "LineString", "coordinates": [[24.1, 60.2], [24.2, 60.3]]})")),
                HasSubstr("look like degrees"));
    EXPECT_THAT(error_in(with_file("top.xyz", "")), HasSubstr("not a known geometry format"));
}

}  // namespace
}  // namespace rockslope::blockgen::read_layers_test
