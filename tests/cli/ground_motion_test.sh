#!/bin/sh
# The artificial record of the project is reproduced byte for byte, and invalid command lines leave no file.
#   ground_motion_test.sh PROGRAM RECORDS
set -eu
program=$1
records=$2
# shellcheck source=tests/cli/common.sh
. "$(dirname "$0")/common.sh"
"$program" synthesise --seed 2 -o again.at2 --spectrum again.csv >measures.txt
cmp again.at2 "$records/artificial-m6.5.at2" || fail "the artificial record is not reproduced"
cmp again.csv "$records/artificial-m6.5-spectrum.csv" || fail "the spectrum of the artificial record is not reproduced"
grep -q 'peak acceleration 0.3500 g' measures.txt || fail "peak is not 0.35 g"
rm -- *

refused() {
    expected=$1
    shift
    run_refused "$expected" "$program" "$@"
    [ -z "$(ls)" ] || fail "left behind by $*: $(ls)"
}
refused "synthesise" synthesize -o a.at2
refused "seeed" synthesise -o a.at2 --seeed 2
refused "magnitude" synthesise -o a.at2 --magnitude 12
refused "duration" synthesise -o a.at2 --duration nan
refused "step" synthesise -o a.at2 --step 0
refused "at2 or .csv" synthesise -o a.txt
refused ".svg, .png or .pdf" synthesise -o a.at2 --picture a.gif
refused "'Font of Nowhere', which is not installed" synthesise -o a.at2 --picture a.svg --font 'Font of Nowhere'
refused "no/such/folder" synthesise -o no/such/folder/a.at2

# Processing a record: the printed measures are the requested ones, and the file reads back the same.
record=$records/artificial-m6.5.at2
expect() {
    expected=$1
    shift
    "$program" "$@" >measures.txt || fail "refused: $*"
    grep -q -e "$expected" measures.txt || fail "no '$expected' from $*: $(cat measures.txt)"
}
expect 'peak acceleration 0.3500 g' show "$record" --spectrum spectrum.csv --picture record.svg
cmp spectrum.csv "$records/artificial-m6.5-spectrum.csv" || fail "show gives another spectrum"
expect 'peak acceleration 0.3500 g' convert "$record" -o same.csv
expect 'samples 4001, step 0.005 s' show same.csv
expect 'samples 4001' show "$record" --format peer
expect 'peak acceleration 0.2000 g' scale "$record" -o scaled.at2 --peak 0.2
expect 'peak acceleration 0.2000 g' show scaled.at2
expect 'Arias intensity 2.500' scale "$record" -o scaled.at2 --arias 2.5
expect 'samples 4001' scale "$record" -o scaled.at2 --ordinate 0.5 --period 0.5 --spectrum at.csv
expect 'duration 5 s' trim "$record" -o part.at2 --from 2 --to 7
expect 'samples 2001, step 0.01 s' resample "$record" -o coarse.at2 --step 0.01
expect 'peak acceleration 0.3500 g' rotate "$record" scaled.at2 -o along.at2 --azimuth 30 --azimuth 120 --section 30
expect 'samples 28001' correct "$record" -o pads.csv --mean 0 --trend 1 --taper 0.5 --high-pass 0.05 --order 4
expect 'velocity [-0-9.]*e-1' correct "$record" -o moved.csv --shift 1 --shift 15
rm -- *

refused "columns\|sample\|time" show "$record" --format csv
refused "is not known" show "$record" --format nonsense
refused "0 records are given; expected 1" show
refused "2 records are given; expected 1" convert a b -o a.at2
refused "at2 or .csv" convert "$record"
refused "overwrite" convert "$record" -o "$record"
refused "exactly one" scale "$record" -o a.at2
refused "exactly one" scale "$record" -o a.at2 --peak 1 --factor 2
refused "go together" scale "$record" -o a.at2 --ordinate 1
refused "peak must be positive" scale "$record" -o a.at2 --peak nan
refused "later than its start" trim "$record" -o a.at2 --from 3 --to 2
refused "step" resample "$record" -o a.at2
refused "10000000 samples" resample "$record" -o a.at2 --step 0
expect 'duration 2 s' trim "$record" -o part.at2 --to 2
expect 'duration 2 s' rotate "$record" part.at2 -o a.at2 --azimuth 0 --azimuth 90 --section 2 2>cut.txt
grep -q '20 s and 2 s: the longer one is cut' cut.txt || fail "rotate does not report the cut: $(cat cut.txt)"
rm -- *
refused "azimuth twice" rotate "$record" "$record" -o a.at2 --azimuth 1 --section 2
refused "10 degrees from parallel" rotate "$record" "$record" -o a.at2 --azimuth 1 --azimuth 181 --section 2
refused "corner frequency" correct "$record" -o a.at2 --high-pass 200
refused "shift twice" correct "$record" -o a.at2 --shift 1
refused "damping" show "$record" --damping 1

