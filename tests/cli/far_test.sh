#!/bin/sh
# A model with coordinates of a national grid moves exactly as the same model near the origin, and can be drawn.
#   far_test.sh BIN_FOLDER
set -eu
bin=$1
# shellcheck source=tests/cli/common.sh
. "$(dirname "$0")/common.sh"
# wedge X Y FOLDER: runs two blocks on a prescribed base; the centre of the model is (X, Y), whole metres.
wedge() {
    awk -v x="$1" -v y="$2" 'function p(a, b) { return sprintf("[%.10g, %.10g]", a + x, b + y) }
        BEGIN {
            print "[domain]"
            print "outline = [" p(-8, -4) ", " p(8, -4) ", " p(8, -3) ", " p(-8, 4) "]"
            print "block_material = \"rock\""
            print "[[traces]]\njoint_material = \"plane\""
            print "points = [" p(-8, 1.25) ", " p(8, -3.5) "]"
            print "[[traces]]\njoint_material = \"plane\""
            print "points = [" p(-1.375, 4) ", " p(1.25, -4) "]"
            print "[[prescribed_block]]\nname = \"base\"\nat = " p(-4, -3)
            print "[[prescribed_block]]\nname = \"base\"\nat = " p(4, -3.75)
            print "[[measured_point]]\nname = \"top\"\nat = " p(-6, 2)
        }' >model.toml
    awk -v x="$1" -v y="$2" 'BEGIN {
            print "blocks = \"model.blocks\""
            print "[block_material.rock]\ndensity = 2600\nyoungs_modulus = \"5 GPa\"\npoissons_ratio = 0.25"
            print "[joint_material.plane]\nlaw = \"mohr-coulomb\"\nfriction_angle = \"25 deg\""
            printf "[[point_load]]\nat = [%.10g, %.10g]\nforce = [1e4, 0]\n", x - 6, y + 2
            print "[[stage]]\nname = \"settle\"\nkind = \"static\"\ntolerance = 1e-6"
            print "[[stage]]\nname = \"shake\"\nkind = \"dynamic\"\nduration = 0.5"
            print "[stage.base_motion]\nx = { times = [0, 0.1, 0.3, 0.5], values = [0, 5, -5, 0] }"
            print "[output]\nname = \"wedge\"\nframes = 2\nhistory_interval = 0"
        }' >run.toml
    "$bin/blockgen" model.toml -o model.blocks >/dev/null
    "$bin/dda-run" run.toml -o "$3" >log.txt 2>&1 || fail "at ($1, $2): $(cat log.txt)"
}

wedge 0 0 near
wedge 512345 6690123 far
[ "$(wc -l <near/history.csv)" -gt 100 ] || fail "the run is too short to show anything"
cmp near/history.csv far/history.csv || fail "distance changes the motion"
cmp near/steps.csv far/steps.csv || fail "distance changes the steps"
"$bin/dda-plot" far --frames last --format svg >/dev/null || fail "the frame cannot be drawn"
