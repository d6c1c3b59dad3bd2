#!/usr/bin/python3
"""The picture of a calibration: each measured quantity over each parameter and over the order of the
search, with the target and its tolerance.

    tools/calibrate_plot.py DIR [PICTURE.png]
        reads DIR/calibration.csv and DIR/calibration.json, writes DIR/calibration.png
"""

import csv
import json
import sys
import textwrap
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.ticker import MaxNLocator

BAND = "#55a868"
BEST = "#c44e52"


def read(folder):
    with open(folder / "calibration.csv", newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    return rows, json.loads((folder / "calibration.json").read_text(encoding="utf-8"))


def points_of(rows, parameters, target):
    """Number, parameters, mean, standard error and the runs' own values of each point."""
    points = []
    for number in sorted({int(row["point"]) for row in rows}):
        own = [row for row in rows if int(row["point"]) == number]
        values = np.array([float(row[target]) for row in own])
        error = values.std(ddof=1) / np.sqrt(len(values)) if len(values) > 1 else 0.0
        points.append((number, [float(own[0][name]) for name in parameters], values.mean(), error,
                       values))
    return points


def band(axis, target):
    low, high = target["value"] - target["tolerance"], target["value"] + target["tolerance"]
    axis.axhspan(low, high, color=BAND, alpha=0.2, lw=0)
    axis.axhline(target["value"], color=BAND, lw=1.2,
                 label=f"target {target['value']:.4g} $\\pm$ {target['tolerance']:.2g}")


def draw_points(axis, places, points, colours, marked):
    for place, (number, _, mean, error, runs), colour in zip(places, points, colours):
        axis.plot([place] * len(runs), runs, ".", ms=4, color=colour, alpha=0.8)
        axis.errorbar(place, mean, error, fmt="o", ms=6, capsize=3, lw=1.2, color=colour,
                      mec=BEST if marked == number else colour, mew=1.8)


def label_points(axis, places, points, best):
    """Numbers in the order of the search, on the side away from the best value."""
    width, height = np.ptp(axis.get_xlim()), np.ptp(axis.get_ylim())
    taken = []
    for place, (number, _, mean, _, _) in zip(places, points):
        side = -1 if place < best else 1
        near = sum(side == other[0] and abs(place - other[1]) < 0.04 * width
                   and abs(mean - other[2]) < 0.03 * height for other in taken)
        taken.append((side, place, mean))
        axis.annotate(str(number), (place, mean), xytext=(side * (7 + 9 * near), -3), fontsize=8,
                      textcoords="offset points", ha="right" if side < 0 else "left",
                      color="#444444")


def best_line(axis, parameter, target, slope):
    value = parameter["value"]
    error = parameter.get("standard_error", 0.0)
    text = f"{parameter['name']} = {value:.4g}" + (f" $\\pm$ {error:.2g}" if error else "")
    axis.axvline(value, color=BEST, lw=1.0, ls="--", label=text)
    axis.axvspan(value - error, value + error, color=BEST, alpha=0.12, lw=0)
    if slope is not None:
        reach = 0.12 * (parameter["high"] - parameter["low"])
        at = np.array([value - reach, value + reach])
        axis.plot(at, target["mean"] + slope * (at - value), color=BEST, lw=1.0,
                  label="fitted slope")


def main(folder, picture):
    rows, result = read(folder)
    parameters, targets = result["parameters"], result["targets"]
    names = [parameter["name"] for parameter in parameters]
    figure, axes = plt.subplots(len(targets), len(names) + 1, squeeze=False,
                                figsize=(4.9 * (len(names) + 1), 0.6 + 3.7 * len(targets)))
    for line, target in zip(axes, targets):
        points = points_of(rows, names, target["name"])
        colours = plt.cm.viridis(np.linspace(0.9, 0.05, max(len(points), 2)))
        marked = next(point[0] for point in points
                      if np.allclose(point[1], [entry["value"] for entry in parameters], rtol=1e-9))
        for n, (axis, parameter) in enumerate(zip(line, parameters)):
            band(axis, target)
            slope = target["slopes"][n] if "slopes" in target else None
            best_line(axis, parameter, target, slope)
            places = [point[1][n] for point in points]
            draw_points(axis, places, points, colours, marked)
            margin = 0.06 * (parameter["high"] - parameter["low"])
            axis.set_xlim(parameter["low"] - margin, parameter["high"] + margin)
            axis.margins(y=0.14)
            if len(names) == 1:  # else the colours tell, with the picture at the right
                label_points(axis, places, points, parameter["value"])
            axis.set_xlabel(parameter["name"])
            axis.set_ylabel(target["name"])
            axis.legend(fontsize=8, frameon=False)
        band(line[-1], target)
        places = [point[0] for point in points]
        draw_points(line[-1], places, points, colours, marked)
        line[-1].set_xlabel("point, in the order of the search (dots: runs)")
        line[-1].xaxis.set_major_locator(MaxNLocator(integer=True))
        line[-1].margins(0.08)
    for axis in axes.flat:
        axis.grid(True, color="#e5e5e5")
        axis.set_axisbelow(True)
    title = result["command"] + ("" if result["met"] else "   (not met)")
    figure.suptitle("\n".join(textwrap.wrap(title, 60 * (len(names) + 1), break_on_hyphens=False)),
                    fontsize=9, family="monospace")
    figure.tight_layout()
    figure.savefig(picture, dpi=110)


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    where = Path(sys.argv[1])
    main(where, Path(sys.argv[2]) if len(sys.argv) == 3 else where / "calibration.png")
