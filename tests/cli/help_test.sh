#!/bin/sh
# Every program and subcommand answers --help, whatever else the command line holds, with the options of its manual page and
# of its completion; a misspelt option or subcommand is refused with the nearest one.
#   help_test.sh BIN
set -eu
bin=$1
# shellcheck source=tests/cli/common.sh
. "$(dirname "$0")/common.sh"

# answers COMMAND...: its help, manual page and completion name the same options.
answers() {
    "$@" --help >help.txt 2>error.txt || fail "$* --help exits with $?"
    [ ! -s error.txt ] || fail "$* --help complains: $(cat error.txt)"
    head -n 1 help.txt | grep -q "^Usage: $(basename "$1")" || fail "$* --help has no usage: $(head -n 1 help.txt)"
    "$@" --no-such-option -h | cmp -s - help.txt || fail "$* does not answer -h beside an unknown option"
    "$@" --help-man >page.1 || fail "$* --help-man exits with $?"
    "$@" --help-words | sed -n 's/^--\([a-z-]*\).*/\1/p' >words.txt
    grep -qx help words.txt || fail "the completion of $* has no --help"
    while read -r option; do
        grep -q -e "--$option\>" help.txt || fail "$* --help has no --$option"
        sed 's/\\-/-/g' page.1 | grep -q -e "--$option\>" || fail "the page of $* has no --$option"
    done <words.txt
    sed -n 's/^  \(-[a-z] \[ \)\{0,1\}--\([a-z-]*\).*/\2/p' help.txt | sort >shown.txt
    sort words.txt | cmp -s - shown.txt || fail "$* --help has other options than its completion"
}
programs=0
for program in "$bin"/*; do
    if [ ! -f "$program" ] || [ ! -x "$program" ]; then continue; fi
    answers "$program"
    programs=$((programs + 1))
    "$program" --help-words | sed -n 's/^\([a-z][a-z-]*\) $/\1/p' >subcommands.txt
    while read -r subcommand; do answers "$program" "$subcommand"; done <subcommands.txt
done
[ "$programs" -ge 5 ] || fail "only $programs programs are in $bin"
"$bin/ground-motion" --help-words | grep -c '^[a-z]' | grep -qx 13 || fail "ground-motion has not 13 subcommands"
rm -- *

run_refused "did you mean '--output'?" "$bin/dda-run" run.toml --outptu out
run_refused "did you mean '--history'?" "$bin/dda-plot" out --histroy
run_refused "did you mean '--friction'?" "$bin/ground-motion" slide a.at2 --fricton 3
run_refused "did you mean 'convert'?" "$bin/ground-motion" konvert a.at2
run_refused "the options that --help lists" "$bin/joint-shear" --nothing-like-it
