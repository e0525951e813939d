#!/bin/sh
# Runs the commands of a page of the guide, in their order, in a fresh copy of data/, and compares what they print with what
# the page shows.
#   run_page.sh BIN ROOT PAGE short|long|write
# `short` ends at the first mark `long`. `write` runs all, puts the figures of the programs into the sessions of the page, and
# lists what it found, sentences that no longer hold among it; its exit code is 0. A page of data/ begins in its own folder,
# another one beside data/.
#
# What a page shows is one of these; another block, or a command within a sentence that no block has, fails the test.
#   ```console          a session: a command behind "$ ", then all that it prints; "..." stands for any lines, or for a word
#                       that varies, such as the time a program took. A command without a line behind it is only run.
#   ```sh               commands that are only run
#   ```toml NAME        a file, whole
#   ```toml part of NAME    paragraphs that stand in this file, comments aside
#   ```text             neither
# Marks stand in comments, each at the begin of a line:
#   <!-- run: COMMAND -->       a command that the reader does not need, such as one that makes a file
#   <!-- says: COMMAND -->      the lines that the command prints must stand in the text of the page, wherever its lines end
#   <!-- exit 1: REASON -->     the commands of the next block end with this exit code
#   <!-- long: REASON -->       all that follows takes long
#   <!-- not run: REASON -->    nobody runs the next block
# The exit code of every command is 0 but for these marks. The numbers of a page are those of the program, digit by digit;
# where they depend on the processor, the page shows fewer digits or a range, and a command of `says` prints it.
set -eu
bin=$(cd "$1" && pwd)
root=$(cd "$2" && pwd)
page=$(cd "$(dirname "$3")" && pwd)/$(basename "$3")
mode=$4
tests=$(cd "$(dirname "$0")" && pwd)
# shellcheck source=tests/cli/common.sh
. "$tests/../cli/common.sh"
name=${page#"$root"/}
state=$folder/state
steps=$folder/steps
faults=$folder/faults
mkdir "$state" "$steps" tree home
: >"$faults"
: >"$steps/list"
: >"$state/renewed"

copy_examples() {
    # Results are a folder deeper, or blocks and reports.
    (cd "$root" && find data -maxdepth 2 -type f ! -name '*.blocks*' ! -name '*.report.json' -print0 | tar --null -cf - -T -) |
        tar -C tree -xf -
    case $name in
    data/*) echo "$folder/tree/${name%/*}" ;;
    *) echo "$folder/tree" ;;
    esac >"$state/folder"
}

# run_step FILE: in the folder and with the variables that the step before left.
run_step() {
    # shellcheck disable=SC2016 # expanded by the shell that is called
    sh -e -c '. "$1/variables"; cd "$(cat "$1/folder")"; . "$2"; pwd >"$1/folder"; export -p >"$1/variables"' sh "$state" "$1" </dev/null
}

fault() {
    echo "$name:$1" >>"$faults"
}

# run_commands NUMBER LINE EXIT_CODE KIND: a command that ends otherwise ends the test, for what follows may need its results.
run_commands() {
    code=0
    if [ "$4" = says ]; then
        run_step "$steps/$1" >"$steps/$1.printed" 2>"$steps/$1.messages" || code=$?
    else
        run_step "$steps/$1" >"$steps/$1.printed" 2>&1 || code=$?
        : >"$steps/$1.messages"
    fi
    [ "$code" -eq "$3" ] && return
    fault "$2: exit code $code, expected $3, of"
    cat "$steps/$1" "$steps/$1.printed" "$steps/$1.messages" >>"$faults"
    report
}

compare_session() {
    awk -v name="$name" -v renewed="$state/renewed" -f "$tests/compare.awk" "$steps/$1.shown" "$steps/$1.printed" >>"$faults"
}

# The lines that a command prints must stand in the page's text.
compare_text() {
    while IFS= read -r said; do
        grep -qF -e "$said" "$steps/prose" || fault "$2: the text must say '$said'"
    done <"$steps/$1.printed"
    [ -s "$steps/$1.printed" ] || fault "$2: the command prints nothing"
}

# Each paragraph of the block must stand in the file, comments and empty lines aside.
compare_part() {
    awk -v name="$name" -v line="$2" -v file="$3" '
        { sub(/ *#.*/, ""); sub(/ +$/, "") }
        FNR == NR { if ($0 != "") text = text "\n" $0; next }
        $0 != "" { paragraph = paragraph "\n" $0 }
        function check() {
            if (paragraph != "" && !index(text "\n", paragraph "\n")) print name ":" line ": not in " file ":" paragraph
            paragraph = ""
        }
        $0 == "" { check() }
        END { check() }' "$(cat "$state/folder")/$3" "$steps/$1" >>"$faults"
}

renew_page() {
    awk -F '\t' '
        FNR != NR { print FNR in line ? line[FNR] : $0; printf "%s", more[FNR + 0]; next }
        { text = substr($0, length($1) + 2) }
        sub(/\+$/, "", $1) { more[$1] = more[$1] text "\n"; next }
        { line[$1] = text }' "$state/renewed" "$page" >"$folder/page"
    cat "$folder/page" >"$page"
}

report() {
    [ "$mode" = write ] && [ -s "$state/renewed" ] && renew_page
    [ -s "$faults" ] || exit 0
    cat "$faults"
    [ "$mode" = write ]
    exit
}

long=1
[ "$mode" = short ] && long=0
awk -v steps="$steps" -v name="$name" -v long=$long -f "$tests/page.awk" "$page" >>"$faults"
copy_examples
unset MAKEFLAGS MAKELEVEL MFLAGS OUT PICTURES RECORD RUN_FLAGS BLOCKGEN_FLAGS DDA_SHARED
export PATH="$bin:$PATH" BIN="$bin" HOME="$folder/home" LC_ALL=C
export -p >"$state/variables"
while read -r number kind line code argument <&3; do
    case $kind in
    file) cp "$steps/$number" "$(cat "$state/folder")/$argument" ;;
    part) compare_part "$number" "$line" "$argument" ;;
    *) run_commands "$number" "$line" "$code" "$kind" ;;
    esac
    case $kind in
    session) [ ! -s "$steps/$number.shown" ] || compare_session "$number" ;;
    says) compare_text "$number" "$line" ;;
    esac
done 3<"$steps/list"
report
