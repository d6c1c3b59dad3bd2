#!/usr/bin/python3
"""The picture of a study: error and cost over the dial, error against cost with the Pareto front.

    tools/study_plot.py DIR [PICTURE.png]
        reads DIR/study.csv and DIR/study.json, writes DIR/study.png
"""

import csv
import json
import math
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

COLOURS = ["#4c72b0", "#dd8452", "#55a868", "#c44e52", "#8172b3", "#333333", "#937860"]


def number(text):
    try:
        return float(text)
    except ValueError:
        return math.nan


def read(folder):
    with open(folder / "study.csv", newline="", encoding="utf-8") as file:
        rows = [row for row in csv.DictReader(file)]
    labels = json.loads((folder / "study.json").read_text(encoding="utf-8"))
    return rows, labels


def logarithmic(values):
    """Whether the values span enough, all above 0, for a logarithmic axis."""
    good = [v for v in values if math.isfinite(v)]
    return bool(good) and min(good) > 0 and max(good) / min(good) >= 3


def plain_ticks(axis):
    """Numbers as they are read, also between the powers of ten."""
    for one, scale, limits in ((axis.xaxis, axis.get_xscale(), axis.get_xlim()),
                               (axis.yaxis, axis.get_yscale(), axis.get_ylim())):
        if scale != "log":
            continue
        decades = math.log10(limits[1] / limits[0])
        one.set_major_locator(LogLocator(subs=(1, 2, 5) if decades < 2.5 else (1,)))
        one.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
        one.set_minor_formatter(NullFormatter())


def over_dial(axis, rows, labels, quantity, text):
    """One curve a series; a dial of words is a row of bars."""
    dial = labels["dial"]
    shown = [row for row in rows if row["point"] != labels["twin"] and row["status"] == "ok"
             and math.isfinite(number(row[quantity]))]
    axis.set_xlabel(labels["dial_text"])
    axis.set_ylabel(text)
    if not shown:
        return
    if all(math.isfinite(number(row[dial])) for row in shown):
        for n, name in enumerate(series(rows, labels)):
            part = sorted(((number(row[dial]), number(row[quantity])) for row in shown
                           if in_series(row, name, labels)))
            axis.plot(*zip(*part) if part else ([], []), "o-", ms=4.5, lw=1.3,
                      color=COLOURS[n % len(COLOURS)], label=name)
        if logarithmic([number(row[dial]) for row in rows]):
            axis.set_xscale("log")
        if logarithmic([number(row[quantity]) for row in shown]):
            axis.set_yscale("log")
    else:
        names = [row[dial] for row in shown]
        axis.barh(range(len(names)), [number(row[quantity]) for row in shown], color=COLOURS[0],
                  height=0.6)
        axis.set_yticks(range(len(names)), names, fontsize=8)
        axis.invert_yaxis()
        axis.set_xlabel(text)
        axis.set_ylabel("")


def series(rows, labels):
    name = labels["series"]
    return list(dict.fromkeys(row[name] for row in rows)) if name else [""]


def in_series(row, name, labels):
    return not labels["series"] or row[labels["series"]] == name


def chance(axis, rows, labels):
    """What two runs that ought to be equal differ by."""
    if not labels["error_is_of_the_bed"]:
        return
    for row in rows:
        value = number(row.get(labels["error"], ""))
        if row["point"] == labels["twin"] and math.isfinite(value):
            axis.axhline(value, color="#999999", ls=":", lw=1.2)
            axis.annotate("chance", (1.0, value), xycoords=("axes fraction", "data"), fontsize=8,
                          color="#777777", ha="right", va="bottom")


def against_cost(axis, rows, labels):
    error, cost = labels["error"], labels["cost"]
    shown = [row for row in rows if row["status"] == "ok" and row["point"] != labels["twin"]
             and math.isfinite(number(row[error])) and math.isfinite(number(row[cost]))]
    for n, name in enumerate(series(rows, labels)):
        part = [(number(row[cost]), number(row[error])) for row in shown
                if in_series(row, name, labels)]
        axis.plot(*zip(*part) if part else ([], []), "o", ms=5, color=COLOURS[n % len(COLOURS)])
    front = sorted((number(row[cost]), number(row[error])) for row in shown
                   if row["pareto"] == "1")
    if front:
        axis.step(*zip(*front), where="post", color="black", lw=1.0, zorder=0)
        axis.plot(*zip(*front), "o", ms=9, mfc="none", mec="black", label="Pareto front")
        axis.legend(fontsize=8.5, frameon=False)
    for row in shown:
        if row["pareto"] == "1" or len(shown) <= 8:
            axis.annotate(row["point"], (number(row[cost]), number(row[error])), fontsize=7.5,
                          xytext=(5, 4), textcoords="offset points", color="#444444")
    if logarithmic([number(row[cost]) for row in shown]):
        axis.set_xscale("log")
    if logarithmic([number(row[error]) for row in shown]):
        axis.set_yscale("log")
    axis.margins(x=0.12, y=0.12)
    axis.set_xlabel(labels["cost_text"])
    axis.set_ylabel(labels["error_text"])


def main(folder, target):
    rows, labels = read(folder)
    figure, (errors, costs, both) = plt.subplots(1, 3, figsize=(16, 4.8))
    over_dial(errors, rows, labels, labels["error"], labels["error_text"])
    over_dial(costs, rows, labels, labels["cost"], labels["cost_text"])
    against_cost(both, rows, labels)
    if errors.get_xlabel() == labels["dial_text"]:
        chance(errors, rows, labels)
    chance(both, rows, labels)
    if labels["series"]:
        errors.legend(fontsize=8.5, frameon=False)
    for axis in (errors, costs, both):
        plain_ticks(axis)
        axis.grid(True, color="#e5e5e5")
        axis.set_axisbelow(True)
    figure.suptitle(labels["command"], fontsize=10, family="monospace")
    figure.tight_layout()
    figure.savefig(target, dpi=130)


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    where = Path(sys.argv[1])
    main(where, Path(sys.argv[2]) if len(sys.argv) == 3 else where / "study.png")
