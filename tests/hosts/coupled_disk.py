#!/usr/bin/python3
"""A checkpoint of the gas that cannot be written ends both programs of a launch."""

import unittest

from coupled_launch import Scene


class Disk(unittest.TestCase):
    def test_both_sides_end_and_the_checkpoint_before_stays(self):
        for gas_ranks in (1, 2):
            with self.subTest(gas_ranks=gas_ranks), Scene(
                    steps=10000, extra="restart 100 @out@/checkpoint/dem.*.restart") as scene:
                folder = scene.out / "checkpoint"
                in_the_way = folder / "gas.200.h5.new"
                in_the_way.mkdir(parents=True)
                status, text, seconds = scene.run(timeout=60, gas_ranks=gas_ranks)
                self.assertNotEqual(status, 0, text)
                self.assertLess(seconds, 20, text)
                messages = [line for line in text.splitlines() if "gasgrain-gas: error:" in line]
                self.assertEqual(len(messages), 1, text)
                self.assertIn(f"{in_the_way}: cannot be created: Is a directory.", messages[0])
                self.assertTrue((folder / "gas.100.h5").exists())
                self.assertFalse((folder / "gas.200.h5").exists())


if __name__ == "__main__":
    unittest.main(verbosity=2)
