#include "study/plan/plan.hpp"

namespace rockslope::study {

namespace {

const char* const commented_plan =
    R"plan(# A plan of dda-study. SI units; a number may carry a unit in quotes. Paths are relative to this file.
# Keys that are commented out show their default, or what else there is.

slope = "slope.toml"               # cut by blockgen; or blocks = "slope.blocks" for all rows
run = "run.toml"                   # simulated by dda-run
# set = ["run:output.frames=10"]   # overrides of all rows: slope:KEY=VALUE or run:KEY=VALUE, as for --set
# replicates = 1                   # runs of each row; from the second on with a perturbation of the order of rounding
# row_time = "2 min"               # expected wall time of a row, for Slurm, until rows are done

[design]
kind = "full"                      # all combinations; or "latin-hypercube", "sobol", "monte-carlo" with samples,
                                   # "incremental", "morris", "one-at-a-time"
# samples = 64                     # rows of the three sampled designs
# seed = 1                         # of the random draws of the design
# indices = false                  # "sobol": (factors + 2) * samples rows, for Sobol' indices
# trajectories = 10                # "morris"
# levels = 4                       # "morris", even
# intensity = "PGA"                # "incremental": the factor whose values rise until the measure is beyond the limit
# measure = "crest"
# limit = 0.05

[[factor]]
name = "realisation"
key = "slope:seed"                 # or keys = [...]; slope:KEY or run:KEY, with the path of --set
range = { from = 1, to = 8 }       # whole numbers; or with step or count, or continuous = true for sampled designs

[[factor]]
name = "record"
key = "run:stage[1].base_motion.x.file"
files = "records/*.at2"            # or a list of patterns

[[factor]]
name = "PGA"
scale = "PGA"                      # scales the records of a factor: "PGA", "PGV", "Arias" or "Sa(0.5)", period in s
record = "record"
values = ["0.1 g", "0.2 g", "0.4 g"]

# [[factor]]
# name = "friction"
# key = "run:joint_material.bedding.friction_angle"
# unit = "deg"                     # of the numbers of a range or a distribution
# distribution = { law = "normal", mean = 34, sd = 2, min = 28, max = 40 }   # as in joint sets; sampled designs
# values = ["30 deg", "34 deg"]    # or a list
# pair = "record"                  # goes with the values of an earlier factor, one by one

[[measure]]
name = "crest"
# kind = "displacement"            # or "moved-volume", "front", "run-out", "travel-angle", "deposit-thickness" (with limit),
                                   # "deposit-height" (with x or width), "surface" (with x), "first-slip", "factor-of-safety"
point = "crest"                    # or region = "face"; neither: the farthest block
# at = "end"                       # or "peak"
# of = "mean"                      # of a region's blocks, or "largest"
# limit = 0.5                      # m, of moved blocks
# x = 120                          # m, station of a surface or a deposit; without it the largest of all x
# width = 2                        # m, of a deposit's height without x: the largest mean over such a stretch

# [[fragility]]                    # curves of the report
# measure = "crest"
# intensity = "PGA"                # a column of the results
# limit = 0.05
# method = "outcomes"              # or "demands"

# [profile]                        # the surface of each row at its end, over stations of x: profiles.csv
# interval = "1 m"
# limit = "0.5 m"                  # of moved blocks

[output]                           # what each row writes, besides its summary and its table of blocks
# frames = 0                       # besides both ends of every stage
# joint_frames = false
# step_log = false
# history_interval = 0.1           # s
)plan";

}  // namespace

std::string plan_template() {
    return commented_plan;
}

}  // namespace rockslope::study
