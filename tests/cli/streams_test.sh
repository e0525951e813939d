#!/bin/sh
# Standard streams that are closed, full or cut off, and signals: results are whole, and the exit code tells.
#   streams_test.sh BIN_FOLDER
set -eu
bin=$1
run=$bin/dda-run
# shellcheck source=tests/cli/common.sh
. "$(dirname "$0")/common.sh"
two_blocks >two.blocks
settle_and_shake >run.toml
short_record >record.csv
sed 's/duration = 1$/duration = 1000/' run.toml >long.toml

# same_results FOLDER FOLDER: but for the summary, which has the time that the run took.
same_results() {
    for file in run.vtkhdf run.joints.vtkhdf history.csv steps.csv blocks.csv run.toml; do
        cmp "$1/$file" "$2/$file" || fail "$file of $1 and $2"
    done
}

# No result file may get the number of a closed stream, and with it what is printed.
"$run" run.toml -o whole >whole.txt 2>/dev/null
code=0
"$run" run.toml -o closed <&- >&- 2>&- || code=$?
[ "$code" -eq 1 ] || fail "exit code $code with a closed standard output"
same_results closed whole
grep -q '"status": "completed"' closed/summary.json || fail "no summary of a run with closed streams"
"$run" run.toml -o deaf <&- 2>&- >deaf.txt || fail "exit code $? with a closed standard error"
same_results deaf whole
cmp deaf.txt whole.txt || fail "another table with a closed standard error"
for stream in '>&-' '>/dev/full'; do
    code=0
    eval "\"\$run\" run.toml -o full $stream" 2>err.txt || code=$?
    [ "$code" -eq 1 ] || fail "exit code $code with $stream"
    tail -n 1 err.txt | grep -q 'dda-run: the standard output cannot be written: ' || fail "said with $stream: $(cat err.txt)"
    same_results full whole
    for program in blockgen dda-run dda-plot joint-shear ground-motion dda-study; do
        code=0
        eval "\"\$bin/\$program\" --help $stream" 2>err.txt || code=$?
        [ "$code" -eq 1 ] || fail "exit code $code of $program --help $stream"
        grep -q "^$program: the standard output cannot be written" err.txt || fail "$program said: $(cat err.txt)"
    done
done
code=0
"$bin/ground-motion" show record.csv >/dev/full 2>err.txt || code=$?
[ "$code" -eq 1 ] || fail "exit code $code of ground-motion show on a full disk"

# A reader that has gone: no silent death.
for program in blockgen dda-run dda-plot joint-shear ground-motion dda-study; do
    {
        code=0
        sleep 0.1
        "$bin/$program" --help 2>err.txt || code=$?
        echo "$code" >code.txt
    } | true
    [ "$(cat code.txt)" -eq 1 ] || fail "exit code $(cat code.txt) of $program into a pipe without a reader"
    grep -q 'standard output cannot be written' err.txt || fail "$program dies silently"
done

# begin FOLDER: starts a run of a thousand seconds there, and waits for its first rows.
begin() {
    "$run" long.toml -o "$1" >/dev/null 2>"$1.err" &
    pid=$!
    while [ ! -s "$1/history.csv" ]; do sleep 0.02; done
}
# ended CODE WHAT: the run that begin started has ended with this code.
ended() {
    code=0
    wait $pid || code=$?
    [ "$code" -eq "$1" ] || fail "exit code $code after $2"
}

# Signals of batch systems, limits and timers stop a run after a checkpoint.
for signal in INT TERM HUP USR1 USR2 XCPU ALRM VTALRM; do
    [ "$signal" != INT ] || continue # which a shell has ignored in what it starts behind itself
    begin "by$signal"
    kill -s $signal $pid
    ended 75 "SIG$signal"
    [ -s "by$signal/checkpoint.h5" ] || fail "no checkpoint after SIG$signal"
done
begin twice
kill -s USR1 $pid
sleep 0.01
kill -s USR1 $pid 2>/dev/null || true
ended 75 "SIGUSR1 twice"
code=0
(
    # shellcheck disable=SC3045
    ulimit -S -t 1
    exec "$run" long.toml -o limited >/dev/null 2>err.txt
) || code=$?
[ "$code" -eq 75 ] || fail "exit code $code at the limit of processor time: $(cat err.txt)"

# What is ignored stays ignored, as nohup and shells ask for.
for signal in HUP INT; do
    trap '' $signal
    begin "ignores$signal"
    trap - $signal
    kill -s $signal $pid
    sleep 0.3
    kill -s 0 $pid || fail "an ignored SIG$signal has ended the run: $(cat "ignores$signal.err")"
    [ ! -e "ignores$signal/summary.json" ] || fail "an ignored SIG$signal has stopped the run"
    kill -s TERM $pid
    ended 75 "SIGTERM, with SIG$signal ignored"
done
echo "streams and signals: all checks passed"
