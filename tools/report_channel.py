#!/usr/bin/python3
"""Injection into a channel: the centre lines of runs, a table of what the paper states of them, pictures.

    tools/report_channel.py DIR ... [--from 1.0] [--data PREFIX]
        a table in Markdown, a column a run; with --data the centre line of each in PREFIX-NAME.csv
    tools/report_channel.py --plot FILE.csv ... --out PREFIX [--slice DIR DIR]
        PREFIX-lines.png of such files of cases 1 to 5, PREFIX-grid.png of case1 and case1_fine,
        PREFIX-slice.png of the last particle files of the folders

The folders are results of `gasgrain run inputs/channel_injection`; a run has its folder's name.
"""

import argparse
import csv
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")

import numpy as np

import report_channel_plot
from report_read import ReportError, property_name

FED, INJECTED = 1, 2  # atom types of in.liggghts
NEAR = 0.05  # local equilibrium: of the excess speed at the nozzle


def read_lines(file):
    """Columns of a CSV file by name."""
    try:
        with open(file, newline="") as stream:
            lines = list(csv.reader(stream))
    except OSError as error:
        raise ReportError(f"{file} cannot be read: {error.strerror}") from error
    if len(lines) < 2:
        raise ReportError(f"{file} holds no line of values")
    return dict(zip(lines[0], np.array(lines[1:], dtype=float).T))


def read_dump(file):
    """(step, values by column name) of each time in an ASCII dump of the host."""
    try:
        text = iter(Path(file).read_text().splitlines())
    except OSError as error:
        raise ReportError(f"{file} cannot be read: {error.strerror}") from error
    step = count = None
    for line in text:
        if line == "ITEM: TIMESTEP":
            step = int(next(text))
        elif line == "ITEM: NUMBER OF ATOMS":
            count = int(next(text))
        elif line.startswith("ITEM: ATOMS"):
            names = [property_name(name) for name in line.split()[2:]]
            values = np.array([next(text).split() for _ in range(count)], dtype=float)
            yield step, dict(zip(names, values.reshape(count, len(names)).T))


def velocities_of_types(file, edges, first_step):
    """Mean velocities by mass of fed and of injected parcels between `edges`; 0 where there are none."""
    mass, momentum = np.zeros((2, 2, len(edges) - 1))
    for step, parcels in read_dump(file):
        if step < first_step:
            continue
        whole = parcels["mass"] * parcels["f_particlesPerParcel"]
        for row, kind in enumerate((FED, INJECTED)):
            of = parcels["type"] == kind
            mass[row] += np.histogram(parcels["x"][of], edges, weights=whole[of])[0]
            momentum[row] += np.histogram(parcels["x"][of], edges, weights=(whole * parcels["vx"])[of])[0]
    return np.divide(momentum, mass, out=np.zeros_like(mass), where=mass > 0.0)


def centre_line(folder, begin):
    """The columns of centre_line.csv, and the velocities of fed and injected parcels."""
    folder = Path(folder)
    line = read_lines(folder / "centre_line.csv")
    half = line["position_m"][0]
    edges = np.append(line["position_m"] - half, line["position_m"][-1] + half)
    history = read_lines(folder / "history.csv")
    dt = history["time_s"][-1] / history["step"][-1]
    fed, injected = velocities_of_types(folder / "line.txt", edges, round(begin / dt))
    return {**line, "fed_velocity_m_s": fed, "injected_velocity_m_s": injected}


def write_lines(file, line):
    with open(file, "w", newline="") as stream:
        out = csv.writer(stream, lineterminator="\n")
        out.writerow(line)
        out.writerows([f"{value:.4g}" for value in row] for row in zip(*line.values()))


def reaches(position, excess, share):
    """Where `excess` has come down for good to `share` of its greatest value [m]; nan: nowhere."""
    above = np.nonzero(excess > share * np.max(excess))[0]
    last = above[-1] if len(above) else 0
    if last + 1 >= len(excess):
        return np.nan
    limit = share * np.max(excess)
    part = (excess[last] - limit) / (excess[last] - excess[last + 1])
    return position[last] + part * (position[last + 1] - position[last])


