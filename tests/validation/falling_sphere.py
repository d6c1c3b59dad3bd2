#!/usr/bin/python3
"""One sphere falls through gas at rest, two-way coupled, and reaches its terminal velocity."""

import csv
import math
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

BIN = Path(sys.argv.pop(1) if len(sys.argv) > 1 else "build").resolve()

GRAVITY = 9.81
DENSITY = 1.2             # kg/m3, of the gas
VISCOSITY = 18.27e-6      # Pa s
GRAIN = 2500.0            # kg/m3
DIAMETER = 1.0e-4         # m
STEP = 2e-5               # s
STEPS = 20000

# A cell is 20 diameters wide: its mean velocity is that of gas far from the sphere, to 0.1 %.
SCRIPT = f"""\
atom_style granular
atom_modify map array
units si
boundary f f f
newton off
communicate single vel yes
region box block 0 0.02 0 0.02 0 0.4 units box
create_box 1 box
create_atoms 1 single 0.0101 0.0097 0.38 units box
set group all diameter {DIAMETER} density {GRAIN:g}
neighbor 0.001 bin
neigh_modify delay 0
timestep {STEP}
fix youngs all property/global youngsModulus peratomtype 5e6
fix poisson all property/global poissonsRatio peratomtype 0.17
fix restitution all property/global coefficientRestitution peratomtypepair 1 0.9
fix friction all property/global coefficientFriction peratomtypepair 1 0.1
pair_style gran model hertz tangential history
pair_coeff * *
fix weight all gravity {GRAVITY} vector 0 0 -1
fix motion all nve/sphere
fix gas all couple/gas every 50 output @out@ drag @law@ pressure_gradient
compute speed all reduce ave vz
thermo_style custom step atoms c_speed
thermo 1000
thermo_modify lost error norm no
run {STEPS}
"""
GAS = """\
[grid]
lo = [0.0, 0.0, 0.0]
hi = [0.02, 0.02, 0.4]
cells = [10, 10, 200]
[boundary]
z_hi = "outlet"
"""


def terminal_velocity(drag_coefficient):
    """Root of drag = weight less buoyancy, by bisection."""
    weight = math.pi / 6 * DIAMETER**3 * (GRAIN - DENSITY) * GRAVITY

    def surplus(v):
        re = DENSITY * v * DIAMETER / VISCOSITY
        return drag_coefficient(re) * math.pi / 8 * DENSITY * DIAMETER**2 * v**2 - weight

    low, high = 1e-6, 100.0
    for _ in range(200):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if surplus(middle) > 0 else (middle, high)
    return low


# Of an isolated sphere: Schiller & Naumann (1935), and Dallavalle (1948).
LAWS = {"ergun_wen_yu": lambda re: 24 / re * (1 + 0.15 * re**0.687),
        "di_felice": lambda re: (0.63 + 4.8 / math.sqrt(re))**2}


class FallingSphere(unittest.TestCase):
    def test_terminal_velocity(self):
        for law, coefficient in LAWS.items():
            with self.subTest(law=law):
                folder = Path(tempfile.mkdtemp(prefix="gasgrain-fall-"))
                try:
                    (folder / "in.liggghts").write_text(
                        SCRIPT.replace("@law@", law).replace("@out@", str(folder)))
                    (folder / "gas.toml").write_text(GAS)
                    done = subprocess.run(
                        ["mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none",
                         "-np", "1", BIN / "gasgrain-liggghts", "-in", "in.liggghts", ":",
                         "-np", "1", BIN / "gasgrain-gas", "gas.toml", "--out", str(folder)],
                        cwd=folder, capture_output=True, text=True, timeout=200)
                    self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
                    with open(folder / "history.csv", encoding="ascii") as file:
                        residual = float(list(csv.DictReader(file))[-1]["ledger_residual"])
                finally:
                    shutil.rmtree(folder)
                rows = [line.split() for line in done.stdout.splitlines()]
                speed = [-float(row[2]) for row in rows
                         if len(row) == 3 and row[0].isdigit() and row[1] == "1"][-1]
                expected = terminal_velocity(coefficient)
                print(f"{law}: {speed:.5f} m/s, analytic {expected:.5f} m/s, "
                      f"error {speed / expected - 1:+.2e}")
                self.assertAlmostEqual(speed, expected, delta=0.01 * expected)
                self.assertLess(residual, 1e-8)


if __name__ == "__main__":
    unittest.main(verbosity=2)
