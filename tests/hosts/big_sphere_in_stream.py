#!/usr/bin/python3
"""The big sphere in a stream with the real program, and `gasgrain analyse` of it: momentum, the force
of a thin beam, means over all steps."""

import csv
import math
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

from coupled_launch import BIN, SOURCE

SCENE = SOURCE / "inputs/big_sphere_in_stream"
SMALL = 5e-4
DENSITY = 2500.0
SPEED = 0.5
MASS = DENSITY * math.pi / 6 * SMALL**3
# 275 small spheres, all within the dumped cube from 11 ms on until the end.
SHORT = {"softened": 100, "size_ratio": 5, "stream_width": 0.006, "fraction": 0.1, "length": 0.005, "reach": 0.012,
         "duration": 0.04}


def frames(folder):
    """(step, rows by column's name) of every dump, in their order."""
    found = []
    for file in (folder / "particles").glob("grains.*.dump"):
        lines = file.read_text().splitlines()
        names = lines[8].split()[2:]
        found.append((int(lines[1]), [dict(zip(names, map(float, line.split()))) for line in lines[9:]]))
    return sorted(found, key=lambda frame: frame[0])


def facts(folder):
    return {name: float(value) for name, value in re.findall(r"(\w+) = (\S+)", (folder / "analyse.toml").read_text())}


class BigSphereInStream(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.top = Path(self.folder.name)

    def tearDown(self):
        self.folder.cleanup()

    def command(self, *words):
        return subprocess.run([str(BIN / "gasgrain"), *map(str, words)], capture_output=True, text=True, timeout=200,
                              check=False)

    def run_scene(self, name, dials):
        out = self.top / name
        settings = [word for dial, value in dials.items() for word in ("--set", f"{dial}={value}")]
        done = self.command("run", SCENE, "--out", out, *settings)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return out

    def analyse(self, folder, *options):
        """Rows of solid_drag_windows.csv and of solid_drag.csv."""
        done = self.command("analyse", folder, *options)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("the means over all steps", done.stdout)
        tables = []
        for name in ("solid_drag_windows.csv", "solid_drag.csv"):
            with open(folder / name, newline="", encoding="utf-8") as file:
                tables.append(list(csv.DictReader(file)))
        return tables

    def test_what_the_big_sphere_feels_is_what_the_small_ones_lose(self):
        out = self.run_scene("momentum", SHORT)
        step = facts(out)["timestep"]
        self.assertAlmostEqual(step, 2.5e-6, delta=1e-12)
        given = [0.0, 0.0, 0.0]
        last = 0
        start = None
        for now, grains in frames(out):
            big = [grain for grain in grains if grain["type"] == 2]
            small = [grain for grain in grains if grain["type"] == 1]
            self.assertEqual(len(big), 1)
            for n, axis in enumerate("xyz"):
                self.assertEqual(big[0][axis], 0.0, "it is held")
                given[n] += (now - last) * step * big[0][f"f_mean[{n + 1}]"]
            last = now
            if start is None and len(small) == 275:
                self.assertEqual(given, [0.0, 0.0, 0.0], "the stream has not arrived")
                start = [MASS * sum(grain["v" + axis] for grain in small) for axis in "xyz"]
        self.assertEqual(len(small), 275, "none has left")
        end = [MASS * sum(grain["v" + axis] for grain in small) for axis in "xyz"]
        impulse = abs(given[2])
        self.assertGreater(impulse, 0.1 * abs(start[2]))
        for n in range(3):
            # Dumps have six digits: 275 velocities to 1e-6 m/s at the most, forces to 1e-6 of theirs.
            self.assertAlmostEqual(start[n] - end[n], given[n], delta=1e-4 * impulse)

    def test_a_windows_force_does_not_hang_on_how_often_is_dumped(self):
        often, _ = self.analyse(self.run_scene("often", SHORT), "--sizes", "1", "--no-plots")
        seldom, _ = self.analyse(self.run_scene("seldom", {**SHORT, "sample": 2.5e-3}), "--sizes", "1", "--no-plots")
        self.assertEqual(len(often), len(seldom))
        rates = [(float(a["dem_z_N_m3"]), float(b["dem_z_N_m3"])) for a, b in zip(often, seldom)]
        greatest = max(abs(a) for a, _ in rates)
        self.assertGreater(greatest, 0.0)
        for a, b in rates:
            self.assertAlmostEqual(a, b, delta=1e-5 * greatest)  # six digits

    def test_a_thin_beam_without_friction_pushes_as_its_impacts_do(self):
        fraction = 0.002
        out = self.run_scene("beam", {"softened": 100, "size_ratio": 10, "stream_width": 0.008, "fraction": fraction,
                                      "friction": 0, "length": 0.4, "duration": 0.9, "sample": 2.5e-3})
        big = 10 * SMALL
        _, means = self.analyse(out, "--steady", "0.025", "0.815", "--sizes", "1", "2")
        self.assertTrue((out / "solid_drag.png").is_file())
        beam = 1.95 * math.pi / 8 * fraction * DENSITY * (SMALL + big)**2 * SPEED**2
        for mean in means:
            side = float(mean["side_m"])
            self.assertAlmostEqual(float(mean["alpha_b"]), math.pi / 6 * (big / side)**3, delta=1e-5)
            # Some 290 impacts of random cos^2: 7 %. What rebounds stands in the way of the next: 4 % (four seeds).
            self.assertAlmostEqual(float(mean["dem_N_m3"]) * side**3, beam, delta=0.2 * beam)

    def test_a_size_ratio_that_is_not_the_papers_needs_a_fraction(self):
        done = self.command("run", SCENE, "--out", self.top / "ratio", "--set", "size_ratio=7")
        self.assertEqual(done.returncode, 1)
        self.assertIn("fraction must be given", done.stderr)

    def test_softer_spheres_have_a_longer_step_and_whole_windows(self):
        out = self.run_scene("soft", {**SHORT, "softened": 1000, "duration": 0.01})
        step = facts(out)["timestep"]
        self.assertAlmostEqual(step, 2.5e-7 * math.sqrt(1000), delta=0.02 * step)
        windows, _ = self.analyse(out, "--sizes", "1", "--no-plots")
        self.assertEqual(len(windows), 4)


if __name__ == "__main__":
    unittest.main()
