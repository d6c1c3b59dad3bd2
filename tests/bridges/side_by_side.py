#!/usr/bin/python3
"""Two spheres pulled apart: `cohesion bridge` beside the two bridge models of stock LIGGGHTS and the solution of
Young and Laplace's equation. Each test measures one difference in the running programs.

With --write FOLDER: the data and the plot of docs/bridges-side-by-side.md in the place of the tests."""

import sys
import unittest

import numpy as np

import stock_bridges as stock
from bridge_formulas import LAWS, Bridge, lian_rupture, viscous_normal, work
from stock_bridges import DEGREE, EASO, WASHINO, combined_angle, film_of, run_stock
from two_sphere_pull import BOX, CURVES, R, at, compare, going, ours, pull_of, stock_pair, two, write
from wet_host import WATER, Grain, Wet
from young_laplace import of_pair


class ContactAngles(unittest.TestCase):
    """Stock reads degrees and takes half the PRODUCT of both angles in radians; ours takes the mean."""

    def test_half_the_product_is_what_stock_computes(self):
        for degrees in ((20, 20), (60, 0), (60, 30), (90, 90)):
            theta = combined_angle(*degrees)
            for model, law in ((EASO, stock.easo), (WASHINO, stock.washino)):
                wet = stock_pair(model, 1e-12, degrees, motion=going(0.1, 100))
                pull, gap = at(wet, 5e-6)
                self.assertAlmostEqual(pull / law(gap, R, R, theta, 1e-12), 1.0, delta=1e-6, msg=(model, degrees))

    def test_a_wetted_partner_makes_stock_blind_to_the_others_angle(self):
        pulls = {}
        for degrees in ((80, 0), (0, 0)):
            for model in (EASO, WASHINO):
                pulls[model, degrees] = at(stock_pair(model, 1e-12, degrees, motion=going(0.1, 100)), 1e-6)[0]
            pulls["ours", degrees] = at(ours(two(1e-9, 5e-13), degrees, **going(0.1, 100)), 1e-6)[0]
        for model in (EASO, WASHINO):
            self.assertEqual(pulls[model, (80, 0)], pulls[model, (0, 0)])
        self.assertAlmostEqual(pulls["ours", (80, 0)] / pulls["ours", (0, 0)], np.cos(40 * DEGREE), delta=1e-9)

    def test_at_40_degrees_stock_pulls_as_at_14(self):
        theta = 40 * DEGREE
        self.assertAlmostEqual(combined_angle(40, 40) / DEGREE, 14.0, delta=0.1)
        gap = 1e-6
        true = of_pair(Bridge(R, theta, WATER, 1e-12), [gap])[0]
        easo = at(stock_pair(EASO, 1e-12, (40, 40), motion=going(0.1, 100)), gap)[0]
        mine = at(ours(two(1e-9, 5e-13), (40, 40), "willett_fit", **going(0.1, 100)), gap)[0]
        print(f"40 degrees, V / r^3 = 1e-3, over Young and Laplace: easo {easo / true:.3f}, ours {mine / true:.3f}")
        self.assertGreater(easo / true, 1.2)
        self.assertAlmostEqual(mine / true, 1.0, delta=0.05)


class Radii(unittest.TestCase):
    def test_washino_has_half_the_effective_radius_in_the_force_and_in_the_depth(self):
        """In the limit of little liquid the force at contact is 2 pi R gamma cos theta."""
        volume = 1e-15
        pull, gap = at(stock_pair(WASHINO, volume, (0, 0), motion=going(1e-3, 100)), 2e-9)
        limit = 2 * np.pi * R * WATER
        print(f"washino at contact, V / r^3 = 1e-6: {pull / limit:.4f} of 2 pi R gamma")
        self.assertAlmostEqual(pull / limit, 0.5, delta=0.01)
        mine = at(ours(two(1e-9, volume / 2), (0, 0), "rabinovich", **going(1e-3, 100)), 2e-9)[0]
        self.assertAlmostEqual(mine / limit, 1.0, delta=0.01)
        # The same form with R / 2 for R wherever R stands: prefactor, depth of immersion, filling angle
        b = Bridge(R / 2, 0.0, WATER, 1e-12)
        pull, gap = at(stock_pair(WASHINO, 1e-12, (0, 0), motion=going(0.1, 500)), 4e-5)
        self.assertAlmostEqual(pull / LAWS["rabinovich"][0](b, gap), 1.0, delta=1e-6)
        once = 0.5 * LAWS["rabinovich"][0](Bridge(R, 0.0, WATER, 1e-12), gap)
        self.assertGreater(pull / once, 1.1)  # half the force alone would not explain it

    def test_easo_does_not_use_the_half_but_the_geometric_mean(self):
        """Its force goes as (r_i r_j)^(1/2); between unequal grains it must go as 2 r_i r_j / (r_i + r_j)."""
        radii = (1.5e-3, 1e-4)
        derjaguin = 2 * radii[0] * radii[1] / sum(radii)
        volume = 1e-4 * derjaguin**3
        pull, gap = at(stock_pair(EASO, volume, (0, 0), radii=radii, motion=going(1e-3, 100)), 2e-9)
        self.assertAlmostEqual(pull / stock.easo(gap, *radii, 0, volume), 1.0, delta=1e-6)
        limit = 2 * np.pi * derjaguin * WATER
        print(f"easo, size ratio 15, at contact: {pull / limit:.3f} of 2 pi R gamma")
        self.assertGreater(pull / limit, 1.5)
        grains = two(1e-9, volume / 2, radii)
        mine = at(ours(grains, (0, 0), **going(1e-3, 100)), 2e-9)[0]
        self.assertAlmostEqual(mine / limit, 1.0, delta=0.01)


