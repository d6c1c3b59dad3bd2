#!/usr/bin/python3
"""Limits on bridges and films, small and large amounts of liquid, and input that is refused."""

import math
import unittest

from wet_bed import DUMP, HOST, LIQUID, SCRIPT_NAME, Bed, floor, random_grains

WATER = "surface_tension 0.0728 contact_angle 0.35"


def liquid(words, tail="every 50 output liquid.csv"):
    return f"fix wet all liquid {words} {tail}"


def cluster_of_13(radius, middle):
    """A grain and the twelve that touch it, as packed most densely."""
    half = math.sqrt(2.0) * radius
    sites = [(0, 0, 0)] + [s for a in (-half, half) for b in (-half, half)
                           for s in ((a, b, 0), (a, 0, b), (0, a, b))]
    lines = [f"create_atoms 1 single {middle + x:.15g} {middle + y:.15g} {middle + z:.15g} units box"
             for x, y, z in sites]
    return "\n".join(lines + [f"set group all diameter {2.0 * radius} density 2500"])


class Limits(unittest.TestCase):
    def last(self, bed, ranks, steps, file="last.dump"):
        bed.run(ranks, runs=DUMP.format(every=steps, file=file) + f"run {steps}")
        return bed.dump(file)

    def test_a_grain_with_twelve_bridges_keeps_its_books(self):
        for ranks in (1, 2):
            with Bed(grains=cluster_of_13(0.001, 0.006), liquid=liquid("film 1e-11 " + WATER), step=1e-7) as bed:
                grains = self.last(bed, ranks, 50)
                rows = bed.ledger()
            self.assertEqual(max(row[10] for row in grains.values()), 12)
            self.assertEqual(rows[-1]["bridge_count"], 36)
            self.assertLess(abs(rows[-1]["residual"]), 1e-14)

    def test_no_grain_has_more_bridges_than_the_limit(self):
        for most in (1, 3):
            alike = []
            for ranks in (1, 2):
                with Bed(grains=random_grains(343, 0.012, 11), liquid=liquid(f"{LIQUID} bridges_max {most}")) as bed:
                    grains = self.last(bed, ranks, 300)
                    rows = bed.ledger()
                bridges = [row[10] for row in grains.values()]
                self.assertLessEqual(max(bridges), most)
                self.assertGreater(bridges.count(most), 20)
                self.assertLess(max(abs(row["residual"]) for row in rows), 1e-12)
                alike.append(bridges)
            self.assertEqual(alike[0], alike[1])

    def test_the_least_film_stays_on_the_grain_whatever_is_asked_for(self):
        least = 2e-12
        with Bed(grains=random_grains(343, 0.012, 12), liquid=liquid(f"film 1e-11 {WATER} gives 1 film_min {least}")) as bed:
            grains = self.last(bed, 2, 300)
            rows = bed.ledger()
        films = [row[9] for row in grains.values()]
        # a few roundings of the film as it was before bridges took from it
        self.assertGreaterEqual(min(films), least - 1e-26)
        self.assertLess(min(films), 1.001 * least)
        self.assertLess(max(abs(row["residual"]) for row in rows), 1e-12)

    def test_the_smallest_volumes_are_kept(self):
        for film in (1e-18, 1e-21, 1e-24):
            with Bed(grains=random_grains(125, 0.01, 13), size=0.01, liquid=liquid(f"film {film} {WATER} formation touch")) as bed:
                bed.run(2, runs="run 300")
                rows = bed.ledger()
            self.assertGreater(rows[-1]["formed"], 50)
            self.assertLess(max(abs(row["residual"]) for row in rows), 1e-12)

    def test_a_viscosity_beyond_the_step_neither_blows_up_nor_goes_unsaid(self):
        with Bed(grains=random_grains(216, 0.01, 14, speed=1.0), size=0.01,
                 liquid=liquid(f"content 0.02 {WATER} viscosity 100 minimum_separation 1e-7")) as bed:
            text = bed.run(runs="thermo_style custom step ke\nthermo 50\nrun 1000")
        energies = [float(line.split()[1]) for line in text.splitlines()
                    if len(line.split()) == 2 and line.split()[0].isdigit()]
        self.assertLess(energies[-1], energies[0])
        self.assertTrue(all(math.isfinite(e) for e in energies))
        self.assertIn("were held back", text)

    @unittest.skipIf(HOST == "lammps", "LAMMPS has no walls of triangles")
    def test_a_bridge_goes_from_triangle_to_triangle_of_a_wall_with_the_same_force_all_the_way(self):
        with Bed(grains="create_atoms 1 single 0.002 0.0031 0.00101 units box\nset group all diameter 0.002 density 2500",
                 boundary="f f f", size=0.012, skin=0.0008, step=1e-6,
                 walls="fix floor all mesh/surface/planar file floor.stl type 1\n"
                       "fix low all wall/gran model hertz tangential history cohesion bridge mesh n_meshes 1 meshes floor",
                 liquid=liquid(f"film 1e-11 {WATER} gives 1 formation 2e-5")) as bed:
            (bed.folder / "floor.stl").write_text(floor(0.012, 6))
            bed.run(runs="run 10\nunfix nve\nfix mv all move linear 1.5 0 0.0\n"
                         "dump d all custom 1 path.dump id fz\nrun 5000")
            forces = [float(line.split()[1]) for line in (bed.folder / "path.dump").read_text().splitlines()
                      if len(line.split()) == 2 and line.startswith("1 ")]
        self.assertEqual(len(forces), 5001)
        self.assertLess(max(forces), 0.0)
        self.assertLess(max(forces) - min(forces), 1e-9 * abs(min(forces)))

    def test_liquid_beyond_the_pendular_range_is_warned_of(self):
        for content, warned in ((0.02, False), (0.6, True)):
            with Bed(grains=random_grains(216, 0.01, 15), size=0.01, liquid=liquid(f"content {content} {WATER}")) as bed:
                self.assertEqual("voids between them" in bed.run(runs="run 200"), warned)


