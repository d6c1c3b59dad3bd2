#!/usr/bin/python3
"""A run that goes wrong stops at once: one message says which grain or cell, when, and what to change,
and the state of both sides is kept beside the good checkpoints. Before it, a DEM step that is too long
for the contacts is refused."""

import re
import subprocess
import tempfile
import unittest
from pathlib import Path

import h5py

from coupled_launch import BIN, COUPLE, HOST, SOURCE, Scene, command_of, in_words_of, pids_left_of

SOON = 20.0  # s, on a machine that does other things too
ONE_PLACE = """\
run 100
create_atoms 1 single 0.011 0.011 0.09 units box
create_atoms 1 single 0.011 0.011 0.09 units box
set group all diameter 0.0025 density 2500"""
INSIDE = COUPLE.replace("output", "gas gas.toml output")
OVERLAPPED = COUPLE.replace("output", "mode overlapped output")


def replaced(name, old, new):
    """An edit of a scene's file, of the script in LIGGGHTS's words."""
    old, new = (in_words_of(HOST, words, BIN) for words in (old, new))

    def edit(scene):
        file = scene.folder / name
        text = file.read_text()
        assert old in text, f"{name} has no {old}"
        file.write_text(text.replace(old, new, 1))
    return edit


def messages(text):
    """Each of our error messages, up to the empty line that ends it."""
    return re.findall(r"^gasgrain-\w+: error: .*?(?=\n\n|\Z)", text, flags=re.M | re.S)


def grains_of(folder, restart):
    """The host alone reads the file, and counts."""
    script = folder / "in.autopsy"
    script.write_text(in_words_of(HOST, "atom_style granular\natom_modify map array\nnewton off\n"
                                  f"communicate single vel yes\nread_restart {restart}\n"
                                  "print 'there are $(atoms) grains'\n", BIN))
    done = subprocess.run([*command_of(HOST, BIN), "-in", script.name], cwd=folder, text=True,
                          capture_output=True, timeout=60, check=False)
    found = re.search(r"^  (\d+) atoms$", done.stdout, flags=re.M)
    assert found, done.stdout + done.stderr
    return int(found[1])


