#!/usr/bin/python3
"""The table of keys in docs/gas-input.md is the one that the program prints, with reasons added."""

import subprocess
import sys
import unittest
from pathlib import Path

BIN = Path(sys.argv.pop(1) if len(sys.argv) > 1 else "build").resolve()
DOCS = Path(__file__).resolve().parents[2] / "docs" / "gas-input.md"


def cells(line):
    return [cell.strip() for cell in line.strip().strip("|").split("|")]


class Keys(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        printed = subprocess.run([BIN / "gasgrain-gas", "--keys"], capture_output=True, text=True,
                                 check=True, timeout=60).stdout
        cls.printed = [cells(line) for line in printed.splitlines()]
        section = DOCS.read_text(encoding="utf-8").split("\n## Keys of gas.toml\n")[1].split("\n## ")[0]
        cls.documented = [cells(line) for line in section.splitlines() if line.startswith("| `[")]

    def test_many_keys_are_printed(self):
        self.assertGreater(len(self.printed), 40)

    def test_every_key_is_documented_with_its_unit_range_and_default(self):
        remedy = "put the line of 'gasgrain-gas --keys' into docs/gas-input.md, and its meaning behind"
        for ours, theirs in zip(self.printed, self.documented):
            self.assertEqual(theirs[:4], ours, remedy)
        self.assertEqual(len(self.documented), len(self.printed), remedy)

    def test_every_key_is_documented_with_its_meaning(self):
        for line in self.documented:
            self.assertEqual(len(line), 5, line)
            self.assertNotEqual(line[4], "", line)


if __name__ == "__main__":
    unittest.main(verbosity=2)
