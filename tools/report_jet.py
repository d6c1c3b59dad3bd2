#!/usr/bin/python3
"""How far a jet of droplets goes into a bed of parcels.

    tools/report_jet.py DIR... [--from 5.0] [--share 0.01] [--out PREFIX]
        a table in Markdown: the mean over the particle files from the time --from [s] on, its
        deviation, and the same of other shares
    with --out
        PREFIX.png        droplets and liquid on the bed's parcels in a slice through the jet
        PREFIX-time.png   penetration over time

Penetration at a moment: the distance from the nozzle, along the jet, to the end of the first gap of
a bin (5 mm) without a droplet, of droplets that still hold the share --share of the liquid they
began with, within 3 cm of the axis. Droplets are the parcels of type 2. The folders are results of
`gasgrain run inputs/jet_penetration`.
"""

import argparse
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy as np

from report_read import ReportError, particle_files, read_box, read_fields

NOZZLE = np.array([0.04, 0.1, 0.04])  # m; the jet goes along x
BIN = 0.005  # m
TUBE = 0.03  # m, half of the width looked at
DROPLET = 2  # type
SHARES = (0.5, 0.1, 0.01, 0.001)


class Moment:
    """The droplets of a particle file."""

    def __init__(self, time, file):
        self.time = time
        self.centres, fields = read_fields(file)
        self.fields = {name: values[:, 0] for name, values in fields.items()}
        for name in ("type", "f_liquidFilm", "f_particlesPerParcel", "radius"):
            if name not in self.fields:
                raise ReportError(f"{file} lacks {name}: write it with the script's dump")
        self.droplet = self.fields["type"] == DROPLET
        self.film = self.fields["f_liquidFilm"]

    def penetration(self, share, whole):
        """[m], 0 without a droplet at the nozzle. whole: liquid of a fresh droplet [m3]."""
        off = self.centres - NOZZLE
        alive = self.droplet & (self.film >= share * whole) & (np.hypot(off[:, 1], off[:, 2]) < TUBE)
        bins = np.floor(off[alive, 0] / BIN).astype(int)
        held = np.bincount(bins[bins >= 0], minlength=1) > 0
        gaps = np.flatnonzero(~held)
        return BIN * (gaps[0] if len(gaps) else len(held))


class Run:
    def __init__(self, folder):
        self.folder = Path(folder)
        self.files = particle_files(folder)
        self.box = read_box(self.files[0][1])
        self.moments = [moment for moment in (Moment(*entry) for entry in self.files)
                        if moment.droplet.any()]
        if not self.moments:
            raise ReportError(f"{folder}: no particle file holds a droplet (type {DROPLET})")
        self.whole = max(moment.film[moment.droplet].max() for moment in self.moments)

    def series(self, share):
        return np.array([(moment.time, moment.penetration(share, self.whole)) for moment in self.moments])


def table(runs, begin):
    text = "| run | share of its liquid a droplet still holds | penetration [cm] | deviation [cm] | files |\n|---|---|---|---|---|\n"
    for run in runs:
        for share in SHARES:
            series = run.series(share)
            taken = series[series[:, 0] >= begin, 1]
            if len(taken) == 0:
                raise ReportError(f"{run.folder}: no particle file after {begin} s; --from is too late")
            text += (f"| {run.folder.name} | {share:g} | {100 * taken.mean():.2f} | "
                     f"{100 * taken.std():.2f} | {len(taken)} |\n")
    return text


def draw_slices(runs, share, file, pictures=5):
    figure, axes = plt.subplots(len(runs), pictures, figsize=(3.0 * pictures, 4.4 * len(runs)), squeeze=False)
    for row, run in zip(axes, runs):
        for axis, n in zip(row, np.linspace(len(run.moments) / pictures, len(run.moments), pictures).astype(int) - 1):
            moment = run.moments[n]
            near = np.abs(moment.centres[:, 1] - NOZZLE[1]) < 0.015
            bed = near & ~moment.droplet
            solid = 4.0 / 3.0 * np.pi * moment.fields["radius"] ** 3 - moment.film
            wet = moment.film / np.maximum(solid, 1e-30)
            shown = axis.scatter(*moment.centres[bed][:, [0, 2]].T, c=wet[bed], s=2, cmap="Blues", vmin=0.0, vmax=0.05,
                                 edgecolors="none")
            alive = near & moment.droplet & (moment.film >= share * run.whole)
            axis.plot(*moment.centres[alive][:, [0, 2]].T, "r.", ms=2)
            axis.set_aspect("equal")
            axis.set_xlim(*run.box[0])
            axis.set_ylim(*run.box[2])
            axis.set_title(f"{run.folder.name}, {moment.time:.1f} s", fontsize=9)
    figure.colorbar(shown, ax=axes, label="liquid over solid volume of bed parcels", shrink=0.6)
    figure.savefig(file, dpi=100)


def draw_time(runs, share, file):
    figure, axis = plt.subplots(figsize=(7, 4))
    for run in runs:
        series = run.series(share)
        axis.plot(series[:, 0], 100 * series[:, 1], label=run.folder.name)
    axis.set_xlabel("time [s]")
    axis.set_ylabel("penetration [cm]")
    axis.legend()
    figure.tight_layout()
    figure.savefig(file, dpi=100)


def main():
    words = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("folders", nargs="+", metavar="DIR")
    words.add_argument("--from", dest="begin", type=float, default=5.0)
    words.add_argument("--share", type=float, default=0.01)
    words.add_argument("--out", metavar="PREFIX")
    options = words.parse_args()
    runs = [Run(folder) for folder in options.folders]
    print(table(runs, options.begin), end="")
    if options.out:
        draw_slices(runs, options.share, f"{options.out}.png")
        draw_time(runs, options.share, f"{options.out}-time.png")


if __name__ == "__main__":
    try:
        main()
    except ReportError as error:
        sys.exit(f"report_jet: {error}")
