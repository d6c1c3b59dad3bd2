#!/usr/bin/python3
"""A run of the gas alone that was cut and goes on is the run that was not, byte by byte; one that does
not fit what is there is refused."""

import shutil
import subprocess
import time
import unittest

from gas_alone import BIN, Run

# Everything that a checkpoint must keep: an iterating pressure solver, a compressible gas, turbulence.
CHOICES = """
[gas]
law = "ideal_gas"
[solver]
pressure = "hypre"
[turbulence]
model = "k_epsilon"
"""


class Restart(unittest.TestCase):
    def run_ok(self, run, *options, **choices):
        status, text, _ = run.gas(*options, **choices)
        self.assertEqual(status, 0, text)
        return text

    def test_half_a_run_and_the_rest_are_the_whole(self):
        for more in ("", CHOICES):
            with self.subTest(choices=more), Run() as run:
                self.run_ok(run, end=0.04, every=0.01, more=more)
                whole = (run.out / "history.csv").read_bytes()
                shutil.rmtree(run.out)
                self.run_ok(run, end=0.02, every=0.01, more=more)
                self.run_ok(run, "--restart", str(run.out / "gas.checkpoint.h5"), end=0.04,
                            every=0.01, more=more)
                self.assertEqual((run.out / "history.csv").read_bytes(), whole)

    def test_snapshots_begin_where_the_run_does_and_no_time_comes_twice(self):
        for ranks in (1, 2):
            with self.subTest(ranks=ranks), Run() as run:
                self.run_ok(run, ranks=ranks, end=0.02, every=0.01)
                restart = ("--restart", str(run.out / "gas.checkpoint.h5"))
                self.run_ok(run, *restart, ranks=ranks, end=0.03, every=0.01)
                self.assertEqual(run.snapshot_times(), [0, 0.01, 0.02, 0.03])
                run.out = run.folder / "new"
                self.run_ok(run, *restart, ranks=ranks, end=0.04, every=0.01)
                self.assertEqual(run.snapshot_times(), [0.03, 0.04])

    def test_a_checkpoint_of_other_choices_is_refused_by_name(self):
        with Run() as run:
            self.run_ok(run, end=0.01, more=CHOICES)
            status, text, _ = run.gas("--restart", str(run.out / "gas.checkpoint.h5"), end=0.02)
            self.assertNotEqual(status, 0, text)
            self.assertIn("another choice of [gas] law, [turbulence] model", text)

    def test_a_folder_in_place_of_a_checkpoint_is_told_in_one_message(self):
        for ranks in (1, 2):
            with self.subTest(ranks=ranks), Run() as run:
                self.run_ok(run, end=0.01)
                status, text, _ = run.gas("--restart", str(run.out), ranks=ranks)
                self.assertNotEqual(status, 0, text)
                self.assertNotIn("Is a directory", text)
                messages = [line for line in text.splitlines() if "error:" in line]
                self.assertEqual(messages, [
                    f"gasgrain-gas: error: {run.out} is a folder: name the checkpoint in it, such as "
                    f"{run.out}/gas.checkpoint.h5."])

    def test_snapshots_of_another_grid_are_not_mixed(self):
        with Run() as run, Run() as other:
            self.run_ok(run, end=0.01, every=0.01)
            self.run_ok(other, end=0.01, every=0.01, cells="[6, 6, 12]")
            shutil.copy(other.out / "gas.h5", run.out / "gas.h5")
            status, text, _ = run.gas("--restart", str(run.out / "gas.checkpoint.h5"), end=0.02,
                                      every=0.01)
            self.assertNotEqual(status, 0, text)
            self.assertIn("snapshots of another grid", text)

    def test_a_killed_run_leaves_its_last_checkpoint(self):
        with Run() as run:
            self.run_ok(run, "--check", end=1000, every=0.01, more="checkpoint_every = 0.02\n")
            process = subprocess.Popen([BIN / "gasgrain-gas", run.folder / "gas.toml", "--out", run.out],
                                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            checkpoint = run.out / "gas.checkpoint.h5"
            patience = time.monotonic() + 30
            while not checkpoint.exists() and time.monotonic() < patience:
                time.sleep(0.05)
            process.kill()
            process.wait()
            self.assertTrue(checkpoint.exists())
            text = self.run_ok(run, "--restart", str(checkpoint), end=0.01, every=0.01)
            self.assertIn("nothing to do: the gas is at 0.0", text)


if __name__ == "__main__":
    unittest.main(verbosity=2)
