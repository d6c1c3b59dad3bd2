#!/usr/bin/python3
"""One sphere falls through gas at rest, two-way coupled, and reaches its terminal velocity.

  falling_sphere.py BUILD [--full]

whatever the size of the cells against its own. --full adds other Reynolds numbers, and what happens
when the sphere's own disturbance of the gas is not undone.
"""

import csv
import math
import shutil
import subprocess
import sys
import tempfile
import unittest
from dataclasses import dataclass
from pathlib import Path

FULL = "--full" in sys.argv
if FULL:
    sys.argv.remove("--full")
BIN = Path(sys.argv.pop(1) if len(sys.argv) > 1 else "build").resolve()

GRAVITY = 9.81
DENSITY = 1.2             # kg/m3, of the gas
VISCOSITY = 18.27e-6      # Pa s
STEPS_A_COUPLING = 50

# Of an isolated sphere: Schiller & Naumann (1935), and Dallavalle (1948).
LAWS = {"ergun_wen_yu": lambda re: 24 / re * (1 + 0.15 * re**0.687),
        "di_felice": lambda re: (0.63 + 4.8 / math.sqrt(re))**2}

SCRIPT = """\
atom_style granular
atom_modify map array
units si
boundary f f f
newton off
communicate single vel yes
region box block 0 {width} 0 {width} 0 {height} units box
create_box 1 box
create_atoms 1 single {x} {y} {z} units box
set group all diameter {diameter} density {grain}
velocity all set 0 0 {first_velocity} units box
neighbor 0.001 bin
neigh_modify delay 0
timestep {step}
fix youngs all property/global youngsModulus peratomtype 5e6
fix poisson all property/global poissonsRatio peratomtype 0.17
fix restitution all property/global coefficientRestitution peratomtypepair 1 0.9
fix friction all property/global coefficientFriction peratomtypepair 1 0.1
pair_style gran/bridge model hertz tangential history
pair_coeff * *
fix weight all gravity 9.81 vector 0 0 -1
fix motion all nve/sphere
fix gas all couple/gas every {every} output {out} {effects}
compute speed all reduce ave vz
thermo_style custom step atoms c_speed
thermo {every}
thermo_modify lost error norm no
run {steps}
"""
GAS = """\
[grid]
lo = [0.0, 0.0, 0.0]
hi = [{width}, {width}, {height}]
cells = [{wide}, {wide}, {high}]
[boundary]
z_hi = "outlet"
"""


