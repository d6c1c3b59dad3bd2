#!/usr/bin/python3
"""The shipped wet bed, shortly, dry and wet: its liquid and momentum stay, its grains hold together."""

import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

BUILD = Path(sys.argv.pop(1)).resolve() if len(sys.argv) > 1 else Path("build").resolve()
SOURCE = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(SOURCE / "tools"))

import report_clusters  # noqa: E402
from report_wet import WetRun  # noqa: E402

CLOSED = 1e-12  # of all liquid
ROUND_OFF = 1e-10  # of the impulse exchanged, as in the other coupled tests
SETTLED = 0.10  # s: the ramp of the inflow ends, the first bubble rises


class WetBed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp(prefix="gasgrain-wet-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder, ignore_errors=True)
        cls.runs = {}
        for content in ("0", "0.001"):
            out = cls.folder / content
            done = subprocess.run(
                [BUILD / "gasgrain", "run", SOURCE / "inputs" / "wet_fluidised_bed", "--out", out,
                 "--time", "0.16", "--var", "packing", "0.08", "--var", "content", content,
                 "--dem-ranks", "2", "--no-plots"],
                capture_output=True, text=True, timeout=280, check=False)
            if done.returncode != 0:
                raise AssertionError(done.stdout[-3000:] + done.stderr[-3000:])
            cls.runs[content] = WetRun(out)
        cls.dry, cls.wet = cls.runs["0"], cls.runs["0.001"]

    def test_no_liquid_is_lost_and_none_is_in_the_dry_bed(self):
        for row in self.wet.ledger:
            self.assertLess(abs(row["residual"]), CLOSED)
        self.assertEqual(self.dry.content, 0.0)
        self.assertAlmostEqual(self.wet.content, 0.001, delta=1e-12)
        self.assertEqual(self.wet.count, 5000)

    def test_the_gas_gives_what_the_grains_take(self):
        for run in self.runs.values():
            self.assertLess(max(abs(run.history["ledger_residual"])), ROUND_OFF)

    def test_the_grains_momentum_is_that_of_all_forces(self):
        for run in self.runs.values():
            # From the second line on: half of the step before the first one was damped by `fix calm`.
            history = {name: values[1:] for name, values in run.history.items()}
            for axis in "xyz":
                def change(name):
                    return history[name] - history[name][0]
                left_over = change(f"momentum_{axis}_Ns") - sum(
                    change(f"impulse_{kind}_{axis}_Ns") for kind in ("taken", "free", "host"))
                self.assertLess(max(abs(left_over)), ROUND_OFF * history["impulse_exchanged_Ns"][-1])

    def test_the_bridges_among_the_pairs_hold_what_the_ledger_says(self):
        in_ledger = {round(row["step"]): row["bridges"] for row in self.wet.ledger}
        holding = self.wet.holding
        files = report_clusters.pair_files(self.wet.folder)
        self.assertGreater(len(files), 10)
        for (_, file), volumes in zip(files, holding.volumes):
            liquid = in_ledger[int(file.stem.split("_")[1])]
            # the files have 6 digits of a volume
            self.assertAlmostEqual(sum(volumes), liquid, delta=1e-5 * liquid)

    def test_wet_grains_hold_together_and_move_less(self):
        dry, wet = (run.figures(SETTLED, 2500.0) for run in (self.dry, self.wet))
        self.assertEqual(dry["bridges"], 0.0)
        self.assertGreater(wet["bridges"], 2.0)
        self.assertLess(wet["parted"], 0.5 * dry["parted"])
        self.assertGreater(wet["size"], 10.0 * dry["size"])
        self.assertLess(wet["energy"], dry["energy"])


class Clusters(unittest.TestCase):
    def test_a_chain_a_pair_and_a_grain_alone_have_3_2_and_1_grains(self):
        pairs = np.array([[4, 2], [2, 0], [5, 3]])
        self.assertEqual(report_clusters.sizes_of_grains(6, pairs).tolist(), [3, 1, 3, 2, 3, 2])

    def test_a_long_chain_in_any_order_is_one_cluster(self):
        order = np.random.default_rng(3).permutation(500)
        pairs = np.column_stack([order[:-1], order[1:]])
        self.assertEqual(set(report_clusters.sizes_of_grains(500, pairs).tolist()), {500})


if __name__ == "__main__":
    unittest.main(verbosity=2)
