#!/usr/bin/python3
"""gasgrain.so in a stock lmp: its ways in, its launch beside the gas, and that every end ends both."""

import os
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

BIN = Path(sys.argv.pop(1) if len(sys.argv) > 1 else "build").resolve()
SOURCE = Path(__file__).resolve().parents[2]
LOAD = f"include {BIN}/gasgrain.lmp\n"
# 48 spheres that stand still in a stream.
SCENE = """\
units si
atom_style sphere
atom_modify map array
boundary f f f
newton off
comm_modify vel yes
region box block 0 0.01 0 0.01 0 0.04
create_box 1 box
lattice sc 0.0025 origin 0.5 0.5 0.5
region bed block 0 0.01 0 0.01 0 0.0075 units box
create_atoms 1 region bed
set group all diameter 0.0025 density 2500
neighbor 0.0005 bin
pair_style gran/hertz/history 1e6 NULL 0 NULL 0.3 0
pair_coeff * *
timestep 1e-4
"""
COUPLE = "fix gas all couple/gas every 10 output out drag koch_hill pressure_gradient\n"
GAS = """\
[grid]
lo = [0.0, 0.0, 0.0]
hi = [0.01, 0.01, 0.04]
cells = [2, 2, 8]
[time]
step = 1e-3
[boundary]
z_hi = "outlet"
[[inflow]]
side = "z_lo"
shape = "rectangle"
center = [0.005, 0.005]
size = [0.01, 0.01]
velocity = 0.5
ramp = 0.002
"""
# A host of another version: lmp's library, whose question for the version the program answers.
OTHER_VERSION = """\
#include <dlfcn.h>
#include <stdio.h>
int lammps_version(void* host) { (void)host; return 20230802; }
void* lammps_open_no_mpi(int argc, char** argv, void** host);
int main(int argc, char** argv) {
  char* words[] = {"other", "-screen", "none", "-log", "none"};
  (void)argc;
  void* host = lammps_open_no_mpi(5, words, 0);
  void* plugin = dlopen(argv[1], RTLD_NOW | RTLD_GLOBAL);
  if (!plugin) { fprintf(stderr, "%s\\n", dlerror()); return 7; }
  ((void (*)(void*))dlsym(plugin, "gasgrain_load"))(host);
  return 0;
}
"""

# What the PLUGIN package does: hands the plugin a function that takes one style after the other.
REGISTER = """\
#include <dlfcn.h>
#include <stdio.h>
typedef struct { const char *version, *style, *name, *info, *author; void *creator, *handle; } plugin_t;
void* lammps_open_no_mpi(int argc, char** argv, void** host);
static void* the_host;
static void take(plugin_t* p, void* host) {
  printf("%s %s %s %d\\n", p->style, p->name, p->version, host == the_host && p->creator && p->handle);
}
int main(int argc, char** argv) {
  char* words[] = {"other", "-screen", "none", "-log", "none"};
  (void)argc;
  the_host = lammps_open_no_mpi(5, words, 0);
  void* plugin = dlopen(argv[1], RTLD_NOW | RTLD_GLOBAL);
  if (!plugin) { fprintf(stderr, "%s\\n", dlerror()); return 7; }
  ((void (*)(void*, void*, void*))dlsym(plugin, "lammpsplugin_init"))(the_host, plugin, take);
  return 0;
}
"""


