"""What the tests with many grains share: a random suspension in a column with periodic sides, its run
through both programs, and what the run wrote."""

import csv
import math
import shutil
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

import numpy as np

DOCS = Path(__file__).resolve().parents[2] / "docs"
GRAVITY = 9.81
LEAST_STEPS_A_CONTACT = 14


def build_folder():
    """The build as first argument, as in `fluidisation.py build --full`; taken off sys.argv."""
    named = len(sys.argv) > 1 and not sys.argv[1].startswith("-")
    return Path(sys.argv.pop(1) if named else "build").resolve()


BIN = build_folder()


def random_spheres(count, size, seed):
    """Centres (count, 3) of spheres of diameter 1 added one by one where there is room in a box
    (0, size), periodic along x and y, between walls along z."""
    random = np.random.default_rng(seed).random
    lx, ly, lz = size
    nx, ny = int(lx), int(ly)
    bins, centres = {}, []

    def free(x, y, z, i, j, k):
        for a in (i - 1, i, i + 1):
            for b in (j - 1, j, j + 1):
                for c in (k - 1, k, k + 1):
                    for other in bins.get((a % nx, b % ny, c), ()):
                        dx, dy, dz = x - other[0], y - other[1], z - other[2]
                        dx -= lx * round(dx / lx)
                        dy -= ly * round(dy / ly)
                        if dx * dx + dy * dy + dz * dz < 1.0:
                            return False
        return True

    while len(centres) < count:
        x, y, z = lx * random(), ly * random(), 0.5 + (lz - 1) * random()
        i, j, k = int(x / lx * nx), int(y / ly * ny), int(z)
        if free(x, y, z, i, j, k):
            bins.setdefault((i, j, k), []).append((x, y, z))
            centres.append((x, y, z))
    return np.array(centres)


def grains_data(centres, size, diameter, density):
    """A file for read_data."""
    lines = ["grains", "", f"{len(centres)} atoms", "1 atom types"]
    lines += [f"0 {length!r} {axis}lo {axis}hi" for axis, length in zip("xyz", size)]
    lines += ["", "Atoms", ""]
    lines += [f"{i} 1 {diameter!r} {density!r} {x!r} {y!r} {z!r}"
              for i, (x, y, z) in enumerate(np.asarray(centres).tolist(), 1)]
    return "\n".join(lines) + "\n"


def script(diameter, mass, step, friction, floor, top, restitution=0.9):
    """Head of a LIGGGHTS script: linear springs that a contact of LEAST_STEPS_A_CONTACT steps wants.
    Hertz's law would ask for a modulus of 5e6 Pa at least."""
    contact = LEAST_STEPS_A_CONTACT * step
    stiffness = 0.5 * mass * (math.pi / contact)**2
    damping = -2 * math.log(restitution) / contact
    tangential = "history" if friction else "off"
    model = f"model hooke/stiffness tangential {tangential}"
    return f"""\
atom_style granular
atom_modify map array
units si
boundary p p f
newton off
communicate single vel yes
read_data grains.data
neighbor {0.3 * diameter!r} bin
neigh_modify delay 0
timestep {step!r}
fix kn all property/global kn peratomtypepair 1 {stiffness!r}
fix kt all property/global kt peratomtypepair 1 {0.8 * stiffness!r}
fix gamman all property/global gamman peratomtypepair 1 {damping!r}
fix gammat all property/global gammat peratomtypepair 1 {damping!r}
fix friction all property/global coefficientFriction peratomtypepair 1 {friction}
pair_style gran/bridge {model}
pair_coeff * *
fix z_lo all wall/gran {model} store_force yes primitive type 1 zplane {floor!r}
fix z_hi all wall/gran {model} primitive type 1 zplane {top!r}
fix weight all gravity {GRAVITY} vector 0 0 -1
fix motion all nve/sphere
thermo_style custom step atoms ke
thermo 10000
thermo_modify lost error norm no
"""


def gas_toml(size, cells, density, viscosity, step, more):
    sides = "".join(f'{side} = "periodic"\n' for side in ("x_lo", "x_hi", "y_lo", "y_hi"))
    return (f"[grid]\nlo = [0.0, 0.0, 0.0]\nhi = {[float(s) for s in size]}\ncells = {list(cells)}\n"
            f"[gas]\ndensity = {density!r}\nviscosity = {viscosity!r}\n"
            f"[time]\nstep = {step!r}\n[boundary]\n{sides}{more}")


class Run:
    """Both programs, one rank each, in a folder of their own that lives as long as the `with`."""

    def __init__(self, files, timeout=900):
        self.folder = Path(tempfile.mkdtemp(prefix="gasgrain-suspension-"))
        for name, text in files.items():
            (self.folder / name).write_text(text, encoding="ascii")
        begin = time.monotonic()
        done = subprocess.run(
            ["mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none", "-np", "1",
             BIN / "gasgrain-liggghts", "-in", "in.liggghts", ":", "-np", "1",
             BIN / "gasgrain-gas", "gas.toml", "--out", "out"],
            cwd=self.folder, capture_output=True, text=True, timeout=timeout, check=False)
        self.seconds = time.monotonic() - begin
        if done.returncode != 0:
            raise RuntimeError(f"{self.folder}: {done.stdout}{done.stderr}")

    def __enter__(self):
        return self

    def __exit__(self, *error):
        shutil.rmtree(self.folder)

    def history(self):
        """{column: values} of history.csv while the gas flows."""
        with open(self.folder / "out" / "history.csv", encoding="ascii") as file:
            rows = list(csv.DictReader(file))
        columns = {key: np.array([float(row[key]) for row in rows]) for key in rows[0]}
        flows = columns["time_s"] > 0
        return {key: values[flows] for key, values in columns.items()}

    def frames(self):
        """(step, columns of the dump by grain) of grains.dump."""
        with open(self.folder / "grains.dump", encoding="ascii") as file:
            while file.readline():
                step = int(file.readline())
                file.readline()
                count = int(file.readline())
                for _ in range(5):
                    file.readline()
                yield step, np.loadtxt(file, max_rows=count, ndmin=2)


def write_csv(path, rows):
    with open(path, "w", newline="", encoding="ascii") as file:
        writer = csv.DictWriter(file, rows[0].keys(), lineterminator="\n")
        writer.writeheader()
        for row in rows:
            writer.writerow({key: f"{value:.5g}" if isinstance(value, float) else value
                             for key, value in row.items()})


def read_csv(path):
    def value(text):
        try:
            return float(text)
        except ValueError:
            return text

    with open(path, encoding="ascii") as file:
        return [{key: value(text) for key, text in row.items()} for row in csv.DictReader(file)]


def main(study, plot):
    """--full: the study and its picture; --plot: the picture of the last study; else the tests."""
    if sys.argv[1:] == ["--full"]:
        study()
    if sys.argv[1:] in (["--full"], ["--plot"]):
        plot()
    else:
        unittest.main(module="__main__", verbosity=2)
