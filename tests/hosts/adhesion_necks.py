#!/usr/bin/python3
"""Contacts with a memory in LIGGGHTS scripts: JKR's neck and the sintered one, restarts."""

import math
import re
import tempfile
import unittest
from pathlib import Path

from adhesion_case import (BOLTZMANN, Case, DENSITY, DUMP, FLOOR, Forces, GAS_CONSTANT, MODULUS, POISSON,
                           R1, attraction_of, driven, equal_pair, gap_of, jkr_force, jkr_snap_gap)


class Jkr(Forces):
    MODEL = "model hertz tangential history cohesion jkr"
    WORK = 0.05  # J/m2
    OF_PAIRS = "fix work all property/global workOfAdhesion peratomtypepair 2" + f" {WORK}" * 4

    def follow(self, case, radius):
        """Every step of a touch and a parting against JKR; returns the greatest gap that was held."""
        touched, compared, held = False, 0, 0.0
        for row in case.steps().values():
            gap, force = gap_of(row), attraction_of(row)
            touched = touched or gap < 0
            if not touched:
                self.assertEqual(force, 0.0)  # nothing before the touch
            elif force != 0.0:
                expected = -jkr_force(self.WORK, radius, -gap)
                self.assertLessEqual(abs(force - expected), 1e-3 * abs(expected) + 1e-12)
                compared, held = compared + 1, max(held, gap)
        self.assertGreater(compared, 300)
        return held

    def test_two_grains_touch_hold_on_by_a_neck_and_snap(self):
        case = Case(equal_pair(1e-7), self.MODEL, self.OF_PAIRS,
                    after=driven((-0.2, 300), (0.2, 600)))
        held = self.follow(case, R1 / 2)
        self.assertLess(abs(held - jkr_snap_gap(self.WORK, R1 / 2)), 2.1e-9)  # one step
        self.assertEqual(case.steps(), case.steps(ranks=2))

    def test_a_grain_and_a_wall_do_as_well(self):
        surfaces = "fix gamma all property/global surfaceEnergy peratomtype 0.025 0.025"
        case = Case([(0.001, 0.001, R1 + 1e-7, 2 * R1, 2)], self.MODEL, surfaces, wall=FLOOR,
                    after=driven(((-0.2,), 300), ((0.2,), 700)))
        held = self.follow(case, R1)
        self.assertLess(abs(held - jkr_snap_gap(self.WORK, R1)), 2.1e-9)

    def test_a_neck_torn_in_one_step_is_forgotten(self):
        # Away by 30 um in one step, further than the host looks, and in one step back into its reach.
        for phases, held in (((0.0, 3), (20.0, 1), (0.0, 2)), True), \
                (((0.0, 3), (3000.0, 1), (-2980.0, 1), (0.0, 2)), False):
            case = Case(equal_pair(-1e-8), self.MODEL, self.OF_PAIRS, skin="1e-4", after=driven(*phases))
            rows = case.steps()
            self.assertAlmostEqual(gap_of(rows[max(rows)]), 1.9e-7, delta=1e-9)
            self.assertEqual(attraction_of(rows[max(rows)]) > 0.0, held)

    def test_a_reset_of_the_time_step_leaves_the_neck(self):
        after = driven((0.0, 3), (20.0, 1), (0.0, 2)).replace("velocity first set -0.0 0 0\nvelocity second "
                                                              "set 0.0 0 0\nrun 2", "")
        case = Case(equal_pair(-1e-8), self.MODEL, self.OF_PAIRS, after=after + "velocity all set 0 0 0\n"
                    "undump forces\nreset_timestep 0\n" + DUMP + "run 3")
        rows = case.steps()
        self.assertEqual(max(rows), 3)
        self.assertGreater(attraction_of(rows[3]), 0.0)

    def test_a_touch_costs_the_energy_that_the_law_says(self):
        # Free grains, no damping: what their collision lost is JKR's 7.09 (w^5 R*^4 / E*^2)^(1/3).
        case = Case(equal_pair(2e-9), self.MODEL, self.OF_PAIRS, every=50,
                    after="fix move all nve/sphere\ngroup first id 1\ngroup second id 2\n"
                          "velocity first set 0.06 0 0\nvelocity second set -0.06 0 0\nrun 3500")
        rows = case.steps()
        mass = DENSITY * 4 / 3 * math.pi * R1**3
        last = rows[max(rows)]
        self.assertGreater(last[2]["vx"], 0.0)
        self.assertGreater(gap_of(last), jkr_snap_gap(self.WORK, R1 / 2))
        lost = mass * (0.06**2 - last[2]["vx"] ** 2)
        expected = 7.09 * (self.WORK**5 * (R1 / 2) ** 4 / MODULUS**2) ** (1 / 3)
        self.assertLess(abs(lost / expected - 1), 0.01)  # a step at the touch is 0.3 %

    def test_other_normal_models_are_refused(self):
        for model in ("hooke", "hertz/stiffness"):
            case = Case(equal_pair(1e-8), f"model {model} tangential history cohesion jkr",
                        self.OF_PAIRS + "\nfix kn all property/global kn peratomtypepair 2 1 1 1 1"
                        "\nfix kt all property/global kt peratomtypepair 2 1 1 1 1"
                        "\nfix gn all property/global gamman peratomtypepair 2 1 1 1 1"
                        "\nfix gt all property/global gammat peratomtypepair 2 1 1 1 1")
            status, text, _ = case.run()
            self.assertNotEqual(status, 0)
            self.assertIn("cohesion jkr: ", text)
            self.assertIn("Write 'model hertz'", text)


