#!/usr/bin/python3
"""`pair_style gran/bridge` does in LIGGGHTS what `pair_style gran` does: forces, history, what the host asks for."""

import re
import unittest

from fused_case import (FORCES, NEW_LISTS, STYLES, crowd, differ, dump, head, launch, lines_of, pair, results, rows_differ,
                        rows_of, states, walls)

# Both do the same few hundred operations on the same numbers, in another order.
ROUND_OFF = 1e-12
ROLLING = ("off", "cdt", "epsd", "epsd2", "viscous", "limited")
# Values of a contact's history.
WIDTHS = {"history": 3, "epsd": 3, "epsd2": 3, "bridge": 6, "jkr": 1, "sintered_neck": 6}
DRY = [(normal, tangential, rolling, "off") for normal in ("hertz", "hooke", "hertz/stiffness", "hooke/stiffness")
       for tangential in ("history", "no_history", "off") for rolling in ROLLING]
CONTACT = "model hertz tangential history rolling_friction epsd"
MOVE = "fix move all nve/sphere\n"


def contact_of(normal, tangential, rolling, cohesion):
    """In LIGGGHTS's order of words."""
    return (f"model {normal}" + f" tangential {tangential}" * (tangential != "off")
            + f" cohesion {cohesion}" * (cohesion != "off") + f" rolling_friction {rolling}" * (rolling != "off"))


def compiled_with(cohesion):
    """The stacks that the message about one that is not compiled lists."""
    lines, words = lines_of(cohesion)
    status, output, _ = launch(head(data=lines) + pair("gran/bridge", f"model hertz/stiffness tangential history "
                                                                      f"cohesion {cohesion}", words) + "run 0")
    assert status == 1 and "'pair_style gran'" in output, output[-2000:]
    assert "damped_history" not in output  # LAMMPS's own
    found = re.findall(r"model (\S+) tangential (\S+) rolling_friction (\S+)$", output, re.MULTILINE)
    return [(*names, cohesion) for names in found
            if cohesion != "jkr" or names[0] == "hertz"]  # with Hertz's alone


