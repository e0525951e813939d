"""Checks by Debian's VTK that the frames of --pvd are what ParaView 5.11 needs. Without VTK nothing is checked."""

import re
import sys
from pathlib import Path

import numpy as np

try:
    import vtk
    from vtk.util.numpy_support import vtk_to_numpy
except ImportError:
    print("VTK is not here: the frames of --pvd are not read by it")
    sys.exit(0)

folder = Path(sys.argv[1])


def frames(name):
    sets = re.findall(r'timestep="([^"]+)" file="([^"]+)"', (folder / name).read_text())
    for time, file in sets:
        reader = vtk.vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(folder / file))
        reader.Update()
        yield float(time), reader.GetOutput()


def text(grid, name):
    return grid.GetFieldData().GetAbstractArray(name).GetValue(0)


blocks = list(frames("incline.pvd"))
joints = list(frames("incline.joints.pvd"))
assert len(blocks) == len(joints) == 14, (len(blocks), len(joints))
assert [t for t, _ in blocks] == [t for t, _ in joints]
first, last = blocks[1][1], blocks[-1][1]
assert text(blocks[0][1], "stage") == "settle" and text(last, "stage") == "shake"
assert "displacement: m\n" in text(last, "units") and text(last, "block_names") == "0 base\n"
assert text(joints[-1][1], "joint_materials") == "0 plane\n"

# The displacement of the points is how far they have moved since the shaking began.
moved = vtk_to_numpy(last.GetPoints().GetData()) - vtk_to_numpy(first.GetPoints().GetData())
assert np.allclose(vtk_to_numpy(last.GetPointData().GetArray("displacement")), moved, atol=1e-6)
assert np.abs(moved).max() > 1e-3
