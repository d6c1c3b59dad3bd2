#!/usr/bin/python3
"""Our cohesion and rolling models in LIGGGHTS scripts: forces against closed forms computed here, grains
and walls, ranks, restarts, refusals."""

import math
import os
import re
import subprocess
import tempfile
import unittest
from decimal import Decimal, getcontext
from pathlib import Path

from coupled_launch import BIN, Scene

getcontext().prec = 60
EPS0 = 8.8541878128e-12
BOLTZMANN = 1.380649e-23
GAS_CONSTANT = 8.31446262
YOUNGS, POISSON, DENSITY = 5e6, 0.17, 2500.0
MODULUS = YOUNGS / 2 / (1 - POISSON**2)  # effective, of two bodies of one material

HEAD = """\
atom_style granular
atom_modify map array sort 0 0
units @units@
boundary f f f
newton off
communicate single vel yes
@processors@
region box block 0 0.002 0 0.002 0 0.002 units box
create_box 2 box
neighbor @skin@ bin
neigh_modify delay 0
timestep @dt@
"""
MATERIALS = """\
fix youngs all property/global youngsModulus peratomtype 5e6 5e6
fix poisson all property/global poissonsRatio peratomtype 0.17 0.17
fix restitution all property/global coefficientRestitution peratomtypepair 2 @e@ @e@ @e@ @e@
fix friction all property/global coefficientFriction peratomtypepair 2 @mu@ @mu@ @mu@ @mu@
fix speed all property/global characteristicVelocity scalar 0.1
"""
DUMP = """\
dump forces all custom @every@ dump.txt id x y z fx fy fz vx vy vz omegax omegay omegaz
dump_modify forces format "%d %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g"
"""
COLUMNS = ("x", "y", "z", "fx", "fy", "fz", "vx", "vy", "vz", "wx", "wy", "wz")


class Case:
    """A few grains given by (x, y, z, diameter, type), their contact models, and what happens."""

    def __init__(self, grains, model, properties="", wall="", after="run 1", words="", **marks):
        values = {"processors": "processors * 1 1", "skin": "2e-5", "dt": "1e-8", "every": 1, "e": "1.0", "mu": "0.5", "units": "si",
                  **marks}
        text = HEAD
        for x, y, z, _, kind in grains:
            text += f"create_atoms {kind} single {x!r} {y!r} {z!r} units box\n"
        for n, grain in enumerate(grains):
            text += f"set atom {n + 1} diameter {grain[3]!r} density {DENSITY}\n"
        text += MATERIALS + properties + f"\npair_style gran {model} {words}\npair_coeff * *\n"
        if wall:  # where a wall's words stand after its shape
            text += f"{wall} {words}\n".replace("@model@", model)
        text += DUMP + after + "\n"
        for mark, value in values.items():
            text = text.replace(f"@{mark}@", str(value))
        self.text = text

    def run(self, folder=None, ranks=1, **environment):
        """(status, everything printed, {step: {id: {column: value}}})"""
        if folder is None:
            with tempfile.TemporaryDirectory(prefix="gasgrain-test-") as own:
                return self.run(Path(own), ranks, **environment)
        (folder / "in.liggghts").write_text(self.text)
        command = [str(BIN / "gasgrain-liggghts"), "-in", "in.liggghts", "-log", "none"]
        if ranks > 1:
            command = ["mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none", "-np",
                       str(ranks), *command]
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=60,
                              check=False, env={**os.environ, **environment})
        dump = folder / "dump.txt"
        return (done.returncode, done.stdout + done.stderr,
                read_dump(dump.read_text()) if dump.exists() else {})

    def steps(self, **options):
        status, text, steps = self.run(**options)
        if status != 0:
            raise AssertionError(text)
        if "whitelist" in text:
            raise AssertionError("the host put the model together by itself:\n" + text)
        return steps


def read_dump(text):
    steps = {}
    for block in text.split("ITEM: TIMESTEP\n")[1:]:
        lines = block.splitlines()
        rows = (line.split() for line in lines[8:])
        steps[int(lines[0])] = {int(row[0]): dict(zip(COLUMNS, map(float, row[1:]))) for row in rows}
    return steps


def effective(a, b):
    return a * b / (a + b)


R1, R2 = 5e-5, 3e-5
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


FLOOR = "fix floor all wall/gran @model@ primitive type 1 zplane 0.0"
# two triangles
MESH = """fix plate all mesh/surface file plate.stl type 1
fix floor all wall/gran @model@ mesh n_meshes 1 meshes plate"""
STL = """solid plate
facet normal 0 0 1
outer loop
vertex 0 0 0
vertex 0.002 0 0
vertex 0 0.002 0
endloop
endfacet
facet normal 0 0 1
outer loop
vertex 0.002 0 0
vertex 0.002 0.002 0
vertex 0 0.002 0
endloop
endfacet
endsolid plate
"""


def hertz(overlap, radius):
    return 4 / 3 * MODULUS * math.sqrt(radius) * max(overlap, 0.0) ** 1.5