# Wavelets, and a record matched to a spectrum.
expect 'peak acceleration 0.2500 g' synthesise --kind sine --peak 0.25 --frequency 2 --cycles 6 -o sine.at2
expect 'duration 3 s' show sine.at2
expect 'duration 2 s' synthesise --kind ricker --peak 0.25 --frequency 2 -o ricker.at2
printf 'period (s),acceleration (g)\n0.05,0.3\n0.15,0.6\n0.4,0.6\n2,0.12\n' >target.csv
expect 'samples 4001' match "$record" -o matched.at2 --target target.csv 2>misfit.txt
grep -q 'off the target by [0-1]\.. % in the mean, [0-3]\.. %' misfit.txt || fail "match is off: $(cat misfit.txt)"
rm -- *
refused "random, sine or ricker" synthesise -o a.at2 --kind square
refused "between 2 and 10000" synthesise -o a.at2 --kind sine --cycles 1
refused "cannot be read\|No such file" match "$record" -o a.at2 --target nowhere.csv
printf 'period,value\n1,2\n2,3\n' >"$folder.csv"
refused "names no acceleration" match "$record" -o a.at2 --target "$folder.csv"
refused "overwrite" match "$record" -o "$folder.csv" --target "$folder.csv"

# Several records in one picture; the history of a run; a record of velocity.
expect 'peak acceleration 0.1750 g' scale "$record" -o half.at2 --factor 0.5
"$program" plot "$record" half.at2 -o both.svg || fail "plot refused"
grep -q 'svg' both.svg || fail "plot drew nothing"
"$program" plot "$record" half.at2 -o narrow.svg --width 85mm --font-size 8 || fail "plot refused"
for_a_column narrow.svg
expect 'peak acceleration 0.3500 g over 0.1750 g: 2.000' amplification "$record" half.at2 -o ratio.csv --picture ratio.png
[ "$(wc -l <ratio.csv)" -eq 62 ] || fail "not 61 periods"
awk -F, 'NR > 1 && ($5 < 1.999 || $5 > 2.001 || $6 < 1.999 || $6 > 2.001) { exit 1 }' ratio.csv || fail "a ratio is not 2"
awk 'BEGIN { print "time (s),stage,top ax (m/s2),prescribed base ax (m/s2)"
             for (k = 0; k <= 400; ++k) { a = sin(0.3 * k); printf "%.2f,shake,%.9f,%.9f\n", k / 100, 3 * a, a } }' >history.csv
expect 'over 0.1020 g: 3.000' amplification history.csv history.csv --point 'top x' --point 'base x'
expect 'peak acceleration 0.3059 g' convert history.csv --point 'top x' -o top.at2
awk 'BEGIN { print "time (s),stage,top ux (m),top uy (m)"
             for (k = 0; k <= 100; ++k) printf "%.2f,shake,%.9f,%.9f\n", k / 100, 0.003 * k, -0.004 * k }' >relative.csv
cp relative.csv other.csv
expect '^one,1,0.30000,-0.40000,0.50000,0.50000,1$' compare relative.csv other.csv --label one --label two --point top \
    -o table.csv --picture tracks.svg
cmp table.csv measures.txt || fail "the table is not what is printed"
grep -q svg tracks.svg || fail "compare drew nothing"
awk 'BEGIN { print "time (s),velocity (m/s)"
             for (k = 0; k <= 1000; ++k) printf "%.3f,%.12f\n", k / 200, sin(k / 100) }' >velocity.csv
expect 'peak acceleration 0.2039 g' convert velocity.csv -o acceleration.csv 2>note.txt
grep -q 'contains velocity; it is differentiated' note.txt || fail "no note on the velocity: $(cat note.txt)"
rm -- *
refused "expected one or more" plot -o a.png
refused ".svg, .png or .pdf" plot "$record" -o a.csv
refused "0 runs are given" compare --point top
refused "1 labels are given; expected 2" compare a.csv b.csv --point top --label one
refused "no heading of a run" compare "$record" --point top
refused "1 records are given; expected 2" amplification "$record"
refused "for one file each" show "$record" --point 'a x' --point 'b x'
refused "file holds no points" show "$record" --point 'a x'
refused "must be acceleration, velocity or displacement" show "$record" --quantity speed
refused "the file holds acceleration" show "$record" --quantity velocity

# Newmark's block.
expect 'yield acceleration 0.1763 g' slide "$record" --dip 20 --friction 30
grep -q 'falling towards +x: slip 0\.[0-9]* m, first at' measures.txt || fail "no slip: $(cat measures.txt)"
expect 'falling towards -x: no slip' slide "$record" --dip 20 --friction 50
rm -- *
refused "below 90 degrees" slide "$record" --dip -1 --friction 30
refused "friction" slide "$record" --dip 20
