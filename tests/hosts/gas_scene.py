#!/usr/bin/python3
"""The shipped scene of the gas alone: it runs, balances, goes on from its checkpoint, and can be read."""

import csv
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as xml
from pathlib import Path

BIN = Path(sys.argv.pop(1) if len(sys.argv) > 1 else "build").resolve()
SCENE = Path(__file__).resolve().parents[2] / "inputs" / "distributor" / "gas.toml"
HOLES = 9
FULL = 1.0e-4   # kg/s a hole
END = "end = 0.1 "


class Distributor(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="gasgrain-gas-"))
        self.out = self.folder / "out"

    def tearDown(self):
        shutil.rmtree(self.folder)

    def run_until(self, end, *options):
        text = SCENE.read_text(encoding="utf-8")
        self.assertIn(END, text)
        (self.folder / "gas.toml").write_text(text.replace(END, f"end = {end} "), encoding="utf-8")
        done = subprocess.run(
            ["mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none", "-np", "2",
             BIN / "gasgrain-gas", self.folder / "gas.toml", "--out", self.out, *options],
            capture_output=True, text=True, timeout=120, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def history(self):
        with open(self.out / "history.csv", encoding="ascii") as file:
            return list(csv.DictReader(file))

    def test_inflow_follows_its_table_and_balances_across_a_restart(self):
        self.run_until(0.02)
        self.run_until(0.03, "--restart", self.out / "gas.checkpoint.h5")
        rows = self.history()
        self.assertEqual([row["time_s"] for row in rows], ["0.01", "0.02", "0.03"])
        for row, share in zip(rows, (0.5, 1.0, 1.0)):
            inflow = HOLES * FULL * share
            self.assertAlmostEqual(float(row["mass_inflow_kg_s"]), inflow, delta=1e-8 * inflow)
            self.assertLess(float(row["mass_imbalance"]), 1e-10)
            self.assertEqual(row["momentum_not_converged"], "0")

    def test_xdmf_names_every_snapshot_and_its_fields(self):
        self.run_until(0.02)
        snapshots = xml.parse(self.out / "gas.xdmf").getroot().findall("./Domain/Grid/Grid")
        self.assertEqual([float(grid.find("Time").get("Value")) for grid in snapshots], [0, 0.01, 0.02])
        size = (self.out / "gas.h5").stat().st_size
        cells = 0
        for grid in snapshots:
            names = [attribute.get("Name") for attribute in grid.findall("Attribute")]
            self.assertEqual(names, ["void_fraction", "pressure", "viscosity", "velocity"])
            for item in grid.findall("Attribute/DataItem"):
                numbers = [int(n) for n in item.get("Dimensions").split()]
                self.assertEqual(numbers[:3], [60, 18, 18])
                cells += 18 * 18 * 60 * (numbers[3] if len(numbers) > 3 else 1)
        self.assertGreater(size, 8 * cells)


if __name__ == "__main__":
    unittest.main(verbosity=2)
