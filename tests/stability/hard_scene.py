"""The small coupled scene of tests/hosts, changed into a hard case, run with the real programs, and the
balances that every case must keep."""

import math
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "hosts"))
from coupled_launch import COUPLE, Scene  # noqa: E402  (takes the build folder off sys.argv)

GRAVITY = 9.81
STEP = 2e-5  # of the scene's DEM [s]
# Of the layer of cells that [output] pressure_probes = [0.01] reads, below the outlet [m]
PROBE_DEPTH = 0.11 - 0.00825
GRAIN = 2500 * math.pi / 6 * 2.5e-3**3  # mass of one of the scene's [kg]
scene_mass = 8 * 8 * 12 * GRAIN
# As it stands in the scene's gas.toml, for a test to replace.
NOZZLE = """\
[[inflow]]
side = "z_lo"
shape = "rectangle"
center = [0.011, 0.011]
size = [5.5e-3, 5.5e-3]
velocity = 45.0
ramp = 0.002
"""
DUMP = "dump view all custom {every} grains.dump id x y z vx vy vz\ndump_modify view sort id"


def changed(text, changes):
    for old, new in changes:
        assert old in text, f"the scene has no {old!r}"
        text = text.replace(old, new)
    return text


class HardCase:
    """What a run wrote: `text` printed, `rows` of history.csv, `frames` of grains.dump as (step, columns
    id x y z vx vy vz)."""

    def __init__(self, in_script=(), in_gas=(), couple=COUPLE, steps=1000, dump_every=0, files=(),
                 dem_ranks=1, gas_ranks=1, expect=0, read_gas=None, **marks):
        if dump_every:
            marks["extra"] = marks.get("extra", "") + "\n" + DUMP.format(every=dump_every)
        with Scene(couple=couple, steps=steps, **marks) as scene:
            for name, text in files:
                (scene.folder / name).write_text(text, encoding="ascii")
            for name, changes in (("in.liggghts", in_script), ("gas.toml", in_gas)):
                path = scene.folder / name
                path.write_text(changed(path.read_text(), changes))
            self.status, self.text, self.seconds = scene.run(dem_ranks=dem_ranks, gas_ranks=gas_ranks)
            assert self.status == expect, self.text
            history = scene.out / "history.csv"
            self.rows = scene.history() if history.exists() else []
            dump = scene.folder / "grains.dump"
            self.frames = list(read_dump(dump)) if dump.exists() else []
            self.gas_data = read_gas(scene.out / "gas.h5") if read_gas else None
            self.gas_speed = greatest_gas_speeds(scene.out / "gas.h5")

    def vectors(self, name):
        return np.array([[row[name.format(axis)] for axis in "xyz"] for row in self.rows])


def energies(case):
    """Of translation and height of the scene's grains, at each frame [J]."""
    return [GRAIN * (0.5 * (columns[:, 4:]**2).sum() + GRAVITY * columns[:, 3].sum())
            for _, columns in case.frames]


def read_dump(path):
    with open(path, encoding="ascii") as file:
        while file.readline():
            step = int(file.readline())
            file.readline()
            count = int(file.readline())
            for _ in range(5):
                file.readline()
            lines = [file.readline() for _ in range(count)]
            yield step, np.array([line.split() for line in lines], dtype=float).reshape(count, -1)


def greatest_gas_speeds(path):
    """Of each snapshot of gas.h5 [(s, m/s)]."""
    if not path.exists():
        return []
    import h5py
    with h5py.File(path) as file:
        groups = [file[name] for name in file if "time" in file[name].attrs]
        return sorted((float(group.attrs["time"]),
                       float(np.linalg.norm(group["velocity"][...], axis=-1).max()))
                      for group in groups)


def expect_balances(test, case, residual=1e-6, leaving=False):
    """Gas mass, exchanged momentum and the grains' momentum, at every coupling."""
    scale = case.rows[-1]["impulse_exchanged_Ns"]
    for row in case.rows:
        test.assertLess(row["mass_imbalance"], 1e-8, row["step"])
        test.assertLess(row["continuity_residual"], residual, row["step"])
        test.assertLess(row["ledger_residual"], 1e-8, row["step"])
        for count in ("pressure_not_converged", "momentum_not_converged", "beyond_walls"):
            test.assertEqual(row[count], 0, (row["step"], count))
    if leaving:
        return
    change = case.vectors("momentum_{}_Ns") - case.vectors("momentum_{}_Ns")[0]
    impulses = sum(case.vectors(f"impulse_{kind}_{{}}_Ns") for kind in ("taken", "free", "host"))
    test.assertLess(np.abs(change - impulses).max(), 1e-9 * scale)
