#!/bin/sh
# A study on a full disk: one line, nothing half-written, and a later make goes on. The disk is a small file system in memory; ends
# with code 77, which ctest takes for skipped, where none can be mounted.
#   full_disk_test.sh BIN DATA
set -eu
bin=$1
data=$2
study=$bin/dda-study
# shellcheck source=tests/cli/common.sh
. "$(dirname "$0")/common.sh"
mkdir disk
mount -t tmpfs -o size=8M tmpfs disk 2>/dev/null || {
    echo "SKIPPED: no file system can be mounted here"
    exit 77
}
trap 'cd /; umount "$folder/disk"; rm -rf "$folder" "$folder".*' EXIT
cp "$data/incline/slope.toml" "$data/incline/sine.csv" .
sed 's/^duration = .*/duration = 1.2/; s/^step = .*/step = 0.01/; s/^frames = .*//' "$data/incline/run.toml" >run.toml
cat >plan.toml <<'PLAN'
slope = "slope.toml"
run = "run.toml"
[[factor]]
name = "scale"
key = "run:stage[1].base_motion.x.scale"
values = [0.5, 1.0, 1.5, 2.0]
[[measure]]
name = "block"
point = "block"
[profile]
interval = 1
limit = 0.01
PLAN

# leave KIB: fills the disk but for so much.
leave() {
    rm -f disk/fill
    free=$(df -k disk | tail -n 1 | awk '{ print $4 }')
    [ "$free" -le "$1" ] || head -c "$(((free - $1) * 1024))" /dev/zero >disk/fill
}
# full EXPECTED COMMAND...: requires exit code 1 and one line that tells of the disk.
full() {
    expected=$1
    shift
    code=0
    "$@" >/dev/null 2>"$folder.err" || code=$?
    [ "$code" -eq 1 ] || fail "exit code $code of: $*: $(cat "$folder.err")"
    [ "$(wc -l <"$folder.err")" -eq 1 ] || fail "not one line from: $*: $(cat "$folder.err")"
    grep -q "$expected: cannot be written: .*\(No space left\|full\)" "$folder.err" || fail "no '$expected' in: $(cat "$folder.err")"
    [ -z "$(find disk -name '*tmp*')" ] || fail "left by $*: $(find disk -name '*tmp*')"
}

# A plan: no Makefile, or the one that was there.
leave 8
full 'disk/one/.*' "$study" make plan.toml -o disk/one
[ ! -e disk/one/Makefile ] || fail "a Makefile on a full disk"
rm -f disk/fill
"$study" make plan.toml -o disk/one >/dev/null
cp disk/one/Makefile before
leave 0
full 'disk/one/.*' "$study" make plan.toml -o disk/one
cmp before disk/one/Makefile || fail "the Makefile is spoilt"

# Rows: what there is space for is computed, the others fail for that reason, and a later make computes them.
leave 900
code=0
make -C disk/one -j2 >make.txt 2>&1 || code=$?
[ "$code" -eq 2 ] || fail "exit code $code of make on a full disk: $(cat make.txt)"
# Which row is told as the first to fail, and whether the library that writes frames passes the reason on, is a race.
grep -q '^failed, .*not written: .*cannot be written' make.txt || fail "not told why: $(cat make.txt)"
grep -q 'cannot be written: No space left on device' make.txt || fail "not told that the disk is full: $(cat make.txt)"
code=0
"$study" status disk/one >status.txt || code=$?
[ "$code" -eq 1 ] || fail "exit code $code of status"
rm -f disk/fill
make -C disk/one -j2 >make.txt 2>&1 || fail "with space again: $(cat make.txt)"
"$study" make plan.toml -o undisturbed >/dev/null
make -C undisturbed -j2 >make.txt 2>&1
for place in disk/one undisturbed; do
    "$study" collect "$place" >/dev/null
    sed 's/,[^,]*$//' "$place/results.csv"
done | awk '{ ++lines[$0] } END { for (line in lines) if (lines[line] != 2) exit 1 }' || fail "another table after a full disk"

# Tables and pictures: the old ones stay.
for name in results.csv results.sqlite profiles.csv; do cp "disk/one/$name" .; done
for space in 0 8 16; do
    leave $space
    full 'disk/one/.*' "$study" collect disk/one
    for name in results.csv profiles.csv; do cmp "disk/one/$name" "$name" || fail "$name is spoilt"; done
    [ "$(wc -c <disk/one/results.sqlite)" -eq "$(wc -c <results.sqlite)" ] || fail "the database is spoilt"
done
curve="fragility disk/one --measure block --limit 0.05 --intensity PGA --method demands"
leave 0
# shellcheck disable=SC2086
for file in curve.png curve.svg curve.pdf; do full "disk/$file" "$study" $curve --picture "disk/$file"; done
# shellcheck disable=SC2086
full disk/curve.csv "$study" $curve -o disk/curve.csv
full disk/one.html "$study" report disk/one -o disk/one.html
full disk/profile.csv "$study" profile disk/one/runs/000001 --interval 1 --limit 0.1 -o disk/profile.csv
rm -f disk/fill
"$study" collect disk/one >/dev/null || fail "collect with space again"
cmp disk/one/profiles.csv profiles.csv || fail "another table with space again"
echo "full disk: all checks passed"
