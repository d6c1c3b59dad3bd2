#!/usr/bin/python3
"""Alone, gasgrain-liggghts runs any LIGGGHTS script as the stock program does."""

import subprocess
import unittest

from coupled_launch import BIN, Scene


def thermo(program, folder, ranks):
    text = subprocess.run(
        ["mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none", "-np", str(ranks),
         program, "-in", "in.liggghts", "-log", "none"],
        cwd=folder, capture_output=True, text=True, timeout=120, check=True).stdout
    lines = text.splitlines()
    rows = [line.split() for line in lines]
    return [row for row in rows if len(row) >= 3 and row[0].isdigit() and row[1].isdigit()]


class Stock(unittest.TestCase):
    def test_the_numbers_are_those_of_the_stock_program(self):
        for ranks in (1, 2):
            with Scene(couple="", steps=1500,
                       extra="thermo_style custom step atoms ke erotate\nthermo 250") as scene:
                scene.script.write_text(scene.script.read_text().replace("pair_style gran/bridge", "pair_style gran"))
                ours = thermo(str(BIN / "gasgrain-liggghts"), scene.folder, ranks)
                stock = thermo("liggghts", scene.folder, ranks)
            self.assertGreater(len(stock), 5)
            self.assertEqual(ours, stock)

    def test_clear_keeps_our_styles(self):
        with Scene(couple="", steps=10, extra="clear\nfix again all couple/gas every 1") as scene:
            done = subprocess.run([str(BIN / "gasgrain-liggghts"), "-in", "in.liggghts"],
                                  cwd=scene.folder, capture_output=True, text=True, timeout=60)
        self.assertNotIn("Invalid fix style", done.stderr)


if __name__ == "__main__":
    unittest.main(verbosity=2)
