#include "blockgen/input/read_map_traces.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <iomanip>
#include <numbers>
#include <sstream>

#include "blockgen/input/domain.hpp"
#include "support/error_of.hpp"
#include "unit/blockgen/file_folder.hpp"
#include "unit/blockgen/slopes.hpp"

namespace rockslope::blockgen::read_map_traces_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class ReadMapTraces : public FileFolder {
  protected:
    /// The key of a new file.
    std::string key(const std::string& name, const std::string& text) const {
        return "file = " + file(name, text) + "\n";
    }
};

/// A slope of 100 m along a section eastwards that falls from 80 m to 30 m between x = 40 and 90 m.
std::string text_with(const std::string& traces, const std::string& project = {}) {
    return "[domain]\nblock_material = \"rock\"\n" + project +
           "outline = [[0, 0], [100, 0], [100, 30], [90, 30], [40, 80], [0, 80]]\n"
           "[section]\nfrom = [466000, 6691500]\nto = [466100, 6691500]\n"
           "[[traces]]\non = \"map\"\nname = \"mapped\"\n" +
           traces;
}

std::string error_with(const std::string& traces) {
    return error_of([&] { slope(text_with(traces)); });
}

/// The elevation of a joint of two points at an x.
double height_at(const Trace& joint, double x) {
    const Point &a = joint.points[0], &b = joint.points[1];
    return a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x);
}

TEST_F(ReadMapTraces, TheApparentDipThroughTheGround) {
    // The trace crosses the section at x = 60, where the ground is at 60 m.
    const std::string points =
        "joint_material = \"fault\"\npoints = [[466062, 6691510], [466058, 6691490]]\n";
    const SlopeModel model = slope(text_with(points + "dip = \"60 deg\"\ndip_direction = \"120 deg\"\n"));
    ASSERT_EQ(model.traces.size(), 1u);
    EXPECT_EQ(model.traces[0].name, "mapped");
    EXPECT_EQ(model.traces[0].joint_material, "fault");
    // tan 60 deg cos 30 deg = 3 / 2, downwards to the right. 1e-8: map coordinates are rounded to 1e-9.
    EXPECT_NEAR(height_at(model.traces[0], 60), 60, 1e-8);
    EXPECT_NEAR(height_at(model.traces[0], 50), 75, 1e-8);
    // It runs through the whole domain.
    const Bounds box = domain_bounds(model);
    for (const Point& p : model.traces[0].points)
        EXPECT_FALSE(p.x > 0 && p.x < box.high.x && p.y > 0 && p.y < box.high.y);
    EXPECT_THAT(model.notes, IsEmpty());
    EXPECT_EQ(cut(model).report.blocks, 2u);

    // Across the dip it is level, against it it rises.
    const auto joint = [&](const std::string& direction) {
        return slope(text_with(points + "dip = \"60 deg\"\ndip_direction = \"" + direction + " deg\"\n"))
            .traces[0];
    };
    EXPECT_NEAR(height_at(joint("180"), 0), 60, 1e-8);
    EXPECT_NEAR(height_at(joint("270"), 61), 60 + std::tan(std::numbers::pi / 3), 1e-8);
}

TEST_F(ReadMapTraces, OfALengthToEachSideOfTheOutcrop) {
    const SlopeModel model =
        slope(text_with("joint_material = \"fault\"\npoints = [[466060, 6691510], [466060, 6691490]]\n"
                        "dip = \"45 deg\"\ndip_direction = \"270 deg\"\ntrace_length = 20\n"));
    const double side = 10 * std::numbers::sqrt2;
    ASSERT_EQ(model.traces[0].points.size(), 2u);
    EXPECT_NEAR(model.traces[0].points[0].x, 60 - side, 1e-8);
    EXPECT_NEAR(model.traces[0].points[0].y, 60 - side, 1e-8);
    EXPECT_NEAR(model.traces[0].points[1].x, 60 + side, 1e-8);
    // 20 m of it are in the rock, the others in the air.
    const CutResult result = cut(model);
    EXPECT_NEAR(result.report.joints[0].outside, 20, 1e-6);
    EXPECT_NEAR(result.report.joints[0].pruned, 20, 1e-6);
}

const std::string fields =
    R"({"type": "FeatureCollection", "features": [
{"type": "Feature", "properties": {"joint_material": "fault", "dip": 60, "dip_direction": 120},
 "geometry": {"type": "LineString", "coordinates": [[466062, 6691510, 65], [466058, 6691490, 69]]}},
{"type": "Feature", "properties": {"dip": "30", "dip_direction": null},
 "geometry": {"type": "MultiLineString", "coordinates": [[[466020, 6691540, 81], [466020, 6691499, 81]],
  [[466030, 6691540, 82], [466030, 6691480, 82]]]}}]})";

