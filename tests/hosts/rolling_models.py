#!/usr/bin/python3
"""Our rolling models in LIGGGHTS scripts against how rolling dies out."""

import math
import unittest

from adhesion_case import Case, DENSITY, FLOOR, MODULUS, R1, equal_pair, hertz


class Rolling(unittest.TestCase):
    MASS = DENSITY * 4 / 3 * math.pi * R1**3
    GRAVITY = 9.81

    def roll(self, model, properties, speed, time, dt=2e-7):
        """Speed [m/s] after a grain has rolled over the floor without slip for this time [s]."""
        sunk = (self.MASS * self.GRAVITY / (4 / 3 * MODULUS * math.sqrt(R1))) ** (2 / 3)
        model = "model hertz tangential history rolling_friction " + model
        case = Case([(0.0005, 0.001, R1 - sunk, 2 * R1, 1)], model, properties, wall=FLOOR, dt=dt, mu=1.0,
                    e=0.5, every=1000,
                    after=f"fix weight all gravity {self.GRAVITY} vector 0 0 -1\n"
                          f"velocity all set {speed!r} 0 0\nset group all omegay {speed / R1!r}\n"
                          f"fix move all nve/sphere\nrun {round(time / dt)}")
        rows = case.steps()
        return rows[max(rows)][1]["vx"]

    def of_pairs(self, **values):
        return "".join(f"fix of_{name} all property/global {name} peratomtypepair 2" + f" {value!r}" * 4 + "\n"
                       for name, value in values.items())

    def test_viscous_rolling_dies_out_exponentially(self):
        k, time = 1e-3, 3e-3
        speed = self.roll("viscous", self.of_pairs(rollingTimeConstant=k), 0.02, time)
        expected = 0.02 * math.exp(-k * self.GRAVITY * time / (1.4 * R1))
        self.assertLess(abs(speed / expected - 1), 2e-3)  # the floor gives way by a per mille

    def test_limited_rolling_slows_down_as_friction_then_as_the_viscous_one(self):
        friction, k = 0.05, 1e-3
        properties = self.of_pairs(coefficientRollingFriction=friction, rollingTimeConstant=k)
        fast, slow = 0.05, 0.001  # the limit is at mu R / k = 0.0025 m/s
        speed = self.roll("limited", properties, fast, 3e-3)
        self.assertLess(abs((fast - speed) / (friction * self.GRAVITY / 1.4 * 3e-3) - 1), 2e-3)
        speed = self.roll("limited", properties, slow, 3e-3)
        expected = slow * math.exp(-k * self.GRAVITY * 3e-3 / (1.4 * R1))
        self.assertLess(abs(speed / expected - 1), 2e-3)

    def test_two_grains_feel_opposite_torques_and_turning_as_one_costs_nothing(self):
        properties = self.of_pairs(rollingTimeConstant=1e-3)
        inertia = 0.4 * self.MASS * R1**2
        for spins, across in (((30.0, -10.0), 40.0), ((20.0, 20.0), 0.0)):
            after = "fix move all nve/sphere\ngroup first id 1\ngroup second id 2\n"
            for name, spin in zip(("first", "second"), spins):
                after += f"set group {name} omegay {spin!r}\n"
            case = Case(equal_pair(-1e-7), "model hertz rolling_friction viscous", properties,
                        after=after + "run 1")
            rows = case.steps()
            change = [rows[1][n]["wy"] - rows[0][n]["wy"] for n in (1, 2)]
            # of the half step before and the one after
            expected = 1e-3 * hertz(1e-7, R1 / 2) * R1 / 2 * across / inertia * 1e-8
            self.assertAlmostEqual(change[0], -expected, delta=1e-3 * expected)
            self.assertAlmostEqual(change[1], expected, delta=1e-3 * expected)


if __name__ == "__main__":
    unittest.main(verbosity=2)
