#!/usr/bin/python3
"""Pressure drop over a fixed bed of spheres against Ergun's equation, through both programs."""

import csv
import math
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
VOID_FRACTION = 1 - math.pi / 6  # simple cubic lattice of touching spheres
PROBES = (0.0325, 0.0525)   # m, inside of the bed


def ergun(velocity, void_fraction=VOID_FRACTION):
    """Pressure gradient [Pa/m], S. Ergun, Chem. Eng. Prog. 48 (1952) 89, superficial velocity."""
    solids = 1 - void_fraction
    return (150 * solids**2 / void_fraction**3 * VISCOSITY * velocity / DIAMETER**2
            + 1.75 * solids / void_fraction**3 * DENSITY * velocity**2 / DIAMETER)


def changed(text, changes):
    for old, new in changes:
        assert old in text, old
        text = text.replace(old, new)
    return text


class PackedBed(unittest.TestCase):
    def expect_ergun(self, in_gas=(), in_script=(), void_fraction=VOID_FRACTION, dem_ranks=2):
        folder = Path(tempfile.mkdtemp(prefix="gasgrain-packed-"))
        try:
            scene = folder / "scene"
            scene.mkdir()
            for name, changes in (("gas.toml", in_gas), ("in.liggghts", in_script)):
                text = (SCENE / name).read_text(encoding="utf-8")
                (scene / name).write_text(changed(text, changes), encoding="utf-8")
            done = subprocess.run(
                [BIN / "gasgrain", "run", scene, "--out", folder / "out", "--dem-ranks",
                 str(dem_ranks), "--no-plots"], capture_output=True, text=True, timeout=120)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            with open(folder / "out" / "history.csv", encoding="ascii") as file:
                last = list(csv.DictReader(file))[-1]
        finally:
            shutil.rmtree(folder)
        drop = float(last[f"p_{PROBES[0]:g}m_Pa"]) - float(last[f"p_{PROBES[1]:g}m_Pa"])
        expected = ergun(VELOCITY, void_fraction) * (PROBES[1] - PROBES[0])
        # The gas's weight between the probes is part of the drop.
        weight = DENSITY * 9.81 * (PROBES[1] - PROBES[0])
        print(f"{drop - weight:.3f} Pa, Ergun {expected:.3f} Pa, "
              f"error {(drop - weight) / expected - 1:+.2e}")
        self.assertAlmostEqual(drop - weight, expected, delta=0.001 * expected)
        self.assertLess(float(last["mass_imbalance"]), 1e-10)
        self.assertLess(float(last["ledger_residual"]), 1e-8)

    def test_pressure_drop_is_ergun_s(self):
        self.expect_ergun()

    def test_pressure_drop_in_model_b_is_ergun_s(self):
        self.expect_ergun(in_gas=[("[gas]\n", "[gas]\nmodel = \"B\"\n")])

    def test_pressure_drop_of_an_ideal_gas_is_ergun_s(self):
        # 90 Pa in 1e5 thin it by less than the tolerance; a molar mass that makes the density 1.2.
        molar_mass = DENSITY * 8.31446261815324 * 293.15 / 101325
        self.expect_ergun(in_gas=[("density = 1.2 ",
                                   f'law = "ideal_gas"\nmolar_mass = {molar_mass!r} ')])

    def test_pressure_drop_over_a_plane_of_spheres_is_ergun_s_in_space(self):
        # Spheres on a square lattice, for which the void fraction in space is that of the cells.
        depth = 2 * 3**-0.75
        self.expect_ergun(
            in_gas=[("hi = [0.02, 0.02, 0.1]\n", "hi = [0.02, 0.0025, 0.1]\nplane_of_spheres = 0.0025\n"),
                    ("cells = [4, 4, 20] ", "cells = [4, 1, 20] ")],
            in_script=[("block 0 0.02 0 0.02", "block 0 0.02 0 0.0025")],
            void_fraction=1 - math.pi / 6 / depth, dem_ranks=1)


if __name__ == "__main__":
    unittest.main(verbosity=2)
