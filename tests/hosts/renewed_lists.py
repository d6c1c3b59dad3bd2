#!/usr/bin/python3
"""Fast grains get new pairs by themselves: forces and motion are those of lists that are all made anew, whoever moves where,
and all lists are made anew much more rarely."""

import os
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

from coupled_launch import BIN

# Grains of three sizes in a box that is periodic along x, with a pipe and planes about them. One in
# twenty-five flies through the others, at speeds of its own.
BED = """
atom_style    granular
atom_modify   map array sort 100 0.0
boundary      {sides} f f
newton        off
communicate   single {cutoff} vel yes
units         si
processors    * 1 1
region        box block 0 0.06 -0.021 0.021 -0.021 0.021 units box
create_box    2 box
region        fill cylinder x 0 0 0.0149 0.0005 0.0595 units box
neighbor      0.0003 bin
neigh_modify  delay 0
timestep      1e-5
fix m1 all property/global youngsModulus peratomtype 5e6 5e6
fix m2 all property/global poissonsRatio peratomtype 0.3 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 2 0.7 0.7 0.7 0.7
fix m4 all property/global coefficientFriction peratomtypepair 2 0.4 0.4 0.4 0.4
pair_style    gran/bridge model hertz tangential history
pair_coeff    * *
fix y0 all wall/gran model hertz tangential history primitive type 1 yplane -0.015
fix y1 all wall/gran model hertz tangential history primitive type 1 yplane 0.015
fix pipe all wall/gran model hertz tangential history primitive type 1 xcylinder 0.0152 0 0
{ends}
{computes}
fix s1 all particletemplate/sphere 15485863 atom_type 1 density constant 2500 radius constant 0.0010
fix s2 all particletemplate/sphere 15485867 atom_type 2 density constant 2500 radius constant 0.0016
fix s3 all particletemplate/sphere 32452843 atom_type 2 density constant 2500 radius constant 0.0013
fix d all particledistribution/discrete 32452867 3 s1 0.3 s2 0.5 s3 0.2
fix in all insert/pack seed 49979687 distributiontemplate d maxattempt 200 insert_every once &
    overlapcheck yes all_in yes vel constant 0.02 0.01 -0.03 region fill particles_in_region 1400
run           1
unfix         in
{motion}
fix g all gravity 9.81 vector 0 0 -1
fix move all nve/sphere
{more}
dump state all custom 100 state.* id type xu yu zu vx vy vz omegax omegay omegaz fx fy fz
dump_modify state sort id format "%d %d %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g"
thermo_style  custom step atoms ke
thermo        100
thermo_modify lost error norm no
run           399
"""
MANY = """group         fast id < 30
group         faster id 31:60
group         third id 61:90
velocity      fast set 2.1 1.3 -0.9
velocity      faster set -1.2 0.9 1.8
velocity      third set 0.7 -1.6 -1.1"""
# Two in a lane that is free of others; ranks meet at x = 0.03.
ONE = """region        lane cylinder x 0 0 0.0035 0.015 0.050 units box
delete_atoms  region lane
create_atoms  1 single 0.019 0 0 units box
create_atoms  2 single 0.039 0 0 units box
region        begin block 0.018 0.020 -0.001 0.001 -0.001 0.001 units box
region        middle block 0.018 0.040 -0.001 0.001 -0.001 0.001 units box
group         fast region begin
group         both region middle
set           group both diameter 0.002 density 2500
velocity      all set 0 0 0
velocity      fast set 6 0 0"""
ENDS = """fix x0 all wall/gran model hertz tangential history primitive type 1 xplane 0.0
fix x1 all wall/gran model hertz tangential history primitive type 1 xplane 0.06"""


