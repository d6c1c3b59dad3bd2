#!/usr/bin/python3
"""Parcels in a gas: the ledger closes, and a parcel's drag is that of its particles."""

import math
import unittest

import numpy as np

from parcel_scripts import Atom, Scene, dump, thermo

SIZE = (0.02, 0.02, 0.06)
GAS = """\
[grid]
lo = [0.0, 0.0, 0.0]
hi = [0.02, 0.02, 0.06]
cells = [4, 4, 12]
[gas]
density = 1.2
viscosity = 1.8e-5
[time]
step = 1e-3
[boundary]
z_hi = "outlet"
[solver]
tolerance = 1e-10
[output]
every = 0.01
pressure_probes = [0.001, 0.02]
"""
INFLOW = """\
[[inflow]]
side = "z_lo"
shape = "whole"
velocity = 0.8
"""
COUPLE = "fix gas all couple/gas every 1 {inside} output out void_fraction trilinear drag gidaspow pressure_gradient {more}\n"
WALLS = "walls x_lo x_hi y_lo y_hi z_lo"


def bed(copies=1):
    """A loose packing of 8 x 8 x 12 parcels; copies: atoms at each place."""
    pitch = 0.0025
    return [Atom([pitch * (i + 0.5) for i in site], radius=5e-4)
            for site in np.ndindex(8, 8, 12) for _ in range(copies)]


class GasScene(Scene):
    def __init__(self, atoms, inflow=True, **options):
        super().__init__(SIZE, atoms, **options)
        (self.folder / "gas.toml").write_text(GAS + (INFLOW if inflow else ""))
        (self.folder / "out").mkdir()

    def run_parcels(self, particles=8, steps=40, ranks=1, gas=1, more="", extra=""):
        inside = "" if gas else "gas gas.toml"
        text = self.run("timestep 5e-4\nfix g all gravity 9.81 vector 0 0 -1\n"
                        f"fix p all parcels particles {particles} {WALLS}\n" + extra +
                        COUPLE.format(inside=inside, more=more) + thermo("f_p[9] f_p[10]") +
                        dump("x y z vx vy vz", steps) + f"run {steps}\n", ranks, boundary="f f f", gas=gas)
        return text, self.table("out/history.csv")


