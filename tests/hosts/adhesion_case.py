"""Grains with our contact models in LIGGGHTS scripts: what the tests of adhesion and rolling share."""

import math
import os
import re
import subprocess
import tempfile
import unittest
from decimal import getcontext
from pathlib import Path

from coupled_launch import BIN

getcontext().prec = 60
BOLTZMANN = 1.380649e-23
GAS_CONSTANT = 8.31446262
YOUNGS, POISSON, DENSITY = 5e6, 0.17, 2500.0
MODULUS = YOUNGS / 2 / (1 - POISSON**2)  # effective, of two bodies of one material
HEAD = """\
atom_style granular
atom_modify map array sort 0 0
units @units@
boundary f f f
newton off
communicate single vel yes
@processors@
region box block 0 0.002 0 0.002 0 0.002 units box
create_box 2 box
neighbor @skin@ bin
neigh_modify delay 0
timestep @dt@
"""
MATERIALS = """\
fix youngs all property/global youngsModulus peratomtype 5e6 5e6
fix poisson all property/global poissonsRatio peratomtype 0.17 0.17
fix restitution all property/global coefficientRestitution peratomtypepair 2 @e@ @e@ @e@ @e@
fix friction all property/global coefficientFriction peratomtypepair 2 @mu@ @mu@ @mu@ @mu@
fix speed all property/global characteristicVelocity scalar 0.1
"""
DUMP = """\
dump forces all custom @every@ dump.txt id x y z fx fy fz vx vy vz omegax omegay omegaz
dump_modify forces format "%d %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g"
"""
COLUMNS = ("x", "y", "z", "fx", "fy", "fz", "vx", "vy", "vz", "wx", "wy", "wz")


class Case:
    """A few grains given by (x, y, z, diameter, type), their contact models, and what happens."""

    def __init__(self, grains, model, properties="", wall="", after="run 1", words="", **marks):
        values = {"processors": "processors * 1 1", "skin": "2e-5", "dt": "1e-8", "every": 1, "e": "1.0", "mu": "0.5", "units": "si",
                  **marks}
        text = HEAD
        for x, y, z, _, kind in grains:
            text += f"create_atoms {kind} single {x!r} {y!r} {z!r} units box\n"
        for n, grain in enumerate(grains):
            text += f"set atom {n + 1} diameter {grain[3]!r} density {DENSITY}\n"
        # What is compiled with every cohesion; the host's own loop takes the rest.
        compiled = re.match(r"model (hertz|hooke)(?!/)( tangential (history|no_history))?\b(?!.* epsd3)", model)
        style = "gran/bridge" if compiled else "gran"
        text += MATERIALS + properties + f"\npair_style {style} {model} {words}\npair_coeff * *\n"
        if wall:  # where a wall's words stand after its shape
            text += f"{wall} {words}\n".replace("@model@", model)
        text += DUMP + after + "\n"
        for mark, value in values.items():
            text = text.replace(f"@{mark}@", str(value))
        self.text = text

    def run(self, folder=None, ranks=1, **environment):
        """(status, everything printed, {step: {id: {column: value}}})"""
        if folder is None:
            with tempfile.TemporaryDirectory(prefix="gasgrain-test-") as own:
                return self.run(Path(own), ranks, **environment)
        (folder / "in.liggghts").write_text(self.text)
        command = [str(BIN / "gasgrain-liggghts"), "-in", "in.liggghts", "-log", "none"]
        if ranks > 1:
            command = ["mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none", "-np",
                       str(ranks), *command]
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=60,
                              check=False, env={**os.environ, **environment})
        dump = folder / "dump.txt"
        return (done.returncode, done.stdout + done.stderr,
                read_dump(dump.read_text()) if dump.exists() else {})

    def steps(self, **options):
        status, text, steps = self.run(**options)
        if status != 0:
            raise AssertionError(text)
        if "whitelist" in text:
            raise AssertionError("the host put the model together by itself:\n" + text)
        return steps


