#!/usr/bin/python3
"""The collisional exchange in scripts of the real program: parcels and grains with films, without a gas."""

import unittest

import numpy as np

from parcel_scripts import HOST, Atom, Scene, cloud, dump, largest_difference, refused, thermo

ROUND_OFF = 1e-12  # of sums over hundreds of parcels and some steps: measured 1e-15 to 1e-13
SIZE = (0.04, 0.04, 0.04)
PACKING = "close_packing 0.6 k_solid 0.5 k_liquid 0.5"
LIQUIDS = ("species water density 998 heat 4180 range 273 373 "
           "species oil density 850 heat 1900 2.5 range 250 400")
DENSITY = (998.0, 850.0)
PARCELS = "timestep 1e-4\nfix p all parcels stress off cells 3 3 3 {walls}\n"
EXCHANGE = "fix e all collisional_exchange " + PACKING + " " + LIQUIDS + " film_temperature {T} {more}\n"
# droplets of both liquids, for 1 ms
DROPLETS = ("fix {name} all parcels/inject at 0.02 0.02 0.02 nozzle_radius 0.005 direction 1 0.3 0.2 half_angle 60 "
            "speed 2 mass_flow 0.02 size constant 1e-4 liquid 930 water 0.4 oil 0.6 parcels_per_second 5e4 "
            "from {start} to {end}\n")
COLUMNS = "x y z vx vy vz mass f_particlesPerParcel f_liquidFilm f_e[1] f_e[2] f_e[3]"
X, V, MASS, NUMBER, FILM, WATER, OIL, TEMPERATURE = slice(0, 3), slice(3, 6), 6, 7, 8, 9, 10, 11


def films(count, factor=1e-10):
    lines = [f"set atom {n} property/atom liquidFilm {factor * (n % 7):.6g}" for n in range(1, count + 1)]
    lines += [f"set atom {n} property/atom particlesPerParcel {1 + n % 5}.5" for n in range(1, count + 1)]
    return "run 0\n" + "\n".join(lines) + "\n"


def enthalpy(rows):
    """Of all films [J], from 273 K."""
    T = rows[:, TEMPERATURE]
    water = 4180.0 * (T - 273.0)
    oil = 1900.0 * (T - 273.0) + 1.25 * (T**2 - 273.0**2)
    return np.sum(rows[:, NUMBER] * (rows[:, WATER] * water + rows[:, OIL] * oil))


def rows_of(frame):
    return np.array([frame[n] for n in sorted(frame)])


def energy(rows):
    return 0.5 * np.sum(rows[:, NUMBER] * rows[:, MASS] * np.sum(rows[:, V]**2, axis=1))


