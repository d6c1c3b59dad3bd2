#!/usr/bin/python3
"""The stability map: runs build/bench/stability_map (some minutes), keeps its CSV and draws it.

  plot_stability_map.py docs/data/stability-map.csv docs/images/stability-map.png [build/bench/stability_map]

Without the program the picture is drawn from the CSV as it is."""

import csv
import subprocess
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

COLOURS = {"stable": "#8fc99a", "bounded": "#f2d479", "broken": "#e08a82", "refused": "#c9c9c9"}
METHODS = ("centre", "trilinear", "offset", "exact", "particle_grid", "kernel")


def read(path):
    with open(path, encoding="ascii") as file:
        return [{key: value if key in ("part", "scheme", "verdict") else float(value)
                 for key, value in row.items()} for row in csv.DictReader(file)]


def short(value):
    return f"{value:.2g}" if value >= 1e-3 else f"{value:.0e}".replace("e-0", "e-")


def strip(axes, rows, columns, cells, title, xlabel, ylabel=""):
    """cells: {(row, column): (text, verdict)}"""
    for (row, column), (text, verdict) in cells.items():
        i, j = columns.index(column), rows.index(row)
        axes.add_patch(plt.Rectangle((i, j), 1, 1, facecolor=COLOURS[verdict], edgecolor="white", lw=1.5))
        axes.text(i + 0.5, j + 0.5, text, ha="center", va="center", fontsize=7.5)
    axes.set(xlim=(0, len(columns)), ylim=(0, len(rows)), title=title, xlabel=xlabel, ylabel=ylabel)
    axes.set_xticks([i + 0.5 for i in range(len(columns))], [f"{c:g}" for c in columns], fontsize=8)
    axes.set_yticks([j + 0.5 for j in range(len(rows))],
                    [r if isinstance(r, str) else f"{r:g}" for r in rows], fontsize=8)
    axes.tick_params(length=0)
    for side in axes.spines.values():
        side.set_visible(False)


def growth(row):
    if row["verdict"] == "refused":
        return "refused"
    return "runs away" if row["measure"] > 1e4 else f"{row['measure']:.3g}"


def draw(data, picture):
    figure = plt.figure(figsize=(13, 10.5))
    grid = figure.add_gridspec(3, 2, height_ratios=(7, 6, 6), hspace=0.42, wspace=0.16)

    rows, cells = [], {}
    for row in data:
        if row["part"] != "drag":
            continue
        name = f"{row['scheme'].replace(' overlapped', ', overlapped').replace(' in turn', ', in turn')}, L = {row['second']:g}"
        if name not in rows:
            rows.append(name)
        text = "> 1e6" if row["measure"] > 1e4 else f"{row['measure']:.3g}"
        cells[(name, row["hardness"])] = (text, row["verdict"])
    rows.sort(reverse=True, key=lambda name: (name.startswith("explicit"), name))
    rows.reverse()
    columns = sorted({column for _, column in cells})
    strip(figure.add_subplot(grid[0, :]), rows, columns, cells,
          "drag: fastest of gas and grains over the fastest grain at first (200 couplings; L: mass of grains / gas)",
          "coupling interval / relaxation time of a grain")

    data_vf = [row for row in data if row["part"] == "void_fraction"]
    columns = sorted({round(row["hardness"], 4) for row in data_vf})
    cells = {(row["scheme"], round(row["hardness"], 4)): (short(row["measure"]), row["verdict"]) for row in data_vf}
    axes = figure.add_subplot(grid[1, :])
    strip(axes, list(METHODS), columns, cells,
          "void fraction: change of the drag while a grain moves 0.02 cells across a face, over its mean",
          "cell size / diameter of the grain")
    axes.set_xticks([i + 0.5 for i in range(len(columns))], [f"{c:.2g}" for c in columns], fontsize=8)

    for place, scheme in enumerate(("in turn", "overlapped")):
        own = [row for row in data if row["part"] == "coupling" and row["scheme"] == scheme]
        cells = {(row["hardness"], row["second"]): (growth(row), row["verdict"]) for row in own}
        strip(figure.add_subplot(grid[2, place]), sorted({r for r, _ in cells}), sorted({c for _, c in cells}),
              cells, f"{scheme}: as drag, L = 100 (2000 couplings)", "cells crossed in a coupling interval",
              "interval / relaxation time")
    handles = [plt.Rectangle((0, 0), 1, 1, facecolor=colour) for colour in COLOURS.values()]
    figure.legend(handles, COLOURS, ncol=4, loc="lower center", frameon=False, fontsize=9,
                  bbox_to_anchor=(0.5, 0.01))
    figure.savefig(picture, dpi=110, bbox_inches="tight")


if __name__ == "__main__":
    table, image = sys.argv[1:3]
    if len(sys.argv) > 3:
        text = subprocess.run([sys.argv[3]], check=True, capture_output=True, text=True).stdout
        with open(table, "w", encoding="ascii") as out:
            out.write(text)
    draw(read(table), image)
