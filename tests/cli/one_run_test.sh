#!/bin/sh
# One run writes into a folder at a time, under names that nobody else has.
#   one_run_test.sh BIN_FOLDER
set -eu
bin=$1
run=$bin/dda-run
# shellcheck source=tests/cli/common.sh
. "$(dirname "$0")/common.sh"
two_blocks >two.blocks
settle_and_shake >run.toml
short_record >record.csv
sed -e 's/duration = 1$/duration = 1000/' -e 's/frames = 10/frames = 2000\ncheckpoint_interval = 0.05/' run.toml >long.toml

# A link of the name that checkpoints once had while they were written.
mkdir out
echo "precious" >victim
ln -s ../victim out/checkpoint.h5.tmp
"$run" long.toml -o out >/dev/null 2>err.txt &
pid=$!
while [ ! -e out/checkpoint.h5 ]; do sleep 0.02; done
[ "$(cat victim)" = precious ] || fail "a link is followed"

# A second run is refused, however it is started, and touches nothing.
for options in "" "--resume" "--make" "--from other/stage-1.saved.h5"; do
    rows=$(wc -l <out/history.csv)
    # shellcheck disable=SC2086
    run_refused "out: another run writes its results here: process $pid on " "$run" long.toml -o out $options
    [ "$(wc -l <out/history.csv)" -ge "$rows" ] || fail "rows are lost by a second run with '$options'"
done
run_refused "another run writes its results here: process $pid" "$run" long.toml -o ./out/../out --log "second"
[ ! -e out/log ] || fail "a second run has a log in the folder of the first"

# Where the first was killed, the next one may begin, and what the first left half-written goes.
kill -9 $pid
wait $pid 2>/dev/null || true
echo "half" >out/checkpoint.h5.tmp0123456789ab
"$run" long.toml -o out --resume >/dev/null 2>err.txt &
pid=$!
while [ -e out/checkpoint.h5.tmp0123456789ab ]; do sleep 0.02; done
kill -s TERM $pid
code=0
wait $pid || code=$?
[ "$code" -eq 75 ] || fail "exit code $code of a run after a killed one: $(cat err.txt)"
[ ! -e out/.dda-run.lock ] || fail "the lock is left"
[ -z "$(find out -name '*tmp?*')" ] || fail "left: $(find out -name '*tmp?*')"
[ "$(readlink out/checkpoint.h5.tmp)" = ../victim ] || fail "the user's link is gone"

# Twenty at once: one runs, the others are refused.
for k in $(seq 20); do
    {
        code=0
        "$run" run.toml -o shared >/dev/null 2>&1 || code=$?
        echo $code >"code.$k"
    } &
done
wait
sort code.* | uniq -c >codes.txt
if awk '$2 != 0 && $2 != 2 { exit 1 } $2 == 0 { ++good } END { exit !good }' codes.txt; then :; else fail "codes of twenty: $(cat codes.txt)"; fi
"$run" run.toml -o alone >/dev/null 2>&1
for file in run.vtkhdf history.csv steps.csv blocks.csv; do cmp shared/$file alone/$file || fail "$file is spoilt"; done
echo "one run in a folder: all checks passed"
