"""Read the results of dda-run.

    import rockslope
    run = rockslope.open("out")
    run.history            # motion of the measured points, a row for each time and point
    run.blocks(12.0)       # the blocks at the frame nearest to 12 s, a row for each
    run.contacts("last")   # the contacts of the last frame

Tables are pandas.DataFrame, in SI units and radians, per metre of thickness. Needs h5py, numpy and pandas.
"""

from .run import Run

__all__ = ["Run", "open"]
__version__ = "0.1.0"


def open(folder):
    """The run whose results are in `folder`. Raises FileNotFoundError where dda-run has written none."""
    return Run(folder)
