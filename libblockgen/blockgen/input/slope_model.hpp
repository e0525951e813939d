#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "blockgen/input/orientation.hpp"
#include "common/base/input_error.hpp"
#include "common/geometry/polygon.hpp"

namespace rockslope::blockgen {

/// A part of the section with a block material of its own; a later region lies over an earlier one.
struct Region {
    std::string name;
    std::string block_material;
    std::string joint_material;  ///< along its outline where no joint runs; may be empty
    Ring polygon;
    SourceLocation place;
};

/// A cavity: the rock inside its outline is taken away.
struct Tunnel {
    std::string name;
    Ring outline;
    SourceLocation place;
};

/// Rock that the run takes out when one of its stages begins. Until then it is rock like any other, cut along
/// the outline.
struct Excavation {
    std::string name;
    int stage = 1;  ///< of the run, counted from 1
    Ring outline;
    std::string joint_material;  ///< along its outline where no joint runs; may be empty
    SourceLocation place;
};

/// How the joints of a set lie to each other.
enum class SetKind {
    parallel,       ///< lines at given spacings, each of traces and rock bridges in turn
    baecher,        ///< traces anywhere, independent of each other (Baecher, Lanney and Einstein 1977)
    veneziano,      ///< lines anywhere, each of traces and rock bridges in turn (Veneziano 1978)
    cross_jointed,  ///< lines at given spacings that may end where they meet joints of another set
    voronoi         ///< edges of the cells that are nearest to points anywhere
};

/// When a set of joints that lie anywhere is complete.
struct StopRule {
    enum class Measure {
        none,
        p10,   ///< 1/m: joints met by a line across their mean direction
        p20,   ///< 1/m2: traces with their middle in the rock, per area
        p21,   ///< m/m2: length in the rock per area
        count  ///< traces with their middle in the rock; lines that meet it; cells
    };
    Measure measure = Measure::none;
    double target = 0;
};

/// A joint set, all lengths in m, angles in rad from the x axis, counter-clockwise positive. Which members
/// count depends on the kind.
struct JointSet {
    std::string name;
    SetKind kind = SetKind::parallel;
    std::string joint_material;
    Orientation orientation;
    Distribution spacing;                      ///< in the section, across the mean direction
    std::optional<Distribution> trace_length;  ///< absent: each joint crosses the whole domain
    std::optional<Distribution> gap;           ///< rock bridge between two traces of one line
    std::optional<Point> origin;               ///< a point of one joint; absent: the seed places the set
    StopRule stop;
    std::string ends_on;     ///< the set, or traces of a name, at which cross joints may end
    double termination = 1;  ///< probability of ending there, in [0, 1]
    double stagger = 0.5;    ///< a piece may lie aside of its line by up to this share of the spacing
    int relaxation = 0;      ///< times that Voronoi cells are centred on their points again (Lloyd 1982)
    std::string region;      ///< name of the region it is limited to; empty: everywhere
    SourceLocation place;
};

/// Joints given one by one.
struct Trace {
    std::string name;
    std::string joint_material;
    std::vector<Point> points;
};

/// Which blocks are meant: the one that holds a point, those whose centroid lies in a polygon, those that a
/// line runs through, or those along a side of the domain's bounding box. Exactly one is given.
struct BlockSelector {
    std::optional<Point> at;
    Ring inside;
    std::vector<Point> along;  ///< two points, or none
    std::string side;          ///< bottom, top, left or right
    bool prescribed = false;
    std::string name;
    SourceLocation place;
};

struct NamedPoint {
    std::string name;
    Point at;
    SourceLocation place;
};

struct BoltLine {
    std::string name;
    std::string material;
    Point from, to;
    SourceLocation place;
};

/// Gives the blocks that a line runs through a material of their own.
struct MaterialLine {
    std::string block_material;
    Point from, to;
    SourceLocation place;
};

/// What to do with blocks that another block encloses: let them fill a hole of it, prolong their joints to
/// its rim, make them part of it, or refuse.
enum class IslandPolicy { keep, cut, fill, error };

/// What to do with blocks that are too small or too slender.
enum class SmallBlockPolicy { keep, merge, drop };

struct SmallBlocks {
    SmallBlockPolicy policy = SmallBlockPolicy::keep;
    double below_area = 0;          ///< m2
    double below_roundness = 0.02;  ///< 4 pi area / perimeter^2, in [0, 1); the measure of a sliver
};

/// What the kinematic screen needs to know.
struct KinematicScreen {
    double friction_angle = 0;  ///< rad, of joints whose material is not in friction_of_material
    std::vector<std::string> fixed_sides = {"bottom", "left", "right"};
    std::map<std::string, double> friction_of_material = {};  ///< rad, per joint material
};

/// A slope as its model file describes it: geometry only, checked, in SI units.
struct SlopeModel {
    std::uint64_t seed = 0;
    double grid = 0x1p-20;  ///< m, a power of two: all vertices lie on multiples of it
    Ring outline;
    std::vector<Ring> further_outlines;  ///< of the domain's other parts; they may touch, but share no area
    std::vector<Ring> holes;
    std::string block_material;
    IslandPolicy islands = IslandPolicy::keep;
    SmallBlocks small_blocks;
    SourceLocation domain_location;
    std::vector<Region> regions;
    std::vector<Tunnel> tunnels;
    std::vector<Excavation> excavations;
    std::vector<JointSet> joint_sets;
    std::vector<Trace> traces;
    std::vector<BlockSelector> selectors;
    std::vector<NamedPoint> measured_points;
    std::vector<BoltLine> bolts;
    std::vector<MaterialLine> material_lines;
    bool outline_of_traces = false;  ///< the outline follows from traces, so that some run along it
    std::vector<std::string> notes;  ///< warnings from the reading
    std::optional<KinematicScreen> kinematics;
    std::vector<std::filesystem::path> files;  ///< read besides the model file itself
};

}  // namespace rockslope::blockgen