def as_text(distance):
    return "beyond the duct" if np.isnan(distance) else f"{100 * distance:.1f}"


def figures(line):
    """What the paper states of a centre line."""
    x, tau, eta = line["position_m"], line["collision_time_s"], line["eta"]
    rms, equilibrium = line["rms_velocity_m_s"], line["equilibrium_velocity_m_s"]
    fraction = line["particle_fraction"]
    at = lambda where, values: float(np.interp(where, x, values))
    tau_at = lambda where: float(np.exp(np.interp(where, x, np.log(tau))))
    apart = line["injected_velocity_m_s"] - line["fed_velocity_m_s"]
    liquid = line["liquid_velocity_m_s"]
    rows = {
        "u_rms at the nozzle, m/s": f"{rms[0]:.2f}",
        "tau at the nozzle, ms": f"{1e3 * tau[0]:.2f}",
        "tau at 10 cm, ms": f"{1e3 * tau_at(0.1):.1f}",
        "tau at 30 cm, ms": f"{1e3 * tau_at(0.3):.0f}",
        "injected less fed velocity down to 5 % at, cm": as_text(reaches(x, apart, NEAR)),
        "u_rms down to 10 % at, cm": as_text(reaches(x, rms, 0.1)),
        "liquid less U_eq at the nozzle, m/s": f"{liquid[0] - equilibrium[0]:.2f}",
        "the same at 10 and 20 cm, m/s": ", ".join(f"{at(d, liquid - equilibrium):.3f}" for d in (0.1, 0.2)),
        "U_eq at the nozzle, m/s": f"{equilibrium[0]:.2f}",
        "U_eq at 10 cm, at the exit, m/s": f"{at(0.1, equilibrium):.2f}, {equilibrium[-1]:.2f}",
        "eta at the nozzle": f"{eta[0]:.2g}",
        "eta over that at 10, 30, 59 cm": ", ".join(f"{at(d, eta) / eta[0]:.2f}" for d in (0.1, 0.3, x[-1]))
            if eta[0] > 0.0 else "",
        "theta_p at the nozzle, at 10 cm": f"{fraction[0]:.2f}, {at(0.1, fraction):.2f}",
    }
    if not liquid.any():
        rows.update({what: "" for what in rows if what.startswith(("liquid", "the same", "eta"))})
    return rows


def table(columns):
    names = list(columns)
    rows = {name: figures(line) for name, line in columns.items()}
    yield "| | " + " | ".join(names) + " |"
    yield "|---" * (len(names) + 1) + "|"
    for what in rows[names[0]]:
        yield f"| {what} | " + " | ".join(rows[name][what] for name in names) + " |"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("runs", nargs="*")
    parser.add_argument("--from", dest="begin", type=float, default=1.0)
    parser.add_argument("--data")
    parser.add_argument("--plot", nargs="+", default=[])
    parser.add_argument("--slice", nargs="+", default=[])
    parser.add_argument("--out")
    given = parser.parse_args()
    if bool(given.plot or given.slice) != bool(given.out) or not (given.runs or given.plot or given.slice):
        parser.error("give folders of runs, or --plot or --slice with --out")
    try:
        columns = {Path(run).name: centre_line(run, given.begin) for run in given.runs}
        for name, line in columns.items():
            if given.data:
                write_lines(f"{given.data}-{name}.csv", line)
        if columns:
            print("\n".join(table(columns)))
        if given.plot:
            lines = {Path(file).stem.split("-")[-1]: read_lines(file) for file in given.plot}
            report_channel_plot.draw_lines(lines, f"{given.out}-lines.png")
            if "case1_fine" in lines:
                report_channel_plot.draw_grids(lines, f"{given.out}-grid.png")
        if given.slice:
            report_channel_plot.draw_slices(given.slice, f"{given.out}-slice.png")
    except ReportError as error:
        sys.exit(f"report_channel: {error}")


if __name__ == "__main__":
    main()