TEST_F(ReadMapTraces, OrientationsOfTheFileComeFirst) {
    const std::string table = "joint_material = \"joint\"\ndip = \"10 deg\"\ndip_direction = \"90 deg\"\n";
    const SlopeModel model = slope(text_with(key("a.geojson", fields) + table));
    ASSERT_EQ(model.traces.size(), 3u);
    EXPECT_EQ(model.traces[0].joint_material, "fault");
    EXPECT_NEAR(height_at(model.traces[0], 50), 75, 1e-8);
    EXPECT_EQ(model.traces[1].joint_material, "joint");
    // The direction is the table's: the section is along the dip. The ground is at 80 m there.
    EXPECT_NEAR(height_at(model.traces[1], 30), 80 - 10 * std::tan(std::numbers::pi / 6), 1e-8);
    EXPECT_THAT(model.notes, ElementsAre(HasSubstr("third coordinates of 2 geometries are not used")));

    // Their own elevations: 67 m at the middle of the first.
    const SlopeModel own = slope(text_with(key("a.geojson", fields) + table + "elevation = \"trace\"\n"));
    EXPECT_NEAR(height_at(own.traces[0], 50), 67 + 15, 1e-8);
    EXPECT_NEAR(height_at(own.traces[1], 20), 81, 1e-8);
    EXPECT_THAT(own.notes, ElementsAre(HasSubstr("differ from the ground by up to 7 m")));

    // The same from a table with a header, and without one.
    const std::string rows =
        "466062,6691510,466058,6691490,fault,60,120,65,69\n466020,6691540,466020,6691499,,30,,81,81\n"
        "466030,6691540,466030,6691480,,30,,82,82\n";
    for (const std::string& header :
         {std::string(), std::string("x1,y1,x2,y2,joint_material,dip,dip_direction,z1,z2\n")}) {
        const SlopeModel csv =
            slope(text_with(key("b.csv", header + rows) + table + "elevation = \"trace\"\n"));
        ASSERT_EQ(csv.traces.size(), 3u);
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_EQ(csv.traces[k].points, own.traces[k].points) << header << k;
    }
}

TEST_F(ReadMapTraces, TracesThatLeaveTheirPlaneAreCounted) {
    const std::string dip = "joint_material = \"a\"\ndip = \"50 deg\"\n";
    const std::string north_south = "points = [[466050, 6691510], [466050, 6691490]]\n";
    // A strike given as dip direction, and a plane that may leave level ground so far.
    const SlopeModel turned = slope(text_with(north_south + dip + "dip_direction = \"0 deg\"\nreach = 5\n"));
    EXPECT_THAT(
        turned.notes,
        ElementsAre(AllOf(HasSubstr("1 mapped trace runs more than 30 deg out of the plane of its dip"),
                          HasSubstr("the first at (466050, 6691510)"),
                          HasSubstr("without elevations the ground is taken as level"))));
    EXPECT_THAT(slope(text_with(north_south + dip + "dip_direction = \"53 deg\"\n")).notes, IsEmpty());
    const std::string gentle = "joint_material = \"a\"\ndip = \"29 deg\"\ndip_direction = \"0 deg\"\n";
    EXPECT_THAT(slope(text_with(north_south + gentle)).notes, IsEmpty());
    // Down a slope of 50 deg along the dip, which level ground would not allow; then up it; then without
    // elevations.
    const std::string rows =
        "466050,6691510,466050,6691490,,50,180,70,46.165\n466060,6691510,466060,6691490,,50,180,50,74\n";
    const std::string own = "joint_material = \"a\"\nelevation = \"trace\"\n";
    const std::vector<std::string> notes = slope(text_with(key("heights.csv", rows) + own)).notes;
    EXPECT_THAT(notes, Contains(AllOf(HasSubstr("1 mapped trace runs"), HasSubstr("first at (466060, "),
                                      HasSubstr("by their elevations"))));
}

TEST_F(ReadMapTraces, WhatDoesNotMeetTheSectionIsCounted) {
    const std::string rows =
        "x1,y1,x2,y2\n466010,6691520,466010,6691490\n"  // crosses
        "466020,6691520,466020,6691508\n"               // 8 m short
        "466030,6691520,466030,6691512\n"               // 12 m short
        "465990,6691520,465990,6691490\n";              // west of the section
    const std::string planes = "joint_material = \"a\"\ndip = \"50 deg\"\ndip_direction = \"90 deg\"\n";
    const SlopeModel model = slope(text_with(key("a.csv", rows) + planes));
    EXPECT_EQ(model.traces.size(), 1u);
    EXPECT_THAT(
        model.notes,
        ElementsAre(AllOf(HasSubstr("1 of 4 mapped traces are projected"),
                          HasSubstr("2 farther along strike from the section line than reach = 0 m, the "
                                    "nearest 8 m"),
                          HasSubstr("1 meeting it beyond its ends"))));
    EXPECT_EQ(slope(text_with(key("a.csv", rows) + planes + "reach = 8\n")).traces.size(), 2u);
    EXPECT_EQ(slope(text_with(key("a.csv", rows) + planes + "reach = \"12 m\"\n")).traces.size(), 3u);

    const std::string east = "joint_material = \"a\"\ndip = \"50 deg\"\ndip_direction = \"0 deg\"\n";
    const std::string beside = key("b.csv", "466010,6691520,466080,6691521\n");
    EXPECT_THAT(
        error_with(beside + east + "reach = 1e6\n"),
        AllOf(HasSubstr("no trace meets the section: 1 parallel to the section"), HasSubstr("slope.toml:")));
    EXPECT_THAT(error_with(beside + planes), HasSubstr("a larger reach"));
    EXPECT_THAT(error_with(key("c.csv", "x1,y1,x2,y2\n") + planes), HasSubstr("contains no trace"));
}

