"""The results of one run of dda-run."""

import json
from pathlib import Path

import numpy as np
import pandas as pd

from .frames import Frames

_states = {0: "open", 1: "sliding", 2: "locked"}
_motions = {0: "free", 1: "fixed", 2: "prescribed"}


def _tidy(table, item):
    """A table with a column NAME QUANTITY for each named thing, as a row for each time and name."""
    common = list(table.columns[:2])
    quantities = {}
    for heading in table.columns[2:]:
        name, quantity = _split(heading, item)
        quantities.setdefault(name, {})[heading] = quantity
    parts = []
    for name, headings in quantities.items():
        part = table[common + list(headings)].rename(columns=headings)
        part.insert(2, item, name)
        parts.append(part)
    if not parts:
        return table.assign(**{item: []}) if table.empty else table[common]
    result = pd.concat(parts, ignore_index=True)
    return result.rename(columns={common[0]: "time"})


_joint_quantities = (
    "shear stress over bearing length (Pa)", "normal stress over bearing length (Pa)",
    "shear stress over whole joint (Pa)", "normal stress over whole joint (Pa)", "mobilised ratio",
    "displacement (m)", "dilation (m)", "strength (Pa)", "slip (m)", "state", "stage", "reversals", "cycle",
)


def _split(heading, item):
    """The name of a point or joint in a heading, and the quantity without its unit."""
    if item == "joint":
        for quantity in _joint_quantities:
            if heading.endswith(" " + quantity):
                return heading[: -len(quantity) - 1], quantity.split(" (")[0].replace(" ", "_")
    words = heading.split(" (")[0].split(" ")
    return " ".join(words[:-1]), words[-1]


class Run:
    """The results in a folder. Files are read when they are asked for."""

    def __init__(self, folder):
        self.folder = Path(folder)
        found = [file for file in sorted(self.folder.glob("*.vtkhdf")) if not file.name.endswith(".joints.vtkhdf")]
        if not found:
            raise FileNotFoundError(f"{self.folder}: contains no NAME.vtkhdf; expected the output folder of dda-run")
        self.name = found[0].name[: -len(".vtkhdf")]
        self._blocks = Frames(found[0])
        contacts = self.folder / f"{self.name}.joints.vtkhdf"
        self._contacts = Frames(contacts) if contacts.exists() else None
        self._count = len(self._blocks.times) if self._contacts is None else min(
            len(self._blocks.times), len(self._contacts.times))

    def __repr__(self):
        return f"<rockslope.Run {self.folder}: {len(self.times)} frames to t = {self.times[-1]:g} s>"

    @property
    def times(self):
        """Times of the frames, s."""
        return self._blocks.times[: self._count]

    @property
    def stages(self):
        """Name of the stage of each frame."""
        return self._blocks.stages[: self._count]

    @property
    def summary(self):
        """How the run ended: summary.json."""
        return json.loads((self.folder / "summary.json").read_text())

    def table(self, file):
        """A table of the folder as it is in the file, such as "steps.csv"."""
        return pd.read_csv(self.folder / file)

    @property
    def history(self):
        """Motion of measured points and prescribed blocks: time, stage, point, ux, uy, vx, vy, ax, ay."""
        return _tidy(self.table("history.csv"), "point")

    @property
    def relative(self):
        """The same relative to the point or block that `relative_to` names."""
        return _tidy(self.table("relative.csv"), "point")

    @property
    def joints(self):
        """The measured joints: time, stage, joint, displacement, stresses, ..."""
        table = self.table("joints.csv")
        return _tidy(table, "joint")

    @property
    def steps(self):
        """The log of the steps."""
        return self.table("steps.csv")

    @property
    def final_blocks(self):
        """The final state of each free block: blocks.csv."""
        return self.table("blocks.csv")

    def blocks(self, when="last"):
        """The blocks of the frame nearest to a time (s, "first" or "last"), indexed by their numbers."""
        k = self._blocks.index(when)
        table = pd.DataFrame(self._blocks.columns(k))
        table.index = pd.Index(table.pop("block").astype(int), name="block")
        table["material"] = _named(table["material"], self._blocks.names("block_materials"))
        table["motion"] = _named(table["motion"], _motions)
        return table

    def outlines(self, when="last"):
        """The outline of each block of a frame, m, in the order of blocks()."""
        k = self._blocks.index(when)
        points = self._blocks.points(k)
        return [points[cell] for cell in self._blocks.cells(k)]

    def contacts(self, when="last"):
        """The contacts of a frame: the ends x0, y0, x1, y1 (m) of each, and its quantities.

        Raises FileNotFoundError where the run has written none."""
        if self._contacts is None:
            raise FileNotFoundError(f"{self.folder}: the run has no {self.name}.joints.vtkhdf")
        k = self._contacts.index(when)
        points = self._contacts.points(k)
        cells = self._contacts.cells(k)
        first = np.array([cell[0] for cell in cells], dtype=int)
        last = np.array([cell[-1] for cell in cells], dtype=int)
        ends = np.hstack([points[first], points[last]]) if len(cells) else np.empty((0, 4))
        table = pd.DataFrame(ends, columns=["x0", "y0", "x1", "y1"]).assign(**self._contacts.columns(k))
        table["state"] = _named(table["state"], _states)
        table["joint_material"] = _named(table["joint_material"], self._contacts.names("joint_materials"))
        table["joint"] = _named(table["joint"], {-1: "", **self._contacts.names("joints")})
        return table


def _named(numbers, names):
    """Numbers by their names; a number without a name stays."""
    return [names.get(int(number), int(number)) for number in numbers]
