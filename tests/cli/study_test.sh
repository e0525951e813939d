#!/bin/sh
# dda-study as a user calls it: what a plan computes, once; interrupted and failed rows; what a changed plan computes anew; the
# same table however it was computed; bad plans.
#   study_test.sh BIN DATA
set -eu
bin=$1
data=$2
study=$bin/dda-study
# shellcheck source=tests/cli/common.sh
. "$(dirname "$0")/common.sh"
cp "$data/incline/slope.toml" slope.toml
sed 's/^duration = .*/duration = 1.2/; s/^step = .*/step = 0.01/; s/^frames = .*//' "$data/incline/run.toml" >run.toml
mkdir records
sed -n '1,120p' "$data/incline/sine.csv" >records/long.csv
sed -n '1,80p' "$data/incline/sine.csv" >records/short.csv
cp records/long.csv sine.csv
cat >plan.toml <<'PLAN'
slope = "slope.toml"
run = "run.toml"
set = ["run:stage[1].stop.displacement=0.1"]
[[factor]]
name = "friction"
key = "run:joint_material.plane.friction_angle"
values = ["25 deg", "27 deg"]
[[factor]]
name = "record"
key = "run:stage[1].base_motion.x.file"
files = "records/*.csv"
[[factor]]
name = "PGA"
scale = "PGA"
record = "record"
values = ["0.2 g", "0.3 g", "0.6 g"]
[[measure]]
name = "block"
point = "block"
[[measure]]
name = "volume"
kind = "moved-volume"
limit = 0.05
[[measure]]
name = "travel angle"
kind = "travel-angle"
limit = 0.05
[[measure]]
name = "thickness"
kind = "deposit-thickness"
limit = 0.05
[[measure]]
name = "height"
kind = "deposit-height"
width = 1
[[measure]]
name = "farthest"
[[measure]]
name = "farthest peak"
at = "peak"
[[measure]]
name = "block peak"
point = "block"
at = "peak"
[[measure]]
name = "toe"
kind = "surface"
x = 23
[profile]
interval = 0.05
limit = 0.05
PLAN
# make_study FOLDER [OPTION...]: computes a study; prints the calls of the programs.
make_study() {
    place=$1
    shift
    make -C "$place" "$@" >"$folder.make" 2>&1
}
# The number of rows that the last make_study computed.
rows_computed() { grep -c '^row' "$folder.make" || true; }
# table_of FOLDER: the results without the wall times.
table_of() {
    "$study" collect "$1" >/dev/null
    sed 's/,[^,]*$//' "$1/results.csv"
}

# A plan computes nothing; its rows share one cut, and the settled state of each friction.
"$study" make plan.toml -o one >out.txt
grep -q '12 rows, of 1 cut, from 2 states at the end of stage .settle.' out.txt || fail "the plan: $(cat out.txt)"
[ -z "$(find one/results one/cuts one/starts -type f)" ] || fail "something is computed by make"
[ "$(wc -l <one/runs.csv)" -eq 13 ] || fail "runs.csv: $(cat one/runs.csv)"
code=0
"$study" status one >out.txt || code=$?
[ "$code" -eq 1 ] || fail "exit code $code of a study that is not done"
grep -q '12 rows: 12 waiting' out.txt || fail "status: $(cat out.txt)"
make -C one -n runs/000005/summary.json | grep -q -e '--from starts' || fail "make -n does not show the run"
# Make starts a row without a shell: outside quotes its command has no character that would need one.
make -C one -n runs/000005/summary.json | sed -n "/--log 'row/{s/'[^']*'//g;p;}" >commands.txt
[ -s commands.txt ] || fail "no command of a row"
grep -q '[][#;"*?&|<>(){}$`^~!\\]' commands.txt && fail "a row needs a shell: $(cat commands.txt)"
make_study one -j1 || fail "the study: $(cat "$folder.make")"
[ "$(find one/cuts -name '*.blocks' | wc -l)" -eq 1 ] || fail "more than one cut"
[ "$(find one/starts -name '*.saved.h5' | wc -l)" -eq 2 ] || fail "not one start for each friction"
"$study" status one | grep -q '12 rows: [0-9]* completed, [0-9]* collapsed' || fail "status: $("$study" status one)"
table_of one >one.csv
grep -q '^1,25 deg,long.csv,1.96133,0,,,completed,' one.csv || fail "the table: $(cat one.csv)"
[ "$(grep -c ',collapsed,' one.csv)" -gt 0 ] || fail "no row has collapsed: $(cat one.csv)"
[ "$(du -s --exclude=profile.csv one/results | cut -f1)" -lt 6000 ] || fail "rows take much space: $(du -s one/results)"

