"""Curves of two runs beside published points."""

import csv
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from report_read import ReportError, read_history

QUANTITIES = {"bed_height": "bed height [m]", "bubble_diameter": "bubble diameter [m]"}
# A published greatest value stands beside the run's greatest, whenever either was reached.
GREATEST = "_max"


def read_points(file):
    """{(case, quantity): (times [s], values [m])} in the order of the file."""
    points = {}
    try:
        with open(file, newline="") as stream:
            table = csv.DictReader(line for line in stream if not line.startswith("#"))
            for row in table:
                quantity = (row["quantity"] or "").strip().removesuffix("_m")
                if quantity.removesuffix(GREATEST) not in QUANTITIES:
                    raise ReportError(f"{file}: the quantity \"{quantity}\" is unknown. "
                                      f"Known: {', '.join(QUANTITIES)}, and these with {GREATEST}.")
                times, values = points.setdefault((row["case"].strip(), quantity), ([], []))
                times.append(float(row["time_s"]))
                values.append(float(row["value_m"]))
    except OSError as error:
        raise ReportError(f"{file} cannot be read: {error.strerror}") from error
    except (KeyError, TypeError, ValueError) as error:
        raise ReportError(f"{file}: a line is not case,quantity,time_s,value_m ({error})") from error
    return points


def table(folders, data):
    """Markdown: each published point beside the run of its case (the runs in the order of the cases)."""
    points = read_points(data)
    cases = list(dict.fromkeys(case for case, _ in points))
    runs = dict(zip(cases, (read_history(folder) for folder in folders)))
    lines = ["| case | quantity | time [s] | published [m] | computed [m] | error |",
             "|---|---|---|---|---|---|"]
    for (case, quantity), (times, values) in points.items():
        if case not in runs:
            continue
        name = quantity.removesuffix(GREATEST)
        run_times, run_values = runs[case]["time_s"], runs[case][name + "_m"]
        for time, value in zip(times, values):
            if quantity.endswith(GREATEST):
                best = max(range(len(run_values)), key=lambda row: run_values[row])
                computed, when = run_values[best], f"{time:.3f} (computed: {run_times[best]:.3f})"
            elif time > run_times[-1]:
                continue
            else:
                computed, when = np.interp(time, run_times, run_values), f"{time:.3f}"
            lines.append(f"| {case} | {quantity.replace('_', ' ')} | {when} | {value:.3f} | "
                         f"{computed:.3f} | {100 * (computed / value - 1):+.0f} % |")
    return "\n".join(lines)


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
            for kind, label_of_kind in ((quantity, ""), (quantity + GREATEST, ", greatest")):
                if (case, kind) in points:
                    axis.plot(*points[case, kind], "os^Dv"[n % 5], color=colours[case],
                              markerfacecolor=colours[case] if label_of_kind else "none",
                              markersize=5, label=f"{case}, published{label_of_kind}")
        axis.set_ylabel(label)
        axis.set_ylim(bottom=0)
        axis.grid(alpha=0.3)
        axis.legend(fontsize=8)
    axes[-1].set_xlabel("time [s]")
    figure.savefig(out, dpi=130)
    plt.close(figure)
