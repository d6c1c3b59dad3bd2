"""The same grains with `pair_style gran` and with `gran/bridge` in LIGGGHTS: what the tests of both share."""

import os
import subprocess
import tempfile
from pathlib import Path

from coupled_launch import BIN
from two_hosts_case import COLUMNS, MATERIALS, SIZE, crowd, data_file, differ, read_states
from two_hosts_forces import COHESIONS

STYLES = ("gran", "gran/bridge")
FORCES = ("fx", "fy", "fz", "tx", "ty", "tz")
STATE = "id " + " ".join(COLUMNS.values())
NUMBERS = '"%d ' + " ".join(["%.17g"] * len(COLUMNS)) + '"'
PLATE = """solid plate
facet normal 0 0 1
outer loop
vertex 0 0 0.001
vertex 0.03 0 0.001
vertex 0 0.03 0.001
endloop
endfacet
endsolid plate
"""
# Lists as often as steps: LIGGGHTS then knows no springs of contacts that have opened.
NEW_LISTS = "neigh_modify every 1 delay 0 check no\n"


def head(dt=2e-6, grains="read_data grains.data", data="", skin=5e-4, boundary="f f f"):
    return f"""\
units si
atom_style granular
atom_modify map array sort 0 0
boundary {boundary}
newton off
communicate single vel yes
processors * 1 1
{grains}
neighbor {skin!r} bin
neigh_modify delay 0
timestep {dt!r}
{MATERIALS}{data}"""


def lines_of(cohesion):
    """(the script's lines, the words) of this cohesion."""
    lines, words = COHESIONS.get(cohesion, ("", ""))
    return lines["liggghts"] if isinstance(lines, dict) else lines, words


def walls(contact, words="", mesh=True):
    """A plane, a cylinder, and a floor of one triangle."""
    shapes = ["primitive type 2 xplane 0.001", "primitive type 2 zcylinder 0.0095 0.01 0.01"]
    text = ""
    if mesh:
        text = "fix plate all mesh/surface file plate.stl type 1\n"
        shapes.append("mesh n_meshes 1 meshes plate")
    return text + "".join(f"fix wall{n} all wall/gran {contact} {shape} {words}\n" for n, shape in enumerate(shapes))


def pair(style, contact, words=""):
    return f"pair_style {style} {contact} {words}\npair_coeff * *\n"


def dump(name="state", every=1):
    return (f"dump {name} all custom {every} {name}.txt {STATE}\ndump_modify {name} sort id format {NUMBERS}\n"
            "thermo_modify lost ignore\n")


def launch(script, grains=None, ranks=1, **environment):
    """(status, everything printed, {file: its text})"""
    with tempfile.TemporaryDirectory(prefix="gasgrain-test-") as name:
        folder = Path(name)
        (folder / "grains.data").write_text(data_file(grains or crowd(), 0.0, SIZE))
        (folder / "plate.stl").write_text(PLATE)
        (folder / "in").write_text(script)
        command = [str(BIN / "gasgrain-liggghts"), "-in", "in", "-log", "none"]
        if ranks > 1:
            command = ["mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none", "-np", str(ranks), *command]
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=240, check=False,
                              env={**os.environ, "OMP_NUM_THREADS": "1", "GASGRAIN_PAIR_STYLE": "", **environment})
        return (done.returncode, done.stdout + done.stderr, {file.name: file.read_text() for file in folder.glob("*.txt")})


def results(script, **settings):
    """What the script writes."""
    status, output, files = launch(script, **settings)
    assert status == 0 and files, f"status {status}\n{output[-3000:]}"
    return files


def states(files, name="state.txt"):
    return read_states(files[name])


def rows_of(text, kind="ENTRIES"):
    """The rows of the last step of a dump."""
    lines = text.split(f"ITEM: {kind}")[-1].splitlines()[1:]
    return sorted([float(word) for word in line.split()] for line in lines)


def rows_differ(one, other):
    """Greatest difference of two tables over the greatest value of its column."""
    assert len(one) == len(other), f"{len(one)} and {len(other)} rows"
    worst = 0.0
    for a, b in zip(zip(*one), zip(*other)):
        most = max(map(abs, a + b))
        worst = max(worst, max(abs(x - y) for x, y in zip(a, b)) / most if most > 0.0 else 0.0)
    return worst
