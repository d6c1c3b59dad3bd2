#!/usr/bin/python3
"""The plot of dem.py: speeds with their spread, and the share of each task.

    tests/bench/dem_plot.py results/dem/dem.csv docs/images/dem_speed.png
"""

import csv
import math
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

import dem_beds  # noqa: E402
from dem_run import TASKS  # noqa: E402
from dem_table import middle  # noqa: E402

OURS, STOCK = ("#1b6e8c", "#3f9dbd", "#8cc7dc"), ("#8a8a8a", "#adadad", "#cfcfcf")  # by number of grains
TASK_COLOURS = ("#c8553d", "#e8a33d", "#588157", "#9aa5b1")


def draw_speeds(axes, rows):
    """A bar a program and number of grains; the bar's end is the median, its line goes from least to greatest."""
    lines = list(dict.fromkeys((row["program"], row["liquid"]) for row in rows))
    numbers = sorted({row["grains"] for row in rows})
    height = 0.8 / len(numbers)
    for row in rows:
        at = lines.index((row["program"], row["liquid"])) + height * (numbers.index(row["grains"])
                                                                      - (len(numbers) - 1) / 2)
        median, least, greatest = (float(row[name]) / 1e6 for name in ("median", "least", "greatest"))
        colour = (OURS if row["ours"] else STOCK)[numbers.index(row["grains"]) % len(OURS)]
        axes.barh(at, median, height, color=colour, xerr=[[median - least], [greatest - median]],
                  error_kw={"elinewidth": 0.8, "ecolor": "#222222"})
    axes.set_yticks(range(len(lines)), [f"{program} ({liquid})" for program, liquid in lines], fontsize=8)
    axes.invert_yaxis()
    sizes = ", ".join(f"{n:,}" for n in numbers)
    axes.set_xlabel(f"10^6 particle-steps/s, {sizes} grains from top to bottom; blue: ours", fontsize=8)


def draw_tasks(axes, rows):
    for n, row in enumerate(rows):
        left = 0.0
        for task, colour in zip(TASKS, TASK_COLOURS):
            share = 100 * float(row[task])
            axes.barh(n, share, 0.7, left=left, color=colour, label=task if n == 0 else None)
            left += share
    axes.set_yticks(range(len(rows)), [""] * len(rows))
    axes.invert_yaxis()
    axes.set_xlim(0, 100)
    axes.set_xlabel(f"share of the time [%], {rows[0]['grains']:,} grains", fontsize=8)


def plot(rows, path):
    """`rows` as dem.py makes them; those of the least number of ranks are drawn."""
    ranks = min(row["ranks"] for row in rows)
    rows = [row for row in rows if row["ranks"] == ranks]
    beds = list(dict.fromkeys(row["bed"] for row in rows))
    figure, panels = plt.subplots(len(beds), 2, figsize=(11, 0.8 + 4.2 * len(beds)), squeeze=False,
                                  width_ratios=(1.5, 1), layout="constrained")
    for (left, right), bed in zip(panels, beds):
        of_bed = [row for row in rows if row["bed"] == bed]
        draw_speeds(left, of_bed)
        draw_tasks(right, middle(of_bed))
        left.set_title(f"{bed} bed, {ranks} rank{'s' * (ranks > 1)}", fontsize=10)
    panels[0][1].legend(fontsize=7, ncols=2, loc="lower center", bbox_to_anchor=(0.5, 1.0))
    figure.savefig(path, dpi=110)
    plt.close(figure)


def plot_beds(tiles, path):
    """The grains of the tiles from the front, coloured by their speed. `tiles`: files by the name of the bed."""
    figure, panels = plt.subplots(1, len(tiles), figsize=(10, 3.4), layout="constrained", sharey=True)
    for axes, (name, tile) in zip(panels, tiles.items()):
        grains = dem_beds.read_grains(tile)
        drawn = axes.scatter([1e3 * grain[0] for grain in grains], [1e3 * grain[2] for grain in grains], s=14,
                             c=[math.hypot(*grain[3:6]) for grain in grains], vmin=0.0, vmax=0.6)
        axes.set_aspect("equal")
        axes.set_title(name, fontsize=10)
        axes.set_xlabel("x [mm]", fontsize=8)
    panels[0].set_ylabel("z [mm]", fontsize=8)
    figure.colorbar(drawn, ax=panels, label="speed [m/s]")
    figure.savefig(path, dpi=90)
    plt.close(figure)


def read_rows(path):
    with Path(path).open(newline="") as file:
        return [{**row, **{name: int(row[name]) for name in ("grains", "ranks", "ours")}}
                for row in csv.DictReader(file)]


if __name__ == "__main__":
    plot(read_rows(sys.argv[1]), sys.argv[2])
