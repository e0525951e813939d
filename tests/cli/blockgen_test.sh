#!/bin/sh
# blockgen as users and Makefiles call it: exit codes, one-line errors with their location, no file changed by a failed run.
#   blockgen_test.sh PROGRAM
set -eu
program=$1
# shellcheck source=tests/cli/common.sh
. "$(dirname "$0")/common.sh"
list() {
    find . ! -name before.txt | sort >"$1"
}

cat >slope.toml <<'END'
seed = 42
[domain]
outline = [[0, 0], [40, 0], [40, 30], [0, 30]]
block_material = "rock"
[[joint_set]]
name = "bedding"
angle = "-25 deg"
spacing = { law = "lognormal", mean = 3.0, sd = 0.6, min = 1.0, max = 8.0 }
[[joint_set]]
name = "cross"
angle = "65 deg"
spacing = 4
trace_length = { law = "exponential", mean = 12 }
gap = 1
[[traces]]
joint_material = "fault"
file = "faults of the slope.csv"
[[fixed_block]]
side = "bottom"
[[fixed_block]]
side = "left"
[[fixed_block]]
side = "right"
END
printf 'x1,y1,x2,y2\n3,-1,20,31\n' >'faults of the slope.csv'

# Success: one line of output, all results, identical bytes when repeated.
"$program" slope.toml --picture p.svg --report r.json --depfile d.d --verify >out.txt 2>err.txt
[ "$(wc -l <out.txt)" -eq 1 ] || fail "not one line: $(cat out.txt)"
grep -q 'slope.blocks: .* blocks, D50 .*verified' out.txt || fail "summary: $(cat out.txt)"
[ ! -s err.txt ] || fail "printed to the standard error: $(cat err.txt)"
[ "$(head -n 1 slope.blocks)" = 'ddablk 1' ] || fail 'not a block file'
grep -q '"area_proved": true' r.json || fail 'the report does not confirm the area'
grep -qF 'faults\ of\ the\ slope.csv:' d.d || fail 'the depfile lacks the traces'
printf 'slope.blocks:\n\tfalse\ninclude d.d\n' >Makefile
make -q slope.blocks || fail 'make finds the blocks out of date'
touch -d 1980-01-01 slope.blocks
! make -q slope.blocks 2>make.txt || fail 'make does not see new traces'
"$program" slope.toml -o again.blocks --picture again.svg >out.txt
cmp slope.blocks again.blocks || fail 'not the same bytes'
cmp p.svg again.svg || fail 'not the same picture'
"$program" slope.toml -o other.blocks --seed 43 >out.txt
! cmp -s slope.blocks other.blocks || fail 'the seed changes nothing'
"$program" slope.toml -o wide.blocks --set 'joint_set[0].spacing=30' --set seed=42 >out.txt
! cmp -s slope.blocks wide.blocks || fail '--set changes nothing'
"$program" --template >template.toml
"$program" template.toml --picture t.png --report t.json >out.txt
"$program" slope.toml --print-config >echo.toml
"$program" echo.toml -o echo.blocks >out.txt
grep -v '^provenance' slope.blocks >a.txt
grep -v '^provenance' echo.blocks >b.txt
cmp a.txt b.txt || fail 'the echoed model makes other blocks'
"$program" slope.toml -o k.blocks --threads 3 --vtk k.vtk >out.txt
head -n 1 k.vtk | grep -q '^# vtk DataFile' || fail 'no VTK file'
rm k.vtk
cmp k.blocks slope.blocks || fail 'three threads make other bytes'
"$program" slope.toml -o k.blocks --set 'kinematics.friction_angle="30 deg"' --kinematic-picture k.svg \
    --size-picture s.svg --rose-picture r.svg --report k.txt >out.txt
grep -q 'filled exactly by the blocks' k.txt || fail 'no tables in the report'
[ -s k.svg ] || fail 'no kinematic picture'
[ -s r.svg ] || fail 'no rose diagram'
"$program" slope.toml -o k.blocks --picture n.svg --size-picture ns.svg --rose-picture nr.svg --width 85mm --font 'DejaVu Serif' --font-size 8 >out.txt
for_a_column n.svg
for_a_column ns.svg
for_a_column nr.svg
grep -q 'DejaVu Serif' n.svg || fail 'another font'
[ -s s.svg ] || fail 'no picture of the sizes'
sed 's/^angle = "-25 deg"/dip = "30 deg"\ndip_direction = "110 deg"/' slope.toml >space.toml
"$program" space.toml -o k.blocks --set 'section.azimuth="90 deg"' --stereonet-picture net.svg --width 85mm --font-size 8 >out.txt
for_a_column net.svg
grep -q '30/110, n .*, all parallel  bedding' net.svg || fail 'no plane in the stereonet'
rm space.toml
"$program" --version | grep -q '^blockgen [0-9]' || fail version
"$program" --help | grep -q -- --max-blocks || fail help

