#!/usr/bin/python3
"""A contact law in a folder of its own, adding_a_law/: built out of tree, loaded by `plugin load` into each
host that was built, and its force against the closed form."""

import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

from adhesion_case import Case, FLOOR, R1, R2, hertz
from coupled_launch import BIN, SOURCE

EXAMPLE = SOURCE / "tests" / "hosts" / "adding_a_law"
WITH_LAMMPS = (BIN / "gasgrain.so").is_file()
PULL = 3e-6  # N
GAP = 1e-6   # m, the greatest of the pull
OVERLAP = 1e-8
# Touching; within the gap, and a hair of it; beyond.
GAPS = (-OVERLAP, 4e-7, 0.999999 * GAP, 1.000001 * GAP)
PROPERTY = f"fix pull all property/global pullForce peratomtypepair 2 {PULL} {PULL} {PULL} {PULL}"
MODEL = "model hertz tangential history cohesion constant_pull"


built = tempfile.TemporaryDirectory(prefix="gasgrain-law-")
LIBRARY = {host: Path(built.name) / "build" / f"constant_pull-{host}.so" for host in ("liggghts", "lammps")}


# Without optimisation, which takes most of the time and is not what is looked at.
def setUpModule():
    shutil.copytree(EXAMPLE, Path(built.name) / "law")
    for words in (["-S", "law", "-B", "build", f"-Dgasgrain_DIR={BIN}", "-DCMAKE_BUILD_TYPE=Debug",
                   "-DCMAKE_CXX_FLAGS_DEBUG="],
                  ["--build", "build", "--parallel", "2"]):
        done = subprocess.run(["cmake", *words], cwd=built.name, capture_output=True, text=True, timeout=280,
                              check=False)
        if done.returncode != 0:
            raise AssertionError(done.stdout + done.stderr)


def tearDownModule():
    built.cleanup()


class Law(unittest.TestCase):
    def hertz_at_touch(self, radius):
        return hertz(OVERLAP, radius)

    def expect(self, measured, radius):
        """Attractions at GAPS, to 1e-9 of the pull: Hertz's force is 5e-3 of it, and the coordinates' rounding
        1e-11 of its overlap."""
        expected = [PULL - self.hertz_at_touch(radius), PULL, PULL, 0.0]
        self.assertEqual(len(measured), len(expected))
        for force, value in zip(measured, expected):
            self.assertAlmostEqual(force, value, delta=1e-9 * PULL)


class InLiggghts(Law):
    def case(self, grains, properties=PROPERTY, model=MODEL, library=None, **options):
        load = f"plugin load {library or LIBRARY['liggghts']}\n"
        return Case(grains, model, load + properties, after="run 0", **options)

    @staticmethod
    def pairs():
        grains = []
        for n, gap in enumerate(GAPS):
            y, x = 0.0004 + 0.0004 * n, 0.001 - R1 - gap / 2
            grains += [(x, y, 0.001, 2 * R1, 1), (x + R1 + R2 + gap, y, 0.001, 2 * R2, 2)]
        return grains

    def forces(self, case):
        status, text, steps = case.run()
        self.assertEqual(status, 0, text)
        return steps[0]

    def refused(self, told, **options):
        status, text, _ = self.case(self.pairs(), **options).run()
        self.assertNotEqual(status, 0, text)
        for words in told:
            self.assertIn(words, text)

    def test_two_grains_are_pulled_together_up_to_the_greatest_gap(self):
        forces = self.forces(self.case(self.pairs()))
        for n in range(1, 9, 2):
            self.assertEqual(forces[n]["fx"], -forces[n + 1]["fx"])
        self.expect([forces[n]["fx"] for n in range(1, 9, 2)], R1 * R2 / (R1 + R2))

    def test_a_wall_pulls_too(self):
        grains = [(0.0004 + 0.0003 * n, 0.001, R1 + gap, 2 * R1, 1) for n, gap in enumerate(GAPS)]
        forces = self.forces(self.case(grains, wall=FLOOR))
        self.expect([-forces[n]["fz"] for n in sorted(forces)], R1)

    def test_a_word_changes_the_gap(self):
        forces = self.forces(self.case(self.pairs(), words="greatest_gap 5e-7"))
        self.assertAlmostEqual(forces[3]["fx"], PULL, delta=1e-12 * PULL)
        self.assertEqual(forces[5]["fx"], 0.0)

    def test_a_misspelt_word_is_told_with_the_nearest(self):
        self.refused(["in.liggghts:", "'greatest_gp'", 'Did you mean "greatest_gap"?'], words="greatest_gp 5e-7")

    def test_a_misspelt_law_is_told_with_the_nearest(self):
        self.refused(["in.liggghts:", 'Did you mean "constant_pull"?'],
                     model="model hertz tangential history cohesion constant_pul")

    def test_a_misspelt_property_is_told_with_the_nearest(self):
        self.refused(["cohesion constant_pull", "it needs the property pullForce", 'has "pullForc": is it misspelt?'],
                     properties=PROPERTY.replace("pullForce", "pullForc"))

    def test_a_wrong_value_is_told_with_its_range(self):
        self.refused(["cohesion constant_pull", "pullForce = -3e-06 N must be 0 or above"],
                     properties=PROPERTY.replace(f"{PULL}", f"{-PULL}"))

    def test_it_may_be_loaded_again(self):
        again = f"{PROPERTY}\nplugin load {LIBRARY['liggghts']}"
        self.assertEqual(self.forces(self.case(self.pairs(), again)), self.forces(self.case(self.pairs())))

    def test_a_library_that_is_none_of_this_host_is_refused(self):
        self.refused(["in.liggghts:", "nothing.so", "there is no such file"], library="nothing.so")
        self.refused(["it holds no contact law"], library="/usr/lib/x86_64-linux-gnu/libliggghts.so")
        if WITH_LAMMPS:
            self.refused(["is built for lammps, and this is liggghts"], library=LIBRARY["lammps"])


