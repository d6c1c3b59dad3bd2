#!/usr/bin/python3
"""Parcels in scripts of the real program, without a gas: falling, leaving, coming in, going on."""

import math
import unittest

import numpy as np

from parcel_scripts import HOST, Atom, Scene, cloud, dump, largest_difference, refused, thermo

ROUND_OFF = 1e-12  # of sums and of what ranks add up in another order
PACKING = 0.6
STATE = "x y z vx vy vz radius mass f_particlesPerParcel"


def rows_of(frame):
    return np.array([frame[n] for n in sorted(frame)])


class FallingColumn(unittest.TestCase):
    """Solids of half of the box's cells fall onto its floor and come to rest."""

    SIZE = (0.02, 0.02, 0.08)
    RADIUS = 5e-4
    NUMBER = 4.0  # particles a parcel
    SCRIPT = ("timestep 5e-4\nfix g all gravity 9.81 vector 0 0 -1\n"
              "fix p all parcels particles 4 close_packing 0.6 walls x_lo x_hi y_lo y_hi z_lo z_hi {more} cells 4 4 16\n")

    @classmethod
    def column(cls, fraction=0.35, height=0.06):
        volume = cls.NUMBER * 4.0 / 3.0 * math.pi * cls.RADIUS**3
        n = round((fraction * cls.SIZE[0] * cls.SIZE[1] * height / volume) ** (1 / 3) * 3**(-1 / 3))
        pitch = (cls.SIZE[0] / n, cls.SIZE[1] / n, height / (3 * n))
        return [Atom([(i + 0.5) * h for i, h in zip((a, b, c), pitch)], radius=cls.RADIUS)
                for a in range(n) for b in range(n) for c in range(3 * n)]

    def fall(self, ranks=1, more="damping on 0.9", steps=500):
        atoms = self.column()
        with Scene(self.SIZE, atoms) as scene:
            text = scene.run(self.SCRIPT.format(more=more) + thermo("ke f_p[1] f_p[2] f_p[3] f_p[9] f_p[10] f_p[15]") +
                             dump(STATE, steps) + f"run {steps}\n", ranks, boundary="f f f")
            return atoms, scene.log()[-1], scene.dump("last.dump", 0), scene.dump("last.dump"), text

    def test_never_passes_close_packing_by_more_than_a_hundredth_and_comes_to_rest(self):
        atoms, log, first, last, _ = self.fall()
        self.assertLess(log[0]["p[10]"], 0.7)
        self.assertGreater(max(row["p[10]"] for row in log), 0.9)
        self.assertLess(max(row["p[10]"] for row in log), 1.01 * (1.0 + 1e-9))  # and round-off
        rows = rows_of(last)
        self.assertEqual(len(rows), len(atoms))
        for row in log:
            self.assertEqual((row["p[1]"], row["p[2]"]), (len(atoms), self.NUMBER * len(atoms)))
            self.assertLess(row["p[9]"], ROUND_OFF)
        solids = len(atoms) * self.NUMBER * 4.0 / 3.0 * math.pi * self.RADIUS**3
        # Twice the mean height of a bed at close packing, which no bed can be below by more than its hundredth;
        # above it by half a cell (of the deposit) and what the stress keeps open.
        packed = solids / (self.SIZE[0] * self.SIZE[1] * PACKING)
        height = 2.0 * rows[:, 2].mean()
        self.assertGreater(height, 0.9 * packed)
        self.assertLess(height, 1.3 * packed)
        # at rest: below a hundredth of the fall's energy
        mass = 2000.0 * solids
        self.assertLess(np.mean(np.sum(rows[:, 3:6]**2, axis=1)) / 2, 0.02 * 9.81 * (0.06 - height) / 2)
        self.assertLess(abs(log[0]["p[3]"] / mass - 1.0), ROUND_OFF)
        self.assertGreater(log[-1]["p[15]"], 0.0)

    def test_the_same_on_four_ranks_with_damping_and_isotropy(self):
        more = "damping on 0.9 isotropy on 0.9 0.4"
        results = [self.fall(ranks, more, steps=60) for ranks in (1, 4)]
        self.assertLess(largest_difference(results[0][3], results[1][3]), 1e-11)


