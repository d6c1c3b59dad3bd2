#!/usr/bin/python3
"""Coupling intervals ten and a hundred times too long: the run stays bounded, and a warning names the
interval to use, which then gives none.

Two beds, one for each limit of coupling/interval_check.h: a spout, whose grains cross cells, and a bed
that settles in a gas a thousand times as viscous as air, whose drag ties gas and grains together. In
the second the interval that the warning is about is the negative control: it makes the bed swing, and
the one that is named does not.
"""

import re
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "hosts"))

from coupled_launch import COUPLE, Scene  # noqa: E402  (after the path)

# The gas leaves at the top, the grains do not.
LID = "fix z_hi all wall/gran model hertz tangential history primitive type 1 zplane 0.11\nfix motion"


def run(every, steps, jet, viscosity=None):
    """(warnings of the interval, history) of a run with a lid."""
    couple = COUPLE.replace("every 25", f"every {every}")
    with Scene(couple=couple, steps=steps, jet=jet) as scene:
        script = scene.folder / "in.liggghts"
        script.write_text(script.read_text().replace("fix motion", LID))
        if viscosity:
            gas = scene.folder / "gas.toml"
            gas.write_text(gas.read_text().replace("[time]", f"[gas]\nviscosity = {viscosity}\n[time]"))
        status, text, _ = scene.run(timeout=120)
        if status != 0:
            raise AssertionError(f"every {every}: {text}")
        rows = scene.history()
    told = [line for line in text.splitlines() if line.startswith("couple/gas: warning: 'every")]
    return told, rows


def greatest(rows, name):
    return max(row[name] for row in rows)


def advised(warning):
    return int(re.search(r"Write 'every (\d+)'\.$", warning)[1])


class CouplingInterval(unittest.TestCase):
    STEPS = 24000  # 0.48 s

    def test_a_spout_is_bounded_and_told_the_interval_that_does(self):
        told, good = run(100, self.STEPS, jet=45)
        self.assertEqual(told, [])
        energy = greatest(good, "kinetic_energy_J")
        for every in (1200, 12000):
            with self.subTest(every=every):
                told, rows = run(every, self.STEPS, jet=45)
                self.assertEqual(len(told), 2, told)  # at its first occurrence, and at the end
                self.assertRegex(told[0], rf"'every {every}' is too long at step \d+, t = [\d.]+ s: "
                                          r"in [\d.]+ s (the fastest grain crosses|gas and grains)|in intervals")
                self.assertRegex(told[1], rf"'every {every}' was too long at \d+ of \d+ couplings\.")
                self.assertEqual(sum(row["interval_too_long"] for row in rows),
                                 int(re.search(r"at (\d+) of", told[1])[1]))
                # What pushes a grain is held for as long, and throws it higher than it should; drag
                # that is implicit in its velocity makes it no faster than the gas.
                self.assertEqual(rows[-1]["particles"], 768)
                self.assertLess(greatest(rows, "bed_height_m"), 0.11)
                self.assertLess(greatest(rows, "kinetic_energy_J"), 20 * energy)
                for row in rows:
                    self.assertLess(row["ledger_residual"], 1e-8)
                # Two couplings see little of what is to come.
                if every == 1200:
                    self.assertEqual(run(advised(told[1]), self.STEPS, jet=45)[0], [])
                else:
                    self.assertLess(advised(told[1]), 0.25 * every)

    def test_a_bed_tied_to_its_gas_swings_at_the_interval_warned_of_and_not_at_the_one_named(self):
        steps, still = 8000, {"jet": 0.02, "viscosity": 0.02}
        told, rows = run(1000, steps, **still)
        self.assertRegex(told[0], r"in intervals of 0.02 s gas and grains of a dense bed throw each other "
                                  r"to and fro: their drag \(m / K\) and void fraction allow 0.00\d+ s")
        every = advised(told[-1])
        again, good = run(every, steps, **still)
        self.assertEqual(again, [])

        def last_third(of):
            return max(row["kinetic_energy_J"] for row in of if row["time_s"] > 0.107)
        self.assertGreater(last_third(rows), 20 * last_third(good))
        # Bounded all the same: no more than the bed lifted over its own height.
        weight = 768 * 2500 * 3.14159 / 6 * 0.0025 ** 3 * 9.81
        self.assertLess(greatest(rows, "kinetic_energy_J"), weight * 0.033)
        self.assertLess(greatest(rows, "bed_height_m"), 0.066)
        self.assertLess(greatest(good, "kinetic_energy_J"), 1e-5)


if __name__ == "__main__":
    unittest.main(verbosity=2)
