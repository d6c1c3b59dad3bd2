"""Curves of two runs beside published points."""

import csv
from pathlib import Path

import matplotlib.pyplot as plt

from report_read import ReportError, read_history

QUANTITIES = {"bed_height": "bed height [m]", "bubble_diameter": "bubble diameter [m]"}


def read_points(file):
    """{(case, quantity): (times [s], values [m])} in the order of the file."""
    points = {}
    try:
        with open(file, newline="") as stream:
            table = csv.DictReader(line for line in stream if not line.startswith("#"))
            for row in table:
                quantity = (row["quantity"] or "").strip().removesuffix("_m")
                if quantity not in QUANTITIES:
                    raise ReportError(f"{file}: the quantity \"{quantity}\" is unknown. "
                                      f"Known: {', '.join(QUANTITIES)}.")
                times, values = points.setdefault((row["case"].strip(), quantity), ([], []))
                times.append(float(row["time_s"]))
                values.append(float(row["value_m"]))
    except OSError as error:
        raise ReportError(f"{file} cannot be read: {error.strerror}") from error
    except (KeyError, TypeError, ValueError) as error:
        raise ReportError(f"{file}: a line is not case,quantity,time_s,value_m ({error})") from error
    return points


def draw(folders, data, out):
    runs = {Path(folder).resolve().name: read_history(folder) for folder in folders}
    points = read_points(data)
    cases = list(dict.fromkeys(case for case, _ in points))
    # A case takes the colour of the run of its name, else of the run in its place.
    colours = {name: f"C{n}" for n, name in enumerate(runs)}
    for n, case in enumerate(cases):
        colours.setdefault(case, f"C{n}")

    figure, axes = plt.subplots(len(QUANTITIES), 1, sharex=True, figsize=(8, 7),
                                layout="constrained")
    for axis, (quantity, label) in zip(axes, QUANTITIES.items()):
        for name, history in runs.items():
            if quantity + "_m" in history:
                axis.plot(history["time_s"], history[quantity + "_m"], color=colours[name],
                          linewidth=1.2, label=name)
        for n, case in enumerate(cases):
            if (case, quantity) in points:
                axis.plot(*points[case, quantity], "os^Dv"[n % 5], color=colours[case],
                          markerfacecolor="none", markersize=5, label=f"{case}, published")
        axis.set_ylabel(label)
        axis.set_ylim(bottom=0)
        axis.grid(alpha=0.3)
        axis.legend(fontsize=8)
    axes[-1].set_xlabel("time [s]")
    figure.savefig(out, dpi=130)
    plt.close(figure)
