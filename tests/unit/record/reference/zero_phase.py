#!/usr/bin/python3
"""Writes zero_phase.csv: a record and what SciPy's sosfiltfilt makes of it, to compare the library with.

The record is a sum of sines of 0.03 to 20 Hz under an envelope on a drifting baseline, by closed form, so that the
test can make it again. Run by hand when the cases change; needs python3-scipy (made with 1.10.1).
Columns: k, then one for each case "pass order corner padding"; padding -1 is SciPy's default extension.
"""
import numpy as np
from scipy.signal import butter, sosfiltfilt

STEP, COUNT = 0.01, 1200
CASES = [("highpass", 2, 0.1, 0), ("highpass", 4, 0.05, 0), ("highpass", 4, 0.2, -1), ("highpass", 3, 0.1, -1),
         ("lowpass", 8, 20.0, -1), ("highpass", 1, 0.5, -1)]

t = STEP * np.arange(COUNT)
record = 0.02 + 0.003 * t + 0.05 * np.sin(2 * np.pi * 0.03 * t)
for frequency, amplitude in ((0.4, 0.3), (1.7, 1.0), (5.3, 0.6), (20.0, 0.2)):
    record = record + amplitude * np.exp(-((t - 5) / 3) ** 2) * np.sin(2 * np.pi * frequency * t + frequency)

columns = []
for kind, order, corner, padding in CASES:
    sections = butter(order, corner, kind, fs=1 / STEP, output="sos")
    columns.append(sosfiltfilt(sections, record, padlen=None if padding < 0 else padding))
with open("zero_phase.csv", "w", encoding="ascii") as file:
    file.write("k," + ",".join(" ".join(map(str, case)) for case in CASES) + "\n")
    for k in range(0, COUNT, 7):
        file.write(f"{k}," + ",".join(f"{column[k]:.13g}" for column in columns) + "\n")
