#!/usr/bin/python3
"""An effect that a scene does not name costs nothing: a build that knows all effects, and one that knows
those of the scene alone, run the same scene with the same number of instructions, bytes on the wire and
bytes of memory. Instructions are counted by valgrind's callgrind, whatever else the machine does."""

import json
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

BIN = Path(sys.argv.pop(1) if len(sys.argv) > 1 else "build/tests").resolve()
SCENE = "drag koch_hill void_fraction trilinear pressure_gradient"
# Of each build. Runs of one program differ by a few thousandths of it, for clocks are read.
GREATEST_DIFFERENCE = 1e-3

GAS = """\
[grid]
lo = [0.0, 0.0, 0.0]
hi = [0.016, 0.016, 0.04]
cells = [8, 8, 20]
[time]
step = 1e-4
[boundary]
z_hi = "outlet"
[turbulence]
model = "@model@"
[[inflow]]
side = "z_lo"
shape = "rectangle"
center = [0.008, 0.008]
size = [0.008, 0.008]
velocity = 5.0
"""


class ZeroCost(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.full = cls.counted("zero_cost_full")
        cls.reduced = cls.counted("zero_cost_reduced")

    @classmethod
    def launch(cls, folder, program, mode, words, model, tool=()):
        (folder / "gas.toml").write_text(GAS.replace("@model@", model))
        done = subprocess.run([*tool, BIN / program, mode, "gas.toml", *words.split()], cwd=folder,
                              capture_output=True, text=True, timeout=120, check=False)
        if done.returncode != 0:
            raise AssertionError(f"{program} {mode} {words}:\n{done.stdout}{done.stderr}")
        return done.stdout

    @classmethod
    def counted(cls, program, words=SCENE, model="none"):
        """Instructions of the particle loop and of the gas steps."""
        with tempfile.TemporaryDirectory(prefix="gasgrain-cost-") as name:
            folder = Path(name)
            cls.launch(folder, program, "loops", words, model,
                       ["valgrind", "--tool=callgrind", "--callgrind-out-file=counts",
                        "--toggle-collect=gasgrain::particle_loop*",
                        "--dump-before=gasgrain::count_gas*",
                        "--toggle-collect=gasgrain::gas_steps*"])
            counts = [int(re.search(r"^totals: (\d+)", (folder / part).read_text(),
                                    flags=re.M).group(1)) for part in ("counts.1", "counts")]
        return dict(zip(("particle loop", "gas steps"), counts))

    @classmethod
    def told(cls, program, words=SCENE, model="none"):
        """Bytes of a particle's record, on the wire, and of memory at its peak."""
        with tempfile.TemporaryDirectory(prefix="gasgrain-cost-") as name:
            return json.loads(cls.launch(Path(name), program, "coupled", words, model).splitlines()[0])

    def test_effects_that_are_off_cost_no_instructions(self):
        for loop, count in self.reduced.items():
            with self.subTest(loop):
                self.assertGreater(count, 1e7)  # the loop has run
                more = self.full[loop] / count - 1
                print(f"{loop}: {self.full[loop]} instructions with all effects listed, {count} with "
                      f"those of the scene: {100 * more:+.4f} %")
                self.assertLess(abs(more), GREATEST_DIFFERENCE)

    def test_an_effect_that_is_on_is_seen_in_the_count(self):
        dearer = self.counted("zero_cost_full", SCENE + " saffman_mei", model="smagorinsky")
        for loop, count in self.full.items():
            with self.subTest(loop):
                print(f"{loop}: {100 * (dearer[loop] / count - 1):+.1f} % with a further effect on")
                self.assertGreater(dearer[loop], (1 + 10 * GREATEST_DIFFERENCE) * count)

    def test_effects_that_are_off_send_and_store_nothing(self):
        full, reduced = self.told("zero_cost_full"), self.told("zero_cost_reduced")
        print(f"all effects listed {full}, those of the scene {reduced}")
        self.assertGreater(full["wire"], 0)
        self.assertEqual(full["record"], reduced["record"])
        self.assertEqual(full["wire"], reduced["wire"])
        # A solver's objects hold the alternatives of its LISTs in place, once a run.
        self.assertLess(abs(full["peak"] / reduced["peak"] - 1), GREATEST_DIFFERENCE)

    def test_an_effect_that_is_on_is_sent_and_stored(self):
        off = self.told("zero_cost_full")
        on = self.told("zero_cost_full", SCENE + " virtual_mass", model="smagorinsky")
        for what in ("record", "wire", "peak"):
            self.assertGreater(on[what], 1.01 * off[what], what)

    def test_the_reduced_build_knows_no_other_effect(self):
        with self.assertRaisesRegex(AssertionError, 'the effect "saffman_mei" is unknown'):
            self.told("zero_cost_reduced", SCENE + " saffman_mei")


if __name__ == "__main__":
    unittest.main(verbosity=2)
