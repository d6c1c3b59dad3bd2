#!/usr/bin/python3
"""Every in.lammps of inputs/: each of its lines is taken by lmp, its runs cut to a step; two run in full."""

import csv
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

BIN = Path(sys.argv.pop(1) if len(sys.argv) > 1 else "build").resolve()
SOURCE = Path(__file__).resolve().parents[2]
SCENES = sorted(script.parent for script in (SOURCE / "inputs").rglob("in.lammps"))
ENVIRONMENT = dict(os.environ, OMPI_MCA_mpi_yield_when_idle="1", OMP_NUM_THREADS="1",
                   OMPI_MCA_btl_vader_single_copy_mechanism="none")


def launch(scene, out):
    """`gasgrain run`'s own command with lmp's option that leaves each run after a step."""
    lmp = ["-np", "1", "lmp"]
    words = ["-skiprun", "-in", "in.lammps", "-log", "none", "-var", "out", out, "-var", "gasgrain",
             BIN / "gasgrain.lmp"]
    if (scene / "gas.toml").is_file():
        lmp += ["-m", "0", *words, ":", "-np", "1", BIN / "gasgrain-gas", "gas.toml", "--out", out]
    else:
        lmp += [*words, "-var", "quick", "1"]
    return ["mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none", *map(str, lmp)]

IN_FULL = "calibration/uniaxial_compression"


class Scenes(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory(prefix="gasgrain-lammps-scenes-")
        self.out = Path(self.temporary.name)
        for part in ("particles", "checkpoint", "pairs"):
            (self.out / part).mkdir()

    def tearDown(self):
        self.temporary.cleanup()

    def test_all_scenes_are_there(self):
        names = {scene.name for scene in SCENES}
        self.assertLessEqual({"spouted_bed", "spouted_bed_slow", "spouted_bed_small", "packed_bed",
                              "wet_fluidised_bed", "channel_injection", "rotating_drum"}, names)
        calibration = SOURCE / "inputs/calibration"
        self.assertEqual([scene.name for scene in calibration.iterdir()
                          if scene.is_dir() and not (scene / "in.lammps").is_file()], [])

    def run_scene(self, scene, *words):
        done = subprocess.run([BIN / "gasgrain", "run", SOURCE / "inputs" / scene, "--host", "lammps", "--no-plots",
                               "--out", self.out, *words], env=ENVIRONMENT, capture_output=True, text=True,
                              timeout=200, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout

    def test_a_coupled_scene_runs_through_the_command(self):
        self.run_scene("packed_bed", "--time", "0.01", "--dem-ranks", "2")
        with open(self.out / "history.csv", encoding="ascii") as file:
            rows = list(csv.DictReader(file))
        self.assertLess(abs(float(rows[-1]["ledger_residual"])), 1e-12)
        self.assertTrue((self.out / "particles/p_100.vtk").is_file())

    def test_a_calibration_scene_measures_what_it_was_given(self):
        text = self.run_scene("calibration/bouncing_sphere", "--set", "quick=1", "--set", "restitution=0.8")
        measured = float(text.split("normal_restitution")[1].split()[0])
        self.assertAlmostEqual(measured, 0.8, delta=0.002)  # of the step's length

    def test_listed_pairs_hold_the_liquid_of_the_bridges(self):
        self.run_scene("wet_fluidised_bed", "--set", "content=0.01", "--set", "packing=0.02", "--time", "0.001",
                       "--dem-ranks", "2")
        with open(self.out / "liquid.csv", encoding="ascii") as file:
            row = next(row for row in csv.DictReader(file) if row["step"] == "500")
        lines = (self.out / "pairs/pairs_500.txt").read_text().splitlines()
        volumes = [float(line.split()[2]) for line in lines[9:]]
        total = sum(volume for volume in volumes if volume > 0.0)  # below 0: asked for, not there yet
        self.assertGreater(total, 0.0)
        self.assertAlmostEqual(total / float(row["bridges"]), 1.0, delta=1e-6)  # six digits are written of each

    def test_the_plate_comes_down_until_it_feels_the_stress(self):
        # Its script asks between runs for what only a whole run leaves behind.
        text = self.run_scene(IN_FULL, "--set", "quick=1")
        solids = float(text.split("solid_fraction")[1].split()[0])
        self.assertTrue(0.58 < solids < 0.64, text)  # of a random packing of two sizes


def taken(scene):
    def test(self):
        done = subprocess.run(launch(scene, self.out), cwd=scene, env=ENVIRONMENT, capture_output=True, text=True,
                              stdin=subprocess.DEVNULL, timeout=120, check=False)
        self.assertEqual(done.returncode, 0, (done.stdout + done.stderr)[-3000:])
    return test


for each in SCENES:
    if each.name != Path(IN_FULL).name:
        setattr(Scenes, f"test_lmp_takes_{each.name}", taken(each))

if __name__ == "__main__":
    unittest.main(verbosity=2)
