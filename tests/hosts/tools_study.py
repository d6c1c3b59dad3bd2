#!/usr/bin/python3
"""`gasgrain study` through the real programs: its table and picture, failures as rows, going on after
Control-C, its messages; and one bounce against its analytic solution, step by step."""

import csv
import os
import shutil
import signal
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

from coupled_launch import BIN, GAS, filled

# 4 x 4 x 6 spheres that fall together over a jet; every dial a study may turn is a variable.
SCRIPT = """\
variable out index results
variable time index 0.004
variable restart index 0
variable packed index 0
variable packing index 0.002
variable dt index 2.0e-5
variable interval index 4.0e-4
variable youngs index 1.0e7
variable contact index "hertz tangential history"
variable mode index in_turn
variable void_fraction index trilinear
variable effects index "drag koch_hill pressure_gradient"
variable every equal round(${interval}/${dt})
variable pack equal ${every}*round(${packing}/${interval})
variable last equal ${pack}+round(${time}/${dt})
atom_style granular
atom_modify map array
units si
boundary f f f
newton off
communicate single vel yes
if "${packed} > 0" then "jump SELF packed"
region box block 0 0.022 0 0.022 0 0.11 units box
create_box 1 box
region bed block 0.0055 0.0165 0.0055 0.0165 0 0.0165 units box
lattice sc 0.00275 origin 0.5 0.5 0.5
create_atoms 1 region bed
set group all diameter 0.0025 density 2500
jump SELF bed
label packed
read_restart packed.restart
label bed
neighbor 0.0005 bin
neigh_modify delay 0
timestep ${dt}
fix youngs all property/global youngsModulus peratomtype ${youngs}
fix poisson all property/global poissonsRatio peratomtype 0.17
fix restitution all property/global coefficientRestitution peratomtypepair 1 0.9
fix friction all property/global coefficientFriction peratomtypepair 1 0.1
fix speed all property/global characteristicVelocity scalar 1.0
pair_style gran model ${contact}
pair_coeff * *
fix x_lo all wall/gran model ${contact} primitive type 1 xplane 0.0
fix x_hi all wall/gran model ${contact} primitive type 1 xplane 0.022
fix y_lo all wall/gran model ${contact} primitive type 1 yplane 0.0
fix y_hi all wall/gran model ${contact} primitive type 1 yplane 0.022
fix z_lo all wall/gran model ${contact} primitive type 1 zplane 0.0
fix weight all gravity 9.81 vector 0 0 -1
fix motion all nve/sphere
fix gas all couple/gas every ${every} start ${pack} output ${out} mode ${mode} &
    void_fraction ${void_fraction} ${effects}
thermo 500
thermo_modify lost error norm no
if "${packed} > 0" then "reset_timestep 0"
run ${pack}
write_restart ${out}/packed.restart
run ${last} upto
"""


