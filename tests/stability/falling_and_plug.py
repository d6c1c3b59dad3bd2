#!/usr/bin/python3
"""A slug of grains falls into empty gas; a bed collapses when its gas is cut; a plug that fills the section
is lifted. Through both programs.

Bounds: the grains' energy never grows without a gas that brings some; the pressure stays below what
carries or accelerates the weight, and changes smoothly as grains fall from cell to cell; what is cut or
has fallen comes to rest under the pressure of gas at rest. Negative control: the void fraction of grains'
centres alone, which blows the pressure up whenever a layer of grains crosses a face."""

import unittest

import numpy as np

from hard_scene import (COUPLE, GRAVITY, NOZZLE, PROBE_DEPTH, STEP, HardCase, energies, expect_balances, scene_mass)

HEAVY = scene_mass * GRAVITY / 0.022**2   # pressure that carries all grains [Pa]
AT_REST = 1.2 * GRAVITY * PROBE_DEPTH     # of the gas at the probe [Pa]
EVERY = 25                                # DEM steps from coupling to coupling
HIGH_UP = [("region bed block 0 0.022 0 0.022 0 0.033", "region bed block 0 0.022 0 0.022 0.055 0.088")]
LANDS = 5300                              # step, from 55 mm


def fall(method):
    case = HardCase(in_script=HIGH_UP, in_gas=[(NOZZLE, "")], couple=COUPLE.replace("trilinear", method),
                    steps=6000, dump_every=100)
    pressure = np.array([row["p_0.01m_Pa"] for row in case.rows[1:]])
    return case, pressure[:LANDS // EVERY - 1], pressure


class FallingAndPlug(unittest.TestCase):
    def expect_no_energy_gained(self, energy, share):
        """From frame to frame; contacts and spin give back a share of what is lost in all."""
        lost = energy[0] - energy[-1]
        self.assertGreater(lost, 0)
        for before, now in zip(energy, energy[1:]):
            self.assertLess(now, before + share * lost)

    def test_a_slug_falls_as_through_gas_and_lands(self):
        for method in ("trilinear", "kernel"):
            with self.subTest(method=method):
                case, falling, pressure = fall(method)
                expect_balances(self, case)
                energy = energies(case)
                self.expect_no_energy_gained(energy[:LANDS // 100], 1e-3)
                # What lands is pressed together, and springs back.
                self.expect_no_energy_gained(energy, 0.3)
                self.assertLess(np.abs(pressure).max(), HEAVY)
                # A smooth rise with the speed of the slug.
                self.assertLess(falling.max(), 0.15 * HEAVY)
                self.assertGreater(falling.min(), 0)
                roughness = np.abs(np.diff(falling, 2)).max()
                print(f"{method}: pressure changes from coupling to coupling differ by {roughness:.2f} Pa")
                self.assertLess(roughness, 0.02 * HEAVY)
                # Slower than in a vacuum, by what the gas took.
                speed = -case.frames[LANDS // 100 - 1][1][:, 6].mean()
                free = GRAVITY * (LANDS - 100) * STEP
                self.assertLess(speed, free)
                self.assertGreater(speed, 0.9 * free)
                self.assertLess(case.rows[-1]["max_overlap"], 0.1)

    def test_with_the_centres_void_fraction_the_pressure_leaps_at_every_face(self):
        case, falling, _ = fall("centre")
        roughness = np.abs(np.diff(falling, 2)).max()
        print(f"centre: {roughness:.0f} Pa, {falling.min():.0f} to {falling.max():.0f} Pa")
        self.assertGreater(roughness, HEAVY)
        self.assertLess(falling.min(), -0.5 * HEAVY)
        self.assertLess(case.rows[-1]["ledger_residual"], 1e-8)

    def test_a_bed_whose_gas_is_cut_collapses_and_comes_to_rest(self):
        cut = 0.02
        case = HardCase(in_gas=[("ramp = 0.002\n", f"table = [[0, 1], [{cut}, 1], [{cut + 1e-5}, 0]]\n")],
                        steps=7500, dump_every=100)
        expect_balances(self, case)
        after = [row for row in case.rows if row["time_s"] > cut + 1e-9]
        heights = [row["bed_height_m"] for row in case.rows]
        self.assertGreater(max(heights), 1.1 * heights[0])
        self.assertLess(heights[-1], heights[0])
        self.expect_no_energy_gained(energies(case)[int(cut / STEP / 100) + 2:], 0.05)
        for row in after:
            self.assertEqual(row["mass_inflow_kg_s"], 0)
        # But for the blow of the cut itself.
        for row in after[2:]:
            self.assertLess(abs(row["p_0.01m_Pa"]), 0.1 * HEAVY, row["step"])
        self.assertAlmostEqual(after[-1]["p_0.01m_Pa"], AT_REST, delta=0.3 * AT_REST)
        speeds = [speed for time, speed in case.gas_speed if time > 2 * cut]
        self.assertEqual(speeds, sorted(speeds, reverse=True))
        kinetic = [row["kinetic_energy_J"] for row in after]
        self.assertLess(kinetic[-1], 0.1 * max(kinetic))

    def test_a_plug_over_the_whole_section_is_lifted_by_its_weight(self):
        velocity = 5.0
        whole = f'[[inflow]]\nside = "z_lo"\nvelocity = {velocity}\n'
        case = HardCase(in_gas=[(NOZZLE, whole), ("[4, 4, 20]", "[1, 1, 20]")], steps=2000, dump_every=100)
        expect_balances(self, case)
        pressure = np.array([row["p_0.01m_Pa"] for row in case.rows[2:]])
        self.assertLess(pressure.max(), 2 * HEAVY)
        self.assertGreater(pressure.min(), 0.5 * HEAVY)
        self.assertLess(np.abs(np.diff(pressure, 2)).max(), 0.2 * HEAVY)
        height = [row["bed_height_m"] for row in case.rows]
        self.assertGreater(height[-1], height[0] + 1e-3)
        # The gas does no more work than its pressure below the plug and its speed allow.
        energy = energies(case)
        self.assertLess(energy[-1] - energy[0], pressure.max() * velocity * 0.022**2 * 2000 * STEP)
        print(f"plug: {pressure.min() / HEAVY:.2f} to {pressure.max() / HEAVY:.2f} of the weight, lifted by "
              f"{1e3 * (height[-1] - height[0]):.1f} mm")


if __name__ == "__main__":
    unittest.main(verbosity=2)
