#!/bin/sh
# Installs into a folder and uses what is there, not the build tree: a program that links the libraries, the manual pages,
# the completion of bash.
#   install_test.sh BUILD CONSUMER
set -eu
build=$1
consumer=$2
# shellcheck source=tests/cli/common.sh
. "$(dirname "$0")/../cli/common.sh"

cmake --install "$build" --prefix "$folder/usr" >install.log || fail "cmake --install: $(tail -n 3 install.log)"
PATH="$folder/usr/bin:$PATH"
[ "$(command -v dda-run)" = "$folder/usr/bin/dda-run" ] || fail "dda-run is not installed"

# The program of the guide cuts and settles the incline: the block moves by the compression of its contacts alone.
cmake -S "$consumer" -B consumer -G Ninja -DCMAKE_PREFIX_PATH="$folder/usr" -DCMAKE_BUILD_TYPE=Debug >cmake.log 2>&1 ||
    fail "find_package(rockslope): $(grep -A 5 Error cmake.log)"
cmake --build consumer >cmake.log 2>&1 || fail "the program does not build: $(tail -n 5 cmake.log)"
cp -r usr/share/rockslope/examples/incline model
awk '/^\[\[stage\]\]/ && n++ { exit } { print }' usr/share/rockslope/examples/incline/run.toml >model/run.toml
(cd model && ../consumer/settle) >settled.txt || fail "the program exits with $?: $(cat settled.txt)"
awk '$2 == "0:" || $2 == "1:" { n += 1; if ($3 > 1e-4) exit 1 } END { exit n != 2 }' settled.txt ||
    fail "blocks have not settled: $(cat settled.txt)"

# Manual pages of programs and subcommands.
for page in blockgen dda-run dda-plot joint-shear ground-motion ground-motion-scale; do
    [ -s "usr/share/man/man1/$page.1" ] || fail "no manual page of $page"
done
grep -q 'checkpoint' usr/share/man/man1/dda-run.1 || fail "the page of dda-run does not name its options"

# Completion: options of programs, subcommands, options of subcommands.
# completed WORD...: what bash offers for the last word.
completed() {
    bash -c '. "$0/$1"; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _rockslope; printf "%s\n" "${COMPREPLY[@]}"' \
        "$folder/usr/share/bash-completion/completions" "$@"
}
completed dda-run run.toml --res | grep -qx -- '--resume' || fail "dda-run --res is not completed"
completed ground-motion sc | grep -qx scale || fail "ground-motion sc is not completed"
completed ground-motion scale --ari | grep -qx -- '--arias' || fail "ground-motion scale --ari is not completed"
