#!/usr/bin/python3
"""The same grains feel the same forces in LIGGGHTS and in LAMMPS, and ours in LAMMPS the same as LAMMPS's own."""

import unittest

from two_hosts_case import (FORCE, MATERIALS, MOTION, TORQUE, WALLS, crowd, differ, greatest, in_both, run, states_of)

# Both hosts do the same few hundred operations on the same numbers, in another order.
ROUND_OFF = 1e-12
# Velocities stay, so that friction's springs are wound up alike: some slide, some hold.
STEPS = {"dt": 2e-6, "after": "run 20", "every": 20}
STOCK = {"hertz/history": "2e5 NULL 2e3 NULL 0.3 1", "hooke/history": "2e3 1e3 2e3 1e3 0.3 1 limit_damping"}


LIQUID = ("fix liquid all liquid content 0.02 surface_tension 0.0728 contact_angle 0.35 viscosity 1e-3 "
          "minimum_separation 1e-6\n")
NECKS = """\
fix tension all property/global neckSurfaceTension peratomtypepair 2 1 1.2 1.2 1.5
fix tensile all property/global neckTensileStrength peratomtypepair 2 1e6 1e6 1e6 1e6
fix shear all property/global neckShearStrength peratomtypepair 2 5e5 5e5 5e5 5e5
fix stiff all property/global neckStiffness peratomtypepair 2 1e3 2e3 2e3 3e3
fix lattice all property/global neckLatticeConstant scalar 3e-10
fix surface1 all property/global surfaceDiffusionPrefactor scalar 5.2e-2
fix surface2 all property/global surfaceDiffusionEnergy scalar 2e5
fix volume1 all property/global volumeDiffusionPrefactor scalar 1.8e-3
fix volume2 all property/global volumeDiffusionEnergy scalar 2.5e5
"""
CHARGES = {"liggghts": "fix charge all property/atom electricCharge scalar yes yes no 1e-10\n",
           "lammps": "fix charge all property/atom d_electricCharge ghost yes\nset group all d_electricCharge 1e-10\n"}
# Of each cohesion: the script's lines, alike or by host, and its words.
COHESIONS = {
    "bridge": (LIQUID, ""),
    "van_der_waals": ("fix hamaker all property/global hamakerConstant peratomtype 4e-18 8e-18\n",
                      "smallest_gap 4e-10 greatest_gap 1e-5 tangential_reduce on"),
    "jkr": ("fix work all property/global workOfAdhesion peratomtypepair 2 0.5 1 1 2\n", ""),
    "electrostatic": (CHARGES, "greatest_gap 2e-4"),
    "sintered_neck": (NECKS, "greatest_gap 1e-5 neck_temperature 1200"),
}


def read_local(text):
    """The rows of the last step of a local dump, without their numbers."""
    lines = text.split("ITEM: ENTRIES")[-1].splitlines()[1:]
    return [[float(word) for word in line.split()[1:]] for line in lines]


