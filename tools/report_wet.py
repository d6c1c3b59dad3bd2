#!/usr/bin/python3
"""Wet beds beside each other: agglomerates, fluidisation, pressure drop, liquid.

    tools/report_wet.py DIR1 DIR2 ... [--from 0.3] [--out PREFIX]
        a table in Markdown of means from the time --from [s] on; with --out
        PREFIX.png        the beds from the front, grains coloured by the size of their agglomerate
        PREFIX-time.png   pressure drop, height, energy, agglomerates and bridges over time,
                          and how large the agglomerates are

The folders are results of `gasgrain run inputs/wet_fluidised_bed --var content X`.
"""

import argparse
import csv
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")

import numpy as np

import report_clusters
import report_wet_plot
from report_history import pressure_columns
from report_read import ReportError, particle_files, read_box, read_fields, read_history

GRAVITY = 9.81  # m/s2


class WetRun:
    """What one folder tells, from the start of the gas on."""

    def __init__(self, folder):
        self.folder = Path(folder)
        self.files = [entry for entry in particle_files(folder) if entry[0] >= 0.0]
        if not self.files:
            raise ReportError(f"{folder}: no particle file was written after the start of the gas")
        self.box = read_box(self.files[0][1])
        centres, fields = read_fields(self.files[0][1])
        if "id" not in fields or "radius" not in fields:
            raise ReportError(f"{folder}: the particle files lack id or radius")
        self.count = int(fields["id"].max())
        self.solid = float(np.sum(4.0 / 3.0 * np.pi * fields["radius"] ** 3))
        self.history = read_history(folder)
        self.ledger = read_ledger(self.folder / "liquid.csv")
        self.holding = report_clusters.Holding(folder, self.count)

    @property
    def content(self):
        last = self.ledger[-1]
        return sum(last[name] for name in ("films", "bridges", "wall_bridges", "walls")) / self.solid

    def name(self):
        return "dry" if self.content == 0.0 else f"liquid {100 * self.content:.3g} %"

    def pressure_drop(self):
        """(time [s], pressure at the floor above the outlet's [Pa]): a line through the two lowest
        probes, which lie in the bed."""
        (low, first), (high, second) = pressure_columns(self.history)[:2]
        p, q = self.history[first], self.history[second]
        return self.history["time_s"], p + (p - q) * low / (high - low)

    def weight(self, density):
        """Of the grains, over the floor [Pa]; the gas carries 1/2000 of it by buoyancy."""
        (x0, x1), (y0, y1), _ = self.box
        return density * self.solid * GRAVITY / ((x1 - x0) * (y1 - y0))

    def figures(self, begin, density):
        """Means over the time from `begin` on."""
        time, drop = self.pressure_drop()
        late = time >= begin
        if not late.any():
            raise ReportError(f"{self.folder}: the run ends before {begin} s")
        drop = drop[late] / self.weight(density)
        height = self.history["bed_height_m"][late]
        holding = self.holding
        held = holding.times >= begin
        rows = [row for row in self.ledger if row["step"] >= self.history["step"][late][0]]
        span = max(rows[-1]["time"] - rows[0]["time"], 1e-30)
        return {
            "content": self.content,
            "drop": drop.mean(), "drop_swing": drop.std(),
            "height": height.mean(), "height_swing": height.std(),
            "energy": self.history["kinetic_energy_J"][late].mean(),
            "bubble": self.history["bubble_diameter_m"][late].mean(),
            "parted": np.nanmean(holding.parted[held]),
            "size": np.nanmean(holding.of_each(report_clusters.mean_size)[held]),
            "in_agglomerates": np.nanmean(holding.of_each(report_clusters.share_in_clusters)[held]),
            "bridges": 2.0 * holding.bridges[held].mean() / self.count,
            "formed": (rows[-1]["formed"] - rows[0]["formed"]) / span / self.count,
            "saturation": rows[-1]["saturation"],
            "residual": max(abs(row["residual"]) for row in self.ledger),
        }


def read_ledger(file):
    try:
        with open(file, newline="") as stream:
            rows = [{key: float(value) for key, value in row.items()} for row in csv.DictReader(stream)]
    except OSError as error:
        raise ReportError(f"{file} cannot be read: {error.strerror}") from error
    if not rows:
        raise ReportError(f"{file} has no line")
    return rows


ROWS = (  # heading, figure, its form
    ("pressure drop / weight", "drop", "{:.3f}"),
    ("its standard deviation", "drop_swing", "{:.3f}"),
    ("bed height, mm", "height", "{:.1f}", 1e3),
    ("its standard deviation, mm", "height_swing", "{:.2f}", 1e3),
    ("bubble diameter, mm", "bubble", "{:.1f}", 1e3),
    ("kinetic energy, uJ", "energy", "{:.3g}", 1e6),
    ("pairs that part within 50 ms", "parted", "{:.1f} %", 100.0),
    ("agglomerate of a grain, mean, grains", "size", "{:.0f}"),
    ("grains in agglomerates of 10 or more", "in_agglomerates", "{:.0f} %", 100.0),
    ("bridges of a grain", "bridges", "{:.2f}"),
    ("bridges formed, per grain and s", "formed", "{:.1f}"),
    ("saturation", "saturation", "{:.5f}"),
    ("liquid ledger, greatest residual", "residual", "{:.0e}"),
)


def table(runs, begin, density):
    figures = [run.figures(begin, density) for run in runs]
    lines = ["| | " + " | ".join(run.name() for run in runs) + " |", "|---|" + "---|" * len(runs)]
    for heading, key, form, *scale in ROWS:
        cells = [form.format(f[key] * (scale[0] if scale else 1.0)) for f in figures]
        lines.append(f"| {heading} | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="+", type=Path, metavar="DIR", help="results of a run")
    parser.add_argument("--from", dest="begin", type=float, default=0.3, help="[s] (default 0.3)")
    parser.add_argument("--density", type=float, default=2500.0, help="of the grains [kg/m3]")
    parser.add_argument("--out", metavar="PREFIX", help="draw PREFIX.png and PREFIX-time.png")
    options = parser.parse_args()
    try:
        runs = [WetRun(folder) for folder in options.folders]
        print(table(runs, options.begin, options.density))
        if options.out:
            report_wet_plot.draw_beds(runs, f"{options.out}.png")
            report_wet_plot.draw_time(runs, options.begin, options.density, f"{options.out}-time.png")
    except ReportError as reason:
        print(f"report_wet.py: {reason}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