class Liquid(unittest.TestCase):
    def row_of_three(self, run):
        """A and B wet, C dry, in a row: A is taken 1e-5 m off B and stays there, then C is taken off B."""
        places = ((-2 * R + 1e-9, 4e-12), (0, 4e-12), (2 * R - 1e-9, 0))
        grains = [Grain((x, 0, 0), R, film) for x, film in places]
        motion = {"body": "group a id 1\ngroup c id 3", "size": BOX, "run": """\
run 4
fix a a move linear -0.01 0 0
run 1000
unfix a
fix c c move linear 0.1 0 0
run 3000"""}
        wet = run(grains, motion)
        return wet, wet.frames["fx"][:, 0]  # of A and B

    def test_stock_changes_a_standing_bridge_when_another_breaks(self):
        solid = 4 / 3 * np.pi * R**3
        for model in (EASO, WASHINO):
            wet, pull = self.row_of_three(lambda grains, motion, m=model: run_stock(
                m, grains, (0, 0), [g.film / solid for g in grains], **motion))
            films = wet.frames["f_surfaceLiquidContent"]
            broke = np.flatnonzero(films[:, 2] != films[0, 2])[0]
            # No film has changed while bridges stood: their liquid is in the films as well.
            np.testing.assert_array_equal(films[:broke], np.broadcast_to(films[0], (broke, 3)))
            jump = abs(pull[broke + 1] / pull[broke - 2] - 1)
            print(f"{model}: a break elsewhere changes a standing bridge's pull by {100 * jump:.2g} %")
            self.assertGreater(jump, 1e-3)

    def test_ours_keeps_the_liquid_with_the_bridge(self):
        words = f"film 0 surface_tension {WATER} contact_angle 0 formation 1e-8 every 100000"
        wet, pull = self.row_of_three(lambda grains, motion: Wet(grains, words, **motion))
        bridges = wet.frames["f_wet[1]"]
        broke = np.flatnonzero((bridges[:, 2] == 0) & (wet.steps > 4))[0]
        self.assertEqual(bridges[broke, 0], 1)
        self.assertGreater(pull[broke], 0)
        np.testing.assert_array_equal(pull[broke:], pull[broke - 2])
        # What is in a bridge is no longer in the films.
        self.assertLess(wet.frames["f_liquidFilm"][10, 0], 4e-12 * 0.95)
        np.testing.assert_allclose(wet.liquid(), 8e-12, rtol=1e-13)

    def test_stock_drops_the_force_of_bridges_below_1e_minus_17_m3(self):
        for model in (EASO, WASHINO):
            for volume, there in ((0.99e-17, False), (1.01e-17, True)):
                wet = stock_pair(model, volume, (0, 0), motion=going(1e-3, 100))
                pull = at(wet, 2e-9)[0]
                self.assertEqual(pull > 0, there, (model, volume))
        mine = at(ours(two(1e-9, 0.5e-18), (0, 0), **going(1e-4, 100)), 2e-9)[0]
        self.assertGreater(mine, 0.9 * 2 * np.pi * R * WATER)

    def test_stock_divides_by_grain_volume_and_keeps_the_sum(self):
        radii = (1e-3, 0.5e-3)
        solid = [4 / 3 * np.pi * r**3 for r in radii]
        for model in (EASO, WASHINO):
            wet = run_stock(model, two(-1e-9, radii=radii), (0, 0), (1e-3, 0.0), size=BOX, every=100,
                            **going(0.1, 4000))
            film = wet.frames["f_surfaceLiquidContent"] * solid
            bridge = stock.share(model, *radii) * film[0, 0]
            np.testing.assert_allclose(film.sum(axis=1), film[0].sum(), rtol=1e-9)
            self.assertAlmostEqual(film[-1, 1] / bridge, 1 / 9, delta=1e-4)  # r_j^3 / (r_i^3 + r_j^3)


