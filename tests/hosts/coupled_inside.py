#!/usr/bin/python3
"""The gas inside the DEM ranks: the same run as with the gas program beside them."""

import json
import signal
import subprocess
import time
import unittest

from coupled_launch import BIN, COUPLE, HOST, Scene, command_of, differing_steps

INSIDE = COUPLE.replace("void_fraction", "gas gas.toml void_fraction")
# 0.1 s: the bed has been blown up and falls back.
STEPS = 5000
SOON = 10.0  # s


def alone(scene, ranks):
    """From here on the scene is launched without a gas program."""
    command = scene.command(dem_ranks=ranks)
    command = command[:command.index(":")]
    scene.command = lambda **_: command


class Inside(unittest.TestCase):
    def run_inside(self, ranks, **marks):
        with Scene(couple=marks.pop("couple", INSIDE), **marks) as scene:
            alone(scene, ranks)
            status, text, _ = scene.run()
            self.assertEqual(status, 0, text)
            return (scene.out / "history.csv").read_text(), scene.history(), text

    def run_beside(self, ranks, **marks):
        with Scene(**marks) as scene:
            status, text, _ = scene.run(dem_ranks=ranks, gas_ranks=ranks)
            self.assertEqual(status, 0, text)
            return (scene.out / "history.csv").read_text()

    def test_a_gas_inside_gives_the_same_bits_as_a_gas_program(self):
        for ranks in (1, 2):
            with self.subTest(ranks=ranks):
                marks = {"steps": STEPS, "processors": "processors * 1 1"}
                text, history, _ = self.run_inside(ranks, **marks)
                # Without this the comparison would be of a bed at rest.
                self.assertGreater(history[-1]["bed_height_m"], 1.1 * history[0]["bed_height_m"])
                for row in history:
                    self.assertLess(row["ledger_residual"], 1e-10, row["step"])
                self.assertEqual(text, self.run_beside(ranks, **marks))

    def test_other_effects_and_none_that_react_are_the_same_too(self):
        lift = COUPLE + " viscous_stress virtual_mass saffman_mei"
        free = "fix gas all couple/gas every 25 output @out@ void_fraction trilinear pressure_gradient"
        for couple in (lift, free):
            for ranks in (1, 2):
                with self.subTest(couple=couple, ranks=ranks):
                    marks = {"steps": 500, "processors": "processors * 1 1"}
                    inside = couple.replace("void_fraction", "gas gas.toml void_fraction")
                    text, _, _ = self.run_inside(ranks, couple=inside, **marks)
                    self.assertEqual(text, self.run_beside(ranks, couple=couple, **marks))

    def test_all_files_of_a_run_are_there_and_mpirun_is_not_needed(self):
        extra = ("restart 500 @out@/checkpoint/dem.*.restart\n"
                 "dump view all custom/vtk 500 @out@/particles/p_*.vtk id type x y z radius")
        with Scene(couple=INSIDE, extra=extra) as scene:
            done = subprocess.run([*command_of(HOST, BIN), "-in", scene.script.name],
                                  cwd=scene.folder, text=True, capture_output=True, timeout=60,
                                  check=False)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            for name in ("history.csv", "run.json", "gas.h5", "gas.xdmf", "particles/p_500.vtk",
                         "checkpoint/gas.500.h5", "checkpoint/dem.500.restart"):
                self.assertGreater((scene.out / name).stat().st_size, 0, name)
            ledger = json.loads((scene.out / "ledger.json").read_text())
            gas, dem = ledger["gas"]["tasks"], ledger["dem"]["tasks"]
            # What the one does the other waits for.
            self.assertGreater(gas["pressure"]["max_s"], 0.0)
            self.assertGreater(gas["waiting for the particles"]["max_s"],
                               dem["pair forces"]["max_s"])
            self.assertGreater(dem["coupling: waiting for the gas"]["max_s"],
                               gas["pressure"]["max_s"])
            self.assertEqual((scene.out / "gas.xdmf").read_text().count("<Time"), 2)

    def test_it_goes_on_from_its_checkpoint(self):
        for ranks in (1, 2):
            with self.subTest(ranks=ranks), Scene(
                    couple=INSIDE, processors="processors * 1 1",
                    extra="restart 500 @out@/checkpoint/dem.*.restart") as scene:
                alone(scene, ranks)
                status, text, _ = scene.run()
                self.assertEqual(status, 0, text)
                whole = scene.history()
                self.resume(scene, f"gas_restart {scene.out}/checkpoint/gas.500.h5")
                status, text, _ = scene.run()
                self.assertEqual(status, 0, text)
                rows = scene.history()
                self.assertEqual(rows[: len(whole)], whole)  # appended, not overwritten
                again = rows[len(whole):]
                self.assertEqual(again[-1]["step"], 1000)
                self.assertEqual(differing_steps(whole, again, after=500), [])
                for row in again:
                    self.assertLess(row["ledger_residual"], 1e-10)

    def resume(self, scene, gas_restart):
        scene.resume(500, 1000)
        script = scene.script
        script.write_text(script.read_text().replace("gas gas.toml", f"gas gas.toml {gas_restart}"))

    def test_the_wish_to_stop_leaves_a_pair_of_checkpoints(self):
        with Scene(couple=INSIDE, steps=10000000) as scene:
            alone(scene, 2)
            process = scene.start()
            history = scene.out / "history.csv"
            end = time.monotonic() + 30
            while time.monotonic() < end and (
                    not history.exists() or history.read_text().count("\n") < 5):
                time.sleep(0.05)
            process.send_signal(signal.SIGUSR1)
            text, _ = process.communicate(timeout=20)
            self.assertEqual(process.returncode, 0, text)
            dem = {path.name.split(".")[1] for path in (scene.out / "checkpoint").glob("dem.*")}
            gas = {path.name.split(".")[1] for path in (scene.out / "checkpoint").glob("gas.*")}
            self.assertEqual(len(dem), 1, text)
            self.assertEqual(dem, gas, text)
            self.assertTrue((scene.out / "ledger.json").exists())

    def test_a_restart_without_the_gas_s_checkpoint_is_refused(self):
        with Scene(couple=INSIDE, steps=500,
                   extra="restart 500 @out@/checkpoint/dem.*.restart") as scene:
            alone(scene, 1)
            self.assertEqual(scene.run()[0], 0)
            results = (scene.out / "gas.h5").read_bytes()
            self.resume(scene, "")
            self.assert_fails(scene, ["restart both from checkpoints of one step"])
            self.assertEqual((scene.out / "gas.h5").read_bytes(), results)

    def assert_fails(self, scene, words):
        status, text, seconds = scene.run(timeout=60)
        self.assertNotEqual(status, 0, text)
        self.assertLess(seconds, SOON, text)
        messages = [line for line in text.splitlines() if "error:" in line and "gasgrain-" in line]
        self.assertEqual(len(messages), 1, text)
        for word in words:
            self.assertIn(word, text)

    def refused(self, words, couple=INSIDE, ranks=2, edit=None, **marks):
        with Scene(couple=couple, **marks) as scene:
            alone(scene, ranks)
            if edit:
                edit(scene)
            self.assert_fails(scene, words)

    def test_all_faults_of_its_input_come_in_one_message(self):
        def edit(scene):
            file = scene.folder / "gas.toml"
            text = file.read_text().replace("courant_max", "courant_mx")
            file.write_text(text.replace("center = [0.011, 0.011]", "center = [0.021, 0.011]"))
        self.refused([f"in.{HOST}:", "gas.toml:7:", 'Did you mean "courant_max"?',
                      "leaves its side z_lo"], edit=edit)

    def test_an_input_that_is_not_there(self):
        self.refused(["no.toml"], couple=INSIDE.replace("gas.toml", "no.toml"))

    def test_a_box_that_differs(self):
        self.refused(["the DEM box spans z = 0 to 0.1 m", "make both the same"], top="0.1")

    def test_more_ranks_than_the_grid_has_cells_for(self):
        def edit(scene):
            file = scene.folder / "gas.toml"
            file.write_text(file.read_text().replace("[4, 4, 20]", "[1, 1, 2]"))
        self.refused(["3 gas ranks cannot share a grid"], ranks=3, edit=edit)

    def test_a_gas_that_fails_on_the_way_ends_all_ranks_with_one_message(self):
        def edit(scene):
            (scene.out / "checkpoint/gas.200.h5.new").mkdir(parents=True)
        for ranks in (1, 2):
            with self.subTest(ranks=ranks):
                self.refused(["gas.200.h5.new: cannot be created"], ranks=ranks, edit=edit,
                             extra="restart 100 @out@/checkpoint/dem.*.restart")

    def test_two_gases_are_one_too_many(self):
        with Scene(couple=INSIDE) as scene:
            self.assert_fails(scene, ["there are two gas solvers", "Leave out one"])

    def test_overlapped_needs_a_gas_program(self):
        self.refused(["mode overlapped", "exclude each other"],
                     couple=INSIDE.replace("gas gas.toml", "mode overlapped gas gas.toml"))

    def test_a_checkpoint_without_a_gas_inside(self):
        self.refused(["needs 'gas FILE'"],
                     couple=INSIDE.replace("gas gas.toml", "gas_restart gas.1.h5"))

    def test_neither_a_partner_nor_an_input_tells_both_ways(self):
        self.refused(["no partner in this launch", "gas gas.toml"], couple=COUPLE)


if __name__ == "__main__":
    unittest.main(verbosity=2)
