#!/bin/sh
# A run gives the same bytes with the kernels of every processor, and with any setting of a BLAS.
#   kernels_test.sh BIN_FOLDER DATA
set -eu
bin=$1
data=$2
run=$bin/dda-run
# shellcheck source=tests/cli/common.sh
. "$(dirname "$0")/common.sh"
mkdir records slope
cp "$data/records/artificial-m6.5.at2" records
cd slope
"$bin/blockgen" "$data/slope-study/slope.toml" -o slope.blocks >/dev/null
sed "s/^duration = .*/duration = 1.5/; s/^frames = 0/frames = 10/" "$data/slope-study/run.toml" >run.toml

run_refused "ROCKSLOPE_KERNEL: is 'none'; expected one of the kernels that this processor can run: " \
    env ROCKSLOPE_KERNEL=none "$run" run.toml -o refused
kernels=$(sed 's/.*can run: //; s/,//g' "$folder.err")
[ "$(echo "$kernels" | wc -w)" -gt 1 ] || echo "one kernel only: $kernels"

# differ_nowhere FOLDER FOLDER: but for the summary, which has the time that the run took.
differ_nowhere() {
    for file in slope.vtkhdf slope.joints.vtkhdf history.csv steps.csv blocks.csv; do
        cmp "$1/$file" "$2/$file" || fail "$file differs in $1 and $2"
    done
}
for solver in multifrontal refined; do
    "$run" run.toml -o "$solver" --set "analysis.solver=$solver" >/dev/null 2>err.txt || fail "$solver: $(cat err.txt)"
    grep -q '"same_bytes_on": ".*processor.*, with any number of threads"' "$solver/summary.json" || fail "no guarantee"
    for kernel in $kernels; do
        ROCKSLOPE_KERNEL=$kernel "$run" run.toml -o "$solver-$kernel" --set "analysis.solver=$solver" >/dev/null 2>&1
        grep -q "\"kernel\": \"$kernel\"" "$solver-$kernel/summary.json" || fail "not the kernel $kernel"
        differ_nowhere "$solver" "$solver-$kernel"
    done
done
"$run" run.toml -o simplicial --set analysis.solver=simplicial >/dev/null 2>&1
for core in Prescott Haswell Zen; do
    OPENBLAS_CORETYPE=$core "$run" run.toml -o $core --set analysis.solver=simplicial >/dev/null 2>&1
    differ_nowhere simplicial $core
done
# blockgen and dda-study may load one with GDAL, which computes nothing with it.
for program in dda-run dda-plot joint-shear; do
    if [ -f "$bin/$program" ] && ldd "$bin/$program" 2>/dev/null | grep -i blas; then fail "$program loads a BLAS"; fi
done
echo "kernels: all checks passed"
