#!/bin/sh
# dda-run and dda-plot as users call them: bad input, stopping and resuming, dependency files for Make.
#   dda_run_test.sh BIN_FOLDER
set -eu
run=$1/dda-run
plot=$1/dda-plot
# shellcheck source=tests/cli/common.sh
. "$(dirname "$0")/common.sh"
two_blocks >two.blocks
settle_and_shake >run.toml
short_record >record.csv

# refused EXPECTED SED_EXPRESSION [OPTION...]: requires that the edited model is refused with one line and no file is written.
refused() {
    expected=$1
    sed "$2" run.toml >bad.toml
    shift 2
    run_refused "$expected" "$run" bad.toml -o results "$@"
    rm -f bad.toml
    [ "$(ls)" = "$present" ] || fail "files touched by '$expected': $(ls)"
}
present=$(ls)

refused 'bad.toml:8:.*unknown key .frction_angle.*did you mean .friction_angle' 's/friction_angle/frction_angle/'
refused 'bad.toml:3:11: .*density.*expected a density' 's/2500/"heavy"/'
refused 'bad.toml:4:18: .*is -1e+10; expected a positive number' 's/"10 GPa"/-1e10/'
refused 'bad.toml:5:18: .*not a finite number' 's/0.25/nan/'
refused 'needs the joint_material .bedding' 's/joint_material.bedding/joint_material.other/'
refused 'no/such.blocks: cannot be read' 's/two.blocks/no\/such.blocks/'
refused 'there is no prescribed block .bass' 's/block = "base"/block = "bass"/'
refused '--set stage\[1\].step=-1: .*positive' 's/x/x/' --set 'stage[1].step=-1'
refused 'no index\|an index below' 's/x/x/' --set 'stage[7].step=1'
refused 'no checkpoint to resume from' 's/x/x/' --resume
refused 'unrecognised option' 's/x/x/' --frames 3
refused 'threads is 0' 's/x/x/' --threads 0

printf '0,0\n0.1,5\n0.25,-5\n0.3,0\n' >uneven.csv
present=$(ls)
refused 'uneven.csv:3: the time step is uneven' 's/"record.csv"/"uneven.csv", quantity = "acceleration", unit = "m\/s2"/'
head -n 12 two.blocks >short.blocks
sed 's/ddablk 1/ddablk 99/' two.blocks >newer.blocks
present=$(ls)
refused 'short.blocks' 's/two.blocks/short.blocks/'
refused 'newer.blocks:1.*99' 's/two.blocks/newer.blocks/'

# Blocks 0.3 m in one another, which were settled for 20 000 steps.
cat >overlap.blocks <<'BLOCKS'
ddablk 1
counts provenance 0 block_materials 1 joint_materials 1 joints 1 vertices 8 blocks 2 rings 2 corners 8 measured_points 0 bolts 0
block_material rock
joint_material bedding
joint set
vertex 0 0
vertex 4 0
vertex 4 1
vertex 0 1
vertex 1 0.7
vertex 3 0.7
vertex 3 1.7
vertex 1 1.7
block 0 1 prescribed base
ring 0 1 2 3
edges - - - -
block 0 1 free
ring 4 5 6 7
edges - - - -
end
BLOCKS
present=$(ls)
refused 'overlap.blocks: blocks 0 and 1 overlap at (.*, .*); expected blocks that touch at most' 's/two.blocks/overlap.blocks/'
touch occupied
code=0
"$run" run.toml -o occupied/out 2>err.txt || code=$?
[ "$code" -eq 2 ] || fail "exit code $code for a folder that cannot be made"
rm err.txt

# A complete run; the dependency file; the written model file gives identical results.
"$run" run.toml -o whole --depfile run.d 2>/dev/null
for file in run.vtkhdf run.joints.vtkhdf history.csv steps.csv summary.json run.toml; do
    [ -s "whole/$file" ] || fail "no $file"
