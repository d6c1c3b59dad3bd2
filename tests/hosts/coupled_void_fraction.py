#!/usr/bin/python3
"""Beds of grains wider than the gas's cells, with every void-fraction method that can do them."""

import unittest

from coupled_launch import COUPLE, Scene

STEPS = 300


def run(method, dem_ranks, gas_ranks=1, cells="[18, 18, 90]"):
    """What is printed, and the history, with cells of 1.2 mm for grains of 2.5 mm."""
    couple = COUPLE.replace("void_fraction trilinear", method)
    with Scene(steps=STEPS, couple=couple, processors="processors * 1 1", jet=20.0) as scene:
        gas = scene.folder / "gas.toml"
        text = gas.read_text()
        assert "[4, 4, 20]" in text
        gas.write_text(text.replace("[4, 4, 20]", cells))
        status, text, _ = scene.run(dem_ranks=dem_ranks, gas_ranks=gas_ranks)
        assert status == 0, text
        return text, scene.history()


class SmallCells(unittest.TestCase):
    def expect_same_bed(self, one, two):
        self.assertEqual(len(one), len(two))
        for ours, theirs in zip(one, two):
            self.assertLess(theirs["ledger_residual"], 1e-8)
            self.assertAlmostEqual(ours["bed_height_m"], theirs["bed_height_m"],
                                   delta=0.01 * ours["bed_height_m"])
            self.assertLess(theirs["mass_imbalance"], 1e-8)
        # Before the first contacts have acted nothing but round-off may differ.
        for ours, theirs in zip(one[:4], two[:4]):
            self.assertAlmostEqual(ours["kinetic_energy_J"], theirs["kinetic_energy_J"],
                                   delta=1e-8 * max(ours["kinetic_energy_J"], 1e-9))

    def test_every_method_gives_the_same_bed_on_any_number_of_ranks(self):
        for method in ("kernel", "particle_grid", "exact"):
            with self.subTest(method=method):
                _, one = run(f"void_fraction {method}", 1)
                _, two = run(f"void_fraction {method}", 2, gas_ranks=2)
                self.expect_same_bed(one, two)

    def test_the_choice_is_printed_once_with_its_reason(self):
        text, chosen = run("", 2)
        self.assertEqual(text.count("void_fraction auto: kernel 2, for particles of 2.5 mm"), 1,
                         text)
        _, named = run("void_fraction kernel 2", 2)
        self.assertEqual(chosen, named)

    def test_a_box_without_grains_is_coupled_and_the_choice_waits_for_them(self):
        rain = """\
run 100
fix sphere all particletemplate/sphere 15485863 atom_type 1 density constant 2500 radius constant 0.00125
fix sizes all particledistribution/discrete 15485867 1 sphere 1.0
region above block 0.001 0.021 0.001 0.021 0.08 0.10 units box
fix rain all insert/pack seed 32452843 distributiontemplate sizes maxattempt 100 insert_every once &
    overlapcheck yes all_in yes vel constant 0. 0. -0.5 region above particles_in_region 20"""
        couple = COUPLE.replace("void_fraction trilinear ", "")
        with Scene(steps=200, couple=couple, extra=rain, jet=20.0) as scene:
            script = scene.folder / "in.liggghts"
            text = script.read_text()
            for old, new in (("create_atoms 1 region bed", ""),
                             ("set group all diameter 0.0025 density 2500", ""),
                             ("map array", "map array sort 0 0")):
                assert old in text
                text = text.replace(old, new)
            script.write_text(text)
            status, text, _ = scene.run(dem_ranks=2)
            self.assertEqual(status, 0, text)
            self.assertEqual(text.count("void_fraction auto: kernel 2, for particles of 2.5 mm"), 1,
                             text)
            rows = scene.history()
            self.assertEqual(rows[0]["particles"], 0)
            self.assertEqual(rows[-1]["particles"], 20)
            self.assertLess(rows[-1]["ledger_residual"], 1e-8)

    def test_wide_cells_get_trilinear_weights(self):
        text, _ = run("void_fraction auto", 1, cells="[2, 2, 10]")
        self.assertEqual(text.count("void_fraction auto: trilinear, for particles of 2.5 mm"), 1,
                         text)


if __name__ == "__main__":
    unittest.main(verbosity=2)
