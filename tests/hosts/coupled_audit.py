#!/usr/bin/python3
"""The audit at the end of a coupled run: coupling/audit.h through the real programs."""

import json
import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

from coupled_launch import BIN, COUPLE, SOURCE, Scene

EFFECTS = "virtual_mass saffman_mei magnus"


def couple(words):
    return COUPLE.replace("drag koch_hill pressure_gradient", words)


def audited(words, dem_ranks=1, **marks):
    """(rows by effect, everything printed, audit.txt) of a run of the small test bed."""
    with Scene(couple=couple(words), steps=400, **marks) as scene:
        status, text, _ = scene.run(dem_ranks=dem_ranks)
        assert status == 0, text
        rows = json.loads((scene.out / "audit.json").read_text())["effects"]
        return {row["effect"]: row for row in rows}, text, (scene.out / "audit.txt").read_text()


class AuditOfARun(unittest.TestCase):
    def test_an_effect_wrongly_off_is_warned_of_and_one_rightly_off_is_not(self):
        rows, text, file = audited("drag koch_hill")
        self.assertTrue(rows["pressure_gradient"]["wrong"])
        self.assertFalse(rows["viscous_stress"]["wrong"])
        self.assertFalse(rows["lorentz"]["wrong"])
        for shown in (text, file):
            self.assertIn("warning: pressure_gradient: off, would have reached", shown)
            self.assertIn('write "pressure_gradient" on the couple/gas line', shown)
            self.assertRegex(shown, r"\n  viscous_stress: off, would have reached .*: rightly off")
            self.assertIn("Not lent, estimated from the gas velocity", shown)

    def test_an_effect_that_is_on_for_nothing_is_warned_of_and_one_that_works_is_not(self):
        rows, text, _ = audited("drag koch_hill pressure_gradient viscous_stress")
        self.assertTrue(rows["viscous_stress"]["wrong"], rows["viscous_stress"])
        self.assertIn('take "viscous_stress" from the couple/gas line', text)
        for name in ("drag", "pressure_gradient"):
            self.assertFalse(rows[name]["wrong"])
            self.assertEqual(rows[name]["state"], "on")

    def test_estimates_are_of_the_size_that_the_ledger_has(self):
        # The ledger sums |F_x| + |F_y| + |F_z| over all steps, contacts' accelerations included; the
        # estimates take |F| at couplings, with slip, spin and shear as unlucky as they can be.
        rows, _, _ = audited(f"drag koch_hill pressure_gradient {EFFECTS}")
        for name in ("pressure_gradient", *EFFECTS.split()):
            ledger, estimate = rows[name]["of_drag"], rows[name]["estimated_of_drag"]
            self.assertGreater(ledger, 0.0, name)
            self.assertLess(max(ledger, estimate) / min(ledger, estimate), 4.0, rows[name])

    def test_what_is_not_lent_is_estimated_to_the_same_order(self):
        # With a field lent and without, the same bed: cells' differences blur what varies in a cell.
        on, _, _ = audited(f"drag koch_hill pressure_gradient {EFFECTS}")
        off, _, _ = audited("drag koch_hill pressure_gradient")
        for name in EFFECTS.split():
            lent, guessed = on[name]["estimated_of_drag"], off[name]["estimated_of_drag"]
            self.assertLess(max(lent, guessed) / min(lent, guessed), 5.0, name)

    def test_ranks_add_up(self):
        one, _, _ = audited("drag koch_hill pressure_gradient")
        two, _, _ = audited("drag koch_hill pressure_gradient", dem_ranks=2,
                            processors="processors 2 1 1")
        for name, row in one.items():
            # The bed's collisions differ in their last digits; its mean does not.
            self.assertAlmostEqual(row["of_drag"], two[name]["of_drag"],
                                   delta=0.05 * abs(row["of_drag"]) + 1e-9, msg=name)

    def test_without_drag_it_says_that_nothing_of_the_gas_is_known(self):
        rows, text, _ = audited("pressure_gradient")
        self.assertEqual(rows, {})
        self.assertIn("no gas velocity was lent", text)

    def test_gasgrain_run_completes_it_from_gas_toml_and_shows_the_warnings(self):
        folder = Path(tempfile.mkdtemp(prefix="gasgrain-audit-"))
        self.addCleanup(shutil.rmtree, folder, ignore_errors=True)
        shutil.copytree(SOURCE / "inputs" / "spouted_bed_small", folder / "scene")
        run = subprocess.run(
            [BIN / "gasgrain", "run", folder / "scene", "--out", folder / "out", "--no-plots",
             "--time", "0.02", "--var", "packing", "0.02", "--var", "effects", "drag koch_hill"],
            capture_output=True, text=True, timeout=200, check=False, env=dict(os.environ))
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        self.assertIn("warning: pressure_gradient: off", run.stdout)
        rows = json.loads((folder / "out" / "audit.json").read_text())["effects"]
        states = {row["effect"]: row["state"] for row in rows}
        self.assertEqual(states["turbulence k_epsilon"], "off")
        self.assertEqual(states["convection"], "on")
        self.assertNotIn("gas.toml", states.values())


if __name__ == "__main__":
    unittest.main(verbosity=2)
