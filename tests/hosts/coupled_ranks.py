#!/usr/bin/python3
"""The same bed on any number of ranks; the same input twice gives the same output."""

import unittest

from coupled_launch import Scene

# 0.1 s: the bed has been blown up and falls back.
STEPS = 5000


def run(dem_ranks, gas_ranks):
    with Scene(steps=STEPS, processors="processors * 1 1") as scene:
        status, text, _ = scene.run(dem_ranks=dem_ranks, gas_ranks=gas_ranks)
        assert status == 0, text
        return (scene.out / "history.csv").read_text(), scene.history()


class Ranks(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.text, cls.history = run(1, 1)

    def test_the_bed_moves(self):
        # Without this the comparisons below would be of a bed at rest.
        self.assertGreater(self.history[-1]["bed_height_m"], 1.1 * self.history[0]["bed_height_m"])

    def test_the_ledger_is_closed(self):
        for row in self.history:
            self.assertLess(row["ledger_residual"], 1e-8)

    def test_twice_the_same_is_bitwise_the_same(self):
        text, _ = run(1, 1)
        self.assertEqual(text, self.text)

    def test_ranks_do_not_change_the_bed(self):
        for dem_ranks, gas_ranks in ((2, 1), (1, 2), (2, 2)):
            with self.subTest(dem_ranks=dem_ranks, gas_ranks=gas_ranks):
                _, history = run(dem_ranks, gas_ranks)
                for ours, theirs in zip(self.history, history):
                    # Sums in another order differ by round-off, which collisions then amplify.
                    self.assertAlmostEqual(ours["bed_height_m"], theirs["bed_height_m"],
                                           delta=0.01 * ours["bed_height_m"])
                self.assertLess(history[-1]["ledger_residual"], 1e-8)
                # Nobody was removed: a record lost on the way between ranks would show here.
                for axis in "xyz":
                    self.assertLess(abs(history[-1][f"impulse_left_{axis}_Ns"]),
                                    1e-12 * history[-1]["impulse_exchanged_Ns"])
                self.assertEqual(len(history), len(self.history))
                # Before the first contacts have acted nothing but round-off may differ.
                for ours, theirs in zip(self.history[:5], history[:5]):
                    self.assertAlmostEqual(ours["kinetic_energy_J"], theirs["kinetic_energy_J"],
                                           delta=1e-8 * max(ours["kinetic_energy_J"], 1e-9))


if __name__ == "__main__":
    unittest.main(verbosity=2)