class OpenSides(unittest.TestCase):
    SIZE = (0.04, 0.04, 0.04)

    def test_what_leaves_is_booked_at_every_step(self):
        with Scene(self.SIZE, cloud(200, self.SIZE, 1)) as scene:
            for ranks in (1, 4):
                scene.run("timestep 1e-3\nfix p all parcels stress off particles 7.5 walls z_lo cells 4 4 4\n" +
                          thermo("atoms f_p[1] f_p[3] f_p[5] f_p[7] f_p[9]") + "run 60\n", ranks, boundary="f p f")
                log = scene.log()[-1]
                self.assertGreater(log[-1]["p[7]"], 0.2 * log[0]["p[3]"])
                self.assertGreater(log[-1]["Atoms"], 5)
                for row in log:
                    self.assertLess(row["p[9]"], ROUND_OFF)
                    self.assertEqual(row["Atoms"], row["p[1]"])

    def test_all_may_leave(self):
        with Scene(self.SIZE, [Atom((0.039, 0.02, 0.02), (3.0, 0.0, 0.0))]) as scene:
            scene.run("timestep 1e-3\nfix p all parcels cells 4 4 4\n" + thermo("atoms f_p[7] f_p[9]") + "run 5\n",
                      2, boundary="f f f")
            last = scene.log()[-1][-1]
            self.assertEqual((last["Atoms"], last["p[9]"]), (0, 0))

    def test_on_the_upper_side_an_open_one_lets_out_and_a_wall_and_a_period_keep(self):
        edge = 0.04
        with Scene(self.SIZE, [Atom((0.01, 0.01, 0.01))] * 4) as scene:
            for ranks in (1, 4):
                scene.run("timestep 1e-3\nfix p all parcels walls x_lo x_hi z_lo cells 4 4 4\n"
                          f"set atom 1 x {edge}\nset atom 2 y {edge}\nset atom 3 z {edge}\nset atom 4 x 0.0 y 0.0 z 0.0\n" +
                          thermo("atoms f_p[1] f_p[9]") + dump(STATE, 2) + "run 2\n", ranks, boundary="f p f")
                self.assertEqual(set(scene.dump("last.dump")), {1, 2, 4})
                for row in scene.log()[-1]:
                    self.assertEqual((row["Atoms"], row["p[1]"], row["p[9]"]), (3, 3, 0))
                # a radius from the wall
                self.assertAlmostEqual(scene.dump("last.dump")[1][0], edge - 1e-3, delta=1e-6)


class Walls(unittest.TestCase):
    def test_keep_their_shares_of_the_velocity(self):
        with Scene((0.04, 0.04, 0.04), [Atom((0.02, 0.02, 0.0395), (0.5, -0.25, 2.0), radius=1e-4)]) as scene:
            scene.run("timestep 1e-3\nfix p all parcels stress off walls z_hi retention 0.4 0.9 cells 4 4 4\n" +
                      dump(STATE, 1) + "run 1\n", boundary="f f f")
            x, v = np.array(scene.dump("last.dump")[1][:3]), scene.dump("last.dump")[1][3:6]
            for got, expected in zip(v, (0.45, -0.225, -0.8)):
                self.assertAlmostEqual(got, expected, delta=1e-14)
            # 0.4 mm to the wall's plane, a radius before the side; the rest of the way with the new velocity
            rest = 1e-3 - 0.0004 / 2.0
            for got, expected in zip(x, (0.02 + 0.5 * 2e-4 + 0.45 * rest, 0.02 - 0.25 * 2e-4 - 0.225 * rest,
                                         0.0399 - 0.8 * rest)):
                self.assertAlmostEqual(got, expected, delta=1e-15)


