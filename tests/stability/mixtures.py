#!/usr/bin/python3
"""Grains of very different sizes in one bed, and grains hardly denser than the liquid, through both
programs: diameters of 4.5 and 0.3 mm (a ratio of 15, as in the mixtures of Shah and Jalali, 2020), of
5 mm and 20 um, and grains 5 % denser than water.

Bounds: both balances close; nothing is faster than the fluid that drives it; dust follows the gas between
the large grains; the weight under water is carried by the water that fluidises. Negative controls: the
void fraction by centres in cells narrower than the large grains; explicit drag of dust and of grains in
water is in drag_stiffness.cpp and density_ratio.cpp."""

import unittest

import numpy as np

from hard_scene import GRAVITY, NOZZLE, PROBE_DEPTH, HardCase, expect_balances

MADE = """\
region box block 0 0.022 0 0.022 0 0.11 units box
create_box 1 box
region bed block 0 0.022 0 0.022 0 0.033 units box
lattice sc 0.00275 origin 0.5 0.5 0.5
create_atoms 1 region bed
set group all diameter 0.0025 density 2500
"""


def lattice(count, low, high):
    """Centres (product(count), 3) of equal boxes that fill the box."""
    axes = [a + (b - a) * (np.arange(n) + 0.5) / n for n, a, b in zip(count, low, high)]
    return np.stack(np.meshgrid(*axes, indexing="ij"), -1).reshape(-1, 3)


def data_file(grains):
    """[(diameter, centres)]"""
    lines = ["grains", "", f"{sum(len(c) for _, c in grains)} atoms", "1 atom types",
             "0 0.022 xlo xhi", "0 0.022 ylo yhi", "0 0.11 zlo zhi", "", "Atoms", ""]
    n = 0
    for d, centres in grains:
        for x, y, z in centres:
            n += 1
            lines.append(f"{n} 1 {d!r} 2500 {x!r} {y!r} {z!r}")
    return "\n".join(lines) + "\n"


def whole(velocity):
    return [(NOZZLE, f'[[inflow]]\nside = "z_lo"\nvelocity = {velocity}\n')]

READ = [(MADE, "read_data grains.data\n")]


def pressures(case):
    return np.array([row["p_0.01m_Pa"] for row in case.rows[3:]])


def speeds(columns):
    return np.linalg.norm(columns[:, 4:], axis=1)


