#!/usr/bin/python3
"""A settled bed on a floor that shakes, from one restart file with `pair_style gran` and with `gran/bridge`: energy, height
and contacts in the mean of the run.

As a test: 576 grains, 3000 steps. Of 2,016 grains and 1e4 steps, with what LIGGGHTS's own springs do that outlive their
contacts (docs/lammps.md):

    tests/hosts/fused_bed.py build --layers 14 --across 12 --steps 10000 --settle 20000
"""

import argparse
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path


def arguments():
    parser = argparse.ArgumentParser()
    parser.add_argument("build", type=Path, nargs="?", default=Path("build"))
    parser.add_argument("--across", type=int, default=8)
    parser.add_argument("--layers", type=int, default=10)
    parser.add_argument("--settle", type=int, default=6000)
    parser.add_argument("--steps", type=int, default=3000)
    return parser.parse_args()


GIVEN = arguments()
DIAMETER, DT, SHARE = 0.0025, 1e-5, 0.005
PITCH = 1.03 * DIAMETER
NEW_LISTS = "neigh_modify every 1 delay 0 check no\n"
SIDE = GIVEN.across * PITCH
PLATE = "solid plate\n" + "".join(
    "facet normal 0 0 1\nouter loop\n" + "".join(f"vertex {x!r} {y!r} 0.0\n" for x, y in corners) + "endloop\nendfacet\n"
    for corners in (((0.0, 0.0), (SIDE, 0.0), (0.0, SIDE)), ((SIDE, SIDE), (0.0, SIDE), (SIDE, 0.0)))) + "endsolid plate\n"


def script(style, begin, end):
    top = (1.5 * GIVEN.layers + 4) * DIAMETER
    return f"""\
units si
atom_style granular
atom_modify map array
boundary p p f
newton off
communicate single vel yes
{begin.format(side=SIDE, top=top)}
neighbor 5e-4 bin
neigh_modify delay 0
timestep {DT}
fix youngs all property/global youngsModulus peratomtype 5e6
fix poisson all property/global poissonsRatio peratomtype 0.17
fix restitution all property/global coefficientRestitution peratomtypepair 1 0.7
fix friction all property/global coefficientFriction peratomtypepair 1 0.3
fix resist all property/global coefficientRollingFriction peratomtypepair 1 0.02
pair_style {style} model hertz tangential history rolling_friction epsd2
pair_coeff * *
fix weight all gravity 9.81 vector 0 0 -1
fix plate all mesh/surface file plate.stl type 1
fix floor all wall/gran model hertz tangential history rolling_friction epsd2 mesh n_meshes 1 meshes plate
fix lid all wall/gran model hertz tangential history rolling_friction epsd2 primitive type 1 zplane {top}
fix motion all nve/sphere
thermo 1000
{end}
"""


LATTICE = f"""region box block 0 {{side}} 0 {{side}} -0.001 {{top}} units box
create_box 1 box
region bed block 0.001 {{side}} 0.001 {{side}} 0.0013 {GIVEN.layers * PITCH} units box
lattice custom {PITCH} a1 1 0 0 a2 0 1 0 a3 0 0 1 basis 0.5 0.5 0.5
create_atoms 1 region bed
set group all diameter {DIAMETER} density 2500
displace_atoms all random 5e-5 5e-5 0 15485863 units box
"""
# The floor goes up and down by 20 um a hundred times a second: at its ends it pulls with 0.8 g.
SHAKEN = f"""fix shake all move/mesh mesh plate wiggle amplitude 0. 0. 2e-5 period 0.01
compute touch all contact/atom
compute touching all reduce ave c_touch
compute place all property/atom z
compute height all reduce ave c_place
compute energy all ke
compute turning all erotate/sphere
fix means all ave/time 10 {GIVEN.steps // 10} {GIVEN.steps} c_energy c_turning c_height c_touching file means.txt
run {GIVEN.steps}
"""


def run(folder, name, text):
    (folder / f"in.{name}").write_text(text)
    done = subprocess.run([GIVEN.build.resolve() / "gasgrain-liggghts", "-in", f"in.{name}", "-log", "none"], cwd=folder,
                          capture_output=True, text=True, timeout=3000, check=False,
                          env={**os.environ, "OMP_NUM_THREADS": "1", "GASGRAIN_PAIR_STYLE": ""})
    if done.returncode != 0:
        raise AssertionError(done.stdout[-3000:] + done.stderr)
    return done.stdout


class Bed(unittest.TestCase):
    def test_energy_height_and_contacts_of_a_shaken_bed_are_those_of_pair_style_gran(self):
        columns = ("energy of motion", "of rotation", "height", "contacts")
        with tempfile.TemporaryDirectory(prefix="gasgrain-bed-") as name:
            folder = Path(name)
            (folder / "plate.stl").write_text(PLATE)
            run(folder, "settle", script("gran", LATTICE, f"run {GIVEN.settle}\nwrite_restart settled"))
            means = {}
            for what, style, lists in (("gran/bridge", "gran/bridge", ""), ("gran, new lists", "gran", NEW_LISTS),
                                       ("gran", "gran", "")):
                run(folder, "shaken", script(style, "read_restart settled", lists + SHAKEN))
                means[what] = [float(word) for word in (folder / "means.txt").read_text().splitlines()[-1].split()[1:]]
        for what, values in means.items():
            print(what, *(f"{column} {value:.6g} ({100 * (value / of_ours - 1):+.2f} %)"
                          for column, value, of_ours in zip(columns, values, means["gran/bridge"])), sep=", ")
        for column, ours, stock in zip(columns, means["gran/bridge"], means["gran, new lists"]):
            self.assertGreater(ours, 0.0)
            self.assertLess(abs(ours / stock - 1.0), SHARE, column)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