class Run:
    def __init__(self, lists, ranks, sides="p", cutoff="", computes="", motion=MANY, more=""):
        environment = {**os.environ, "GASGRAIN_LISTS": lists}
        environment.pop("GASGRAIN_PAIR_STYLE", None)
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            (folder / "in.liggghts").write_text(BED.format(
                sides=sides, cutoff=cutoff, computes=computes, motion=motion, more=more, ends=ENDS if sides == "f" else ""))
            done = subprocess.run(
                ["mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none", "-np", str(ranks),
                 str(BIN / "gasgrain-liggghts"), "-in", "in.liggghts", "-log", "none"],
                cwd=folder, env=environment, capture_output=True, text=True, timeout=120, check=False)
            if done.returncode != 0:
                raise AssertionError(done.stdout[-2000:] + done.stderr[-1000:])
            if "instructions portable" in done.stdout:
                raise unittest.SkipTest("walls are the host's on a machine without vector instructions")
            self.text = done.stdout[done.stdout.rindex("Setting up run"):]
            self.states = {path.name: [[float(word) for word in line.split()]
                                       for line in path.read_text().splitlines()[9:]]
                           for path in folder.glob("state.*")}
            self.why_whole = re.findall("made anew all at once, because (.*)", done.stdout)
        self.builds = int(re.search(r"Neighbor list builds = (\d+)", self.text)[1])
        found = re.search(r"(\d+) times a grain got new pairs", self.text)
        self.renewals = int(found[1]) if found else None


def greatest_difference(a, b):
    """Of each column of all dumps, relative to its greatest value."""
    greatest = 0.0
    for name in a.states:
        for one, other in zip(zip(*a.states[name]), zip(*b.states[name])):
            scale = max(map(abs, one)) or 1.0
            greatest = max(greatest, max(abs(p - q) for p, q in zip(one, other)) / scale)
    return greatest


class RenewedLists(unittest.TestCase):
    # Sums of forces come in another order, and collisions make more of a round-off of 1e-16.
    def agree(self, ranks, fewer, **case):
        whole, single = Run("whole", ranks, **case), Run("single", ranks, **case)
        self.assertEqual(len(whole.states), 4)
        self.assertGreater(len(whole.states["state.400"]), 1300)
        self.assertLess(greatest_difference(whole, single), 1e-8)
        self.assertIsNone(whole.renewals)
        self.assertEqual(whole.why_whole, ["GASGRAIN_LISTS asks for it"])
        self.assertEqual(single.why_whole, [])
        self.assertGreater(single.renewals, 4000)
        self.assertLess(fewer * single.builds, whole.builds)
        return single

    def test_between_walls(self):
        self.agree(1, 3, sides="f")

    def test_two_ranks_with_ghosts_from_further_away(self):
        self.agree(2, 2, sides="f", cutoff="cutoff 0.006")

    def test_two_ranks_and_a_periodic_side(self):
        self.agree(2, 2, cutoff="cutoff 0.01")

    def test_fast_grains_near_to_ghosts_ask_for_all_lists(self):
        whole, single = Run("whole", 2), Run("single", 2)
        self.assertLess(greatest_difference(whole, single), 1e-8)
        self.assertLess(single.builds, whole.builds)

    def test_one_flies_to_where_nobody_knows_of_it(self):
        for ranks, sides in ((2, "f"), (1, "f")):
            whole, single = (Run(lists, ranks, sides=sides, motion=ONE) for lists in ("whole", "single"))
            self.assertLess(greatest_difference(whole, single), 1e-8)
            hit = [row for row in single.states["state.400"] if row[5] > 1.0]
            self.assertEqual(len(hit), 1)
            self.assertGreater(hit[0][2], 0.04)  # it was thrown on
            self.assertLess(single.builds, whole.builds)

    def test_single_contacts_are_told_as_well(self):
        computes = "compute pairs all pair/gran/local id force"
        more = "dump pairs all local 100 pairs.* c_pairs[1] c_pairs[2] c_pairs[4]"
        self.agree(1, 3, sides="f", computes=computes, more=more)

    def test_who_else_needs_lists_gets_them_all(self):
        run = Run("single", 1, more="compute near all contact/atom\nfix near all ave/atom 1 1 1 c_near")
        self.assertEqual(run.why_whole, ["somebody else has a list of neighbours"])
        self.assertIsNone(run.renewals)


if __name__ == "__main__":
    unittest.main(verbosity=2)
