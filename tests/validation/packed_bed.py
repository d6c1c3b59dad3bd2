#!/usr/bin/python3
"""Pressure drop over a fixed bed of spheres against Ergun's equation, through both programs."""

import csv
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

BIN = Path(sys.argv.pop(1) if len(sys.argv) > 1 else "build").resolve()
SCENE = Path(__file__).resolve().parents[2] / "inputs" / "packed_bed"

# Of inputs/packed_bed
DIAMETER = 2.5e-3           # m
VELOCITY = 0.5              # m/s, superficial
DENSITY = 1.2               # kg/m3
VISCOSITY = 18.27e-6        # Pa s
VOID_FRACTION = 1 - 3.141592653589793 / 6  # simple cubic lattice of touching spheres
PROBES = (0.0325, 0.0525)   # m, inside of the bed


def ergun(velocity):
    """Pressure gradient [Pa/m], S. Ergun, Chem. Eng. Prog. 48 (1952) 89, superficial velocity."""
    solids = 1 - VOID_FRACTION
    return (150 * solids**2 / VOID_FRACTION**3 * VISCOSITY * velocity / DIAMETER**2
            + 1.75 * solids / VOID_FRACTION**3 * DENSITY * velocity**2 / DIAMETER)


class PackedBed(unittest.TestCase):
    def test_pressure_drop_is_ergun_s(self):
        out = Path(tempfile.mkdtemp(prefix="gasgrain-packed-"))
        try:
            done = subprocess.run(
                [BIN / "gasgrain", "run", SCENE, "--out", out, "--dem-ranks", "2", "--no-plots"],
                capture_output=True, text=True, timeout=120)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            with open(out / "history.csv", encoding="ascii") as file:
                last = list(csv.DictReader(file))[-1]
        finally:
            shutil.rmtree(out)
        drop = float(last[f"p_{PROBES[0]:g}m_Pa"]) - float(last[f"p_{PROBES[1]:g}m_Pa"])
        expected = ergun(VELOCITY) * (PROBES[1] - PROBES[0])
        # The gas's weight between the probes is part of the drop.
        weight = DENSITY * 9.81 * (PROBES[1] - PROBES[0])
        print(f"{drop - weight:.3f} Pa, Ergun {expected:.3f} Pa, "
              f"error {(drop - weight) / expected - 1:+.2e}")
        self.assertAlmostEqual(drop - weight, expected, delta=0.01 * expected)
        self.assertAlmostEqual(float(last["mass_outflow_kg_s"]), float(last["mass_inflow_kg_s"]),
                               delta=1e-6 * float(last["mass_inflow_kg_s"]))
        self.assertLess(float(last["ledger_residual"]), 1e-8)


if __name__ == "__main__":
    unittest.main(verbosity=2)
