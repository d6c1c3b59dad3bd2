#!/usr/bin/python3
"""Speed of the grains' contacts: stock LIGGGHTS and LAMMPS, and ours in both, on the same beds.

A settled and a bubbling bed of glass spheres of 2.5 mm, dry and wet. All programs run the same bed for the same
steps, one after the other, again and again, so that a noisy machine treats them alike: what counts are the medians,
and the medians of the ratios within a round. Speeds are those of the time loop alone. The pairs that touch are
counted after it.

    tests/bench/dem.py                         the whole table, about 40 minutes
    tests/bench/dem.py --docs                  the same, for docs/data/dem_speed.csv and docs/images/dem_*.png
    tests/bench/dem.py --grains 36500 --ranks 1 --beds settled --only 'LIGGGHTS gran'
    tests/bench/dem.py --quick                 whether everything runs, a few steps of one tile: no figures
"""

import argparse
import shutil
import statistics
import time
from pathlib import Path

import dem_beds
import dem_plot
import dem_table
from dem_programs import COUNTED, PROGRAMS, STOCK_LAMMPS, STOCK_LIGGGHTS, TIMED
from dem_run import NUMBER, TASKS, kinetic_energies, launch, one_number, script_name, shares

SOURCE = Path(__file__).resolve().parents[2]
BEDS = ("settled", "bubbling")
# Steps of a run: so many particle-steps, within these bounds. A bubbling bed collapses without its gas: it is timed
# for 5 ms at most, and for long enough to make its neighbour lists anew a few times.
WORK = 6.0e6
STEPS = {"settled": (30, 1500), "bubbling": (80, 500)}


def steps_of(bed, grains):
    least, most = STEPS[bed]
    return max(least, min(most, round(WORK / grains)))


def one_run(work, build, program, data, grains, ranks, steps):
    """What a program says of a run."""
    text = launch(work, program.command(build), script_name(program.name), program.script(build, data, steps), ranks)
    timed, counted = text.split(TIMED)[-1].split(COUNTED)[:2]
    seconds = one_number("time of the loop", rf"Loop time of {NUMBER}", timed)
    touching = one_number("contacts", rf"^ *\d+ +{NUMBER} *$", counted) / 2  # the sum counts both grains of a pair
    begin, end = kinetic_energies(timed)
    return {"speed": grains * steps / seconds, "contacts": touching, "contact_speed": touching * steps / seconds,
            "rebuilds": one_number("rebuilds", r"Neighbor list builds = (\d+)", timed),
            "neighbours": one_number("neighbours", rf"Ave neighs/atom = {NUMBER}", timed),
            "energy_begin": begin, "energy_end": end, **shares(timed)}


def ratio(of, to):
    """Median of the ratios within a round."""
    return statistics.median(a["speed"] / b["speed"] for a, b in zip(of, to))


def row_of(program, runs, case):
    """A row of the table; `runs`: those of all programs of the case."""
    own = runs[program.name]
    speeds = [run["speed"] for run in own]

    def median(name):
        return statistics.median(run[name] for run in own)

    def of(name):
        return f"{ratio(own, runs[name]):.3f}" if name in runs and name != program.name else ""

    stocks = [name for name in STOCK_LAMMPS if name in runs and program.liquid == "dry"]
    fastest = max(stocks, key=lambda name: statistics.median(run["speed"] for run in runs[name]), default=None)
    return {**case, "liquid": program.liquid, "program": program.name,
            "ours": int(program.ours), "median": f"{median('speed'):.5g}", "least": f"{min(speeds):.5g}",
            "greatest": f"{max(speeds):.5g}", "contacts_per_s": f"{median('contact_speed'):.5g}",
            **{name: f"{statistics.mean(run[name] for run in own):.4f}" for name in TASKS},
            "of_replaced": of(program.replaces), "of_stock_liggghts": of(STOCK_LIGGGHTS[program.liquid]),
            "of_faster_stock_lammps": of(fastest), "contacts": f"{median('contacts'):.0f}",
            "neighbours_per_grain": f"{median('neighbours'):.3f}", "rebuilds": f"{median('rebuilds'):.0f}",
            "kinetic_energy_begin": f"{median('energy_begin'):.5g}",
            "kinetic_energy_end": f"{median('energy_end'):.5g}"}


