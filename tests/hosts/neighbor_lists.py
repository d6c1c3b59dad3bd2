#!/usr/bin/python3
"""Neighbour lists made from sorted grains are those of the stock program: grains move alike to the
last bit, and what keeps or reads contacts (history, walls of meshes, liquid between grains,
exclusions, restarts) goes on as there."""

import pathlib
import subprocess
import tempfile
import unittest

from coupled_launch import BIN

OURS = str(BIN / "gasgrain-liggghts")
STOCK = "liggghts"

# Grains of three sizes (the longest reach is not that of most pairs) fall and are thrown about: they
# cross ranks, the periodic side and the bins, and the host sorts its arrays every 100 steps.
BED = """
atom_style    granular
atom_modify   map array sort 100 0.0
boundary      p f f
newton        off
communicate   single vel yes
units         si
processors    * 1 1
region        box block 0 0.06 0 0.03 0 0.12 units box
create_box    2 box
region        fill block 0 0.06 0 0.03 0 0.05 units box
neighbor      {skin} bin
neigh_modify  delay 0
timestep      1e-5
fix m1 all property/global youngsModulus peratomtype 5e6 5e6
fix m2 all property/global poissonsRatio peratomtype 0.3 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 2 0.7 0.7 0.7 0.7
fix m4 all property/global coefficientFriction peratomtypepair 2 0.4 0.4 0.4 0.4
{properties}
pair_style    gran model hertz tangential history {cohesion}
pair_coeff    * *
{walls}
fix y0 all wall/gran model hertz tangential history {cohesion} primitive type 1 yplane 0.0
fix y1 all wall/gran model hertz tangential history {cohesion} primitive type 1 yplane 0.03
fix g all gravity 9.81 vector 0.2 0.1 -1
fix s1 all particletemplate/sphere 15485863 atom_type 1 density constant 2500 radius constant 0.0010
fix s2 all particletemplate/sphere 15485867 atom_type 2 density constant 2500 radius constant 0.0016
fix s3 all particletemplate/sphere 32452843 atom_type 2 density constant 2500 radius constant 0.0027
fix d all particledistribution/discrete 32452867 3 s1 0.3 s2 0.5 s3 0.2
fix in all insert/pack seed 49979687 distributiontemplate d maxattempt 200 insert_every once &
    overlapcheck yes all_in yes vel constant 0.8 0.4 -1.5 region fill particles_in_region 1000
fix move all nve/sphere
dump state all custom 300 state.* id type x y z vx vy vz omegax omegay omegaz fx fy fz
dump_modify state sort id format "%d %d %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g"
thermo_style  custom step atoms ke
thermo        300
thermo_modify lost ignore norm no
{more}
run           900
"""

FLOOR = "fix z0 all wall/gran model hertz tangential history {} primitive type 1 zplane 0.0"

MESH = """fix plate all mesh/surface file plate.stl type 1
fix z0 all wall/gran model hertz tangential history mesh n_meshes 1 meshes plate"""

PLATE = """solid plate
facet normal 0 0 1
outer loop
vertex -0.01 -0.01 0.02
vertex 0.07 -0.01 0.03
vertex 0.07 0.04 0.03
endloop
endfacet
facet normal 0 0 1
outer loop
vertex -0.01 -0.01 0.02
vertex 0.07 0.04 0.03
vertex -0.01 0.04 0.02
endloop
endfacet
endsolid plate
"""

WASHINO = """fix w1 all property/global minSeparationDistanceRatio scalar 1.01
fix w2 all property/global maxSeparationDistanceRatio scalar 1.1
fix w3 all property/global surfaceLiquidContentInitial scalar 0.02
fix w4 all property/global surfaceTension scalar 0.05
fix w5 all property/global fluidViscosity scalar 1e-3
fix w6 all property/global contactAngle peratomtype 0.3 0.3
fix w7 all property/global maxLiquidContent scalar 0.5"""


def states(program, ranks, skin="0.0008", properties="", cohesion="", walls=None, more=""):
    """{file name: text} of all dumps; the numbers of lists made in each run, and the restart file."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "plate.stl").write_text(PLATE)
        script = BED.format(skin=skin, properties=properties, cohesion=cohesion, more=more,
                            walls=FLOOR.format(cohesion) if walls is None else walls)
        (folder / "in.liggghts").write_text(script)
        done = subprocess.run(
            ["mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none", "-np",
             str(ranks), program, "-in", "in.liggghts", "-log", "none"],
            cwd=folder, capture_output=True, text=True, timeout=120, check=False)
        if done.returncode != 0:
            raise AssertionError(done.stdout[-2000:] + done.stderr[-1000:])
        builds = [int(line.split("=")[1]) for line in done.stdout.splitlines()
                  if line.startswith("Neighbor list builds")]
        texts = {path.name: path.read_text() for path in sorted(folder.glob("state.*"))}
        kept = folder / "half"
        return texts, builds + [kept.read_bytes() if kept.exists() else b""]


class NeighborLists(unittest.TestCase):
    def same(self, ranks=(1,), **case):
        for count in ranks:
            stock, stock_builds = states(STOCK, count, **case)
            ours, our_builds = states(OURS, count, **case)
            self.assertEqual(our_builds[:-1], stock_builds[:-1])
            self.assertTrue(our_builds[-1] == stock_builds[-1], "the restart files differ")
            self.assertEqual(len(stock_builds[-1]) > 50_000, "write_restart" in case.get("more", ""))
            self.assertGreater(stock_builds[0], 3)
            self.assertEqual(sorted(ours), sorted(stock))
            del stock["state.0"]  # before the grains come
            self.assertGreaterEqual(len(stock), 3)
            for name, text in stock.items():
                self.assertGreater(text.count("\n"), 300)
                self.assertTrue(ours[name] == text, f"{name} differs, {count} ranks, {case}")

    def test_grains_of_three_sizes_on_one_and_two_ranks(self):
        self.same(ranks=(1, 2))

    def test_a_skin_wider_than_a_small_grain(self):
        self.same(skin="0.004")

    def test_walls_of_meshes_read_the_bins(self):
        self.same(walls=MESH)

    def test_liquid_bridges_beyond_contact(self):
        self.same(ranks=(2,), properties=WASHINO, cohesion="cohesion washino/capillary/viscous")

    def test_excluded_pairs_and_groups(self):
        self.same(more="neigh_modify exclude type 1 2")

    def test_grains_leave_through_the_bottom(self):
        self.same(walls="")

    def test_a_second_run_with_another_skin_and_a_restart_file(self):
        self.same(ranks=(2,), more="run 300\nneighbor 0.0015 bin\nwrite_restart half\nrun 100")


if __name__ == "__main__":
    unittest.main(verbosity=2)
