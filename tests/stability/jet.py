#!/usr/bin/python3
"""A jet of 100 m/s through one cell into a packed bed, through both programs: on in one step, off in one
step; and gas drawn out from under the bed, so that the outlet's flow is reversed.

Bounds: no grain is faster than a share of the jet, no gas faster than the jet; the grains have no more
energy than the jet brought; mass and both balances of momentum close; when the jet is off the gas comes
to rest and the grains have no energy but that which falling gives. The negative control, drag taken from
the step before, is in jet_into_fixed_bed.cpp."""

import unittest

import numpy as np

from hard_scene import NOZZLE, STEP, HardCase, energies, expect_balances

JET = 100.0               # m/s
WIDTH = 5.5e-3            # of the nozzle and of a cell [m]
OFF = 0.015               # s
RATE = 2e-3               # drawn out [kg/s]
DENSITY = 1.2             # kg/m3
ONE_CELL = [("center = [0.011, 0.011]", "center = [0.01375, 0.01375]"),
            ("ramp = 0.002\n", f"table = [[0, 1], [{OFF}, 1], [{OFF + 1e-5}, 0]]\n")]
SINK = f"[[mass_source]]\nlo = [0.0, 0.0, 0.0]\nhi = [0.022, 0.022, 0.0055]\nrate = {-RATE}\n"


class Jet(unittest.TestCase):
    def test_of_100_m_s_comes_and_goes_in_one_step(self):
        case = HardCase(in_gas=ONE_CELL, jet=JET, steps=1500, dump_every=25)
        expect_balances(self, case)
        on = [row for row in case.rows if 0 < row["time_s"] <= OFF + 1e-9]
        off = [row for row in case.rows if row["time_s"] > OFF + 1e-9]
        flow = DENSITY * JET * WIDTH**2
        for row in on:
            self.assertAlmostEqual(row["mass_inflow_kg_s"], flow, delta=1e-9 * flow)
            self.assertLess(row["courant"], 10 * 1.001)  # the scene's courant_max
        for row in off:
            self.assertEqual(row["mass_inflow_kg_s"], 0)
        for row in case.rows:
            self.assertLess(row["max_overlap"], 0.1, row["step"])
        for time, speed in case.gas_speed:
            self.assertLess(speed, JET if time <= OFF else 0.3 * JET, time)
        # What the jet brings: its kinetic energy, and the work of the pressure it meets, its
        # stagnation pressure at most.
        brought = DENSITY * JET**3 * WIDTH**2 * OFF
        by_time = dict(zip((step * STEP for step, _ in case.frames), energies(case)))
        first = by_time[0.0]
        for time, now in by_time.items():
            self.assertLess(now - first, brought, time)
        self.assertGreater(max(by_time.values()) - first, 1e-3 * brought)
        fastest = max(np.linalg.norm(columns[:, 4:], axis=1).max() for _, columns in case.frames)
        print(f"gas at {case.gas_speed} (s, m/s); grains at {fastest:.2f} m/s at most, their energy "
              f"{(max(by_time.values()) - first) / brought:.3f} of what the jet brought")
        self.assertLess(fastest, 0.1 * JET)
        # Without the jet grains lose energy, but for what contacts and spin give back.
        calm = [by_time[t] - first for t in sorted(by_time) if t > OFF + 2e-3]
        for before, now in zip(calm, calm[1:]):
            self.assertLess(now, before + 0.01 * max(calm))
        self.assertLess(calm[-1], calm[0])

    def test_flow_reversed_at_the_outlet_draws_the_bed_down_and_no_more(self):
        case = HardCase(in_gas=[(NOZZLE, SINK)], steps=1500, dump_every=100)
        expect_balances(self, case)
        for row in case.rows[1:]:
            self.assertEqual(row["backflow_faces"], 16)
            self.assertAlmostEqual(row["mass_outflow_kg_s"], -RATE, delta=1e-9 * RATE)
            self.assertLess(row["max_overlap"], 0.1, row["step"])
        # The plug flow between grains; somewhat more where they stand closest.
        plug = RATE / DENSITY / 0.022**2
        for time, speed in case.gas_speed:
            self.assertLess(speed, plug / 0.35, time)
        # Drawn down by g and the drag of this flow, at rest at last.
        self.assertLess(case.rows[-1]["bed_height_m"], case.rows[0]["bed_height_m"])
        kinetic = [row["kinetic_energy_J"] for row in case.rows]
        self.assertLess(kinetic[-1], 0.05 * max(kinetic))


if __name__ == "__main__":
    unittest.main(verbosity=2)
