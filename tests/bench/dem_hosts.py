#!/usr/bin/python3
"""Speed of the grains' contacts in both hosts on one settled bed: each host's own styles, and ours in it.

A periodic tile of glass spheres of 2.5 mm is packed once on a floor, and repeated sideways up to the number that
is asked for; all grains then get small random velocities. All programs run the same bed for the same steps, one
after the other, again and again, so that a noisy machine treats them alike; what counts is the median and the
ratio. The wet bed has bridges by the script's liquid in ours, by its washino model in stock LIGGGHTS.

    tests/bench/dem_hosts.py [--grains 5000 36500] [--ranks 1 2] [--steps 2000] [--repeats 5]
    tests/bench/dem_hosts.py --quick     whether everything runs, a few steps of one tile: no figures
"""

import argparse
import csv
import os
import random
import re
import statistics
import subprocess
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
DIAMETER, DENSITY, DT = 0.0025, 2500.0, 1.0e-5  # m, kg/m3, s
TILE, LAYERS = 8, 40                            # spheres across, and in depth, before the tile settles
PITCH = 1.04 * DIAMETER
SETTLING = 0.2                                  # s
SPEED = 0.02                                    # m/s, greatest of each component when the timing begins
HEIGHT = 0.13                                   # m, of the box

MATERIALS = """\
fix youngs all property/global youngsModulus peratomtype 5e6
fix poisson all property/global poissonsRatio peratomtype 0.17
fix restitution all property/global coefficientRestitution peratomtypepair 1 0.9
fix friction all property/global coefficientFriction peratomtypepair 1 0.1
"""
WASHINO = """\
fix viscosity all property/global fluidViscosity scalar 1e-3
fix tension all property/global surfaceTension scalar 0.0728
fix angle all property/global contactAngle peratomtype 0.35
fix least all property/global minSeparationDistanceRatio scalar 1.001
fix ratio all property/global maxSeparationDistanceRatio scalar 1.1
fix content all property/global surfaceLiquidContentInitial scalar 0.5
"""
LIQUID = ("fix liquid all liquid content 0.005 surface_tension 0.0728 contact_angle 0.35 viscosity 1e-3 "
          "minimum_separation 1e-6\n")
MODEL = "model hertz tangential history"
# The same spheres in the words of LAMMPS's own styles; damping as MODEL's at an overlap of 1 um.
OWN_LAW = "3.43e6 4.67e6 8.7e6 NULL 0.1 1"
GRANULAR = "hertz/material 5e6 0.9 0.17 damping tsuji tangential mindlin NULL 1.0 0.1"


class Program:
    """One line of the table: `pair` and `wall` are the script's lines."""

    def __init__(self, name, host, ours, pair, wall, before="", coeff="* *", wet=False, stock_of=None):
        self.name, self.host, self.ours, self.wet = name, host, ours, wet
        self.stock_of = stock_of  # the line that this one replaces
        self.models = f"{before}pair_style {pair}\npair_coeff {coeff}\nfix floor all {wall}\n"


def liggghts(name, ours, words="", before="", after="", **more):
    return Program(name, "liggghts", ours, f"gran {MODEL} {words}",
                   f"wall/gran {MODEL} {words} primitive type 1 zplane 0.0{after}", MATERIALS + before, **more)


def bridge(name, words, before="", after="", **more):
    return Program(name, "lammps", True, f"gran/bridge {words}",
                   f"wall/gran/bridge {words} primitive type 1 zplane 0.0{after}", MATERIALS + before, **more)


