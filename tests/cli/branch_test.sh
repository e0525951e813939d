#!/bin/sh
# dda-run beginning with a state that another run saved, and dda-run --make.
#   branch_test.sh BIN_FOLDER
set -eu
run=$1/dda-run
plot=$1/dda-plot
# shellcheck source=tests/cli/common.sh
. "$(dirname "$0")/common.sh"
two_blocks >two.blocks
settle_and_shake >run.toml
short_record >record.csv

# same_results A B: requires the same bytes in all results, and the same summary but for the wall time and the saved state.
same_results() {
    for file in history.csv relative.csv steps.csv blocks.csv run.vtkhdf run.joints.vtkhdf; do
        cmp "$1/$file" "$2/$file" || fail "$2 has another $file than $1"
    done
    for of in "$1" "$2"; do grep -v -e wall_time "$of/summary.json" | sed '/"saved_state": {/,/},/d' >"$of.brief"; done
    cmp "$1.brief" "$2.brief" || fail "$2 has another summary than $1"
}

# A branch gives the bytes of the run in one go, from a run of the first stage alone and from a whole run.
"$run" run.toml -o whole --set output.save_stages=true >/dev/null 2>&1
for stage in 1 2; do [ -s "whole/stage-$stage.saved.h5" ] || fail "stage $stage is not saved"; done
"$run" run.toml -o settled --until settle >/dev/null 2>&1
[ -s settled/stage-1.saved.h5 ] || fail "the end of the stage is not saved"
grep -q '"status": "completed"' settled/summary.json || fail "no summary of the settled state"
"$run" run.toml -o plain >/dev/null 2>&1
"$run" run.toml -o branch --from settled/stage-1.saved.h5 >/dev/null 2>&1
same_results plain branch
"$run" run.toml -o other --from whole/stage-1.saved.h5 >/dev/null 2>&1
same_results plain other

