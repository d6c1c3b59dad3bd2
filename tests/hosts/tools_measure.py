#!/usr/bin/python3
"""Scenes of grains alone through the real programs: what `gasgrain run` measures of them against what
was set, and how it refuses."""

import csv
import math
import os
import signal
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

from coupled_launch import BIN, SOURCE

SCENES = SOURCE / "inputs/calibration"
KINDS = {"agglomerate_impact", "angle_of_repose_drained", "angle_of_repose_pile", "bouncing_sphere", "oblique_impact",
         "rotating_drum", "shear_cell", "two_sphere_pull", "uniaxial_compression"}

# One grain that falls for ever: what stops and fails is tried on it.
FALL = """\
variable out index results
variable steps index 100
variable friction index 0.5
atom_style granular
atom_modify map array
units si
boundary f f p
newton off
communicate single vel yes
region box block 0 0.01 0 0.01 0 0.01 units box
create_box 1 box
create_atoms 1 single 0.005 0.005 0.005 units box
set group all diameter 0.002 density 2500
neighbor 0.001 bin
timestep 1e-6
fix youngs all property/global youngsModulus peratomtype 5e6
fix poisson all property/global poissonsRatio peratomtype 0.25
fix restitution all property/global coefficientRestitution peratomtypepair 1 0.9
fix friction all property/global coefficientFriction peratomtypepair 1 ${friction}
pair_style gran/bridge model hertz tangential history
pair_coeff * *
fix motion all nve/sphere
thermo 1000
run ${steps}
"""


