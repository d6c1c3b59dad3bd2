#!/usr/bin/python3
"""Our fixes act alike in both hosts: the forces of a gas, colliding parcels, jets with films.

Both hosts are handed the same numbers by the same code, and integrate them by the same formulae: what differs is
the order in which sums over ranks are taken, and nothing on one rank.
"""

import random
import sys
import unittest
from pathlib import Path

import numpy as np

from jet_gas import GAS

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "exchange_model"))
from parcel_scripts import Atom, Scene, cloud, dump, thermo  # noqa: E402

HOSTS = ("liggghts", "lammps")

EFFECTS = ("void_fraction trilinear drag koch_hill pressure_gradient viscous_stress virtual_mass saffman_mei magnus "
           "rotation_torque")


def rows_of(frame):
    return np.array([frame[n] for n in sorted(frame)])


def largest_differences(one, other, columns):
    """Of the columns of two frames, each group of columns against its own largest value."""
    a, b = rows_of(one), rows_of(other)
    return [np.abs(a[:, group] - b[:, group]).max() / np.abs(a[:, group]).max() for group in columns]


class GrainsInGas(unittest.TestCase):
    """A hundred grains of many sizes that move and turn in a jet, without contacts."""

    SIZE = (0.022, 0.022, 0.11)
    COLUMNS = "x y z vx vy vz omegax omegay omegaz fx fy fz tqx tqy tqz"
    GROUPS = (slice(0, 3), slice(3, 6), slice(6, 9), slice(9, 12), slice(12, 15))

    @classmethod
    def grains(cls):
        roll = random.Random(2)
        return [Atom([roll.uniform(0.002, 0.02), roll.uniform(0.002, 0.02), roll.uniform(0.002, 0.04)],
                     [roll.uniform(-0.1, 0.1) for _ in range(3)], radius=1e-3 * roll.uniform(0.5, 1.0),
                     spin=[roll.uniform(-100, 100) for _ in range(3)]) for _ in range(100)]

    def fly(self, host, ranks, gas, steps):
        with Scene(self.SIZE, self.grains()) as scene:
            (scene.folder / "gas.toml").write_text(GAS.replace("@jet@", "45.0"))
            inside = "" if gas else "gas gas.toml"
            scene.run("timestep 2e-5\n"
                      "fix g all gravity 9.81 vector 0 0 -1\nfix m all nve/sphere\n"
                      f"fix gas all couple/gas every 25 {inside} output out {EFFECTS}\n" +
                      dump(self.COLUMNS, steps) + f"run {steps}\n", ranks, boundary="f f f", gas=gas, host=host)
            return scene.dump("last.dump"), (scene.folder / "out/history.csv").read_text()

    def test_forces_and_torques_of_a_given_gas_agree_to_round_off_on_1_and_2_ranks(self):
        # Two couplings: the gas of the first one has come back. Beside the DEM ranks, and inside them.
        for ranks, gas in ((1, 0), (1, 1), (2, 2)):
            with self.subTest(ranks=ranks, gas=gas):
                here, there = (self.fly(host, ranks, gas, 40)[0] for host in HOSTS)
                for column, differs in enumerate(largest_differences(here, there, self.GROUPS)):
                    self.assertLess(differs, 1e-12, column)

    def test_flights_and_histories_agree_over_1000_steps(self):
        (here, history), (there, other) = (self.fly(host, 1, 0, 1000) for host in HOSTS)
        for differs in largest_differences(here, there, self.GROUPS[:3]):
            self.assertLess(differs, 1e-9)
        # 1 mm at least: the gas blows
        self.assertGreater(np.abs(rows_of(here)[:, 5]).max(), 0.3)
        tables = [[[float(value) for value in line.split(",")] for line in text.splitlines()[1:]] for text in (history, other)]
        self.assertEqual(history.splitlines()[0], other.splitlines()[0])
        scale = np.abs(tables[0]).max(axis=0)
        # residuals are round-off themselves
        sizes = [not name.endswith(("residual", "imbalance")) for name in history.splitlines()[0].split(",")]
        self.assertLess((np.abs(np.subtract(*tables)) / (scale + 1e-300))[:, sizes].max(), 1e-9)