TEST_F(ReadMapTraces, MissingAndWrongOrientationsAreRefused) {
    const std::string rows = key("a.csv", "466010,6691520,466010,6691490\n");
    EXPECT_THAT(error_with(rows + "joint_material = \"a\"\ndip = \"50 deg\"\n"),
                HasSubstr("trace 1 has no dip_direction"));
    EXPECT_THAT(error_with(rows + "joint_material = \"a\"\ndip_direction = \"50 deg\"\n"),
                HasSubstr("trace 1 has no dip;"));
    EXPECT_THAT(error_with(rows + "joint_material = \"a\"\ndip = \"95 deg\"\ndip_direction = \"0 deg\"\n"),
                HasSubstr("a dip from 0 to 90 deg"));
    EXPECT_THAT(error_with(rows + "dip = \"50 deg\"\ndip_direction = \"90 deg\"\n"),
                HasSubstr("no joint material"));
    EXPECT_THAT(error_with(key("b.csv", "466010,6691520,466010,6691490,a,120,60\n")),
                AllOf(HasSubstr("b.csv"), HasSubstr("trace 1 has a dip of 120 degrees")));
    EXPECT_THAT(error_with(key("b.csv", "466010,6691520,466010,6691490,a,steep,60\n")),
                AllOf(HasSubstr("b.csv:1: 'steep'")));
    EXPECT_THAT(error_with(rows + "joint_material = \"a\"\ndip = \"50 deg\"\ndip_direction = \"90 deg\"\n"
                                  "elevation = \"trace\"\n"),
                HasSubstr("trace 1 at (466010, 6691520) has no elevation"));
    EXPECT_THAT(error_with(rows + "reach = -1\n"), HasSubstr("a distance of zero or more"));
    EXPECT_THAT(error_with(rows + "trace_length = 0\n"), HasSubstr("a positive length"));
    // Keys of the map need the map, and the map a section line.
    EXPECT_THAT(
        error_of([] {
            slope(
                "[domain]\nblock_material = \"rock\"\noutline = [[0, 0], [9, 0], [9, 9]]\n[[traces]]\n"
                "joint_material = \"a\"\npoints = [[0, 1], [9, 1]]\ndip = \"5 deg\"\n");
        }),
        HasSubstr("dip"));
    EXPECT_THAT(
        error_of([] {
            slope(
                "[domain]\nblock_material = \"rock\"\noutline = [[0, 0], [9, 0], [9, 9]]\n[[traces]]\n"
                "joint_material = \"a\"\npoints = [[0, 1], [9, 1]]\non = \"map\"\n");
        }),
        HasSubstr("no section line"));
}

TEST_F(ReadMapTraces, MapsAreHeldToTheRulesOfCoordinates) {
    const std::string planes = "joint_material = \"a\"\ndip = \"50 deg\"\ndip_direction = \"90 deg\"\n";
    // The x axis of the section counts from 0 to 100, where degrees are, too.
    std::vector<Point> trace = {{466060, 6691510}, {466060, 6691490}};
    CoordinateSystem("EPSG:3067", {}).convert(trace, CoordinateSystem("OGC:CRS84", {}), {});
    std::ostringstream row;
    row << std::setprecision(17) << trace[0].x << ',' << trace[0].y << ',' << trace[1].x << ',' << trace[1].y;
    const std::string degrees = key("a.csv", row.str());
    EXPECT_THAT(error_with(degrees + planes), HasSubstr("look like degrees"));
    const SlopeModel model = slope(text_with(degrees + planes, "project = \"EPSG:3067\"\n"));
    ASSERT_EQ(model.traces.size(), 1u);
    // The ground at x = 60 is at 60 m, and falls by 1 in 1: the way there and back is exact to a micrometre.
    EXPECT_NEAR(height_at(model.traces[0], 60), 60, 1e-5);
    EXPECT_THAT(model.notes, ElementsAre(HasSubstr("converted from")));
}

TEST_F(ReadMapTraces, TracesBeyondTheGroundOfTheSectionAreCounted) {
    std::string text =
        text_with(key("a.csv", "466010,6691520,466010,6691490\n466090,6691520,466090,6691490\n") +
                  "joint_material = \"a\"\ndip = \"50 deg\"\ndip_direction = \"90 deg\"\n");
    const std::string outline = "[[0, 0], [100, 0], [100, 30], [90, 30], [40, 80], [0, 80]]";
    text.replace(text.find(outline), outline.size(), "[[0, 0], [50, 0], [50, 80], [0, 80]]");
    const SlopeModel model = slope(text);
    EXPECT_EQ(model.traces.size(), 1u);
    EXPECT_THAT(model.notes, ElementsAre(HasSubstr("1 where the section has no ground")));
}

}  // namespace
}  // namespace rockslope::blockgen::read_map_traces_test
