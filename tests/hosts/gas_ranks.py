#!/usr/bin/python3
"""The gas program alone runs on every number of ranks that the grid allows, and on no more."""

import unittest

from gas_alone import Run


class Ranks(unittest.TestCase):
    CELLS = "[4, 3, 4]"  # two ranks along x and z, none to cut y for

    def test_as_many_ranks_as_the_grid_allows(self):
        for ranks in (1, 2, 4):
            with self.subTest(ranks=ranks), Run() as run:
                status, text, _ = run.gas(ranks=ranks, cells=self.CELLS)
                self.assertEqual(status, 0, text)
                self.assertTrue((run.out / "gas.checkpoint.h5").exists())

    def test_one_rank_more_is_an_error_that_says_how_many(self):
        with Run() as run:
            status, text, seconds = run.gas(ranks=5, cells=self.CELLS)
        self.assertNotEqual(status, 0, text)
        self.assertLess(seconds, 15, text)
        self.assertEqual(text.count("gasgrain-gas: error:"), 1, text)
        self.assertIn("5 gas ranks cannot share a grid of 4 x 3 x 4 cells with at least 2 cells a "
                      "side: use 4.", text)

    def test_a_check_tells_the_same_before_a_launch(self):
        with Run() as run:
            status, text, _ = run.gas("--check", "--ranks", "5", cells=self.CELLS)
            self.assertNotEqual(status, 0, text)
            self.assertIn("use 4.", text)
            status, text, _ = run.gas("--check", "--ranks", "4", cells=self.CELLS)
            self.assertEqual(status, 0, text)


if __name__ == "__main__":
    unittest.main(verbosity=2)