class CollidingParcels(unittest.TestCase):
    """Collisions of the parcels in cells, as a relaxation (Bhatnagar, Gross and Krook), by its two names."""

    SIZE = (0.02, 0.02, 0.02)
    COLUMNS = "x y z vx vy vz"
    GROUPS = (slice(0, 3), slice(3, 6))

    def collide(self, host, ranks, name):
        with Scene(self.SIZE, cloud(200, self.SIZE, 3, radius=8e-4)) as scene:
            scene.run("timestep 2e-4\nfix p all parcels particles 3 stress off cells 2 2 2\n"
                      f"fix e all {name} close_packing 0.6 momentum on\n" + thermo("f_e[5]", 1000) +
                      dump(self.COLUMNS, 1000) + "run 1000\n", ranks, host=host)
            return scene.dump("last.dump"), scene.dump("last.dump", 0)

    def test_a_cell_of_parcels_goes_the_same_way_over_1000_steps(self):
        here, first = self.collide("liggghts", 1, "collisional_exchange")
        # Nothing else changes velocities here: the collisions were not idle.
        self.assertLess(rows_of(here)[:, 3:].std(), 0.85 * rows_of(first)[:, 3:].std())
        for host, ranks, name in (("liggghts", 1, "exchange/bgk"), ("lammps", 1, "exchange/bgk"),
                                  ("lammps", 2, "collisional_exchange")):
            with self.subTest(host=host, ranks=ranks, name=name):
                there, _ = self.collide(host, ranks, name)
                for differs in largest_differences(here, there, self.GROUPS):
                    self.assertLess(differs, 1e-9)


class Jets(unittest.TestCase):
    """Drops of two liquids into falling solids: what comes in, spreads and leaves."""

    SIZE = (0.06, 0.04, 0.04)
    SCRIPT = (
        "timestep 5e-4\nfix g all gravity 9.81 vector 0 0 -1\n"
        "fix p all parcels walls x_lo y_lo y_hi z_lo z_hi damping on 0.9 isotropy on 0.9 0.4 cells 6 4 4\n"
        "fix e all collisional_exchange close_packing 0.6 species water density 998 species oil density 850\n"
        "fix drops all parcels/inject at 0.005 0.02 0.02 nozzle_radius 0.002 direction 1 0.1 0 half_angle 15 speed 4 "
        "mass_flow 0.01 size lognormal 1e-4 0.3 liquid 930 water 0.4 oil 0.6 parcels_per_second 2e4 from 1e-3 seed 3\n"
        "fix feed all parcels/inject face x_lo rectangle 0.01 0.03 0.01 0.03 fraction 0.05 speed 2 size constant 2e-4 "
        "solid 2000 particles 40 type 2 seed 5\n")
    SUMS = " ".join(["atoms"] + [f"f_p[{n}]" for n in range(1, 16)] + ["f_e[1] f_e[2] f_e[5] f_e[6] f_e[7]"] +
                    [f"f_{jet}[{n}]" for jet in ("drops", "feed") for n in (1, 3, 4, 5, 6, 7)])

    def test_parcels_films_and_balances_agree(self):
        frames, sums = [], []
        for host in HOSTS:
            with Scene(self.SIZE, types=2) as scene:
                scene.run(self.SCRIPT + thermo(self.SUMS, 60) +
                          dump("x y z vx vy vz radius mass type f_liquidFilm f_particlesPerParcel f_e[1] f_e[2]", 60) +
                          "run 60\n", boundary="f f f", host=host)
                frames.append(scene.dump("last.dump"))
                sums.append(scene.log(host)[-1][-1])
        self.assertEqual(sorted(frames[0]), sorted(frames[1]))
        for column, differs in enumerate(largest_differences(*frames, [[n] for n in range(13)])):
            self.assertLess(differs, 1e-11, column)
        for name, value in sums[0].items():
            if name != "p[9]":  # round-off itself
                self.assertLess(abs(sums[1][name] - value), 1e-11 * abs(value) + 1e-30, name)
        self.assertGreater(sums[0]["e[6]"], 0.0)  # films have moved


if __name__ == "__main__":
    unittest.main(verbosity=2)
