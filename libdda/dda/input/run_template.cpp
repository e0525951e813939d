#include "dda/input/read_run.hpp"

namespace rockslope::dda {

namespace {

constexpr const char* template_text =
    R"(# A run of dda-run. SI units; a number may carry a unit in quotes: "35 deg", "5 GPa", "0.3 g".
# Keys that are commented out show their default.

blocks = "slope.blocks"            # made by blockgen; --blocks overrides

[block_material.rock]              # one table for each block material of the block file
density = 2600                     # kg/m3
youngs_modulus = "5 GPa"
poissons_ratio = 0.25
# damping_ratio = 0.1              # of the strain modes of a block, fraction of critical
# initial_stress = [0, 0, 0]       # Pa: sx, sy, txy, tension positive

[joint_material.joint]             # one table for each joint material of the block file
law = "mohr-coulomb"
friction_angle = "35 deg"
# cohesion = 0                     # Pa
# tensile_strength = 0             # Pa
# residual_friction_angle = "35 deg"   # after the first slip or opening; default: friction_angle
# residual_cohesion = 0            # Pa
# normal_penalty = 0               # N/m per metre per contact; 0: the value of [analysis]
# shear_penalty = 0
# contact_damping = 0              # of the normal motion of contacts, fraction of critical: 0.2 gives a restitution of 0.57

# [joint_material.weld]            # a joint that neither opens nor slips
# law = "elastic"
# normal_stiffness = "100 GPa/m"   # of the joint, times the contact's length; replaces the penalties
# shear_stiffness = "40 GPa/m"     # default: normal_stiffness
# corner_length = 0.01             # m, smallest length of a contact in that product
# largest_closure = "0.2 mm"       # the joint closes along a hyperbola; normal_stiffness is its initial slope

# [joint_material.rough]           # a rough joint that is sheared one way
# law = "barton-bandis"
# residual_friction_angle = "34.6 deg"
# jrc = 12.8                       # joint roughness coefficient at peak, 0 to 20
# jcs = "151 MPa"                  # strength of the joint's walls
# peak_displacement = "1.25 mm"    # without it: constant peak roughness
# mobilisation = "barton-1985"     # or [[0, 1], [1, 1], [2, 0.5]]: displacement over peak displacement, fraction of jrc
# damage = 0                       # 1 to 2: the joint dilates; 0: it does not

# [joint_material.worn]            # a rough joint that is sheared to and fro
# law = "cyclic-barton-bandis"     # residual_friction_angle, jrc, jcs, damage as above
# residual_friction_angle = "1 deg"
# jrc = 3.98
# jcs = "80 MPa"
# peak_displacement = 0.164
# wear = [[0, 1], [1, 1], [2, 0.9], [20, 0.2]]   # fraction of jrc by displacement over peak displacement, both ways; or
#                                  [[joint_material.worn.cycle]] with a table for each branch: see the formats
# reversal_factor = 1              # on the ratios, for each change of the slip direction
# min_slip = 1e-4                  # m, slip in the other direction that counts as a change; choose it, see the guide
# heal = false                     # true: roughness worn off in an excursion returns in the next
# asymmetric = false               # true: roughness resists forward motion only
# floor_dilation = false           # true: the dilation never becomes negative
# contact_length = 0               # m, for the stress; 0: the contact's present length

# [joint_material.weakening]       # strength falls with slip in either direction
# law = "weakening"
# friction_angle = "35 deg"
# residual_friction_angle = "20 deg"   # default: friction_angle
# cohesion = 0
# residual_cohesion = 0
# weakening_slip = "5 mm"          # slip over which it falls
# weakening = "linear"             # or "exponential"

# [joint_material.racing]          # friction falls with the slip velocity and recovers at rest
# law = "velocity-weakening"
# friction_angle = "35 deg"        # at zero velocity
# residual_friction_angle = "20 deg"   # at high velocity; default: friction_angle
# weakening_speed = "0.1 m/s"
# weakening = "logarithmic"        # default: "exponential", without a weakening_rate
# weakening_rate = 0.02            # tan(friction) lost each time 1 + v/weakening_speed grows e-fold

# [joint_material.toothed]         # other laws of rough joints: "two-order-asperities", "stressed-asperities", "bilinear"
# law = "plesha"
# friction_angle = "30 deg"        # of the flat surface
# asperity_angle = "15 deg"        # of the unworn asperities
# wear = 0                         # m2/J, of that angle by plastic work

# [bolt_material.anchor]           # for bolts of the block file, per metre of section
# axial_stiffness = "100 MN"       # EA over the spacing
# pretension = 0                   # N
# yield_force = 0                  # N; 0: never yields

[analysis]
# plane = "strain"                 # or "stress"
# gravity = [0, -9.81]             # m/s2
# normal_penalty = "50 GPa"        # N/m per metre per contact; default: 10 times the largest Young's modulus
# penetration_tolerance = 0        # m; positive: contact forces are augmented until no penetration exceeds this
# shear_penalty = "50 GPa"         # default: normal_penalty
# fixed_point_penalty = "50 GPa"   # default: normal_penalty
# strength_reduction = 1           # joints' cohesion, tan(friction angle), tensile strength are divided by this
# default_joint_material = "joint" # for contacts of free faces; default: the first in this file
# solver = "multifrontal"          # or "refined": small systems, too; "simplicial": slower, to compare with
# lost_blocks = "keep"             # or "remove": blocks that have fallen below all fixed and prescribed blocks
# straight_corners = "keep"        # "drop": no contacts where another block's corner cuts a straight face

# [[point_load]]
# at = [10, 5]                     # m, or measured_point = "crest"
# force = [0, "-10 kN"]
# history = { times = [0, 1], values = [0, 1] }   # or { file = "history.csv" }

# [[body_load]]                    # an acceleration added to gravity, on all blocks or on the one at a point
# acceleration = ["0.1 g", 0]

# [[line_load]]                    # on the free faces along a line
# along = [[0, 0], [120, 0]]
# tolerance = 0.001                # m, of a face from the line
# pressure = "100 kPa"             # into the rock
# pressure_end = "100 kPa"         # at the line's end, linear between; default: pressure
# traction = [0, 0]                # Pa, in fixed directions
# traction_end = [0, 0]            # default: traction

# [[joint_water]]                  # one pressure in joints, on both faces
# pressure = "20 kPa"
# joint_material = "joint"         # default: all joints
# region = [[0, 0], [120, 0], [120, 70], [0, 70]]   # default: everywhere

# [[head_water]]                   # still water below a line, in joints and on free faces
# head = "section"                 # the slope model's water table; or [[0, 20], [60, 35], [120, 50]]
# unit_weight = 9810               # N/m3
# free_faces = true

# [[viscous_boundary]]             # free faces beyond which the rock is unbounded: they absorb waves
# name = "below"
# along = [[0, 0], [120, 0]]       # the faces on this line
# tolerance = 0.001                # m, of a face from the line
# normal_impedance = 0             # Pa s/m; 0: density times the speed of pressure waves
# shear_impedance = 0              # Pa s/m; 0: density times the speed of shear waves
# hold = "both"                    # in static stages; or "normal", "none"

# [[viscous_boundary]]             # an upright side with a free field: a column of rock whose waves rise from the base
# name = "left"
# along = [[0, 0], [0, 60]]
# free_field = "below"             # the viscous boundary at the base
# free_field_layer = 0             # m, largest height of the column's layers; 0: the faces'

# [[fixed_point]]
# at = [10, 5]
# direction = "both"               # or "x", "y"

# [[initial_velocity]]
# at = [10, 5]                     # or block = 3
# velocity = [1, 0]                # m/s
# angular_velocity = 0             # rad/s

# [[measured_joint]]               # a point of a joint whose displacements and stresses go to joints.csv
# name = "bedding"
# at = [12, 5]                     # a point of the joint
# tolerance = "1 mm"               # from the joint

# [[measured_region]]              # blocks whose displacement is reported together
# name = "face"
# polygon = [[0, 0], [120, 0], [120, 70], [0, 70]]   # with their centroid in it
# block_material = "rock"          # and, or instead, of this material

[[stage]]
name = "settle"
kind = "static"                    # runs until gravity is carried
# tolerance = 1e-6                 # unbalanced force over weight
# step_limit = 20000
# reset_displacements = true       # displacements are zeroed at the end of this stage
# reset_joint_history = false
# step = 0.005                     # s, the largest step; a static stage begins with less and grows where nothing moves
# displacement_limit = "2 m"       # static: a block that moves farther does not stop; default: 5 % of the model's height
# bonds_break = "at-rest"          # static: what cannot be held at rest, or "at-once": what slips on the way
# moving_share = 1e-4              # static: at rest when the blocks that move are this share of the mass, or less
# moving_blocks = "keep"           # or "remove": what becomes of them
# smallest_step = 1e-9
# cut = 0.3333333333333333         # factor on the step after a rejection
# growth = 1.3
# iteration_limit = 100            # open-close iterations in a step
# displacement_ratio = 0.01        # largest displacement in a step over the model's half-height
# force_tolerance = 1e-6
# mass_damping = 0                 # 1/s

# [[stage]]
# name = "factor of safety"
# kind = "strength-reduction"      # static trials with strengths divided by factors; keys of a static stage, and:
# factor_tolerance = 0.01          # width of the final bracket, a ratio
# lowest_factor = 0.1
# highest_factor = 10
# displacement_limit = "0.5 m"     # a block that moves farther has failed; default: 1 % of the model's height

[[stage]]
name = "shake"
kind = "dynamic"
duration = 10                      # s, or "record": until the end of the longest record
step = 0.005
# dynamic_coefficient = 1          # share of the velocity kept from step to step
# newmark_beta = 0.5               # (1/2, 1) is Shi's integration
# newmark_gamma = 1
# perturbation = 0                 # seed of a perturbation of the order of rounding, to see how far results depend on it

# [stage.stop]                     # the run ends here, with the status "collapsed"; in static stages, too
# displacement = "5 m"             # less that of relative_to
# region = "face"                  # a measured region, or point = "crest"; default: any free block
# share = 0                        # of the mass of the free blocks, that blocks beyond it must exceed
# relative_to = "base"             # as in [output]

# [stage.base_motion]              # moves the prescribed block of that name; without block: all prescribed blocks
# block = "base"
# way = "prescribed"               # or "body-force": bases stay, blocks have the opposite body acceleration
# delay = 0                        # s
# x = { file = "record.at2", scale = 1.0, baseline = "drift" }
# y = { file = "up.csv", format = "csv", channel = 1, quantity = "acceleration", unit = "cm/s2" }

# [[stage.incident_wave]]          # enters through a viscous boundary; default: all without a free field
# boundary = "below"
# delay = 0                        # s
# x = { times = [0, 0.1, 0.2], values = [0, 0.05, 0], scale = 1.0 }   # m/s; or { file = "velocity.csv" }

[output]
# frames = 200                     # frames over the dynamic stages
# static_frame_interval = 0        # steps between frames inside static stages; 0: none
# history_interval = 0.01          # s between rows of history.csv
# relative_to = "base"             # measured point or prescribed block; default: the first prescribed block
# slip_threshold = "0.1 mm"        # slip of a contact above which its blocks have slipped
# joint_frames = true              # frames of the contacts beside those of the blocks
# step_log = true                  # steps.csv
# save_stages = false              # save the state at each stage's end, for dda-run --from
# checkpoint_interval = 60         # s of wall time
)";

}  // namespace

std::string run_template() {
    return template_text;
}

}  // namespace rockslope::dda
