#!/usr/bin/python3
"""`gasgrain calibrate`: a bouncing sphere's restitution found through the real programs; then, with a
script that plays LIGGGHTS, runs that scatter and fail, several at a time, stopped and gone on with."""

import csv
import json
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

BUILD = Path(sys.argv.pop(1) if len(sys.argv) > 1 else "build").resolve()
SCENES = Path(__file__).resolve().parents[2] / "inputs/calibration"

# Notes when it runs, takes PLAYED_S, and leaves the dump of one grain that hits a plate at 1 m/s and
# leaves it at friction + scatter, which is set by the seed.
DEM = r"""#!/usr/bin/python3
import os, sys, time
from pathlib import Path
words = sys.argv[1:]
given = {words[n + 1]: words[n + 2] for n in range(len(words) - 2) if words[n] == "-var"}
notes = Path(os.environ["NOTES"])
start = time.time()
friction, seed = float(given["friction"]), int(given.get("seed", "0"))
if friction > float(os.environ.get("FAILS_ABOVE", "9")):
    print("ERROR: Neighbor list overflow (neigh.cpp:1)")
    sys.exit(4)
time.sleep(float(os.environ.get("PLAYED_S", "0")))
rebound = friction + (0.004 * (seed % 7 - 3) if "seed" in given else 0)
rows = {0: -1.0, 1: rebound}
with open(Path(given["out"]) / "particles/bounce.dump", "w") as dump:
    for step, speed in rows.items():
        dump.write("ITEM: TIMESTEP\n%d\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS ff ff ff\n" % step)
        dump.write("0 1\n0 1\n0 1\nITEM: ATOMS id x y z vx vy vz radius\n")
        dump.write("1 0 0 0.5 0 0 %r 0.1\n" % speed)
with open(notes / "runs", "a") as file:
    file.write("%r %r %s %s\n" % (start, time.time(), given["friction"], given.get("quick", "-")))
"""