class SinteredNeck(Forces):
    """Linear contacts of K N/m; a neck that holds is as stiff."""

    K, SIGMA, TAU, TENSION, LATTICE = 1.0, 1e7, 5e6, 2.0, 2.87e-10
    SURFACE, VOLUME = (5e-4, 2.2e5), (2e-4, 2.5e5)  # D_0 [m2/s], Q [J/mol]
    MODEL = "model hooke/stiffness tangential history cohesion sintered_neck"
    WORDS = "greatest_gap 5e-6 neck_temperature 1400"
    DT = 1e-8

    def properties(self, tension=TENSION, **kn):
        text = ""
        for name, value in (("neckSurfaceTension", tension), ("neckTensileStrength", self.SIGMA),
                            ("neckShearStrength", self.TAU), ("kn", kn.get("kn", self.K)), ("kt", self.K),
                            ("gamman", 0.0), ("gammat", 0.0), *kn.get("more", ())):
            text += f"fix of_{name} all property/global {name} peratomtypepair 2" + f" {value!r}" * 4 + "\n"
        for name, value in (("neckLatticeConstant", self.LATTICE),
                            ("surfaceDiffusionPrefactor", self.SURFACE[0]),
                            ("surfaceDiffusionEnergy", self.SURFACE[1]),
                            ("volumeDiffusionPrefactor", self.VOLUME[0]),
                            ("volumeDiffusionEnergy", self.VOLUME[1])):
            text += f"fix of_{name} all property/global {name} scalar {value!r}\n"
        return text

    def neck(self, time, temperature, radius):
        """x [m] after a time of growth from nothing."""
        common = self.TENSION * self.LATTICE**3 / (BOLTZMANN * temperature)
        if temperature >= 1323.15:
            d = self.VOLUME[0] * math.exp(-self.VOLUME[1] / (GAS_CONSTANT * temperature))
            return (10 * common * d * radius**2 * time) ** (1 / 5)
        d = self.SURFACE[0] * math.exp(-self.SURFACE[1] / (GAS_CONSTANT * temperature))
        return (56 * common * self.LATTICE * d * radius**3 * time) ** (1 / 7)

    def held_to(self, rows):
        """The greatest gap at which the neck still pulled; its pull is K times the gap at every step."""
        held = 0.0
        for row in rows.values():
            gap, force = gap_of(row), attraction_of(row)
            if gap > 0 and force != 0.0:
                self.assertLessEqual(abs(force - self.K * gap), 1e-3 * self.K * gap)
                held = max(held, gap)
        return held

    def breaking_gap(self, time_of_step, temperature, radius, contacts=1):
        """The last gap [m] of a pull by 1 nm a step that its neck bears."""
        step = 1
        while True:
            x = self.neck(time_of_step(step), temperature, radius)
            if self.K * step * 1e-9 >= self.SIGMA * contacts * math.pi * x**2:
                return (step - 1) * 1e-9
            step += 1

    def test_a_neck_grows_by_diffusion_and_bears_its_cross_section(self):
        # Held at an overlap of 100 nm for 500 steps, then pulled apart by 1 nm a step.
        for words, temperature, radius, contacts in (
                ("neck_temperature 1400", 1400, R1, 1), ("neck_temperature 1250", 1250, R1, 1),
                ("neck_temperature 1400 micro_contacts 9", 1400, 0.1 * R1, 9)):
            case = Case(equal_pair(-1e-7), self.MODEL, self.properties(),
                        words=f"greatest_gap 8e-6 {words}", skin="5e-5",
                        after=driven((0.0, 500), (0.1, 3000)))
            expected = self.breaking_gap(lambda n: (600 + n) * self.DT, temperature, radius, contacts)
            held = self.held_to(case.steps())
            self.assertGreater(expected, 1.5e-7)
            self.assertLess(abs(held - expected), 2.1e-9, words)

    def test_a_neck_to_the_floor_has_the_doubled_radius(self):
        case = Case([(0.001, 0.001, R1 - 1e-7, 2 * R1, 1)], self.MODEL, self.properties(), wall=FLOOR,
                    words=self.WORDS, after=driven(((0.0,), 500), ((0.1,), 2000)))
        expected = self.breaking_gap(lambda n: (600 + n) * self.DT, 1400, 2 * R1)
        self.assertLess(abs(self.held_to(case.steps()) - expected), 2.1e-9)

    def test_two_grains_have_the_mean_of_their_temperatures_on_any_rank(self):
        after = ("run 0\ngroup cold id 1\nset group cold property/atom Temp 1340.0\n"
                 + driven((0.0, 500), (0.1, 1500)))
        case = Case(equal_pair(-1e-7), self.MODEL, self.properties() +
                    "fix heat all property/atom Temp scalar yes yes no 1460.0",
                    words="greatest_gap 5e-6", after=after)
        rows = case.steps()
        expected = self.breaking_gap(lambda n: (600 + n) * self.DT, 1400, R1)
        self.assertLess(abs(self.held_to(rows) - expected), 2.1e-9)
        self.assertEqual(rows, case.steps(ranks=2))

    def test_beyond_the_greatest_gap_a_neck_breaks_and_is_told_of(self):
        case = Case(equal_pair(-1e-7), self.MODEL, self.properties(), words="greatest_gap 5e-8 "
                    "neck_temperature 1400", after=driven((0.0, 500), (0.1, 400)))
        status, text, rows = case.run()
        self.assertEqual(status, 0, text)
        self.assertLess(abs(self.held_to(rows) - 5e-8), 1.1e-9)
        self.assertIn("1 of this rank's necks broke at greatest_gap", text)

    def test_a_neck_holds_against_sliding_up_to_its_shear_strength(self):
        # Sheared by 0.4 nm a step: the spring's force grows beyond mu F_n = 1e-10 N until tau A.
        after = ("group first id 1\ngroup second id 2\nfix move all nve/noforce\nrun 500\n"
                 "velocity first set 0 0.02 0\nvelocity second set 0 -0.02 0\nrun 1500")
        case = Case(equal_pair(-1e-7), self.MODEL, self.properties(), words=self.WORDS, mu=1e-3,
                    after=after)
        forces = [abs(row[1]["fy"]) for row in case.steps().values()]
        strongest = max(forces)
        step = forces.index(strongest)
        bears = self.TAU * math.pi * self.neck(step * self.DT, 1400, R1) ** 2
        self.assertLess(abs(strongest / bears - 1), 4e-10 * self.K / bears + 1e-3)
        # then a neck of a few steps, and friction, are all that is left
        self.assertLess(forces[step + 2], 0.5 * strongest)

    def test_a_softened_contact_grows_the_neck_of_the_real_one(self):
        # Meeting at 1 m/s: T_dem = pi sqrt(m / K), T_real by Hertz with steel's modulus.
        properties = self.properties() + "fix real all property/global youngsModulusReal peratomtype 2e11 2e11\n"
        case = Case(equal_pair(5e-9), self.MODEL, properties,
                    words=self.WORDS + " contact_time_correction on",
                    after=driven((-1.0, 30), (0.1, 1000)))
        mass = DENSITY * 4 / 3 * math.pi * R1**3 / 2
        in_dem = math.pi * math.sqrt(mass / self.K)
        hertz_k = 4 / 3 * (2e11 / 2 / (1 - POISSON**2)) * math.sqrt(R1 / 2)
        real = 2.94328 * (1.25 * mass / hertz_k) ** 0.4 * 1.0 ** (-1 / 5)
        rows = case.steps()
        touching = [step for step, row in rows.items() if gap_of(row) < 0]
        begun, zero = min(touching), max(touching) + 1
        first = gap_of(rows[zero])
        share = real / in_dem
        self.assertLess(share, 0.1)
        held = self.held_to(rows)
        expected = self.breaking_gap(lambda n: (zero - begun + n) * self.DT * share, 1400, R1)
        self.assertLess(abs(held - expected), 2.1e-9 + first)
        self.assertGreater(self.breaking_gap(lambda n: (zero - begun + n) * self.DT, 1400, R1),
                           1.3 * expected)

    def test_a_restart_in_the_middle_of_a_pull_changes_no_bit(self):
        first = Case(equal_pair(-1e-7), self.MODEL, self.properties(), words=self.WORDS,
                     after=driven((0.0, 300), (0.1, 150)) + "\nwrite_restart neck.restart\nrun 600")
        with tempfile.TemporaryDirectory(prefix="gasgrain-test-") as folder:
            whole = first.steps(folder=Path(folder))
            again = Case(equal_pair(-1e-7), self.MODEL, self.properties(), words=self.WORDS,
                         after="fix move all nve/noforce\nrun 600")
            again.text = re.sub(r"region box.*?(?=neighbor)", "read_restart neck.restart\n", again.text,
                                flags=re.S)
            again.text = re.sub(r"(create_atoms|set atom).*\n", "", again.text)
            resumed = again.steps(folder=Path(folder))
        self.assertGreater(self.held_to(whole), 1e-7)
        self.assertEqual(len(resumed), 601)
        self.assertEqual(resumed, {step: whole[step] for step in resumed})

    def test_hertz_needs_a_stiffness_of_the_neck(self):
        model = "model hertz tangential history cohesion sintered_neck"
        status, text, _ = Case(equal_pair(-1e-7), model, self.properties(), words=self.WORDS).run()
        self.assertNotEqual(status, 0)
        self.assertIn("neckStiffness peratomtypepair 2 VALUES", text)
        case = Case(equal_pair(-1e-7), model, self.properties(more=(("neckStiffness", self.K),)),
                    words=self.WORDS, after=driven((0.0, 500), (0.1, 300)))
        self.assertGreater(self.held_to(case.steps()), 1.5e-7)


if __name__ == "__main__":
    unittest.main(verbosity=2)
