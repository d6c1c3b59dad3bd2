"""Pairs of wet grains, and grains on a primitive and on a mesh wall, side by side in one run, all pulled apart at
one speed."""

from dataclasses import dataclass

import numpy as np

from bridge_formulas import Bridge
from wet_host import WATER, Grain, Wet

ANGLES = {1: 0.35, 2: 0.1, 3: 0.6, 4: 0.0, 5: 0.5 * np.pi, 6: 0.2}  # of types; 6: of walls
ANGLE_WORDS = " ".join(f"{angle:.17g}" for angle in ANGLES.values())
VOLUMES = (1e-4, 1e-3, 5e-2)  # V / R^3
MM = 1e-3
START = 1e-9  # gap at first [m]; still within `formation`
LIQUID = (f"film 0 gives 1 surface_tension {WATER} contact_angle {ANGLE_WORDS} formation {2 * START} "
          "every 100000 ")
PLATE = 0.02  # below the primitive wall at z = 0 [m]
SPEED = 0.3
STEP = 1e-6


def plate(half=0.04, z=-PLATE):
    """Two triangles."""
    corners = [(-half, -half, z), (half, -half, z), (half, half, z), (-half, half, z)]
    text = "solid plate\n"
    for triangle in ((0, 1, 2), (0, 2, 3)):
        text += "facet normal 0 0 1\nouter loop\n"
        text += "".join(f"vertex {x} {y} {z}\n" for x, y, z in (corners[k] for k in triangle))
        text += "endloop\nendfacet\n"
    return text + "endsolid plate\n"


WALLS = """\
fix floor all wall/gran {model} {cohesion} primitive type 6 zplane 0.0
fix plate all mesh/surface file plate.stl type 6
fix plates all wall/gran {model} {cohesion} mesh n_meshes 1 meshes plate
"""


@dataclass
class Pulled:
    """`moves` goes away from `stays` (a grain, or the name of a wall)."""
    name: str
    stays: object
    moves: int
    bridge: Bridge


class Scene:
    """Pairs side by side, along x; one grain of each goes off in +x. Grains on walls at y above the pairs': off
    the floor in +z, while the plate leaves the grains on it."""

    def __init__(self, volumes=VOLUMES, start=START):
        self.grains, self.pulled, self.start = [], [], start
        kinds = [("equal", 1.0, 1.0, 1, 1), ("size ratio 15", 1.5, 0.1, 2, 3), ("wetted", 1.0, 1.0, 4, 4),
                 ("90 degrees", 1.0, 1.0, 5, 5), ("0 on 90 degrees", 1.0, 1.0, 4, 5), ("unequal", 0.4, 1.0, 2, 3)]
        y = -0.045
        for name, radius_i, radius_j, type_i, type_j in kinds:
            for v in volumes:
                y += 4.5e-3
                self.pair(f"{name}, v = {v:g}", y, radius_i * MM, radius_j * MM, type_i, type_j, v)
        for n, v in enumerate(volumes):
            self.on_wall(f"on the floor, v = {v:g}", "floor", -0.02 - 0.004 * n, 0.0, v)
            # On the edge of two triangles, within one, within the other
            self.on_wall(f"on the plate, v = {v:g}", "plate", (0.0, 0.01, -0.01)[n], -PLATE, v)

    def pair(self, name, y, radius_i, radius_j, type_i, type_j, v):
        radius = 2 * radius_i * radius_j / (radius_i + radius_j)
        volume = v * radius**3
        first = len(self.grains)
        # On either side of x = 0, where two ranks meet
        self.grains.append(Grain((-radius_i, y, 0.02), radius_i, 0.25 * volume, type_i))
        self.grains.append(Grain((radius_j + self.start, y, 0.02), radius_j, 0.75 * volume, type_j))
        angle = (ANGLES[type_i] + ANGLES[type_j]) / 2
        self.pulled.append(Pulled(name, first, first + 1, Bridge(radius, angle, WATER, volume)))

    def on_wall(self, name, wall, x, z, v):
        radius = 1.0 * MM
        volume = v * radius**3
        self.grains.append(Grain((x, 0.0, z + radius + self.start), radius, volume, 2))
        self.pulled.append(Pulled(name, wall, len(self.grains) - 1,
                                  Bridge(2 * radius, (ANGLES[2] + ANGLES[6]) / 2, WATER, volume, True)))

    def run(self, liquid, speed=SPEED, steps=2800, step=STEP, every=1, body="", **more):
        movers = [p.moves + 1 for p in self.pulled if isinstance(p.stays, int)]
        on_floor = [p.moves + 1 for p in self.pulled if p.stays == "floor"]
        self.speed, self.step = speed, step
        # Bridges take two steps to form; then off they go.
        return Wet(self.grains, liquid, types=6, step=step, every=every, files=[("plate.stl", plate())],
                   body=WALLS + body + f"""\
group movers id {" ".join(map(str, movers))}
group risers id {" ".join(map(str, on_floor))}""", run=f"""\
run 4
fix off movers move linear {speed} 0 0
fix up risers move linear 0 0 {speed}
fix down all move/mesh mesh plate linear 0 0 {-speed}
run {steps}""", size=0.07, skin=1.2e-3, **more)

    def gap(self, wet, one):
        if isinstance(one.stays, int):
            return wet.gaps(one.stays, one.moves)
        gap = wet.frames["z"][:, one.moves] - self.grains[one.moves].radius
        if one.stays == "plate":
            gap = gap + PLATE + self.speed * self.step * np.maximum(wet.steps - 4, 0)
        return gap

    def pull(self, wet, one):
        """Attraction that the moving grain feels [N]."""
        axis = "fx" if isinstance(one.stays, int) else "fz"
        return -wet.frames[axis][:, one.moves]