# With --pvd its list has the frames of the saved run too, under their times, also where that run went on after the state.
"$run" run.toml -o pvd-plain --pvd >/dev/null 2>&1
"$run" run.toml -o pvd-settled --pvd --until settle >/dev/null 2>&1
"$run" run.toml -o pvd-whole --pvd --set output.save_stages=true >/dev/null 2>&1
for saved in settled whole; do
    "$run" run.toml -o "pvd-$saved-branch" --pvd --from "pvd-$saved/stage-1.saved.h5" >/dev/null 2>&1
    same_results pvd-plain "pvd-$saved-branch"
    for file in pvd-plain/*.pvd pvd-plain/*.vtu; do
        cmp "$file" "pvd-$saved-branch/${file#pvd-plain/}" || fail "a branch has another ${file#pvd-plain/}"
    done
done
[ "$(grep -c '<DataSet timestep=' pvd-plain/run.pvd)" -eq "$(find pvd-settled-branch -name 'run.[0-9]*.vtu' | wc -l)" ] ||
    fail "the list and the frames are not as many"
grep -q '<DataSet timestep="0" file="run.0.vtu"/>' pvd-settled-branch/run.pvd || fail "the first frame is not in the list"
# Without those of the saved run it begins with the branch.
"$run" run.toml -o pvd-new --pvd --from settled/stage-1.saved.h5 >/dev/null 2>&1
grep -q 'timestep="0"' pvd-new/run.pvd && fail "a frame that was not written is in the list"
grep -q 'file="run.0.vtu"' pvd-new/run.pvd || fail "the list does not begin with the branch"

# Later stages, records and output may change, and inputs may have moved.
"$run" run.toml -o weaker --set 'stage[1].base_motion.x.scale=0.5' >/dev/null 2>&1
"$run" run.toml -o weaker-branch --from settled/stage-1.saved.h5 --set 'stage[1].base_motion.x.scale=0.5' >/dev/null 2>&1
same_results weaker weaker-branch
mkdir elsewhere
cp two.blocks record.csv run.toml elsewhere
"$run" elsewhere/run.toml -o moved --from settled/stage-1.saved.h5 >/dev/null 2>&1
cmp plain/history.csv moved/history.csv || fail "the place of the inputs matters"
"$run" run.toml -o renamed --from settled/stage-1.saved.h5 --set output.name=new --set output.frames=3 >/dev/null 2>&1
[ -s renamed/new.vtkhdf ] || fail "no frames under another name"

# What the saved run went on with is not the branch's: its frames stayed where a branch has fewer.
"$run" run.toml -o shorter --set output.frames=3 --set 'stage[1].duration=0.5' >/dev/null 2>&1
"$run" run.toml -o shorter-branch --from whole/stage-1.saved.h5 --set output.frames=3 --set 'stage[1].duration=0.5' >/dev/null 2>&1
same_results shorter shorter-branch

# What the state depends on may not.
branch_refused() {
    expected=$1
    shift
    run_refused "$expected" "$run" run.toml -o refused "$@"
    [ ! -e refused ] || fail "results after '$expected'"
}
branch_refused "joint_material.bedding. has 'friction_angle = .30 deg.', the saved run has 'friction_angle = .20 deg" \
    --from settled/stage-1.saved.h5 --set joint_material.bedding.friction_angle='30 deg'
branch_refused "stage.. has 'tolerance = 1e-05', the saved run has 'tolerance = 1e-06'" \
    --from settled/stage-1.saved.h5 --set 'stage[0].tolerance=1e-5'
branch_refused "output. has 'relative_to = \"crest\"'" --from settled/stage-1.saved.h5 --set output.relative_to=crest
branch_refused 'is the end of stage 2, and the run has 2 stages' --from whole/stage-2.saved.h5
branch_refused "no stage 'setle' is left to run; expected perhaps 'settle'" --until setle
branch_refused "no stage 'settle' is left to run" --from settled/stage-1.saved.h5 --until settle
branch_refused 'there is no' --from settled/no.h5
branch_refused 'both given' --resume --make
run_refused 'the folder of the run that --from begins with' "$run" run.toml -o settled --from settled/stage-1.saved.h5
sed 's/vertex 3 2/vertex 3 2.5/' two.blocks >higher.blocks
branch_refused 'the block file is not that of the saved run' --from settled/stage-1.saved.h5 --blocks higher.blocks

# A branch that is killed goes on with --make, and so does one whose checkpoint is damaged or of other input.
long_branch="run.toml --from settled/stage-1.saved.h5 --make --set stage[1].duration=600 --set output.checkpoint_interval=1e-3"
start_long() {
    # shellcheck disable=SC2086
    "$run" $long_branch -o "$1" >/dev/null 2>"$1.err"
}
mkdir long-branch
# shellcheck disable=SC2086
"$run" $long_branch -o long-branch >/dev/null 2>long-branch.err &
while [ ! -s long-branch/checkpoint.h5 ]; do sleep 0.01; done
kill -9 $!
wait 2>/dev/null || true
[ ! -e long-branch/summary.json ] || fail "the run was over before it was killed"
branch_refused 'is a checkpoint from within a stage' --from long-branch/checkpoint.h5 --set 'stage[1].duration=600' \
    --set output.checkpoint_interval=1e-3
cp -r long-branch damaged
echo rubbish >damaged/checkpoint.h5
start_long long-branch
[ ! -e long-branch/checkpoint.h5 ] || fail "the checkpoint of a complete run is left"
start_long damaged
grep -q 'begins anew' damaged.err || fail "not told that the run begins anew"
start_long undisturbed
same_results undisturbed long-branch
same_results undisturbed damaged

# For Make a summary is there only when all is done.
code=0
"$run" run.toml -o failing --make --set 'stage[0].step_limit=2' >/dev/null 2>&1 || code=$?
[ "$code" -eq 1 ] || fail "exit code $code of a run that does not settle"
[ ! -e failing/summary.json ] || fail "a failed run is up to date"
grep -q '"status": "not settled"' failing/failed.json || fail "no reason of the failure"
"$run" run.toml -o failing --make >/dev/null 2>&1
[ -s failing/summary.json ] || fail "no summary of a run that succeeds"
[ ! -e failing/failed.json ] || fail "a run that succeeds leaves the failure"
code=0
"$run" run.toml -o failing --make --set 'stage[1].smallest_step=4.9e-3' --set 'analysis.normal_penalty=1e30' >/dev/null 2>&1 || code=$?
[ "$code" -eq 1 ] || fail "exit code $code of a run that does not converge"
[ ! -e failing/summary.json ] || fail "the summary of an earlier run is left"
"$plot" failing --frames last || fail "a failed run cannot be drawn"

# A slope that comes down is a result.
"$run" run.toml -o down --make --set 'stage[1].stop.displacement=2e-4' 2>err.txt >/dev/null
grep -q "stage 'shake' has collapsed, t = .*: block 1 at .* has moved 0.0002.* m .*beyond the limit of 0.0002 m" err.txt ||
    fail "not told of the collapse: $(cat err.txt)"
grep -q '"status": "collapsed"' down/summary.json || fail "the status is not collapsed"
echo "branches: all checks passed"
