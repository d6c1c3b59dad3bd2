"""The beds of dem.py: a periodic tile of glass spheres, settled on a floor or bubbling in air, repeated sideways.

Both are made once, by ours in LAMMPS, and kept in the folder of the work. The tile is wide and thin, so that
bubbles have room in one of its directions. A bed continues from places, velocities and spins; its contacts' springs
begin anew.
"""

import random
from pathlib import Path

from dem_run import launch, script_name

DIAMETER, DENSITY, DT = 0.0025, 2500.0, 1.0e-5  # m, kg/m3, s
TILE = (40, 5, 25)                              # spheres before they settle: 5,000
PITCH = 1.04 * DIAMETER
WIDTH, DEPTH = TILE[0] * PITCH, TILE[1] * PITCH
HEIGHT = 0.3                                    # m, of the box
SETTLING, BUBBLING = 0.2, 0.46                  # s, without gas, then with it: its second bubble is in the bed
AIR, STRIP = (1.2, 4.0), (0.36, 0.64)           # m/s through the sides and the middle of the floor; share of the width
SHAKE = 0.02                                    # m/s, greatest of each component of the settled bed's grains

MATERIALS = """\
fix youngs all property/global youngsModulus peratomtype 5e6
fix poisson all property/global poissonsRatio peratomtype 0.17
fix restitution all property/global coefficientRestitution peratomtypepair 1 0.9
fix friction all property/global coefficientFriction peratomtypepair 1 0.1
"""
def floor_strip(begin, end, velocity):
    """Gas through the floor between two shares of the tile's width, over all of its depth."""
    return f"""\
[[inflow]]
side = "z_lo"
shape = "rectangle"
center = [{(begin + end) / 2 * WIDTH!r}, {DEPTH / 2!r}]
size = [{(end - begin) * WIDTH!r}, {DEPTH!r}]
velocity = {velocity!r}
ramp = 0.02
"""


# 1.98 m/s in the mean, 1.6 times the u_mf of Ergun's law. Stronger in the middle: through an even floor the bed of a
# periodic tile rises as one plug.
GAS = f"""\
[grid]
lo = [0.0, 0.0, 0.0]
hi = [{WIDTH!r}, {DEPTH!r}, {HEIGHT!r}]
cells = [25, 3, 60]
[time]
step = 1e-3
[boundary]
x_lo = "periodic"
x_hi = "periodic"
y_lo = "periodic"
y_hi = "periodic"
z_hi = "outlet"
""" + floor_strip(0, STRIP[0], AIR[0]) + floor_strip(*STRIP, AIR[1]) + floor_strip(STRIP[1], 1, AIR[0])
MAKE = f"""\
pair_style gran/bridge model hertz tangential history
pair_coeff * *
fix floor all wall/gran/bridge model hertz tangential history primitive type 1 zplane 0.0
fix ceiling all wall/gran/bridge model hertz tangential history primitive type 1 zplane {HEIGHT!r}
"""


def head(host, build, data):
    """The script's lines before the contacts; `build`: the folder whose styles LAMMPS loads, or None."""
    lammps = host == "lammps"
    lines = [f"include {build / 'gasgrain.lmp'}"] if lammps and build else []
    return "\n".join([*lines, f"atom_style {'sphere' if lammps else 'granular'}", "atom_modify map array", "units si",
                      "boundary p p f", "newton off", "comm_modify vel yes" if lammps else "communicate single vel yes",
                      "processors * * 1", f"read_data {data}", "neighbor 0.0005 bin", "neigh_modify delay 0",
                      f"timestep {DT}"]) + "\n"


MOTION = "fix weight all gravity 9.81 vector 0 0 -1\nfix move all nve/sphere\n"


def write_data(path, grains, width, depth):
    """`grains`: rows of place, velocity, spin."""
    text = f"bed\n\n{len(grains)} atoms\n1 atom types\n\n0 {width!r} xlo xhi\n0 {depth!r} ylo yhi\n0 {HEIGHT} zlo zhi\n"
    text += "\nAtoms\n\n" + "".join(f"{n} 1 {DIAMETER} {DENSITY} {g[0]!r} {g[1]!r} {g[2]!r}\n"
                                    for n, g in enumerate(grains, 1))
    text += "\nVelocities\n\n" + "".join(f"{n} {' '.join(map(repr, g[3:]))}\n" for n, g in enumerate(grains, 1))
    path.write_text(text)


def read_grains(path):
    rows = (line.split() for line in path.read_text().split("ITEM: ATOMS")[1].splitlines()[1:])
    return [(float(x) % WIDTH, float(y) % DEPTH, *map(float, rest)) for x, y, *rest in rows]


def make_tiles(work, build, settling, bubbling):
    """Files of the settled and of the bubbling tile, made where they are not there."""
    tiles = {"settled": work / f"settled.{settling}.txt", "bubbling": work / f"bubbling.{settling}.{bubbling}.txt"}
    if all(tile.exists() for tile in tiles.values()):
        return tiles
    print("packing a tile and blowing air through it ...", flush=True)
    roll = random.Random(3)
    loose = [(*((n + 0.5) * PITCH + roll.uniform(-0.015, 0.015) * DIAMETER for n in (i, j, k)), *[0.0] * 6)
             for k in range(TILE[2]) for j in range(TILE[1]) for i in range(TILE[0])]
    write_data(work / "loose.data", loose, WIDTH, DEPTH)
    (work / "gas.toml").write_text(GAS)
    columns = "x y z vx vy vz omegax omegay omegaz modify sort id format float %.17g"
    text = head("lammps", build, "loose.data") + MATERIALS + MAKE + MOTION + (
        f"fix calm all viscous 1e-4\nrun {round(settling / DT)}\nunfix calm\n"
        f"write_dump all custom {tiles['settled'].name} {columns}\n"
        f"fix air all couple/gas every 100 start {round(settling / DT)} gas gas.toml output {work / 'air'} "
        "drag koch_hill pressure_gradient\n"
        f"thermo 5000\nrun {round(bubbling / DT)}\nwrite_dump all custom {tiles['bubbling'].name} {columns}\n")
    launch(work, ["lmp"], script_name("make tiles"), text, 1)
    return tiles


def across_and_along(tiles):
    """Two factors of a number of tiles that make the bed most nearly square."""
    pairs = [(n, tiles // n) for n in range(1, tiles + 1) if tiles % n == 0]
    return min(pairs, key=lambda pair: max(pair[0] * WIDTH, pair[1] * DEPTH) / min(pair[0] * WIDTH, pair[1] * DEPTH))


def make_bed(work, tile: Path, grains, shaken):
    """(name of the data file, grains in it). `shaken`: small random velocities take the place of the tile's own."""
    of_tile = read_grains(tile)
    along, across = across_and_along(max(1, round(grains / len(of_tile))))
    bed = [(x + i * WIDTH, y + j * DEPTH, *rest) for i in range(along) for j in range(across)
           for x, y, *rest in of_tile]
    if shaken:
        roll = random.Random(1)
        bed = [(*grain[:3], *(roll.uniform(-SHAKE, SHAKE) for _ in range(3)), 0.0, 0.0, 0.0) for grain in bed]
    name = f"{tile.stem}.{len(bed)}.data"
    write_data(work / name, bed, along * WIDTH, across * DEPTH)
    return name, len(bed)
