#!/usr/bin/python3
"""A run of the gas alone that is asked to stop ends its interval, leaves a checkpoint, and goes on from
it as if nothing had happened; asked twice it ends at once."""

import signal
import time
import unittest

from gas_alone import Run

ENDLESS = {"end": 1000, "every": 0.01}
SOON = 20.0  # s; to start and to stop, on a machine that does other things too


class Stop(unittest.TestCase):
    def wait_for_lines(self, run, process, count):
        history = run.out / "history.csv"
        patience = time.monotonic() + SOON
        while time.monotonic() < patience and process.poll() is None:
            if history.exists() and history.read_text().count("\n") >= count:
                return
            time.sleep(0.02)
        process.kill()
        self.fail(f"no run: {process.communicate()[0]}")

    def stopped(self, run, number, ranks):
        process = run.start(ranks=ranks, **ENDLESS)
        self.wait_for_lines(run, process, 3)
        process.send_signal(number)
        text, _ = process.communicate(timeout=SOON)
        return process.returncode, text

    def assert_stopped_with_checkpoint(self, run, text):
        checkpoint = run.out / "gas.checkpoint.h5"
        self.assertEqual(text.count("stopping: ending the interval"), 1, text)
        self.assertIn(f" of 1000 s: go on with --restart {checkpoint}", text)
        self.assertTrue((run.out / "ledger.json").exists())

    def test_a_run_that_was_stopped_goes_on_as_the_one_that_was_not(self):
        for ranks in (1, 2):
            with self.subTest(ranks=ranks), Run() as run:
                status, text = self.stopped(run, signal.SIGUSR1, ranks)
                self.assertEqual(status, 0, text)
                self.assert_stopped_with_checkpoint(run, text)
                lines = len((run.out / "history.csv").read_text().splitlines())
                end = 0.01 * (lines + 2)
                status, text, _ = run.gas("--restart", str(run.out / "gas.checkpoint.h5"),
                                          ranks=ranks, end=end, every=0.01)
                self.assertEqual(status, 0, text)
                parts = (run.out / "history.csv").read_bytes()
                run.out = run.folder / "whole"
                status, text, _ = run.gas(ranks=ranks, end=end, every=0.01)
                self.assertEqual(status, 0, text)
                self.assertEqual(parts, (run.out / "history.csv").read_bytes())

    def test_ctrl_c_and_sigterm_leave_a_checkpoint_too_and_say_so_in_the_status(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            with self.subTest(number), Run() as run:
                status, text = self.stopped(run, number, ranks=0)
                self.assertEqual(status, 130, text)
                self.assert_stopped_with_checkpoint(run, text)

    def test_a_second_signal_ends_the_run_at_once(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGUSR1):
            with self.subTest(number), Run() as run:
                process = run.start(ranks=0, end=1000, every=1000)
                self.wait_for_lines(run, process, 1)
                process.send_signal(number)
                time.sleep(1.0)
                self.assertIsNone(process.poll())
                process.send_signal(number)
                text, _ = process.communicate(timeout=5)
                self.assertEqual(process.returncode, -number, text)
                self.assertIn("stopping: ending the interval", text)

    def test_a_run_at_its_end_is_no_stopped_one(self):
        with Run() as run:
            process = run.start(ranks=0, end=1.0, every=1.0)
            self.wait_for_lines(run, process, 1)
            process.send_signal(signal.SIGINT)
            text, _ = process.communicate(timeout=2 * SOON)
            self.assertEqual(process.returncode, 0, text)
            self.assertNotIn("stopped at", text)


if __name__ == "__main__":
    unittest.main(verbosity=2)
