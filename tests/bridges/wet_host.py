"""Runs a script of grains with the real program, alone, and reads what it dumped.

Every case is a data file of grains in a box with fixed faces and a script around it. Forces are dumped with
all their digits, so that a test sees the force at the gap that the program had."""

import os
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np

BIN = Path(sys.argv.pop(1)).resolve() if len(sys.argv) > 1 and Path(sys.argv[1]).is_dir() else Path("build")
MPI = ["mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none"]
WATER = 0.0728  # surface tension [N/m]
DENSITY = 2500.0
COLUMNS = ["id", "x", "y", "z", "fx", "fy", "fz", "tqx", "tqy", "tqz", "vx", "vy", "vz"]


@dataclass
class Grain:
    x: tuple
    radius: float
    film: float = 0.0  # [m3]
    type: int = 1
    velocity: tuple = (0.0, 0.0, 0.0)
    spin: tuple = (0.0, 0.0, 0.0)

    @property
    def mass(self):
        return DENSITY * 4.0 / 3.0 * np.pi * self.radius**3


def words(numbers):
    return " ".join(f"{number:.17g}" for number in numbers)


def data_file(grains, types, low, high):
    lines = ["grains", "", f"{len(grains)} atoms", f"{types} atom types", ""]
    lines += [f"{low[d]:.17g} {high[d]:.17g} {'xyz'[d]}lo {'xyz'[d]}hi" for d in range(3)]
    lines += ["", "Atoms", ""]
    lines += [f"{n} {g.type} {2.0 * g.radius:.17g} {DENSITY} {words(g.x)}" for n, g in enumerate(grains, 1)]
    lines += ["", "Velocities", ""]
    lines += [f"{n} {words(g.velocity)} {words(g.spin)}" for n, g in enumerate(grains, 1)]
    return "\n".join(lines) + "\n"


def properties(types, restitution, friction, modulus):
    pairs = " ".join([str(restitution)] * types**2)
    return f"""\
fix m1 all property/global youngsModulus peratomtype {" ".join([str(modulus)] * types)}
fix m2 all property/global poissonsRatio peratomtype {" ".join(["0.3"] * types)}
fix m3 all property/global coefficientRestitution peratomtypepair {types} {pairs}
fix m4 all property/global coefficientFriction peratomtypepair {types} {" ".join([str(friction)] * types**2)}
"""


MODEL = "model hertz tangential history"


class Wet:
    """What a run wrote: `frames`, {column: array over frames and grains}, `steps` of them, `log` printed.

    liquid: the words after 'fix wet all liquid'; empty: no liquid. before, after: lines before the pair style
    (properties of other models) and after it. body: lines between those and the runs (walls, motion). run: the lines
    that run. extra: columns to dump beside COLUMNS. ranks: side by side along x. A status other than `expect` is a
    failure."""

    def __init__(self, grains, liquid="", cohesion=None, before="", body="", run="run 1000", step=1e-6, every=1,
                 extra=(), types=None, size=0.05, ranks=1, expect=0, files=(), restitution=0.9, friction=0.0,
                 modulus=5e6, program=None, skin=5e-4, after=""):
        types = types or max(g.type for g in grains)
        self.grains = grains
        columns = COLUMNS + (["f_liquidFilm", "f_wet[1]", "f_wet[2]"] if liquid else []) + list(extra)
        low, high = ((-size,) * 3, (size,) * 3) if np.isscalar(size) else size
        cohesion = cohesion if cohesion is not None else "bridge" if liquid else ""
        self.cohesion = f"cohesion {cohesion}" if cohesion else ""
        # The host's own models are in its own style alone.
        style = "gran/bridge" if program is None and cohesion in ("", "bridge", None) else "gran"
        lines = ["atom_style granular", "atom_modify map array", "boundary f f f", "newton off",
                 "communicate single vel yes", "units si", f"processors {ranks} 1 1", "read_data grains.data", f"neighbor {skin} bin",
                 "neigh_modify delay 0", properties(types, restitution, friction, modulus), before,
                 f"pair_style {style} {MODEL} {self.cohesion}", "pair_coeff * *", f"timestep {step:.17g}"]
        lines.append("thermo 100000")
        if liquid:
            lines.append(f"fix wet all liquid {liquid} output liquid.csv")
            # The host's set needs a run before it.
            lines.append("run 0")
            lines += [f"set atom {n} property/atom liquidFilm {g.film:.17g}" for n, g in enumerate(grains, 1)]
        lines += [after, body.format(cohesion=self.cohesion, model=MODEL),
                  f"dump d all custom {every} grains.dump {' '.join(columns)}",
                  f'dump_modify d sort id format "%d {" ".join(["%.17g"] * (len(columns) - 1))}"', run]
        with tempfile.TemporaryDirectory(dir=os.environ.get("WET_HOST_KEEP")) as folder:
            folder = Path(folder)
            (folder / "grains.data").write_text(data_file(grains, types, low, high), encoding="ascii")
            (folder / "in.wet").write_text("\n".join(lines) + "\n", encoding="ascii")
            for name, text in files:
                (folder / name).write_text(text, encoding="ascii")
            launch = [*MPI, "-np", str(ranks)] if ranks > 1 else []
            done = subprocess.run([*launch, program or str(BIN / "gasgrain-liggghts"), "-in", "in.wet", "-log", "none"],
                                  cwd=folder, capture_output=True, text=True, errors="replace", timeout=120, check=False)
            self.log = done.stdout + done.stderr
            if (done.returncode == 0) != (expect == 0):
                raise AssertionError(f"exit status {done.returncode}:\n{self.log[-3000:]}")
            self.frames, self.steps = read_dump(folder / "grains.dump", columns)
            ledger = folder / "liquid.csv"
            self.ledger = np.genfromtxt(ledger, delimiter=",", names=True) if ledger.exists() else None
        self.step = step

    def vectors(self, name, grain):
        """Of a grain (its place in the list) over the frames: x, f, tq or v."""
        return np.stack([self.frames[name + axis][:, grain] if name != "x" else self.frames[axis][:, grain]
                         for axis in "xyz"], axis=-1)

    def gaps(self, i, j):
        apart = np.linalg.norm(self.vectors("x", i) - self.vectors("x", j), axis=-1)
        return apart - self.grains[i].radius - self.grains[j].radius

    def liquid(self):
        """All liquid of grains and their bridges, over the frames [m3]: each grain has half of a bridge."""
        return self.frames["f_liquidFilm"].sum(axis=1) + self.frames["f_wet[2]"].sum(axis=1)


def read_dump(path, columns):
    if not path.exists():
        return None, None
    steps, rows = [], []
    with open(path, encoding="ascii") as file:
        while file.readline():
            steps.append(int(file.readline()))
            file.readline()
            count = int(file.readline())
            for _ in range(5):
                file.readline()
            rows.append([file.readline().split() for _ in range(count)])
    values = np.array(rows, dtype=float)
    return {name: values[:, :, n] for n, name in enumerate(columns)}, np.array(steps)
