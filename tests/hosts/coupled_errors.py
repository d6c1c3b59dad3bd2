#!/usr/bin/python3
"""Whatever goes wrong, both sides end soon, not with 0, and one message says what to do."""

import os
import signal
import time
import unittest

from coupled_launch import COUPLE, Scene, pids_left_of, pids_of

SOON = 10.0  # s


class Errors(unittest.TestCase):
    def expect(self, words, gas_first=False, dem_ranks=2, edit=None, **marks):
        with Scene(**marks) as scene:
            if edit:
                edit(scene)
            status, text, seconds = scene.run(timeout=60, dem_ranks=dem_ranks, gas_first=gas_first)
        self.assertNotEqual(status, 0, text)
        self.assertLess(seconds, SOON, text)
        messages = [line for line in text.splitlines() if "error:" in line and "gasgrain-" in line]
        self.assertEqual(len(messages), 1, text)
        for word in words:
            self.assertIn(word, text)
        return text

    def test_an_unknown_style_names_line_and_nearest_style(self):
        self.expect(["in.liggghts:", "nve/sphre", 'Did you mean "nve/sphere"?'],
                    extra="fix more all nve/sphre")

    def test_an_unknown_style_with_the_gas_program_first(self):
        self.expect(["in.liggghts:", "nve/sphre"], gas_first=True, extra="fix more all nve/sphre")

    def test_an_unknown_command_names_the_nearest(self):
        self.expect(['Did you mean "timestep"?'], extra="timestp 1e-5")
        self.expect(["gran/brige", 'Did you mean "gran/bridge"?'], extra="pair_style gran/brige model hertz")
        self.expect(["unknown primitive wall style", 'Did you mean "zplane"?'],
                    extra="fix lid all wall/gran model hertz tangential history primitive type 1 zplan 0.1")

    def test_an_unknown_drag_law_names_the_nearest(self):
        self.expect(["koch_hil", 'Did you mean "koch_hill"?'],
                    couple=COUPLE.replace("koch_hill", "koch_hil"))

    def test_a_misspelt_key_names_file_line_and_nearest_key(self):
        def edit(scene):
            file = scene.folder / "gas.toml"
            file.write_text(file.read_text().replace("courant_max", "courant_mx"))
        self.expect(["gas.toml:7:", "courant_mx", 'Did you mean "courant_max"?'], edit=edit)

    def test_a_nozzle_outside_of_the_box(self):
        def edit(scene):
            file = scene.folder / "gas.toml"
            file.write_text(file.read_text().replace("center = [0.011, 0.011]",
                                                     "center = [0.021, 0.011]"))
        self.expect(["gas.toml:", "leaves its side z_lo"], edit=edit)

    def test_a_dem_box_that_differs_from_the_gas_box(self):
        self.expect(["the DEM box spans z = 0 to 0.1 m", "0 to 0.11 m", "make both the same"], top="0.1")

    def test_units_that_are_not_si(self):
        def edit(scene):
            script = scene.folder / "in.liggghts"
            script.write_text(script.read_text().replace("units si", "units cgs"))
        self.expect(["in.liggghts:", "'units cgs'", "write 'units si'"], edit=edit)

    def test_a_box_that_is_periodic_on_one_side_only(self):
        self.expect(["y is periodic in the script", "not periodic in gas.toml"],
                    boundary="f p f",
                    edit=lambda scene: (scene.folder / "in.liggghts").write_text(
                        "\n".join(line for line in
                                  (scene.folder / "in.liggghts").read_text().splitlines()
                                  if not line.startswith("fix y_"))))

    def test_a_bad_option_of_the_gas_program_ends_the_dem_too(self):
        with Scene() as scene:
            status, text, seconds = scene.run(timeout=60, gas_options=("--no-such-option",))
        self.assertNotEqual(status, 0, text)
        self.assertLess(seconds, SOON, text)
        self.assertIn("--no-such-option", text)

    def test_a_script_that_never_couples(self):
        self.expect(["without meeting its partner", "couple/gas every"], couple="", steps=10)

    def test_coupling_without_a_partner(self):
        with Scene() as scene:
            command = scene.command()
            scene.command = lambda **_: command[:command.index(":")]
            status, text, seconds = scene.run()
        self.assertNotEqual(status, 0)
        self.assertLess(seconds, SOON)
        self.assertIn("no partner in this launch", text)

    def test_a_lost_particle_ends_both_sides(self):
        self.expect(["a lost particle"], steps=100000, dem_ranks=1,
                    extra="unfix z_lo\nthermo 100")

    def killed(self, program):
        with Scene(steps=10000000) as scene:
            process = scene.start(dem_ranks=2)
            history = scene.out / "history.csv"
            waited = time.monotonic() + 30
            while time.monotonic() < waited and (
                    not history.exists() or history.read_text().count("\n") < 5):
                time.sleep(0.05)
            os.kill(pids_of(program, scene.folder)[0], signal.SIGKILL)
            begin = time.monotonic()
            process.communicate(timeout=SOON)
            self.assertLess(time.monotonic() - begin, SOON)
            self.assertNotEqual(process.returncode, 0)
            self.assertEqual(pids_left_of("gasgrain-gas", scene.folder), [])
            self.assertEqual(pids_left_of("gasgrain-liggghts", scene.folder), [])
            rows = scene.history()  # what was written is readable
            self.assertGreater(len(rows), 3)

    def test_the_gas_program_killed_in_the_middle(self):
        self.killed("gasgrain-gas")

    def test_a_dem_rank_killed_in_the_middle(self):
        self.killed("gasgrain-liggghts")


if __name__ == "__main__":
    unittest.main(verbosity=2)
