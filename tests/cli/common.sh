# shellcheck shell=sh
# What every test of the programs begins with: an empty folder of its own, removed at the end, and `fail`.
# To be sourced. $folder.* are beside the folder for what must not be seen in it.
folder=$(mktemp -d)
trap 'chmod -R u+w "$folder"; rm -rf "$folder" "$folder".*' EXIT
cd "$folder"

# rock_and_bedding: the materials of most runs here.
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

# run_refused EXPECTED COMMAND...: exit code 2, nothing on the standard output, one line that says what was expected.
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