PROGRAMS = [
    liggghts("LIGGGHTS gran", False),
    liggghts("LIGGGHTS, ours, gran", True, stock_of="LIGGGHTS gran"),
    liggghts("LIGGGHTS, ours, bridge without liquid", True, "cohesion bridge",
             LIQUID.replace("content 0.005", "content 0"), stock_of="LIGGGHTS gran"),
    Program("LAMMPS granular", "lammps", False, "granular", f"wall/gran granular {GRANULAR} zplane 0.0 NULL",
            coeff=f"* * {GRANULAR}"),
    Program("LAMMPS gran/hertz/history", "lammps", False, f"gran/hertz/history {OWN_LAW}",
            f"wall/gran hertz/history {OWN_LAW} zplane 0.0 NULL"),
    bridge("LAMMPS, ours, hertz/history", f"hertz/history {OWN_LAW}", stock_of="LAMMPS gran/hertz/history"),
    bridge("LAMMPS, ours, model hertz", MODEL, stock_of="LIGGGHTS gran"),
    liggghts("LIGGGHTS gran, washino", False, "cohesion washino/capillary/viscous", WASHINO, wet=True,
             after=" "),
    liggghts("LIGGGHTS, ours, bridge", True, "cohesion bridge", LIQUID, wet=True,
             stock_of="LIGGGHTS gran, washino"),
    bridge("LAMMPS, ours, bridge", f"{MODEL} cohesion bridge", LIQUID, wet=True,
           stock_of="LIGGGHTS gran, washino"),
]


def head(host, build, data):
    lammps = host == "lammps"
    lines = [f"include {build / 'gasgrain.lmp'}"] if lammps and build else []
    return "\n".join([*lines, f"atom_style {'sphere' if lammps else 'granular'}", "atom_modify map array", "units si",
                      "boundary p p f", "newton off", "comm_modify vel yes" if lammps else "communicate single vel yes",
                      "processors * * 1", f"read_data {data}", "neighbor 0.0005 bin", "neigh_modify delay 0",
                      f"timestep {DT}"]) + "\n"


def gravity(host):
    return f"fix weight all gravity 9.81 vector 0 0 -1\nfix move all nve/sphere\n"


def launch(work, host, build, ours, name, text, ranks):
    """The times of the script's runs [s]."""
    script = work / f"in.{re.sub('[^a-z]+', '_', name.lower())}"
    script.write_text(text)
    program = build / "gasgrain-liggghts" if host == "liggghts" and ours else {"liggghts": "liggghts"}.get(host, "lmp")
    command = [str(program), "-in", script.name, "-log", "none"]
    if ranks > 1:
        command = ["mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none", "-np", str(ranks), *command]
    environment = dict(os.environ, OMP_NUM_THREADS="1", OMPI_MCA_mpi_yield_when_idle="1")
    done = subprocess.run(command, cwd=work, env=environment, capture_output=True, text=True, check=False)
    times = re.findall(r"Loop time of ([\d.e+-]+)", done.stdout)
    if done.returncode != 0 or not times:
        raise SystemExit(f"{' '.join(command)}\n{done.stdout[-2000:]}\n{done.stderr[-2000:]}")
    return [float(time) for time in times]


def write_data(path, places, width, depth, seed=1):
    roll = random.Random(seed)
    text = f"bed\n\n{len(places)} atoms\n1 atom types\n\n0 {width!r} xlo xhi\n0 {depth!r} ylo yhi\n0 {HEIGHT} zlo zhi\n"
    text += "\nAtoms\n\n" + "".join(f"{n + 1} 1 {DIAMETER} {DENSITY} {x!r} {y!r} {z!r}\n"
                                    for n, (x, y, z) in enumerate(places))
    text += "\nVelocities\n\n" + "".join(
        f"{n + 1} " + " ".join(f"{roll.uniform(-SPEED, SPEED)!r}" for _ in range(3)) + " 0 0 0\n"
        for n in range(len(places)))
    path.write_text(text)


def packed_tile(work, build, settling):
    """Places of the grains of a settled tile."""
    found = work / f"tile.{settling}.txt"
    side = TILE * PITCH
    if not found.exists():
        print("packing a tile ...", flush=True)
        roll = random.Random(3)
        loose = [tuple((k + 0.5) * PITCH + roll.uniform(-0.015, 0.015) * DIAMETER for k in (i, j, k))
                 for k in range(LAYERS) for j in range(TILE) for i in range(TILE)]
        write_data(work / "loose.data", loose, side, side)
        text = head("lammps", build, "loose.data") + MATERIALS + (
            f"pair_style gran/bridge {MODEL}\npair_coeff * *\n"
            f"fix floor all wall/gran/bridge {MODEL} primitive type 1 zplane 0.0\n") + gravity("lammps")
        text += (f"fix slow all viscous 1e-4\nrun {round(settling / DT)}\n"
                 f"write_dump all custom {found.name} x y z modify sort id format float %.17g\n")
        launch(work, "lammps", build, True, "pack", text, 1)
    rows = [line.split() for line in found.read_text().split("ITEM: ATOMS")[1].splitlines()[1:]]
    return [(float(x) % side, float(y) % side, float(z)) for x, y, z in rows], side


