#!/usr/bin/python3
"""The scene channel_injection, short and with few parcels: what it must hold whatever the statistics."""

import csv
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

BUILD = Path(sys.argv.pop(1) if len(sys.argv) > 1 else "build").resolve()
SCENE = Path(__file__).resolve().parents[2] / "inputs" / "channel_injection"

FED, JET = 1.25, 5.0  # m/s
START, END = 0.29, 0.35  # s, of the injection
FRONT = JET * (END - START)  # m, no droplet can be farther
FILLED = FED * END - 0.05  # m, the feed has come so far; its head is in motion
SETTINGS = {"per_cell": 2, "jet_parcels": 4000, "dt": 1e-3, "start": START, "means": 0.33}


def columns_of(file):
    with open(file, newline="") as stream:
        rows = list(csv.DictReader(stream))
    return {name: [float(row[name]) for row in rows] for name in rows[0]}


class ChannelScene(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        out = Path(cls.folder.name) / "results"
        words = [str(BUILD / "gasgrain"), "run", str(SCENE), "--dem-ranks", "1", "--no-plots",
                 "--time", str(END), "--out", str(out)]
        for name, value in SETTINGS.items():
            words += ["--set", f"{name}={value}"]
        done = subprocess.run(words, capture_output=True, text=True, timeout=120)
        cls.text = done.stdout + done.stderr
        if done.returncode != 0:
            raise RuntimeError(cls.text)
        cls.log = (out / "run.log").read_text()
        cls.history = columns_of(out / "history.csv")
        cls.line = columns_of(out / "centre_line.csv")

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def cells(self, of):
        return [n for n, x in enumerate(self.line["position_m"]) if of(x)]

    def test_masses_of_solid_and_liquid_add_up(self):
        found = re.findall(r"balance of masses (\S+)", self.text + self.log)
        self.assertTrue(found)
        # Sums of some thousand parcels, each good to round-off.
        self.assertLess(abs(float(found[-1])), 1e-12)

    def test_momentum_of_gas_and_parcels_adds_up(self):
        self.assertGreater(self.history["impulse_exchanged_Ns"][-1], 0.0)
        self.assertLess(max(abs(r) for r in self.history["ledger_residual"]), 1e-12)

    def test_equilibrium_velocity_lies_between_those_of_feed_and_jet(self):
        for n in self.cells(lambda x: x < FILLED):
            velocity = self.line["equilibrium_velocity_m_s"][n]
            # The gas, slowed or pushed by the jet, moves the feed by some percent.
            self.assertGreater(velocity, 0.9 * FED)
            self.assertLess(velocity, JET)
        nozzle = self.line["equilibrium_velocity_m_s"][0]
        # Half of the mass in the first cell, roughly, is the jet's.
        self.assertGreater(nozzle, 1.2 * FED)

    def test_collision_time_falls_towards_the_nozzle(self):
        tau = self.line["collision_time_s"]
        ahead = min(tau[n] for n in self.cells(lambda x: FRONT + 0.015 < x < FILLED))
        # Two orders of magnitude in the whole run; one here, where parcels are few.
        self.assertLess(tau[0], 0.1 * ahead)
        self.assertLess(tau[0], tau[6])

    def test_liquid_is_between_the_nozzle_and_the_front_of_the_jet(self):
        liquid, eta = self.line["liquid_velocity_m_s"], self.line["eta"]
        # The front's last cell is whole.
        for n in self.cells(lambda x: FRONT + 0.015 < x < FILLED):
            self.assertGreater(self.line["particle_fraction"][n], 0.0)
            self.assertEqual((liquid[n], eta[n]), (0.0, 0.0))
        self.assertGreater(liquid[0], 0.5 * JET)
        self.assertGreater(eta[0], 0.0)


if __name__ == "__main__":
    unittest.main()
