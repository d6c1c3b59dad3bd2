"""A small coupled scene for tests, and its launch with the real programs under mpirun.

Its script is in LIGGGHTS's words; `lammps` after the folder of the build runs it in LAMMPS.
"""

import csv
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from host_words import HOST, command_of, in_words_of
from jet_gas import GAS

BIN = Path(sys.argv.pop(1) if len(sys.argv) > 1 else "build").resolve()
SOURCE = Path(__file__).resolve().parents[2]

# 8 x 8 x 12 spheres of 2.5 mm on a lattice, slightly pulled apart, over a central jet: they fall
# together, then spout. The marks @...@ are what tests replace.
SCRIPT = """\
atom_style granular
atom_modify map array
units si
boundary @boundary@
newton off
communicate single vel yes
@processors@
region box block 0 0.022 0 0.022 0 @top@ units box
create_box 1 box
region bed block 0 0.022 0 0.022 0 0.033 units box
lattice sc 0.00275 origin 0.5 0.5 0.5
create_atoms 1 region bed
set group all diameter 0.0025 density 2500
neighbor 0.0005 bin
neigh_modify delay 0
timestep 2e-5
fix youngs all property/global youngsModulus peratomtype 5e6
fix poisson all property/global poissonsRatio peratomtype 0.17
fix restitution all property/global coefficientRestitution peratomtypepair 1 0.9
fix friction all property/global coefficientFriction peratomtypepair 1 0.1
pair_style gran/bridge model hertz tangential history
pair_coeff * *
fix x_lo all wall/gran model hertz tangential history primitive type 1 xplane 0.0
fix x_hi all wall/gran model hertz tangential history primitive type 1 xplane 0.022
fix y_lo all wall/gran model hertz tangential history primitive type 1 yplane 0.0
fix y_hi all wall/gran model hertz tangential history primitive type 1 yplane 0.022
fix z_lo all wall/gran model hertz tangential history primitive type 1 zplane 0.0
fix weight all gravity 9.81 vector 0 0 -1
fix motion all nve/sphere
@couple@
thermo 500
thermo_modify lost error norm no
@extra@
run @steps@
"""
COUPLE = "fix gas all couple/gas every 25 output @out@ void_fraction trilinear drag koch_hill pressure_gradient"

def filled(text, marks):
    for mark, value in marks.items():
        text = text.replace(f"@{mark}@", str(value))
    return text


class Scene:
    """A folder with in.liggghts and gas.toml, removed at the end of a test."""

    def __init__(self, **marks):
        self.folder = Path(tempfile.mkdtemp(prefix="gasgrain-test-"))
        self.out = self.folder / "out"
        self.out.mkdir()
        values = {"boundary": "f f f", "top": "0.11", "couple": COUPLE, "extra": "", "steps": 1000,
                  "processors": "", "jet": 45.0, **marks}
        values["out"] = self.out
        self.script = self.folder / f"in.{HOST}"
        self.script.write_text(in_words_of(HOST, filled(filled(SCRIPT, values), values), BIN))
        (self.folder / "gas.toml").write_text(filled(GAS, values))

    def __enter__(self):
        return self

    def __exit__(self, *_):
        shutil.rmtree(self.folder, ignore_errors=True)

    def resume(self, step, last):
        """The script goes on from its checkpoint of `step`, up to step `last`."""
        script = self.script
        text = re.sub(r"region box.*?set group all[^\n]*\n",
                      f"read_restart {self.out}/checkpoint/dem.{step}.restart\n",
                      script.read_text(), flags=re.S)
        script.write_text(re.sub(r"run \d+", f"run {last} upto", text))

    def command(self, dem_ranks=1, gas_ranks=1, gas_first=False, dem_options=(), gas_options=()):
        dem = ["-np", str(dem_ranks), *command_of(HOST, BIN, beside_gas=True), "-in", self.script.name,
               *dem_options]
        gas = ["-np", str(gas_ranks), str(BIN / "gasgrain-gas"), "gas.toml", "--out", str(self.out),
               *gas_options]
        both = [*gas, ":", *dem] if gas_first else [*dem, ":", *gas]
        return ["mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none", *both]

    def start(self, **options):
        environment = dict(os.environ, OMPI_MCA_mpi_yield_when_idle="1",
                           OMPI_MCA_btl_vader_single_copy_mechanism="none", OMP_NUM_THREADS="1")
        return subprocess.Popen(self.command(**options), cwd=self.folder, env=environment, text=True,
                                stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                stderr=subprocess.STDOUT, start_new_session=True)

    def run(self, timeout=120, **options):
        """(exit status, everything printed, seconds); a launch that hangs is killed and fails."""
        begin = time.monotonic()
        process = self.start(**options)
        try:
            text, _ = process.communicate(timeout=timeout)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            text, _ = process.communicate()
            raise AssertionError(f"the launch hung for {timeout} s:\n{text}") from None
        return process.returncode, text, time.monotonic() - begin

    def history(self):
        with open(self.out / "history.csv", encoding="ascii") as file:
            return [{name: float(value) for name, value in row.items()}
                    for row in csv.DictReader(file)]


def differing_steps(whole, again, after):
    """Steps beyond `after` in which a run that went on differs from the whole one.

    The host computes the first forces after a restart with the velocities of the whole step, within a
    run with those of the half step before: contact damping and drag differ in that one step by a
    velocity change of g dt, 1e-5 of the energy here.
    """
    by_step = {row["step"]: row for row in again}
    return [(row["step"], name) for row in whole if row["step"] > after
            for name in ("bed_height_m", "kinetic_energy_J", "p_0.01m_Pa")
            if not abs(row[name] - by_step[row["step"]][name]) <= 1e-4 * abs(row[name]) + 1e-12]


def pids_of(program, folder):
    """Processes of this program that run in this folder."""
    found = []
    for entry in Path("/proc").iterdir():
        if not entry.name.isdigit():
            continue
        try:
            command = (entry / "cmdline").read_bytes().split(b"\0")
            place = os.readlink(entry / "cwd")
        except OSError:
            continue
        if command[0].endswith(program.encode()) and place == str(folder):
            found.append(int(entry.name))
    return found


def pids_left_of(program, folder, patience=5.0):
    """Those that still run after the launch has ended; one that is killed takes a moment to be gone."""
    end = time.monotonic() + patience
    while (found := pids_of(program, folder)) and time.monotonic() < end:
        time.sleep(0.05)
    return found
