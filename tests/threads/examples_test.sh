#!/bin/sh
# Three examples give the same bytes on one thread and on two. The thread sanitizer runs them on two threads alone, cut by the blockgen
# of another build.
#   [BLOCKGEN=PROGRAM] [THREADS=2] examples_test.sh BIN_FOLDER DATA
set -eu
bin=$1
data=$2
blockgen=${BLOCKGEN:-$bin/blockgen}
# shellcheck source=tests/cli/common.sh
. "$(dirname "$0")/../cli/common.sh"
mkdir records
cp "$data/records/artificial-m6.5.at2" records

# compare EXAMPLE SECONDS [SETTING...]: runs an example on one thread and on two, shaken for some seconds.
compare() {
    example=$1 seconds=$2
    shift 2
    mkdir "$example"
    cd "$example"
    # The files alone: folders are those of a run in the example's own folder.
    for file in "$data/$example"/*; do
        [ -d "$file" ] || cp "$file" .
    done
    "$blockgen" slope.toml -o slope.blocks >/dev/null 2>&1
    for threads in ${THREADS:-1 2}; do
        "$bin/dda-run" run.toml -o "$threads" --threads "$threads" --set "stage[1].duration=$seconds" --set output.frames=5 "$@" \
            >/dev/null 2>err.txt || fail "$example on $threads threads: $(cat err.txt)"
    done
    # The summary has the time that the run took.
    [ "${THREADS:-1 2}" = 2 ] || for file in 1/*.vtkhdf 1/*.csv; do
        cmp "$file" "2/${file#1/}" || fail "$example: ${file#1/} differs on two threads"
    done
    cd ..
}
compare jointed-slope 0.05
compare slope-study 0.25
compare granite-shear 0.5
echo "threads: all checks passed"