# As those of LIGGGHTS above.
LAMMPS = """\
include @bin@/gasgrain.lmp
plugin load @library@
units si
atom_style sphere
atom_modify map array sort 0 0
boundary f f f
newton off
comm_modify vel yes
region box block 0 0.002 0 0.002 0 0.002
create_box 2 box
@grains@
neighbor 2e-5 bin
neigh_modify delay 0
timestep 1e-8
fix youngs all property/global youngsModulus peratomtype 5e6 5e6
fix poisson all property/global poissonsRatio peratomtype 0.17 0.17
fix restitution all property/global coefficientRestitution peratomtypepair 2 1 1 1 1
fix friction all property/global coefficientFriction peratomtypepair 2 0.5 0.5 0.5 0.5
@properties@
pair_style gran/bridge @model@
pair_coeff * *
@wall@
dump forces all custom 1 dump.txt id fx fy fz
dump_modify forces format line "%d %.17g %.17g %.17g" sort id
run 0
"""


@unittest.skipUnless(WITH_LAMMPS, "gasgrain was not built for LAMMPS")
class InLammps(Law):
    def lmp(self, grains, properties=PROPERTY, model=MODEL, words="", wall="", library=None):
        lines = "\n".join(f"create_atoms {kind} single {x!r} {y!r} {z!r}" for x, y, z, _, kind in grains)
        lines += "".join(f"\nset atom {n + 1} diameter {grain[3]!r} density 2500" for n, grain in enumerate(grains))
        script = LAMMPS
        for mark, value in (("bin", BIN), ("library", library or LIBRARY["lammps"]), ("grains", lines),
                            ("properties", properties), ("model", f"{model} {words}"),
                            ("wall", wall.replace("@model@", f"{model} {words}"))):
            script = script.replace(f"@{mark}@", str(value))
        with tempfile.TemporaryDirectory(prefix="gasgrain-test-") as folder:
            (Path(folder) / "in.lammps").write_text(script)
            done = subprocess.run(["lmp", "-in", "in.lammps", "-log", "none"], cwd=folder, capture_output=True,
                                  text=True, timeout=60, check=False)
            dump = Path(folder) / "dump.txt"
            rows = dump.read_text().splitlines()[9:] if dump.exists() else []
        return done.returncode, done.stdout + done.stderr, [tuple(map(float, row.split()[1:])) for row in rows]

    def forces(self, *args, **options):
        status, text, rows = self.lmp(*args, **options)
        self.assertEqual(status, 0, text)
        return rows

    def refused(self, told, **options):
        status, text, _ = self.lmp(InLiggghts.pairs(), **options)
        self.assertNotEqual(status, 0, text)
        for words in told:
            self.assertIn(words, text)

    def test_two_grains_are_pulled_together_up_to_the_greatest_gap(self):
        forces = self.forces(InLiggghts.pairs())
        for n in range(0, 8, 2):
            self.assertEqual(forces[n][0], -forces[n + 1][0])
        self.expect([forces[n][0] for n in range(0, 8, 2)], R1 * R2 / (R1 + R2))

    def test_a_wall_pulls_too(self):
        grains = [(0.0004 + 0.0003 * n, 0.001, R1 + gap, 2 * R1, 1) for n, gap in enumerate(GAPS)]
        forces = self.forces(grains, wall="fix floor all wall/gran/bridge @model@ primitive type 1 zplane 0.0")
        self.expect([-force[2] for force in forces], R1)

    def test_a_misspelt_word_is_told_with_the_nearest(self):
        self.refused(['"greatest_gp"', 'Did you mean "greatest_gap"?'], words="greatest_gp 5e-7")

    def test_a_misspelt_law_is_told_with_the_nearest(self):
        self.refused(['Did you mean "constant_pull"?'],
                     model="model hertz tangential history cohesion constant_pul")

    def test_a_misspelt_property_is_told_with_the_nearest(self):
        self.refused(["cohesion constant_pull", "it needs the property pullForce", 'has "pullForc": is it misspelt?'],
                     properties=PROPERTY.replace("pullForce", "pullForc"))

    def test_it_may_be_loaded_again(self):
        again = f"{PROPERTY}\nplugin load {LIBRARY['lammps']}"
        self.assertEqual(self.forces(InLiggghts.pairs(), properties=again), self.forces(InLiggghts.pairs()))

    def test_the_library_of_the_other_host_is_refused(self):
        self.refused(["is built for liggghts, and this is lammps"], library=LIBRARY["liggghts"])


class InTheDocuments(unittest.TestCase):
    def test_the_page_shows_the_example_as_it_is(self):
        page = (SOURCE / "docs" / "adding-a-law.md").read_text()
        for name in ("cohesion_constant_pull.h", "CMakeLists.txt"):
            self.assertIn((EXAMPLE / name).read_text(), page)


del Law  # has no tests of its own

if __name__ == "__main__":
    unittest.main()
