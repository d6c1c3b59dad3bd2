#!/usr/bin/python3
"""The small spouted bed in both hosts, from one packed bed: its height over the first spout.

As a test: 0.06 s, LIGGGHTS on one rank, LAMMPS on one and two. For 0.3 s on one and two ranks each:

    tests/hosts/two_hosts_bed.py build --time 0.3 --ranks 1 2
"""

import argparse
import csv
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
ENVIRONMENT = dict(os.environ, OMPI_MCA_mpi_yield_when_idle="1", OMP_NUM_THREADS="1",
                   OMPI_MCA_btl_vader_single_copy_mechanism="none")
SCRIPTS = {"liggghts": "in.liggghts", "lammps": "in.lammps"}


def arguments():
    parser = argparse.ArgumentParser()
    parser.add_argument("build", type=Path, nargs="?", default=Path("build"))
    parser.add_argument("--time", type=float, default=0.06)
    parser.add_argument("--ranks", type=int, nargs="+")
    return parser.parse_args()


GIVEN = arguments()
RUNS = [(host, ranks) for ranks in GIVEN.ranks for host in SCRIPTS] if GIVEN.ranks else \
    [("liggghts", 1), ("lammps", 1), ("lammps", 2)]


def run(scene, host, out, *words):
    done = subprocess.run([GIVEN.build.resolve() / "gasgrain", "run", scene, "--host", host, "--no-plots", "--out", out,
                           *map(str, words)], env=ENVIRONMENT, capture_output=True, text=True, timeout=600, check=False)
    if done.returncode != 0:
        raise AssertionError(done.stdout + done.stderr)


def packed_bed(folder):
    """Centres of the grains after 0.1 s of packing in LAMMPS, of its last dump."""
    sys.path.insert(0, str(SOURCE / "tools"))
    from report_read import read_fields
    run(SOURCE / "inputs/spouted_bed_small", "lammps", folder, "--dem-ranks", 1, "--time", 1e-3, "--var", "packing", 0.1)
    return read_fields(folder / "particles/p_10000.vtk")[0]


def scene_from(centres, folder):
    """The scene, with these grains at rest in the place of its own filling and packing."""
    folder.mkdir()
    original = SOURCE / "inputs/spouted_bed_small"
    (folder / "gas.toml").write_text((original / "gas.toml").read_text())
    (folder / "bed.txt").write_text("".join(
        "create_atoms 1 single {:.17g} {:.17g} {:.17g} units box\n".format(*centre) for centre in centres))
    for script in SCRIPTS.values():
        text = (original / script).read_text()
        begin = text.index('if "${packed} > 0" then "jump SELF calm"')
        end = text.index("label", text.index("write_restart", begin))
        filling = "include bed.txt\nset group all diameter 0.0025 density 2500\n"
        text = text[:begin] + filling + text[end:]
        (folder / script).write_text(re.sub(r"variable packing.*", "variable packing index 0.0", text))
    return folder


class Bed(unittest.TestCase):
    def test_both_hosts_raise_it_alike(self):
        heights, residuals = {}, {}
        with tempfile.TemporaryDirectory(prefix="gasgrain-two-hosts-") as name:
            top = Path(name)
            scene = scene_from(packed_bed(top / "packing"), top / "spouted_bed_small")
            for host, ranks in RUNS:
                out = top / f"{host}-{ranks}"
                run(scene, host, out, "--dem-ranks", ranks, "--time", GIVEN.time)
                with open(out / "history.csv", encoding="ascii") as file:
                    rows = list(csv.DictReader(file))
                heights[host, ranks] = [float(row["bed_height_m"]) for row in rows]
                residuals[host, ranks] = max(abs(float(row["ledger_residual"])) for row in rows)
        first = heights[RUNS[0]]
        for which, heights_of in heights.items():
            self.assertEqual(len(heights_of), len(first))
            greatest = max(abs(a / b - 1.0) for a, b in zip(heights_of, first))
            mean = sum(heights_of) / sum(first) - 1.0
            print(f"{which}: mean height {sum(heights_of) / len(heights_of):.5f} m ({100 * mean:+.2f} %), greatest "
                  f"difference {100 * greatest:.2f} %, ledger {residuals[which]:.1e}")
            self.assertLess(abs(mean), 0.02)
            if GIVEN.time <= 0.1:  # later, grains that fly apart tell the height
                self.assertLess(greatest, 0.02)
            self.assertLess(residuals[which], 1e-12)  # round-off of the sums


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