JETS = ("fix drops all parcels/inject at 0.005 0.02 0.02 nozzle_radius 0.002 direction 1 0.1 0 half_angle 15 speed 4 "
        "mass_flow 0.01 size lognormal 1e-4 0.3 liquid 930 water 0.4 oil 0.6 parcels_per_second 2e4 from 1e-3 seed 3 {drops}\n"
        "fix feed all parcels/inject face x_lo rectangle 0.01 0.03 0.01 0.03 fraction 0.05 speed 2 size constant 2e-4 "
        "solid 2000 particles 40 type 2 seed 5 {feed}\n")


class Injection(unittest.TestCase):
    SIZE = (0.06, 0.04, 0.04)
    BED = ("timestep 5e-4\nfix g all gravity 9.81 vector 0 0 -1\n"
           "fix p all parcels walls x_lo y_lo y_hi z_lo z_hi damping on 0.9 isotropy on 0.9 0.4 cells 6 4 4\n"
           "fix e all collisional_exchange close_packing 0.6 species water density 998 species oil density 850 {exchange}\n")
    COLUMNS = STATE + " type f_liquidFilm f_e[1] f_e[2]"
    SUMS = "atoms " + " ".join(f"f_p[{n}]" for n in range(1, 11)) + " f_e[1] f_e[2] " + \
           " ".join(f"f_drops[{n}] f_feed[{n}]" for n in (1, 2, 3, 4, 5, 6, 7))

    def script(self, drops="", feed="", exchange=""):
        return self.BED.format(exchange=exchange) + JETS.format(drops=drops, feed=feed)

    def run_bed(self, ranks):
        with Scene(self.SIZE, types=2) as scene:
            scene.run(self.script() + thermo(self.SUMS) + dump(self.COLUMNS, 80) + "run 80\n", ranks, boundary="f f f")
            return scene.log()[-1], scene.dump("last.dump")

    def test_injected_is_contained_plus_left_at_every_step_on_any_number_of_ranks(self):
        results = {ranks: self.run_bed(ranks) for ranks in (1, 4)}
        for log, _ in results.values():
            self.check_sums(log)
        self.assertLess(largest_difference(results[1][1], results[4][1]), 1e-11)

    def check_sums(self, log):
        end = log[-1]
        self.assertGreater(end["p[7]"], 0.1 * end["p[5]"])  # solids have left
        self.assertGreater(end["p[8]"], 0.1 * end["p[6]"])  # and liquid
        rate = 0.05 * 2000.0 * 2.0 * 0.02 * 0.02
        for row in log:
            time = 5e-4 * row["Step"]
            drops = 0.01 * max(0.0, time - 1e-3)
            # what has come in, and what lacks to the next whole parcel
            self.assertLess(abs(row["drops[1]"] + row["drops[2]"] - drops), ROUND_OFF * 0.01 * 0.04)
            self.assertLess(abs(row["feed[1]"] + row["feed[2]"] - rate * time), ROUND_OFF * rate * 0.04)
            # a parcel that lacks no more than round-off is whole
            self.assertTrue(-1e-9 * 0.01 / 2e4 <= row["drops[2]"] <= 0.01 / 2e4)
            self.assertLess(row["p[9]"], ROUND_OFF)
            if row["Step"] < 4:
                continue
            for one, other in ((row["p[6]"], row["drops[1]"]),
                               (row["p[5]"], row["feed[3]"] + row["drops[3]"]),
                               (row["p[3]"] + row["p[7]"], row["feed[1]"] + row["drops[3]"]),
                               (row["p[4]"] + row["p[8]"], row["drops[1]"]),
                               (row["e[1]"] + row["e[2]"], row["p[4]"]),
                               (row["drops[6]"], 0.4 * row["drops[1]"]), (row["drops[7]"], 0.6 * row["drops[1]"]),
                               (row["feed[4]"], 40.0 * row["feed[5]"])):
                self.assertLess(abs(one / other - 1.0), ROUND_OFF)
            self.assertEqual(row["Atoms"], row["p[1]"])

    def test_a_restart_amid_injection_goes_on_bit_for_bit_on_as_many_ranks(self):
        for ranks in (1, 2):
            with Scene(self.SIZE, types=2) as scene:
                script = self.script(drops="to 0.013", exchange="every 2")
                scene.run(script + "run 15\nwrite_restart half.restart\nrun 25\n" + thermo(self.SUMS) +
                          dump(self.COLUMNS, 40) + "run 0\n", ranks, boundary="f f f")
                whole, sums = scene.raw_dump("last.dump"), scene.log()[-1][-1]
                reference = scene.dump("last.dump")
                for others in (ranks, 3 - ranks):
                    scene.run(script + "run 25\n" + thermo(self.SUMS) + dump(self.COLUMNS, 40) + "run 0\n", others,
                              boundary="f f f", start="read_restart half.restart\n")
                    again = scene.log()[-1][-1]
                    if others == ranks:
                        self.assertEqual(scene.raw_dump("last.dump"), whole)
                    self.assertLess(largest_difference(scene.dump("last.dump"), reference), 1e-11)
                    for name, value in sums.items():
                        if name not in ("p[9]", "drops[2]", "feed[2]"):
                            self.assertLess(abs(again[name] - value), ROUND_OFF * abs(value) + 1e-30, name)
                    self.assertLess(again["p[9]"], ROUND_OFF)

    def test_a_checkpoint_within_a_run_goes_on_as_if_nothing_had_happened(self):
        # The host computes forces anew after a restart, with the velocities of the whole step. Only the limiter
        # of the stress looks at them (and drag, which is not here).
        script = self.script(drops="to 0.013").replace("walls", "stress off walls")
        with Scene(self.SIZE, types=2) as scene:
            scene.run(script + "restart 15 half.*.restart\n" + dump(self.COLUMNS, 40) + "run 40\n", boundary="f f f")
            whole = scene.dump("last.dump")
            scene.run(script + dump(self.COLUMNS, 40) + "run 25\n", boundary="f f f", start="read_restart half.15.restart\n")
            self.assertLess(largest_difference(scene.dump("last.dump"), whole), 1e-11)

    def test_another_timestep_or_step_number_and_a_late_source_do_not_change_the_flow(self):
        sums = thermo("atoms f_p[5] f_p[9] f_feed[1] f_feed[2] f_feed[5]")
        with Scene(self.SIZE, types=2) as scene:
            scene.run(self.BED.format(exchange="") + "run 30\n" + JETS.format(drops="to 1e-2", feed="") + sums +
                      "run 4\nreset_timestep 0\nrun 4\ntimestep 1e-3\nrun 3\nreset_timestep 5000\ntimestep 1e-4\nrun 10\n",
                      boundary="f f f")
            rate = 0.05 * 2000.0 * 2.0 * 0.02 * 0.02
            ends = [run[-1] for run in scene.log()[-4:]]
            for row, time in zip(ends, (2e-3, 4e-3, 7e-3, 8e-3)):
                self.assertAlmostEqual((row["feed[1]"] + row["feed[2]"]) / (rate * time), 1.0, delta=1e-10)
                self.assertLess(abs(row["feed[2]"]), rate * 1e-3)
                self.assertLess(row["p[9]"], ROUND_OFF)
            begin = next(row for row in scene.log()[1] if row["Step"] == 31)
            self.assertLess(begin["feed[1]"], 1.01 * rate * 5e-4)

    def test_a_restart_of_other_species_is_refused(self):
        with Scene(self.SIZE, types=2) as scene:
            scene.run(self.script() + "run 2\nwrite_restart first.restart\n", boundary="f f f")
            # films of another fix's name are not looked at
            other = self.script().replace("fix e all", "fix other all").replace(" species oil density 850", "").replace("water 0.4 oil 0.6", "water 1")
            refused(self, scene, other + "run 1\n", "liquid species", boundary="f f f",
                    start="read_restart first.restart\n")


