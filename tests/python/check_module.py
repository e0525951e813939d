"""Checks what the module reads of a run of the incline against the run's own tables."""

import sys

import numpy as np

import rockslope

run = rockslope.open(sys.argv[1])
assert run.name == "incline", run.name
assert run.summary["status"] == "completed"
assert len(run.times) == 14 and run.stages[0] == "settle" and run.stages[-1] == "shake", run.stages

# A row for each time and point, with the numbers of the file.
raw = run.table("history.csv")
history = run.history
assert list(history.columns) == ["time", "stage", "point", "ux", "uy", "vx", "vy", "ax", "ay"], history.columns
block = history[history.point == "block"]
assert len(block) == len(raw)
assert np.array_equal(block.ux, raw["block ux (m)"]) and np.array_equal(block.ay, raw["block ay (m/s2)"])
assert set(history.point) == {"block", "prescribed base"}

# Blocks by number, with names; the free block slides down, the base moves with the record.
blocks = run.blocks("last")
assert list(blocks.index) == [0, 1] and list(blocks.motion) == ["prescribed", "free"]
assert list(blocks.material) == ["rock", "rock"]
final = run.final_blocks.set_index("block")
assert abs(blocks.displacement_x[1] - final["displacement x (m)"][1]) < 1e-6
assert run.blocks("first").displacement_x.abs().max() == 0

# The outline of the block has its area; the contacts lie on the plane between the blocks.
x, y = run.outlines("last")[1].T
area = 0.5 * abs(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1)))
assert abs(area - 3.125 * 1.5625) < 1e-3, area
contacts = run.contacts("last")
assert set(contacts.joint_material) == {"plane"} and "plane" in set(contacts.joint)
assert set(contacts.block) | set(contacts.other_block) == {0, 1}
assert set(contacts.state) <= {"open", "sliding", "locked"}
on_plane = contacts[contacts.joint == "plane"]
weight = 2600 * 9.81 * area
assert 0.5 * weight < on_plane.normal_force.sum() < 1.5 * weight, on_plane.normal_force.sum()

# A time picks the nearest frame.
assert run.blocks(run.times[5] + 1e-6).equals(run.blocks(float(run.times[5])))
try:
    rockslope.open("/nowhere")
except FileNotFoundError as error:
    assert "dda-run" in str(error)
else:
    raise AssertionError("a missing folder is opened")