class Study(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="gasgrain-study-"))
        self.scene = self.folder / "scene"
        self.out = self.folder / "out"
        self.scene.mkdir()
        (self.scene / "in.liggghts").write_text(SCRIPT)
        (self.scene / "gas.toml").write_text(filled(GAS, {"jet": 45.0}))

    def tearDown(self):
        shutil.rmtree(self.folder)

    def command(self, kind, *options):
        return [str(BIN / "gasgrain"), "study", kind, str(self.scene), "--out", str(self.out),
                *options]

    def study(self, kind, *options):
        done = subprocess.run(self.command(kind, *options), capture_output=True, text=True,
                              timeout=200, check=False)
        return done.returncode, done.stdout, done.stderr

    def rows(self):
        with open(self.out / "study.csv", newline="", encoding="utf-8") as file:
            return {row["point"]: row for row in csv.DictReader(file)}

    def test_methods_and_grids_give_a_table_a_picture_and_a_front(self):
        status, out, err = self.study("void-fraction", "--quick", "--values", "centre", "offset",
                                      "--time", "0.02")
        self.assertEqual(status, 0, out + err)
        rows = self.rows()
        self.assertEqual(list(rows), ["exact_x1", "twin", "centre_x1", "offset_x1", "exact_x2",
                                      "centre_x2", "offset_x2"])
        for name, row in rows.items():
            self.assertEqual(row["status"], "ok", name)
            self.assertGreater(float(row["wall_s_per_s"]), 0.0)
        # A reference has no error of its own; offset is nearer to the exact share than the centre.
        self.assertEqual(rows["exact_x1"]["energy_error"], "")
        self.assertLess(float(rows["offset_x1"]["energy_error"]),
                        float(rows["centre_x1"]["energy_error"]))
        front = [row for row in rows.values() if row["pareto"] == "1"]
        best = min((row for row in rows.values() if row["energy_error"] and row["point"] != "twin"),
                   key=lambda row: float(row["energy_error"]))
        self.assertIn(best["point"], [row["point"] for row in front])
        self.assertGreater((self.out / "study.png").stat().st_size, 10000)
        self.assertIn("smaller differences are chance", (self.out / "study.md").read_text())
        # The scene of a point is a scene like any other, with its one dial turned.
        point = (self.out / "points" / "centre_x2" / "scene" / "gas.toml").read_text()
        self.assertIn("cells = [8, 8, 40]", point)

    def test_a_point_that_fails_is_a_row_and_the_study_goes_on(self):
        # LIGGGHTS refuses a Young's modulus below 5e6 Pa.
        status, out, err = self.study("stiffness", "--values", "1e6", "1e7", "2e7", "--time", "0.004",
                                      "--no-plots")
        self.assertEqual(status, 0, out + err)
        rows = self.rows()
        self.assertIn("youngsModulus >= 5e6", rows["E_1e+06"]["status"])
        self.assertEqual(rows["E_1e+06"]["wall_s_per_s"], "")
        self.assertEqual(rows["E_1e+07"]["status"], "ok")
        # k ~ E^0.8, step ~ k^-0.5
        soft, stiff = rows["E_1e+07"], rows["E_2e+07"]
        ratio = float(stiff["linear_stiffness_N_m"]) / float(soft["linear_stiffness_N_m"])
        self.assertAlmostEqual(ratio, 2.0**0.8, places=4)
        self.assertLess(float(stiff["dt_s"]), float(soft["dt_s"]) / ratio**0.45)

    def test_each_contact_model_by_both_loops_over_contacts(self):
        status, out, err = self.study("contact-model", "--values", "hertz tangential history",
                                      "hooke", "--time", "0.01", "--no-plots")
        self.assertEqual(status, 0, out + err)
        rows = self.rows()
        # Ours has no loop for a contact without a tangential model.
        self.assertEqual(list(rows), ["hertz_tangential_history", "twin",
                                      "hertz_tangential_history_gran", "hooke_gran"])
        for name, row in rows.items():
            self.assertEqual(row["status"], "ok", name)
            script = (self.out / "points" / name / "scene" / "in.liggghts").read_text()
            line = f"\npair_style {row['pair_style']} model ${{contact}}\n"
            self.assertIn(line, script)
            self.assertEqual(row["pair_style"] == "gran", name.endswith("_gran"))
        # The order of sums is all that differs; another model is another bed.
        loop = float(rows["hertz_tangential_history_gran"]["loop_energy_error"])
        self.assertLess(loop, 0.1 * float(rows["hooke_gran"]["energy_error"]))
        self.assertEqual(rows["hooke_gran"]["loop_energy_error"], "")
        self.assertIn("by pair_style gran in place of gran/bridge", out)

    def test_a_bounce_meets_its_analytic_solution_as_the_step_shrinks(self):
        status, out, err = self.study("dem-step", "--values", "0.01", "0.04", "0.16", "--time",
                                      "0.0008", "--no-plots")
        self.assertEqual(status, 0, out + err)
        rows = self.rows()
        fine, usual, long = (rows[f"step_{share}"] for share in ("0.01", "0.04", "0.16"))
        for figure in ("restitution_error", "contact_time_error", "energy_drift"):
            self.assertLess(float(fine[figure]), float(usual[figure]))
            self.assertLess(float(usual[figure]), float(long[figure]))
        # A hundred steps a contact. The damped contact opens at an infinite rate of its dashpot's
        # force, delta^(1/4): first order, with a small factor.
        self.assertLess(float(fine["restitution_error"]), 5e-3)
        self.assertLess(float(fine["contact_time_error"]), 5e-3)
        self.assertLess(float(fine["energy_drift"]), 1e-3)

    def test_control_c_stops_and_the_same_command_goes_on(self):
        # A gentle jet, for a run of some seconds that loses no grain.
        (self.scene / "gas.toml").write_text(filled(GAS, {"jet": 5.0}))
        command = self.command("ranks", "--values", "1+1", "2+1", "--time", "0.2", "--no-plots")
        process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                   text=True, start_new_session=True)
        done = self.out / "points" / "1+1" / "done.json"
        end = time.monotonic() + 100
        while time.monotonic() < end and not done.exists():
            time.sleep(0.05)
        os.kill(process.pid, signal.SIGINT)
        text, _ = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130, text)
        written = done.stat().st_mtime_ns
        status, out, err = self.study("ranks", "--values", "1+1", "2+1", "--time", "0.2",
                                      "--no-plots")
        self.assertEqual(status, 0, out + err)
        self.assertEqual(done.stat().st_mtime_ns, written, "the point that was done ran again")
        rows = self.rows()
        self.assertEqual(rows["2+1"]["status"], "ok")
        # Another number of ranks differs by the order of sums alone, until collisions enlarge it.
        self.assertLess(float(rows["2+1"]["height_error"]), 0.05)

    def test_each_effect_is_switched_off_in_turn(self):
        status, out, err = self.study("effects", "--time", "0.004", "--no-plots")
        self.assertEqual(status, 0, out + err)
        rows = self.rows()
        self.assertEqual(set(rows), {"all", "twin", "without_drag", "without_pressure_gradient",
                                     "without_self_disturbance", "without_tangential"})
        script = (self.out / "points" / "without_drag" / "scene" / "in.liggghts").read_text()
        self.assertIn("variable effects index pressure_gradient\n", script)
        change = {name: float(row["energy_error"] or "nan") for name, row in rows.items()}
        self.assertGreater(change["without_drag"], change["without_tangential"])

    def test_messages_name_the_remedy(self):
        status, _, err = self.study("void_fractions")
        self.assertEqual(status, 1)
        self.assertIn('study "void_fractions" is unknown. Did you mean "void-fraction"?', err)
        status, _, err = self.study("void-fraction", "--values", "ofset")
        self.assertEqual(status, 1)
        self.assertIn('Did you mean "offset"?', err)
        status, _, err = self.study("ranks", "--values", "2x1")
        self.assertIn("--values 2x1: ranks are DEM+GAS", err)
        script = self.scene / "in.liggghts"
        script.write_text(script.read_text().replace("variable youngs index", "variable stiff index")
                          .replace("${youngs}", "${stiff}"))
        status, _, err = self.study("stiffness")
        self.assertEqual(status, 1)
        self.assertIn("'variable youngs index VALUE'", err)


if __name__ == "__main__":
    unittest.main()
