#!/usr/bin/python3
"""The same grains move alike in LIGGGHTS and in LAMMPS over a thousand steps."""

import math
import unittest

from two_hosts_case import FORCE, MATERIALS, MOTION, WALLS, crowd, differ, greatest, in_both

# Round-off, grown by some collisions and the breaking of a bridge; all within a thousand steps.
ALIKE = 1e-9
GRAVITY = "fix weight all gravity 9.81 vector 0 0 -1\nfix move all nve/sphere\nrun 1000"
CONTACT = "model hertz tangential history rolling_friction epsd"
LIQUID = ("fix liquid all liquid content 0.02 surface_tension 0.0728 contact_angle 0.35 viscosity 1e-3 "
          "minimum_separation 1e-6\n")


def sphere(place, velocity=(0.0, 0.0, 0.0), spin=(0.0, 0.0, 0.0), kind=1, diameter=0.002):
    return (kind, diameter, 2500.0, list(place), list(velocity), list(spin))


class Motion(unittest.TestCase):
    def both(self, grains, contact=CONTACT, **settings):
        states = in_both(grains, contact, **settings)
        for name in MOTION:
            most = max(abs(row[name]) for state in states[0].values() for row in state.values())
            for step in (1, 100, 500, 1000):
                for number, row in states[0][step].items():
                    self.assertLess(abs(row[name] - states[1][step][number][name]), ALIKE * max(most, 1e-12),
                                    f"{name} of {number} at step {step}")
        return states[1]

    def test_a_falling_sphere(self):
        end = self.both([sphere((0.01, 0.01, 0.018))], dt=1e-5, after=GRAVITY)[1000][1]
        # after 1000 steps of which the first speed is half a step old
        self.assertAlmostEqual(0.018 - end["z"], 0.5 * 9.81 * 0.01**2, delta=1e-3 * 0.5 * 9.81 * 0.01**2)

    def test_a_bouncing_and_spinning_sphere_between_walls(self):
        states = self.both([sphere((0.0105, 0.0095, 0.0012), (0.5, 0.2, -0.3), (80.0, -40.0, 20.0))],
                           walls=("zplane 0.0", "xplane 0.0125"), dt=5e-6, after=GRAVITY)
        self.assertGreater(max(state[1]["vz"] for state in states.values()), 0.05)   # off the floor
        self.assertLess(min(state[1]["vx"] for state in states.values()), -0.05)     # off the side

    def test_two_spheres_that_collide_obliquely(self):
        states = self.both([sphere((0.009, 0.01, 0.01), (0.3, 0.0, 0.0), (50.0, 0.0, 90.0)),
                            sphere((0.0112, 0.0108, 0.0103), (-0.2, 0.0, 0.0), kind=2)],
                           dt=2e-6, after="fix move all nve/sphere\nrun 1000")
        self.assertGreater(states[1000][2]["vy"], 0.01)

    def test_a_bridge_that_is_pulled_apart(self):
        radius = 0.001
        grains = [sphere((0.01, 0.01, 0.01), (-0.15, 0.02, 0.0), (20.0, 0.0, 10.0)),
                  sphere((0.01 + 2 * radius - 2e-6, 0.01, 0.01), (0.15, 0.0, 0.0), kind=2)]
        states = self.both(grains, "model hertz tangential history cohesion bridge", before="",
                           properties=MATERIALS + LIQUID, dt=5e-6, after="fix move all nve/sphere\nrun 1000")
        pulls = {step: math.hypot(*(state[1][name] for name in ("fx", "fy", "fz"))) for step, state in states.items()}
        self.assertGreater(pulls[100], 1e-5)       # it holds,
        self.assertEqual(pulls[1000], 0.0)         # and has broken

    def test_a_hundred_wet_grains_between_walls(self):
        # LIGGGHTS shows a primitive wall to grains within half of the skin: 2 mm let it see all bridges.
        one, other = in_both(crowd(), "model hertz tangential history cohesion bridge", walls=WALLS, dt=2e-6, skin=2e-3,
                             properties=MATERIALS + LIQUID, every=100, after="fix move all nve/sphere\nrun 300")
        for columns in (MOTION, FORCE):
            self.assertLess(max(differ(one[step], other[step], columns) for step in (0, 100, 200, 300)), ALIKE)
        self.assertGreater(greatest(one[300], FORCE), 0.0)

    def test_a_bridge_to_a_wall_that_is_pulled_apart(self):
        states = self.both([sphere((0.01, 0.01, 0.001 - 1e-6), (0.0, 0.02, 0.25))],
                           "model hertz tangential history cohesion bridge", walls=("zplane 0.0",),
                           properties=MATERIALS + LIQUID, dt=5e-6, skin=1e-3,
                           after="fix move all nve/sphere\nrun 1000")
        self.assertLess(states[100][1]["fz"], -1e-5)
        self.assertEqual(states[1000][1]["fz"], 0.0)


if __name__ == "__main__":
    unittest.main(verbosity=2)
