#!/usr/bin/python3
"""The picture of a measurement: what was measured, over the curve it was read from.

    tools/measure_plot.py DIR [PICTURE.png]
        reads DIR/measured.json and DIR/measured_curve.csv, writes DIR/measured.png
"""

import csv
import json
import math
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

BLUE, ORANGE, GREY = "#4c72b0", "#dd8452", "#999999"


def read_curve(folder):
    """Columns of measured_curve.csv by name, in their order; an empty field is NaN."""
    with open(folder / "measured_curve.csv", newline="", encoding="utf-8") as file:
        lines = list(csv.reader(file))
    if not lines:
        raise SystemExit(f"{folder}/measured_curve.csv is empty")
    return {name: [float(line[n]) if line[n] else math.nan for line in lines[1:]]
            for n, name in enumerate(lines[0])}


def last_grains(file):
    """Columns of the last frame of a dump, by name; nothing when there is no such file."""
    if not file.exists():
        return {}
    heading, *lines = file.read_text(encoding="utf-8").split("ITEM: ATOMS ")[-1].splitlines()
    rows = [[float(word) for word in line.split()] for line in lines]
    return dict(zip(heading.split(), zip(*rows)))


def heap(axes, curve, folder, _):
    side, profile = axes
    grains = last_grains(folder / "particles/heap.dump")
    if grains:
        side.scatter(grains["x"], grains["z"], s=9, c=grains["y"], cmap="Greys", lw=0)
        side.set_title("the heap from the side", fontsize=9)
    side.set_xlabel("x [m]")
    side.set_ylabel("z [m]")
    side.set_aspect("equal")
    profile.plot(curve["distance_m"], curve["height_m"], "o-", ms=4, lw=1, color=BLUE,
                 label="mean of the highest tops")
    profile.plot(curve["distance_m"], curve["line_m"], lw=2, color=ORANGE, label="flank, fitted")
    profile.set_xlabel("distance from the axis [m]")
    profile.set_ylabel("height [m]")
    profile.set_aspect("equal")


def bounce(axes, curve, _, quantities):
    axis, histogram = axes
    axis.plot(curve["impact_speed_m_s"], curve["normal_restitution"], "o", color=BLUE,
              label="each grain")
    axis.axhline(quantities["normal_restitution"]["value"], color=ORANGE, label="mean")
    axis.set_xlabel("impact speed [m/s]")
    axis.set_ylabel("normal restitution")
    axis.set_ylim(0, 1.05)
    histogram.hist(curve["normal_restitution"], color=BLUE)
    histogram.set_xlabel("normal restitution")
    histogram.set_ylabel("grains")


# A kind of measurement: the function that draws it, on two axes.
KINDS = {"angle_of_repose": heap, "normal_restitution": bounce}


def main(folder, target):
    measured = json.loads((folder / "measured.json").read_text(encoding="utf-8"))
    if measured["kind"] not in KINDS:
        raise SystemExit(f"{folder}/measured.json: no picture is known for the kind "
                         f"{measured['kind']}")
    quantities = {one["name"]: one for one in measured["quantities"]}
    figure, axes = plt.subplots(1, 2, figsize=(11, 4.2))
    KINDS[measured["kind"]](axes, read_curve(folder), folder, quantities)
    for axis in axes:
        axis.grid(True, color="#e5e5e5")
        axis.set_axisbelow(True)
        if axis.get_legend_handles_labels()[0]:
            axis.legend(fontsize=8.5, frameon=False)
    figure.suptitle("   ".join(text_of(one) for one in measured["quantities"]), fontsize=10)
    figure.tight_layout()
    figure.savefig(target, dpi=110)


def text_of(one):
    unit = "" if one["unit"] == "1" else " " + one["unit"]
    spread = f" ± {one['uncertainty']:.2g}" if one["uncertainty"] else ""
    return f"{one['name']} {one['value']:.4g}{spread}{unit}"


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    where = Path(sys.argv[1])
    main(where, Path(sys.argv[2]) if len(sys.argv) == 3 else where / "measured.png")