class Scripts(unittest.TestCase):
    SIZE = (0.04, 0.04, 0.04)
    P = "timestep 1e-4\nfix p all parcels particles 10 stress off cells 4 4 4\n"

    @classmethod
    def setUpClass(cls):
        cls.scene = Scene(cls.SIZE, cloud(60, cls.SIZE, 2))

    @classmethod
    def tearDownClass(cls):
        cls.scene.held.cleanup()

    def last(self):
        return self.scene.log()[-1][-1]

    def test_particles_a_parcel_can_be_given_one_by_one(self):
        self.scene.run(self.P + "run 0\nset atom 1*20 property/atom particlesPerParcel 2.5\n" +
                       thermo("f_p[1] f_p[2] f_p[3] f_p[9]") + dump(STATE, 5) + "run 5\n", 2)
        rows = rows_of(self.scene.dump("last.dump"))
        self.assertEqual(set(rows[:20, 8]), {2.5})
        self.assertEqual(set(rows[20:, 8]), {10.0})
        row = self.last()
        self.assertEqual((row["p[1]"], row["p[2]"]), (60, 450))
        self.assertLess(abs(row["p[3]"] / np.sum(rows[:, 8] * rows[:, 7]) - 1.0), ROUND_OFF)
        self.assertLess(row["p[9]"], ROUND_OFF)

    def test_a_script_may_take_parcels_away_and_make_new_ones_between_runs(self):
        text = self.scene.run(self.P + thermo("atoms f_p[1] f_p[2] f_p[3] f_p[7] f_p[9]") +
                              "run 3\nregion half block 0 0.02 0 0.04 0 0.04 units box\ndelete_atoms region half compress no\nrun 3\n"
                              "group old union all\ncreate_atoms 1 single 0.01 0.01 0.01 units box\ngroup new subtract all old\n"
                              "set group new diameter 0.001 density 2000\nrun 3\n"
                              "delete_atoms group all compress no\nrun 3\n", 2)
        runs = self.scene.log()
        self.assertLess(runs[1][-1]["Atoms"], 60)
        self.assertEqual(runs[3][-1]["Atoms"], 0)
        self.assertEqual(runs[2][-1]["Atoms"], runs[1][-1]["Atoms"] + 1)
        for run in runs:
            for row in run:
                self.assertLess(row["p[9]"], ROUND_OFF, text)
                self.assertEqual(row["p[2]"], 10 * row["Atoms"])
        # what is taken away has gone
        self.assertLess(abs(runs[1][0]["p[7]"] / (runs[0][-1]["p[3]"] - runs[1][-1]["p[3]"]) - 1.0), ROUND_OFF)
        new = runs[2][-1]["p[3]"] - runs[1][-1]["p[3]"]
        self.assertAlmostEqual(new / (10 * 2000 * math.pi / 6 * 1e-9), 1.0, delta=1e-9)

    def test_two_runs_are_one_run(self):
        self.scene.run(self.P + "run 20\n" + dump(STATE, 20) + "run 0\n")
        whole = self.scene.raw_dump("last.dump")
        self.scene.run(self.P + "run 9\nrun 11\n" + dump(STATE, 20) + "run 0\n")
        self.assertEqual(self.scene.raw_dump("last.dump"), whole)

    def test_fixes_can_be_taken_away_and_made_anew_and_cleared(self):
        again = thermo("f_p[2] f_p[9]") + "run 3\n"
        plain = "thermo_style one\n"
        self.scene.run(self.P + "fix e all collisional_exchange species water density 998\nrun 3\nunfix e\nrun 3\n" + plain +
                       "unfix p\n" + self.P.replace("particles 10", "particles 3") + again + plain +
                       "unfix p\nfix n all nve/sphere\nrun 2\n")
        self.assertEqual(self.scene.log()[-2][-1]["p[2]"], 180)
        head = ("atom_style granular\natom_modify map array sort 0 0\nunits si\nboundary p p p\nnewton off\n"
                "communicate single vel yes\nread_data atoms.data\npair_style none\nneighbor 0.002 bin\n")
        self.scene.run(self.P + "run 3\nclear\n" + head + self.P + again, 2)
        self.assertEqual(self.scene.log()[-1][-1]["p[2]"], 600)
        self.assertLess(self.scene.log()[-1][-1]["p[9]"], ROUND_OFF)


