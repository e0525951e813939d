#!/bin/sh
# The shipped record is what its recipe makes, byte for byte, and bad command lines leave no file.
#   ground_motion_test.sh PROGRAM RECORDS
set -eu
program=$1
records=$2
# shellcheck source=tests/cli/common.sh
. "$(dirname "$0")/common.sh"
"$program" synthesise --seed 2 -o again.at2 --spectrum again.csv >measures.txt
cmp again.at2 "$records/artificial-m6.5.at2" || fail "the shipped record is not the recipe's"
cmp again.csv "$records/artificial-m6.5-spectrum.csv" || fail "the shipped spectrum is not the record's"
grep -q 'peak acceleration 0.3500 g' measures.txt || fail "peak is not 0.35 g"
rm -- *

refused() {
    expected=$1
    shift
    run_refused "$expected" "$program" "$@"
    [ -z "$(ls)" ] || fail "left behind by $*: $(ls)"
}
refused "synthesise" synthesize -o a.at2
refused "seeed" synthesise -o a.at2 --seeed 2
refused "magnitude" synthesise -o a.at2 --magnitude 12
refused "duration" synthesise -o a.at2 --duration nan
refused "step" synthesise -o a.at2 --step 0
refused "at2 or .csv" synthesise -o a.txt
refused ".svg, .png or .pdf" synthesise -o a.at2 --picture a.gif
refused "no/such/folder" synthesise -o no/such/folder/a.at2
