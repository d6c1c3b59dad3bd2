#!/usr/bin/python3
"""A shipped scene through `gasgrain run`: stopped by Control-C, gone on with --restart; and grains that
come and go while the gas flows."""

import os
import shutil
import signal
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

from coupled_launch import BIN, SOURCE, Scene

SCENE = SOURCE / "inputs" / "spouted_bed_small"


class ShippedScene(unittest.TestCase):
    def test_control_c_and_restart(self):
        out = Path(tempfile.mkdtemp(prefix="gasgrain-scene-"))
        command = [BIN / "gasgrain", "run", SCENE, "--out", out, "--no-plots", "--var", "packing",
                   "0.004", "--dem-ranks", "2"]
        try:
            process = subprocess.Popen([*command, "--time", "0.2"], text=True, start_new_session=True,
                                       stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
            history = out / "history.csv"
            end = time.monotonic() + 60
            while time.monotonic() < end and (
                    not history.exists() or history.read_text().count("\n") < 12):
                time.sleep(0.05)
            os.kill(process.pid, signal.SIGINT)
            text, _ = process.communicate(timeout=60)
            self.assertEqual(process.returncode, 130, text)
            before = history.read_text()
            done = subprocess.run([*command, "--time", "0.02", "--restart"], capture_output=True,
                                  text=True, timeout=120, check=False)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            self.assertTrue(history.read_text().startswith(before))
        finally:
            shutil.rmtree(out)


class ComingAndGoing(unittest.TestCase):
    def test_inserted_and_removed_grains_keep_the_ledger_closed(self):
        # Those above 5 cm are taken away half-way, between two couplings.
        extra = """\
fix sphere all particletemplate/sphere 15485863 atom_type 1 density constant 2500 radius constant 0.00125
fix sizes all particledistribution/discrete 15485867 1 sphere 1.0
region above block 0.001 0.021 0.001 0.021 0.08 0.10 units box
fix rain all insert/pack seed 32452843 distributiontemplate sizes maxattempt 100 insert_every 110 &
    overlapcheck yes all_in yes vel constant 0. 0. -0.5 region above particles_in_region 20
run 512
region high block INF INF INF INF 0.05 INF units box
group gone region high
delete_atoms group gone compress no"""
        with Scene(extra=extra, steps=500, processors="processors * 1 1") as scene:
            status, text, _ = scene.run(dem_ranks=2)
            self.assertEqual(status, 0, text)
            rows = scene.history()
        counts = [row["particles"] for row in rows]
        self.assertGreater(max(counts), counts[0])
        self.assertLess(counts[-1], max(counts))
        self.assertGreater(sum(abs(rows[-1][f"impulse_left_{axis}_Ns"]) for axis in "xyz"), 0.0)
        for row in rows:
            self.assertLess(row["ledger_residual"], 1e-10)


if __name__ == "__main__":
    unittest.main(verbosity=2)