class Mixtures(unittest.TestCase):
    def ratio_15(self, method, cells):
        """32 large grains on the floor, 1024 small ones above, in a wind that carries the small ones."""
        large = lattice((4, 4, 2), (0, 0, 0), (0.022, 0.022, 0.011))
        small = lattice((16, 16, 4), (0, 0, 0.012), (0.022, 0.022, 0.015))
        small += np.random.default_rng(1).uniform(-1e-4, 1e-4, small.shape)
        couple = (f"fix gas all couple/gas every 40 output @out@ void_fraction {method} drag beetstra "
                  "polydisperse pressure_gradient")
        return HardCase(
            in_script=[*READ, ("timestep 2e-5", "timestep 2.5e-6"), ("neighbor 0.0005", "neighbor 0.0001")],
            in_gas=[*whole(2.5), ("[4, 4, 20]", cells)], couple=couple, steps=8000, dump_every=500,
            files=[("grains.data", data_file([(4.5e-3, large), (0.3e-3, small)]))])

    def test_of_a_size_ratio_of_15_is_bounded(self):
        for cells in ("[4, 4, 20]", "[8, 8, 40]"):
            case = self.ratio_15("auto", cells)
            expect_balances(self, case)
            pressure = pressures(case)
            rough = np.abs(np.diff(pressure, 2)).max()
            print(f"ratio 15, cells {cells}: pressure {pressure.min():.2f} to {pressure.max():.2f} Pa, rough "
                  f"by {rough:.2f} Pa; gas at {case.gas_speed[-1][1]:.2f} m/s, small grains at "
                  f"{speeds(case.frames[-1][1][32:]).max():.2f} m/s")
            self.assertLess(rough, 1.0)
            self.assertLess(case.gas_speed[-1][1], 2 * 2.5)
            for row in case.rows:
                for count in ("moved_cells", "too_dense", "disturbance_cut"):
                    self.assertEqual(row[count], 0, (row["step"], count))
                self.assertLess(row["max_overlap"], 0.1)
            for _, columns in case.frames:
                self.assertLess(speeds(columns).max(), 2.5)

    def test_by_centres_in_cells_narrower_than_the_large_grains_is_rough(self):
        case = self.ratio_15("centre", "[8, 8, 40]")
        rough = np.abs(np.diff(pressures(case), 2)).max()
        print(f"ratio 15, centre: rough by {rough:.0f} Pa, gas at {case.gas_speed[-1][1]:.2f} m/s")
        self.assertGreater(rough, 100)
        self.assertGreater(case.rows[-1]["moved_cells"], 0)

    def test_dust_of_20_um_among_grains_of_5_mm_follows_the_gas(self):
        large = lattice((4, 4, 2), (0, 0, 0), (0.022, 0.022, 0.0111))
        dust = lattice((5, 5, 10), (0, 0, 0), (0.022, 0.022, 0.011))
        clear = np.linalg.norm(dust[:, None] - large[None], axis=2).min(axis=1) > 2.52e-3
        superficial = 0.5
        case = HardCase(
            in_script=[*READ, ("timestep 2e-5", "timestep 2e-7")], in_gas=whole(superficial),
            couple="fix gas all couple/gas every 500 output @out@ drag koch_hill pressure_gradient",
            files=[("grains.data", data_file([(5e-3, large), (20e-6, dust[clear])]))],
            steps=50000, dump_every=5000)
        expect_balances(self, case)
        means = [columns[32:, 6].mean() for _, columns in case.frames]
        print(f"{clear.sum()} grains of dust, after each ms at " + ", ".join(f"{m:.3f}" for m in means) + " m/s")
        # Between the large grains the gas is faster than above the bed, 0.03 m/s is the dust's fall.
        self.assertGreater(means[-1], superficial)
        self.assertLess(means[-1], superficial / 0.6)
        for before, now in zip(means, means[1:]):
            self.assertGreater(now, 0.99 * before)
        for _, columns in case.frames:
            self.assertLess(speeds(columns[32:]).max(), case.gas_speed[-1][1])
            # The large ones fall by no more than their way to the floor.
            self.assertLess(speeds(columns[:32]).max(), 0.12)

    def test_grains_5_percent_denser_than_water_are_carried_by_it(self):
        couple = ("fix gas all couple/gas every 50 output @out@ drag di_felice pressure_gradient "
                  "virtual_mass void_fraction trilinear")
        velocity = 0.015
        case = HardCase(
            in_script=[("density 2500", "density 1050")], couple=couple, steps=10000, dump_every=1000,
            in_gas=[*whole(velocity), ("[time]", "[gas]\ndensity = 1000.0\nviscosity = 1e-3\n[time]")])
        expect_balances(self, case)
        # Weight less buoyancy of what stands above the probe, at 8 of 33 mm.
        volume = 8 * 8 * 12 * np.pi / 6 * 2.5e-3**3
        carried = volume * 50 * GRAVITY / 0.022**2 * (1 - 0.00825 / 0.033)
        pressure = (pressures(case)[10:] - 1000 * GRAVITY * PROBE_DEPTH) / carried
        print(f"water: pressure {np.median(pressure):.3f} of the grains' weight above the probe "
              f"({pressure.min():.2f} to {pressure.max():.2f} as grains meet), bed "
              f"{1e3 * case.rows[0]['bed_height_m']:.1f} to {1e3 * case.rows[-1]['bed_height_m']:.1f} mm")
        self.assertAlmostEqual(np.median(pressure), 1, delta=0.1)
        # Two grains that meet stop the water that moves with them.
        self.assertLess(np.abs(pressure - 1).max(), 2)
        for _, columns in case.frames:
            # No more than a single grain's fall.
            self.assertLess(speeds(columns).max(), 0.05)
        heights = [row["bed_height_m"] for row in case.rows]
        self.assertLess(max(heights) - heights[0], velocity * 10000 * 2e-5)


if __name__ == "__main__":
    unittest.main(verbosity=2)
