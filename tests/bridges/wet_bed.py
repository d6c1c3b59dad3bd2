"""A few hundred wet grains in the real programs, for the tests of their liquid.

Scripts are in LIGGGHTS's words; `lammps` after the folder of the build runs them in LAMMPS.
"""

import csv
import random
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "hosts"))
from host_words import HOST, command_of, in_words_of  # noqa: E402

BUILD = Path(sys.argv.pop(1)).resolve() if len(sys.argv) > 1 else Path("build").resolve()
SCRIPT_NAME = f"in.{HOST}"

LIQUID = ("content 0.02 surface_tension 0.0728 contact_angle 0.35 viscosity 0.001 "
          "minimum_separation 1e-6")

SCRIPT = """
atom_style granular
atom_modify map array sort 0 0
boundary {boundary}
newton off
communicate single vel yes
units si
region box block 0 {size} 0 {size} 0 {size} units box
create_box 1 box
neighbor {skin} bin
neigh_modify delay 0 {neighbours}
fix m1 all property/global youngsModulus peratomtype 5e6
fix m2 all property/global poissonsRatio peratomtype 0.45
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.7
fix m4 all property/global coefficientFriction peratomtypepair 1 0.5
pair_style gran/bridge model hertz tangential history {cohesion}
pair_coeff * *
timestep {step}
{grains}
{walls}
{liquid}
fix nve all nve/sphere
{runs}
"""


def random_grains(count, size, seed, margin=0.0, speed=0.2):
    """Lines that put grains on the sites of a jittered lattice, some of them in touch."""
    rng = random.Random(seed)
    sites = int(count ** (1 / 3) + 0.999)
    pitch = (size - 2 * margin) / sites
    radius = 0.53 * pitch
    lines = []
    number = 0
    for ix in range(sites):
        for iy in range(sites):
            for iz in range(sites):
                if number == count:
                    break
                number += 1
                at = [margin + (i + 0.5 + rng.uniform(-0.12, 0.12)) * pitch for i in (ix, iy, iz)]
                lines.append("create_atoms 1 single {:.12g} {:.12g} {:.12g} units box".format(*at))
    for n in range(1, number + 1):
        lines.append("set atom {} diameter {:.12g}".format(n, 2 * radius * rng.uniform(0.7, 1.0)))
        lines.append("set atom {} vx {:.6g} vy {:.6g} vz {:.6g}".format(
            n, *(rng.uniform(-speed, speed) for _ in range(3))))
    # Last of all: in LAMMPS a diameter that is set leaves the mass as it was.
    lines.append("set group all density 2500")
    return "\n".join(lines)


def floor(size, cells):
    """A floor of triangles at z = 0, as STL."""
    pitch = size / cells
    text = "solid floor\n"
    for i in range(cells):
        for j in range(cells):
            a, b = (i * pitch, j * pitch), ((i + 1) * pitch, j * pitch)
            c, d = ((i + 1) * pitch, (j + 1) * pitch), (i * pitch, (j + 1) * pitch)
            for corners in ((a, b, c), (a, c, d)):
                text += " facet normal 0 0 1\n  outer loop\n"
                text += "".join(f"   vertex {x:.9g} {y:.9g} 0.0\n" for x, y in corners)
                text += "  endloop\n endfacet\n"
    return text + "endsolid floor\n"


class Bed:
    """A folder with a script; its results are there until the block ends."""

    def __init__(self, **parts):
        self.parts = dict(boundary="p p p", size=0.012, skin=0.0004, neighbours="", cohesion="cohesion bridge",
                          step=1e-5, grains="", walls="", liquid=f"fix wet all liquid {LIQUID} every 50 output liquid.csv",
                          runs="run 100")
        self.parts.update(parts)

    def __enter__(self):
        self.held = tempfile.TemporaryDirectory()
        self.folder = Path(self.held.name)
        return self

    def __exit__(self, *_):
        self.held.cleanup()

    def run(self, ranks=1, fails=False, **parts):
        text = SCRIPT.format(**{**self.parts, **parts})
        (self.folder / SCRIPT_NAME).write_text(in_words_of(HOST, text, BUILD))
        return self.run_script(SCRIPT_NAME, ranks, fails)

    def run_script(self, name, ranks=1, fails=False):
        done = subprocess.run(
            ["mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none", "-np",
             str(ranks), *command_of(HOST, BUILD), "-in", name],
            cwd=self.folder, capture_output=True, text=True, timeout=240, check=False)
        if (done.returncode != 0) != fails:
            raise AssertionError(f"status {done.returncode}\n{done.stdout[-2000:]}\n{done.stderr[-2000:]}")
        return done.stdout + done.stderr

    def ledger(self, name="liquid.csv"):
        with open(self.folder / name, encoding="utf-8") as file:
            return [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]

    def dump(self, name):
        """The last step of a dump: number of a grain -> its values."""
        text = (self.folder / name).read_text()
        last = text[text.rindex("ITEM: TIMESTEP"):].splitlines()
        start = next(n for n, line in enumerate(last) if line.startswith("ITEM: ATOMS"))
        rows = [line.split() for line in last[start + 1:]]
        return {int(row[0]): [float(value) for value in row[1:]] for row in rows}


DUMP = ("dump d all custom {every} {file} id x y z fx fy fz tqx tqy tqz f_liquidFilm f_wet[1] f_wet[2]\n"
        "dump_modify d sort id format \"%d" + " %.17g" * 12 + "\"\n")