class WarmCloud(unittest.TestCase):
    """Solids with films of 300 K and droplets, to which a second run adds droplets of 350 K."""

    STEPS = 12
    START = 10  # steps of the first run

    @classmethod
    def setUpClass(cls):
        cls.scene = Scene(SIZE, cloud(300, SIZE, 1, margin=0.006))
        cls.scene.run(PARCELS.format(walls="") + EXCHANGE.format(T=300, more="") + films(300) +
                      DROPLETS.format(name="cold", start=0, end=1e-3) +
                      f"run {cls.START}\nwrite_restart first.restart\n")

    @classmethod
    def tearDownClass(cls):
        cls.scene.held.cleanup()

    def go_on(self, boundary, more="", ranks=1):
        walls = "walls x_lo x_hi y_lo y_hi z_lo z_hi" if "f" in boundary else ""
        # the warm droplets are all there after two steps
        self.scene.run(PARCELS.format(walls=walls) + EXCHANGE.format(T=350, more=more) +
                       DROPLETS.format(name="warm", start=0, end=1.2e-3) + dump(COLUMNS, 1) +
                       thermo("f_p[9] f_p[11] f_e[1] f_e[2] f_e[3] f_e[4] f_e[6] f_e[7] f_warm[6]") +
                       f"run {self.STEPS}\n", ranks, boundary=boundary, start="read_restart first.restart\n")
        return [self.scene.dump("last.dump", self.START + n) for n in range(self.STEPS + 1)], self.scene.log()[-1]

    def test_conserves_species_momentum_and_enthalpy_on_any_number_of_ranks(self):
        for boundary in ("p p p", "f f f"):
            last = {}
            for ranks in (1, 2, 4):
                with self.subTest(boundary=boundary, ranks=ranks):
                    frames, log = self.go_on(boundary, ranks=ranks)
                    self.check_balances([rows_of(frame) for frame in frames[2:]], log[2:])
                    last[ranks] = frames[-1]
            self.assertLess(largest_difference(last[1], last[2]), ROUND_OFF)
            self.assertLess(largest_difference(last[1], last[4]), ROUND_OFF)

    def check_balances(self, frames, log):
        first = frames[0]
        self.assertEqual(len(first), 300 + 50 + 10)
        # Films of two temperatures, or the test of the enthalpy were one of a mass.
        self.assertGreater(np.ptp(first[:, TEMPERATURE]), 10.0)
        weight = (first[:, NUMBER] * first[:, MASS])[:, None]
        scale = np.sum(np.abs(weight * first[:, V]))
        for frame, row in zip(frames, log):
            for column, name in ((WATER, "e[1]"), (OIL, "e[2]")):
                held = np.sum(first[:, NUMBER] * first[:, column])
                self.assertLess(abs(np.sum(frame[:, NUMBER] * frame[:, column]) / held - 1.0), ROUND_OFF)
                self.assertLess(abs(row[name] / held - 1.0), ROUND_OFF)
            momentum = np.sum((frame[:, NUMBER] * frame[:, MASS])[:, None] * frame[:, V] - weight * first[:, V], axis=0)
            self.assertLess(np.abs(momentum).max() / scale, ROUND_OFF)
            self.assertLess(abs(enthalpy(frame) / enthalpy(first) - 1.0), ROUND_OFF)
            self.assertLess(row["p[9]"], ROUND_OFF)
            self.assertEqual(row["p[11]"], 0.0)
            # the film is the sum of its species
            volume = frame[:, WATER] / DENSITY[0] + frame[:, OIL] / DENSITY[1]
            self.assertLess(np.abs(volume / frame[:, FILM] - 1.0)[frame[:, FILM] > 0].max(), ROUND_OFF)
        energies = [energy(frame) for frame in frames]
        self.assertTrue(all(after < before for before, after in zip(energies, energies[1:])))
        # what is told as lost is what is lost
        told = log[-1]["e[7]"] - log[0]["e[7]"]
        self.assertLess(abs(told / (energies[0] - energies[-1]) - 1.0), 1e-9)  # a difference of sums
        self.assertGreater(log[-1]["e[6]"], log[0]["e[6]"])
        self.assertGreater(log[-1]["e[3]"], 0.0)
        self.assertTrue(0.0 < log[-1]["e[4]"] < 1e3)

    def test_a_hot_film_and_a_cold_one_meet_between_their_temperatures(self):
        frames, _ = self.go_on("p p p")
        first, last = rows_of(frames[2]), rows_of(frames[-1])
        self.assertLess(last[:, TEMPERATURE].max(), 350.0 * (1.0 + ROUND_OFF))
        self.assertGreater(last[:, TEMPERATURE].min(), 300.0 * (1.0 - ROUND_OFF))
        self.assertLess(np.std(last[:, TEMPERATURE]), np.std(first[:, TEMPERATURE]))

    def test_every_third_step_exchanges_then_alone_and_what_dumps_show_stays_with_its_parcel(self):
        for ranks in (1, 4):
            frames, log = self.go_on("p p p", "every 3", ranks)
            rows = [rows_of(frame) for frame in frames]
            for n in range(3, self.STEPS + 1):
                same = np.array_equal(rows[n][:, V], rows[n - 1][:, V])
                self.assertEqual(same, (self.START + n) % 3 != 0, n)
                volume = rows[n][:, WATER] / DENSITY[0] + rows[n][:, OIL] / DENSITY[1]
                self.assertLess(np.abs(volume - rows[n][:, FILM]).max() / rows[n][:, FILM].max(), ROUND_OFF)
            self.check_balances_of_sums(rows[2:], log)

    def check_balances_of_sums(self, rows, log):
        for column in (WATER, OIL):
            sums = [np.sum(row[:, NUMBER] * row[:, column]) for row in rows]
            self.assertLess(np.ptp(sums) / sums[0], ROUND_OFF)
        self.assertLess(max(row["p[9]"] for row in log), ROUND_OFF)

    def test_a_restart_goes_on_bit_for_bit_on_as_many_ranks_and_to_round_off_on_others(self):
        script = (PARCELS.format(walls="") + EXCHANGE.format(T=350, more="every 2") +
                  DROPLETS.format(name="warm", start=0, end=2.2e-3))
        columns = dump(COLUMNS, 11, "@")
        for ranks in (1, 2):
            self.scene.run(script + "run 7\nwrite_restart half.restart\n" + columns.replace("@", "whole.dump") +
                           "run 9\n" + "undump d\n" + dump(COLUMNS, 26, "@").replace("@", "end.dump") + "run 0\n",
                           ranks, start="read_restart first.restart\n")
            whole = self.scene.raw_dump("end.dump")
            reference = self.scene.dump("end.dump")
            for others in (ranks, 3 - ranks):
                self.scene.run(script + "run 9\n" + dump(COLUMNS, 26, "again.dump") + "run 0\n", others,
                               start="read_restart half.restart\n")
                if others == ranks:
                    self.assertEqual(self.scene.raw_dump("again.dump"), whole)
                self.assertLess(largest_difference(self.scene.dump("again.dump"), reference), ROUND_OFF)

    def test_a_restart_of_other_films_is_refused(self):
        for liquids in ("species water density 998", LIQUIDS.replace(" heat 4180 range 273 373", "").replace(
                " heat 1900 2.5 range 250 400", "")):
            refused(self, self.scene, PARCELS.format(walls="") + "fix e all collisional_exchange " + liquids + "\nrun 1\n",
                    "of other species", start="read_restart first.restart\n")

    def test_a_film_that_the_script_sets_keeps_its_mixture(self):
        self.scene.run(PARCELS.format(walls="") + EXCHANGE.format(T=300, more="") + dump(COLUMNS, 10) +
                       "run 10\nset group all property/atom liquidFilm 2e-10\n" + "undump d\n" +
                       dump(COLUMNS, 20, "set.dump") + thermo("f_p[9]") + "run 0\n",
                       start="read_restart first.restart\n")
        before = rows_of(self.scene.dump("last.dump", 20))
        after = rows_of(self.scene.dump("set.dump"))
        self.assertTrue(np.all(before[:, FILM] > 0.0))
        self.assertLess(np.abs(after[:, FILM] - 2e-10).max(), 1e-22)
        for column in (WATER, OIL):
            expected = before[:, column] * 2e-10 / before[:, FILM]
            self.assertLess(np.abs(after[:, column] - expected).max() / expected.max(), ROUND_OFF)
        # its mass is on the parcel, and booked
        grown = after[:, MASS] - before[:, MASS]
        liquid = np.sum(after[:, [WATER, OIL]] - before[:, [WATER, OIL]], axis=1)
        self.assertLess(np.abs(grown - liquid).max() / after[:, MASS].max(), ROUND_OFF)
        self.assertLess(self.scene.log()[-1][-1]["p[9]"], ROUND_OFF)


