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
