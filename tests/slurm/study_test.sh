#!/bin/sh
# A study on a real Slurm of two nodes: a task near its time limit writes checkpoints and is queued again, one node is killed in
# mid-study, rows go on from their checkpoints, and the table is that of make on one machine. Ends with code 77, which ctest takes for skipped, where Slurm is not installed.
#   study_test.sh BIN DATA
set -eu
bin=$1
data=$2
study=$bin/dda-study
here=$(cd "$(dirname "$0")" && pwd)
cluster=
# shellcheck source=tests/slurm/cluster.sh
. "$here/cluster.sh"
has_slurm || {
    echo "SKIPPED: slurm-wlm and munge are not installed"
    exit 77
}
# shellcheck source=tests/cli/common.sh
. "$here/../cli/common.sh"
cluster=$folder.cluster
mkdir "$cluster"
trap 'stop_cluster; rm -rf "$folder" "$folder".*' EXIT
start_cluster || fail "the cluster does not start: $(tail -n 5 "$cluster"/*.out "$cluster"/*.log)"

cp "$data/incline/slope.toml" slope.toml
sed 's/^duration = .*/duration = 30/; s/^step = .*/step = 0.0005/' "$data/incline/run.toml" >run.toml
mkdir records
cp "$data/incline/sine.csv" records/sine.csv
cp records/sine.csv sine.csv
cat >plan.toml <<'PLAN'
slope = "slope.toml"
run = "run.toml"
set = ["run:output.checkpoint_interval=0.05"]
[[factor]]
name = "friction"
key = "run:joint_material.plane.friction_angle"
values = ["24 deg", "26 deg"]
[[factor]]
name = "record"
key = "run:stage[1].base_motion.x.file"
files = "records/*.csv"
[[factor]]
name = "PGA"
scale = "PGA"
record = "record"
values = ["0.1 g", "0.2 g", "0.3 g"]
[[measure]]
name = "block"
point = "block"
PLAN
"$study" make plan.toml -o single >/dev/null
make -C single -j2 >"$folder.make" 2>&1 || fail "make: $(cat "$folder.make")"
"$study" collect single >/dev/null

# Scripts alone.
"$study" make plan.toml -o cluster >/dev/null
"$study" slurm cluster --max 2 --dry-run | grep -q '6 rows in 2 tasks, 2 shared results in 2; 1 thread a row' ||
    fail "the batches: $("$study" slurm cluster --max 2 --dry-run)"
grep -q -e '--signal=B:TERM@60' cluster/slurm/submit.sh || fail "no signal before the limit"
[ -z "$(squeue -h)" ] || fail "submitted by --dry-run"

# rows_on NODE: prints the processes that compute rows on a node and have written a checkpoint.
rows_on() {
    for note in cluster/results/*/running; do
        if ! [ -s "$note" ] || ! [ -e "${note%running}checkpoint.h5" ]; then continue; fi
        read -r _ process <"$note"
        { tr '\0' '\n' <"/proc/$process/environ"; } 2>/dev/null | grep -q -x -F "SLURMD_NODENAME=$1" && echo "$process"
    done
    return 0
}
# hold_rows NODE: waits for rows on a node, and holds them, so that they are not over before what is to come.
hold_rows() {
    waited=0
    until [ -n "$(rows_on "$1")" ]; do
        waited=$((waited + 1))
        [ "$waited" -lt 1200 ] || fail "no row runs on $1: $(squeue) $(cat cluster/slurm/*.log)"
        [ -n "$(squeue -h)" ] || fail "the study is done before a row runs on $1"
        sleep 0.05
    done
    for process in $(rows_on "$1"); do kill -STOP "$process"; done
}

# For real, with a limit of a minute. n2 dies while it computes; the tasks of n1 are told of the limit by Slurm, which looks
# every 30 s.
"$study" slurm cluster --max 4 --row-time 60 --time-limit 1 >"$folder.submitted"
hold_rows n1 &
holding=$!
hold_rows n2
wait "$holding"
kill_node n2
held=$(rows_on n1)
waited=0
until grep -q 'asked to stop' cluster/slurm/rows-*.log; do
    waited=$((waited + 1))
    [ "$waited" -lt 450 ] || fail "no task is told of its time limit: $(squeue; tail -n 20 "$cluster/slurmctld.log")"
    sleep 0.2
done
for process in $held; do kill -CONT "$process" 2>/dev/null || true; done
waited=0
while [ -n "$(squeue -h)" ]; do
    waited=$((waited + 1))
    [ "$waited" -lt 600 ] || fail "the study does not end: $(squeue; sinfo; tail -n 20 cluster/slurm/*.log)"
    # The dead node comes back after a while.
    [ "$waited" -ne 5 ] || start_node n2
    [ $((waited % 10)) -ne 0 ] || end_requeue_delay
    sleep 0.2
done
grep -q 'Requeuing JobId' "$cluster/slurmctld.log" || fail "no task was queued again: $(tail -n 20 "$cluster/slurmctld.log")"
grep -q 'due to node failure\|due to failure of node n2' "$cluster/slurmctld.log" ||
    fail "the death of n2 was not noticed: $(tail -n 30 "$cluster/slurmctld.log")"
grep -q 'summary.json\] Error 75' cluster/slurm/rows-*.log || fail "no run wrote a checkpoint: $(cat cluster/slurm/rows-*.log)"
"$study" collect cluster >"$folder.collected" || {
    "$study" slurm cluster --max 4 >/dev/null
    while [ -n "$(squeue -h)" ]; do sleep 0.2; done
    "$study" collect cluster >"$folder.collected" || fail "rows are not done: $(cat "$folder.collected") $(cat cluster/slurm/*.log)"
}
for of in single cluster; do sed 's/,[^,]*$//' "$of/results.csv" >"$of.csv"; done
cmp single.csv cluster.csv || fail "Slurm gives another table"
"$study" slurm cluster | grep -q 'all 6 rows are done' || fail "rows are submitted again"
echo "Slurm: all checks passed"