def make_bed(work, build, grains, settling):
    """(name of the data file, grains in it)"""
    tile, side = packed_tile(work, build, settling)
    tiles = max(1, round(grains / len(tile)))
    across = max(n for n in range(1, tiles + 1) if tiles % n == 0 and n * n <= tiles)
    along = tiles // across
    places = [(x + i * side, y + j * side, z) for i in range(along) for j in range(across) for x, y, z in tile]
    name = f"bed.{len(places)}.data"
    write_data(work / name, places, along * side, across * side)
    return name, len(places)


def table(rows, options):
    text = (f"Settled bed, {options.steps} steps, median of {options.repeats} (least to greatest), "
            "all in one run, interleaved.\n\n| grains | ranks | bed | | particle-steps/s | of what it replaces |\n"
            "|---|---|---|---|---|---|\n")
    for row in rows:
        text += (f"| {row['grains']} | {row['ranks']} | {row['bed']} | {row['program']} | {row['median']:.3g} "
                 f"({row['least']:.3g} to {row['greatest']:.3g}) | {row['ratio']} |\n")
    return text


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=Path, default=SOURCE / "build")
    parser.add_argument("--work", type=Path, default=SOURCE / "results" / "dem_hosts")
    parser.add_argument("--grains", type=int, nargs="+", default=[5000, 36500])
    parser.add_argument("--ranks", type=int, nargs="+", default=[1, 2])
    parser.add_argument("--steps", type=int, default=2000)
    parser.add_argument("--repeats", type=int, default=5)
    parser.add_argument("--only", nargs="+", default=[], help="parts of the names of the programs")
    parser.add_argument("--quick", action="store_true")
    options = parser.parse_args()
    work, build = options.work.resolve(), options.build.resolve()
    work.mkdir(parents=True, exist_ok=True)
    settling = SETTLING
    if options.quick:
        options.grains, options.ranks, options.steps, options.repeats, settling = [1], [1], 5, 1, 1e-3
    programs = [p for p in PROGRAMS if not options.only or any(part in p.name for part in options.only)]
    rows = []
    for grains in options.grains:
        data, number = make_bed(work, build, grains, settling)
        for ranks in options.ranks:
            speeds = {program.name: [] for program in programs}
            for repeat in range(options.repeats):
                for program in programs:
                    plugin = build if program.ours else None
                    text = head(program.host, plugin, data) + program.models + gravity(program.host)
                    text += f"thermo {options.steps}\nrun {max(1, options.steps // 10)}\nrun {options.steps}\n"
                    times = launch(work, program.host, build, program.ours, program.name, text, ranks)
                    speeds[program.name].append(number * options.steps / times[-1])
                    print(f"{number} grains, {ranks} rank(s), {repeat + 1} of {options.repeats}: {program.name} "
                          f"{speeds[program.name][-1]:.3g}", flush=True)
            for program in programs:
                values = speeds[program.name]
                median = statistics.median(values)
                stock = statistics.median(speeds[program.stock_of]) if speeds.get(program.stock_of) else None
                rows.append({"grains": number, "ranks": ranks, "bed": "wet" if program.wet else "dry",
                             "program": program.name, "median": median, "least": min(values),
                             "greatest": max(values), "ratio": f"{median / stock:.2f}" if stock else ""})
    with (work / "dem_hosts.csv").open("w", newline="") as file:
        writer = csv.DictWriter(file, rows[0].keys())
        writer.writeheader()
        writer.writerows(rows)
    text = table(rows, options)
    (work / "dem_hosts.md").write_text(text)
    print("\n" + text)


if __name__ == "__main__":
    main()
