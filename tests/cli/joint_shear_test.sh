#!/bin/sh
# joint-shear: the same rows for any increment, comparison with a table, no file left after invalid input.
#   joint_shear_test.sh PROGRAM
set -eu
program=$1
# shellcheck source=tests/cli/common.sh
. "$(dirname "$0")/common.sh"

"$program" --template >test.toml
"$program" test.toml -o rows.csv --picture rows.svg >told.txt
grep -q '^granite: 2401 rows; largest shear stress 1.9202 MPa at 1.25 mm' told.txt || fail "$(cat told.txt)"
head -n 1 rows.csv | grep -q '^displacement (m),shear stress (Pa),' || fail "heading of rows.csv"
grep -q '<svg' rows.svg || fail "no picture"
"$program" test.toml -o rows.csv --picture narrow.svg --width 85mm --font-size 8 >told.txt
for_a_column narrow.svg
"$program" test.toml -o again.csv >/dev/null
cmp rows.csv again.csv || fail "not the same bytes twice"

# The misfit to its own rows is zero; laboratory units are converted.
"$program" test.toml -o coarse.csv --set shear_test.increment=0.003 --compare rows.csv >told.txt
grep -q '^misfit of shear stress: rms 0 MPa, largest 0 MPa' told.txt || fail "$(cat told.txt)"
printf '# a laboratory\ndisplacement (mm);temperature (C);shear stress (kPa)\n1.25;20;1920.24\n15;21;813.551\n' >lab.csv
"$program" test.toml -o rows.csv --compare lab.csv --picture rows.png >told.txt
grep -q '^misfit of shear stress: rms 0.007071 MPa, largest 0.01 MPa at 15 mm' told.txt || fail "$(cat told.txt)"
"$program" test.toml -o along.csv --set 'shear_test.path={file="lab.csv"}' >/dev/null
tail -n 1 along.csv | grep -q '^0.015,8035' || fail "a path from a file: $(tail -n 1 along.csv)"

# With a stiff normal boundary the normal stress grows with dilation.
stiff='shear_test.boundary="constant-stiffness"'
"$program" test.toml -o stiff.csv --picture stiff.svg --set "$stiff" --set shear_test.boundary_stiffness=1e9 >/dev/null
awk -F, 'NR > 1 && ($3 - 1e6 - 1e9 * $4 > 1 || $3 - 1e6 - 1e9 * $4 < -1) && $3 > 0 { exit 1 }' stiff.csv ||
    fail "normal stress and dilation do not agree"

# A prescribed normal stress, listed or from the table of the path. A locked loop takes no work.
prescribed='shear_test.boundary="prescribed-stress"'
"$program" test.toml -o loop.csv --set "$prescribed" \
    --set 'shear_test.path=["5 mm", "4.8 mm", "4.8 mm", "4.9 mm", "4.9 mm", "4.8 mm"]' \
    --set 'shear_test.path_stress=[1e6, 1e6, 1.5e6, 1.5e6, 1e6, 1e6]' >told.txt
grep -q 'energy created 0 J/m2' told.txt || fail "$(cat told.txt)"
awk -F, '$1 == 0.0048 && $3 == 1e6 && $7 == "forward unloading" { if (!n++) first = $11; last = $11 }
    END { if (n < 2 || first < 1000 || last - first > 1e-6 || first - last > 1e-6) exit 1 }' loop.csv || fail "work of a loop"
printf 'time (s),displacement (mm),normal stress (MPa)\n0,0,1\n1,5,2\n2,5,0.5\n' >history.csv
"$program" test.toml -o history-rows.csv --set "$prescribed" --set 'shear_test.path={file="history.csv"}' \
    --compare history.csv >told.txt
grep -q '^misfit of normal stress: rms 0 MPa' told.txt || fail "$(cat told.txt)"
tail -n 1 history-rows.csv | grep -q '^0.005,[0-9.]*,5e+05,' || fail "$(tail -n 1 history-rows.csv)"

mkdir refused
cp test.toml lab.csv refused
cd refused
refused() {
    expected=$1
    shift
    run_refused "$expected" "$program" "$@"
    [ "$(ls)" = "lab.csv
test.toml" ] || fail "left behind by $*: $(ls)"
}
refused 'expected joint-shear TEST.toml -o ROWS.csv' -o a.csv
refused 'more than one model file' test.toml test.toml -o a.csv
refused '--output is missing' test.toml
refused '.svg, .png or .pdf' test.toml -o a.csv --picture a.gif
refused 'perhaps\|did you mean' test.toml -o a.csv --set shear_test.lenth=1
refused 'positive number' test.toml -o a.csv --set shear_test.normal_stress=0
refused 'has no displacement other than 0' test.toml -o a.csv --set 'shear_test.path=[0, 0]'
refused 'more than 1e7 rows' test.toml -o a.csv --set shear_test.increment=1e-12
refused 'cannot be compressed' test.toml -o a.csv --set 'shear_test.boundary="constant-volume"'
refused 'boundary_stiffness' test.toml -o a.csv --set "$stiff"
refused 'no stress is given' test.toml -o a.csv --set "$prescribed"
refused 'has 1 stresses for 4 points' test.toml -o a.csv --set "$prescribed" --set 'shear_test.path_stress=[1e6]'
refused "has no column 'normal stress'" test.toml -o a.csv --set "$prescribed" --set 'shear_test.path_stress=[1e6, 1e6, 0, 0]' --compare lab.csv
refused 'no such file\|No such file' test.toml -o a.csv --compare no.csv
refused 'is in .furlong' test.toml -o a.csv --compare /dev/stdin <<END
displacement (furlong)
1
END
refused 'no column .displacement' test.toml -o a.csv --compare /dev/stdin <<END
shear stress (MPa)
1
END
refused 'is not a finite number' test.toml -o a.csv --compare /dev/stdin <<END
displacement (mm),dilation (mm)
1,inf
END
refused 'lab.csv' test.toml -o lab.csv --compare lab.csv
