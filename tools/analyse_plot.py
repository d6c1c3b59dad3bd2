#!/usr/bin/python3
"""The picture of what `gasgrain analyse` left: rates and omega over time, omega over the cube's side.

    tools/analyse_plot.py DIR
        one run: reads DIR/solid_drag*.csv and solid_drag.json, writes DIR/solid_drag.png
    tools/analyse_plot.py LABEL=DIR LABEL=DIR ... --out PICTURE.png
        runs beside each other; several of one label are realisations, whose mean is drawn
    tools/analyse_plot.py --by-fraction LABEL=DIR ... --out PICTURE.png
        omega over the mean solid fraction of the small grains in the cube instead
"""

import csv
import json
import math
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

COLOURS = ["#4c72b0", "#dd8452", "#55a868", "#c44e52", "#8172b3", "#333333", "#937860"]
SIZE_TEXT = "side of the cube / (d_s + d_b)"


def number(text):
    return float(text) if text else math.nan


def rows_of(file):
    with open(file, newline="", encoding="utf-8") as stream:
        return [{name: number(text) for name, text in row.items()} for row in csv.DictReader(stream)]


class Run:
    def __init__(self, folder):
        folder = Path(folder)
        self.windows = rows_of(folder / "solid_drag_windows.csv")
        self.means = rows_of(folder / "solid_drag.csv")
        self.labels = json.loads((folder / "solid_drag.json").read_text(encoding="utf-8"))
        self.sizes = [mean["size"] for mean in self.means]

    def course(self, size, quantity):
        """(times, values), the mean of all big grains; of a rate its component along Syamlal's."""
        by_time = {}
        for row in self.windows:
            if row["size"] == size:
                by_time.setdefault(row["time_s"], []).append(row)
        value = {"omega": lambda row: row["omega"], "alpha_s": lambda row: row["alpha_s"],
                 "dem": lambda row: self.along(row, "dem"),
                 "syamlal": lambda row: self.along(row, "syamlal")}[quantity]
        times = sorted(by_time)
        return times, [sum(map(value, by_time[time])) / len(by_time[time]) for time in times]

    def along(self, row, rate):
        steady = self.direction(row["size"])
        return sum(row[f"{rate}_{axis}_N_m3"] * steady[axis] for axis in "xyz")

    def direction(self, size):
        """Unit vector of the mean of Syamlal's rate over the steady period."""
        low, high = self.labels["steady_s"]
        total = {axis: sum(row[f"syamlal_{axis}_N_m3"] for row in self.windows
                           if row["size"] == size and low < row["time_s"] <= high * (1 + 1e-9))
                 for axis in "xyz"}
        length = math.sqrt(sum(value**2 for value in total.values())) or 1.0
        return {axis: value / length for axis, value in total.items()}

    def greatest_omega(self):
        """Of the windows that count, for the limit of an axis."""
        found = [mean[name] for mean in self.means for name in ("omega", "omega_transient")]
        return max([value for value in found if math.isfinite(value)], default=1.0)


def finish(axis, text_x, text_y, legend=True):
    axis.set_xlabel(text_x)
    axis.set_ylabel(text_y)
    axis.grid(True, color="#e5e5e5")
    axis.set_axisbelow(True)
    if legend:
        axis.legend(fontsize=8.5, frameon=False)


def shade(axis, run):
    low, high = run.labels["steady_s"]
    axis.axvspan(1e3 * low, 1e3 * high, color="#f2f2f2", zorder=0)


def milliseconds(course):
    return [1e3 * time for time in course[0]], course[1]


def draw_rates(axis, run, size):
    shade(axis, run)
    axis.plot(*milliseconds(run.course(size, "dem")), lw=1.4, color=COLOURS[0], label="DEM")
    axis.plot(*milliseconds(run.course(size, "syamlal")), lw=1.4, color=COLOURS[1], label="Syamlal")
    finish(axis, "time [ms]", f"rate of momentum [N/m3], side {size:g} (d_s + d_b)")


def draw_omegas(axis, run):
    shade(axis, run)
    for n, size in enumerate(run.sizes):
        axis.plot(*milliseconds(run.course(size, "omega")), lw=1.2,
                  color=COLOURS[n % len(COLOURS)], label=f"{size:g} (d_s + d_b)")
    axis.axhline(1.0, color="black", lw=0.8, ls=":")
    axis.set_ylim(0.0, 1.15 * run.greatest_omega())
    finish(axis, "time [ms]", "omega = DEM / Syamlal")


