#!/bin/sh
# The progress line on a terminal and its silence elsewhere, duration = "record", and warnings about slips in a model.
#   progress_test.sh BIN DATA
set -eu
bin=$1
data=$2
# shellcheck source=tests/cli/common.sh
. "$(dirname "$0")/common.sh"
cp "$data"/incline/*.toml "$data"/incline/*.csv .
"$bin/blockgen" slope.toml >cut.txt

# on_terminal COLUMNS ARGUMENTS...: what dda-run shows on a terminal of that width, a line for each time it draws.
on_terminal() {
    columns=$1
    shift
    SHELL=/bin/sh script -qec "stty columns $columns; $bin/dda-run run.toml $* >/dev/null" /dev/null </dev/null | tr '\r' '\n' |
        sed -n 's/^\x1b\[K\(.\)/\1/p' | grep -v '^dda-run:' >shown.txt
}
on_terminal 100 --set "'stage[1].step=0.0005'" --set "'stage[1].duration=\"record\"'"
grep -q '^shake  t [0-9.]* of 5 s  [0-9]*:[0-9][0-9] left  dt 0.5 ms' shown.txt || fail "no time left: $(tail -n 3 shown.txt)"
on_terminal 40 --set "'stage[1].step=0.0005'"
awk 'length > 39 { exit 1 }' shown.txt || fail "wider than the terminal: $(awk 'length > 39' shown.txt | head -n 1)"
grep -q 'left$' shown.txt || fail "the time left has no room: $(tail -n 3 shown.txt)"
sed '/^\[\[stage\]\]/,$d' run.toml >reduction.toml
cat >>reduction.toml <<'END'
[[stage]]
name = "strength"
kind = "strength-reduction"
step = 0.0002
END
mv reduction.toml run.toml
on_terminal 120 -o reduced
grep -q '^strength  trial [0-9]*, factor [0-9.]*  .* left  unbalanced [0-9.e+-]*, goal 1e-06' shown.txt ||
    fail "no trial and factor: $(tail -n 3 shown.txt)"
cp "$data"/incline/run.toml .
"$bin/dda-run" run.toml 2>said.txt >/dev/null
grep -q 'steps/s\|left' said.txt && fail "it is not silent without a terminal: $(cat said.txt)"

# The stage lasts as long as its record, 5 s, instead of the 5.5 s of the example.
"$bin/dda-run" run.toml -o whole --set 'stage[1].duration="record"' >/dev/null 2>said.txt || fail "duration = record: $(cat said.txt)"
awk -F, '$2 == "shake" { if (first == "") first = $1; last = $1 } END { exit !(last - first > 4.999 && last - first < 5.001) }' \
    whole/history.csv || fail "the stage does not last 5 s: $(tail -n 1 whole/history.csv)"
grep -q '^duration = "record"$' whole/run.toml || fail "the effective model has another duration"
run_refused 'no record to last as long as' "$bin/dda-run" run.toml -o bad --set 'stage[1].duration="record"' \
    --set 'stage[1].base_motion.x={times=[0],values=[0]}' --set 'stage[1].base_motion.y={times=[0],values=[0]}'

# Slips are told, and the run goes on; so is a run that ends too early.
"$bin/dda-run" run.toml -o slips --set 'block_material.rock.density=2.65' --set 'stage[1].duration=1.9' >/dev/null 2>said.txt ||
    fail "a warning stops the run: $(cat said.txt)"
grep -q "density of block material 'rock' is 2.65 kg/m3" said.txt || fail "no warning of the density: $(cat said.txt)"
grep -q "of its energy is cut off" said.txt || fail "no warning of the record: $(cat said.txt)"
grep -q "'block' still moves at 0\.[0-9]* m/s at the end" said.txt || fail "no warning of the motion: $(cat said.txt)"
exit 0
