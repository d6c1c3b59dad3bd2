#!/usr/bin/python3
"""A run that was stopped goes on from its checkpoint as if nothing had happened."""

import re
import signal
import time
import unittest

from coupled_launch import Scene, differing_steps


class Restart(unittest.TestCase):
    def test_a_checkpoint_goes_on_as_if_nothing_had_happened(self):
        with Scene(steps=1000, extra="restart 500 @out@/checkpoint/dem.*.restart") as scene:
            status, text, _ = scene.run()
            self.assertEqual(status, 0, text)
            whole = scene.history()
            scene.resume(500, 1000)
            status, text, _ = scene.run(
                gas_options=("--restart", str(scene.out / "checkpoint/gas.500.h5")))
            self.assertEqual(status, 0, text)
            rows = scene.history()
        self.assertEqual(rows[: len(whole)], whole)  # appended, not overwritten
        again = rows[len(whole):]
        self.assertEqual(again[-1]["step"], 1000)
        self.assertEqual(differing_steps(whole, again, after=500), [])
        for row in again:
            self.assertLess(row["ledger_residual"], 1e-8)

    def test_states_of_two_steps_are_refused(self):
        with Scene(steps=1000, extra="restart 500 @out@/checkpoint/dem.*.restart") as scene:
            self.assertEqual(scene.run()[0], 0)
            scene.resume(1000, 1500)
            status, text, seconds = scene.run(
                gas_options=("--restart", str(scene.out / "checkpoint/gas.500.h5")))
        self.assertNotEqual(status, 0)
        self.assertLess(seconds, 10)
        self.assertIn("restart both from checkpoints of one step", text)

    def test_the_wish_to_stop_leaves_a_pair_of_checkpoints(self):
        with Scene(steps=10000000) as scene:
            process = scene.start(dem_ranks=2, gas_ranks=2)
            history = scene.out / "history.csv"
            end = time.monotonic() + 30
            while time.monotonic() < end and (
                    not history.exists() or history.read_text().count("\n") < 5):
                time.sleep(0.05)
            process.send_signal(signal.SIGUSR1)
            text, _ = process.communicate(timeout=20)
            self.assertEqual(process.returncode, 0, text)
            dem = {re.sub(r"\D", "", p.name) for p in (scene.out / "checkpoint").glob("dem.*.restart")}
            gas = {p.name.split(".")[1] for p in (scene.out / "checkpoint").glob("gas.*.h5")}
            self.assertEqual(len(dem & gas), 1, text)


if __name__ == "__main__":
    unittest.main(verbosity=2)
