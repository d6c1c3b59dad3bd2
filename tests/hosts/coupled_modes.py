#!/usr/bin/python3
"""Ways of coupling: overlapped, the ways of sharing momentum, what goes over the wire."""

import unittest

from coupled_launch import COUPLE, Scene

STEPS = 2500  # 0.05 s


def run(couple=COUPLE, dem_ranks=1, gas_ranks=1, steps=STEPS, **marks):
    with Scene(couple=couple, steps=steps, **marks) as scene:
        status, text, _ = scene.run(dem_ranks=dem_ranks, gas_ranks=gas_ranks)
        assert status == 0, text
        return scene.history()


def vector(row, name):
    return [row[name.format(axis)] for axis in "xyz"]


class Modes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.in_turn = run()

    def assert_momentum_closes(self, history):
        """Change of the grains' momentum = taken from the gas + grad p + walls and weight."""
        first, scale = history[0], history[-1]["impulse_exchanged_Ns"]
        for row in history:
            for before, now, *impulses in zip(
                    vector(first, "momentum_{}_Ns"), vector(row, "momentum_{}_Ns"),
                    vector(row, "impulse_taken_{}_Ns"), vector(row, "impulse_free_{}_Ns"),
                    vector(row, "impulse_host_{}_Ns")):
                self.assertLess(abs(now - before - sum(impulses)), 1e-10 * scale, row["step"])

    def assert_ledger_closes(self, history, bound=1e-10):
        for row in history:
            self.assertLess(row["ledger_residual"], bound, row["step"])
        for left in vector(history[-1], "impulse_left_{}_Ns"):
            self.assertLess(abs(left), 1e-12 * history[-1]["impulse_exchanged_Ns"])

    def test_in_turn_both_balances_close(self):
        self.assert_ledger_closes(self.in_turn)
        self.assert_momentum_closes(self.in_turn)

    def test_overlapped_both_balances_close_whatever_the_ranks(self):
        couple = COUPLE.replace("void_fraction", "mode overlapped void_fraction")
        for boundary in ("f f f", "p p f"):
            for dem_ranks, gas_ranks in ((1, 1), (2, 2)):
                with self.subTest(boundary=boundary, dem_ranks=dem_ranks):
                    marks = {}
                    if boundary == "p p f":
                        marks = {"boundary": boundary, "extra": "unfix x_lo\nunfix x_hi\n"
                                 "unfix y_lo\nunfix y_hi\n"}
                    history = self.overlapped(couple, dem_ranks, gas_ranks, marks)
                    self.assertGreater(history[-1]["bed_height_m"],
                                       1.02 * history[0]["bed_height_m"])
                    self.assert_ledger_closes(history)
                    self.assert_momentum_closes(history)

    def overlapped(self, couple, dem_ranks, gas_ranks, marks):
        with Scene(couple=couple, steps=STEPS, processors="processors * 1 1", **marks) as scene:
            if marks:
                gas = scene.folder / "gas.toml"
                gas.write_text(gas.read_text().replace(
                    "[boundary]\n", "[boundary]\n" + "".join(
                        f'{side} = "periodic"\n' for side in ("x_lo", "x_hi", "y_lo", "y_hi"))))
            status, text, _ = scene.run(dem_ranks=dem_ranks, gas_ranks=gas_ranks)
            self.assertEqual(status, 0, text)
            return scene.history()

    def test_overlapped_goes_on_from_a_checkpoint(self):
        couple = COUPLE.replace("void_fraction", "mode overlapped void_fraction")
        with Scene(couple=couple, steps=1000,
                   extra="restart 510 @out@/checkpoint/dem.*.restart") as scene:
            status, text, _ = scene.run()
            self.assertEqual(status, 0, text)
            whole = scene.history()
            scene.resume(510, 1000)
            status, text, _ = scene.run(
                gas_options=("--restart", str(scene.out / "checkpoint/gas.510.h5")))
            self.assertEqual(status, 0, text)
            again = scene.history()[len(whole):]
        self.assertEqual(again[-1]["step"], 1000)
        self.assert_ledger_closes(again)
        for name in ("bed_height_m", "kinetic_energy_J", "p_0.01m_Pa"):
            self.assertAlmostEqual(whole[-1][name], again[-1][name],
                                   delta=1e-3 * abs(whole[-1][name]) + 1e-12, msg=name)

    def test_overlapped_differs_from_in_turn_as_the_interval(self):
        def greatest_difference(every):
            def at(mode):
                couple = COUPLE.replace("every 25", f"every {every} mode {mode}")
                rows = run(couple, steps=500)
                return {row["step"]: row["kinetic_energy_J"] for row in rows}
            ours, theirs = at("in_turn"), at("overlapped")
            self.assertEqual(sorted(ours), sorted(theirs))
            return max(abs(ours[step] - theirs[step]) for step in ours) / max(ours.values())

        long, short = greatest_difference(50), greatest_difference(10)
        self.assertGreater(long, 0.0)
        self.assertLess(short, 0.5 * long)

    def test_scheme_2_closes_and_scheme_1_tells_what_it_lost(self):
        self.assert_ledger_closes(run(COUPLE + " momentum_sharing scheme_2"))
        lost = run(COUPLE + " momentum_sharing scheme_1")
        self.assertGreater(lost[-1]["ledger_residual"], 1e-6)

    def test_only_fields_that_are_needed_go_over_the_wire(self):
        cells = 4 * 4 * 20

        def numbers_a_cell(effects):
            rows = run(f"fix gas all couple/gas every 25 output @out@ {effects}", steps=125)
            return rows[-1]["bytes_of_fields"] / 8 / cells

        # Solids; with drag eps, K, S and u; a vector for grad p.
        self.assertEqual(numbers_a_cell("void_fraction trilinear"), 1)
        self.assertEqual(numbers_a_cell("void_fraction trilinear pressure_gradient"), 1 + 3)
        drag = numbers_a_cell("void_fraction trilinear drag koch_hill")
        self.assertEqual(drag, 1 + 1 + 1 + 3 + 3)
        both = numbers_a_cell("void_fraction trilinear drag koch_hill pressure_gradient")
        self.assertEqual(both, drag + 3)
        sharing = numbers_a_cell(
            "void_fraction trilinear drag koch_hill momentum_sharing scheme_2")
        self.assertEqual(sharing, drag + 3 + 3)
        mixture = numbers_a_cell("void_fraction trilinear drag beetstra polydisperse")
        self.assertEqual(mixture, drag + 1 + 1)
        for force, needs in (("saffman_mei", 3), ("virtual_mass", 3), ("viscous_stress", 3)):
            self.assertEqual(numbers_a_cell(f"void_fraction trilinear drag koch_hill {force}"),
                             drag + needs, force)

    def test_every_force_is_in_the_ledger_and_does_something(self):
        forces = ("viscous_stress virtual_mass basset saffman_mei magnus rotation_torque "
                  "lorentz charge 1e-9 electric 0 0 1e3")
        history = run(f"{COUPLE} {forces} polydisperse")
        self.assert_ledger_closes(history)
        self.assert_momentum_closes(history)
        for name in ("drag", "pressure_gradient", *forces.split()[:6], "lorentz"):
            self.assertGreater(history[-1][f"impulse_of_{name}_Ns"], 0.0, name)

    def test_an_unknown_mode_is_told_with_the_nearest_name(self):
        with Scene(couple=COUPLE.replace("void_fraction", "mode overlaped void_fraction")) as scene:
            status, text, seconds = scene.run()
        self.assertNotEqual(status, 0)
        self.assertLess(seconds, 10)
        self.assertIn('Did you mean "overlapped"?', text)

    def test_forces_that_come_later_are_warned_of(self):
        with Scene(steps=50, extra="fix late all viscous 1e-6") as scene:
            status, text, _ = scene.run()
        self.assertEqual(status, 0, text)
        self.assertIn("fix late viscous stands after it", text)


if __name__ == "__main__":
    unittest.main(verbosity=2)
