#include "blockgen/input/meet_section.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace rockslope::blockgen::meet_section_test {
namespace {

constexpr double pi = std::numbers::pi, degree = pi / 180;

JointPlane plane(double dip, double dip_direction) {
    return {dip * degree, dip_direction * degree};
}

TEST(ApparentAngle, IsTheDipAlongTheSectionAndZeroAcrossIt) {
    EXPECT_NEAR(apparent_angle(plane(35, 90), 90 * degree), -35 * degree, 1e-15);
    EXPECT_NEAR(apparent_angle(plane(35, 270), 90 * degree), 35 * degree, 1e-15);
    EXPECT_NEAR(apparent_angle(plane(35, 180), 90 * degree), 0, 1e-15);
    EXPECT_NEAR(apparent_angle(plane(35, 0), 90 * degree), 0, 1e-15);
    EXPECT_NEAR(apparent_angle(plane(0, 77), 90 * degree), 0, 1e-15);
    EXPECT_NEAR(std::abs(apparent_angle(plane(90, 120), 90 * degree)), 90 * degree, 1e-15);
    for (double dip = 5; dip < 90; dip += 5)
        for (double direction = 0; direction < 360; direction += 15)
            for (const double azimuth : {0.0, 40.0, 250.0})
                EXPECT_NEAR(std::tan(apparent_angle(plane(dip, direction), azimuth * degree)),
                            -std::tan(dip * degree) * std::cos((direction - azimuth) * degree), 1e-12)
                    << dip << ' ' << direction << ' ' << azimuth;
}

/// A section of 100 m in the direction (3, 4) / 5.
const SectionLine section{{1000, 2000}, {1060, 2080}};

/// The point of the map at x along the section and `left` m to the left of it.
Point on_map(double x, double left) {
    return {1000 + 0.6 * x - 0.8 * left, 2000 + 0.8 * x + 0.6 * left};
}

TEST(MeetSection, TracesThatCrossTheLine) {
    const std::vector<Point> trace = {on_map(20, 10), on_map(30, 5), on_map(42, -15)};
    const std::vector<double> heights = {100, 104, 120};
    const Outcrop outcrop = meet_section(section, trace, heights, plane(60, 10), 0);
    EXPECT_EQ(outcrop.how, Meeting::crosses);
    EXPECT_NEAR(outcrop.x, 33, 1e-9);  // a quarter of the second piece
    EXPECT_NEAR(*outcrop.elevation, 108, 1e-9);
    EXPECT_FALSE(outcrop.crosses_again);
    EXPECT_FALSE(meet_section(section, trace, {}, plane(60, 10), 0).elevation);

    // Of several crossings the first along the section counts, and a vertex on the line is one crossing.
    const std::vector<Point> wave = {on_map(70, 5), on_map(60, -5), on_map(20, 5), on_map(10, -5)};
    EXPECT_NEAR(meet_section(section, wave, {}, plane(60, 10), 0).x, 15, 1e-9);
    EXPECT_TRUE(meet_section(section, wave, {}, plane(60, 10), 0).crosses_again);
    const SectionLine east{{0, 0}, {50, 0}};
    const std::vector<Point> corner = {{8, 3}, {10, 0}, {9, -3}};
    EXPECT_EQ(meet_section(east, corner, {}, plane(60, 10), 0).x, 10);
    EXPECT_FALSE(meet_section(east, corner, {}, plane(60, 10), 0).crosses_again);
}

/// The ends of the section line are part of it, in spite of rounding.
TEST(MeetSection, TracesThroughTheEndsAndBeyond) {
    for (const double x : {0.0, 100.0}) {
        const std::vector<Point> through = {on_map(x, 5), on_map(x, -7)};
        const Outcrop outcrop = meet_section(section, through, {}, plane(60, 10), 0);
        EXPECT_EQ(outcrop.how, Meeting::crosses) << x;
        EXPECT_EQ(outcrop.x, std::clamp(outcrop.x, 0.0, section.length()));
        EXPECT_NEAR(outcrop.x, x, 1e-9);
    }
    for (const double x : {-0.1, 100.1}) {
        const std::vector<Point> beside = {on_map(x, 5), on_map(x, -7)};
        EXPECT_EQ(meet_section(section, beside, {}, plane(60, 10), 50).how, Meeting::beyond_ends) << x;
    }
}

/// A plane that strikes north meets a section eastwards where a line from its end northwards does.
TEST(MeetSection, ExtensionsAlongStrike) {
    const SectionLine east{{0, 0}, {50, 0}};
    const std::vector<Point> trace = {{10, 12}, {14, 4}};
    const std::vector<double> heights = {7, 9};
    for (const double direction : {90.0, 270.0}) {
        const Outcrop near = meet_section(east, trace, heights, plane(60, direction), 5);
        EXPECT_EQ(near.how, Meeting::extended);
        EXPECT_NEAR(near.x, 14, 1e-12);
        EXPECT_NEAR(near.distance, 4, 1e-12);
        EXPECT_EQ(*near.elevation, 9);
        EXPECT_EQ(meet_section(east, trace, {}, plane(60, direction), 3.9).how, Meeting::too_far);
        EXPECT_NEAR(meet_section(east, trace, {}, plane(60, direction), 0).distance, 4, 1e-12);
    }
    // Strike N 45 E: the nearer end is 4 sqrt 2 m from the line, along strike.
    const Outcrop oblique = meet_section(east, trace, {}, plane(60, 135), 6);
    EXPECT_EQ(oblique.how, Meeting::extended);
    EXPECT_NEAR(oblique.x, 10, 1e-12);
    EXPECT_NEAR(oblique.distance, 4 * std::numbers::sqrt2, 1e-12);
    // An end on the line needs no reach.
    const std::vector<Point> abutting = {on_map(20, 10), on_map(20, 0)};
    const auto how = meet_section(section, abutting, {}, plane(60, 30), 0).how;
    EXPECT_TRUE(how == Meeting::extended || how == Meeting::crosses);
}

TEST(MeetSection, PlanesAndLinesParallelToTheSection) {
    const SectionLine east{{0, 0}, {50, 0}};
    const std::vector<Point> beside = {{10, 2}, {40, 3}}, across = {{10, 2}, {12, -3}};
    // Strike eastwards: the extension never meets the line, but a winding trace may cross it.
    EXPECT_EQ(meet_section(east, beside, {}, plane(60, 180), 1e9).how, Meeting::parallel);
    EXPECT_EQ(meet_section(east, across, {}, plane(60, 180), 0).how, Meeting::crosses);
    // A vertical plane along the section has no trace in it.
    EXPECT_EQ(meet_section(east, across, {}, plane(90, 180), 1e9).how, Meeting::parallel);
    EXPECT_EQ(meet_section(east, across, {}, plane(90, 181), 1e9).how, Meeting::crosses);
}

/// The joint through the outcrop is where the section cuts the plane: each of its points satisfies the
/// plane's equation in space, n.(p - q) = 0 with the normal n = (sin d sin a, sin d cos a, cos d).
TEST(MeetSection, TheJointLiesInThePlane) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int trial = 0; trial < 500; ++trial) {
        const double azimuth = 2 * pi * unit(random);
        const SectionLine any{{500, 900}, {500 + 80 * std::sin(azimuth), 900 + 80 * std::cos(azimuth)}};
        const JointPlane joint{(1 + 88 * unit(random)) * degree, 2 * pi * unit(random)};
        const double nx = std::sin(joint.dip) * std::sin(joint.dip_direction),
                     ny = std::sin(joint.dip) * std::cos(joint.dip_direction), nz = std::cos(joint.dip);
        const Point q = any.at(80 * unit(random));
        // A trace along strike from q, on level ground, that stops short of the section line by up to 9 m.
        const double sx = ny / std::hypot(nx, ny), sy = -nx / std::hypot(nx, ny), gap = 9 * unit(random);
        const std::vector<Point> trace = {{q.x + (gap + 20) * sx, q.y + (gap + 20) * sy},
                                          {q.x + gap * sx, q.y + gap * sy}};
        const Outcrop outcrop = meet_section(any, trace, {}, joint, 10);
        if (std::abs(std::sin(joint.dip_direction - pi / 2 - azimuth)) < 1e-3) continue;
        ASSERT_EQ(outcrop.how, Meeting::extended) << trial;
        EXPECT_NEAR(outcrop.distance, gap, 1e-8);  // of coordinates of 1e3 m, along lines 1e-3 from parallel
        const double angle = apparent_angle(joint, any.azimuth());
        for (const double t : {-30.0, 40.0}) {
            const Point p = any.at(outcrop.x + t * std::cos(angle));
            EXPECT_NEAR(nx * (p.x - q.x) + ny * (p.y - q.y) + nz * t * std::sin(angle), 0, 1e-8) << trial;
        }
    }
}

}  // namespace
}  // namespace rockslope::blockgen::meet_section_test