# The deposit: a block of 1.5625 m on the 7-24-25 slope is 1.5625 * 25 / 24 m thick, wherever it comes to rest, and the base is
# where it was though it was shaken, 7 / 24 m above its toe one metre from there. The area under each profile is that of the block, 3.125 m x 1.5625 m.
grep -q ',thickness (m),height (m),farthest (m),.*,toe (m),PGA' one/results.csv || fail "the headings: $(head -n 1 one/results.csv)"
awk -F, 'NR == 1 { for (k = 1; k <= NF; ++k) column[$k] = k; next }
    # A face of 1.6 m that has moved by so much is no higher than that over a metre.
    $column["height (m)"] > 1.7 * $column["block (m)"] + 1e-6 { print; exit 1 }
    { thickness = $column["thickness (m)"]; toe = $column["toe (m)"]
      expected = $column["volume (m3/m)"] > 0 ? 1.5625 * 25 / 24 : 0
      if ((thickness - expected) ^ 2 > 1e-6 || (toe - 3 - 7 / 24) ^ 2 > 1e-10) { print; exit 1 } }' one/results.csv ||
    fail "the thickness of the block, or the surface at the toe"
# The farthest block is the block, relative to the base.
awk -F, 'NR == 1 { for (k = 1; k <= NF; ++k) column[$k] = k; next }
    { end = $column["farthest (m)"] - $column["block (m)"]; peak = $column["farthest peak (m)"] - $column["block peak (m)"]
      if (end ^ 2 > 1e-8 || peak ^ 2 > 1e-8) { print; exit 1 } }' one/results.csv || fail "the farthest block is another"
[ "$(grep -c '^1,' one/profiles.csv)" -ge 480 ] || fail "not a station every 5 cm: $(grep -c '^1,' one/profiles.csv)"
grep -q '^12,12.05,' one/profiles.csv || fail "stations are not round: $(grep '^12,12.0' one/profiles.csv)"
awk -F, 'NR > 1 && $6 > 0 { area[$1] += 0.05 * $6 } END { for (row in area) { ++rows; if ((area[row] - 3.125 * 1.5625) ^ 2 > 4e-4) exit 1 }
    exit !(rows > 0) }' one/profiles.csv || fail "the area of the profiles"
cmp one/runs/000012/profile.csv - <<PROFILE || fail "the profile beside the row is another"
$("$study" profile one/runs/000012 --interval 0.05 --limit 0.05)
PROFILE
run_refused 'interval is not given' "$study" profile one/runs/000012 --limit 1
run_refused 'contains no NAME.vtkhdf' "$study" profile records --limit 1 --interval 1

# A row in one go, by hand, moves as far.
"$bin/dda-run" run.toml --blocks one/cuts/*.blocks -o by-hand --set 'stage[1].base_motion.x.file="records/long.csv"' \
    --set 'stage[1].stop.displacement=0.1' \
    >/dev/null 2>&1
grep -q '"peak_acceleration": 2.9' by-hand/summary.json || fail "the record by hand: $(grep peak_acc by-hand/summary.json)"

# Two at a time, and a study that is killed again and again, give the same table.
"$study" make plan.toml -o two >/dev/null
make_study two -j2 || fail "two at a time: $(cat "$folder.make")"
table_of two | cmp - one.csv || fail "make -j2 gives another table"
"$study" make plan.toml -o killed >/dev/null
for delay in 0.1 0.05 0.1 0.05 0.1; do
    setsid make -C killed -j2 >/dev/null 2>&1 &
    sleep "$delay"
    kill -9 -- "-$!" 2>/dev/null || true
    wait 2>/dev/null || true
done
make_study killed -j2 || fail "a study that was killed: $(cat "$folder.make")"
table_of killed | cmp - one.csv || fail "a study that was killed gives another table"

# SIGTERM to make, as a time limit sends it: the run writes a checkpoint, ends with code 75, says so, and goes on later.
sed 's/^set = .*/set = ["run:stage[1].duration=300", "run:stage[1].step=0.0005"]/' plan.toml >stopped.toml
"$study" make stopped.toml -o stopped >/dev/null
make -C stopped runs/000001/summary.json >make.txt 2>&1 &
while [ -z "$(find stopped/results -name history.csv -size +1k 2>/dev/null)" ]; do sleep 0.02; done
"$study" status stopped >status.txt || true
grep -q '12 rows: 1 running, 11 waiting' status.txt || fail "status during a run: $(cat status.txt)"
kill -TERM "$!"
wait 2>/dev/null || true
grep -q '^row 000001: dda-run: stopped at t = .*--resume continues' make.txt || fail "not told of the stop: $(cat make.txt)"
"$study" status stopped >status.txt || true
grep -q '12 rows: 1 stopped, 11 waiting' status.txt || fail "status of a stopped row: $(cat status.txt)"

