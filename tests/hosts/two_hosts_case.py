"""The same grains in LIGGGHTS and in LAMMPS: what the tests of both hosts share."""

import math
import os
import random
import subprocess
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from coupled_launch import BIN

COLUMNS = {"x": "x", "y": "y", "z": "z", "vx": "vx", "vy": "vy", "vz": "vz", "fx": "fx", "fy": "fy", "fz": "fz",
           "wx": "omegax", "wy": "omegay", "wz": "omegaz", "tx": "tqx", "ty": "tqy", "tz": "tqz"}
FORCE, TORQUE = ("fx", "fy", "fz"), ("tx", "ty", "tz")
MOTION = ("x", "y", "z", "vx", "vy", "vz", "wx", "wy", "wz")
SIZE = 0.02  # of the box [m]

MATERIALS = """\
fix youngs all property/global youngsModulus peratomtype 5e6 8e6
fix poisson all property/global poissonsRatio peratomtype 0.17 0.3
fix restitution all property/global coefficientRestitution peratomtypepair 2 0.9 0.8 0.8 0.6
fix friction all property/global coefficientFriction peratomtypepair 2 0.3 0.1 0.1 0.5
fix resist all property/global coefficientRollingFriction peratomtypepair 2 0.05 0.03 0.03 0.2
fix damp all property/global coefficientRollingViscousDamping peratomtypepair 2 0.3 0.2 0.2 0.1
fix speed all property/global characteristicVelocity scalar 0.3
fix kn all property/global kn peratomtypepair 2 2e5 3e5 3e5 4e5
fix kt all property/global kt peratomtypepair 2 1e5 2e5 2e5 3e5
fix gamman all property/global gamman peratomtypepair 2 2e3 3e3 3e3 1e3
fix gammat all property/global gammat peratomtypepair 2 1e3 2e3 2e3 3e3
fix gamman_abs all property/global gamman_abs peratomtypepair 2 0.01 0.02 0.02 0.03
fix gammat_abs all property/global gammat_abs peratomtypepair 2 0.005 0.01 0.01 0.02
fix viscosity all property/global FluidViscosity peratomtypepair 2 1e-3 2e-3 2e-3 1e-3
fix stokes all property/global CriticalStokes peratomtypepair 2 10 11 11 12
fix most all property/global MaximumRestitution peratomtypepair 2 0.9 0.8 0.8 0.7
fix time all property/global rollingTimeConstant peratomtypepair 2 1e-3 2e-3 2e-3 3e-3
"""
WALLS = ("xplane 0.001", "yplane 0.019", "zplane 0.001", "zcylinder 0.0095 0.01 0.01")


def crowd(number=100, seed=7, spread=0.8, speed=0.1):
    """Spheres of two sizes and types, many of which overlap by some per mille to per cent, some with walls:
    [(type, diameter, density, place, velocity, spin)]."""
    roll = random.Random(seed)
    grains = []
    while len(grains) < number:
        diameter = roll.choice((0.002, 0.003))
        place = [0.01 + spread * 0.01 * roll.uniform(-1, 1), 0.01 + spread * 0.01 * roll.uniform(-1, 1),
                 0.001 + roll.uniform(0.47 * diameter, 0.008)]
        off_axis = math.hypot(place[0] - 0.01, place[1] - 0.01)
        if off_axis > 0.0095 - 0.47 * diameter:
            continue
        if any(math.dist(place, other[3]) < 0.46 * (diameter + other[1]) for other in grains):
            continue
        vector = lambda most: [roll.uniform(-most, most) for _ in range(3)]
        grains.append((roll.choice((1, 2)), diameter, 2500.0, place, vector(speed), vector(50.0)))
    return grains


def data_file(grains, low=0.0, size=SIZE):
    text = f"grains\n\n{len(grains)} atoms\n2 atom types\n\n" + "".join(f"{low!r} {low + size!r} {d}lo {d}hi\n" for d in "xyz")
    text += "\nAtoms\n\n"
    for n, (kind, diameter, density, place, _, _) in enumerate(grains):
        text += f"{n + 1} {kind} {diameter!r} {density!r} " + " ".join(map(repr, place)) + "\n"
    text += "\nVelocities\n\n"
    for n, grain in enumerate(grains):
        text += f"{n + 1} " + " ".join(repr(value) for value in grain[4] + grain[5]) + "\n"
    return text