class Bed(unittest.TestCase):
    def check(self, history, atoms, particles):
        for row in history:
            self.assertEqual((row["parcels"], row["particles"]), (atoms, particles))
            self.assertLess(row["ledger_residual"], 1e-12)
        self.assertGreater(history[-1]["impulse_of_drag_Ns"], 0.0)

    def test_the_ledger_closes_beside_a_gas_program_and_with_the_gas_inside(self):
        with GasScene(bed()) as scene:
            texts = {}
            frames = {}
            for ranks, gas in ((1, 1), (2, 1), (1, 0), (2, 0)):
                with self.subTest(ranks=ranks, gas=gas):
                    _, history = scene.run_parcels(ranks=ranks, gas=gas)
                    self.check(history, 768, 8 * 768)
                    for row in scene.log()[-1]:
                        self.assertLess(row["p[9]"], 1e-12)
                        self.assertLess(row["p[10]"], 1.01 * (1 + 1e-9))
                    texts[ranks, gas] = (scene.folder / "out/history.csv").read_text()
                    last = scene.dump("last.dump")
                    frames[ranks, gas] = np.array([last[n] for n in sorted(last)])
            # inside is beside, bit for bit; other ranks differ by round-off and the solver's tolerance
            self.assertEqual(texts[1, 1], texts[1, 0])
            one, two = frames[1, 1], frames[2, 1]
            self.assertLess(np.abs(one - two).max() / np.abs(one[:, 3:]).max(), 1e-8)

    def test_a_parcel_of_eight_drags_the_gas_as_eight_parcels_of_one(self):
        results = []
        for copies, particles in ((1, 8), (8, 1)):
            with GasScene(bed(copies)) as scene:
                _, history = scene.run_parcels(particles, steps=20, gas=0)
                self.check(history, 768 * copies, 8 * 768)
                results.append(history)
        for one, other in zip(*results):
            for name in ("kinetic_energy_J", "momentum_z_Ns", "impulse_of_drag_Ns", "impulse_of_pressure_gradient_Ns",
                         "p_0.001m_Pa", "p_0.02m_Pa", "bed_height_m"):
                # the solver's tolerance, and sums in another order
                self.assertLess(abs(one[name] - other[name]), 1e-8 * abs(one[name]) + 1e-15, name)

    def test_droplets_come_in_and_wet_the_bed(self):
        jet = ("fix e all collisional_exchange close_packing 0.6 species water density 998\n"
               "fix j all parcels/inject at 0.003 0.01 0.015 direction 1 0 0 speed 5 mass_flow 1e-3 size constant 1e-4 "
               "liquid 998 water 1 parcels_per_second 4000\n")
        with GasScene(bed()) as scene:
            _, history = scene.run_parcels(ranks=2, extra=jet)
            self.assertEqual(history[-1]["parcels"], 768 + 80)
            number = 1e-3 * 0.02 / (998 * 4 / 3 * math.pi * 1e-12)
            self.assertLess(abs(history[-1]["particles"] / (8 * 768 + number) - 1.0), 1e-9)
            for row in history:
                self.assertLess(row["ledger_residual"], 1e-12)
            for row in scene.log()[-1]:
                self.assertLess(row["p[9]"], 1e-12)


    def test_droplets_that_give_all_their_liquid_away_stay_where_the_gas_takes_their_cores(self):
        # the bed is denser than the exchange's close packing: collisions without number
        jet = ("fix e all collisional_exchange close_packing 0.1 species water density 998\n"
               "fix j all parcels/inject at 0.003 0.01 0.015 direction 1 0 0 speed 5 mass_flow 1e-3 size constant 1e-4 "
               "liquid 998 water 1 parcels_per_second 4000\n")
        with GasScene(bed()) as scene:
            _, history = scene.run_parcels(steps=20, gas=0, extra=jet)
            self.assertEqual(history[-1]["parcels"], 768 + 40)
            last = scene.dump("last.dump")
            cores = np.array([last[n] for n in range(769, 809)])
            # within the cells beside the nozzle's
            self.assertLess(np.abs(cores[:, :3] - (0.005, 0.01, 0.015)).max(), 0.006)
            self.assertLess(np.abs(cores[:, 3:]).max(), 1.0)


class Falling(unittest.TestCase):
    RADIUS, DENSITY = 25e-6, 2000.0

    def terminal_velocity(self):
        """With Wen and Yu's law at a void fraction of 1: Schiller and Naumann's."""
        d, mu, rho = 2 * self.RADIUS, 1.8e-5, 1.2
        v = 0.1
        for _ in range(50):
            re = rho * v * d / mu
            v = (self.DENSITY * 9.81 * d**2 / (18 * mu)) / (1 + 0.15 * re**0.687)
        return v

    def test_parcels_of_one_particle_fall_like_grains_at_the_terminal_velocity(self):
        atoms = [Atom((0.0025 + 0.005 * i, 0.0025 + 0.005 * j, 0.045), radius=self.RADIUS, density=self.DENSITY)
                 for i in range(4) for j in range(4)]
        fixes = "timestep 5e-4\nfix g all gravity 9.81 vector 0 0 -1\n"
        movers = {"parcels": f"pair_style none\nneighbor 0.002 bin\nfix p all parcels {WALLS}\n",
                  "grains": "pair_style none\nneighbor 0.002 bin\nfix n all nve/sphere\n"}
        speed = {}
        for name, mover in movers.items():
            with GasScene(atoms, inflow=False) as scene:
                scene.run(fixes + mover + COUPLE.format(inside="gas gas.toml", more="self_disturbance ignored") +
                          dump("vz z", 200) + "run 200\n", boundary="f f f")
                last = scene.dump("last.dump")
                speed[name] = np.array([last[n] for n in sorted(last)])
        # six time scales of 15 ms; the gas that they drag along falls with 0.1 % of it
        expected = self.terminal_velocity() * (1 - math.exp(-0.1 / 0.0155))
        self.assertLess(abs(-speed["parcels"][:, 0].mean() / expected - 1.0), 0.01)
        # the same integration; only the order of sums may differ
        self.assertLess(np.abs(speed["parcels"] - speed["grains"]).max() / expected, 1e-9)


if __name__ == "__main__":
    unittest.main(verbosity=2)