class Fused(unittest.TestCase):
    def sections(self, style, stacks):
        """A run of each stack in one script: walls, frozen grains, springs that have been wound up for some steps."""
        text = ""
        for n, stack in enumerate(stacks):
            lines, words = lines_of(stack[3])
            contact = contact_of(*stack)
            width = sum(WIDTHS.get(name, 0) for name in stack)
            columns = " ".join(f"c_loc[{c}]" for c in range(1, 4 + width))
            text += ("clear\n" * (n > 0) + head(data=lines) + "thermo_modify norm no\n" + pair(style, contact, words)
                     + walls(contact, words) + "group still id < 20\nfix still still freeze\n"
                     + "compute loc all pair/gran/local id" + " history" * (width > 0) + "\n" + dump(f"s{n}", 10)
                     + f"dump loc all local 10 l{n}.txt {columns}\n"
                     + f'dump_modify loc format "%.0f %.0f %.0f {"%.17g " * width}"\nrun 10\n')
        return text

    def compare(self, stacks, ranks):
        files = [results(self.sections(style, stacks), ranks=ranks) for style in STYLES]
        for n, stack in enumerate(stacks):
            one, other = (states(text, f"s{n}.txt")[10] for text in files)
            for columns in (FORCES[:3], FORCES[3:]):
                self.assertLess(differ(one, other, columns), ROUND_OFF, stack)
            rows = [rows_of(text[f"l{n}.txt"]) for text in files]
            self.assertGreater(len(rows[0]), 35, stack)
            self.assertLess(rows_differ(*rows), ROUND_OFF, stack)
            if "history" in stack:
                self.assertGreater(max(abs(row[-1]) for row in rows[0]), 0.0, stack)  # of a spring that was wound up

    def test_every_compiled_stack_has_the_forces_torques_and_histories_of_pair_style_gran(self):
        stacks = list(DRY)
        for cohesion in ("bridge", "van_der_waals", "jkr", "electrostatic", "sintered_neck"):
            found = compiled_with(cohesion)
            self.assertEqual(len(found), 12 if cohesion == "jkr" else 24)
            stacks += found
        self.compare(stacks, 1)
        self.compare(stacks[::7], 2)

    def moved(self, style, contact, after, lines="", every=100, before_walls="", **settings):
        return results(head(data=lines) + pair(style, contact) + before_walls + walls(contact) + MOVE
                       + dump(every=every) + after, **settings)

    def test_grains_that_meet_and_part_move_alike_where_no_spring_outlives_its_contact(self):
        stock = states(self.moved("gran", CONTACT, NEW_LISTS + "run 200"))
        for ranks in (1, 2):
            fused = states(self.moved("gran/bridge", CONTACT, "run 200", ranks=ranks))
            for n in stock:
                self.assertLess(differ(stock[n], fused[n], FORCES[:3]), ROUND_OFF)
                self.assertLess(differ(stock[n], fused[n], FORCES[3:]), ROUND_OFF)

    def test_either_style_goes_on_from_the_restart_file_of_the_other(self):
        for cohesion, ranks in (("off", 1), ("bridge", 2)):
            contact = contact_of("hertz", "history", "epsd", cohesion)
            lines, _ = lines_of(cohesion)
            whole = states(self.moved("gran", contact, NEW_LISTS + "run 100\nrun 100", lines, ranks=ranks))
            for first, second in (STYLES, STYLES[::-1], STYLES[1:] * 2):
                resume = ("run 100\nwrite_restart half\nclear\n" + head(grains="read_restart half", data=lines)
                          + pair(second, contact) + walls(contact) + MOVE + dump("later", 100) + NEW_LISTS + "run 100")
                later = states(self.moved(first, contact, NEW_LISTS + resume, lines, ranks=ranks), "later.txt")
                self.assertLess(differ(whole[200], later[200], FORCES), ROUND_OFF, (first, second))

    def test_computes_and_fixes_of_the_host_are_told_the_same_of_each_contact(self):
        asked = "pos vel id force force_normal force_tangential torque torque_tangential contactArea delta"
        columns = " ".join(f"c_loc[{n}]" for n in range(1, 33))
        after = (f"compute stress all stress/atom virial\ncompute loc all pair/gran/local {asked}\n"
                 f"dump loc all local 5 local.txt {columns}\ndump_modify loc format \"{'%.17g ' * 32}\"\n"
                 "dump told all custom 5 told.txt id f_press c_stress[1] c_stress[2] c_stress[4] f_stressTensor_[1] "
                 f"f_stressTensor_[4]\ndump_modify told sort id format \"%d{' %.17g' * 6}\"\nrun 5")
        press = "fix press all property/atom sum_normal_force_ scalar no no no 0.0\n"
        weighted = "fix weighted all continuum/weighted kernel_radius 0.006 kernel_type Top_Hat compute stress\n"
        for cohesion in ("off", "bridge"):
            lines, _ = lines_of(cohesion)
            contact = contact_of("hertz", "history", "epsd", cohesion)
            files = [self.moved(style, contact, after, lines + press, 5, weighted) for style in STYLES]
            rows = [rows_of(text["local.txt"]) for text in files]
            self.assertGreater(len(rows[0]), 35)
            self.assertLess(rows_differ(*rows), ROUND_OFF)
            told = [rows_of(text["told.txt"], "ATOMS") for text in files]
            for values in list(zip(*told[0]))[1:]:
                self.assertGreater(max(map(abs, values)), 0.0)
            if cohesion == "bridge":  # of bodies apart the host takes the normal of those before
                told = [[row[:1] + row[2:] for row in table] for table in told]
            self.assertLess(rows_differ(*told), ROUND_OFF)
            self.assertLess(differ(*(states(text)[5] for text in files), FORCES), ROUND_OFF)

    def test_grains_of_a_rigid_body_have_its_mass(self):
        body = ("unfix move\ngroup clump id < 9\ngroup rest subtract all clump\nfix body clump rigid single\n"
                "fix move rest nve/sphere\nneigh_modify exclude group clump clump\n" + NEW_LISTS + "run 100")
        for ranks in (1, 2):
            one, other = (states(self.moved(style, CONTACT, body, ranks=ranks))[100] for style in STYLES)
            self.assertLess(differ(one, other, FORCES[:3]), ROUND_OFF)

    def test_walls_that_the_hosts_models_take_are_told_of_and_do_the_same(self):
        plain = "fix floor all wall/gran {contact} primitive type 2 zplane 0.001"
        body = "group clump id < 9\ngroup rest subtract all clump\nfix body clump rigid single\nneigh_modify exclude group clump clump\n"
        for before, line, says in (
                ("", plain, None),
                ("", plain + " store_force yes", "forces or energies of its contacts are stored"),
                ("", plain + " shear x 0.1", "of its 'shear'"),
                ("group some id > 30\n", plain.replace(" all ", " some "), "its group is not 'all'"),
                (body, plain, "of 'fix rigid'")):
            files = []
            for style in STYLES:
                status, output, written = launch(head() + pair(style, CONTACT) + before + line.format(contact=CONTACT)
                                                 + "\nfix move all nve/sphere\n" + dump(every=20) + NEW_LISTS + "run 20")
                self.assertEqual(status, 0, output[-2000:])
                files.append(written)
                if "gran/bridge: instructions portable" in output and says is None:
                    says = "one contact comes after the other"
                told = "fix floor wall/gran: LIGGGHTS's own models take its contacts, because"
                self.assertEqual(output.count(told), int(says is not None and style != "gran"), output[-2000:])
                if says is not None and style != "gran":
                    self.assertIn(f"{told} {says}\n", output)
            self.assertLess(differ(*(states(text)[20] for text in files), FORCES[:3]), ROUND_OFF, line)

    def test_what_it_does_not_take_is_refused_with_a_way_out(self):
        for line, says in (("pair_style gran/bridge model hertz tangential history heating_tracking on",
                            "\"heating_tracking\" is unknown to these models"),
                           ("pair_style gran/bridge model hooke/hysteresis", "model \"hooke/hysteresis\" is unknown"),
                           ("pair_style gran/bridge model hertz tangential history cohesion sjkr",
                            "cohesion \"sjkr\" is unknown. Did you mean \"jkr\"?"),
                           ("pair_style hybrid gran/bridge model hertz tangential history", "it is the only pair style")):
            status, output, _ = launch(head() + line + "\nrun 0")
            self.assertEqual(status, 1, line)
            self.assertIn(says, output)
            self.assertIn("gran'", output)
        status, output, _ = launch(head() + "run 0", GASGRAIN_PAIR_STYLE="stock")
        self.assertEqual(status, 1)
        self.assertIn("GASGRAIN_PAIR_STYLE=stock: it is gran", output)

    def test_the_environment_puts_the_hosts_own_loop_under_its_name(self):
        script = head() + pair("gran/bridge", CONTACT) + walls(CONTACT) + MOVE + dump(every=200) + "run 200"
        stock = results(script.replace("gran/bridge", "gran"))
        self.assertEqual(results(script, GASGRAIN_PAIR_STYLE="gran")["state.txt"], stock["state.txt"])
        self.assertNotEqual(results(script)["state.txt"], stock["state.txt"])

    def test_a_run_says_with_which_instructions_contacts_are_computed(self):
        for cohesion in ("off", "van_der_waals"):  # of cohesion one contact comes after the other
            lines, words = lines_of(cohesion)
            script = head(data=lines) + pair("gran/bridge", contact_of("hertz", "history", "epsd", cohesion), words) + MOVE
            _, output, _ = launch(script + "run 1\nrun 1", GASGRAIN_INSTRUCTIONS="portable")
            self.assertEqual(output.count("pair_style gran/bridge: instructions portable\n"), 1, output)
        _, output, _ = launch(head() + pair("gran/bridge", CONTACT) + MOVE + "run 1", GASGRAIN_INSTRUCTIONS="avx3")
        self.assertIn("GASGRAIN_INSTRUCTIONS=avx3 is not of this machine", output)


if __name__ == "__main__":
    unittest.main(verbosity=2)
