"""Frames of a VTKHDF file of dda-run."""

import os

# A viewer may read the file of a running analysis.
os.environ.setdefault("HDF5_USE_FILE_LOCKING", "FALSE")

import h5py  # noqa: E402: h5py reads the variable when it is imported
import numpy as np  # noqa: E402


class Frames:
    """The frames of a file: times, stages, and the cells and quantities of each."""

    def __init__(self, path):
        self._file = h5py.File(path, "r")
        self._grid = self._file["VTKHDF"]
        self._steps = self._grid["Steps"]
        count = int(self._steps.attrs["NSteps"])
        self.times = self._steps["Values"][:count]
        self.stages = self._stage_of_each(count)

    def _stage_of_each(self, count):
        if "stage" not in self._grid["FieldData"]:
            return [""] * count
        names = [name.decode() for name in self._grid["FieldData/stage"][:]]
        return [names[k] for k in self._steps["FieldDataOffsets/stage"][:count]]

    def text(self, name):
        """A text about the file, such as "units"; empty if it has none."""
        texts = self._grid["FieldData"]
        return texts[name][0].decode() if name in texts else ""

    def names(self, text):
        """The names that a text lists, by their numbers."""
        lines = (line.split(" ", 1) for line in self.text(text).splitlines())
        return {int(number): name for number, name in lines}

    def index(self, when):
        """Number of the frame nearest to a time, s; "first" and "last" are frames too."""
        if len(self.times) == 0:
            raise ValueError("the run has no frames yet")
        if when == "first":
            return 0
        if when == "last":
            return len(self.times) - 1
        return int(np.argmin(np.abs(self.times - float(when))))

    def _start(self, name, k):
        return int(self._steps[name][k])

    def _count(self, name, k):
        return int(self._grid[name][self._start("PartOffsets", k)])

    def points(self, k):
        """Coordinates of the points of frame k, m: an array of two columns."""
        first = self._start("PointOffsets", k)
        return self._grid["Points"][first : first + self._count("NumberOfPoints", k), :2]

    def cells(self, k):
        """The numbers of the points of each cell of frame k."""
        part = self._start("PartOffsets", k)
        first = self._start("CellOffsets", k) + part
        offsets = self._grid["Offsets"][first : first + self._count("NumberOfCells", k) + 1]
        first = self._start("ConnectivityIdOffsets", k)
        points = self._grid["Connectivity"][first : first + self._count("NumberOfConnectivityIds", k)]
        return [points[a:b] for a, b in zip(offsets[:-1], offsets[1:])]

    def columns(self, k):
        """The quantities of the cells of frame k by name; vectors get a suffix for each component."""
        suffixes = {"stress": ("_xx", "_yy", "_xy"), "principal_stress": ("_1", "_2")}
        table = {}
        for name, values in self._grid["CellData"].items():
            first = self._start("CellDataOffsets/" + name, k)
            data = values[first : first + self._count("NumberOfCells", k)]
            if data.ndim == 1:
                table[name] = data
                continue
            for i, suffix in enumerate(suffixes.get(name, ("_x", "_y"))):
                table[name + suffix] = data[:, i]
        return table