@dataclass
class Fall:
    diameter: float        # m
    grain: float           # kg/m3
    cells_a_diameter: float
    cells_wide: int = 24
    relaxation_times: float = 5.0
    courant: float = 0.5   # cells that the sphere crosses in a coupling interval
    law: str = "ergun_wen_yu"
    words: str = ""        # that change the defaults

    @property
    def mass(self):
        return math.pi / 6 * self.diameter**3 * self.grain

    @property
    def terminal_velocity(self):
        """Root of drag = weight less buoyancy, by bisection."""
        weight = math.pi / 6 * self.diameter**3 * (self.grain - DENSITY) * GRAVITY
        low, high = 1e-9, 100.0
        for _ in range(200):
            v = 0.5 * (low + high)
            drag = LAWS[self.law](self.reynolds(v)) * math.pi / 8 * DENSITY * self.diameter**2 * v**2
            low, high = (low, v) if drag > weight else (v, high)
        return low

    def reynolds(self, v):
        return DENSITY * v * self.diameter / VISCOSITY

    def run(self):
        """(mean velocity of the last quarter, ledger residual, line on the chosen method)"""
        v = self.terminal_velocity
        cell = self.diameter / self.cells_a_diameter
        interval = self.courant * cell / v
        relaxation = v / GRAVITY  # or a little more, by buoyancy
        couplings = math.ceil(self.relaxation_times * relaxation / interval)
        high = math.ceil(couplings * self.courant) + self.cells_wide + 8
        folder = Path(tempfile.mkdtemp(prefix="gasgrain-fall-"))
        marks = {"width": self.cells_wide * cell, "height": high * cell, "wide": self.cells_wide,
                 "high": high, "x": (self.cells_wide / 2 + 0.03) * cell,
                 "y": (self.cells_wide / 2 - 0.07) * cell,
                 "z": (high - self.cells_wide / 2) * cell, "diameter": self.diameter,
                 "grain": self.grain, "first_velocity": -0.95 * v,
                 "step": interval / STEPS_A_COUPLING, "every": STEPS_A_COUPLING,
                 "steps": couplings * STEPS_A_COUPLING, "out": folder,
                 "effects": f"{self.words} drag {self.law} pressure_gradient"}
        try:
            (folder / "in.liggghts").write_text(SCRIPT.format(**marks))
            (folder / "gas.toml").write_text(GAS.format(**marks))
            done = subprocess.run(
                ["mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none",
                 "-np", "1", BIN / "gasgrain-liggghts", "-in", "in.liggghts", ":",
                 "-np", "1", BIN / "gasgrain-gas", "gas.toml", "--out", str(folder)],
                cwd=folder, capture_output=True, text=True, timeout=1000 if FULL else 250)
            assert done.returncode == 0, done.stdout + done.stderr
            with open(folder / "history.csv", encoding="ascii") as file:
                residual = float(list(csv.DictReader(file))[-1]["ledger_residual"])
        finally:
            shutil.rmtree(folder)
        lines = done.stdout.splitlines()
        speeds = [-float(row[2]) for row in map(str.split, lines)
                  if len(row) == 3 and row[0].isdigit() and row[1] == "1"]
        last = speeds[3 * len(speeds) // 4:]
        method = [line for line in lines if line.startswith("void_fraction auto")]
        return sum(last) / len(last), residual, method[0].split(",")[0] if method else ""


class FallingSphere(unittest.TestCase):
    def check(self, fall, bound=0.01):
        speed, residual, method = fall.run()
        expected = fall.terminal_velocity
        error = speed / expected - 1
        print(f"{fall.law}, d/h = {fall.cells_a_diameter:g}, Re = {fall.reynolds(expected):.3g}, "
              f"{fall.words or method}: {speed:.5f} m/s, analytic {expected:.5f} m/s, "
              f"error {100 * error:+.2f} %", flush=True)
        if bound is not None:
            self.assertLess(abs(error), bound)
        self.assertLess(residual, 1e-8)

    def test_a_sphere_much_smaller_than_a_cell(self):
        # A cell is 20 diameters wide: its mean velocity is that of gas far from the sphere.
        for law in LAWS:
            with self.subTest(law=law):
                self.check(Fall(1e-4, 2500.0, 1 / 20, cells_wide=10, law=law, courant=0.25))

    def test_a_sphere_of_any_size_against_a_cell_with_the_default_settings(self):
        # A bead of expanded polystyrene.
        for cells_a_diameter, wide in ((0.2, 12), (1, 24), (2, 32)):
            with self.subTest(cells_a_diameter=cells_a_diameter):
                self.check(Fall(1e-3, 20.0, cells_a_diameter, cells_wide=wide))

    @unittest.skipUnless(FULL, "a study of minutes")
    def test_other_reynolds_numbers_and_what_the_correction_does(self):
        for diameter, grain in ((3e-4, 20.0), (1e-3, 20.0), (1e-3, 300.0)):
            for cells_a_diameter, wide in ((0.2, 12), (1, 24), (2, 32)):
                for words in ("", "self_disturbance ignored"):
                    fast = grain > 100
                    self.check(Fall(diameter, grain, cells_a_diameter, cells_wide=wide, words=words,
                                    relaxation_times=1.2 if fast else 5.0), bound=None)


if __name__ == "__main__":
    unittest.main(verbosity=2)
