#!/usr/bin/python3
"""Wet grains that part, slide and spin, through the real program: the viscous force and its torques against the
published formulas (bridge_formulas.py)."""

import unittest

import numpy as np

from bridge_formulas import Bridge, viscous_normal, viscous_tangential, willett
from pulled_pairs import START, Scene
from wet_host import WATER, Grain, Wet


class Viscous(unittest.TestCase):
    VISCOSITY = 0.01
    SEPARATION = 1e-5
    LIQUID = (f"film 0 gives 1 surface_tension {WATER} contact_angle 0.35 formation 2e-9 every 100000 "
              f"viscosity {VISCOSITY} minimum_separation {SEPARATION} ")
    VELOCITY = np.array([0.1, 0.02, -0.03])
    STEP = 1e-7  # [s]; short enough that no coefficient is held back

    def resistance(self, bridge, gap):
        s = np.maximum(gap, self.SEPARATION)
        return viscous_normal(bridge, self.VISCOSITY, s), viscous_tangential(bridge, self.VISCOSITY, s)

    def test_two_grains_that_part_slide_and_spin_feel_the_lubrication_of_their_bridge(self):
        radius_i, radius_j, volume = 1e-3, 0.6e-3, 2e-11
        bridge = Bridge(2 * radius_i * radius_j / (radius_i + radius_j), 0.35, WATER, volume)
        spin = np.array([[3.0, -8.0, 5.0], [20.0, 10.0, -7.0]])
        apart = np.array([0.6, 0.0, 0.8])  # not along an axis
        grains = [Grain((0, 0, 0), radius_i, volume, spin=spin[0]),
                  Grain(tuple((radius_i + radius_j + START) * apart), radius_j, spin=spin[1])]
        vx, vy, vz = self.VELOCITY
        wet = Wet(grains, self.LIQUID, step=self.STEP, size=0.01, body="group b id 2", every=5,
                  run=f"run 5\nfix off b move linear {vx} {vy} {vz}\nrun 12000")
        gap = wet.gaps(0, 1)
        there = np.flatnonzero(wet.frames["f_wet[1]"][:, 0])
        there = there[(there > 1) & (there % 40 == 0)]
        self.assertGreater(there.size, 30)
        self.assertLess(gap[there[0]], 0.5 * self.SEPARATION)
        x_i, x_j = wet.vectors("x", 0), wet.vectors("x", 1)
        normal = (x_i - x_j) / np.linalg.norm(x_i - x_j, axis=-1)[:, None]  # from j to i
        for k in there:
            n = normal[k]
            # Both surfaces meet at one point between them.
            point = x_i[k] - n * radius_i * (1 + gap[k] / (radius_i + radius_j))
            slip = (np.cross(spin[0], point - x_i[k]) - self.VELOCITY - np.cross(spin[1], point - x_j[k]))
            normal_c, tangential_c = self.resistance(bridge, gap[k])
            along = slip @ n
            tangential = -tangential_c * (slip - along * n)
            expected = -willett(bridge, max(gap[k], 0)) * n - normal_c * along * n + tangential
            np.testing.assert_allclose(wet.vectors("f", 0)[k], expected, rtol=0, atol=1e-6 * np.linalg.norm(tangential))
            np.testing.assert_array_equal(wet.vectors("f", 1)[k], -wet.vectors("f", 0)[k])
            for grain, x, sign in ((0, x_i[k], 1), (1, x_j[k], -1)):
                torque = np.cross(point - x, sign * tangential)
                np.testing.assert_allclose(wet.vectors("tq", grain)[k], torque, rtol=0, atol=1e-6 * np.linalg.norm(torque))

    def test_a_wall_resists_as_a_grain_of_twice_the_radius_does(self):
        scene = Scene(volumes=(1e-3,))
        wet = scene.run(self.LIQUID, speed=0.1, steps=6000, step=self.STEP, every=5)
        for one in scene.pulled:
            if one.name.startswith("on"):
                gap, pull = scene.gap(wet, one), scene.pull(wet, one)
                there = np.flatnonzero(wet.frames["f_wet[1]"][:, one.moves])[20::40]
                one.bridge.theta = 0.35
                expected = willett(one.bridge, gap[there]) + 0.1 * self.resistance(one.bridge, gap[there])[0]
                with self.subTest(one.name):
                    self.assertGreater(there.size, 20)
                    np.testing.assert_allclose(pull[there], expected, rtol=1e-6)

    def test_viscosity_that_a_step_cannot_take_is_held_back_and_told_of(self):
        grains = [Grain((0, 0, 0), 1e-4, 1e-14), Grain((2e-4 + START, 0, 0), 1e-4, velocity=(1.0, 0, 0))]
        wet = Wet(grains, self.LIQUID.replace("viscosity 0.01", "viscosity 100").replace("2e-9", "1e-5"), step=1e-6, size=0.01,
                  body="fix motion all nve/sphere", run="run 200")
        self.assertIn("were held back", wet.log)
        # Parted at 1 m/s, they stick: what is held back leaves 1 - 1 / 3.5 of the speed each step, and must not throw
        # them back and forth.
        speed = wet.frames["vx"][:, 1] - wet.frames["vx"][:, 0]
        self.assertLess(abs(speed[12:]).max(), 0.05)
        self.assertTrue((np.diff(speed[:12]) <= 0).all())
        self.assertAlmostEqual(wet.frames["vx"][-1].sum(), 1.0, delta=1e-12)


if __name__ == "__main__":
    unittest.main(verbosity=2)