class Measuring(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.top = Path(self.folder.name)
        self.out = self.top / "out"

    def tearDown(self):
        self.folder.cleanup()

    def command(self, scene, *options):
        return [str(BIN / "gasgrain"), "run", str(scene), "--out", str(self.out), *options]

    def run_scene(self, scene, *options):
        done = subprocess.run(self.command(scene, *options), capture_output=True, text=True,
                              timeout=120, check=False)
        return done.returncode, done.stdout, done.stderr

    def measured(self, name, *options):
        """Value and uncertainty by quantity."""
        status, out, err = self.run_scene(SCENES / name, *options)
        self.assertEqual(status, 0, out + err)
        with open(self.out / "measured.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(list(rows[0]), ["quantity", "value", "unit", "uncertainty"])
        for row in rows:
            self.assertIn(row["quantity"], out)
        return {row["quantity"]: (float(row["value"]), float(row["uncertainty"])) for row in rows}

    def curve(self):
        with open(self.out / "measured_curve.csv", newline="", encoding="utf-8") as file:
            return [{name: float(text or "nan") for name, text in row.items()}
                    for row in csv.DictReader(file)]

    def scene(self, script=FALL, measure=None):
        folder = self.top / "fall"
        folder.mkdir(exist_ok=True)
        (folder / "in.liggghts").write_text(script)
        if measure:
            (folder / "measure.toml").write_text(measure)
        return folder

    def test_every_scene_has_its_three_files_and_a_quick_dial(self):
        self.assertEqual({scene.name for scene in SCENES.iterdir()}, KINDS)
        for scene in SCENES.iterdir():
            for name in ("in.liggghts", "measure.toml", "README.md"):
                self.assertTrue((scene / name).is_file(), scene / name)
            self.assertFalse((scene / "gas.toml").exists())
            script = (scene / "in.liggghts").read_text()
            for dial in ("out", "quick", "friction", "restitution"):
                self.assertRegex(script, rf"variable\s+{dial}\s+index")

    def test_a_bouncing_sphere_has_the_restitution_that_was_set(self):
        for restitution in (0.9, 0.5):
            e, error = self.measured("bouncing_sphere", "--set", "quick=1", "--no-plots", "--set",
                                     f"restitution={restitution}")["normal_restitution"]
            # The host's damping is that of the analytic solution; an impact lasts 160 steps, and
            # where in a step it ends is worth 1e-4.
            self.assertAlmostEqual(e, restitution, delta=1e-3)
            self.assertLess(error, 1e-3)

    def test_oblique_impacts_that_slide_lie_on_the_line_of_rigid_spheres(self):
        friction = 0.3
        measured = self.measured("oblique_impact", "--set", "quick=1", "--set",
                                 f"friction={friction}")
        # The host's sliding force is mu |F_n|, also in the last moment of a contact, in which its
        # damping pulls (F_n < 0): 0.4 % too much impulse with a restitution of 0.9.
        self.assertAlmostEqual(measured["sliding_friction"][0], friction, delta=0.01 * friction)
        self.assertAlmostEqual(measured["normal_restitution"][0], 0.9, delta=1e-3)
        self.assertTrue((self.out / "measured.png").is_file())
        rows = self.curve()
        sliding = [row for row in rows if row["impact_angle_degree"] > 65]
        self.assertGreater(len(sliding), 3)
        for row in sliding:
            line = 1 - friction * 1.9 / math.tan(math.radians(row["impact_angle_degree"]))
            self.assertAlmostEqual(row["tangential_restitution"], line, delta=0.005)
        # With nu = 0.25 an elastic sphere slides throughout from tan(angle) = 5.83 mu on, 60.3
        # degrees (Maw, Barber, Fawcett 1976); the quick preset's impacts are 3.7 degrees apart.
        first = next(row for row in rows if row["impulse_ratio"] > 0.99 * friction)
        self.assertAlmostEqual(first["impact_angle_degree"], 60.3, delta=3.7)
        # Of steep impacts friction needs less than that: they leave the line.
        for row in rows:
            if row["impact_angle_degree"] < 50:
                self.assertLess(row["impulse_ratio"], 0.95 * friction)

    def test_a_bridge_pulled_apart_has_the_force_and_work_of_its_law(self):
        """The energy form of Rabinovich et al. 2005, which has an integral: (1 + theta / 2) V^(1/3) is its end."""
        radius, volume, tension, theta = 1e-3, 1e-12, 0.05, 0.5
        measured = self.measured("two_sphere_pull", "--no-plots", "--set", "law=rabinovich_energy", "--set",
                                 f"surface_tension={tension}", "--set", f"contact_angle={theta}")
        contact = 2 * math.pi * radius * tension * math.cos(theta)
        end = (1 + theta / 2) * volume**(1 / 3)
        q = 2 * volume / (math.pi * radius)
        # s / (s + 2 d) with 2 d = (s^2 + q)^(1/2) - s: F = contact (1 - s / (s^2 + q)^(1/2))
        work = contact * (end - math.sqrt(end**2 + q) + math.sqrt(q))
        # The first reading is of a gap of 4e-8 m, the others are 5e-8 m apart.
        self.assertAlmostEqual(measured["greatest_force"][0], contact, delta=2e-3 * contact)
        self.assertAlmostEqual(measured["rupture_distance"][0], end, delta=1e-7)
        self.assertAlmostEqual(measured["pull_energy"][0], work, delta=2e-3 * work)

    def test_a_harder_impact_breaks_more_of_an_agglomerate(self):
        damage = [self.measured("agglomerate_impact", "--no-plots", "--set", "quick=1", "--set", f"speed={speed}")["damage_ratio"][0]
                  for speed in (0.2, 1.0)]
        self.assertLess(damage[0], 0.4)
        self.assertGreater(damage[1], 0.7)

    def test_a_wet_grain_bounces_less(self):
        wet = self.measured("bouncing_sphere", "--no-plots", "--set", "quick=1", "--set", "film=1e-10", "--set",
                            "contact=hertz tangential history cohesion bridge")
        self.assertLess(wet["normal_restitution"][0], 0.85)
        self.assertGreater(wet["normal_restitution"][0], 0.3)

    def test_more_friction_shears_harder(self):
        # Drawn twice as fast as usual: half the time, and still slow (inertial number 0.014).
        angles = [self.measured("shear_cell", "--set", "quick=1", "--no-plots", "--set", "speed=0.2",
                                "--set", f"friction={friction}")["internal_friction_angle"]
                  for friction in (0.1, 0.5)]
        # 15 and 23 degrees, each to a degree or so.
        self.assertGreater(angles[1][0] - angles[0][0], 3.0 * (angles[0][1] + angles[1][1]))

    def test_what_a_scene_without_gas_cannot_have_is_refused_with_the_reason(self):
        status, _, err = self.run_scene(self.scene(), "--gas-ranks", "1", "--restart", "--time", "2",
                                        "--set", "frction=0.3")
        self.assertEqual(status, 1)
        self.assertIn("--gas-ranks:", err)
        self.assertIn("no gas.toml: there is no gas", err)
        self.assertIn("--restart:", err)
        self.assertIn("--time:", err)
        self.assertIn("no line 'variable frction index ...'. Did you mean \"friction\"?", err)
        self.assertFalse(self.out.exists(), "a refused run must leave no trace")

    def test_a_bare_name_is_answered_with_the_scene(self):
        status, _, err = self.run_scene("shear_cel")
        self.assertEqual(status, 1)
        self.assertRegex(err, 'Did you mean ".*inputs/calibration/shear_cell"')

    def test_a_setting_that_is_no_pair_is_refused(self):
        for word in ("friction", "=0.3"):
            status, _, err = self.run_scene(self.scene(), "--set", word)
            self.assertNotEqual(status, 0)
            self.assertIn("must read NAME=VALUE", err)

    def test_faults_of_measure_toml_are_told_before_the_run(self):
        status, _, err = self.run_scene(
            self.scene(measure='[measure]\nkind = "angle_of_repose"\nsektors = 8\n'))
        self.assertEqual(status, 1)
        self.assertIn("measure.toml:3: the key measure.sektors is unknown. "
                      "Did you mean \"sectors\"?", err)
        self.assertFalse(self.out.exists())

    def test_a_run_that_leaves_nothing_to_measure_fails_and_says_so(self):
        status, out, err = self.run_scene(self.scene(measure='[measure]\nkind = "angle_of_repose"\n'))
        self.assertEqual(status, 1)
        self.assertIn("nothing was measured", err)
        self.assertIn("heap.dump is absent", err)
        self.assertFalse((self.out / "measured.csv").exists(), out)

    def test_what_an_earlier_run_measured_is_not_left_behind(self):
        self.measured("bouncing_sphere", "--set", "quick=1", "--no-plots")
        status, _, _ = self.run_scene(self.scene(measure='[measure]\nkind = "angle_of_repose"\n'))
        self.assertEqual(status, 1)
        self.assertFalse((self.out / "measured.csv").exists())

    def test_a_scene_without_measure_toml_just_runs(self):
        status, out, err = self.run_scene(self.scene())
        self.assertEqual(status, 0, err)
        self.assertNotIn("Measured", out)

    def test_an_error_of_the_script_is_passed_on(self):
        status, _, err = self.run_scene(self.scene(FALL + "fix x all nonsense\n"))
        self.assertNotEqual(status, 0)
        self.assertIn("nonsense", err)

    def test_control_c_ends_it_and_nothing_is_measured(self):
        scene = self.scene(measure='[measure]\nkind = "angle_of_repose"\n')
        process = subprocess.Popen(self.command(scene, "--set", "steps=1000000000"), text=True,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                   start_new_session=True)
        log = self.out / "run.log"
        end = time.time() + 30
        while not (log.exists() and "Step" in log.read_text()):
            self.assertLess(time.time(), end, "the run did not start")
            time.sleep(0.1)
        os.kill(process.pid, signal.SIGINT)
        out, _ = process.communicate(timeout=30)
        self.assertEqual(process.returncode, 130, out)
        self.assertIn("Nothing was measured", out)
        self.assertNotIn("checkpoint", out)


if __name__ == "__main__":
    unittest.main()