class Calibrate(unittest.TestCase):
    def setUp(self):
        self.top = Path(tempfile.mkdtemp(prefix="gasgrain-calibrate-"))
        self.out = self.top / "out"
        self.scene = self.top / "inputs/bounce"
        self.scene.mkdir(parents=True)
        self.write_scene("variable friction index 0.5\nvariable seed index 5331\n"
                         "variable quick index 0\nrun 1\n")
        (self.scene / "measure.toml").write_text('[measure]\nkind = "normal_restitution"\n')
        (self.top / "bin").mkdir()
        (self.top / "bin/gasgrain-liggghts").write_text(DEM)
        (self.top / "bin/gasgrain-liggghts").chmod(0o755)

    def tearDown(self):
        shutil.rmtree(self.top)

    def write_scene(self, text):
        (self.scene / "in.liggghts").write_text(text)

    def environment(self, **more):
        return {**os.environ, "GASGRAIN_BIN_DIR": str(self.top / "bin"), "NOTES": str(self.top),
                **more}

    def command(self, *options, scene=None):
        return [str(BUILD / "gasgrain"), "calibrate", str(scene or self.scene), "--out",
                str(self.out), *options]

    def calibrate(self, *options, **environment):
        done = subprocess.run(self.command(*options), capture_output=True, text=True, timeout=120,
                              env=self.environment(**environment), check=False)
        return done.returncode, done.stdout, done.stderr

    def rows(self):
        with open(self.out / "calibration.csv", newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def played(self):
        """Start, end, friction and quick of each run that the script has played."""
        file = self.top / "runs"
        lines = [line.split() for line in file.read_text().splitlines()] if file.exists() else []
        return [(float(start), float(end), friction, quick) for start, end, friction, quick in lines]

    def test_restitution_is_found_through_the_real_programs(self):
        done = subprocess.run(
            self.command("--target", "normal_restitution=0.7", "--vary", "restitution=0.4:0.95",
                         "--tolerance", "0.005", "--quick", scene=SCENES / "bouncing_sphere"),
            capture_output=True, text=True, timeout=120, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        result = json.loads((self.out / "calibration.json").read_text())
        self.assertTrue(result["met"])
        # The contact model gives its own coefficient back to within the error of the step, which
        # the scene keeps below 0.005 as well.
        self.assertAlmostEqual(result["parameters"][0]["value"], 0.7, delta=0.01)
        self.assertAlmostEqual(result["targets"][0]["mean"], 0.7, delta=0.005)
        self.assertAlmostEqual(result["targets"][0]["slopes"][0], 1.0, delta=0.1)
        rows = self.rows()
        self.assertEqual(list(rows[0]),
                         ["run", "point", "restitution", "seed", "normal_restitution", "wall_s"])
        # Nothing scatters: two ends and one or two points between them.
        self.assertLessEqual(len(rows), 5)
        self.assertEqual({row["seed"] for row in rows}, {""})
        value = rows[-1]["restitution"]
        script = (self.out / "calibrated.txt").read_text()
        self.assertIn(f"\nvariable restitution index {value}\n", script)
        self.assertIn(f"restitution = {value}", done.stdout)
        self.assertGreater((self.out / "calibration.png").stat().st_size, 10000)

    def test_repeats_run_two_at_a_time_and_give_mean_and_standard_error(self):
        status, out, err = self.calibrate("--target", "normal_restitution=0.4", "--vary",
                                          "friction=0.1:0.8", "--seeds", "4", "--quick",
                                          "--no-plots", PLAYED_S="0.4")
        self.assertEqual(status, 0, out + err)
        self.assertFalse((self.out / "calibration.png").exists())
        runs = self.played()
        self.assertEqual({run[3] for run in runs}, {"1"})  # the quick preset
        at_a_time = [sum(other[0] <= run[0] < other[1] for other in runs) for run in runs]
        self.assertEqual(max(at_a_time), 2)
        result = json.loads((self.out / "calibration.json").read_text())
        value = result["parameters"][0]["value"]
        own = [float(row["normal_restitution"]) for row in self.rows()
               if float(row["friction"]) == value]
        self.assertEqual(len(own), 4)
        mean = sum(own) / 4
        self.assertAlmostEqual(result["targets"][0]["mean"], mean, delta=1e-6)
        self.assertAlmostEqual(result["targets"][0]["standard_error"],
                               (sum((x - mean) ** 2 for x in own) / 3 / 4) ** 0.5, delta=1e-5)
        self.assertEqual(len({row["seed"] for row in self.rows()}), 4)
        # The quantity is the parameter and a scatter: the one's error is the other's.
        self.assertGreater(result["parameters"][0]["standard_error"], 0.0)
        self.assertAlmostEqual(result["targets"][0]["slopes"][0], 1.0, delta=0.05)

    def test_target_out_of_reach_ends_with_the_range_that_was_reached(self):
        status, out, err = self.calibrate("--target", "normal_restitution=0.9", "--vary",
                                          "friction=0.1:0.5", "--no-plots")
        self.assertEqual(status, 2, out + err)
        self.assertIn("normal_restitution = 0.9 is out of reach for friction from 0.1 to 0.5: "
                      "normal_restitution reached from", err)
        self.assertIn("widen --vary friction", err)
        self.assertFalse((self.out / "calibrated.txt").exists())
        self.assertEqual(len(self.rows()), 5)

    def test_results_of_an_earlier_calibration_do_not_stay(self):
        status, out, err = self.calibrate("--target", "normal_restitution=0.4", "--vary",
                                          "friction=0.1:0.5", "--seeds", "1")
        self.assertEqual(status, 0, out + err)
        self.assertTrue((self.out / "calibration.png").exists())
        status, out, err = self.calibrate("--target", "normal_restitution=0.9", "--vary",
                                          "friction=0.1:0.5", "--no-plots")
        self.assertEqual(status, 2, out + err)
        for name in ("calibrated.txt", "calibration.png"):
            self.assertFalse((self.out / name).exists(), name)
        self.assertFalse(json.loads((self.out / "calibration.json").read_text())["met"])

    def test_failed_run_is_told_with_its_values_and_reason(self):
        status, out, err = self.calibrate("--target", "normal_restitution=0.4", "--vary",
                                          "friction=0.1:0.8", FAILS_ABOVE="0.7", PLAYED_S="20")
        self.assertEqual(status, 1, out + err)
        self.assertIn("gasgrain: error: the run with friction=0.8 seed=5331 failed: ", err)
        self.assertIn("LIGGGHTS: ERROR: Neighbor list overflow", err)
        self.assertEqual(self.played(), [])  # its neighbour was ended, not waited for

    def test_quantity_that_is_not_measured_is_told_with_the_nearest(self):
        status, _, err = self.calibrate("--target", "normal_restitutoin=0.4", "--vary",
                                        "friction=0.1:0.8")
        self.assertEqual(status, 1)
        self.assertIn('"normal_restitutoin" is not measured by this scene. '
                      'Did you mean "normal_restitution"?', err)

    def test_faults_of_request_and_scene_are_told_together(self):
        (self.scene / "measure.toml").write_text('[measure]\nkind = "normal_restitutoin"\n')
        status, _, err = self.calibrate("--target", "normal_restitution=x", "--vary",
                                        "frction=0.8:0.1")
        self.assertEqual(status, 1)
        for part in ("measure.toml:2", "--target normal_restitution=x: write it as NAME=VALUE",
                     "the lower end must be below the upper", 'Did you mean "friction"?'):
            self.assertIn(part, err)
        (self.scene / "measure.toml").unlink()
        status, _, err = self.calibrate("--target", "a=1", "--vary", "friction=0.1:0.8")
        self.assertEqual(status, 1)
        self.assertIn("measure.toml is absent: the scene measures nothing", err)
        self.out = Path("/proc/calibration")
        (self.scene / "measure.toml").write_text('[measure]\nkind = "normal_restitution"\n')
        status, _, err = self.calibrate("--target", "a=1", "--vary", "friction=0.1:0.8")
        self.assertEqual(status, 1)
        self.assertIn("/proc/calibration cannot be written", err)
        self.assertIn("Choose another folder: --out DIR", err)
        self.assertEqual(self.played(), [])

    def test_control_c_ends_it_and_the_same_command_goes_on(self):
        options = ("--target", "normal_restitution=0.4", "--vary", "friction=0.1:0.8", "--no-plots")
        with subprocess.Popen(self.command(*options), stdout=subprocess.PIPE, text=True,
                              stderr=subprocess.STDOUT,
                              env=self.environment(PLAYED_S="1")) as process:
            while len(self.played()) < 2:  # both ends
                time.sleep(0.05)
            time.sleep(0.3)
            process.send_signal(signal.SIGINT)
            out = process.communicate(timeout=60)[0]
        self.assertEqual(process.returncode, 130, out)
        self.assertIn("the same command goes on from here", out)
        before = len(self.played())
        status, out, err = self.calibrate(*options)
        self.assertEqual(status, 0, out + err)
        # The ends, which were done, are not run again.
        self.assertEqual([run[2] for run in self.played()[before:] if run[2] in ("0.1", "0.8")], [])
        self.assertEqual([row["friction"] for row in self.rows()][:2], ["0.1", "0.8"])

    def test_help_tells_the_options(self):
        done = subprocess.run([str(BUILD / "gasgrain"), "calibrate", "--help"], capture_output=True,
                              text=True, timeout=20, check=True)
        for option in ("--target", "--vary", "--tolerance", "--seeds", "--quick", "--jobs"):
            self.assertIn(option, done.stdout)


if __name__ == "__main__":
    unittest.main()