class Watch(unittest.TestCase):
    def stops(self, words, edit=None, grains=768, gas_alone=False, **options):
        """The run ends with these words in its one message, and with a pair of autopsy files."""
        ranks = {key: options.pop(key) for key in ("dem_ranks", "gas_ranks") if key in options}
        with Scene(**options) as scene:
            if edit:
                edit(scene)
            if options.get("couple") == INSIDE:
                command = scene.command
                scene.command = lambda **o: command(**o)[:command(**o).index(":")]
            status, text, seconds = scene.run(timeout=60, **ranks)
            self.assertNotEqual(status, 0, text)
            self.assertLess(seconds, SOON, text)
            for program in ("gasgrain-gas", command_of(HOST, BIN)[0].rpartition("/")[2]):
                self.assertEqual(pids_left_of(program, scene.folder), [])
            told = messages(text)
            self.assertEqual(len(told), 1, text)
            for word in words:
                self.assertRegex(told[0], word)
            dem, gas = self.autopsy(scene)
            self.assertIn(f"For an autopsy, the state is in {dem} and {gas}", told[0])
            self.assertEqual(grains_of(scene.folder, dem), grains)
            with h5py.File(gas) as file:
                self.assertEqual(file["velocity_z"].ndim, 3)
            self.assertEqual(list((scene.out / "checkpoint").glob("dem.*")), [])
            rows = scene.history()
            self.assertTrue(all(len(row) == len(rows[0]) for row in rows))
            return told[0], rows

    def autopsy(self, scene):
        folder = scene.out / "checkpoint"
        dem = list(folder.glob("autopsy.dem.*.restart"))
        gas = list(folder.glob("autopsy.gas.*.h5"))
        self.assertEqual((len(dem), len(gas)), (1, 1), list(folder.iterdir()))
        self.assertEqual(dem[0].name.split(".")[2], gas[0].name.split(".")[2])
        return dem[0], gas[0]

    def test_two_grains_in_one_place_make_a_force_that_is_no_number(self):
        for ranks in (1, 2):
            self.stops([r"the force on grain 769 at x = 0.011, y = 0.011, z = 0.09 m.* is not a number",
                        r"at step 100, t = 0.002 s\.", r"lower 'timestep'"],
                       extra=ONE_PLACE, grains=770, dem_ranks=ranks)

    def test_a_position_that_is_no_number_is_found_before_the_host_sorts_the_grains(self):
        # Between two couplings, by one of the ranks; the host sorts them anew at every step.
        words = [r"the position of grain (769|770) at x = -?nan.* is not a number at step 10[1-9],",
                 r"two grains were put into one place"]
        self.stops(words, extra=ONE_PLACE.replace("run 100", "run 101") + "\nneigh_modify every 1 check no",
                   grains=770, dem_ranks=2, gas_ranks=2)

    def test_a_grain_that_leaves_where_there_is_no_wall_is_lost_with_its_name(self):
        words = [r"grain \d+ at x = .* z = -[\d.e-]+ m, velocity .* has left the box through z_lo",
                 r"at step \d+, t = 0.0\d+ s: a lost particle\. Likely there is no wall",
                 r"'thermo_modify lost ignore'"]
        for ranks in (1, 2):
            self.stops(words, extra="unfix z_lo", steps=100000, dem_ranks=ranks)

    def test_one_rank_alone_finds_a_grain_that_flies_away(self):
        fast = "group one id 760\nrun 100\nvelocity one set 0 0 20 units box"
        _, rows = self.stops([r"grain 760 at .* z = 0.11\d* m, .* has left the box through z_hi"],
                             extra=fast, dem_ranks=2, gas_ranks=2)
        self.assertGreater(rows[-1]["step"], 100)

    def test_a_lost_grain_with_the_gas_inside_and_overlapped(self):
        for couple in (INSIDE, OVERLAPPED):
            self.stops([r"a lost particle"], couple=couple, extra="unfix z_lo", steps=100000, dem_ranks=2)

    def test_grains_that_may_leave_are_counted(self):
        with Scene(extra="unfix z_lo\nthermo_modify lost ignore norm no", steps=2000) as scene:
            status, text, _ = scene.run(dem_ranks=2)
            self.assertEqual(status, 0, text)
            rows = scene.history()
        left = sum(row["left_box"] for row in rows)
        self.assertGreater(left, 50)
        self.assertEqual(rows[0]["particles"] - rows[-1]["particles"], left)

    def test_an_overlap_of_more_than_a_radius(self):
        fast = "group one id 760\nrun 100\nvelocity one set 0 0 -60 units box"
        self.stops([r"grain \d+ at .* and grain \d+ at .* overlap by 0.00[12]\d* m, more than the radius "
                    r"of the smaller, 0.00125 m, at step 1\d\d, t = 0.00\d+ s", r"raise youngsModulus"],
                   extra=fast, dem_ranks=2)

    def test_a_bed_too_soft_for_its_weight_is_pressed_through_its_floor(self):
        def soften(scene):
            if HOST == "liggghts":
                replaced(f"in.{HOST}", "fix youngs", "soft_particles yes\nfix youngs")(scene)
            replaced(f"in.{HOST}", "peratomtype 5e6", "peratomtype 2e2")(scene)
        self.stops([r"has left the box through z_lo .*: a lost particle\.",
                    r"the grain was pressed or shot through it: then raise youngsModulus"],
                   edit=soften, jet=1.0, steps=10000)

    def test_a_jet_that_runs_away(self):
        words = [r"the Courant number of the gas has run away at t = 0 s: through an \[\[inflow\]\]",
                 r"more than \[time\] courant_max x substeps_max = 10 x 1000\.",
                 r"velocity, ramp"]
        for couple in (COUPLE, INSIDE, OVERLAPPED):
            self.stops(words, jet=1e6, couple=couple, dem_ranks=2, gas_ranks=2)

    def test_the_documented_number_of_steps_is_the_limit(self):
        # The jet crosses 1.9 cells of 5.5 mm in an interval of 0.5 ms (history.csv, courant).
        few = "courant_max = 0.1\nsubsteps_max = 15"
        self.stops([r"crosses 1\.\d+ cells in a step of 0.0005 s", r"= 0.1 x 15\."],
                   edit=replaced("gas.toml", "courant_max = 10", few))
        with Scene(steps=100) as scene:
            replaced("gas.toml", "courant_max = 10", few.replace("15", "30"))(scene)
            status, text, _ = scene.run()
        self.assertEqual(status, 0, text)

    def resumed(self, value, words, **options):
        """A run goes on from a checkpoint in which one velocity of the gas has this value."""
        with Scene(steps=200, extra="restart 100 @out@/checkpoint/dem.*.restart") as scene:
            self.assertEqual(scene.run(**options)[0], 0)
            scene.resume(100, 1000)
            checkpoint = scene.out / "checkpoint" / "gas.100.h5"
            with h5py.File(checkpoint, "r+") as file:
                file["velocity_z"][10, 2, 1] = value
            for old in (scene.out / "checkpoint").glob("*.200.*"):
                old.unlink()
            status, text, seconds = scene.run(gas_options=("--restart", str(checkpoint)), **options)
            self.assertNotEqual(status, 0, text)
            self.assertLess(seconds, SOON)
            told = messages(text)
            self.assertEqual(len(told), 1, text)
            for word in words:
                self.assertRegex(told[0], word)
            dem, gas = self.autopsy(scene)
            self.assertEqual(dem.name, "autopsy.dem.125.restart")
            self.assertEqual(grains_of(scene.folder, dem), 768)
            with h5py.File(gas) as file:
                self.assertEqual(file["velocity_z"].ndim, 3)

    def test_gas_that_is_too_fast_somewhere_names_the_cell(self):
        self.resumed(1e7, [r"run away at t = .*: in cell \(1, 2, 10\) at x = .* along z with 1e\+07 m/s",
                           r"\[time\] courant_max x substeps_max"], gas_ranks=2)

    def test_gas_that_is_no_number_names_the_cell_and_the_time(self):
        self.resumed(float("nan"), [r"gas velocity or pressure in cell \(\d, \d, \d+\) at x = .* is not "
                                    r"finite at t = .* s", r"lower \[time\] step"], dem_ranks=2, gas_ranks=2)

    def test_gas_alone_that_runs_away(self):
        for ranks in (1, 2):
            with Scene(jet=1e6) as scene:
                replaced("gas.toml", "courant_max = 10", "courant_max = 10\nend = 0.1")(scene)
                command = scene.command(gas_ranks=ranks)
                scene.command = lambda c=command, **_: c[:c.index("-np")] + c[c.index(":") + 1:]
                status, text, seconds = scene.run()
                self.assertNotEqual(status, 0, text)
                self.assertLess(seconds, SOON)
                told = messages(text)
                self.assertEqual(len(told), 1, text)
                self.assertRegex(told[0], r"Courant number of the gas has run away at t = 0 s")
                file = scene.out / "gas.autopsy.h5"
                self.assertIn(f"For an autopsy, its state is in {file}", told[0])
                with h5py.File(file) as state:
                    self.assertEqual(state["velocity_z"].ndim, 3)

    def test_an_autopsy_that_cannot_be_written_does_not_hide_the_fault(self):
        for name, word in (("autopsy.gas.100.h5.new", r"that of the gas could not be written: .*directory"),
                           ("autopsy.dem.100.restart", r"No autopsy of it: Cannot open restart file")):
            with Scene(extra=ONE_PLACE) as scene:
                (scene.out / "checkpoint" / name).mkdir(parents=True)
                status, text, seconds = scene.run(timeout=60, dem_ranks=2)
            self.assertNotEqual(status, 0, text)
            self.assertLess(seconds, SOON)
            told = messages(text)
            self.assertEqual(len(told), 1, text)
            self.assertRegex(told[0], r"the force on grain 769 at .* is not a number")
            self.assertRegex(told[0], word)

    def test_an_autopsy_is_no_checkpoint_to_go_on_from(self):
        with tempfile.TemporaryDirectory() as out:
            folder = Path(out) / "checkpoint"
            folder.mkdir()
            for name in ("autopsy.dem.100.restart", "autopsy.gas.100.h5"):
                (folder / name).touch()
            done = subprocess.run([BIN / "gasgrain", "run", SOURCE / "inputs" / "spouted_bed_small",
                                   "--restart", "--out", out], text=True, capture_output=True,
                                  timeout=60, check=False)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("checkpoint", done.stdout + done.stderr)


