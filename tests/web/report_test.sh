#!/bin/sh
# The report of a block that slides on an incline, opened in Chromium.
#   report_test.sh PYTHON BIN SOURCE CHROMEDRIVER CHROMIUM
# RENEW=1 writes the picture that the view is compared with.
set -eu
python=$1
bin=$2
source=$3
chromedriver=$4
chromium=$5
# shellcheck source=tests/cli/common.sh
. "$(dirname "$0")/../cli/common.sh"
cp "$source"/data/incline/*.toml "$source"/data/incline/*.csv .
"$bin/blockgen" slope.toml >cut.txt
"$bin/dda-run" run.toml --set 'stage[1].step=0.002' --set 'stage[1].duration=2' --set output.frames=40 >run.txt 2>&1 ||
    fail "dda-run: $(tail -n 2 run.txt)"
"$bin/dda-plot" out --report report.html || fail "no report"
[ "$(wc -c <report.html)" -lt 200000 ] || fail "the report has $(wc -c <report.html) bytes"
grep -q "http[s]\{0,1\}://" report.html && fail "the report names an address"
run_refused 'a name that ends in .html' "$bin/dda-plot" out --report report.pdf
HOME=$folder PYTHONDONTWRITEBYTECODE=1 "$python" "$source/tests/web/check_report.py" "$chromedriver" "$chromium" report.html \
    "$source/tests/web/incline-view.png" "${RENEW-}" || fail "the page does not work"
