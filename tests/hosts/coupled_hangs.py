#!/usr/bin/python3
"""Three ways in which a stock host would wait for ever for the partner program; none does here."""

import unittest

from coupled_launch import Scene

VTK = """\
dump a all custom/vtk 100 @out@/particles/p_*.vtk id type x y z vx vy vz radius
dump b all custom/vtk 100 @out@/particles/p_*.vtp id type x y z vx vy vz radius
dump c all local/gran/vtk 100 @out@/particles/contacts_*.vtk contacts"""
CONTACTS = "compute contacts all pair/gran/local pos id force"


class Hangs(unittest.TestCase):
    def finishes(self, gas_first, **marks):
        with Scene(steps=200, **marks) as scene:
            status, text, _ = scene.run(timeout=60, dem_ranks=2, gas_first=gas_first)
            self.assertEqual(status, 0, text)
            return text, sorted(p.name for p in (scene.out / "particles").glob("*"))

    def test_verbose_timing_gathers_on_the_world(self):
        for gas_first in (False, True):
            text, _ = self.finishes(gas_first, extra="modify_timing verbose")
            self.assertIn("Loop time", text)

    def test_vtk_dumps_start_a_controller_on_the_world(self):
        for gas_first in (False, True):
            _, files = self.finishes(gas_first, extra=CONTACTS + "\n" + VTK)
            self.assertIn("p_200.vtk", files)
            self.assertIn("p_200.vtp", files)

    def test_an_error_in_the_middle_finalizes_mpi(self):
        with Scene(extra="unfix z_lo\nthermo 100", steps=100000) as scene:
            status, text, seconds = scene.run(timeout=60, dem_ranks=1)
        self.assertNotEqual(status, 0, text)
        self.assertLess(seconds, 30)

    def test_quit_is_an_orderly_end(self):
        text, _ = self.finishes(False, extra="run 50\nquit")
        self.assertNotIn("error", text)


if __name__ == "__main__":
    unittest.main(verbosity=2)