class Forces(unittest.TestCase):
    grains = crowd()

    def both(self, contact, grains=None, **settings):
        """The states of the last step in both hosts."""
        lines = settings.pop("lines", "")
        properties = ({host: MATERIALS + own for host, own in lines.items()} if isinstance(lines, dict)
                      else MATERIALS + lines)
        states = in_both(grains or self.grains, contact, **{**STEPS, "properties": properties, **settings})
        self.assertEqual(*(max(state) for state in states))
        for step in (min(states[0]), max(states[0])):
            one, other = (state[step] for state in states)
            for columns in (FORCE, TORQUE):
                self.assertLess(differ(one, other, columns), ROUND_OFF, f"{contact}, step {step}")
        return states[0][max(states[0])], states[0][min(states[0])]

    def test_a_hundred_dry_grains_with_walls_feel_the_same_with_every_normal_and_tangential_model(self):
        for normal in ("hertz", "hooke", "hertz/stiffness", "hooke/stiffness"):
            for tangential in ("history", "no_history"):
                last, first = self.both(f"model {normal} tangential {tangential}", walls=WALLS)
                self.assertGreater(greatest(last, TORQUE), 0.0)
                if tangential == "history":
                    self.assertGreater(differ(last, first, TORQUE), 1e-3)  # the springs were wound up

    def test_a_hundred_grains_feel_the_same_with_every_model_of_rolling_friction(self):
        for rolling in ("cdt", "epsd", "epsd2", "viscous", "limited"):
            self.both(f"model hertz tangential history rolling_friction {rolling}", walls=WALLS)

    def test_the_words_of_the_models_do_in_lammps_what_they_do_in_liggghts(self):
        for contact, words in (
                ("model hertz tangential history", "limitForce on tangential_damping off"),
                ("model hooke tangential history", "viscous on ktToKnUser on limitForce on"),
                ("model hooke/stiffness tangential no_history", "absolute_damping on"),
                ("model hertz tangential history rolling_friction cdt", "torsionTorque on"),
                ("model hertz tangential history rolling_friction epsd", "torsionTorque on")):
            default, _ = self.both(contact, walls=WALLS)
            changed, _ = self.both(contact, walls=WALLS, words=words)
            self.assertGreater(max(differ(default, changed, FORCE), differ(default, changed, TORQUE)), 1e-9, words)

    def test_a_hundred_grains_with_walls_feel_the_same_with_every_cohesion(self):
        dry, _ = self.both("model hertz tangential history", walls=WALLS)
        for cohesion, (lines, words) in COHESIONS.items():
            for rolling in ("", "rolling_friction limited") if cohesion == "bridge" else ("",):
                last, _ = self.both(f"model hertz tangential history cohesion {cohesion} {rolling}", walls=WALLS,
                                    words=words, lines=lines)
                self.assertGreater(differ(dry, last, FORCE), 1e-7, cohesion)  # it acts

    def test_two_grains_and_a_grain_in_a_corner_feel_the_same(self):
        pair = [(1, 0.002, 2500.0, [0.01, 0.01, 0.01], [0.1, -0.05, 0.02], [30.0, 10.0, -20.0]),
                (2, 0.003, 1500.0, [0.0117, 0.0117, 0.0104], [-0.1, 0.02, 0.0], [5.0, -40.0, 10.0])]
        corner = [(1, 0.002, 2500.0, [0.00199, 0.01801, 0.00199], [-0.1, 0.05, -0.1], [30.0, 10.0, -20.0])]
        for grains in (pair, corner):
            last, _ = self.both("model hertz tangential history rolling_friction epsd", grains, walls=WALLS[:3])
            self.assertGreater(greatest(last, FORCE), 0.0)

    def test_two_ranks_feel_what_one_feels(self):
        contact = "model hertz tangential history rolling_friction epsd cohesion bridge"
        one, two = (states_of("lammps", self.grains, contact, walls=WALLS, ranks=ranks, dt=2e-6, every=50,
                              properties=MATERIALS + LIQUID, after="fix move all nve/sphere\nrun 200")
                    for ranks in (1, 2))
        for columns in (MOTION, FORCE, TORQUE):
            self.assertLess(differ(one[200], two[200], columns), ROUND_OFF)

    def test_lammps_own_laws_are_felt_as_its_own_styles_have_them(self):
        walls = ("xplane 0.019", "zplane 0.001")
        for law, arguments in STOCK.items():
            for newton, ranks in (("off", 1), ("on", 1), ("on", 2)):
                # Grains move, part and meet, and change ranks.
                settings = {"newton": newton, "ranks": ranks, "dt": 2e-6, "every": 10,
                            "after": "fix move all nve/sphere\nrun 100"}
                own = states_of("lammps", self.grains, "", pair=f"gran/{law} {arguments}",
                                walls=("xplane NULL 0.019", "zplane 0.001 NULL"),
                                wall=f"fix wall{{}} all wall/gran {law} {arguments} {{}}", **settings)
                ours = states_of("lammps", self.grains, f"{law} {arguments}", walls=walls, **settings)
                for columns in (FORCE, TORQUE):
                    self.assertLess(max(differ(own[n], ours[n], columns) for n in own), ROUND_OFF, law)

    def test_grains_of_a_rigid_body_have_its_mass_as_in_lammps_own_styles(self):
        arguments = STOCK["hertz/history"]
        after = ("group clump id < 9\ngroup rest subtract all clump\nfix body clump rigid single\n"
                 "fix move rest nve/sphere\nneigh_modify exclude group clump clump\nrun 100")
        for newton, ranks in (("off", 1), ("on", 2)):
            settings = {"dt": 2e-6, "after": after, "newton": newton, "ranks": ranks, "every": 10}
            own = states_of("lammps", self.grains, "", pair=f"gran/hertz/history {arguments}",
                            walls=("zplane 0.001 NULL",), wall=f"fix wall{{}} all wall/gran hertz/history {arguments} {{}}",
                            **settings)
            ours = states_of("lammps", self.grains, f"hertz/history {arguments}", walls=("zplane 0.001",), **settings)
            for columns in (MOTION, FORCE):
                self.assertLess(max(differ(own[n], ours[n], columns) for n in own), ROUND_OFF)

    def test_what_compute_pair_local_reads_is_as_in_lammps_own_styles(self):
        arguments = STOCK["hertz/history"]
        after = ("compute loc all pair/local dist force p1 p2 p3 p4 p5 p8\ndump loc all local 5 later.txt index c_loc[*]\n"
                 "dump_modify loc format float %.17g\nrun 5")
        rows = [read_local(run("lammps", self.grains, f"hertz/history {arguments}", after=after, pair=pair,
                               keep="later.txt", dt=2e-6)[3])
                for pair in (None, f"gran/hertz/history {arguments}")]
        self.assertGreater(len(rows[0]), 50)
        self.assertEqual(len(rows[0]), len(rows[1]))
        for column in zip(*(zip(*part) for part in rows)):
            most = max(map(abs, column[1]))
            self.assertLess(max(abs(a - b) for a, b in zip(*column)), ROUND_OFF * max(most, 1e-300))

    def test_frozen_grains_and_round_walls_are_as_in_lammps_own_styles(self):
        arguments = STOCK["hertz/history"]
        still = "group still id < 30\nfix still still freeze\nfix move all nve/sphere\nrun 100"
        own = states_of("lammps", self.grains, "", pair=f"gran/hertz/history {arguments}", dt=2e-6, after=still)
        ours = states_of("lammps", self.grains, f"hertz/history {arguments}", dt=2e-6, after=still)
        self.assertLess(max(differ(own[n], ours[n], MOTION) for n in own), ROUND_OFF)
        # LAMMPS's own cylinder stands at 0, 0
        moved = [(kind, size, density, [place[0] - 0.01, place[1] - 0.01, place[2]], speed, spin)
                 for kind, size, density, place, speed, spin in self.grains]
        settings = {"dt": 2e-6, "after": "run 20", "low": -0.01, "every": 20}
        own = states_of("lammps", moved, "", pair=f"gran/hertz/history {arguments}", walls=("zcylinder 0.0095",),
                        wall=f"fix wall{{}} all wall/gran hertz/history {arguments} {{}}", **settings)
        ours = states_of("lammps", moved, f"hertz/history {arguments}", walls=("zcylinder 0.0095 0 0",), **settings)
        for columns in (FORCE, TORQUE):
            self.assertLess(differ(own[20], ours[20], columns), ROUND_OFF)

    def test_a_restart_goes_on_with_the_history_of_pairs_and_walls(self):
        move = "fix move all nve/sphere\n"
        for contact, lines, ranks in (("model hertz tangential history rolling_friction epsd", "", 1),
                                      ("model hertz tangential history cohesion bridge", LIQUID, 2)):
            settings = {"walls": WALLS, "dt": 2e-6, "properties": MATERIALS + lines, "ranks": ranks, "every": 100}
            whole = states_of("lammps", self.grains, contact, after=move + "run 100\nrun 100", **settings)
            walls = "".join(f"fix wall{n} all wall/gran/bridge {contact} primitive type 2 {shape}\n"
                            for n, shape in enumerate(WALLS))
            resume = ("write_restart half\nclear\ninclude @plugin@\nnewton off\nread_restart half\nneighbor 5e-4 bin\n"
                      "neigh_modify delay 0\natom_modify sort 0 0\n"
                      f"{MATERIALS}{lines}pair_style gran/bridge {contact}\npair_coeff * *\n{walls}{move}@dump@\nrun 100")
            halves = states_of("lammps", self.grains, contact, after=move + "run 100\n" + resume, **settings)
            for columns in (MOTION, FORCE, TORQUE):
                self.assertLess(differ(whole[200], halves[200], columns), ROUND_OFF)
            # Without what the walls remember it would be another end.
            fresh = states_of("lammps", self.grains, contact,
                              after=move + "run 100\n" + resume.replace("fix wall", "fix other"), **settings)
            self.assertGreater(differ(whole[200], fresh[200], FORCE), 1e-9)


