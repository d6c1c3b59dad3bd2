"""Runs scripts of parcels and grains with the real programs and reads what they wrote.

Scripts are in LIGGGHTS's words; `lammps` after the folder of the build runs them in LAMMPS.
"""

import csv
import os
import random
import signal
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "hosts"))
from host_words import HOST, command_of, in_words_of  # noqa: E402

BUILD = Path(sys.argv.pop(1) if len(sys.argv) > 1 and Path(sys.argv[1]).is_dir() else "build").resolve()

HEAD = """
atom_style granular
atom_modify map array sort 0 0
units si
boundary {boundary}
newton off
communicate single vel yes
{processors}
"""
BOX = "region box block 0 {x} 0 {y} 0 {z} units box\ncreate_box {types} box\n"


def words(numbers):
    return " ".join(f"{number:.17g}" for number in numbers)


class Atom:
    def __init__(self, x, v=(0.0, 0.0, 0.0), radius=1e-3, density=2000.0, kind=1, spin=(0.0, 0.0, 0.0)):
        self.x, self.v, self.spin, self.radius, self.density, self.kind = x, v, spin, radius, density, kind


def cloud(count, size, seed, speed=1.0, radius=1e-3, margin=0.0):
    """Parcels anywhere in a box, with velocities and radii of many sizes."""
    rng = random.Random(seed)
    return [Atom([rng.uniform(margin, side - margin) for side in size],
                 [rng.uniform(-speed, speed) for _ in range(3)], radius * rng.uniform(0.5, 1.0))
            for _ in range(count)]


def data_file(atoms, size, types=1):
    lines = ["atoms", "", f"{len(atoms)} atoms", f"{types} atom types", ""]
    lines += [f"0 {size[d]:.17g} {'xyz'[d]}lo {'xyz'[d]}hi" for d in range(3)]
    lines += ["", "Atoms", ""]
    lines += [f"{n} {a.kind} {2 * a.radius:.17g} {a.density:.17g} {words(a.x)}" for n, a in enumerate(atoms, 1)]
    lines += ["", "Velocities", ""]
    lines += [f"{n} {words(a.v)} {words(a.spin)}" for n, a in enumerate(atoms, 1)]
    return "\n".join(lines) + "\n"


class Scene:
    """A folder with a script and its results, removed when the block ends."""

    def __init__(self, size=(0.04, 0.04, 0.04), atoms=(), types=1):
        self.size, self.types = size, types
        self.held = tempfile.TemporaryDirectory(prefix="gasgrain-test-")
        self.folder = Path(self.held.name)
        self.start = BOX.format(x=size[0], y=size[1], z=size[2], types=types)
        if atoms:
            (self.folder / "atoms.data").write_text(data_file(atoms, size, types))
            self.start = "read_data atoms.data\n"

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.held.cleanup()

    def run(self, body, ranks=1, fails=False, boundary="p p p", processors="", start=None, gas=0, host=HOST):
        """What the program prints; gas: ranks of a gas program in the launch."""
        text = HEAD.format(boundary=boundary, processors=processors) + (start or self.start)
        text += "pair_style none\nneighbor 0.002 bin\n" * ("pair_style" not in body) + "neigh_modify delay 0\n" + body
        (self.folder / f"in.{host}").write_text(in_words_of(host, text, BUILD))
        command = [*command_of(host, BUILD, gas > 0), "-in", f"in.{host}"]
        if ranks > 1 or gas:
            command = ["mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none",
                       "-np", str(ranks), *command]
        if gas:
            command += [":", "-np", str(gas), str(BUILD / "gasgrain-gas"), "gas.toml", "--out", "out"]
        process = subprocess.Popen(
            command, cwd=self.folder, text=True, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT, start_new_session=True,
            env=dict(os.environ, OMPI_MCA_mpi_yield_when_idle="1", OMP_NUM_THREADS="1",
                     OMPI_MCA_btl_vader_single_copy_mechanism="none"))
        try:
            text, _ = process.communicate(timeout=120)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            raise AssertionError(f"the launch hung:\n{process.communicate()[0]}") from None
        if (process.returncode != 0) != fails:
            raise AssertionError(f"status {process.returncode}\n{text[-3000:]}")
        return text

    def dump(self, name, step=None):
        """A step of a dump, the last one unless told: number of an atom -> its values."""
        frames = (self.folder / name).read_text().split("ITEM: TIMESTEP\n")[1:]
        frame = frames[-1] if step is None else next(f for f in frames if f.startswith(f"{step}\n"))
        lines = frame.splitlines()
        first = next(n for n, line in enumerate(lines) if line.startswith("ITEM: ATOMS"))
        return {int(line.split()[0]): [float(value) for value in line.split()[1:]] for line in lines[first + 1:]}

    def raw_dump(self, name):
        """The last step as it is written, for a comparison bit for bit."""
        text = (self.folder / name).read_text()
        return text[text.rindex("ITEM: ATOMS"):]

    def log(self, host=HOST):
        """Rows of the thermo tables, a list for each run."""
        runs = []
        rows = None
        for line in (self.folder / f"log.{host}").read_text().splitlines():
            if line.split()[:1] == ["Step"]:
                names = [name.removeprefix("f_") for name in line.split()]
                rows = []
                runs.append(rows)
            elif line.startswith("Loop time"):
                rows = None
            elif rows is not None and len(line.split()) == len(names):
                try:
                    rows.append(dict(zip(names, map(float, line.split()))))
                except ValueError:
                    pass
        return runs

    def table(self, name):
        with open(self.folder / name, encoding="ascii") as file:
            return [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]


def thermo(columns, every=1):
    return (f"thermo_style custom step {columns}\nthermo_modify norm no lost ignore format float %.17g\n"
            f"thermo {every}\n")


def dump(columns, every, name="last.dump"):
    count = len(columns.split())
    return (f"dump d all custom {every} {name} id {columns}\n"
            f"dump_modify d sort id format \"%d{' %.17g' * count}\"\n")


def largest_difference(one, other):
    """Of two dumps, each column against its own largest value."""
    if one.keys() != other.keys():
        raise AssertionError(f"atoms differ: {len(one)} and {len(other)}")
    columns = range(len(next(iter(one.values()))))
    scales = [max(abs(row[n]) for row in one.values()) or 1.0 for n in columns]
    return max(abs(a - b) / scale for key in one for a, b, scale in zip(one[key], other[key], scales))


def refused(test, scene, body, *expected, **options):
    """One message with these words, and a status that is not 0, in time."""
    text = scene.run(body, fails=True, **options)
    lines = [line for line in text.splitlines() if f"gasgrain-{HOST}: error:" in line]
    test.assertEqual(len(lines), 1, text[-2000:])
    message = text[text.index(f"gasgrain-{HOST}: error:"):].split("-----")[0]
    for part in expected:
        test.assertIn(part, message)
