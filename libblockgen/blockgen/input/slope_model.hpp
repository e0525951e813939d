#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "blockgen/base/input_error.hpp"
#include "blockgen/input/distribution.hpp"
#include "blockgen/mesh/polygon.hpp"

namespace blockgen {

/// A part of the section with a block material of its own; a later region lies over an earlier one.
struct Region {
    std::string name;
    std::string block_material;
    std::string joint_material;  ///< along its outline where no joint runs; may be empty
    Ring polygon;
    SourcePlace place;
};

/// A cavity: the rock inside its outline is taken away.
struct Tunnel {
    std::string name;
    Ring outline;
    SourcePlace place;
};

/// Parallel joints, all lengths in m, angles in rad from the x axis, counter-clockwise positive.
struct JointSet {
    std::string name;
    std::string joint_material;
    Distribution angle;
    Distribution spacing;
    std::optional<Distribution> trace_length;  ///< absent: each joint crosses the whole domain
    std::optional<Distribution> gap;           ///< rock bridge between two traces of one line
    std::optional<Point> origin;               ///< a point of one joint; absent: the seed places the set
    std::string region;                        ///< name of the region it is limited to; empty: everywhere
    SourcePlace place;
};

/// Joints given one by one.
struct Trace {
    std::string name;
    std::string joint_material;
    std::vector<Point> points;
};

/// Which blocks are meant: the one that holds a point, those whose centroid lies in a polygon, or those along
/// a side of the domain's bounding box. Exactly one is given.
struct BlockSelector {
    std::optional<Point> at;
    Ring inside;
    std::string side;  ///< bottom, top, left or right
    bool prescribed = false;
    std::string name;
    SourcePlace place;
};

struct NamedPoint {
    std::string name;
    Point at;
    SourcePlace place;
};

struct BoltLine {
    std::string name;
    std::string material;
    Point from, to;
    SourcePlace place;
};

/// What to do with blocks that another block encloses: let them fill a hole of it, prolong their joints to
/// its rim, make them part of it, or refuse.
enum class IslandPolicy { keep, cut, fill, error };

/// What to do with blocks that are too small or too slender.
enum class SmallPolicy { keep, merge, drop };

struct SmallBlocks {
    SmallPolicy policy = SmallPolicy::keep;
    double below_area = 0;          ///< m2
    double below_roundness = 0.02;  ///< 4 pi area / perimeter^2, in [0, 1); the measure of a sliver
};

/// A slope as its model file describes it: geometry only, checked, in SI units.
struct SlopeModel {
    std::uint64_t seed = 0;
    double grid = 0x1p-20;  ///< m, a power of two: all vertices lie on multiples of it
    Ring outline;
    std::vector<Ring> holes;
    std::string block_material;
    IslandPolicy islands = IslandPolicy::keep;
    SmallBlocks small_blocks;
    SourcePlace domain_place;
    std::vector<Region> regions;
    std::vector<Tunnel> tunnels;
    std::vector<JointSet> joint_sets;
    std::vector<Trace> traces;
    std::vector<BlockSelector> selectors;
    std::vector<NamedPoint> measured_points;
    std::vector<BoltLine> bolts;
    std::vector<std::filesystem::path> files;  ///< read besides the model file itself
};

}  // namespace blockgen
