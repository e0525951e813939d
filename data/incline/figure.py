"""A figure of the results by Python: blocks coloured by displacement beside the history of a point.

    make run && python3 figure.py out figure.png

Needs the module rockslope (installed, or PYTHONPATH=../../python) and Debian's h5py, numpy, pandas and matplotlib.
"""

# %% Read a run.
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection, PolyCollection

import rockslope

run = rockslope.open(sys.argv[1])
blocks = run.blocks("last")
contacts = run.contacts("last")

# %% Displacements relative to the base.
base = blocks[blocks.motion == "prescribed"].iloc[0]
moved = np.hypot(blocks.displacement_x - base.displacement_x, blocks.displacement_y - base.displacement_y)

figure, (section, history) = plt.subplots(1, 2, figsize=(9, 3.6), constrained_layout=True)
polygons = PolyCollection(run.outlines("last"), array=moved, cmap="viridis_r", edgecolor="black", linewidth=0.5)
section.add_collection(polygons)
sliding = contacts[contacts.state == "sliding"]
section.add_collection(LineCollection(sliding[["x0", "y0", "x1", "y1"]].to_numpy().reshape(-1, 2, 2), color="crimson"))
section.set(aspect="equal", xlabel="x (m)", ylabel="y (m)", title=f"t = {run.times[-1]:.2f} s")
section.autoscale()
figure.colorbar(polygons, ax=section, location="bottom", label="displacement from the base (m)")

# %% The history of a point: a row for each time and point.
for point, rows in run.relative.groupby("point"):
    shaking = rows[rows.stage == "shake"]
    history.plot(shaking.time, np.hypot(shaking.ux, shaking.uy), label=point)
history.set(xlabel="time (s)", ylabel="displacement from the base (m)")
history.legend()

figure.savefig(sys.argv[2], dpi=120)