def script(host, contact, walls=(), words="", before="", after="run 5", dt=1e-7, properties=MATERIALS, skin=5e-4,
           newton="off", pair=None, wall=None, boundary="f f f", every=1):
    """`before` stands before the models, `pair` and `wall` in the place of the host's own lines; states are written
    `every` so many steps."""
    lammps = host == "lammps"
    style = "gran/bridge" if lammps else "gran"
    columns = " ".join(COLUMNS.values())
    numbers = " ".join(["%.17g"] * len(COLUMNS))
    lines = [f"include {BIN / 'gasgrain.lmp'}"] if lammps else []
    lines += [f"atom_style {'sphere' if lammps else 'granular'}", "atom_modify map array sort 0 0", "units si",
              f"boundary {boundary}", f"newton {newton}", "comm_modify vel yes" if lammps else "communicate single vel yes",
              "read_data grains.data", f"neighbor {skin!r} bin", "neigh_modify delay 0", f"timestep {dt!r}", before,
              properties, f"pair_style {pair or f'{style} {contact} {words}'}", "pair_coeff * *"]
    for n, shape in enumerate(walls):
        lines.append(wall.format(n, shape) if wall else
                     f"fix wall{n} all wall/{style} {contact} primitive type 2 {shape} {words}")
    dump = (f"dump state all custom {every} state.txt id {columns}\n"
            f'dump_modify state format {"line " if lammps else ""}"%d {numbers}"\nthermo_modify lost ignore')
    # In a script that begins anew: what it loads, and its output, in another file.
    after = after.replace("@plugin@", str(BIN / "gasgrain.lmp")).replace("@dump@", dump.replace("state.txt", "later.txt"))
    return "\n".join([*lines, dump, after]) + "\n"


def read_states(text):
    """{step: {number: {column: value}}}"""
    states = {}
    lines = iter(text.splitlines())
    for line in lines:
        if line.startswith("ITEM: TIMESTEP"):
            state = states[int(next(lines))] = {}
        elif line.startswith("ITEM: ATOMS"):
            rest = True
        elif not line.startswith("ITEM") and len(line.split()) == len(COLUMNS) + 1:
            number, *values = line.split()
            state[int(number)] = dict(zip(COLUMNS, map(float, values)))
    return states


def run(host, grains, contact, ranks=1, size=SIZE, low=0.0, keep=None, **settings):
    """(status, everything printed, states); with `keep` also the text of the file of this name."""
    program = str(BIN / "gasgrain-liggghts") if host == "liggghts" else "lmp"
    with tempfile.TemporaryDirectory(prefix="gasgrain-test-") as name:
        folder = Path(name)
        (folder / "grains.data").write_text(data_file(grains, low, size))
        (folder / "in").write_text(script(host, contact, **settings))
        command = [program, "-in", "in", "-log", "none"]
        if ranks > 1:
            command = ["mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none", "-np", str(ranks), *command]
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=120, check=False,
                              env={**os.environ, "OMP_NUM_THREADS": "1"})
        states = {}
        for states_file in ("state.txt", "later.txt"):
            if states_file != keep and (folder / states_file).exists():
                states.update(read_states((folder / states_file).read_text()))
        found = done.returncode, done.stdout + done.stderr, states
        return found if keep is None else (*found, (folder / keep).read_text())


def states_of(host, grains, contact, **settings):
    status, output, states = run(host, grains, contact, **settings)
    assert status == 0 and states, f"{host}, {contact}: status {status}\n{output[-3000:]}"
    return states


def in_both(grains, contact, **settings):
    """The states in LIGGGHTS and in LAMMPS; what differs between the hosts' scripts is given as {host: value}."""
    def of(host):
        own = {name: value[host] if isinstance(value, dict) and host in value else value
               for name, value in settings.items()}
        return states_of(host, grains, contact, **own)
    with ThreadPoolExecutor() as pool:
        return list(pool.map(of, ("liggghts", "lammps")))


def greatest(state, columns):
    return max(max(abs(row[name]) for name in columns) for row in state.values())


def differ(one, other, columns):
    """Greatest difference of two states over the greatest value."""
    assert one.keys() == other.keys()
    most = max(greatest(one, columns), greatest(other, columns))
    return max(max(abs(one[n][name] - other[n][name]) for name in columns) for n in one) / most if most > 0.0 else 0.0