class SmallCases(unittest.TestCase):
    def test_a_parcel_alone_in_its_cell_keeps_its_bits(self):
        atoms = [Atom((0.005, 0.02, 0.02), (0.3, -0.2, 0.1)), Atom((0.03, 0.03, 0.01), (-0.3, 0.2, 0.7))]
        with Scene(SIZE, atoms) as scene:
            scene.run(PARCELS.format(walls="") + EXCHANGE.format(T=300, more="cells 2 1 1") + films(2) +
                      dump(COLUMNS, 1) + thermo("f_e[1] f_e[3]") + "run 20\n")
            first, last = scene.dump("last.dump", 0), scene.dump("last.dump", 20)
            for n, atom in enumerate(atoms, 1):
                self.assertEqual(last[n][V], list(atom.v))
                self.assertEqual(last[n][FILM:], first[n][FILM:])
            self.assertEqual(scene.log()[-1][-1]["e[3]"], 0.0)

    def test_grids_of_one_cell_and_ranks_without_parcels(self):
        atoms = cloud(40, (0.009, 0.009, 0.009), 2)
        with Scene(SIZE, atoms) as scene:
            results = []
            for boundary in ("p p p", "f f f"):
                for cells in ("2 2 1", "1 4 1"):
                    for ranks in (1, 4):
                        scene.run("timestep 1e-4\nfix p all parcels cells 4 1 1\n" +
                                  EXCHANGE.format(T=300, more=f"cells {cells}") + films(40) +
                                  dump(COLUMNS, 5) + "run 5\n", ranks, boundary=boundary,
                                  processors="processors 2 * *" if ranks > 1 else "")
                        results.append(scene.dump("last.dump"))
                    self.assertLess(largest_difference(*results[-2:]), ROUND_OFF)

    def test_the_profile_shows_the_means_of_its_line(self):
        with Scene(SIZE, cloud(200, SIZE, 3)) as scene:
            tables = []
            for ranks in (1, 4):
                scene.run(PARCELS.format(walls="") + EXCHANGE.format(
                    T=300, more="cells 4 2 2 profile x 0.01 0.03 from 4.5e-4 file line.csv") + films(200) +
                          dump(COLUMNS, 5) + "run 5\n", ranks)
                tables.append(scene.table("line.csv"))
                rows = rows_of(scene.dump("last.dump"))
                at = rows[:, X] % 0.04
                for n, told in enumerate(tables[-1]):
                    self.assertAlmostEqual(told["position_m"], 0.005 + 0.01 * n)
                    here = ((at[:, 0] // 0.01 == n) & (at[:, 1] < 0.02) & (at[:, 2] >= 0.02))
                    liquid = (rows[:, NUMBER] * rows[:, WATER])[here]
                    self.assertGreater(np.count_nonzero(here), 2)
                    # six digits are written
                    mean = np.sum(liquid * rows[here, 3]) / np.sum(liquid)
                    self.assertAlmostEqual(told["liquid_velocity_m_s"], mean, delta=2e-6)
                    weight = (rows[:, NUMBER] * rows[:, MASS])[here]
                    self.assertAlmostEqual(told["equilibrium_velocity_m_s"],
                                           np.sum(weight * rows[here, 3]) / np.sum(weight), delta=2e-6)
                    self.assertGreater(told["rms_velocity_m_s"], 0.0)
                    self.assertGreater(told["eta"], 0.0)
            for one, other in zip(*tables):
                for name in one:
                    self.assertAlmostEqual(one[name], other[name], delta=2e-5 * abs(one[name]) + 1e-12)


GRAINS = """
neighbor 0.0004 bin
fix m1 all property/global youngsModulus peratomtype 5e6 {two}
fix m2 all property/global poissonsRatio peratomtype 0.45 {ratio}
fix m3 all property/global coefficientRestitution peratomtypepair {types} {four}
fix m4 all property/global coefficientFriction peratomtypepair {types} {four}
pair_style gran/bridge model hertz tangential history {cohesion}
pair_coeff * *
timestep 1e-5
fix nve all nve/sphere
"""


def grains(cohesion="", types=1):
    return GRAINS.format(cohesion=cohesion, types=types, two="5e6" * (types - 1), ratio="0.45" * (types - 1),
                         four=" ".join(["0.7"] * types**2))


def lattice(seed, types=1):
    """216 grains of two sizes, some of them in touch."""
    pitch, radius = 0.01 / 6, 0.53 * 0.01 / 6
    atoms = cloud(216, (0.2 * pitch,) * 3, seed, speed=0.2, radius=radius)
    for n, atom in enumerate(atoms):
        site = (n // 36, n // 6 % 6, n % 6)
        atom.x = [pitch * (i + 0.4) + x for i, x in zip(site, atom.x)]
        atom.radius = radius if n % 2 else 0.8 * radius
        atom.kind = 1 + n % types
    return atoms


class Grains(unittest.TestCase):
    BOX = (0.01, 0.01, 0.01)
    SPREAD = ("fix e all collisional_exchange close_packing 0.64 k_liquid 50 momentum off cells 3 3 3 "
              "species water density 998 {}\n")

    def test_bridges_and_exchange_conserve_one_liquid(self):
        liquid = ("fix wet all liquid content 0.02 surface_tension 0.0728 contact_angle 0.35 viscosity 0.001 "
                  "minimum_separation 1e-6 every 10 output liquid.csv\n")
        for types, ranks in ((1, 1), (2, 2)):
            with self.subTest(types=types), Scene(self.BOX, lattice(4, types), types) as scene:
                dry = "set atom 1*100 property/atom liquidFilm 0.0\n"
                scene.run(grains("cohesion bridge", types) + liquid + self.SPREAD.format("every 2") + "run 0\n" + dry +
                          thermo("f_e[1] f_e[5]", 10) + dump("vx f_liquidFilm f_e[1]", 300) + "run 300\n", ranks)
                rows = scene.table("liquid.csv")
                self.assertLess(max(abs(row["residual"]) for row in rows), ROUND_OFF)
                self.assertGreater(rows[-1]["bridge_count"], 100)
                self.assertGreater(scene.log()[-1][-1]["e[5]"], 0.0)
                # the same liquid in both: between two exchanges bridges have moved some of it
                film = rows_of(scene.dump("last.dump"))
                self.assertLess(np.abs(film[:, 1] * 998.0 - film[:, 2]).max() / film[:, 2].max(), 1e-12)
                self.assertLess(abs(np.sum(film[:, 1]) / rows[-1]["films"] - 1.0), 1e-9)
                # a dry grain without a bridge has got its film by exchange: all have one
                self.assertGreater(film[:, 1].min(), 0.0)

    def test_without_bridges_films_spread_and_the_motion_is_that_without_exchange(self):
        with Scene(self.BOX, lattice(5)) as scene:
            wet = "run 0\nset atom 1*50 property/atom liquidFilm 1e-11\n"
            columns = "x y z vx vy vz"
            scene.run(grains() + self.SPREAD.format("") + wet + thermo("f_e[1] f_e[4]", 1) +
                      dump(columns + " f_liquidFilm", 200) + "run 200\n")
            told = [row["e[1]"] for row in scene.log()[-1]]
            film = rows_of(scene.dump("last.dump"))
            scene.run(grains() + "run 0\n" + dump(columns, 200) + "run 200\n")
            self.assertTrue(np.array_equal(film[:, :6], rows_of(scene.dump("last.dump"))))
        self.assertLess(max(abs(value / (50 * 1e-11 * 998.0) - 1.0) for value in told), ROUND_OFF)
        self.assertGreater(np.count_nonzero(film[:, 6]), 50)


class Refusals(unittest.TestCase):
    WET = "species water density 998"

    @classmethod
    def setUpClass(cls):
        cls.scene = Scene(SIZE, cloud(5, SIZE, 6))

    @classmethod
    def tearDownClass(cls):
        cls.scene.held.cleanup()

    def refuse(self, body, *expected, **options):
        refused(self, self.scene, body, *expected, **options)

    def test_scenes_that_cannot_be(self):
        p = "fix p all parcels cells 2 2 2\n"
        e = "fix e all collisional_exchange "
        self.refuse(p + e + "momentum off\nrun 1\n", f"in.{HOST}", "'momentum off' is for grains", "Leave it out", ranks=2)
        self.refuse("fix p all parcels\n" + e + self.WET + "\nrun 1\n", "no cells", "'cells NX NY NZ'")
        self.refuse(p + e + self.WET + "\nfix again all collisional_exchange\n", "there is a fix collisional_exchange already")
        self.refuse("group few id 1 2\nfix e few collisional_exchange cells 1 1 1\n", "must be 'all', it is 'few'")
        self.refuse(e + self.WET + " cells 1 1 1\n" + p + "run 1\n", "must stand after fix parcels")

    def test_words_that_are_not_understood(self):
        e = "fix e all collisional_exchange "
        self.refuse(e + "species water species oil density 850 film_temperature 300 k_sold 0.1 every 0\n",
                    "species water: has no density", "species oil: has no enthalpy", 'Did you mean "k_solid"?', "every 0")
        self.refuse(e + self.WET + " cells 1 1 1 profile x 0.5 0.01 file f.csv\nrun 1\n", "outside of the box")

    def test_films_that_are_none(self):
        e = "fix p all parcels cells 2 2 2\nfix e all collisional_exchange " + self.WET + "\n"
        # LAMMPS takes none but numbers itself.
        for value in ("-1e-12", "nan", "inf") if HOST == "liggghts" else ("-1e-12",):
            self.refuse(e + f"run 2\nset atom 3 property/atom liquidFilm {value}\nrun 1\n", "liquidFilm of atom 3 is", "0 or more")

    def test_more_ranks_than_cells(self):
        self.refuse("fix p all parcels cells 1 2 1\nrun 1\n", "4 ranks cannot share the 1 x 2 x 1 cells", ranks=4)

    def test_other_units(self):
        scene = Scene(SIZE)
        with scene:
            refused(self, scene, "fix e all collisional_exchange cells 1 1 1\n", "units si",
                    start="units cgs\n" + scene.start)


if __name__ == "__main__":
    unittest.main(verbosity=2)
