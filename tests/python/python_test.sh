#!/bin/sh
# The Python module reads a run as the files say, Debian's VTK reads the frames of --pvd, and the example draws its figure.
#   python_test.sh PYTHON BIN SOURCE
set -eu
python=$1
bin=$2
source=$3
# shellcheck source=tests/cli/common.sh
. "$(dirname "$0")/../cli/common.sh"
cp "$source"/data/incline/*.toml "$source"/data/incline/*.csv .
"$bin/blockgen" slope.toml >cut.txt
"$bin/dda-run" run.toml --pvd --set 'stage[1].duration=0.6' --set 'stage[1].step=0.002' --set output.frames=12 >run.txt 2>&1 ||
    fail "dda-run: $(tail -n 2 run.txt)"
export PYTHONPATH="$source/python" PYTHONDONTWRITEBYTECODE=1
"$python" "$source/tests/python/check_module.py" out || fail "the module reads the run wrongly"
"$python" "$source/tests/python/check_vtk.py" out || fail "VTK reads the run wrongly"
"$python" "$source/data/incline/figure.py" out figure.png || fail "the example draws no figure"
[ "$(wc -c <figure.png)" -gt 10000 ] || fail "the figure is empty"