# Curves, what measures depend on, and a report.
"$study" fragility one --measure block --limit 0.02 --intensity PGA -o curve.csv --picture curve.png >out.txt
grep -q '^P(block (m) > 0.02 | PGA' out.txt || fail "no curve: $(cat out.txt)"
"$study" sensitivity one --measure volume | grep -q '^PGA,' || fail "no indices"
"$study" sensitivity one --measure block --spread | grep -q '^friction,' || fail "no spread"
"$study" report one -o one.html
grep -q '<h2>Measures</h2>' one.html || fail "no report"
run_refused "expected perhaps 'block'" "$study" fragility one --measure blok --limit 1 --intensity PGA
run_refused 'limit is not given' "$study" fragility one --measure block --intensity PGA

# What was removed is computed again.
rm -r two/starts two/cuts two/results/*
make_study two -j2 || fail "after removing results: $(cat "$folder.make")"
table_of two | cmp - one.csv || fail "what was computed again differs"

# Nothing is computed twice: neither by a second make, nor after a touch, nor for the rows that a changed plan keeps.
make_study one -j2
grep -q '^row' "$folder.make" && fail "computed again: $(cat "$folder.make")"
sleep 1
touch run.toml records/long.csv plan.toml
make_study one -j2
grep -q '^row' "$folder.make" && fail "computed again after a touch: $(cat "$folder.make")"
sed -i 's/values = \["0.2 g", "0.3 g", "0.6 g"\]/values = ["0.2 g", "0.25 g", "0.3 g", "0.6 g"]/' plan.toml
make_study one -j2 || fail "one intensity more: $(cat "$folder.make")"
[ "$(grep -c '^row' "$folder.make")" -eq 4 ] || fail "not four rows more: $(cat "$folder.make")"
"$study" status one | grep -q '16 rows' || fail "the plan is not read again"
grep -v '^[0-9]*,2[57] deg,[a-z]*.csv,2.45' one/results.csv >/dev/null || fail "no row of the new intensity"

# The table tells rows that were computed from other files than there are now; a comment does not matter.
"$study" collect one >out.txt || fail "collect: $(cat out.txt)"
echo '# a comment' >>run.toml
"$study" collect one | grep -q 'other input' && fail "a comment makes rows outdated"
cp run.toml run.before
sed -i 's/^duration = 1.2/duration = 1.1/' run.toml
code=0
"$study" collect one >out.txt || code=$?
[ "$code" -eq 1 ] || fail "exit code $code of outdated rows"
grep -q '^16 rows were computed from other input than there is now; the first is 1, for changes in ../run.toml. make' out.txt ||
    fail "not told of outdated rows: $(cat out.txt)"
[ "$(grep -c ',computed from other input,' one/results.csv)" -eq 16 ] || fail "they are not marked in the table"
cp run.before run.toml
cp records/short.csv short.before
sed -i '$d' records/short.csv
"$study" collect one >out.txt || true
grep -q '^8 rows were .*; the first is 5, for changes in ../run.toml, .*records/short.csv. make' out.txt || fail "not told of a record: $(cat out.txt)"
make_study one -j2 || fail "another record: $(cat "$folder.make")"
"$study" collect one >out.txt || fail "after computing them: $(cat out.txt)"
mv short.before records/short.csv
make_study one -j2 || fail "the record as it was: $(cat "$folder.make")"
[ "$(rows_computed)" -eq 0 ] || fail "computed again: $(cat "$folder.make")"

# A row that fails says why, is tried again, and ends the study with a list by cause.
sed 's/^\[\[factor\]\]/set = ["run:stage[0].step_limit=3"]\n&/; s/^set = \["run:stage.1.*//' plan.toml |
    awk '!/^set/ || !seen++' >failing.toml