def time_case(work, build, programs, options, bed, data, grains, ranks):
    steps = options.steps or steps_of(bed, grains)
    case = {"bed": bed, "grains": grains, "ranks": ranks, "steps": steps, "repeats": options.repeats}
    runs = {program.name: [] for program in programs}
    for repeat in range(options.repeats):
        # There and back: a machine that slowly warms up or is slowly taken favours nobody.
        for program in programs if repeat % 2 == 0 else reversed(programs):
            run = one_run(work, build, program, data, grains, ranks, steps)
            runs[program.name].append(run)
            print(f"{time.strftime('%H:%M:%S')} {bed} {grains} x {steps} steps, {ranks} rank(s), "
                  f"{repeat + 1} of {options.repeats}: {program.name} {run['speed']:.3g}", flush=True)
    return [row_of(program, runs, case) for program in programs]


def check_contacts(rows):
    """After a few steps from one bed all programs have the same contacts, but for grains that only just touch."""
    for row in rows:
        first = int(next(other for other in rows if other["bed"] == row["bed"])["contacts"])
        if first == 0 or abs(int(row["contacts"]) - first) > 0.02 * first:
            raise SystemExit(f"dem.py: {row['program']} has {row['contacts']} contacts in the {row['bed']} bed, "
                             f"{rows[0]['program']} {first}")


def read_options():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=Path, default=SOURCE / "build")
    parser.add_argument("--work", type=Path, default=SOURCE / "results" / "dem")
    parser.add_argument("--beds", nargs="+", choices=BEDS, default=BEDS)
    parser.add_argument("--grains", type=int, nargs="+", default=[5000, 36500, 300000],
                        help="rounded to whole tiles of 5,000")
    parser.add_argument("--ranks", type=int, nargs="+", default=[1, 2])
    parser.add_argument("--steps", type=int, help="in the place of what the number of grains says")
    parser.add_argument("--repeats", type=int, default=5)
    parser.add_argument("--only", nargs="+", default=[], help="parts of the names of the programs")
    parser.add_argument("--docs", action="store_true", help="write the table and the plot of docs/dem-speed.md")
    parser.add_argument("--quick", action="store_true")
    return parser.parse_args()


def main():
    options = read_options()
    work, build = options.work.resolve(), options.build.resolve()
    work.mkdir(parents=True, exist_ok=True)
    settling, bubbling = dem_beds.SETTLING, dem_beds.BUBBLING
    if options.quick:
        options.grains, options.ranks, options.steps, options.repeats = [1], [1], 5, 1
        settling, bubbling = 1e-2, 2e-3
    programs = [program for program in PROGRAMS
                if (any(part in program.name for part in options.only) if options.only else not program.extra)]
    tiles = dem_beds.make_tiles(work, build, settling, bubbling)
    rows = []
    for grains in options.grains:
        for bed in options.beds:
            data, number = dem_beds.make_bed(work, tiles[bed], grains, shaken=bed == "settled")
            for ranks in options.ranks:
                rows += time_case(work, build, programs, options, bed, data, number, ranks)
                dem_table.write_csv(work / "dem.csv", rows)  # what is done is kept when a later run fails
    text = dem_table.markdown(rows)
    (work / "dem.md").write_text(text)
    print("\n" + text)
    dem_plot.plot(rows, work / "dem.png")
    if options.quick:
        check_contacts(rows)
    dem_plot.plot_beds(tiles, work / "beds.png")
    if options.docs:
        for kept, name in (("dem.csv", "data/dem_speed.csv"), ("dem.png", "images/dem_speed.png"),
                           ("beds.png", "images/dem_beds.png")):
            shutil.copyfile(work / kept, SOURCE / "docs" / name)


if __name__ == "__main__":
    main()
