#!/bin/sh
# A run with --pvd opens in ParaView: all frames, with names, units and stages, warped by their displacement.
#   paraview_test.sh PVPYTHON XVFB_RUN BIN SOURCE [PICTURE]
# ParaView draws under a display of xvfb-run, which must not reset between two connections. PICTURE keeps what it drew, to be looked at.
set -eu
pvpython=$1
xvfb=$2
bin=$3
source=$4
picture=${5-picture.png}
# shellcheck source=tests/cli/common.sh
. "$(dirname "$0")/../cli/common.sh"
cp "$source"/data/incline/*.toml "$source"/data/incline/*.csv .
"$bin/blockgen" slope.toml >cut.txt
"$bin/dda-run" run.toml --pvd --set 'stage[1].duration=2' --set 'stage[1].step=0.004' --set output.frames=12 >run.txt 2>&1 ||
    fail "dda-run: $(tail -n 2 run.txt)"
HOME=$folder PYTHONDONTWRITEBYTECODE=1 "$xvfb" -a -f "$folder/authority" -s "-screen 0 1280x1024x24 -noreset" \
    "$pvpython" "$source/tests/python/check_paraview.py" out "$picture" ||
    fail "ParaView reads the run wrongly"
