#!/usr/bin/python3
"""A DEM step far too long for the contacts' stiffness: refused before the run, with the step that does.

Negative control: the host alone, without the watch, runs with such a step, and its bed does not come to
rest or is gone. The limit is not timid either: with a step just below it the bed lies still.
"""

import re
import subprocess
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "hosts"))

from coupled_launch import BIN, Scene  # noqa: E402  (after the path)

HERTZ = "model hertz"
HOOKE = "model hooke"
SPEED = "fix speed all property/global characteristicVelocity scalar 1.47\npair_style"
FALL = 0.5  # s: the bed, pulled apart a little, has fallen and come to rest after 0.1


class DemStep(unittest.TestCase):
    def scene(self, model, step, **marks):
        scene = Scene(**marks)
        script = scene.folder / "in.liggghts"
        text = script.read_text().replace("timestep 2e-5", f"timestep {step}")
        if model == HOOKE:
            text = text.replace(HERTZ, HOOKE).replace("pair_style", SPEED)
        # Off the lattice, or the grains stand in columns that fall straight.
        script.write_text(text.replace("neighbor 0.0005",
                                       "displace_atoms all random 1e-4 1e-4 1e-4 49979687\nneighbor 0.0005"))
        return scene

    def contact_time(self, model):
        """As the refusal of a step of 1 ms tells it."""
        with self.scene(model, 1e-3, steps=10) as scene:
            status, text, seconds = scene.run()
        self.assertNotEqual(status, 0)
        self.assertLess(seconds, 20)
        self.assertRegex(text, r"'timestep 0.001' is too long for the contacts: two grains of type 1 .*"
                               r"\. With fewer than pi steps a packed bed feeds itself with energy")
        self.assertNotIn("Step", text.replace("timestep", ""))  # no step was made
        return (float(re.search(r"touch for ([\d.e-]+) s", text)[1]),
                re.search(r"Write 'timestep ([\d.e-]+)'", text)[1])

    def alone(self, model, step):
        """(grains left, their kinetic energy [J]) after the fall, the host alone."""
        steps = round(FALL / step)
        extra = f"thermo {steps}\nthermo_style custom step atoms ke\nthermo_modify lost ignore norm no"
        with self.scene(model, step, couple="", steps=steps, extra=extra) as scene:
            done = subprocess.run([BIN / "gasgrain-liggghts", "-in", "in.liggghts"], cwd=scene.folder,
                                  text=True, capture_output=True, timeout=120, check=False)
        last = re.findall(rf"^ *{steps} +(\d+) +(\S+)", done.stdout, flags=re.M)
        self.assertTrue(last, done.stdout[-500:] + done.stderr[-500:])
        return int(last[-1][0]), float(last[-1][1])

    def test_a_step_beyond_the_limit_is_refused_and_would_have_lost_the_bed(self):
        for model in (HERTZ, HOOKE):
            with self.subTest(model=model):
                contact, advised = self.contact_time(model)
                # At twice the limit the host alone shoots its grains out of the box ...
                grains, _ = self.alone(model, 0.6 * contact)
                self.assertLess(grains, 100)
                # ... and just under it, where one is warned, they lie: a grain that falls by a hundredth
                # of its radius has 2.5 nJ, these have 0.13 each at most.
                grains, energy = self.alone(model, 0.28 * contact)
                self.assertEqual(grains, 768)
                self.assertLess(energy, 1e-7)
                # With what is advised the coupled run goes on without a word about the step.
                with self.scene(model, advised, steps=200) as scene:
                    status, text, _ = scene.run()
                self.assertEqual(status, 0, text)
                self.assertNotIn("for the contacts", text)

    def test_the_limit_goes_with_the_root_of_the_stiffness(self):
        """Hertz: t_c goes with E^-0.4; a stiffness 100 times greater asks for a step 6.3 times shorter."""
        soft, _ = self.contact_time(HERTZ)
        with self.scene(HERTZ, 1e-3, steps=10) as scene:
            script = scene.folder / "in.liggghts"
            script.write_text(script.read_text().replace("peratomtype 5e6", "peratomtype 5e8"))
            _, text, _ = scene.run()
        hard = float(re.search(r"touch for ([\d.e-]+) s", text)[1])
        self.assertAlmostEqual(soft / hard, 100 ** 0.4, delta=0.05)  # 3 digits are printed


if __name__ == "__main__":
    unittest.main(verbosity=2)
