#!/usr/bin/python3
"""`gasgrain run` seen from outside: shell scripts play the two programs under the real mpirun."""

import json
import os
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

GASGRAIN = Path(sys.argv.pop(1) if len(sys.argv) > 1 else "build/gasgrain").resolve()

# Both scripts note their arguments; what they then do is chosen by DEM_PART and GAS_PART.
DEM = r"""#!/bin/bash
echo "$@" > "$NOTES/dem.arguments"
while [ $# -gt 0 ]; do [ "$1 $2" = "-var out" ] && out=$3; shift; done
if [ "$OMPI_COMM_WORLD_RANK" = 0 ]; then
  echo '{"first_step": 0, "last_step": 300, "start_step": 100, "dt_s": 0.01, "time_end_s": 2}' > "$out/run.json"
  echo 'step,time_s,bed_height_m,max_overlap,courant,ledger_residual' > "$out/history.csv"
  for row in 0,-1,0.1,0.01,0,0 150,0.5,0.25,0.02,0.3,1e-15 300,2,0.125,0.004,0.4,2e-15; do
    echo $row >> "$out/history.csv"
  done
fi
case $DEM_PART in
  fail) printf '\ngasgrain-liggghts: error: in.liggghts:3: "fix x": it is wrong.\n  Put it right.\n\n'; exit 3;;
  host_error) echo 'ERROR: Unknown pair style (force.cpp:1)'; sleep 0.3; exit 4;;
  silent) for n in 1 2 3 4 5 6 7; do echo "word $n"; done; sleep 0.3; exit 5;;
  wait)
    trap 'touch "$out/checkpoint/dem.200.restart"; exit 0' USR1
    touch "$NOTES/dem.waits.$OMPI_COMM_WORLD_RANK"
    while true; do sleep 0.1; done;;
  deaf) trap '' USR1; touch "$NOTES/dem.waits.$OMPI_COMM_WORLD_RANK"; while true; do sleep 0.1; done;;
esac
echo '{"dem": {"ranks": 2, "tasks": {"contacts": {"mean_s": 3.0, "max_s": 4.0}}},
  "gas": {"ranks": 1, "tasks": {"pressure": {"mean_s": 1.0, "max_s": 1.0}}}}' > "$out/ledger.json"
"""

GAS = r"""#!/bin/bash
RULE=$(printf '%.0s-' {1..74})
if [ "$1" = --check ]; then
  case $GAS_PART in
    faulty)
      printf '\ngasgrain-gas: error: gas.toml:2: drag = "gidaspw" is unknown. Did you mean "gidaspow"?\n'
      printf 'gas.toml:5: the key gird is unknown.\n\n%s\nMPI_ABORT was invoked\n%s\n' $RULE $RULE
      exit 1;;
    stuck) sleep 60;;
  esac
  exit 0
fi
echo "$@" > "$NOTES/gas.arguments"
while [ $# -gt 0 ]; do [ "$1" = --out ] && out=$2; shift; done
case $GAS_PART in
  killed) sleep 0.3; kill -9 $$;;
  wait)
    trap 'touch "$out/checkpoint/gas.200.h5"; exit 0' USR1
    touch "$NOTES/gas.waits"
    while true; do sleep 0.1; done;;
esac
[ "$DEM_PART" = ok ] || sleep 30
"""


