#!/bin/sh
# data/incline run by make as a user would: which programs run after which edit, identical bytes when repeated, and the slip
# of Newmark's sliding block.
#   incline_test.sh BIN DATA
set -eu
bin=$1
data=$2
# shellcheck source=tests/cli/common.sh
. "$(dirname "$0")/common.sh"
cp -r "$data/incline" "$data/rules.mk" "$folder"
cd "$folder/incline"
rm -rf out pictures slope.blocks*

run() {
    make --no-print-directory BIN="$bin" run "$@" >log 2>&1 || { cat log >&2; fail "make run $*"; }
}

# expect PROGRAM yes|no REASON: checks whether the last make called the program.
expect() {
    called=no
    grep -q "/$1 " log && called=yes
    [ "$called" = "$2" ] || fail "$1 called: $called, expected: $2 ($3)"
}

run
expect blockgen yes "first make"
expect dda-run yes "first make"
cp -r out first

run
expect blockgen no "nothing changed"
expect dda-run no "nothing changed"

sleep 1 # make compares file times, which some file systems store in whole seconds
sed -i 's/friction_angle = "25 deg"/friction_angle = "26 deg"/' run.toml
run
expect blockgen no "strength changed"
expect dda-run yes "strength changed"
cmp -s out/history.csv first/history.csv && fail "the strength has no effect"
sed -i 's/friction_angle = "26 deg"/friction_angle = "25 deg"/' run.toml

run RUN_FLAGS="--set joint_material.plane.friction_angle='25 deg'"
expect blockgen no "flags changed"
expect dda-run yes "flags changed"

sleep 1
sed -i 's/^outline/# the joints or the outline changed\noutline/' slope.toml
run
expect blockgen yes "geometry changed"
expect dda-run yes "geometry changed"

for file in history.csv steps.csv incline.vtkhdf incline.joints.vtkhdf; do
    cmp "out/$file" "first/$file" || fail "$file differs between two runs of the same input"
done

# A run that fails is never up to date, and says why. It is tried again.
for attempt in first second; do
    code=0
    make --no-print-directory BIN="$bin" OUT=failing run RUN_FLAGS="--set stage[0].step_limit=1" >log 2>&1 || code=$?
    [ "$code" -eq 2 ] || fail "exit code $code of make, $attempt time"
    expect dda-run yes "the run failed, $attempt time"
    grep -q 'does not settle' log || fail "no reason: $(cat log)"
    [ ! -e failing/summary.json ] || fail "a target is left after a failure"
done

# A run that is killed together with make goes on from its checkpoint.
long="--set stage[1].duration=300 --set output.checkpoint_interval=1e-3"
killed=$folder/incline/killed
make --no-print-directory BIN="$bin" OUT="$killed" run RUN_FLAGS="$long" >log 2>&1 &
pid=$!
while [ ! -s killed/checkpoint.h5 ]; do sleep 0.01; done
kill -9 "$pid"
kill_all_with "-o $killed"
[ ! -e killed/summary.json ] || fail "the run was over before it was killed"
cp killed/steps.csv before
run OUT="$killed" RUN_FLAGS="$long"
head -c "$(wc -c <before)" killed/steps.csv | cmp -s - before || fail "a killed run begins anew"
grep -q 'begins anew' log && fail "the checkpoint is refused: $(cat log)"

# Under make -j a run takes one thread unless told otherwise.
make --no-print-directory BIN="$bin" OUT=threads -j2 -n run | grep -q -e '--threads 1' || fail "more threads under make -j"
make --no-print-directory BIN="$bin" OUT=threads -j2 -n run THREADS=2 | grep -q -e '--threads 2' || fail "THREADS is ignored"
make --no-print-directory BIN="$bin" OUT=threads -n run | grep -q -e --threads && fail "one thread without make -j"

# The slip is the displacement of the block relative to the base. Newmark's equation for this base motion, a slope of
# atan(7/24) and a friction of 25 deg, integrated with a step of 1e-5 s, gives 0.4930 m. The tolerance of 1 % allows for the
# contact spring and the finite step.
awk -F, '
    NR == 1 { for (i = 1; i <= NF; ++i) column[$i] = i }
    END {
        x = $column["block ux (m)"] - $column["prescribed base ux (m)"]
        y = $column["block uy (m)"] - $column["prescribed base uy (m)"]
        slip = sqrt(x * x + y * y)
        print "slip", slip, "m, expected 0.4930 m"
        exit !(slip > 0.4930 * 0.99 && slip < 0.4930 * 1.01)
    }' out/history.csv || fail "the slip is not Newmark's"
