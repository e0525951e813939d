#!/bin/sh
# The water table of a section from the slope model to the run: a block that floats, the same bytes as with the line in the
# run's model, and the refusal where there is none.
#   water_table_test.sh BIN
set -eu
bin=$1
# shellcheck source=tests/cli/common.sh
. "$(dirname "$0")/common.sh"

cat >slope.toml <<'TOML'
[domain]
outline = [[0, 0], [4, 0], [4, 1], [3, 1], [3, 2], [1, 2], [1, 1], [0, 1]]
block_material = "rock"
[[traces]]
joint_material = "bedding"
points = [[1, 1], [3, 1]]
[[fixed_block]]
side = "bottom"
[[measured_point]]
name = "block"
at = [2, 1.5]
[water_table]
line = [[4, 5], [0, 5.5]]
TOML
"$bin/blockgen" slope.toml >/dev/null
grep -q '^water_table_point 0 5.5$' slope.blocks || fail "no water table in the block file"

# The upper block weighs half as much as the water that it displaces.
cat >run.toml <<'TOML'
blocks = "slope.blocks"
[block_material.rock]
density = 500
youngs_modulus = "10 GPa"
poissons_ratio = 0.25
[joint_material.bedding]
law = "mohr-coulomb"
friction_angle = "20 deg"
[analysis]
gravity = [0, -9.81]
[[head_water]]
[[stage]]
kind = "dynamic"
duration = 0.2
step = 0.002
TOML
"$bin/dda-run" run.toml -o section >/dev/null 2>log || fail "$(cat log)"
sed 's/^\[\[head_water\]\]/&\nhead = "section"/' run.toml >named.toml
"$bin/dda-run" named.toml -o named --set output.name=run >/dev/null 2>log || fail "$(cat log)"
sed 's/^\[\[head_water\]\]/&\nhead = [[0, 5.5], [4, 5]]/' run.toml >written.toml
"$bin/dda-run" written.toml -o written --set output.name=run >/dev/null 2>log || fail "$(cat log)"
for file in history.csv steps.csv run.vtkhdf run.joints.vtkhdf; do
    cmp "section/$file" "written/$file" || fail "$file differs from that with the line in the run's model"
    cmp "section/$file" "named/$file" || fail "$file differs from that of head = \"section\""
done

# A head that slopes by 1 in 8 pushes the block to the side as well. It rises with (unit weight / density - g) = 9.81 m/s2, by
# 0.1962 m in 0.2 s. The pressure on its sides differs by 2 m times the slope of the head, which gives 9810 / 8 N/m3, over 500
# kg/m3 2.4525 m/s2, or 0.04905 m to the right. 0.1 % allows for the block's own strain and the springs of the joint that it
# leaves; 5e-6 was found.
awk -F, '
    NR == 1 { for (i = 1; i <= NF; ++i) column[$i] = i }
    END {
        x = $column["block ux (m)"]; y = $column["block uy (m)"]
        print "moved by", x, y, "m, expected 0.04905 0.1962 m"
        exit !(x > 0.04905 * 0.999 && x < 0.04905 * 1.001 && y > 0.1962 * 0.999 && y < 0.1962 * 1.001)
    }' section/history.csv || fail "the block does not float"

# A block file without a water table.
sed '/water_table/,$d' slope.toml >dry.toml
"$bin/blockgen" dry.toml >/dev/null
run_refused "run.toml:11:1: the block file has no water table to be the head of \[head_water\[0\]\]" \
    "$bin/dda-run" run.toml --blocks dry.blocks -o dry
