# shellcheck shell=sh
# Common part of the tests of the programs, to be sourced: changes into an empty temporary folder, removed at the end, and
# defines `fail`. Files that must not appear in the folder are named $folder.*.
folder=$(mktemp -d)
trap 'chmod -R u+w "$folder"; rm -rf "$folder" "$folder".*' EXIT
cd "$folder"

# rock_and_bedding: prints the materials of most runs in these tests.
rock_and_bedding() {
    cat <<'MODEL'
[block_material.rock]
density = 2500
youngs_modulus = "10 GPa"
poissons_ratio = 0.25
[joint_material.bedding]
law = "mohr-coulomb"
friction_angle = "20 deg"
MODEL
}

fail() {
    echo "FAILED: $*" >&2
    exit 1
}

# for_a_column FILE.svg: requires a picture 85 mm wide with letters of 8 pt.
for_a_column() {
    grep -q 'width="240.9[0-9]*pt"' "$1" || fail "$1 is not 85 mm wide: $(grep '<svg' "$1")"
    grep -q 'font-size="8.00"' "$1" || fail "$1 has no letters of 8 pt"
}

# run_refused EXPECTED COMMAND...: requires exit code 2, no standard output, and one error line that matches EXPECTED.
run_refused() {
    expected=$1
    shift
    code=0
    "$@" >"$folder.out" 2>"$folder.err" || code=$?
    [ "$code" -eq 2 ] || fail "exit code $code of: $*: $(cat "$folder.err")"
    [ "$(wc -l <"$folder.err")" -eq 1 ] || fail "not one line from: $*: $(cat "$folder.err")"
    grep -q -e "$expected" "$folder.err" || fail "no '$expected' in: $(cat "$folder.err")"
    [ ! -s "$folder.out" ] || fail "printed to the standard output by: $*"
}

# two_blocks: prints a block file of a block of 2 m x 1 m on a base of 4 m x 1 m that moves as prescribed.
two_blocks() {
    cat <<'BLOCKS'
ddablk 1
counts provenance 0 block_materials 1 joint_materials 1 joints 1 vertices 8 blocks 2 rings 2 corners 10 measured_points 1 bolts 0
block_material rock
joint_material bedding
joint set
vertex 0 0
vertex 4 0
vertex 4 1
vertex 3 1
vertex 1 1
vertex 0 1
vertex 3 2
vertex 1 2
block 0 1 prescribed base
ring 0 1 2 3 4 5
edges - - - 0:0 - -
block 0 1 free
ring 4 3 6 7
edges 0:0 - - -
measured_point crest 1 2 2
end
BLOCKS
}

# settle_and_shake: prints a run of these blocks, by the record record.csv.
settle_and_shake() {
    echo 'blocks = "two.blocks"'
    rock_and_bedding
    cat <<'MODEL'
[[stage]]
name = "settle"
kind = "static"
[[stage]]
name = "shake"
kind = "dynamic"
duration = 1
[stage.base_motion]
block = "base"
x = { file = "record.csv" }
[output]
frames = 10
MODEL
}

# short_record: prints an accelerogram of 0.3 s.
short_record() {
    printf 'time (s),acceleration (m/s2)\n0,0\n0.1,5\n0.2,-5\n0.3,0\n'
}

# pids_with TEXT: prints the processes with TEXT in their command line.
pids_with() {
    for process in /proc/[0-9]*; do
        { tr '\0' ' ' <"$process/cmdline"; } 2>/dev/null | grep -q -F -e "$1" && echo "${process#/proc/}"
    done
    return 0
}

# kill_all_with TEXT: kills these processes, and waits until there is none. TEXT must be of this test alone.
kill_all_with() {
    for process in $(pids_with "$1"); do kill -9 "$process" 2>/dev/null || true; done
    while [ -n "$(pids_with "$1")" ]; do sleep 0.01; done
}