class Forces(unittest.TestCase):
    """Attractions [N] in a case's last step: of each pair of pairs_at(), or of each grain to the floor."""

    def attractions(self, case, **options):
        steps = case.steps(**options)
        last = steps[max(steps)]
        if "wall/gran" in case.text:
            return [-last[n]["fz"] for n in sorted(last)]
        for n in range(1, len(last), 2):  # action and reaction, to the last bit
            self.assertEqual(last[n]["fx"], -last[n + 1]["fx"])
        return [last[n]["fx"] for n in range(1, len(last), 2)]

    def near(self, measured, expected, share=1e-3):
        for m, e in zip(measured, expected, strict=True):
            self.assertLessEqual(abs(m - e), share * abs(e), f"{m} is not {e}")

    def on_mesh(self, case):
        with tempfile.TemporaryDirectory(prefix="gasgrain-test-") as folder:
            (Path(folder) / "plate.stl").write_text(STL)
            return self.attractions(case, folder=Path(folder))


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


def gap_of(row):
    """Of the first two grains along x, or of the only one and the floor."""
    return row[2]["x"] - row[1]["x"] - 2 * R1 if len(row) > 1 else row[1]["z"] - R1


def attraction_of(row):
    return row[1]["fx"] if len(row) > 1 else -row[1]["fz"]


def equal_pair(gap):
    return [(0.001 - R1 - gap / 2, 0.0011, 0.0009, 2 * R1, 1), (0.001 + R1 + gap / 2, 0.0011, 0.0009, 2 * R1, 1)]


def driven(*phases):
    """Grains that keep their speeds: phases of (speed along x of each, or of one along z, steps)."""
    lines = ["group first id 1", "group second id 2", "fix move all nve/noforce"]
    for speed, steps in phases:
        if isinstance(speed, tuple):
            lines.append(f"velocity all set 0 0 {speed[0]!r}")
        else:
            lines += [f"velocity first set {-speed / 2!r} 0 0", f"velocity second set {speed / 2!r} 0 0"]
        lines.append(f"run {steps}")
    return "\n".join(lines)


def jkr_force(work, radius, overlap):
    """Repulsion by bisection for the contact's radius a, which is unique beyond the snap's."""
    snap = (math.pi * work * radius**2 / (8 * MODULUS)) ** (1 / 3)
    low, high = snap, radius
    for _ in range(200):
        a = (low + high) / 2
        if a**2 / radius - math.sqrt(2 * math.pi * work * a / MODULUS) < overlap:
            low = a
        else:
            high = a
    return 4 * MODULUS * a**3 / (3 * radius) - math.sqrt(8 * math.pi * work * MODULUS * a**3)


def jkr_snap_gap(work, radius):
    return 3 * (math.pi * work * radius**2 / (8 * MODULUS)) ** (2 / 3) / radius


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
        dry = self.state(hertz_history)
        for model, properties, words in (
                ("cohesion van_der_waals", "fix h all property/global hamakerConstant peratomtype 0.0", ""),
                ("cohesion jkr", "fix w all property/global workOfAdhesion peratomtypepair 1 0.0", ""),
                ("cohesion sintered_neck", self.NECK.replace("@t@", "0"), "neck_temperature 1400 greatest_gap 1e-6"),
                ("rolling_friction viscous",
                 "fix k all property/global rollingTimeConstant peratomtypepair 1 0.0", "")):
            with self.subTest(model):
                self.assertEqual(self.state(f"{hertz_history} {model}", properties, words), dry)

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
        self.refused(["work of adhesion = -0.1 J/m2 must be 0 or above"], pairs_at(1e-8), Jkr.MODEL,
                     "fix w all property/global workOfAdhesion peratomtypepair 2" + " -0.1" * 4)
        self.refused(["workOfAdhesion peratomtypepair 2 VALUES", "surfaceEnergy peratomtype VALUES"],
                     pairs_at(1e-8), Jkr.MODEL)

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
        neck = SinteredNeck("test_beyond_the_greatest_gap_a_neck_breaks_and_is_told_of")
        self.refused(["greatest_gap = 0 m must be above 0", "micro_contacts = 2.5", "must be 1, 3 or 9",
                      "surface tension = -1 N/m must be 0 or above"], pairs_at(1e-8), neck.MODEL,
                     neck.properties(tension=-1.0), words="neck_temperature 1400 micro_contacts 2.5")
        self.refused(["it needs a temperature", "fix heat/gran"], pairs_at(1e-8), neck.MODEL,
                     neck.properties(), words="greatest_gap 1e-7")
        self.refused(["Temp = 0 K; it must be above 0"], pairs_at(1e-8), neck.MODEL, neck.properties() +
                     "fix heat all property/atom Temp scalar yes yes no 0.0", words="greatest_gap 1e-7")

    def test_rolling(self):
        model = "model hertz tangential history rolling_friction limited"
        of_pairs = Rolling("test_viscous_rolling_dies_out_exponentially").of_pairs
        self.refused(["rolling_friction limited", "friction = 2 must be at most 1",
                      "time constant = -1 s must be 0 or above"], pairs_at(1e-8), model,
                     of_pairs(coefficientRollingFriction=2.0, rollingTimeConstant=-1.0))
        self.refused(["rollingTimeConstant peratomtypepair 2 VALUES  (s)"], pairs_at(1e-8), model,
                     of_pairs(coefficientRollingFriction=0.1))


if __name__ == "__main__":
    unittest.main(verbosity=2)