"$study" make failing.toml -o failing >/dev/null
for attempt in first second; do
    code=0
    make_study failing -j2 || code=$?
    [ "$code" -eq 2 ] || fail "exit code $code of make, $attempt time"
    grep -q 'failed, start not settled: 16 rows, the first is 1: stage .settle. does not settle' "$folder.make" ||
        fail "no list of failures: $(cat "$folder.make")"
    grep -q '^start [0-9a-f]*: .*does not settle' "$folder.make" || fail "the start is not tried again, $attempt time"
done
code=0
"$study" collect failing >out.txt || code=$?
[ "$code" -eq 1 ] || fail "exit code $code of collect with failures"
grep -q ',failed,start not settled,' failing/results.csv || fail "the cause is not in the table: $(cat failing/results.csv)"

# Replicates begin with a perturbation; rows of an incremental study end where the slope fails.
sed 's/^slope = /replicates = 2\n&/' plan.toml >replicates.toml
"$study" make replicates.toml -o replicates >out.txt
grep -q '32 rows' out.txt || fail "replicates: $(cat out.txt)"
grep -q "stage\[1\].perturbation=1" replicates/Makefile || fail "no perturbation"

# Rows of an incremental study end where the slope fails, beyond 0.06 m: by friction and record at the second, third, third and
# third of 0.1, 0.3 and 0.6 g. Intensities that come in between later compute nothing but themselves: 0.2 g for all, 0.5 g for
# the three that stood at 0.3 g, and nothing above. The table is that of a study that had all of them from the start.
cat plan.toml - >incremental.toml <<'PLAN'
[design]
kind = "incremental"
intensity = "PGA"
measure = "block"
limit = 0.06
PLAN
intensities() { sed -i "s/^values = .* g\"\]/values = [$1]/" incremental.toml; }
intensities '"0.1 g", "0.3 g", "0.6 g"'
"$study" make incremental.toml -o incremental >/dev/null
make_study incremental -j2 || fail "incremental: $(cat "$folder.make")"
[ "$(rows_computed)" -eq 11 ] || fail "not 11 rows: $(cat "$folder.make")"
"$study" status incremental | grep -q '12 rows: 8 completed, 3 collapsed, 1 not needed' ||
    fail "status: $("$study" status incremental)"
make_study incremental -j2 || fail "incremental, again: $(cat "$folder.make")"
[ "$(rows_computed)" -eq 0 ] || fail "computed again: $(cat "$folder.make")"
intensities '"0.1 g", "0.2 g", "0.3 g", "0.5 g", "0.6 g", "0.9 g"'
make_study incremental -j2 || fail "more intensities: $(cat "$folder.make")"
[ "$(rows_computed)" -eq 7 ] || fail "not 7 rows more: $(cat "$folder.make")"
table_of incremental >incremental.csv
"$study" make incremental.toml -o fresh >/dev/null
make_study fresh -j2 || fail "incremental from the start: $(cat "$folder.make")"
table_of fresh | cmp - incremental.csv || fail "intensities that were added later give another table"
awk -F, 'NR == 1 { for (k = 1; k <= NF; ++k) column[$k] = k; next }
    $column["status"] == "not needed" { ++rows; if ($column["block (m)"] != "") exit 1
        if (($column["PGA (m/s2)"] / $column["PGA"] - 1) ^ 2 > 1e-6) exit 1 } END { exit rows != 9 }' incremental.csv ||
    fail "rows that are not needed: $(cat incremental.csv)"
"$study" fragility incremental --measure block --limit 0.06 --intensity 'Sa(0.5)' | grep -q ': 24 rows, 13 beyond' ||
    fail "rows that are not needed are left out: $("$study" fragility incremental --measure block --limit 0.06 --intensity 'Sa(0.5)')"
