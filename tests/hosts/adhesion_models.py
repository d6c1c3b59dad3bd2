#!/usr/bin/python3
"""Our cohesion models in LIGGGHTS scripts: forces at a distance against closed forms, ranks, the host's other
models, refusals."""

import math
import os
import re
import subprocess
import unittest
from decimal import Decimal
from unittest import mock

import adhesion_necks
import rolling_models
from adhesion_case import Case, FLOOR, Forces, R1, R2, hertz
from coupled_launch import BIN, Scene

EPS0 = 8.8541878128e-12
R12 = R1 * R2 / (R1 + R2)


def pairs_at(*gaps):
    """Pairs of a large and a small grain along x, far from each other and from the walls; the middle
    of the box, where two ranks meet, lies between each pair."""
    grains = []
    for n, gap in enumerate(gaps):
        y, z = 0.0004 + 0.0006 * (n % 3), 0.0006 + 0.0008 * (n // 3)
        x = 0.001 - R1 - gap / 2
        grains += [(x, y, z, 2 * R1, 1), (x + R1 + R2 + gap, y, z, 2 * R2, 2)]
    return grains


def above_floor(*gaps):
    return [(0.0005 + 0.0003 * n, 0.0011, R1 + gap, 2 * R1, 2) for n, gap in enumerate(gaps)]


# two triangles
MESH = """fix plate all mesh/surface file plate.stl type 1
fix floor all wall/gran @model@ mesh n_meshes 1 meshes plate"""


def hamaker_of_spheres(a, r1, r2, gap):
    """-dE/dr of Hamaker's energy of two spheres, differentiated here."""
    a, r1, r2, gap = map(Decimal, (a, r1, r2, gap))

    def energy(r):
        outer, inner = r * r - (r1 + r2) ** 2, r * r - (r1 - r2) ** 2
        return -a / 6 * (2 * r1 * r2 / outer + 2 * r1 * r2 / inner + (outer / inner).ln())

    r, h = r1 + r2 + gap, gap / 1000
    return float((energy(r + h) - energy(r - h)) / (2 * h))


def hamaker_of_wall(a, radius, gap):
    a, radius, gap = map(Decimal, (a, radius, gap))

    def energy(s):
        return -a / 6 * (radius / s + radius / (s + 2 * radius) + (s / (s + 2 * radius)).ln())

    h = gap / 1000
    return float((energy(gap + h) - energy(gap - h)) / (2 * h))


class VanDerWaals(Forces):
    MODEL = "model hertz tangential history cohesion van_der_waals"
    OF_MATERIALS = "fix hamaker all property/global hamakerConstant peratomtype 1e-19 4e-19"
    GAPS = (1e-9, 2e-8, 1.5e-7, 9e-7)
    MIXED = 2e-19  # J: the root of both

    def test_two_grains_attract_as_hamaker_says_and_not_beyond_the_greatest_gap(self):
        case = Case(pairs_at(*self.GAPS, 1.01e-6), self.MODEL, self.OF_MATERIALS)
        expected = [hamaker_of_spheres(self.MIXED, R1, R2, gap) for gap in self.GAPS] + [0.0]
        self.near(self.attractions(case), expected)

    def test_two_ranks_that_share_pairs_agree_with_one(self):
        case = Case(pairs_at(*self.GAPS), self.MODEL, self.OF_MATERIALS)
        self.assertEqual(self.attractions(case), self.attractions(case, ranks=2))

    def test_across_a_medium_the_roots_differ(self):
        properties = self.OF_MATERIALS + "\nfix k all property/global hamakerMedium scalar 2.5e-20"
        mixed = math.sqrt(1e-19 * 4e-19) * (1 - 0.5) * (1 - 0.25)
        self.near(self.attractions(Case(pairs_at(2e-8), self.MODEL, properties)),
                  [hamaker_of_spheres(mixed, R1, R2, 2e-8)])

    def test_a_constant_of_pairs_is_taken_as_it_is(self):
        of_pairs = "fix h all property/global hamakerConstant peratomtypepair 2 1e-19 7e-20 7e-20 1e-19"
        self.near(self.attractions(Case(pairs_at(2e-8), self.MODEL, of_pairs)),
                  [hamaker_of_spheres(7e-20, R1, R2, 2e-8)])

    def test_walls_of_planes_and_meshes_attract_alike(self):
        grains = above_floor(*self.GAPS, 1.01e-6)
        plane = self.attractions(Case(grains, self.MODEL, self.OF_MATERIALS, wall=FLOOR))
        mesh = self.on_mesh(Case(grains, self.MODEL, self.OF_MATERIALS, wall=MESH))
        # the wall is of type 1, the grains of type 2
        self.near(plane, [hamaker_of_wall(self.MIXED, R1, gap) for gap in self.GAPS] + [0.0])
        self.near(mesh[:-1], plane[:-1], share=1e-9)
        self.assertEqual(mesh[-1], 0.0)

    def test_a_mesh_without_history_counts_a_grain_over_its_edge_once(self):
        model = "model hertz tangential no_history cohesion van_der_waals"
        over_edge = [(0.001, 0.001, R1 + 2e-8, 2 * R1, 2)]
        force = self.on_mesh(Case(over_edge, model, self.OF_MATERIALS, wall=MESH))
        self.near(force, [hamaker_of_wall(self.MIXED, R1, 2e-8)])

    def test_an_overlap_is_attracted_as_the_smallest_gap(self):
        case = Case(pairs_at(-1e-8), self.MODEL, self.OF_MATERIALS, words="smallest_gap 1e-9")
        expected = hamaker_of_spheres(self.MIXED, R1, R2, 1e-9) - hertz(1e-8, R12)
        self.near(self.attractions(case), [expected])

    def test_tangential_reduce_takes_the_attraction_off_the_force_that_friction_goes_by(self):
        # A grain on the floor that slides: |F_t| = mu |F_n|, with the attraction in F_n or not.
        grains = above_floor(-1e-8)
        attraction = hamaker_of_wall(self.MIXED, R1, 1e-9)
        for word, normal in (("off", hertz(1e-8, R1)), ("on", hertz(1e-8, R1) - attraction)):
            case = Case(grains, self.MODEL, self.OF_MATERIALS, wall=FLOOR, mu=1e-6,
                        words=f"smallest_gap 1e-9 tangential_reduce {word}",
                        after="velocity all set 1.0 0 0\nrun 1")
            self.near([-case.steps()[1][1]["fx"]], [1e-6 * abs(normal)])

    def test_it_stands_beside_every_model_of_the_host(self):
        # At a gap none of these models has a force; in touch all have some of their own.
        properties = self.OF_MATERIALS
        for name in ("kn 100", "kt 100", "gamman 1", "gammat 1", "coefficientRollingFriction 0.1",
                     "coefficientRollingViscousDamping 0.1", "coefficientMaxElasticStiffness 2",
                     "coefficientAdhesionStiffness 0.5", "coefficientPlasticityDepth 0.1"):
            word, value = name.split()
            properties += f"\nfix of_{word} all property/global {word} peratomtypepair 2" + f" {value}" * 4
        rolling = "model hertz tangential history cohesion van_der_waals rolling_friction "
        for model in ("model hooke tangential no_history cohesion van_der_waals",
                      "model hooke tangential history cohesion van_der_waals rolling_friction epsd2",
                      "model hooke/stiffness tangential history cohesion van_der_waals",
                      "model hertz/stiffness tangential no_history cohesion van_der_waals",
                      "model hooke/hysteresis tangential history cohesion van_der_waals",
                      "model hertz cohesion van_der_waals", rolling + "cdt", rolling + "epsd",
                      rolling + "epsd3"):
            with self.subTest(model):
                extra = "\nfix kr all property/global rollingStiffness scalar 1.0"
                case = Case(pairs_at(2e-8, -1e-8), model, properties + extra)
                force = self.attractions(case)[0]
                self.near([force], [hamaker_of_spheres(self.MIXED, R1, R2, 2e-8)])


class Electrostatic(Forces):
    MODEL = "model hertz tangential history cohesion electrostatic"
    WORDS = "greatest_gap 3e-4"

    def forces(self, grains, charges, words="", wall="", **options):
        properties = "fix q all property/atom electricCharge scalar yes yes no 0.0"
        after = "run 0\n"
        for n, charge in enumerate(charges):
            after += f"group g{n} id {n + 1}\nset group g{n} property/atom electricCharge {charge!r}\n"
        case = Case(grains, self.MODEL, properties, wall=wall, skin="7e-4", after=after + "run 1",
                    words=self.WORDS + words)
        return self.attractions(case, **options)

    def test_two_charges_follow_coulomb_up_to_the_greatest_gap(self):
        gaps = (-1e-7, 1e-7, 5e-5, 2.9e-4, 3.01e-4)
        charges = (1e-14, -2e-14, 1e-14, 2e-14, -1e-14, 2e-14, 1e-14, -3e-14, 1e-14, -2e-14)
        expected = [-charges[2 * n] * charges[2 * n + 1] / (4 * math.pi * EPS0 * (R1 + R2 + gap)**2)
                    for n, gap in enumerate(gaps)]
        expected[0] -= hertz(1e-7, R12)
        expected[-1] = 0.0
        forces = self.forces(pairs_at(*gaps), charges)
        self.near(forces, expected)
        self.assertEqual(forces, self.forces(pairs_at(*gaps), charges, ranks=2))

    # Contacts with cohesion are computed one by one.
    @mock.patch.dict(os.environ, {"GASGRAIN_INSTRUCTIONS": "portable"})
    def test_grains_without_charge_collide_as_dry_ones(self):
        # Of many grains the longer neighbour lists would change the order of summation.
        after = "fix move all nve/sphere\nvelocity all set 0 0.1 0.2\nset group all omegaz 5.0\nrun 400"
        dry = Case(pairs_at(-1e-7, 1e-8), "model hertz tangential history", after=after)
        charge = "fix q all property/atom electricCharge scalar yes yes no 0.0"
        case = Case(pairs_at(-1e-7, 1e-8), self.MODEL, charge, words=self.WORDS, after=after)
        self.assertEqual(case.steps(), dry.steps())

    def test_a_wall_holds_a_charge_by_its_image_and_by_its_own_charge(self):
        q, gap = 1e-14, 2e-5
        image = q**2 / (16 * math.pi * EPS0 * (R1 + gap) ** 2)
        for words, expected in (("", image), (" wall_permittivity 4", 0.6 * image),
                                (" wall_permittivity 1 wall_charge 2e-6", -q * 2e-6 / (2 * EPS0))):
            self.near(self.forces(above_floor(gap), (q,), words, FLOOR), [expected])

    def test_more_charge_than_the_gas_bears_is_warned_of(self):
        properties = "fix q all property/atom electricCharge scalar yes yes no 1e-11"
        status, text, _ = Case(pairs_at(1e-5), self.MODEL, properties, words=self.WORDS).run()
        self.assertEqual(status, 0, text)
        self.assertIn("2 grains carry more charge than the gas bears", text)

    def test_charges_of_the_atom_style_are_taken(self):
        case = Case(pairs_at(5e-5), self.MODEL, words=self.WORDS)
        case.text = case.text.replace("atom_style granular", "atom_style hybrid granular charge")
        case.text = case.text.replace("fix youngs", "set atom 1 charge 1e-14\nset atom 2 charge -2e-14\n"
                                      "fix youngs", 1)
        self.near(self.attractions(case), [2e-28 / (4 * math.pi * EPS0 * (R1 + R2 + 5e-5)**2)])


class Bed(unittest.TestCase):
    """768 grains that fall together in a box, 2.5 mm, hence many contacts and many makings of lists."""

    NECK = "\n".join(
        [f"fix of_{name} all property/global {name} peratomtypepair 1 {value}" for name, value in (
            ("neckSurfaceTension", "@t@"), ("neckTensileStrength", 1e7), ("neckShearStrength", 1e7),
            ("neckStiffness", 1e3))] +
        [f"fix of_{name} all property/global {name} scalar {value}" for name, value in (
            ("neckLatticeConstant", 2.87e-10), ("surfaceDiffusionPrefactor", 5e-4),
            ("surfaceDiffusionEnergy", 2.2e5), ("volumeDiffusionPrefactor", 2e-4),
            ("volumeDiffusionEnergy", 2.5e5))])

    def state(self, model, properties="", words="", steps=300, **environment):
        extra = ("fix speed all property/global characteristicVelocity scalar 0.1\n"
                 "fix cr all property/global coefficientRollingFriction peratomtypepair 1 0.1\n"
                 "fix cv all property/global coefficientRollingViscousDamping peratomtypepair 1 0.1\n")
        with Scene(couple="", steps=steps) as scene:
            script = scene.folder / "in.liggghts"
            text = script.read_text().replace("pair_style", f"{extra}{properties}\npair_style")
            text = re.sub(r"model hertz tangential history(.*)", rf"{model}\1 {words}", text)
            text = text.replace("run 300", "velocity all set 0.6 0.4 -0.5\nset group all omegax 50.0\n"
                                'dump end all custom 300 dump.txt id x y z vx vy vz omegax omegay omegaz\n'
                                'dump_modify end sort id format "%d' + " %.17g" * 9 + '"\nrun 300')
            script.write_text(text)
            done = subprocess.run([str(BIN / "gasgrain-liggghts"), "-in", "in.liggghts", "-log", "none"],
                                  cwd=scene.folder, capture_output=True, text=True, timeout=60,
                                  check=False, env={**os.environ, **environment})
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            self.assertNotIn("whitelist", done.stdout)
            return (scene.folder / "dump.txt").read_text()

    def test_parameters_of_zero_are_the_dry_run_bit_for_bit(self):
        hertz_history = "model hertz tangential history"
        one_by_one = {"GASGRAIN_INSTRUCTIONS": "portable"}  # as contacts with cohesion are computed
        dry = self.state(hertz_history, **one_by_one)
        for model, properties, words in (
                ("cohesion van_der_waals", "fix h all property/global hamakerConstant peratomtype 0.0", ""),
                ("cohesion jkr", "fix w all property/global workOfAdhesion peratomtypepair 1 0.0", ""),
                ("cohesion sintered_neck", self.NECK.replace("@t@", "0"), "neck_temperature 1400 greatest_gap 1e-6"),
                ("rolling_friction viscous",
                 "fix k all property/global rollingTimeConstant peratomtypepair 1 0.0", "")):
            with self.subTest(model):
                self.assertEqual(self.state(f"{hertz_history} {model}", properties, words, **one_by_one), dry)

    def test_compiled_and_combined_at_run_time_agree_bit_for_bit(self):
        charge = "fix q all property/atom electricCharge scalar yes yes no 2e-11"
        rolling = "fix k all property/global rollingTimeConstant peratomtypepair 1 1e-3"
        dry = self.state("model hertz tangential history")
        for model, properties, words in (
                ("hertz tangential history cohesion van_der_waals rolling_friction epsd",
                 "fix h all property/global hamakerConstant peratomtype 5e-18", "smallest_gap 1e-9 greatest_gap 1e-5"),
                ("hertz tangential history cohesion jkr rolling_friction cdt",
                 "fix w all property/global workOfAdhesion peratomtypepair 1 5.0", ""),
                ("hooke tangential history cohesion sintered_neck", self.NECK.replace("@t@", "2"),
                 "neck_temperature 1500 greatest_gap 1e-5 micro_contacts 9"),
                ("hooke tangential no_history cohesion electrostatic", charge, "greatest_gap 2e-4"),
                ("hertz tangential history rolling_friction limited", rolling, "")):
            with self.subTest(model):
                compiled = self.state("model " + model, properties, words)
                at_run_time = self.state("model " + model, properties, words,
                                         GASGRAIN_CONTACT_STYLES="runtime")
                self.assertEqual(compiled, at_run_time)
                self.assertNotEqual(compiled, dry)


class Refusals(unittest.TestCase):
    """One message: the model, the property or word, its value, what is allowed, the remedy."""

    def refused(self, expected, *arguments, **options):
        status, text, _ = Case(*arguments, **options).run()
        self.assertNotEqual(status, 0, text)
        messages = [line for line in text.splitlines() if line.startswith("gasgrain-liggghts: error:")]
        self.assertEqual(len(messages), 1, text)
        for words in expected:
            self.assertIn(words, text)

    def test_van_der_waals(self):
        model, pair = VanDerWaals.MODEL, pairs_at(1e-8)
        self.refused(["needs the property hamakerConstant", "hamakerConstant peratomtype VALUES",
                      'has "hamakerConstnt": is it misspelt?'], pair, model,
                     "fix h all property/global hamakerConstnt peratomtype 1e-19 1e-19")
        self.refused(["not in this form"], pair, model, "fix h all property/global hamakerConstant scalar 1e-19")
        self.refused(["Types 1 and 2, from hamakerConstant", "A_jj = -1e-19 J must be 0 or above"], pair,
                     model, "fix h all property/global hamakerConstant peratomtype 1e-19 -1e-19")
        self.refused(["Hamaker's constant = 0.6 J must be below 1e-17", "give it in J, not in zJ or eV",
                      "smallest gap = 0 m must be above 0"], pair, model,
                     "fix h all property/global hamakerConstant peratomtype 0.6 0.6", words="smallest_gap 0")
        self.refused(["primitive wall", "Write 'neighbor 5e-05 bin'"], above_floor(1e-6), model,
                     VanDerWaals.OF_MATERIALS, wall=FLOOR, words="greatest_gap 2.5e-5")
        self.refused(["the script has 'units cgs'", "Write 'units si'"], pair, model,
                     VanDerWaals.OF_MATERIALS + "\nsoft_particles yes", units="cgs")

    def test_jkr(self):
        self.refused(["work of adhesion = -0.1 J/m2 must be 0 or above"], pairs_at(1e-8), adhesion_necks.Jkr.MODEL,
                     "fix w all property/global workOfAdhesion peratomtypepair 2" + " -0.1" * 4)
        self.refused(["workOfAdhesion peratomtypepair 2 VALUES", "surfaceEnergy peratomtype VALUES"],
                     pairs_at(1e-8), adhesion_necks.Jkr.MODEL)

    def test_electrostatic(self):
        charge = "fix q all property/atom electricCharge scalar yes {} no 0.0"
        self.refused(["greatest_gap = 0 m must be above 0"], pairs_at(1e-8), Electrostatic.MODEL,
                     charge.format("yes"))
        self.refused(["the grains have no charges", "property/atom electricCharge"], pairs_at(1e-8),
                     Electrostatic.MODEL, words=Electrostatic.WORDS)
        self.refused(["Write its second word yes"], pairs_at(1e-8), Electrostatic.MODEL,
                     charge.format("no"), words=Electrostatic.WORDS)
        self.refused(["permittivity of the medium = 0.5 must be 1 or above"], pairs_at(1e-8),
                     Electrostatic.MODEL, charge.format("yes"), words="greatest_gap 1e-4 medium_permittivity 0.5")

    def test_sintered_neck(self):
        neck = adhesion_necks.SinteredNeck("test_beyond_the_greatest_gap_a_neck_breaks_and_is_told_of")
        self.refused(["greatest_gap = 0 m must be above 0", "micro_contacts = 2.5", "must be 1, 3 or 9",
                      "surface tension = -1 N/m must be 0 or above"], pairs_at(1e-8), neck.MODEL,
                     neck.properties(tension=-1.0), words="neck_temperature 1400 micro_contacts 2.5")
        self.refused(["it needs a temperature", "fix heat/gran"], pairs_at(1e-8), neck.MODEL,
                     neck.properties(), words="greatest_gap 1e-7")
        self.refused(["Temp = 0 K; it must be above 0"], pairs_at(1e-8), neck.MODEL, neck.properties() +
                     "fix heat all property/atom Temp scalar yes yes no 0.0", words="greatest_gap 1e-7")

    def test_rolling(self):
        model = "model hertz tangential history rolling_friction limited"
        of_pairs = rolling_models.Rolling("test_viscous_rolling_dies_out_exponentially").of_pairs
        self.refused(["rolling_friction limited", "friction = 2 must be at most 1",
                      "time constant = -1 s must be 0 or above"], pairs_at(1e-8), model,
                     of_pairs(coefficientRollingFriction=2.0, rollingTimeConstant=-1.0))
        self.refused(["rollingTimeConstant peratomtypepair 2 VALUES  (s)"], pairs_at(1e-8), model,
                     of_pairs(coefficientRollingFriction=0.1))


if __name__ == "__main__":
    unittest.main(verbosity=2)
