#!/usr/bin/python3
"""How far a jet of droplets goes into a bed of parcels.

    tools/report_jet.py DIR... [--from 0.25] [--out PREFIX]
        a table in Markdown of means over the particle files from --from [s] after the first
        droplets on
    with --out
        PREFIX.png        droplets and liquid on the bed's parcels in a slice through the jet
        PREFIX-flow.png   the share of the jet's liquid that droplets still carry, over the distance
        PREFIX-flow.csv   the same

Penetration is told in two ways, along the jet (x) and within 3 cm of its axis:
    half, tenth       distance at which droplets carry one half, one tenth of the liquid's flow on:
                      sum of N V_f u_x over the droplets of a bin, over the bin and the mean flow
    droplets          distance to the end of the first gap of 5 mm without a droplet that still
                      holds a hundredth of its liquid, as seen on a picture of the droplets
Droplets are the parcels of type 2. The folders are results of `gasgrain run inputs/jet_penetration`.
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
GAP = 0.005  # m, of the droplets on a picture
BIN = 0.01  # m, of the flow
LENGTH = 0.16  # m, to the wall
TUBE = 0.03  # m, half of the width looked at
DROPLET = 2  # type
SEEN = 0.01  # of its liquid, that a droplet must hold to be seen


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

        off = self.centres - NOZZLE
        self.along = off[:, 0]
        self.near = self.droplet & (np.hypot(off[:, 1], off[:, 2]) < TUBE)

    def liquid(self):
        """Of all parcels [m3]."""
        return float(np.sum(self.film * self.fields["f_particlesPerParcel"]))

    def reach_of_droplets(self, whole):
        """[m], 0 without a droplet at the nozzle. whole: liquid of a fresh droplet [m3]."""
        bins = np.floor(self.along[self.near & (self.film >= SEEN * whole)] / GAP).astype(int)
        held = np.bincount(bins[bins >= 0], minlength=1) > 0
        gaps = np.flatnonzero(~held)
        return GAP * (gaps[0] if len(gaps) else len(held))

    def flow(self):
        """Volume of liquid that the droplets of each bin carry on [m3/s]."""
        here = self.near & (self.along >= 0.0) & (self.along < LENGTH)
        carried = (self.film * self.fields["f_particlesPerParcel"] * self.fields["v"])[here]
        return np.bincount((self.along[here] / BIN).astype(int), carried, round(LENGTH / BIN)) / BIN


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
        first, last = self.moments[0], self.moments[-1]
        if last.time <= first.time:
            raise ReportError(f"{folder}: two particle files with droplets are needed, there is one")
        self.jet = (last.liquid() - first.liquid()) / (last.time - first.time)  # m3/s

    def later(self, begin):
        taken = [moment for moment in self.moments if moment.time >= self.moments[0].time + begin]
        if not taken:
            raise ReportError(f"{self.folder}: no particle file {begin} s after the first droplets; --from is too late")
        return taken

    def share(self, begin):
        """Of the jet's liquid, carried on by the droplets of each bin: the mean."""
        return np.mean([moment.flow() for moment in self.later(begin)], axis=0) / self.jet

    def reaches(self, begin):
        return np.array([moment.reach_of_droplets(self.whole) for moment in self.later(begin)])


def distance_at(share, level):
    """Where the share falls below a level for good [m], linear between the bins' centres."""
    above = np.flatnonzero(share >= level)
    if len(above) == 0:
        return 0.0
    n = above[-1]
    if n + 1 == len(share):
        return LENGTH
    return BIN * (n + 0.5 + (share[n] - level) / (share[n] - share[n + 1]))


def table(runs, begin):
    text = ("| run | half [cm] | tenth [cm] | droplets [cm] | deviation [cm] | files |\n"
            "|---|---|---|---|---|---|\n")
    for run in runs:
        share, reaches = run.share(begin), 100 * run.reaches(begin)
        text += (f"| {run.folder.name} | {100 * distance_at(share, 0.5):.1f} | {100 * distance_at(share, 0.1):.1f} | "
                 f"{reaches.mean():.1f} | {reaches.std():.1f} | {len(reaches)} |\n")
    return text


def draw_slices(runs, file, pictures=5):
    figure, axes = plt.subplots(len(runs), pictures, figsize=(2.6 * pictures, 3.4 * len(runs)), squeeze=False,
                                sharex=True, sharey=True, layout="constrained")
    for row, run in zip(axes, runs):
        for axis, n in zip(row, np.linspace(len(run.moments) / pictures, len(run.moments), pictures).astype(int) - 1):
            moment = run.moments[n]
            thin = np.abs(moment.centres[:, 1] - NOZZLE[1]) < 0.015
            bed = thin & ~moment.droplet
            solid = 4.0 / 3.0 * np.pi * moment.fields["radius"] ** 3 - moment.film
            wet = moment.film / np.maximum(solid, 1e-30)
            shown = axis.scatter(*moment.centres[bed][:, [0, 2]].T, c=wet[bed], s=2, cmap="viridis_r", vmin=0.0, vmax=0.05,
                                 edgecolors="none")
            alive = thin & moment.droplet & (moment.film >= SEEN * run.whole)
            axis.plot(*moment.centres[alive][:, [0, 2]].T, "r.", ms=2)
            axis.set_aspect("equal")
            axis.set_xlim(*run.box[0])
            axis.set_ylim(run.box[2][0], 0.3)
            axis.set_title(f"{run.folder.name}, {moment.time:.1f} s", fontsize=9)
    figure.colorbar(shown, ax=axes, label="liquid over solid volume of bed parcels", shrink=0.6)
    figure.savefig(file, dpi=100)


def draw_flow(runs, begin, file):
    figure, axis = plt.subplots(figsize=(7, 4))
    centres = 100 * BIN * (np.arange(round(LENGTH / BIN)) + 0.5)
    for run in runs:
        axis.plot(centres, run.share(begin), ".-", label=run.folder.name)
    axis.axhline(0.5, color="grey", lw=0.5)
    axis.set_xlabel("distance from the nozzle [cm]")
    axis.set_ylabel("liquid still carried by droplets, of the jet's")
    axis.legend()
    figure.tight_layout()
    figure.savefig(file, dpi=100)


def write_flow(runs, begin, file):
    rows = np.array([run.share(begin) for run in runs]).T
    with open(file, "w") as stream:
        stream.write("distance_m," + ",".join(run.folder.name for run in runs) + "\n")
        for n, row in enumerate(rows):
            stream.write(f"{BIN * (n + 0.5):g}," + ",".join(f"{value:.4f}" for value in row) + "\n")


def main():
    words = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("folders", nargs="+", metavar="DIR")
    words.add_argument("--from", dest="begin", type=float, default=0.25)
    words.add_argument("--out", metavar="PREFIX")
    options = words.parse_args()
    runs = [Run(folder) for folder in options.folders]
    print(table(runs, options.begin), end="")
    if options.out:
        draw_slices(runs, f"{options.out}.png")
        draw_flow(runs, options.begin, f"{options.out}-flow.png")
        write_flow(runs, options.begin, f"{options.out}-flow.csv")


if __name__ == "__main__":
    try:
        main()
    except ReportError as error:
        sys.exit(f"report_jet: {error}")
