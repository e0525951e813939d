#!/bin/sh
# Input and machines at their limits: one line and a code, never a crash, a hang or memory without end.
#   limits_test.sh BIN_FOLDER [SANITIZERS]
# shellcheck disable=SC3045
set -eu
bin=$1
sanitizers=${2:-}
run=$bin/dda-run
# shellcheck source=tests/cli/common.sh
. "$(dirname "$0")/common.sh"
two_blocks >two.blocks
settle_and_shake >run.toml
short_record >record.csv

# names COUNT: so many names in a row.
names() {
    yes a | head -n "$1" | paste -sd.
}
# deep FILE: a model with tables 50 000 deep is refused by every program that reads models.
deep() {
    run_refused "$1:[12]: a key has more than 64 names" timeout 60 "$run" "$1" -o deep
    run_refused "$1:[12]: a key has more than 64 names" timeout 60 "$bin/blockgen" "$1"
    run_refused "$1:[12]: a key has more than 64 names" timeout 60 "$bin/joint-shear" "$1" -o rows.csv
}
printf '\n[%s]\nx = 1\n' "$(names 50000)" >header.toml
printf '\n%s = 1\n' "$(names 50000)" >dotted.toml
printf 'x = {%s = 1}\n' "$(names 50000)" >inline.toml
printf '# %s\n[["a" . %s]]\n' "$(names 100)" "$(names 50000)" >array.toml
for file in header dotted inline array; do deep $file.toml; done
run_refused 'the key has more than 64 names' "$run" run.toml -o deep --set "$(names 100)=1"
run_refused 'maximum nested value depth' "$run" /dev/stdin -o deep <<MODEL
x = $(yes '[' | head -n 50000 | tr -d '\n')
MODEL
{ # comments and texts are no keys
    echo "# $(names 100)"
    cat run.toml
} | sed "s/^name = \"settle\"/name = \"$(names 100)\"/" >commented.toml
"$run" commented.toml -o commented >/dev/null 2>err.txt || fail "a comment with points is refused: $(cat err.txt)"

# Lines of a million characters, in keys, values, block files and records.
million=$(head -c 1000000 /dev/zero | tr '\0' k)
# too_long EXPECTED COMMAND...: refused with a line that can be read.
too_long() {
    run_refused "$@"
    [ "$(wc -c <"$folder.err")" -lt 10000 ] || fail "a message of $(wc -c <"$folder.err") characters"
}
{ cat run.toml; echo "$million = 1"; } >key.toml
too_long 'unknown key' "$run" key.toml -o long
{ echo "blocks = \"$million\""; sed 1d run.toml; } >value.toml
too_long 'cannot be read' "$run" value.toml -o long
{ sed 2q two.blocks; echo "joint_material $million $million"; } >long.blocks
too_long 'long.blocks' "$run" run.toml --blocks long.blocks -o long
echo "$million" >long.csv
too_long 'long.csv' "$bin/ground-motion" show long.csv

# A device without an end; pipes, which can be read once.
for file in /dev/zero /dev/urandom; do
    too_long "$file: is too large, or has no end; expected .* 256 MiB" timeout 60 "$run" $file -o endless
    too_long "$file: is too large, or has no end" timeout 60 "$bin/blockgen" $file
    too_long "$file: is too large, or has no end" timeout 60 "$bin/ground-motion" show $file
done
mkfifo model blocks
cat run.toml >model &
cat two.blocks >blocks &
"$run" model --blocks blocks -o piped >/dev/null 2>err.txt || fail "a model from a pipe: $(cat err.txt)"
wait
for file in run.toml two.blocks; do
    grep -q "$(sha256sum <"$file" | cut -d' ' -f1)" piped/summary.json || fail "not the digest of the bytes of $file"
done

# Times that no clock can count.
for key in 'stage[1].duration' 'stage[1].step' 'stage[0].step'; do
    run_refused 'expected a time of at most 1e9 s' "$run" run.toml -o long --set "$key=1e30"
done

# A sanitizer takes all the address space that it can get.
[ -z "$sanitizers" ] || {
    echo "limits: all checks passed but those of memory"
    exit 0
}

# Threads that the system does not start: 1024 stacks do not fit the address space.
code=0
(
    ulimit -v 2000000
    exec timeout 60 "$run" run.toml -o threads --threads 1024 >/dev/null 2>err.txt
) || code=$?
[ "$code" -eq 1 ] || fail "exit code $code where threads cannot be started: $(cat err.txt)"
grep -q '^1024 threads cannot be started, only [0-9]*: ' err.txt || fail "said of threads: $(cat err.txt)"

# Little memory: a whole run, and an end. With a BLAS loaded the program never ended.
(
    ulimit -v 150000
    exec timeout 60 "$run" run.toml -o little --threads 1 >/dev/null 2>err.txt
) || fail "exit code $? in 150 MB of address space: $(cat err.txt)"
cmp little/history.csv piped/history.csv || fail "another history with little memory"
echo "limits: all checks passed"
