#!/bin/sh
# Small inputs that went wrong once: each gives the right answer, and no energy from nowhere. They may not be
# redistributed, so the test is skipped where they are not beside the sources.
#   known_cases_test.sh BIN_FOLDER SHARED_FOLDER [slow]
set -eu
run=$1/dda-run
shared=${DDA_SHARED:-$2}/cases
[ -d "$shared" ] || {
    echo "no $shared: skipped"
    exit 77
}
slow=${3:-}
# shellcheck source=tests/cli/common.sh
. "$(dirname "$0")/common.sh"

# run_case NAME: runs it and requires that it completes, and that no account gives energy beyond a thousandth of the
# energy turned over.
run_case() {
    echo "$1"
    (cd "$shared/$1" && "$run" run.toml -o "$folder/$1" --threads 1) >"$folder.out" 2>"$folder.err" ||
        fail "$1: $(tail -n 1 "$folder.err")"
    awk -F '[:,]' '
        /"energy"/ { inside = 1 }
        inside { gsub(/[" ]/, "", $1); value[$1] = $2 }
        inside && /}/ { exit }
        END {
            least = -1e-3 * (value["external_work"]^2)^0.5 - 1e-3 * (value["gravity"]^2)^0.5
            for (name in value)
                if ((name ~ /^(friction_loss|released|numerical_loss)$/ && value[name] < least) ||
                    (name == "friction_returned" && -value[name] < least)) {
                    print name, value[name]
                    wrong = 1
                }
            exit wrong
        }' "$1/summary.json" >"$folder.energy" || fail "$1: energy from nowhere: $(cat "$folder.energy")"
}

# displacement NAME COLUMNS [UNTIL]: the length of these columns of relative.csv in its last row, up to a time (s) of
# the last stage.
displacement() {
    grep -v '^#' "$1/relative.csv" | awk -F , -v columns="$2" -v until="${3:-1e9}" '
        NR == 1 { next }
        $2 != stage { stage = $2; start = $1 }
        $1 <= start + until + 1e-9 { x = columns ~ /x/ ? $3 : 0; y = columns ~ /y/ ? $4 : 0; value = sqrt(x^2 + y^2) }
        END { print value }'
}

# between VALUE LEAST MOST NAME
between() {
    awk -v value="$1" -v least="$2" -v most="$3" 'BEGIN { exit !(value >= least && value <= most) }' ||
        fail "$4: $1 m, expected $2 to $3"
}

if [ "$slow" ]; then
    run_case rough-slope
    between "$(displacement rough-slope xy)" 0 5 rough-slope
    run_case crawls
    echo "known slow cases: all checks passed"
    exit 0
fi

for name in bond-broken-by-loading chip no-step glued; do run_case $name; done
run_case dilating-flat # 61.1 mm of a rigid block
between "$(displacement dilating-flat x 0.6)" 0.0598 0.0624 dilating-flat
run_case rough-kick # 96 to 124 mm as the landing is damped
between "$(displacement rough-kick x)" 0.090 0.130 rough-kick
# The block rocks, leaves its joint and lands. Its slip is 0.45 to 0.51 m at steps of 0.1 to 5 ms, without a trend, and
# 0.38 to 0.41 m of a rigid block that cannot rock. It was 1.0 to 2.1 m when an open joint did not follow its walls.
run_case rough-25deg
between "$(displacement rough-25deg xy)" 0.44 0.52 rough-25deg
# The peak of 113 mm is that of a rigid block with a critically damped contact; undamped it swings, and the soft spring
# loses up to 10 % of it. It was 832 to 1116 mm.
run_case bb-flat-pulse
between "$(displacement bb-flat-pulse x)" 0.101 0.119 bb-flat-pulse
run_case rough-sinks
grep -v '^#' rough-sinks/relative.csv | awk -F , 'NR > 1 && $4 < -1e-3 { exit 1 }' || fail "the block sinks into the base"
echo "known cases: all checks passed"