class Refused(unittest.TestCase):
    def refused(self, *parts, **script):
        with Bed(grains=random_grains(8, 0.01, 21), size=0.01, **script) as bed:
            text = " ".join(bed.run(fails=True).split())
        for part in parts:
            self.assertIn(part, text)

    def test_all_faults_of_a_line_together(self):
        self.refused("content -0.1: must be from 0 to 1", "surface_tension -1", "If it is in degrees, write 0.523599",
                     'law "mikammi" is unknown. Did you mean "mikami"?', '"filmmin" is no keyword. Did you mean "film_min"?',
                     SCRIPT_NAME + ":", liquid="fix wet all liquid content -0.1 surface_tension -1 contact_angle 30 law mikammi filmmin")

    def test_negative_film(self):
        self.refused("film -1e-12: must be from 0 to 1", liquid=f"fix wet all liquid film -1e-12 {WATER}")
        self.refused("the liquidFilm of grain", "give m3, 0 or more",
                     liquid=f"fix wet all liquid film 1e-12 {WATER}\nrun 0\nset group all property/atom liquidFilm -1e-12")

    def test_missing_numbers(self):
        self.refused("there is no liquid", "surface_tension is missing", "contact_angle is missing",
                     liquid="fix wet all liquid law willett")
        self.refused("viscosity and minimum_separation belong together", liquid=f"fix wet all liquid content 0.01 {WATER} viscosity 0.001")

    def test_bridges_without_liquid_and_liquid_without_bridges(self):
        self.refused("has no liquid", "fix liquid all liquid content", liquid="")
        wall = "gran" if HOST == "liggghts" else "gran/bridge"
        self.refused(f"neither 'pair_style gran/bridge' nor a 'fix wall/{wall}' has 'cohesion bridge'", cohesion="")

    def test_a_wall_that_is_not_there(self):
        self.refused('wall "flor" is no fix wall/gran', 'Did you mean "floor"?', liquid=f"fix wet all liquid {LIQUID} wall flor 1e-4",
                     boundary="p p f", skin=0.004,
                     walls="fix floor all wall/gran model hertz tangential history cohesion bridge primitive type 1 zplane 0.0")

    def test_a_second_fix_another_unit_another_group(self):
        line = f"all liquid {LIQUID}"
        self.refused("a scene has one", liquid=f"fix a {line}\nfix b {line}")
        self.refused("must be 'all'", liquid=f"group some id 1 2\nfix a some liquid {LIQUID}")


if __name__ == "__main__":
    unittest.main(verbosity=2)
