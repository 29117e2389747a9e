#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The pressure of the largest contact of a scene under several factors of one load: plot_pressure.py SCENE LOAD PICTURE"""
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import abut

scene, load, picture = sys.argv[1:]

# %% Prepare once: grids follow the contact under the loads as they are given.
session = abut.Session(scene)
result = session.prepare()
strongest = max(range(len(result["contacts"])), key=lambda k: result["contacts"][k]["max_pressure"]["value"])

# %% Ask again under other loads: milliseconds each; new grids where the contact has gone beyond these.
figure, axes = plt.subplots(figsize=(8, 4.5))
for factor in np.linspace(0.5, 1.5, 5):
    session.set_load(load, factor)
    answer = session.answer()
    if answer["doubts"]:
        print("\n".join(f"{load} × {factor:g}: {doubt}" for doubt in answer["doubts"]))
        session.prepare()
        answer = session.answer()
    contact = answer["contacts"][strongest]
    pressed = np.flatnonzero(contact["pressure"] > 0)
    shown = slice(max(pressed[0] - 1, 0), pressed[-1] + 2)
    axes.plot(contact["x"][shown], contact["pressure"][shown], label=f"{load} × {factor:g}")

axes.set_xlabel("x [{}]".format(result["units"]["length"]))
axes.set_ylabel("pressure [{}/{}²]".format(result["units"]["force"], result["units"]["length"]))
axes.set_title(" on ".join(contact["parts"]))
axes.legend()
figure.tight_layout()
figure.savefig(picture, dpi=100)