# A map, fitted: the model that comes out is cut as it is.
awk 'BEGIN { print "x1,y1,x2,y2"; srand(1)
    for (k = 0; k < 200; ++k) { x = 20 * rand(); y = 20 * rand(); print x "," y "," x + 2 "," y + (k % 2 ? 1 : -2) } }' >map.csv
"$program" fit map.csv -o fitted.toml --report fit.json >out.txt 2>error.txt || fail 'no fit'
grep -q 'fitted.toml: 2 joint sets' out.txt || fail "the map has two sets: $(cat out.txt)"
grep -q 'outline' error.txt || fail 'no word of the outline'
grep -q '"p21"' fit.json || fail 'no P21 in the report of the fit'
"$program" fitted.toml -o fitted.blocks >out.txt 2>error.txt || fail 'the fitted model is not cut'
rm map.csv fitted.toml fit.json fitted.blocks

# Failure: earlier results are unchanged, and no new file appears.
echo old >slope.blocks
list before.txt
refused() {
    expected=$1
    shift
    run_refused "$expected" "$program" "$@"
    list "$folder.now"
    cmp -s "$folder.now" before.txt || fail "a file appeared or vanished after: $*"
    [ "$(cat slope.blocks)" = old ] || fail "slope.blocks was touched by: $*"
}
set_value() { refused "$1" slope.toml --set "$2" --picture new.svg --report new.json --depfile new.d; }

set_value 'spacing' 'joint_set[0].spacng=3'
set_value 'finite' 'domain.outline=[[0, 0], [1, nan], [1, 1]]'
set_value 'enclose no area' 'domain.outline=[]'
set_value 'edge 1 .* and edge 3 .* meet at (0.5, 0.5)' 'domain.outline=[[0, 0], [1, 1], [1, 0], [0, 1]]'
set_value 'block_material' 'domain.block_material=3'
set_value 'too small' 'joint_set[0].spacing=-3'
set_value 'below the grid' 'joint_set[0].spacing=1e-7'
set_value 'blocks in the box round the domain; expected at most 4001000 (four times --max-blocks, 1000000, ' 'joint_set[0].spacing=0.001'
set_value 'slope.toml:9:1.*needs about .*--max-blocks' 'joint_set[1].spacing=0.00003'
refused 'slope.toml:2.*--max-blocks' slope.toml --max-blocks 10
refused '--max-blocks is 200000000; expected a number from 1 to 100000000' slope.toml --max-blocks 200000000
refused '--max-blocks is 0; expected' slope.toml --max-blocks 0
refused '--threads is 0; expected a number' slope.toml --threads 0
refused 'no-such.toml' no-such.toml
refused 'no-such.csv' fit no-such.csv -o new.toml
refused '--sets: expected' fit no-such.csv --sets 0 -o new.toml
refused "did you mean '--sets'?" fit slope.toml --stes 2
refused 'no such folder' slope.toml -o nowhere/slope.blocks
refused 'new.gif' slope.toml --picture new.gif
refused "which is not installed; '.*' would be drawn" slope.toml --picture new.svg --font 'Font of Nowhere'
refused 'friction_angle' slope.toml --kinematic-picture new.svg
refused 'slope.toml.*--stereonet-picture without planes in space; expected a .*dip' slope.toml --stereonet-picture new.svg
refused 'new.gif' slope.toml --stereonet-picture new.gif
refused 'new.gif' slope.toml --size-picture new.gif
refused 'ends in .vtk' slope.toml --vtk new.vtu
refused 'model file' slope.toml -o slope.toml
refused 'different names' slope.toml --report slope.blocks
refused 'pictur' slope.toml --pictur new.svg
refused 'no model file'
if [ "$(id -u)" -ne 0 ]; then
    mkdir shut
    chmod a-w shut
    list before.txt
    refused 'shut/slope.blocks: cannot be written' slope.toml -o shut/slope.blocks
fi
printf '[domain\n' >broken.toml
list before.txt
refused 'broken.toml:1' broken.toml
echo 'blockgen: all checks passed'
