#!/bin/sh
# data/granite-shear and data/seismic-sliding run by make as a user would. Blocks under cyclic shear follow their joint law
# row by row, also across reversals; blocks on a joint that wears slide.
#   shear_box_test.sh BIN DATA
set -eu
bin=$1
data=$2
# shellcheck source=tests/cli/common.sh
. "$(dirname "$0")/common.sh"
cp -r "$data/granite-shear" "$data/seismic-sliding" "$data/rules.mk" "$data/shear-box.mk" "$folder"

cd "$folder/granite-shear"
rm -rf out pictures slope.blocks* law.toml
make --no-print-directory BIN="$bin" >log 2>&1 || { cat log >&2; fail "make in granite-shear"; }
[ -s pictures/shear.png ] || fail "no picture of the shear test"
[ -s pictures/joint-joint.png ] || fail "no picture of the measured joint"
ls pictures/granite.roughness-*.png >/dev/null || fail "no picture of the roughness"
# Required of the blocks: 0.5 % of the peak of 1.9202 MPa, and 5 um.
awk '/^misfit of shear stress/ { stress = $9 } /^misfit of dilation/ { dilation = $8 }
    END { exit !(stress > 0 && stress < 0.005 * 1.9202 && dilation > 0 && dilation < 0.005) }' log ||
    fail "the blocks do not follow the law: $(grep misfit log)"
# Two cycles with four changes of direction, in all six branches.
tail -n 1 out/joints.csv | grep -q ',4,2,[^,]*,[^,]*$' || fail "reversals and cycle: $(tail -n 1 out/joints.csv)"
for stage in forward backward; do
    for phase in advance unloading return; do
        grep -q ",$stage $phase," out/joints.csv || fail "no $stage $phase"
    done
done

cd "$folder/seismic-sliding"
rm -rf out even soft soft-even sensitivity reversals pictures slope.blocks* motion-*.csv
make --no-print-directory BIN="$bin" >log 2>&1 || { cat log >&2; fail "make in seismic-sliding"; }
for motion in a c; do
    [ -s "pictures/motion-$motion/joint-plane.png" ] || fail "no picture of motion $motion"
done
# Rigid blocks: 13.945 m within 10 % after 16 changes of direction; 0.4411 m within 3 % with constant strength.
awk -F, 'END { exit !($3 > 0.9 * 13.945 && $3 < 1.1 * 13.945 && $12 == 16) }' out/joints.csv ||
    fail "motion A, wearing: $(tail -n 1 out/joints.csv)"
awk -F, 'END { exit !($3 > 0.97 * 0.4411 && $3 < 1.03 * 0.4411) }' even/joints.csv ||
    fail "motion A, 8 deg: $(tail -n 1 even/joints.csv)"

cd "$folder/seismic-sliding"
refused() {
    expected=$1
    shift
    run_refused "$expected" "$bin/dda-plot" "$@"
}
refused "no column 'plan displacement" out even --joint plan -o elsewhere
refused 'reference is given without' out --reference motion-a.csv
refused 'one: dda-plot OUT' out even
[ ! -e elsewhere ] || fail "a refused call left a folder"
"$bin/dda-plot" out --joint plane --reference /dev/stdin -o beside --format svg <<END
time (s),displacement (m)
0,0
25,13.945
END
"$bin/dda-plot" out --joint plane -o alone --format svg
cmp -s alone/joint-plane.svg beside/joint-plane.svg && fail "the reference is not drawn"
exit 0
