#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "blockgen/input/coordinate_system.hpp"
#include "blockgen/input/orientation.hpp"
#include "blockgen/input/section_line.hpp"
#include "common/base/input_error.hpp"
#include "common/geometry/polygon.hpp"

namespace rockslope::blockgen {

/// A part of the section with its own block material. A later region overrides an earlier one.
struct Region {
    std::string name;
    std::string block_material;  ///< empty: that of the rock it lies over
    std::string joint_material;  ///< along its outline where no joint runs; may be empty
    Ring polygon;                ///< may touch itself along lines without width
    SourceLocation place;
    const char* kind = "region";  ///< what messages call it: region, layer, weathered zone
};

/// A cavity: there is no rock inside its outline.
struct Tunnel {
    std::string name;
    Ring outline;
    SourceLocation place;
};

/// Rock that the simulation removes at the start of a stage. Blocks are cut along its outline.
struct Excavation {
    std::string name;
    int stage = 1;  ///< stage of the simulation, counted from 1
    Ring outline;
    std::string joint_material;  ///< along its outline where no joint runs; may be empty
    SourceLocation place;
};

/// The model by which the joints of a set are sampled.
enum class SetKind {
    parallel,       ///< lines at given spacings, of alternating traces and rock bridges
    baecher,        ///< independent traces at random positions (Baecher, Lanney and Einstein 1977)
    veneziano,      ///< random lines of alternating traces and rock bridges (Veneziano 1978)
    cross_jointed,  ///< lines at given spacings that may end at joints of another set
    voronoi         ///< edges of the Voronoi cells of random points
};

/// The stop rule of a set of randomly placed joints: sampling ends when the measure reaches its target.
struct StopRule {
    enum class Measure {
        none,
        p10,   ///< 1/m: joints per length of a scanline perpendicular to their mean direction
        p20,   ///< 1/m2: traces with their midpoint in the rock, per area
        p21,   ///< m/m2: trace length in the rock, per area
        count  ///< number of traces with their midpoint in the rock, of lines that meet it, or of cells
    };
    Measure measure = Measure::none;
    double target = 0;
};

/// A joint set. Lengths in m, angles in rad from the x axis, counter-clockwise positive. The kind determines
/// which members are used.
struct JointSet {
    std::string name;
    SetKind kind = SetKind::parallel;
    std::string joint_material;
    Orientation orientation;
    Distribution spacing;                      ///< in the section, perpendicular to the mean direction
    std::optional<Distribution> trace_length;  ///< absent: each joint crosses the whole domain
    std::optional<Distribution> gap;           ///< rock bridge between two traces of one line
    std::optional<Point> origin;               ///< a point of one joint; absent: drawn at random
    StopRule stop;
    std::string ends_on;     ///< name of the set or traces at which cross joints may end
    double termination = 1;  ///< probability of ending there, in [0, 1]
    double stagger = 0.5;    ///< largest lateral offset of a piece from its line, fraction of the spacing
    int relaxation = 0;      ///< number of relaxations of the Voronoi cells (Lloyd 1982)
    std::string region;      ///< name of the region that limits the set; empty: the whole domain
    std::string
        conditioned_on;  ///< name of mapped traces of the set, which the sampled ones add to; or empty
    Ring mapped_area;    ///< where the mapped traces are all there are; empty: nowhere
    SourceLocation place;
};

/// A joint as a polyline, given or sampled.
struct Trace {
    std::string name;
    std::string joint_material;
    std::vector<Point> points;
    /// Number by which SetSampler draws its direction or plane; nothing for given traces and Voronoi edges.
    std::optional<std::int64_t> draw = std::nullopt;
};

/// An end of a given trace, and what it was joined to or stops short of.
struct NearEnd {
    Point at;           ///< where it lies now
    double gap = 0;     ///< m, by which it moved, or by which it stops short
    std::string joint;  ///< name of its trace
    std::string other;  ///< name of the other trace, or "outline"
};

/// What became of the ends of the given traces.
struct TraceEnds {
    std::vector<NearEnd> joined;       ///< moved to another end, trace or outline
    std::vector<NearEnd> near_misses;  ///< stop short of something by `reach` or less
    double reach = 0;                  ///< m
    double suggested_snap = 0;  ///< m, which would join these; 0: they are hardly more than chance explains
};

/// Selects fixed or prescribed blocks by exactly one of: a point inside the block, a polygon that contains
/// their centroids, a line through the blocks, or a side of the domain's bounding box along which they lie.
struct BlockSelector {
    std::optional<Point> at;
    Ring inside;
    std::vector<Point> along;  ///< two points, or none
    std::string side;          ///< bottom, top, left or right
    bool prescribed = false;
    std::string name;
    SourceLocation place;
};

/// A block below and behind the slope, on which it stands.
struct BaseBlock {
    std::string name;
    std::string block_material;
    std::string joint_material;  ///< of its contact with the slope
    bool is_fixed = false;       ///< rather than prescribed
    Ring outline;
    std::vector<Point>
        contact;   ///< the part of the slope's outline along which they touch, from left to right
    Point inside;  ///< a point of the base
    SourceLocation place;
};

struct NamedPoint {
    std::string name;
    Point at;
    SourceLocation place;
};

/// A line along which joints are counted.
struct Scanline {
    std::string name;
    Point from, to;
    double sound_length = 0.1;  ///< m; longer pieces between joints count for the rock quality designation
};

struct BoltLine {
    std::string name;
    std::string material;
    Point from, to;
    SourceLocation place;
};

/// Assigns a material to the blocks that a line runs through.
struct MaterialLine {
    std::string block_material;
    Point from, to;
    SourceLocation place;
};

/// What to do with islands, blocks that another block encloses: keep them in a hole of that block, extend
/// their joints to its boundary, merge them with it, or report an error.
enum class IslandPolicy { keep, cut, fill, error };

/// What to do with blocks that are too small or too slender.
enum class SmallBlockPolicy { keep, merge, drop };

struct SmallBlocks {
    SmallBlockPolicy policy = SmallBlockPolicy::keep;
    double below_area = 0;          ///< m2
    double below_roundness = 0.02;  ///< 4 pi area / perimeter^2, in [0, 1); a block below it is a sliver
    double below_share = 0;         ///< of the median area of all blocks
    bool merges_slivers = true;     ///< whether slivers count as small
};

/// Settings of the kinematic screen.
struct KinematicScreen {
    double friction_angle = 0;  ///< rad, for joint materials that are not in friction_of_material
    std::vector<std::string> fixed_sides = {"bottom", "left", "right"};
    std::map<std::string, double> friction_of_material = {};  ///< rad, per joint material
};

/// A slope as its model file describes it: geometry only, checked, in SI units.
struct SlopeModel {
    std::uint64_t seed = 0;
    double grid = 0x1p-20;  ///< m, grid step, a power of two: vertex coordinates are multiples of it
    Ring outline;
    std::vector<Ring> further_outlines;  ///< of further parts of the domain; they may touch but not overlap
    std::vector<Ring> holes;
    std::string block_material;
    IslandPolicy islands = IslandPolicy::keep;
    SmallBlocks small_blocks;
    CoordinateSystem project;  ///< to which the coordinates of files are converted
    CoordinateSystem system;   ///< without `project`: that of the files which state one
    std::string system_file;   ///< the first of these files
    std::optional<Section> section;
    SourceLocation domain_location;
    SourceLocation outlines_location;  ///< of the key that gives the parts of the domain
    SourceLocation holes_location;     ///< of the key that gives the last hole
    std::vector<Region> regions;
    std::vector<Tunnel> tunnels;
    std::vector<Excavation> excavations;
    std::vector<JointSet> joint_sets;
    std::vector<Trace> traces;
    std::vector<std::string> repeated_names;  ///< of traces that all repeat earlier ones and are dropped
    TraceEnds trace_ends;
    std::optional<BaseBlock> base;
    double unjointed_area =
        0;  ///< m2 of the domain in which no joints are asked for: the base, once it is part of it
    std::vector<BlockSelector> selectors;
    std::vector<NamedPoint> measured_points;
    std::vector<BoltLine> bolts;
    std::vector<Scanline> scanlines;
    std::vector<Point> water_table;  ///< x growing; level beyond its ends; empty: none
    std::vector<MaterialLine> material_lines;
    bool outline_of_traces = false;  ///< the outline was computed from traces, so some traces run along it
    std::vector<std::string> notes;  ///< warnings of the reader
    std::optional<KinematicScreen> kinematics;
    std::vector<std::filesystem::path> files;  ///< files read in addition to the model file
};

}  // namespace rockslope::blockgen
