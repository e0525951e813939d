#include "blockgen/input/read_slope_model.hpp"

#include "blockgen/input/read_geology.hpp"
#include "blockgen/input/read_shapes.hpp"

namespace rockslope::blockgen {

namespace {

constexpr const char* template_text =
    R"(# A slope for blockgen. Lengths in metres, or with a unit: "5 mm", "2 km". Angles need a unit: "35 deg".
# They are measured from the x axis, counter-clockwise positive. Lines that start with '#' show optional keys.

seed = 42                                  # seed of all random draws; the same seed gives the same blocks

[domain]
outline = [[0, 0], [120, 0], [120, 30], [60, 70], [0, 70]]
# outlines = [[[0, 0], ...], [[90, 0], ...]]   # instead: a domain of several parts
# outline_file = "profile.csv"             # instead: columns x,y; or .geojson, .dxf, .shp, .gpkg
# profile_file = "ground.csv"              # instead: the ground, columns distance,elevation; a line of a map file; or a raster
                                           # of elevations, which needs [section] from and to
# depth = 20                               # m of rock below the lowest point of the profile; or bottom, an elevation
# profile_step = 2                         # m, between two samples of a raster; absent: one cell
# simplify = "10 cm"                       # leaves out points of the profile that are not needed to keep this close to it
# project = "EPSG:32634"                   # the coordinates of files are converted to this system
# geo_file = "old.geo"                     # instead: a line file of Shi's programs
# holes = [[[10, 10], [14, 10], [12, 14]]]
block_material = "sandstone"
# grid = 9.5367431640625e-7                # m, a power of two: joints nearer to each other than this are joined
# snap = "1 cm"                            # ends of [[traces]] within it of another trace or an outline are joined
# islands = "keep"                         # blocks enclosed by one block; or "cut" to its boundary, "fill", "error"

# [small_blocks]                           # absent: blocks below 1e-4 of the median area are merged
# policy = "merge"                         # across the longest boundary; or "drop" a piece of the shortest joint; "keep"
# below_area = 0.01                        # m2
# below_share = 1e-4                       # of the median area of the blocks
# below_roundness = 0.02                   # 4 pi area / perimeter^2

# [[layer]]                                # from the highest to the lowest, each down to the next one's top
# name = "shale"
# block_material = "shale"
# joint_material = "contact"               # of its top, where no joint runs
# top = [[0, 30], [60, 24], [120, 10]]     # level beyond its ends; or top_file = "top.csv"

# [weathered]                              # the rock within a depth below the ground surface; also [[weathered]]
# name = "weathered"
# depth = 4                                # m, vertical
# block_material = "weathered rock"        # absent: that of the rock it lies in
# joint_material = "contact"               # of its base, where no joint runs

# [[region]]                               # overrides what lies below it, inside its polygon
# name = "dyke"
# block_material = "basalt"
# joint_material = "dyke contact"          # along its outline where no joint runs
# polygon = [[40, 0], [44, 0], [44, 70], [40, 70]]

# [[tunnel]]
# shape = "circle"                         # or "horseshoe" (floor, width, height), "polygon" (polygon)
# centre = [40, 20]
# radius = 3
# segments = 32
# stage = 2                                # stage of the run at whose start the rock is removed; absent: no rock from the start

# [[excavation]]                           # rock until its stage starts; shapes as for tunnels
# stage = 2
# joint_material = "bedding"               # along its outline where no joint runs
# shape = "polygon"
# polygon = [[100, 0], [120, 0], [120, 30], [100, 30]]

[[joint_set]]
name = "bedding"
joint_material = "bedding"
angle = "-25 deg"
spacing = { law = "lognormal", mean = 3.0, sd = 0.6, min = 1.0, max = 8.0 }
# angle, spacing, trace_length and gap are numbers or distributions truncated to [min, max]. Laws: constant (value),
# uniform (min, max), normal, lognormal, gamma (mean, sd), exponential (mean), weibull (mean, shape), power (exponent,
# min, max).

[[joint_set]]
name = "cross joints"
joint_material = "cross joints"
angle = "65 deg"
spacing = 4
trace_length = { law = "exponential", mean = 20, min = 2 }   # absent: each joint crosses the whole domain
gap = 1.0                                  # rock bridge; or persistence = 0.9
# origin = [0, 0]                          # a point of one joint; absent: the seed places the set
# region = "weathered"                     # only in this region, layer or weathered zone

# [section]
# azimuth = "90 deg"                       # of the x axis, clockwise from north: for sets given as planes in space
# from = [465980, 6691570]                 # instead: the vertical plane through two points of the map, in m; x is 0 at
# to = [466040, 6691570]                   # `from`, and the azimuth that of the line, clockwise from grid north

# [[joint_set]]                            # random traces; or kind = "veneziano": random lines of traces and rock bridges
# name = "random"
# kind = "baecher"
# dip = "60 deg"                           # instead of angle; or orientations = [["60 deg", "120 deg"]],
# dip_direction = "120 deg"                # or orientation_file = "readings.csv" (dip,dip_direction in degrees)
# fisher_k = 100                           # scatter of the planes; absent: none
# weighting = "section"                    # planes are drawn as often as the section meets them; absent: as they are
# trace_length = { law = "lognormal", mean = 6, sd = 3 }
# p21 = 0.4                                # m/m2; or p20 (1/m2), p10 (1/m), count
# conditioned_on = "faults"                # [[traces]] of that name count as joints of the set
# mapped_area = [[0, 0], ...]              # where they are all there are: the rest gets the density

# [[joint_set]]
# name = "cross"
# kind = "cross-jointed"
# ends_on = "bedding"
# angle = "65 deg"
# spacing = 3
# termination = 1                          # probability of ending at a joint of that set
# stagger = 0.5                            # largest lateral offset of the next piece, as a fraction of the spacing

# [[joint_set]]
# name = "columns"
# kind = "voronoi"
# count = 200
# relaxation = 3

# [[traces]]                               # joints one by one
# joint_material = "fault"
# points = [[10, 0], [40, 70]]             # or file = "faults.csv" (x1,y1,x2,y2[,joint_material]), .geojson, .dxf, ...
# on = "map"                               # traces on the map, whose planes the section cuts: needs [section] from and to
# dip = "60 deg"                           # unless the file has fields dip and dip_direction, in degrees
# dip_direction = "120 deg"
# reach = 5                                # m, by which a trace may stop short of the section line, along strike
# trace_length = 20                        # m, from the outcrop down dip and up; absent: through the whole domain
# elevation = "ground"                     # or "trace": that of the outcrop

# [base]                                   # instead of [[prescribed_block]]: a block round the slope, of another rock
# below = 12                               # m
# behind = 20                              # m, at the side of the crest; ahead: at that of the toe
# material = "bedrock"

[[fixed_block]]
side = "bottom"                            # or at = [x, y], or inside = polygon

# [[prescribed_block]]                     # moves as a motion record prescribes
# name = "base"
# at = [60, 2]

# [kinematics]                             # screen for removable blocks, in the report and --kinematic-picture
# friction_angle = "30 deg"
# fixed_sides = ["bottom", "left", "right"]
# [kinematics.friction_angles]             # joint materials with other angles
# bedding = "25 deg"

[[measured_point]]
name = "crest"
at = [59, 69]

# [water_table]                            # drawn, and the default of [[head_water]] in the run
# line = [[0, 50], [60, 38], [120, 28]]    # level beyond its ends; or line_file = "water.csv"

# [[scanline]]                             # joints along it are counted, in the report
# name = "borehole 1"
# from = [40, 60]
# to = [40, 5]
# sound_length = "10 cm"                   # longer pieces count for the RQD

# [[bolt]]
# name = "anchor 1"
# material = "cable"
# from = [80, 56]
# to = [70, 50]
)";

}  // namespace

SlopeModel read_slope_model(const ConfigTable& root, const EnclosedAreaFunction& enclosed_area) {
    SlopeModel model;
    const std::int64_t seed = root.integer("seed", 0);
    if (seed < 0) root.fail("seed", "a negative seed", "an integer of zero or more");
    model.seed = static_cast<std::uint64_t>(seed);
    read_domain(root, enclosed_area, model);
    read_layers(root, model);
    read_weathered_zones(root, model);
    read_regions(root, model);
    read_tunnels(root, model);
    read_base(root, enclosed_area, model);
    read_joints(root, model);
    read_block_assignments(root, model);
    read_water_table(root, model);
    root.finish();
    return model;
}

std::string slope_model_template() {
    return template_text;
}

}  // namespace rockslope::blockgen