class Launch(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory(prefix="gasgrain-lammps-")
        self.folder = Path(self.temporary.name)
        (self.folder / "gas.toml").write_text(GAS)

    def tearDown(self):
        self.temporary.cleanup()

    def start(self, command, **environment):
        env = dict(os.environ, OMPI_MCA_mpi_yield_when_idle="1", OMP_NUM_THREADS="1",
                   OMPI_MCA_btl_vader_single_copy_mechanism="none", **environment)
        return subprocess.Popen(command, cwd=self.folder, env=env, text=True, stdin=subprocess.DEVNULL,
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, start_new_session=True)

    def finish(self, process, timeout=60):
        try:
            text, _ = process.communicate(timeout=timeout)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            text, _ = process.communicate()
            raise AssertionError(f"the launch hung:\n{text}") from None
        return process.returncode, text

    def lmp(self, script, **environment):
        (self.folder / "in.lammps").write_text(script)
        return self.finish(self.start(["lmp", "-in", "in.lammps", "-log", "none"], **environment))

    def both(self, script, dem_ranks=1, split=("-m", "0"), gas_first=False, gas=None):
        (self.folder / "in.lammps").write_text(script)
        dem = ["-np", str(dem_ranks), "lmp", *split, "-in", "in.lammps", "-log", "none"]
        partner = ["-np", "1", str(gas or BIN / "gasgrain-gas"), "gas.toml", "--out", "out"]
        words = [*partner, ":", *dem] if gas_first else [*dem, ":", *partner]
        return self.start(["mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none", *words])

    def fails(self, process, *told):
        begin = time.monotonic()
        status, text = self.finish(process)
        self.assertNotEqual(status, 0, text)
        for words in told:
            self.assertIn(words, text)
        self.assertLess(time.monotonic() - begin, 30)
        return text

    def test_an_included_file_loads_it(self):
        status, text = self.lmp(LOAD + SCENE + "dump a all custom/vtk 1 p_*.vtk id x y z radius\nrun 0\n")
        self.assertEqual(status, 0, text)
        self.assertTrue((self.folder / "p_0.vtk").is_file())

    def test_a_preloaded_library_serves_and_survives_clear(self):
        script = SCENE + "clear\n" + SCENE + "dump a all custom/vtk 1 p_*.vtk id x y z radius\nrun 0\n"
        (self.folder / "in.lammps").write_text(script)
        # Not for MPI's own programs, which have no LAMMPS in them.
        status, text = self.finish(self.start(
            ["mpirun", "--allow-run-as-root", "-np", "1", "-x", f"LD_PRELOAD={BIN}/gasgrain.so",
             "lmp", "-in", "in.lammps", "-log", "none"]))
        self.assertEqual(status, 0, text)
        self.assertTrue((self.folder / "p_0.vtk").is_file())

    def test_an_included_file_loads_it_again_after_clear(self):
        status, text = self.lmp(LOAD + SCENE + "clear\n" + LOAD + SCENE +
                                "dump a all custom/vtk 1 p_*.vtk id x y z radius\nrun 0\n")
        self.assertEqual(status, 0, text)

    def program(self, source):
        """A program of LAMMPS's library, started with the plugin."""
        (self.folder / "other.c").write_text(source)
        subprocess.run(["mpicc", "-rdynamic", "other.c", "-o", "other", "-l:liblammps.so.0", "-ldl"],
                       cwd=self.folder, check=True)
        return self.start([str(self.folder / "other"), str(BIN / "gasgrain.so")])

    def test_the_plugin_package_is_offered_every_style(self):
        status, text = self.finish(self.program(REGISTER))
        self.assertEqual(status, 0, text)
        for style in ("pair gran/bridge", "fix couple/gas", "fix wall/gran/bridge", "fix liquid", "fix parcels",
                      "fix parcels/inject", "fix exchange/bgk", "fix property/global", "compute pair/gran/local"):
            self.assertIn(f"{style} 29 Sep 2021 1\n", text)

    def test_another_version_is_refused_with_the_one_it_needs(self):
        text = self.fails(self.program(OTHER_VERSION))
        self.assertIn("needs LAMMPS 29 Sep 2021", text)
        self.assertIn("version 20230802", text)

    def test_it_runs_beside_the_gas_in_either_order(self):
        for dem_ranks, gas_first in ((1, False), (2, True)):
            process = self.both(LOAD + SCENE + COUPLE + "run 100\n", dem_ranks, gas_first=gas_first)
            status, text = self.finish(process)
            self.assertEqual(status, 0, text)
            self.assertIn("Total wall time", text)
            self.assertIn("residual", text)

    def test_an_error_of_the_host_ends_both(self):
        self.fails(self.both(LOAD + SCENE + COUPLE + "run 20\nfix wrong\nrun 20\n", 2),
                   "Illegal fix command", "Last command: fix wrong")

    def test_an_error_of_ours_ends_both_and_names_the_line(self):
        self.fails(self.both(LOAD + SCENE + COUPLE.replace("koch_hill", "koch_hil") + "run 20\n", 2),
                   "gasgrain-lammps: error: in.lammps:18:", 'Did you mean "koch_hill"?')

    def test_a_script_without_the_coupling_ends_both(self):
        self.fails(self.both(LOAD + SCENE + "run 20\n", 2), "ended without meeting its partner")

    def test_a_launch_without_the_split_is_refused(self):
        self.fails(self.both(LOAD + SCENE + COUPLE + "run 20\n", 2, split=()), "'-m 0'")

    def test_a_wrong_input_of_the_gas_ends_both(self):
        (self.folder / "gas.toml").write_text(GAS.replace("velocity", "velocty"))
        self.fails(self.both(LOAD + SCENE + COUPLE + "run 20\n", 2), "gas.toml:14", 'Did you mean "velocity"?')

    def test_a_killed_side_ends_the_other(self):
        for program in ("lmp", "gasgrain-gas"):
            process = self.both(LOAD + SCENE + COUPLE + "run 1000000\n")
            victims = []
            while not victims and process.poll() is None:
                time.sleep(0.2)
                victims = [int(entry.name) for entry in Path("/proc").glob("[0-9]*")
                           if started_as(entry, program, self.folder)]
            history = self.folder / "out/history.csv"
            end = time.monotonic() + 30
            while time.monotonic() < end and not history.exists():
                time.sleep(0.05)
            os.kill(victims[0], signal.SIGKILL)
            self.fails(process)

    def test_headers_that_cannot_be_had_are_told(self):
        # A closed port stands for a machine without network.
        closed = "http://127.0.0.1:9"
        done = subprocess.run([SOURCE / "fix_cfd_coupling/lammps/fetch_headers", self.folder / "headers"],
                              env=dict(os.environ, http_proxy=closed, https_proxy=closed),
                              capture_output=True, text=True, timeout=120, check=False)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("the source package lammps", done.stderr)
        self.assertFalse((self.folder / "headers").exists())


def started_as(entry, program, folder):
    try:
        words = (entry / "cmdline").read_bytes().split(b"\0")
        return words[0].endswith(program.encode()) and os.readlink(entry / "cwd") == str(folder)
    except OSError:
        return False


if __name__ == "__main__":
    unittest.main(verbosity=2)