class DemStep(unittest.TestCase):
    def told(self, edits=(), steps=10, **marks):
        """(status, what couple/gas and our errors said of the step)"""
        with Scene(steps=steps, **marks) as scene:
            for edit in edits:
                edit(scene)
            status, text, _ = scene.run()
        return status, "\n".join(messages(text) + [
            line for line in text.splitlines() if re.match("couple/gas: warning: .*'timestep", line)])

    def refused(self, words, *edits, **marks):
        status, text = self.told(edits, **marks)
        self.assertNotEqual(status, 0, text)
        for word in words:
            self.assertRegex(text, word)
        return text

    def test_a_step_too_long_is_refused_before_the_run_and_the_one_named_will_do(self):
        text = self.refused([r"'timestep 0.0002' is too long for the contacts: two grains of type 1 \(the "
                             r"smallest, 0.0025 m across\) touch for 0.00032\d s \(hertz, youngsModulus "
                             r"5e\+06 Pa, 1.5 m/s\); that is 1.6 steps"],
                            replaced(f"in.{HOST}", "timestep 2e-5", "timestep 2e-4"))
        advised = re.search(r"Write '(timestep [\d.e-]+)'", text)[1]
        status, text = self.told([replaced(f"in.{HOST}", "timestep 2e-5", advised)])
        self.assertEqual((status, text), (0, ""))

    def test_a_step_between_is_warned_of_once_and_runs(self):
        status, text = self.told([replaced(f"in.{HOST}", "timestep 2e-5", "timestep 5e-5")],
                                 extra="run 20")
        self.assertEqual(status, 0)
        self.assertRegex(text, r"'timestep 5e-05' is long for the contacts: .* that is 6.5 steps")
        self.assertEqual(text.count("is long"), 1)

    def test_the_other_normal_models(self):
        slow = replaced(f"in.{HOST}", "timestep 2e-5", "timestep 1e-3")
        pair = "pair_style gran/bridge model hertz tangential history"
        speed = "fix speed all property/global characteristicVelocity scalar 2.0\n"
        kn = "\n".join(f"fix {n} all property/global {n} peratomtypepair 1 {v}" for n, v in
                       (("kn", 1000), ("kt", 300), ("gamman_abs", 0.01), ("gammat_abs", 0.01))) + "\n"
        self.refused([r"\(hooke, youngsModulus 5e\+06 Pa, characteristicVelocity 2 m/s\)"], slow,
                     replaced(f"in.{HOST}", pair, speed + pair.replace("hertz", "hooke")))
        # pi sqrt(m / 2 / k), m of 2.5 mm glass
        self.refused([r"touch for 0.000318 s \(hooke/stiffness, kn 1000\)"], slow,
                     replaced(f"in.{HOST}", pair,
                              kn + pair.replace("hertz", "hooke/stiffness") + " absolute_damping on"))

    def test_a_harder_wall_counts(self):
        wall = ("create_box 1 box", "create_box 2 box")
        two = [replaced(f"in.{HOST}", *wall),
               replaced(f"in.{HOST}", "youngsModulus peratomtype 5e6", "youngsModulus peratomtype 5e6 5e8"),
               replaced(f"in.{HOST}", "poissonsRatio peratomtype 0.17", "poissonsRatio peratomtype 0.17 0.3"),
               replaced(f"in.{HOST}", "peratomtypepair 1 0.9", "peratomtypepair 2 0.9 0.9 0.9 0.9"),
               replaced(f"in.{HOST}", "peratomtypepair 1 0.1", "peratomtypepair 2 0.1 0.1 0.1 0.1"),
               replaced(f"in.{HOST}", "primitive type 1 zplane", "primitive type 2 zplane"),
               replaced(f"in.{HOST}", "timestep 2e-5", "timestep 2e-4")]
        self.refused([r"a grain of type 1 \(.*\) and a wall of type 2 touch for 0.00028\d s"], *two)

    def test_a_bed_that_nothing_moves_and_a_grain_alone_may_take_any_step(self):
        slow = replaced(f"in.{HOST}", "timestep 2e-5", "timestep 2e-4")
        frozen = replaced(f"in.{HOST}", "fix motion all nve/sphere\n", "")
        self.assertEqual(self.told([slow, frozen]), (0, ""))

        def alone(scene):
            script = scene.script
            text = script.read_text().replace("create_atoms 1 region bed",
                                              "create_atoms 1 single 0.011 0.011 0.08 units box")
            script.write_text("".join(line for line in text.splitlines(keepends=True)
                                      if "wall/gran" not in line))
        self.assertEqual(self.told([slow, alone]), (0, ""))

    @unittest.skipIf(HOST == "lammps", "LAMMPS inserts grains by other commands")
    def test_grains_that_come_later_are_looked_at_when_they_come(self):
        # No grain at the beginning of the run.
        pour = """\
fix sphere all particletemplate/sphere 15485863 atom_type 1 density constant 2500 radius constant 0.00125
fix sizes all particledistribution/discrete 15485867 1 sphere 1.0
region above block 0.001 0.021 0.001 0.021 0.05 0.10 units box
fix rain all insert/pack seed 32452843 distributiontemplate sizes maxattempt 100 insert_every 10 &
    overlapcheck yes all_in yes vel constant 0. 0. -0.5 region above particles_in_region 20"""
        self.refused([r"'timestep 0.0002' is too long"],
                     replaced(f"in.{HOST}", "create_atoms 1 region bed\nset group all diameter 0.0025 density 2500", ""),
                     replaced(f"in.{HOST}", "timestep 2e-5", "timestep 2e-4"), extra=pour, steps=100)

    def test_a_contact_model_that_cannot_be_read_is_said_and_not_refused(self):
        pair = "pair_style gran/bridge model hertz tangential history"
        hysteresis = "".join(f"fix {n} all property/global {n} peratomtypepair 1 {v}\n" for n, v in
                             (("coefficientMaxElasticStiffness", 2.0), ("coefficientAdhesionStiffness", 0.1),
                              ("coefficientPlasticityDepth", 0.05)))
        speed = "fix speed all property/global characteristicVelocity scalar 2.0\n"
        unread = hysteresis + speed + "pair_style gran model hooke/hysteresis tangential history"
        if HOST == "lammps":
            unread = "pair_style gran/hertz/history 5e6 NULL 50 NULL 0.1 1"
        status, text = self.told([replaced(f"in.{HOST}", pair, unread)], extra="run 20")
        self.assertEqual((status, text.count("nobody checks that 'timestep 2e-05'")), (0, 1), text)


if __name__ == "__main__":
    unittest.main(verbosity=2)