done
grep -q 'whole/summary.json:' run.d || fail "no rule in the depfile"
for file in run.toml two.blocks record.csv; do grep -q "^$file:\$" run.d || fail "no $file in the depfile"; done
"$run" whole/run.toml -o echo 2>/dev/null
"$run" run.toml -o threads --threads 2 2>/dev/null
for file in history.csv steps.csv run.vtkhdf run.joints.vtkhdf; do
    cmp "whole/$file" "echo/$file" || fail "the echo gives another $file"
    cmp "whole/$file" "threads/$file" || fail "two threads give another $file"
done
"$run" run.toml --print-config | grep -q 'growth = 1.3  # default' || fail "no default in --print-config"
"$run" --template | grep -q 'joint_material.joint' || fail "no template"
"$run" --help | grep -q -- '--resume' || fail "no help"

# A run stopped by a file and then resumed.
mkdir stopped
sed 's/duration = 1/duration = 40/' run.toml >long.toml
"$run" long.toml -o long --set 'output.name="run"' 2>/dev/null
code=0
"$run" long.toml -o stopped --set 'output.name="run"' 2>/dev/null &
pid=$!
while [ ! -s stopped/steps.csv ]; do sleep 0.01; done
touch stopped/stop
wait $pid || code=$?
[ "$code" -eq 75 ] || fail "exit code $code after a stop file"
[ ! -e stopped/stop ] || fail "the stop file is left"
code=0
"$run" long.toml -o stopped --set 'output.name="run"' --set 'stage[1].duration=41' --resume 2>err.txt || code=$?
[ "$code" -eq 2 ] || fail "resumed with other input"
"$run" long.toml -o stopped --set 'output.name="run"' --resume 2>/dev/null
for file in history.csv steps.csv run.vtkhdf run.joints.vtkhdf; do
    cmp "long/$file" "stopped/$file" || fail "the resumed run gives another $file"
done

# Blocks of four corners that are glued together are told of, once.
sed 's/prescribed base/free/' two.blocks >glued.blocks
cat >glued.toml <<'MODEL'
blocks = "glued.blocks"
[analysis]
gravity = [0, 0]
[block_material.rock]
density = 2500
youngs_modulus = "10 GPa"
poissons_ratio = 0.25
[joint_material.bedding]
law = "elastic"
[[stage]]
kind = "dynamic"
duration = 0.01
MODEL
"$run" glued.toml -o glued 2>err.txt
[ "$(grep -c '2 blocks of more than three corners are glued, the first is block 0 .*joint material bedding' err.txt)" -eq 1 ] ||
    fail "not told of glued rectangles: $(cat err.txt)"
"$run" run.toml -o loose 2>err.txt
grep -q 'are glued' err.txt && fail "told of glue where there is none"

# So is a contact damping that the steps are too long for: with the default penalty omega dt is above 1 here.
"$run" run.toml -o damped --set joint_material.bedding.contact_damping=0.05 2>err.txt
[ "$(grep -c "contact_damping 0.05 of joint material 'bedding' has no effect" err.txt)" -eq 1 ] ||
    fail "not told of a damping without effect: $(cat err.txt)"
"$run" run.toml -o damped --set joint_material.bedding.contact_damping=0.05 --set 'stage[1].step=1e-5' \
    --set 'stage[1].duration=1e-4' 2>err.txt
grep -q 'has no effect' err.txt && fail "told of a damping that has an effect"

# Pictures.
"$plot" whole
for file in frame-0000 frame-0006 frame-0011 history; do [ -s "whole/run.$file.png" ] || fail "no picture $file"; done
"$plot" whole --frames 3,last --format svg -o stopped
grep -q '<svg' stopped/run.frame-0003.svg || fail "no SVG"
code=0
"$plot" whole --frames 99 2>err.txt || code=$?
[ "$code" -eq 2 ] || fail "exit code $code for a frame that is not there"
for largest in 0 -1 nan inf; do
    code=0
    "$plot" whole --largest=$largest 2>err.txt || code=$?
    [ "$code" -eq 2 ] || fail "exit code $code for --largest=$largest"
done
"$plot" whole --frames last -o other
"$plot" whole --frames last --largest 0.02 -o given
cmp -s other/run.frame-0011.png given/run.frame-0011.png && fail "--largest changes nothing"
echo "dda-run: all checks passed"
