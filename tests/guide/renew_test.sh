#!/bin/sh
# run_page.sh puts the figures of the programs into a page whose figures are wrong.
#   renew_test.sh BIN ROOT
set -eu
tests=$(cd "$(dirname "$0")" && pwd)
# shellcheck source=tests/cli/common.sh
. "$tests/../cli/common.sh"
cp "$tests/planted/faults.md" page.md
"$tests/run_page.sh" "$1" "$2" "$folder/page.md" write >found
grep -q "the page has 'peak acceleration 0.3510 g" found || fail "the fault is not the wrong figure: $(cat found)"
sed '23s/0.3510/0.3500/; 24a\
at the end: velocity -3.0e-09 m/s, displacement -4.4e-08 m\
cumulative absolute velocity 8.288 m/s, mean period 0.556 s' "$tests/planted/faults.md" >expected.md
diff expected.md page.md || fail "the page is not renewed"