class Refusals(unittest.TestCase):
    SIZE = (0.04, 0.04, 0.04)
    P = "fix p all parcels cells 2 2 2\n"
    JET = "fix j all parcels/inject "

    @classmethod
    def setUpClass(cls):
        cls.scene = Scene(cls.SIZE, cloud(5, cls.SIZE, 6))

    @classmethod
    def tearDownClass(cls):
        cls.scene.held.cleanup()

    def refuse(self, body, *expected, **options):
        refused(self, self.scene, body, *expected, **options)

    def test_scenes_that_cannot_be(self):
        contacts = ("neighbor 0.002 bin\nfix m1 all property/global youngsModulus peratomtype 5e6\n"
                    "fix m2 all property/global poissonsRatio peratomtype 0.45\n"
                    "fix m3 all property/global coefficientRestitution peratomtypepair 1 0.7\n"
                    "pair_style gran/bridge model hertz tangential off\npair_coeff * *\n")
        if HOST == "lammps":
            contacts = "neighbor 0.002 bin\npair_style gran/hertz/history 5e6 NULL 50 NULL 0.5 1\npair_coeff * *\n"
        self.refuse(contacts + self.P + "run 1\n", f"in.{HOST}", "parcels have no contacts", "pair_style none")
        self.refuse(self.P + "fix n all nve/sphere\nrun 1\n", "fix n nve/sphere", "Take it away", ranks=2)
        self.refuse(self.P + self.P.replace("fix p", "fix q"), "there is a fix parcels already")
        self.refuse("fix p all parcels\nrun 1\n", "no cells", "'cells NX NY NZ'")
        self.refuse(self.JET + "face x_lo fraction 0.1 speed 1 size constant 1e-4 solid 1000 particles 1\n",
                    "needs a fix parcels before it")

    def test_sources_that_cannot_be(self):
        self.refuse(self.P + self.JET + "face x_lo fraction 0.7 speed 1 size constant 1e-4 solid 1000 particles 1\n",
                    "fraction 0.7", "above close_packing 0.6", "Lower")
        nozzle = "direction 1 0 0 speed 1 mass_flow 1 size constant 1e-4 "
        self.refuse(self.P + "fix e all collisional_exchange species water density 998\n" + self.JET + "at 0.01 0.01 0.01 " +
                    nozzle + "liquid 900 watr 1.0 particles 1\n", "watr", "water")
        self.refuse("timestep 1e-4\n" + self.P + self.JET + "at 0.05 0.01 0.01 " + nozzle + "solid 900 particles 100\nrun 10\n",
                    "outside of the box", "move the opening inwards", boundary="f f f", ranks=2)
        self.refuse(self.P + self.JET + "at 0.01 0.01 0.01 direction 1 0 0 speed -1 mass_flow -2 size constant -1e-4 solid -9 particles -1\n",
                    "speed", "mass_flow", "size", "solid", "particles")
        self.refuse(self.P.replace("cells", "particles -3 close_packing 1.5 wals x_lo cells"),
                    "particles -3", "close_packing 1.5", 'Did you mean "walls"?')

    def test_values_of_atoms_that_are_none(self):
        self.refuse(self.P + "run 0\nset atom 2 property/atom particlesPerParcel -4\nrun 1\n", "particlesPerParcel of atom 2 is -4")
        self.refuse(self.P + "run 1\nset group all density 500\nrun 1\n", "mass of atom", "before the first run")
        self.refuse("timestep 1e-4\n" + self.P + "run 1\nset atom 2 vx 1e400\nrun 2\n", "atom 2", "not a number")


if __name__ == "__main__":
    unittest.main(verbosity=2)
