#!/bin/sh
# A run that does not converge ends, reports its worst contact and writes its last frame; dda-plot draws both.
#   no_convergence_test.sh BIN_FOLDER
set -eu
run=$1/dda-run
plot=$1/dda-plot
# shellcheck source=tests/cli/common.sh
. "$(dirname "$0")/common.sh"
cat >stack.blocks <<'BLOCKS'
ddablk 1
counts provenance 0 block_materials 1 joint_materials 1 joints 1 vertices 10 blocks 3 rings 3 corners 14 measured_points 0 bolts 0
block_material rock
joint_material bedding
joint set
vertex -10 0
vertex 14 0
vertex 14 1
vertex 3 1
vertex 1 1
vertex -10 1
vertex 3 2
vertex 1 2
vertex 3 3
vertex 1 3
block 0 1 prescribed base
ring 0 1 2 3 4 5
edges - - - 0:0 - -
block 0 1 free
ring 4 3 6 7
edges 0:0 - 0:0 -
block 0 1 free
ring 7 6 8 9
edges 0:0 - - -
end
BLOCKS
# Shaken at 2 g, the blocks slip and lift off. The contact states change, and one iteration without a smaller step does not
# converge.
printf 'time (s),acceleration (m/s2)\n0,0\n0.1,20\n0.2,-20\n0.3,0\n' >record.csv
{
    echo 'blocks = "stack.blocks"'
    rock_and_bedding
    cat <<'MODEL'
[[stage]]
name = "settle"
kind = "static"
[[stage]]
name = "shake"
kind = "dynamic"
duration = 1
iteration_limit = 1
smallest_step = 0.004
[stage.base_motion]
block = "base"
x = { file = "record.csv" }
[output]
frames = 10
MODEL
} >run.toml

code=0
timeout 60 "$run" run.toml -o out 2>err.txt || code=$?
[ "$code" -eq 1 ] || fail "exit code $code: $(cat err.txt)"
grep -q "stage 'shake'.*no step above 0.004 s is accepted.*worst contact: block [0-9] on block [0-9]" err.txt ||
    fail "no contact named: $(cat err.txt)"
for file in run.vtkhdf run.joints.vtkhdf history.csv steps.csv summary.json; do
    [ -s "out/$file" ] || fail "no $file"
done
grep -q '"status": "not converged"' out/summary.json || fail "the summary has another status"
grep -q '"worst_contact"' out/summary.json || fail "the summary names no contact"

# The last frame is the last accepted state: the time of the summary and of the last step.
"$plot" out --frames last --format svg -o last
time=$(sed -n 's/^  "time": \(.*\),$/\1/p' out/summary.json)
stepped=$(tail -n 1 out/steps.csv | cut -d, -f1)
[ "$time" = "$stepped" ] || fail "the summary's time is $time, the last step's $stepped"

# One command draws the worst contact; with --worst-contact it draws nothing else.
"$plot" out
for picture in worst-contact worst-contact-near frame-0000; do
    [ -s "out/run.$picture.png" ] || fail "no picture $picture"
done
"$plot" out --worst-contact -o alone
[ "$(ls alone)" = "run.worst-contact-near.png
run.worst-contact.png" ] || fail "other pictures too: $(ls alone)"
cmp -s alone/run.worst-contact.png alone/run.worst-contact-near.png && fail "both pictures are the same"

# A completed run has no worst contact, and a damaged summary is refused.
"$run" run.toml -o whole --set 'stage[1].iteration_limit=100' --set 'stage[1].smallest_step=1e-9' 2>/dev/null
"$plot" whole
[ ! -e whole/run.worst-contact.png ] || fail "a worst contact of a run that converged"
run_refused 'names no worst contact' "$plot" whole --worst-contact
cp out/summary.json kept.json
for edit in 's/"edge_block": [0-9]*/"edge_block": 99/' 's/"edge_block": [0-9]*/"edge_block": -1/' \
    's/"edge_block"/"edge_bock"/' 's/"status"/"state"/' 's/}//'; do
    sed "$edit" kept.json >out/summary.json
    run_refused 'summary\|no block of the worst contact' "$plot" out --worst-contact -o refused
    [ ! -e refused ] || fail "something written for $edit"
done
echo "a run that does not converge reports its worst contact"
