#!/usr/bin/python3
"""The cost ledger at the end of a run: every task has a row, the rows sum to the whole, and what is off
has none. Seconds themselves are not asserted: they are the machine's."""

import json
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

from coupled_launch import BIN, COUPLE, SOURCE, Scene

HOST = {"total", "setup", "pair forces", "neighbour lists", "DEM communication", "output", "walls",
        "integration", "other fixes", "other"}
COUPLING = {"coupling: void fraction", "coupling: transport", "coupling: waiting for the gas",
            "coupling: sampling", "coupling: history", "coupling: DEM ranks in step",
            "coupling: forces, every step", "coupling: looking for faults", "coupling: audit"}
DRAG = {"coupling: drag law", "coupling: drag of the gas", "coupling: force drag"}
GAS = {"total", "setup", "boundaries", "momentum", "pressure", "means",
       "measures", "output", "other"}
PORT = {"fields of the grains", "transport", "waiting for the particles", "solids above the limit"}


def seconds(side):
    return {task: cost["mean_s"] for task, cost in side["tasks"].items()}


class CostLedger(unittest.TestCase):
    def coupled(self, couple, dem_ranks=1, gas_ranks=1, **marks):
        with Scene(couple=couple, steps=500, **marks) as scene:
            status, text, _ = scene.run(dem_ranks=dem_ranks, gas_ranks=gas_ranks)
            self.assertEqual(status, 0, text)
            return json.loads((scene.out / "ledger.json").read_text()), text

    def assert_sums_to_its_total(self, side):
        of = dict(seconds(side))
        total = of.pop("total")
        self.assertGreater(total, 0.0)
        # Six digits of each row are written.
        self.assertAlmostEqual(sum(of.values()), total, delta=1e-4 * total)
        for task, value in of.items():
            # A ledger that counted something twice would have a rest below zero.
            self.assertGreaterEqual(value, 0.0, task)

    def assert_table_shows(self, text, side, ledger):
        shares = {name.strip(): float(share) for name, share in
                  re.findall(r"^    (\S.*?) +[\d.]+ +[\d.]+ +([\d.]+) %$",
                             text.split(f"  {side}, ")[1].split("  gas, ")[0], flags=re.M)}
        self.assertEqual(shares.keys(), ledger["tasks"].keys())
        rows = [share for name, share in shares.items() if name != "total"]
        # Each is rounded to 0.1 %.
        self.assertAlmostEqual(sum(rows), 100.0, delta=0.05 * len(rows))

    def test_fixes_are_timed_in_every_run_of_a_script(self):
        # A quarter of the steps in the last run: timed there alone, walls would have a quarter of
        # their share.
        couple = COUPLE
        once, _ = self.coupled(couple)
        thrice, _ = self.coupled(couple, extra="run 1500")
        share = [seconds(ledger["dem"])["walls"] / seconds(ledger["dem"])["pair forces"]
                 for ledger in (once, thrice)]
        self.assertGreater(share[1], 0.5 * share[0])

    def test_every_task_of_both_sides_has_a_row_and_they_sum_to_the_whole(self):
        for dem_ranks, gas_ranks in ((1, 1), (2, 2)):
            with self.subTest(ranks=(dem_ranks, gas_ranks)):
                ledger, text = self.coupled(COUPLE, dem_ranks, gas_ranks,
                                            processors="processors * 1 1")
                dem, gas = ledger["dem"], ledger["gas"]
                self.assertEqual(dem["tasks"].keys(), HOST | COUPLING | DRAG
                                 | {"coupling: force pressure_gradient"})
                self.assertEqual(gas["tasks"].keys(), GAS | PORT)
                self.assertEqual((dem["ranks"], gas["ranks"]), (dem_ranks, gas_ranks))
                for side, name in ((dem, "DEM"), (gas, "gas")):
                    self.assert_sums_to_its_total(side)
                    self.assert_table_shows(text, name, side)
                # Whatever the machine, these were at work.
                for task in ("pair forces", "walls", "integration", "coupling: force drag",
                             "coupling: force pressure_gradient", "coupling: void fraction"):
                    self.assertGreater(seconds(dem)[task], 0.0, task)
                for task in ("momentum", "pressure", "transport", "output"):
                    self.assertGreater(seconds(gas)[task], 0.0, task)

    def test_each_force_has_a_row_where_it_is_on_and_none_where_it_is_off(self):
        forces = ["pressure_gradient", "viscous_stress", "virtual_mass", "basset", "saffman_mei", "magnus",
                  "rotation_torque"]
        ledger, _ = self.coupled(
            "fix gas all couple/gas every 25 output @out@ void_fraction trilinear drag koch_hill "
            + " ".join(forces))
        of = seconds(ledger["dem"])
        named = {task for task in of if task.startswith("coupling: force ")}
        self.assertEqual(named, {f"coupling: force {name}" for name in ["drag", *forces]})
        for task in named:
            self.assertGreater(of[task], 0.0, task)
        self.assert_sums_to_its_total(ledger["dem"])

        ledger, _ = self.coupled(
            "fix gas all couple/gas every 25 output @out@ void_fraction trilinear pressure_gradient")
        self.assertEqual(ledger["dem"]["tasks"].keys(),
                         HOST | COUPLING | {"coupling: force pressure_gradient"})

    def test_a_gas_inside_the_dem_ranks_has_its_side_too(self):
        couple = COUPLE.replace("void_fraction", "gas gas.toml void_fraction")
        with Scene(couple=couple, steps=250) as scene:
            done = subprocess.run([BIN / "gasgrain-liggghts", "-in", "in.liggghts"], cwd=scene.folder,
                                  capture_output=True, text=True, timeout=120, check=False)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            ledger = json.loads((scene.out / "ledger.json").read_text())
        self.assertEqual(ledger["gas"]["tasks"].keys(), GAS | PORT)
        for side in ("dem", "gas"):
            self.assert_sums_to_its_total(ledger[side])

    def test_two_runs_of_one_script_are_one_ledger(self):
        ledger, _ = self.coupled(COUPLE, extra="run 250")
        self.assert_sums_to_its_total(ledger["dem"])

    def test_a_run_of_the_gas_alone_has_a_ledger(self):
        folder = Path(tempfile.mkdtemp(prefix="gasgrain-gas-"))
        try:
            text = (SOURCE / "inputs/distributor/gas.toml").read_text()
            for model in ("smagorinsky", "none"):
                with self.subTest(turbulence=model):
                    self.assertIn('model = "smagorinsky"', text)
                    (folder / "gas.toml").write_text(
                        text.replace("end = 0.1 ", "end = 0.02 ")
                        .replace('model = "smagorinsky"', f'model = "{model}"'))
                    done = subprocess.run([BIN / "gasgrain-gas", "gas.toml", "--out", "out"], cwd=folder,
                                          capture_output=True, text=True, timeout=120, check=False)
                    self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
                    ledger = json.loads((folder / "out/ledger.json").read_text())
                    self.assertEqual(ledger.keys(), {"gas"})
                    self.assertEqual(ledger["gas"]["tasks"].keys(),
                                     GAS | ({"turbulence"} if model != "none" else set()))
                    self.assert_sums_to_its_total(ledger["gas"])
                    self.assert_table_shows(done.stdout, "gas", ledger["gas"])
        finally:
            shutil.rmtree(folder)


if __name__ == "__main__":
    unittest.main(verbosity=2)
