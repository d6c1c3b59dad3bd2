#!/usr/bin/python3
"""tools/report.py on particle files made by LIGGGHTS itself, ASCII and binary."""

import importlib
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

REPORT = Path(sys.argv.pop(1) if len(sys.argv) > 1 else "tools/report.py").resolve()
sys.dont_write_bytecode = True
sys.path.insert(0, str(REPORT.parent))
report_read = importlib.import_module("report_read")
report_bed = importlib.import_module("report_bed")

# Two particles, of which one is faster than the other.
SCRIPT = """
atom_style granular
atom_modify map array
boundary f f f
newton off
communicate single vel yes
units si
region box block 0 0.1 0 0.05 0 0.4 units box
create_box 1 box
neighbor 0.005 bin
fix m1 all property/global youngsModulus peratomtype 5.e6
fix m2 all property/global poissonsRatio peratomtype 0.45
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.95
fix m4 all property/global coefficientFriction peratomtypepair 1 0.05
pair_style gran model hertz tangential history
pair_coeff * *
timestep 1e-5
create_atoms 1 single 0.05 0.02 0.05
create_atoms 1 single 0.02 0.04 0.1
group fast region NAME
set group all density 2500 diameter 0.01
set group fast density 2500 diameter 0.02
velocity fast set 0.3 0.0 0.4
fix move all nve/sphere
dump d all custom/vtk 100 particles/p_*.vtk id type x y z vx vy vz radius
dump_modify d binary KIND
run 1000
""".replace("group fast region NAME", "region upper block 0 0.1 0 0.05 0.08 0.4 units box\n"
            "group fast region upper")

PNG_START = b"\x89PNG"


def make_results(folder, kind):
    (folder / "particles").mkdir(parents=True)
    (folder / "in.liggghts").write_text(SCRIPT.replace("KIND", kind))
    subprocess.run(["liggghts", "-in", "in.liggghts", "-screen", "none", "-log", "none"], cwd=folder,
                   check=True, stdout=subprocess.DEVNULL)
    plan = {"first_step": 0, "last_step": 1000, "start_step": 200, "dt_s": 1e-5, "time_end_s": 0.008}
    (folder / "run.json").write_text(json.dumps(plan))
    lines = ["step,time_s,bed_height_m,bubble_diameter_m,kinetic_energy_J,p_0.1m_Pa,ledger_residual"]
    lines += [f"{step},{(step - 200) * 1e-5},0.1,0.02,0.5,100,1e-15" for step in range(0, 1001, 100)]
    (folder / "history.csv").write_text("\n".join(lines) + "\n")


def run_report(*arguments):
    return subprocess.run(["/usr/bin/python3", "-B", REPORT, *arguments], text=True,
                          capture_output=True)


class Report(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.top = Path(self.folder.name)

    def tearDown(self):
        self.folder.cleanup()

    def test_particles_are_read_from_ascii_and_binary_files_alike(self):
        for kind in ("no", "yes"):
            with self.subTest(binary=kind):
                make_results(self.top / kind, kind)
                file = self.top / kind / "particles/p_1000.vtk"
                centres, radii, speeds = report_read.read_particles(file)
                fast = np.argmax(speeds)
                self.assertAlmostEqual(speeds[fast], 0.5, places=12)
                self.assertAlmostEqual(radii[fast], 0.01, places=12)
                # Positions are single precision in these files.
                np.testing.assert_allclose(centres[fast], [0.023, 0.04, 0.104], rtol=1e-6)
                self.assertEqual(report_read.read_box(file), [(0, 0.1), (0, 0.05), (0, 0.4)])

    def test_a_run_gets_its_pictures_and_its_index(self):
        make_results(self.top, "no")
        done = run_report(self.top)
        self.assertEqual(done.returncode, 0, done.stderr)
        for name in ("history.png", "bed.png"):
            self.assertEqual((self.top / name).read_bytes()[:4], PNG_START)
        files = json.loads((self.top / "particles.vtk.series").read_text())["files"]
        self.assertEqual(len(files), 11)
        self.assertEqual(files[0]["name"], "particles/p_0.vtk")
        self.assertAlmostEqual(files[0]["time"], -0.002)
        self.assertAlmostEqual(files[-1]["time"], 0.008)
        self.assertTrue((self.top / files[-1]["name"]).exists())

    def test_snapshots_span_the_gas_stage_alone(self):
        files = [(0.1 * n, n) for n in range(-5, 31)]
        picked = [time for time, _ in report_bed.pick(files)]
        self.assertEqual(len(picked), 8)
        self.assertEqual((picked[0], picked[-1]), (0.0, 3.0))

    def test_lines_that_a_restart_repeats_count_once(self):
        (self.top / "history.csv").write_text("time_s,a\n0,1\n1,2\n2,3\n1,4\n2,5\n3,6\n")
        history = report_read.read_history(self.top)
        self.assertEqual(list(history["time_s"]), [0, 1, 2, 3])
        self.assertEqual(list(history["a"]), [1, 4, 5, 6])

    def test_what_is_absent_is_named(self):
        done = run_report(self.top)
        self.assertEqual(done.returncode, 1)
        self.assertIn("history.csv cannot be read", done.stderr)
        self.assertIn("run.json cannot be read", done.stderr)
        self.assertNotIn("Traceback", done.stderr)

    def test_two_runs_are_drawn_beside_published_points(self):
        for name in ("dry", "wet"):
            make_results(self.top / name, "no")
        data = self.top / "points.csv"
        data.write_text("case,quantity,time_s,value_m\ndry,bed_height,0.001,0.1\n"
                        "wet,bubble_diameter,0.002,0.02\n")
        picture = self.top / "compared.png"
        arguments = ("--compare", self.top / "dry", self.top / "wet", "--data", data, "--out", picture)
        done = run_report(*arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(picture.read_bytes()[:4], PNG_START)
        data.write_text("case,quantity,time_s,value_m\ndry,bed_hieght,0.001,0.1\n")
        done = run_report(*arguments)
        self.assertIn('the quantity "bed_hieght" is unknown', done.stderr)


if __name__ == "__main__":
    unittest.main()