def one(folder):
    run = Run(folder)
    figure, axes = plt.subplots(1, 3, figsize=(15, 4.5))
    draw_rates(axes[0], run, run.sizes[0])
    draw_omegas(axes[1], run)
    axes[2].errorbar(run.sizes, [mean["omega"] for mean in run.means],
                     [mean["omega_error"] for mean in run.means], fmt="o-", capsize=3,
                     color=COLOURS[0])
    axes[2].axhline(1.0, color="black", lw=0.8, ls=":")
    axes[2].set_ylim(bottom=0.0)
    finish(axes[2], SIZE_TEXT, "omega of the steady period", legend=False)
    figure.suptitle(run.labels["command"], fontsize=10, family="monospace")
    figure.tight_layout()
    figure.savefig(Path(folder) / "solid_drag.png", dpi=120)


def mean_and_error(runs, k, name):
    """Of realisations with their standard error; of one run with that of its windows."""
    values = [run.means[k][name] for run in runs]
    mean = sum(values) / len(values)
    if len(values) == 1:
        return mean, runs[0].means[k]["omega_error"] if name == "omega" else 0.0
    spread = sum((value - mean)**2 for value in values) / (len(values) - 1)
    return mean, math.sqrt(spread / len(values))


def points(axis, x, y, colour, label=None):
    axis.errorbar([v[0] for v in x], [v[0] for v in y], [v[1] for v in y], [v[1] for v in x], fmt="o-",
                  ms=4.5, lw=1.3, capsize=3, color=colour, label=label)


def over_sides(groups, target):
    figure, axes = plt.subplots(1, 3, figsize=(15, 4.5))
    for n, (label, runs) in enumerate(groups.items()):
        colour = COLOURS[n % len(COLOURS)]
        omegas = [mean_and_error(runs, k, "omega") for k in range(len(runs[0].sizes))]
        points(axes[0], [(size, 0.0) for size in runs[0].sizes], omegas, colour, label)
        points(axes[1], [(1e3 * mean["side_m"], 0.0) for mean in runs[0].means], omegas, colour, label)
        axes[2].plot(*milliseconds(runs[0].course(runs[0].sizes[0], "omega")), lw=1.2, color=colour,
                     label=label)
    size = next(iter(groups.values()))[0].sizes[0]
    finish(axes[0], SIZE_TEXT, "omega of the steady period")
    finish(axes[1], "side of the cube [mm]", "omega of the steady period")
    finish(axes[2], "time [ms]", f"omega, side {size:g} (d_s + d_b)")
    save(figure, axes, target)


def over_fractions(groups, target):
    figure, axis = plt.subplots(figsize=(6.5, 4.5))
    found = sorted((*(mean_and_error(runs, 0, name) for name in ("alpha_s", "omega")), label)
                   for label, runs in groups.items())
    points(axis, [p[0] for p in found], [p[1] for p in found], COLOURS[0])
    for alpha, omega, label in found:
        axis.annotate(label, (alpha[0], omega[0]), fontsize=8, xytext=(5, 5), textcoords="offset points",
                      color="#444444")
    finish(axis, "mean solid fraction of the small grains in the cube", "omega of the steady period", legend=False)
    save(figure, [axis], target)


def save(figure, axes, target):
    for axis in axes:
        axis.axhline(1.0, color="black", lw=0.8, ls=":")
        axis.set_ylim(bottom=0.0)
    figure.tight_layout()
    figure.savefig(target, dpi=120)


def several(words, target, by_fraction):
    groups = {}
    for word in words:
        label, _, folder = word.rpartition("=")
        if not label or not (Path(folder) / "solid_drag.csv").is_file():
            sys.exit(f'"{word}" must read LABEL=DIR, of a folder that gasgrain analyse has written to')
        groups.setdefault(label, []).append(Run(folder))
    for label, runs in groups.items():
        if any(run.sizes != runs[0].sizes for run in runs):
            sys.exit(f"the runs of {label} have cubes of different sizes: analyse them alike")
    (over_fractions if by_fraction else over_sides)(groups, target)


def main(words):
    by_fraction = "--by-fraction" in words
    words = [word for word in words if word != "--by-fraction"]
    if len(words) == 1 and not by_fraction and not words[0].startswith("-"):
        one(words[0])
    elif len(words) > 2 and words[-2] == "--out":
        several(words[:-2], words[-1], by_fraction)
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main(sys.argv[1:])
