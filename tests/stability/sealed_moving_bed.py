#!/usr/bin/python3
"""A bed that moves in a sealed box, and an inflow of exactly nothing, through both programs.

Bounds: no gas comes or goes, its mass stays as it was, and what grains displace on one side of the bed
comes back on the other: the continuity of every cell closes although no outlet takes up what is amiss.
The grains only lose energy. An inflow of 0 m/s is a wall. The negative control, solids that are cut off
instead of moved, is in sealed_box.cpp."""

import unittest

import h5py
import numpy as np

from hard_scene import GRAVITY, NOZZLE, HardCase, energies, expect_balances, scene_mass

HEAVY = scene_mass * GRAVITY / 0.022**2  # pressure that carries all grains [Pa]
HIGH_UP = [("region bed block 0 0.022 0 0.022 0 0.033", "region bed block 0 0.022 0 0.022 0.055 0.088")]
SEALED = [('z_hi = "outlet"\n', "")]
STILL = [(NOZZLE, NOZZLE.replace("velocity = 45.0", "velocity = 0.0"))]
IDEAL = [("[time]", '[gas]\nlaw = "ideal_gas"\n[time]')]
SUMS = "momentum_z_Ns", "kinetic_energy_J", "p_0.01m_Pa", "impulse_given_z_Ns", "bed_height_m"


def gas_masses(path):
    """Sum of eps rho over the cells at each snapshot, times the volume of a cell [kg]."""
    volume = 0.0055**3
    with h5py.File(path) as file:
        groups = [file[name] for name in file if "time" in file[name].attrs]
        return [float((group["void_fraction"][...] * group["density"][...]).sum()) * volume
                for group in sorted(groups, key=lambda group: group.attrs["time"])]


class SealedBox(unittest.TestCase):
    def expect_sealed(self, case):
        expect_balances(self, case)
        for row in case.rows[1:]:
            for name in ("mass_inflow_kg_s", "mass_outflow_kg_s", "backflow_faces"):
                self.assertEqual(row[name], 0, (row["step"], name))
        energy = energies(case)
        falling = energy[:52]
        for before, now in zip(falling, falling[1:]):
            self.assertLess(now, before + 1e-9 * energy[0])
        self.assertLess(max(energy), (1 + 1e-9) * energy[0])
        self.assertLess(energy[-1], 0.7 * energy[0])
        self.assertGreater(case.rows[0]["bed_height_m"], 2 * case.rows[-1]["bed_height_m"])

    def test_a_bed_falls_through_gas_that_cannot_leave(self):
        case = HardCase(in_script=HIGH_UP, in_gas=[(NOZZLE, ""), *SEALED], steps=6000, dump_every=100)
        self.expect_sealed(case)

    def test_the_mass_of_an_ideal_gas_is_kept(self):
        case = HardCase(in_script=HIGH_UP, in_gas=[(NOZZLE, ""), *SEALED, *IDEAL], steps=6000,
                        dump_every=100, read_gas=gas_masses)
        self.expect_sealed(case)
        self.assertGreater(len(case.gas_data), 10)
        for mass in case.gas_data:
            self.assertAlmostEqual(mass, case.gas_data[0], delta=1e-9 * case.gas_data[0])

    def test_an_inflow_of_nothing_is_a_wall(self):
        for box in ([], SEALED):
            runs = [HardCase(in_script=HIGH_UP, in_gas=[*change, *box], steps=2000)
                    for change in ([(NOZZLE, "")], STILL)]
            for without, still in zip(runs[0].rows, runs[1].rows):
                for name in SUMS:
                    self.assertAlmostEqual(without[name], still[name], delta=1e-9 * abs(without[name]) + 1e-15,
                                           msg=f"{name} at step {without['step']:g}")


if __name__ == "__main__":
    unittest.main(verbosity=2)
