#!/usr/bin/env python3
"""Draws the error, the spread and the time of the void-fraction methods over the size of cells.

  tests/bench/plot_void_fraction.py TABLE.csv PICTURE.png [BENCH]

With BENCH, the program void_fraction_bench, the table is measured first:

  tests/bench/plot_void_fraction.py docs/data/void-fraction-error.csv \\
      docs/images/void-fraction-error.png build/bench/void_fraction_bench
"""
import csv
import pathlib
import subprocess
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.lines import Line2D

COLOURS = {"centre": "#c44e52", "offset": "#dd8452", "trilinear": "#4c72b0", "exact": "#333333",
           "kernel": "#55a868", "particle_grid": "#8172b3"}
TICKS = [0.2, 0.5, 1, 2, 5, 10]


def read(path):
    """{(method, phi): rows in order of cell size}, every value but the method's name a number."""
    curves = {}
    with open(path, newline="") as file:
        for row in csv.DictReader(file):
            method = row.pop("method")
            values = {key: float(value) for key, value in row.items()}
            curves.setdefault((method, values["phi"]), []).append(values)
    return {key: sorted(rows, key=lambda r: r["cell_by_diameter"]) for key, rows in curves.items()}


def draw(axes, rows, quantity, colour, line):
    x = [r["cell_by_diameter"] for r in rows]
    y = [r[quantity] for r in rows]
    axes.loglog(x, y, line, color=colour, lw=1.4)
    for failed, face in ((False, colour), (True, "white")):
        some = [(a, b) for a, b, r in zip(x, y, rows) if (r["share_below_zero"] > 0) == failed]
        axes.plot(*zip(*some) if some else ([], []), "o", ms=4.5, mec=colour, mfc=face)


def main(source, target):
    curves = read(source)
    shares = sorted({phi for _, phi in curves}, reverse=True)
    lines = dict(zip(shares, ["-", "--", ":"]))
    figure, (error, spread, time) = plt.subplots(1, 3, figsize=(15, 4.8))
    for (method, phi), rows in curves.items():
        colour = COLOURS.get(method, "#777777")
        if method != "exact":
            draw(error, rows, "rms_error", colour, lines[phi])
        if phi == shares[0]:
            draw(spread, rows, "spread", colour, "-")
            draw(time, rows, "ns_per_particle", colour, "-")
    for axes in (error, spread, time):
        axes.set_xlabel("cell size / particle diameter")
        axes.set_xticks(TICKS, [str(t) for t in TICKS])
        axes.minorticks_off()
        axes.grid(True, color="#e5e5e5")
        axes.set_axisbelow(True)
    error.set_ylabel(r"rms of $\varepsilon - \varepsilon_\mathrm{exact}$")
    spread.set_ylabel(r"standard deviation of $\varepsilon$ over the cells")
    time.set_ylabel("ns per particle (weights and deposit)")
    error.set_title("error against the exact void fraction", fontsize=11)
    spread.set_title(rf"spread in a random packing, $\varphi$ = {shares[0]:g}", fontsize=11)
    time.set_title(rf"time, $\varphi$ = {shares[0]:g}", fontsize=11)
    methods = [Line2D([], [], color=COLOURS.get(m, "#777777"), label=m) for m in
               dict.fromkeys(method for method, _ in curves)]
    keys = [Line2D([], [], color="black", ls=lines[p], lw=1, label=rf"$\varphi$ = {p:g}")
            for p in shares]
    keys += [Line2D([], [], color="black", marker="o", mfc="white", ls="", ms=4.5,
                    label=r"$\varepsilon < 0$ somewhere")]
    error.legend(handles=keys, fontsize=8.5, frameon=False, loc="lower left")
    spread.legend(handles=methods, fontsize=8.5, frameon=False, loc="upper right")
    figure.tight_layout()
    figure.savefig(target, dpi=130)


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    for path in sys.argv[1:3]:
        pathlib.Path(path).parent.mkdir(parents=True, exist_ok=True)
    if len(sys.argv) == 4:
        subprocess.run([sys.argv[3], "--csv", sys.argv[1]], check=True)
    main(*sys.argv[1:3])
