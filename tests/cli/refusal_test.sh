#!/bin/sh
# A refused run changes no file, neither its input nor existing results. A full disk and a killed run leave readable results.
#   refusal_test.sh BIN_FOLDER
set -eu
bin=$1
# shellcheck source=tests/cli/common.sh
. "$(dirname "$0")/common.sh"
cat >slope.toml <<'MODEL'
[domain]
outline_file = "outline.csv"
block_material = "rock"
[[joint_set]]
name = "bedding"
angle = "10 deg"
spacing = 1.5
origin = [0, 1]
[[prescribed_block]]
name = "base"
side = "bottom"
[[measured_point]]
name = "crest"
at = [2, 3.9]
MODEL
printf 'x,y\n0,0\n4,0\n4,4\n0,4\n' >outline.csv
{
    echo 'blocks = "slope.blocks"'
    rock_and_bedding
    cat <<'MODEL'
[[stage]]
name = "shake"
kind = "dynamic"
duration = 0.5
[stage.base_motion]
x = { file = "record.csv" }
[output]
frames = 10
MODEL
} >run.toml
printf 'time (s),acceleration (m/s2)\n0,0\n0.1,5\n0.2,-5\n0.3,0\n' >record.csv

"$bin/blockgen" slope.toml >/dev/null
"$bin/dda-run" run.toml -o good 2>/dev/null
cp -r good spoilt

# refused EXPECTED PROGRAM ARGUMENT...: requires exit code 2, one error line that matches EXPECTED, and unchanged files.
# The lock that a killed run leaves is no result.
listing() {
    find . -type f ! -name .dda-run.lock -exec sha256sum {} + | sort -k 2
    find . ! -type f | sort
}
refused() {
    expected=$1
    program=$2
    shift 2
    listing >"$folder.before"
    run_refused "$expected" "$bin/$program" "$@"
    listing >"$folder.after"
    cmp -s "$folder.before" "$folder.after" || fail "$program $* touched: $(diff "$folder.before" "$folder.after")"
}

# Input files are not overwritten, however their paths are written.
refused 'overwrite the model file' blockgen slope.toml --report "$folder/slope.toml"
refused 'overwrite the input file' blockgen slope.toml --report ./outline.csv
refused 'two results are the same file' blockgen slope.toml --report ./slope.blocks
refused 'output is empty' blockgen slope.toml -o ''
refused 'overwrite the model file' dda-run run.toml -o .
refused 'overwrite the model file' dda-run good/run.toml -o good
refused 'overwrite the model file' dda-run run.toml -o new --depfile run.toml
refused 'overwrite the input file' dda-run run.toml -o new --depfile slope.blocks
cp record.csv good/history.csv
refused 'overwrite the input file' dda-run run.toml -o good --set 'stage[0].base_motion.x.file=good/history.csv'
cp spoilt/history.csv good/history.csv
refused 'two results are the same file' dda-run run.toml -o good --depfile good/steps.csv
refused 'two results are the same file' ground-motion synthesise -o a.csv --spectrum a.csv
refused 'seed must not be negative' ground-motion synthesise -o a.csv --seed -1
refused 'leave no motion' ground-motion synthesise -o a.csv --kappa 1e308

# A run that cannot start leaves existing results unchanged.
refused 'no such folder' dda-run run.toml -o good --depfile nowhere/run.d
refused 'this is a folder' dda-run run.toml -o good --depfile good
refused 'no such folder' ground-motion synthesise -o a.csv --spectrum nowhere/s.csv
rm spoilt/history.csv
mkdir spoilt/history.csv
refused 'history.csv: .*this is a folder' dda-run run.toml -o spoilt
rmdir spoilt/history.csv
refused 'Not a directory' dda-run run.toml -o run.toml
refused 'Not a directory' dda-plot good -o run.toml/pictures

# Result folders that dda-plot refuses.
refused 'contains no' dda-plot nowhere
refused 'history.csv: cannot be read' dda-plot spoilt -o pictures
head -n 1 good/history.csv >spoilt/history.csv
refused 'contains no rows yet' dda-plot spoilt -o pictures
sed '1s/crest uy/crest vy/' good/history.csv >spoilt/history.csv
refused 'no column .crest uy' dda-plot spoilt -o pictures
for file in run.vtkhdf run.joints.vtkhdf; do
    cp good/* spoilt
    : >spoilt/$file
    refused 'cannot be read as HDF5' dda-plot spoilt -o pictures
    head -c 3000 good/$file >spoilt/$file
    refused 'cannot be read as HDF5' dda-plot spoilt -o pictures
done

# A run killed between writing a frame of blocks and its contacts leaves an incomplete frame; the others are drawn.
"$bin/dda-run" run.toml -o fewer --set output.frames=5 2>/dev/null
cp good/* spoilt
cp fewer/run.joints.vtkhdf spoilt
"$bin/dda-plot" fewer --frames all -o whole_pictures
"$bin/dda-plot" spoilt --frames all -o pictures || fail "an incomplete frame prevents drawing the others"
drawn=$(find pictures -type f | wc -l)
[ "$drawn" -eq "$(find whole_pictures -type f | wc -l)" ] || fail "$drawn pictures of the complete frames"
rm -r pictures whole_pictures

# A killed run can be drawn, and resumed only from its own files. Checkpoints are written every 0.05 s of wall time.
sed -e 's/duration = 0.5/duration = 1000/' -e 's/frames = 10/frames = 2000\ncheckpoint_interval = 0.05/' run.toml >long.toml
"$bin/dda-run" long.toml -o killed 2>/dev/null &
pid=$!
while [ ! -e killed/checkpoint.h5 ]; do sleep 0.05; done
kill -9 $pid
wait $pid 2>/dev/null || true
"$bin/dda-plot" killed -o pictures || fail "a killed run cannot be drawn"
rm -r pictures
corrupt() {
    rm -rf spoilt
    cp -r killed spoilt
}
corrupt
refused 'but it is requested now' dda-run long.toml -o spoilt --resume --pvd
refused 'belongs to a run of other input' dda-run run.toml -o spoilt --resume
for file in history.csv steps.csv long.vtkhdf long.joints.vtkhdf; do
    corrupt
    rm spoilt/$file
    refused "$file: cannot be resumed from" dda-run long.toml -o spoilt --resume
    head -c 100 killed/$file >spoilt/$file
    refused "$file: cannot be resumed from" dda-run long.toml -o spoilt --resume
done
for bytes in 0 100 5000; do
    corrupt
    head -c $bytes killed/checkpoint.h5 >spoilt/checkpoint.h5
    refused 'checkpoint.h5: cannot be resumed from' dda-run long.toml -o spoilt --resume
done

# A disk that is full from the start, and disks that fill up: a limit of the file size, in blocks of 512 bytes.
for blocks in 0 1 8 64 800 1200; do
    rm -rf full
    (
        ulimit -f "$blocks"
        trap '' XFSZ
        "$bin/dda-run" long.toml -o full 2>&1 || echo "exit code $?"
    ) | cat >"$folder.out"
    grep -q '^exit code 1$' "$folder.out" || fail "on a disk of $blocks blocks: $(cat "$folder.out")"
    grep -q 'cannot be written: File too large' "$folder.out" || fail "said: $(cat "$folder.out")"
done
# The summary fits on a disk on which a frame does not fit.
grep -q '"status": "not written"' full/summary.json || fail "no summary of a run that could not be written"
"$bin/dda-plot" full -o pictures || fail "the frames written before the disk was full cannot be drawn"
echo "refused runs change no file"