class FormingAndBreaking(unittest.TestCase):
    FAR = 2e-4

    def cycle(self, run):
        steps = round((self.FAR + 1e-7) / 2e-8)
        return run(f"""\
fix on b move linear -0.02 0 0
run {steps}
run 5
unfix on
fix off b move linear 0.02 0 0
run {steps}""")

    def test_washino_forms_bridges_without_a_touch_and_so_costs_nothing(self):
        volume = 1e-12
        lost = {}
        b = Bridge(R, 0.0, WATER, volume)
        for name in (EASO, WASHINO, "ours"):
            def run(motion, model=name):
                motion = {"body": "group b id 2", "run": motion, "every": 5}
                if model == "ours":
                    return ours(two(self.FAR, volume / 2), (0, 0), more="formation touch", **motion)
                content = film_of(model, volume, R)
                return run_stock(model, two(self.FAR), (0, 0), (content, content), size=BOX, **motion)
            wet = self.cycle(run)
            gap, pull = wet.gaps(0, 1), pull_of(wet)
            middle = len(gap) // 2
            open_gap = gap > 0  # contact itself is left out
            way = np.where(open_gap, pull, 0.0)
            parts = 0.5 * (way[1:] + way[:-1]) * np.diff(gap)
            lost[name] = parts.sum()
            if name == WASHINO:
                first = gap[np.flatnonzero(pull > 0)[0]]
                self.assertAlmostEqual(first / stock.rupture(0, volume), 1.0, delta=2e-3)
                self.assertLess(abs(parts.sum()), 0.01 * parts[middle:].sum())
            else:
                np.testing.assert_array_equal(way[:middle - 10], 0.0)
        for name, joules in lost.items():
            print(f"{name}: a cycle costs {joules:.4g} J")
        integral = work(LAWS["willett"][0], b, 1e-12, LAWS["willett"][1](b))
        self.assertAlmostEqual(lost["ours"] / integral, 1.0, delta=0.01)

    def test_stock_cuts_a_bridge_at_the_greatest_separation(self):
        for model in (EASO, WASHINO):
            for greatest, breaks in ((1.5, stock.rupture(0, 1e-12)), (1.02, 0.02 * 2 * R)):
                wet = stock_pair(model, 1e-12, (0, 0), greatest=greatest, motion=going(0.1, 2000))
                last = wet.gaps(0, 1)[np.flatnonzero(pull_of(wet) > 0)[-1]]
                self.assertAlmostEqual(last, breaks, delta=2.1e-7, msg=(model, greatest))
                self.assertNotIn("broke below", wet.log)  # it says nothing
        mine = ours(two(1e-9, 5e-13), (0, 0), more="formation 2e-9 reach 0.02", **going(0.1, 2000))
        self.assertIn("broke below their rupture distance", mine.log)

    def test_washino_jumps_at_touch_and_is_no_number_on_it(self):
        volume = 1e-12
        jump = {}
        for name in (EASO, WASHINO, "ours"):
            if name == "ours":
                wet = ours(two(-1e-7, volume / 2), (0, 0), "rabinovich", restitution=1.0, **going(0.01, 20))
            else:
                wet = stock_pair(name, volume, (0, 0), -1e-7, motion=going(0.01, 20), restitution=1.0)
            (behind, _), (before, _) = at(wet, -2e-8), at(wet, 2e-8)
            jump[name] = before / behind
            print(f"{name}: 2e-8 m before touch {before:.5g} N, as far behind {behind:.5g} N")
        # The contact itself repels by 2e-7 N there.
        self.assertAlmostEqual(jump[EASO], 1, delta=3e-3)
        self.assertAlmostEqual(jump["ours"], 1, delta=3e-3)
        self.assertGreater(jump[WASHINO], 1.05)
        self.assertTrue(np.isnan(at(stock_pair(WASHINO, volume, (0, 0), 0.0, motion=going(0, 5)), 0.0)[0]))
        self.assertTrue(np.isfinite(at(stock_pair(EASO, volume, (0, 0), 0.0, motion=going(0, 5)), 0.0)[0]))
        self.assertGreater(at(ours(two(0.0, volume / 2), (0, 0), "rabinovich", **going(0, 5)), 0.0)[0], 0)

    def test_washino_pulls_harder_the_deeper_grains_overlap(self):
        volume, depth = 1e-12, 1e-5
        expected = {EASO: 1.0, WASHINO: 1 + depth * np.sqrt(np.pi * R / 2 / (2 * volume))}
        contact = {EASO: stock.easo(0, R, R, 0, volume), WASHINO: np.pi * R * WATER}
        for model, share in expected.items():
            wet, dry = (pull_of(run_stock(model, two(-depth), (0, 0), (content, content), size=BOX, **going(0, 5)))[-1]
                        for content in (film_of(model, volume, R), 0.0))
            print(f"{model} in 1e-5 m of overlap: {(wet - dry) / contact[model]:.3f} of that at touch")
            self.assertAlmostEqual((wet - dry) / contact[model], share, delta=1e-3)


