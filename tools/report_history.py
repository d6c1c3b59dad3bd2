"""history.png: what history.csv tells, one panel a quantity."""

import re
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from report_read import read_history


def pressure_columns(history):
    """(height [m], column) of the columns p_<height>m_Pa, from the bottom up."""
    found = []
    for name in history:
        match = re.fullmatch(r"p_(.+)m_Pa", name)
        if match:
            found.append((float(match[1]), name))
    return sorted(found)


def panels(history):
    """(axis label, logarithmic, curves as (label, values)) of the quantities there are."""
    def single(label, column, scale=1.0, log=False):
        return (label, log, [(None, scale * history[column])]) if column in history else None

    pressures = [(f"z = {height:g} m", history[name]) for height, name in pressure_columns(history)]
    found = [
        single("bed height [m]", "bed_height_m"),
        single("bubble diameter [m]", "bubble_diameter_m"),
        ("pressure above\nthe outlet's [Pa]", False, pressures) if pressures else None,
        single("kinetic energy [J]", "kinetic_energy_J"),
        single("ledger residual,\nrelative [-]", "ledger_residual", log=True),
    ]
    return [panel for panel in found if panel]


def draw(folder):
    history = read_history(folder)
    time = history["time_s"]
    shown = panels(history)
    figure, axes = plt.subplots(len(shown), 1, sharex=True, squeeze=False, layout="constrained",
                                figsize=(8, 1.9 * len(shown) + 0.5))
    for axis, (label, log, curves) in zip(axes[:, 0], shown):
        for name, values in curves:
            # A residual may be exactly zero, which a logarithmic axis cannot show.
            shown_values = np.where(values == 0.0, np.nan, np.abs(values)) if log else values
            axis.plot(time, shown_values, linewidth=1.1, label=name)
        if log and np.any(curves[0][1] != 0.0):
            axis.set_yscale("log")
        if len(curves) > 1 or curves[0][0]:
            axis.legend(fontsize=8, loc="center left", bbox_to_anchor=(1.0, 0.5), frameon=False)
        axis.set_ylabel(label)
        axis.grid(alpha=0.3)
        axis.margins(x=0)
    axes[-1, 0].set_xlabel("time [s]")
    figure.align_ylabels()
    figure.savefig(Path(folder) / "history.png", dpi=130)
    plt.close(figure)