def read_dump(text):
    steps = {}
    for block in text.split("ITEM: TIMESTEP\n")[1:]:
        lines = block.splitlines()
        rows = (line.split() for line in lines[8:])
        steps[int(lines[0])] = {int(row[0]): dict(zip(COLUMNS, map(float, row[1:]))) for row in rows}
    return steps


def effective(a, b):
    return a * b / (a + b)


R1, R2 = 5e-5, 3e-5
FLOOR = "fix floor all wall/gran @model@ primitive type 1 zplane 0.0"
STL = """solid plate
facet normal 0 0 1
outer loop
vertex 0 0 0
vertex 0.002 0 0
vertex 0 0.002 0
endloop
endfacet
facet normal 0 0 1
outer loop
vertex 0.002 0 0
vertex 0.002 0.002 0
vertex 0 0.002 0
endloop
endfacet
endsolid plate
"""


def hertz(overlap, radius):
    return 4 / 3 * MODULUS * math.sqrt(radius) * max(overlap, 0.0) ** 1.5


class Forces(unittest.TestCase):
    """Attractions [N] in a case's last step: of each pair of pairs_at(), or of each grain to the floor."""

    def attractions(self, case, **options):
        steps = case.steps(**options)
        last = steps[max(steps)]
        if "wall/gran" in case.text:
            return [-last[n]["fz"] for n in sorted(last)]
        for n in range(1, len(last), 2):  # action and reaction, to the last bit
            self.assertEqual(last[n]["fx"], -last[n + 1]["fx"])
        return [last[n]["fx"] for n in range(1, len(last), 2)]

    def near(self, measured, expected, share=1e-3):
        for m, e in zip(measured, expected, strict=True):
            self.assertLessEqual(abs(m - e), share * abs(e), f"{m} is not {e}")

    def on_mesh(self, case):
        with tempfile.TemporaryDirectory(prefix="gasgrain-test-") as folder:
            (Path(folder) / "plate.stl").write_text(STL)
            return self.attractions(case, folder=Path(folder))


def gap_of(row):
    """Of the first two grains along x, or of the only one and the floor."""
    return row[2]["x"] - row[1]["x"] - 2 * R1 if len(row) > 1 else row[1]["z"] - R1


def attraction_of(row):
    return row[1]["fx"] if len(row) > 1 else -row[1]["fz"]


def equal_pair(gap):
    return [(0.001 - R1 - gap / 2, 0.0011, 0.0009, 2 * R1, 1), (0.001 + R1 + gap / 2, 0.0011, 0.0009, 2 * R1, 1)]


def driven(*phases):
    """Grains that keep their speeds: phases of (speed along x of each, or of one along z, steps)."""
    lines = ["group first id 1", "group second id 2", "fix move all nve/noforce"]
    for speed, steps in phases:
        if isinstance(speed, tuple):
            lines.append(f"velocity all set 0 0 {speed[0]!r}")
        else:
            lines += [f"velocity first set {-speed / 2!r} 0 0", f"velocity second set {speed / 2!r} 0 0"]
        lines.append(f"run {steps}")
    return "\n".join(lines)


def jkr_force(work, radius, overlap):
    """Repulsion by bisection for the contact's radius a, which is unique beyond the snap's."""
    snap = (math.pi * work * radius**2 / (8 * MODULUS)) ** (1 / 3)
    low, high = snap, radius
    for _ in range(200):
        a = (low + high) / 2
        if a**2 / radius - math.sqrt(2 * math.pi * work * a / MODULUS) < overlap:
            low = a
        else:
            high = a
    return 4 * MODULUS * a**3 / (3 * radius) - math.sqrt(8 * math.pi * work * MODULUS * a**3)


def jkr_snap_gap(work, radius):
    return 3 * (math.pi * work * radius**2 / (8 * MODULUS)) ** (2 / 3) / radius
