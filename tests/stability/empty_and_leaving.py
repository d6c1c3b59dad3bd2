#!/usr/bin/python3
"""No grain at all; a single one, on ranks most of which have none; every grain leaves through the outlet;
more gas ranks than there are cells for. Through both programs.

Bounds: without grains the gas flows as it does alone; a single grain falls as the drag law says, wherever
the ranks are cut; those that leave take what they owe into the ledger, which closes, and leave a gas that
flows as if they had never been. Negative control: the ledger without the carry of those that left. Ranks
that would have no cells are refused before the run, in words."""

import math
import unittest

import numpy as np

from hard_scene import GRAIN, GRAVITY, NOZZLE, STEP, HardCase, expect_balances

EMPTY = [("set group all diameter 0.0025 density 2500\n", ""), ("map array", "map array sort 0 0")]
NONE = [*EMPTY, ("create_atoms 1 region bed\n", "")]
ONE = [*EMPTY, ("create_atoms 1 region bed\n", "create_atoms 1 single 0.0115 0.011 0.1 units box\n"
                "set group all diameter 2.5e-3 density 2500\n")]
LIGHT = [("density 2500", "density 250"), ("timestep 2e-5", "timestep 1e-5"), ("lost error", "lost ignore")]
RANKS = ((1, 1), (3, 2))
ALONG_Z = "processors 1 1 *"


def whole(velocity):
    return [(NOZZLE, f'[[inflow]]\nside = "z_lo"\nvelocity = {velocity}\n')]


def fallen_speed(time, steps=20000):
    """Of the scene's grain from rest in air at rest, C_d 24 / Re (1 + 0.15 Re^0.687), own weight less
    buoyancy [m/s]."""
    d, rho, mu, dt, v = 2.5e-3, 1.2, 1.827e-5, time / steps, 0.0
    for _ in range(steps):
        reynolds = rho * v * d / mu
        drag = 3 * math.pi * mu * d * (1 + 0.15 * reynolds**0.687) * v
        v += dt * (GRAVITY * (1 - rho / 2500) - drag / GRAIN)
    return v


class EmptyAndLeaving(unittest.TestCase):
    def test_without_grains_the_gas_flows_as_alone(self):
        for ranks in RANKS:
            case = HardCase(in_script=NONE, in_gas=whole(3.0), steps=500, processors=ALONG_Z,
                            dem_ranks=ranks[0], gas_ranks=ranks[1])
            flow = 1.2 * 3.0 * 0.022**2
            self.assertEqual(len(case.rows), 21)
            for row in case.rows[1:]:
                for name in ("particles", "kinetic_energy_J", "impulse_exchanged_Ns", "ledger_residual",
                             "bed_height_m", "moved_cells", "too_dense"):
                    self.assertEqual(row[name], 0, name)
                self.assertAlmostEqual(row["mass_outflow_kg_s"], flow, delta=1e-9 * flow)
                self.assertLess(row["continuity_residual"], 1e-9)
            # A boundary layer, which no duct brings beyond 2.1 times the mean.
            self.assertLess(case.gas_speed[-1][1], 2.1 * 3.0)

    def test_a_single_grain_falls_as_the_law_says_whatever_the_ranks(self):
        ends = []
        couple = "fix gas all couple/gas every 25 output @out@ drag schiller_naumann pressure_gradient"
        for ranks in RANKS:
            case = HardCase(in_script=ONE, in_gas=[(NOZZLE, "")], couple=couple, steps=6000,
                            processors=ALONG_Z, dump_every=1000, dem_ranks=ranks[0], gas_ranks=ranks[1])
            expect_balances(self, case)
            for step, columns in case.frames[1:]:
                speed = fallen_speed(step * STEP)
                self.assertAlmostEqual(-columns[0, 6], speed, delta=2e-3 * speed)
            ends.append(case.frames[-1][1][0])
            # It is not pushed aside: the gas is as still to its left as to its right, but for where
            # it is in its cell.
            self.assertLess(np.abs(case.frames[-1][1][0, 4:6]).max(), 1e-3 * speed)
        np.testing.assert_allclose(ends[0], ends[1], rtol=1e-8, atol=1e-9)

    def test_all_grains_leave_and_the_gas_is_as_it_was(self):
        velocity = 15.0
        for ranks in ((1, 1), (2, 2)):
            case = HardCase(in_script=LIGHT, in_gas=whole(velocity), steps=4000, processors=ALONG_Z,
                            dem_ranks=ranks[0], gas_ranks=ranks[1])
            self.assertEqual(case.rows[0]["particles"], 768)
            expect_balances(self, case, leaving=True)
            speeds = [math.sqrt(2 * row["kinetic_energy_J"] / (row["particles"] * GRAIN / 10))
                      for row in case.rows if row["particles"]]
            self.assertLess(max(speeds), velocity)
            last = case.rows[-1]
            self.assertEqual(last["particles"], 0)
            for name in ("kinetic_energy_J", "impulse_outstanding_z_Ns"):
                self.assertEqual(last[name], 0)
            self.assertAlmostEqual(last["mass_outflow_kg_s"], 1.2 * velocity * 0.022**2, delta=1e-9)
            self.assertLess(last["ledger_residual"], 1e-12)
            without = abs(last["impulse_given_z_Ns"] - last["impulse_taken_z_Ns"])
            print(f"without the carry of those that left the residual is "
                  f"{without / last['impulse_exchanged_Ns']:.2g} instead of {last['ledger_residual']:.2g}")
            self.assertGreater(without, 1e-4 * last["impulse_exchanged_Ns"])
            empty = HardCase(in_script=NONE, in_gas=whole(velocity), steps=500)
            self.assertAlmostEqual(last["p_0.01m_Pa"], empty.rows[-1]["p_0.01m_Pa"],
                                   delta=0.02 * last["p_0.01m_Pa"])

    def test_gas_ranks_that_would_have_no_cells_are_refused(self):
        case = HardCase(in_gas=[*whole(3.0), ("[4, 4, 20]", "[1, 1, 2]")], steps=100, gas_ranks=3, expect=1)
        self.assertIn("3 gas ranks cannot share a grid of 1 x 1 x 2 cells", case.text)
        self.assertEqual(case.text.count("error:"), 1, case.text)


if __name__ == "__main__":
    unittest.main(verbosity=2)
