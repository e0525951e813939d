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