class RunCommand(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.top = Path(self.folder.name)
        self.results = self.top / "results/spouted_bed"
        self.write("bin/gasgrain-liggghts", DEM).chmod(0o755)
        self.write("bin/gasgrain-gas", GAS).chmod(0o755)
        self.write("inputs/spouted_bed/in.liggghts", "variable seed index 1\nvariable slope index 1\n"
                   "fix gas all couple/gas &\n  every 10\n")
        self.write("inputs/spouted_bed/gas.toml", "")

    def tearDown(self):
        self.folder.cleanup()

    def write(self, name, text):
        file = self.top / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
        return file

    def start(self, *arguments, dem="ok", gas="ok"):
        environment = dict(os.environ, GASGRAIN_BIN_DIR=str(self.top / "bin"), NOTES=str(self.top),
                           DEM_PART=dem, GAS_PART=gas)
        return subprocess.Popen([GASGRAIN, "run", *arguments], cwd=self.top, env=environment,
                                text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                start_new_session=True)

    def run_tool(self, *arguments, **parts):
        process = self.start(*arguments, **parts)
        out, err = process.communicate(timeout=60)
        return process.returncode, out, err

    def wait_for(self, *names):
        end = time.time() + 30
        while not all((self.top / name).exists() for name in names):
            self.assertLess(time.time(), end, f"{names} did not appear")
            time.sleep(0.05)

    def assert_no_process_is_left(self):
        end = time.time() + 10
        while True:
            left = []
            for entry in Path("/proc").glob("[0-9]*"):
                try:
                    if str(self.top / "bin").encode() in (entry / "cmdline").read_bytes():
                        left.append(entry.name)
                except OSError:  # it ended meanwhile
                    pass
            if not left:
                return
            self.assertLess(time.time(), end, f"processes {left} are left")
            time.sleep(0.1)

    def test_an_absent_scene_is_answered_with_the_nearest_name(self):
        status, _, err = self.run_tool("inputs/spouted_bde")
        self.assertEqual(status, 1)
        self.assertIn('Did you mean "inputs/spouted_bed"?', err)

    def test_a_bare_scene_name_is_looked_for_in_inputs(self):
        _, _, err = self.run_tool("spouted_bed")
        self.assertIn('Did you mean "inputs/spouted_bed"?', err)

    def test_all_faults_are_reported_at_once(self):
        self.write("inputs/spouted_bed/in.liggghts", "# fix gas all couple/gas\n")
        (self.top / "bin/gasgrain-liggghts").unlink()
        status, _, err = self.run_tool("inputs/spouted_bed", "--restart", "--var", "out", "x",
                                       gas="faulty")
        self.assertEqual(status, 1)
        self.assertIn("inputs/spouted_bed/in.liggghts: no line couples", err)
        self.assertIn("fix gas all couple/gas", err)
        self.assertIn("gasgrain-liggghts is not in", err)
        self.assertIn('gas.toml:2: drag = "gidaspw" is unknown', err)
        self.assertIn("gas.toml:5: the key gird is unknown", err)
        self.assertNotIn("MPI_ABORT", err)
        self.assertIn("holds no complete checkpoint", err)
        self.assertIn("--var out", err)
        self.assertFalse(self.results.exists(), "a refused run must leave no trace")

    def test_a_misspelt_fix_is_answered_with_the_right_one(self):
        self.write("inputs/spouted_bed/in.liggghts", "\nfix gas all couple/gaz every 10\n")
        _, _, err = self.run_tool("inputs/spouted_bed")
        self.assertIn('in.liggghts:2: fix style "couple/gaz" is unknown. Did you mean "couple/gas"?',
                      err)

    def test_the_fix_may_stand_in_an_included_file(self):
        self.write("inputs/spouted_bed/in.liggghts", "include in.gas\n")
        self.write("inputs/spouted_bed/in.gas", "fix gas all couple/gas every 10\n")
        status, _, err = self.run_tool("inputs/spouted_bed", "--no-plots")
        self.assertEqual(status, 0, err)

    def test_a_check_that_hangs_is_given_up(self):
        status, _, err = self.run_tool("inputs/spouted_bed", gas="stuck")
        self.assertEqual(status, 1)
        self.assertIn("its check did not end within 10 s", err)
        self.assert_no_process_is_left()

    def test_a_run_hands_the_options_on_and_sums_up(self):
        status, out, err = self.run_tool("inputs/spouted_bed/", "--time", "2", "--no-plots", "--var",
                                         "seed", "7", "--var", "slope", "-3", "--dem-ranks", "3")
        self.assertEqual(status, 0, err)
        self.assertEqual((self.top / "dem.arguments").read_text().strip(),
                         f"-in in.liggghts -log none -var out {self.results} -var time 2 "
                         "-var restart 0 -var seed 7 -var slope -3")
        self.assertEqual((self.top / "gas.arguments").read_text().strip(),
                         f"gas.toml --out {self.results}")
        self.assertIn("-np 3", out)
        self.assertIn("at most 0.2500 m, at 0.5 s", out)
        self.assertIn("2 % of a diameter", out)
        self.assertIn(str(self.results / "history.csv"), out)

    def test_the_ledger_gets_the_wall_time_and_is_shown(self):
        _, out, _ = self.run_tool("inputs/spouted_bed", "--no-plots")
        ledger = json.loads((self.results / "ledger.json").read_text())
        self.assertEqual(ledger["dem"]["tasks"]["contacts"]["max_s"], 4.0)
        self.assertEqual(ledger["gas"]["ranks"], 1)
        self.assertGreater(ledger["wall_s"], 0.0)
        self.assertIn("contacts", out)
        self.assertIn("pressure", out)

    def test_files_of_an_earlier_run_are_cleared_and_others_kept(self):
        for name in ("run.log", "gas.h5", "bed.png", "particles/p_1.vtk", "checkpoint/dem.1.restart",
                     "notes.txt"):
            self.write(f"results/spouted_bed/{name}", "old")
        self.run_tool("inputs/spouted_bed", "--no-plots")
        self.assertFalse((self.results / "gas.h5").exists())
        self.assertFalse((self.results / "bed.png").exists())
        self.assertFalse((self.results / "particles/p_1.vtk").exists())
        self.assertFalse((self.results / "checkpoint/dem.1.restart").exists())
        self.assertTrue((self.results / "notes.txt").exists())

    def test_a_folder_that_holds_no_run_is_not_cleared(self):
        self.write("pictures/holiday.png", "mine")
        status, _, _ = self.run_tool("inputs/spouted_bed", "--no-plots", "--out", "pictures")
        self.assertEqual(status, 0)
        self.assertTrue((self.top / "pictures/holiday.png").exists())

    def test_plots_that_fail_are_a_warning(self):
        self.write("bin/gasgrain-liggghts", "#!/bin/sh\n").chmod(0o755)
        status, _, err = self.run_tool("inputs/spouted_bed")
        self.assertEqual(status, 0)
        self.assertIn("warning: not all plots could be made", err)
        self.assertIn("history.csv", err)

    def test_an_error_of_one_side_is_passed_on_in_its_own_words(self):
        status, _, err = self.run_tool("inputs/spouted_bed", dem="fail")
        self.assertEqual(status, 3)
        self.assertEqual(err.count('in.liggghts:3: "fix x": it is wrong.'), 1, err)
        self.assertIn("Put it right.", err)
        self.assertIn(str(self.results / "run.log"), err)
        self.assertNotIn("Primary job", err)
        self.assert_no_process_is_left()

    def test_an_error_of_the_host_is_passed_on(self):
        status, _, err = self.run_tool("inputs/spouted_bed", dem="host_error")
        self.assertEqual(status, 4)
        self.assertIn("ERROR: Unknown pair style", err)

    def test_a_silent_failure_shows_the_last_lines_without_those_of_mpi(self):
        status, _, err = self.run_tool("inputs/spouted_bed", "--dem-ranks", "1", dem="silent")
        self.assertEqual(status, 5)
        for n in (3, 4, 5, 6, 7):
            self.assertIn(f"word {n}", err)
        self.assertNotIn("word 2", err)
        self.assertNotIn("mpirun", err)

    def test_a_killed_rank_is_named_with_its_program(self):
        status, _, err = self.run_tool("inputs/spouted_bed", dem="wait", gas="killed")
        self.assertNotEqual(status, 0)
        self.assertIn("gasgrain-gas (its rank 0) was ended by signal 9 (Killed).", err)
        self.assert_no_process_is_left()

    def test_restart_takes_the_newest_step_that_both_sides_have(self):
        for name in ("dem.90.restart", "gas.90.h5", "dem.200.restart", "gas.200.h5",
                     "dem.1000.restart", "gas.1100.h5", "dem.latest.restart"):
            self.write(f"results/spouted_bed/checkpoint/{name}", "")
        self.write("results/spouted_bed/run.log", "old")
        self.write("results/spouted_bed/gas.h5", "old")
        status, _, err = self.run_tool("inputs/spouted_bed", "--restart", "--no-plots")
        self.assertEqual(status, 0, err)
        self.assertIn("-var restart 200", (self.top / "dem.arguments").read_text())
        self.assertIn(f"--restart {self.results}/checkpoint/gas.200.h5",
                      (self.top / "gas.arguments").read_text())
        self.assertTrue((self.results / "gas.h5").exists())

    def stop_a_waiting_run(self, number, dem="wait"):
        process = self.start("inputs/spouted_bed", "--gas-ranks", "1", dem=dem, gas="wait")
        self.wait_for("dem.waits.0", "dem.waits.1", "gas.waits")
        process.send_signal(number)
        return process

    def test_ctrl_c_writes_a_checkpoint_and_says_how_to_go_on(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            with self.subTest(number):
                for waits in self.top.glob("*.waits*"):
                    waits.unlink()
                process = self.stop_a_waiting_run(number)
                out, err = process.communicate(timeout=30)
                self.assertEqual(process.returncode, 130, out + err)
                self.assertIn("stopping: writing a checkpoint", out)
                self.assertIn("checkpoint at step 200", out)
                self.assertIn("gasgrain run inputs/spouted_bed --restart", out)
                self.assert_no_process_is_left()

    def test_a_second_ctrl_c_ends_the_run_at_once(self):
        process = self.stop_a_waiting_run(signal.SIGINT, dem="deaf")
        time.sleep(0.5)
        self.assertIsNone(process.poll())
        process.send_signal(signal.SIGINT)
        out, _ = process.communicate(timeout=30)
        self.assertEqual(process.returncode, 130)
        self.assertIn("ending the run", out)
        self.assert_no_process_is_left()

    def test_nothing_is_left_when_the_command_itself_is_killed(self):
        process = self.stop_a_waiting_run(signal.SIGKILL)
        process.communicate(timeout=30)
        self.assert_no_process_is_left()

    def test_two_runs_do_not_share_a_folder(self):
        first = self.start("inputs/spouted_bed", dem="wait", gas="wait")
        self.wait_for("dem.waits.0", "dem.waits.1", "gas.waits")
        status, _, err = self.run_tool("inputs/spouted_bed")
        self.assertEqual(status, 1)
        self.assertIn("another run is writing to", err)
        first.send_signal(signal.SIGINT)
        first.communicate(timeout=30)

    def test_progress_is_plain_lines_where_there_is_no_terminal(self):
        process = self.start("inputs/spouted_bed", dem="wait", gas="wait")
        self.wait_for("dem.waits.0")
        time.sleep(6.0)
        process.send_signal(signal.SIGINT)
        out, _ = process.communicate(timeout=30)
        self.assertRegex(out, r"2\.000 of 2\.000 s  wall 0:00:\d\d")
        self.assertIn("bed 0.1250 m  overlap 0.4 %  Courant 0.40", out)
        self.assertNotIn("\r", out)


if __name__ == "__main__":
    unittest.main()
