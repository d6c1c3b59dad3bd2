#!/usr/bin/python3
"""Gas and a bed at rest under gravity for 1e5 DEM steps, through both programs: no energy creeps in.

The bed is let down from a lattice and comes to rest within the first tenth. Grains that lie loose roll on,
as no rolling friction is named, with an energy that may only fall. The negative control, drag of the step
before, which grows out of round-off, is in drag_stiffness.cpp."""

import unittest

import numpy as np

from hard_scene import GRAIN, GRAVITY, NOZZLE, PROBE_DEPTH, STEP, HardCase, expect_balances

STEPS = 100000
TENTH = STEPS // 10
GRAINS = 8 * 8 * 4
# Lifts the bed by a diameter [J].
SCALE = GRAINS * GRAIN * GRAVITY * 2.5e-3
LOW = [("region bed block 0 0.022 0 0.022 0 0.033", "region bed block 0 0.022 0 0.022 0 0.011"),
       ("every 25", "every 100")]


class Rest(unittest.TestCase):
    def test_a_bed_at_rest_stays_at_rest_for_1e5_steps(self):
        case = HardCase(in_script=LOW, in_gas=[(NOZZLE, "")], steps=STEPS, dump_every=TENTH)
        expect_balances(self, case)
        self.assertEqual(len(case.rows), STEPS // 100 + 1)
        kinetic = np.array([row["kinetic_energy_J"] for row in case.rows])
        tenths = [part.max() for part in np.array_split(kinetic, 10)]
        print("greatest kinetic energy of each tenth, over that which lifts the bed by a diameter: "
              + ", ".join(f"{tenth / SCALE:.1g}" for tenth in tenths))
        for before, now in zip(tenths[1:], tenths[2:]):
            self.assertLess(now, 1.02 * before)
        self.assertLess(tenths[-1], 1e-4 * SCALE)
        heights = [GRAIN * GRAVITY * columns[:, 3].sum() for _, columns in case.frames]
        for before, now in zip(heights[3:], heights[4:]):
            self.assertLess(abs(now - before), 1e-4 * SCALE)
        speeds = [speed for time, speed in case.gas_speed if time > 0.3 * STEPS * STEP]
        self.assertLess(max(speeds), 1e-3)
        # Gas at rest carries itself alone.
        at_rest = 1.2 * GRAVITY * PROBE_DEPTH
        for row in case.rows[3 * len(case.rows) // 10:]:
            self.assertAlmostEqual(row["p_0.01m_Pa"], at_rest, delta=1e-3 * at_rest)


if __name__ == "__main__":
    unittest.main(verbosity=2)