"$study" slurm incremental --dry-run | grep -q 'all 24 rows are done' || fail "rows that are not needed are submitted"
"$study" make incremental.toml -o fresh >/dev/null
rm -r fresh/results/*
"$study" slurm fresh --dry-run --max 4 >out.txt
grep -q '^24 rows in 4 tasks' out.txt || fail "a series is computed by several tasks: $(cat out.txt)"
[ "$(cat fresh/slurm/rows/* | wc -l)" -eq 4 ] || fail "not a target for each series"

# What a row of 381 blocks keeps, by its parts: bytes of a frame and of the table for each block, and of a row of the histories.
# A row of 20 s has three frames, and 213 rows of histories: 0.64 MB, and the settled state of all rows takes 2 MB once.
mkdir jointed
cp "$data/jointed-slope/slope.toml" "$data/jointed-slope/run.toml" "$data"/records/artificial-m6.5.at2 jointed
cat >jointed/plan.toml <<'PLAN'
slope = "slope.toml"
run = "run.toml"
set = ["run:stage[1].duration=0.05"]
[[factor]]
name = "record"
key = "run:stage[1].base_motion.x.file"
files = "*.at2"
[[factor]]
name = "PGA"
scale = "PGA"
record = "record"
values = ["0.2 g", "0.3 g"]
PLAN
sed -i 's|"../records/|"|' jointed/run.toml
"$study" make jointed/plan.toml -o jointed/study >/dev/null
make_study jointed/study -j2 || fail "the jointed slope: $(cat "$folder.make")"
row=jointed/study/runs/000001
bytes() { wc -c <"$1"; }
[ "$(grep -c '' $row/blocks.csv)" -ge 380 ] || fail "not the 381 blocks"
"$bin/dda-run" jointed/study/runs/000001/run.toml --from jointed/study/starts/*/stage-1.saved.h5 -o jointed/frames --set output.frames=10 \
    >jointed/log 2>&1 || fail "ten frames: $(cat jointed/log)"
ten=$(($(bytes jointed/frames/slope.vtkhdf) - $(bytes $row/slope.vtkhdf)))
[ $((ten / 9 / 381)) -le 120 ] || fail "$((ten / 9 / 381)) bytes for each frame and block"
[ $(($(bytes $row/blocks.csv) / 381)) -le 330 ] || fail "$(($(bytes $row/blocks.csv) / 381)) bytes of the table for each block"
for table in history relative; do
    line=$(tail -n 1 $row/$table.csv | wc -c)
    [ "$line" -le 700 ] || fail "$line bytes of a row of $table.csv"
done
others=$(find $row/ -type f ! -name '*.vtkhdf' ! -name '*.csv' -exec cat {} + | wc -c)
[ "$others" -le 20000 ] || fail "$others bytes in $(ls $row/)"

# Bad plans: one line, nothing written.
plan_refused() {
    expected=$1
    sed "$2" plan.toml >bad.toml
    run_refused "$expected" "$study" make bad.toml -o refused
    [ ! -e refused/Makefile ] || fail "a Makefile after '$expected'"
}
plan_refused 'bad.toml:4:.*unknown key .facter.' 's/^\[\[factor\]\]/[[facter]]/'
plan_refused "no factor 'recrd' before this one; expected perhaps 'record'" 's/^record = "record"/record = "recrd"/'
plan_refused "no file matches 'records/\*.at2'" 's/records.\*.csv/records\/*.at2/'
plan_refused "is no intensity measure; expected .PGA" 's/^scale = "PGA"/scale = "PGG"/'
plan_refused "names no key; expected slope:KEY or run:KEY" 's/run:joint/joint/'
plan_refused "unknown key 'frction_angle'.*did you mean 'friction_angle'" 's/plane.friction/plane.frction/'
plan_refused "an index below that" 's/stage\[1\].base/stage[7].base/'
plan_refused 'has no values' 's/^values = \["25 deg", "27 deg"\]//'
plan_refused 'no-such.toml: cannot be read' 's/run.toml/no-such.toml/'
# Two values that are each right, and wrong together: steps of 10 ms to at least 1 ms, or of 0.5 ms to at least 0.1 ms.
cat plan.toml - >together.toml <<'PLAN'
[[factor]]
name = "step"
key = "run:stage[1].step"
values = [0.01, 0.0005]
[[factor]]
name = "least step"
key = "run:stage[1].smallest_step"
values = [0.0001, 0.001]
PLAN
run_refused 'row 4 and [0-9]* combinations more, friction = .25 deg., .*step = 5e-04, least step = 0.001: .*larger than the step' \
    "$study" make together.toml -o refused
sed 's/^name = "least step"/&\npair = "step"/' together.toml >paired.toml
run_refused 'row 2 and' "$study" make paired.toml -o refused
sed -i 's/^values = .0.0001, 0.001./values = [0.001, 0.0001]/' paired.toml
"$study" make paired.toml -o paired >/dev/null
run_refused 'is no study' "$study" status records
run_refused "unknown subcommand 'colect'; expected perhaps 'collect'" "$study" colect one
run_refused 'output is not given' "$study" make plan.toml
"$study" --template | grep -q '^\[\[factor\]\]' || fail "no template"
"$study" --help | grep -q collect || fail "no help"
"$study" status --help | grep -q 'expected\|how long' || fail "no help of a subcommand"
echo "studies: all checks passed"
