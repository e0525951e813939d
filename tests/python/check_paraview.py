"""Opens a run in ParaView as its user does: every frame of blocks and joints, their names, units and stages, the blocks
warped by their displacement, a picture. Run by pvpython, under a display.

    check_paraview.py FOLDER PICTURE
"""

import sys
from pathlib import Path

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

folder, picture = Path(sys.argv[1]), sys.argv[2]
version = (simple.GetParaViewVersion().major, simple.GetParaViewVersion().minor)
frames = 14


def at(source, time):
    """What a reader or a filter gives at a time."""
    source.UpdatePipeline(time)
    grid = simple.servermanager.Fetch(source)
    return grid.GetBlock(0) if grid.IsA("vtkMultiBlockDataSet") else grid


def opened(name):
    source = simple.OpenDataFile(str(folder / name))
    source.UpdatePipelineInformation()
    times = list(source.TimestepValues)
    assert len(times) == frames, f"{name} has {len(times)} frames"
    return source, times


def text(grid, name):
    return grid.GetFieldData().GetAbstractArray(name).GetValue(0)


def values(grid, name):
    return vtk_to_numpy(grid.GetCellData().GetArray(name))


def check_blocks(name):
    source, times = opened(name)
    first, last = at(source, times[0]), at(source, times[-1])
    assert text(first, "stage") == "settle" and text(last, "stage") == "shake"
    assert "displacement: m\n" in text(last, "units")
    assert text(last, "block_names") == "0 base\n" and text(last, "block_materials") == "0 rock\n"
    start = vtk_to_numpy(at(source, times[1]).GetPoints().GetData()).copy()
    for time in times[1:]:
        grid = at(source, time)
        moved = vtk_to_numpy(grid.GetPoints().GetData()) - start
        assert np.allclose(vtk_to_numpy(grid.GetPointData().GetArray("displacement")), moved, atol=1e-5), time
    warp = simple.WarpByVector(Input=source, Vectors=["POINTS", "displacement"], ScaleFactor=9)
    warped = vtk_to_numpy(at(warp, times[-1]).GetPoints().GetData())
    assert np.allclose(warped - start, 10 * moved, atol=1e-3), "nine times the displacement is added"
    return source, warp, times


def check_joints(name, times):
    source, own = opened(name)
    assert own == times
    last = at(source, times[-1])
    assert text(last, "joint_materials") == "0 plane\n" and text(last, "stage") == "shake"
    assert set(values(last, "block")) | set(values(last, "other_block")) == {0, 1}
    assert np.abs(values(last, "slip")).max() > 1e-3
    return source


def check_picture(blocks, joints, time):
    view = simple.CreateRenderView(ViewSize=[900, 600])
    view.ViewTime = time
    shown = simple.Show(blocks, view)
    simple.ColorBy(shown, ("CELLS", "displacement", "Magnitude"))
    shown.RescaleTransferFunctionToDataRange(True)
    shown.SetScalarBarVisibility(view, True)
    simple.ColorBy(simple.Show(joints, view), ("CELLS", "slip"))
    stage = simple.PythonAnnotation(Input=joints, ArrayAssociation="Field Data", Expression="stage.GetValue(0)")
    simple.Show(stage, view)
    view.ResetCamera(True)
    simple.Render(view)
    simple.SaveScreenshot(picture, view)
    reader = vtkPNGReader()
    reader.SetFileName(picture)
    reader.Update()
    red, green, blue = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(int).T[:3]
    ground, slider = (blue > red + 60).mean(), (red > blue + 60).mean()
    assert ground > 0.1 and slider > 0.003, f"blue base: {ground:.3f}, red block: {slider:.4f} of the picture"


blocks, warp, times = check_blocks("incline.pvd")
joints = check_joints("incline.joints.pvd", times)
check_picture(warp, joints, times[-1])
if version >= (5, 12):
    check_joints("incline.joints.vtkhdf", check_blocks("incline.vtkhdf")[2])
else:
    print(f"ParaView {version[0]}.{version[1]} reads no .vtkhdf: the frames of --pvd are checked")