class Refusals(unittest.TestCase):
    def refusal(self, contact, **settings):
        status, output, _ = run("lammps", crowd(4), contact, **settings)
        self.assertNotEqual(status, 0)
        return output

    def test_misspelt_models_words_and_properties_are_answered_with_the_nearest_name(self):
        self.assertIn('model "hertzz" is unknown. Did you mean "hertz"?',
                      self.refusal("model hertzz tangential history"))
        self.assertIn('the word "limitforce" is unknown to these models. Did you mean "limitForce"?',
                      self.refusal("model hertz tangential history", words="limitforce on"))
        self.assertIn('The script has "youngModulus": is it misspelt?',
                      self.refusal("model hertz tangential history",
                                   properties=MATERIALS.replace("youngsModulus", "youngModulus")))

    def test_a_combination_that_is_not_compiled_is_answered_with_those_that_are(self):
        output = self.refusal("model hooke/stiffness tangential history cohesion van_der_waals")
        self.assertIn("is not compiled with cohesion van_der_waals. These are:", output)
        self.assertIn("model hertz tangential history rolling_friction off", output)

    def test_properties_outside_of_their_range_and_unfit_scenes_are_refused(self):
        contact = "model hertz tangential history"
        self.assertIn("coefficientRestitution of types 1 and 2 is 1.5; allowed: above 0 to 1.",
                      self.refusal(contact, properties=MATERIALS.replace("0.9 0.8 0.8 0.6", "0.9 1.5 1.5 0.6")))
        self.assertIn("a property of pairs is symmetric",
                      self.refusal(contact, properties=MATERIALS.replace("0.9 0.8 0.8 0.6", "0.9 0.8 0.7 0.6")))
        self.assertIn("Write 'newton off'", self.refusal(
            contact + " cohesion van_der_waals", newton="on",
            properties=MATERIALS + "fix hamaker all property/global hamakerConstant peratomtype 1e-19 1e-19\n"))
        self.assertIn("is no shape of a wall", self.refusal(contact, walls=("zplan 0.0",)))


if __name__ == "__main__":
    unittest.main(verbosity=2)