class ViscousForce(unittest.TestCase):
    MU = 0.01

    def test_stock_has_the_force_of_grains_immersed(self):
        volume, speed = 1e-12, 0.1
        b = Bridge(R, 0.0, WATER, volume)
        for model in (EASO, WASHINO):
            thin = stock_pair(model, volume, (0, 0), motion=going(speed, 800))
            thick = stock_pair(model, volume, (0, 0), viscosity=self.MU, motion=going(speed, 800))
            # 6 pi mu (R/2)^2 / s is 3/2 pi mu R^2 / s: the half is in its place here.
            for gap in (2e-5, 7e-5):
                more = at(thick, gap)[0] - at(thin, gap)[0]
                s = at(thin, gap)[1]
                self.assertAlmostEqual(more / (1.5 * np.pi * self.MU * R**2 * speed / s), 1.0, delta=1e-6)
                finite = viscous_normal(b, self.MU, s) * speed
                print(f"{model}, gap {s:.2g} m: {more / finite:.2f} of the resistance of a bridge of this volume")
                self.assertGreater(more / finite, 1.5)

    def test_stock_makes_angular_momentum_across_a_gap(self):
        volume = 1e-12
        slide = {"body": "group b id 2",
                 "run": "run 4\nfix off b move linear 0.1 0 0\nrun 495\nunfix off\n"
                        "fix off b move linear 0 0.1 0\nrun 10"}
        wets = {model: stock_pair(model, volume, (0, 0), viscosity=self.MU, motion=slide) for model in (EASO, WASHINO)}
        wets["ours"] = ours(two(1e-9, volume / 2), (0, 0), more=f"formation 2e-9 viscosity {self.MU} "
                            "minimum_separation 1e-5", **slide)
        for name, wet in wets.items():
            arm = wet.vectors("x", 1)[-1] - wet.vectors("x", 0)[-1]
            force = wet.vectors("f", 1)[-1]
            made = wet.vectors("tq", 0)[-1] + wet.vectors("tq", 1)[-1] + np.cross(arm, force)
            over = np.linalg.norm(made) / np.linalg.norm(np.cross(arm, force))
            print(f"{name}: {over:.2g} of the torque of the sliding force is made of nothing")
            if name == "ours":
                self.assertLess(over, 1e-12)
            else:
                self.assertAlmostEqual(over, wet.gaps(0, 1)[-1] / np.linalg.norm(arm), delta=1e-5)


class TrueForce(unittest.TestCase):
    def test_this_solution_is_that_of_the_unit_tests(self):
        """bridges.h has the ratios of `willett` that tests/bridges/young_laplace.h gives."""
        b = Bridge(R, 20 * DEGREE, WATER, 1e-12)
        gaps = np.array([1e-6, 0.3, 0.9]) * lian_rupture(b)
        np.testing.assert_allclose([LAWS["willett"][0](b, s) / f for s, f in zip(gaps, of_pair(b, gaps))],
                                   [1.08, 0.90, 0.78], atol=0.005)

    def test_ours_are_nearer_to_it_than_stock(self):
        for row in compare(points=7):
            off = {}
            for name in CURVES:
                ratio = row[name] / row["young_laplace"]
                off[name] = abs(ratio - 1).max()
                print(f"V / r^3 = {row['v']:g}, {row['degrees']} degrees: {name} over Young and Laplace's force "
                      + " ".join(f"{one:.2f}" for one in ratio))
            # Up to 0.6 of the rupture distance (docs/bridges.md: willett_fit 3 %, lian_toroid 7 %)
            self.assertLess(off["willett_fit"], 0.03)
            self.assertLess(off["lian_toroid"], 0.075)
            self.assertLess(off["willett_fit"], off["easo"])
            self.assertLess(off["lian_toroid"], off["washino"])


if __name__ == "__main__":
    if "--write" in sys.argv:
        write(sys.argv[sys.argv.index("--write") + 1])
    else:
        unittest.main(verbosity=2)
