#!/usr/bin/python3
"""The picture of a measurement: what was measured, over the curve it was read from.

    tools/measure_plot.py DIR [PICTURE.png]
        reads DIR/measured.json and DIR/measured_curve.csv, writes DIR/measured.png
"""

import csv
import json
import math
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

BLUE, ORANGE, GREY = "#4c72b0", "#dd8452", "#999999"


def read_curve(folder):
    """Columns of measured_curve.csv by name, in their order; an empty field is NaN."""
    with open(folder / "measured_curve.csv", newline="", encoding="utf-8") as file:
        lines = list(csv.reader(file))
    if not lines:
        raise SystemExit(f"{folder}/measured_curve.csv is empty")
    return {name: [float(line[n]) if line[n] else math.nan for line in lines[1:]]
            for n, name in enumerate(lines[0])}


def last_grains(file):
    """Columns of the last frame of a dump, by name; nothing when there is no such file."""
    if not file.exists():
        return {}
    heading, *lines = file.read_text(encoding="utf-8").split("ITEM: ATOMS ")[-1].splitlines()
    rows = [[float(word) for word in line.split()] for line in lines]
    return dict(zip(heading.split(), zip(*rows)))


def side_view(axis, grains, title):
    """Grains seen along y, the near ones light and in front."""
    if not grains:
        axis.set_axis_off()
        return
    order = sorted(range(len(grains["y"])), key=lambda n: -grains["y"][n])
    near, far = min(grains["y"]), max(grains["y"])
    for n in order:
        shade = 0.88 - 0.55 * (grains["y"][n] - near) / max(far - near, 1e-30)
        axis.add_patch(plt.Circle((grains["x"][n], grains["z"][n]), grains["radius"][n],
                                  fc=str(shade), ec="#555555", lw=0.2))
    axis.autoscale_view()
    axis.set_aspect("equal")
    axis.set_xlabel("x [m]")
    axis.set_ylabel("z [m]")
    axis.set_title(title, fontsize=9)


def slope(dump, title, distance):
    def draw(axes, curve, folder, _):
        side_view(axes[0], last_grains(folder / dump), title)
        axes[1].plot(curve["distance_m"], curve["height_m"], "o-", ms=4, lw=1, color=BLUE,
                     label="seen from above, mean")
        axes[1].plot(curve["distance_m"], curve["line_m"], lw=2, color=ORANGE,
                     label="flank, fitted")
        axes[1].set_xlabel(distance)
        axes[1].set_ylabel("height [m]")
        axes[1].set_aspect("equal")
    return draw


def drum(axes, curve, folder, quantities):
    side_view(axes[0], last_grains(folder / "particles/drum.dump"), "the last frame")
    axes[1].plot(curve["step"], curve["angle_degree"], lw=1, color=BLUE, label="each frame")
    axes[1].axhline(quantities["dynamic_angle"]["value"], color=ORANGE, label="mean")
    axes[1].set_xlabel("step")
    axes[1].set_ylabel("inclination of the surface [degree]")


def bounce(axes, curve, _, quantities):
    axes[0].plot(curve["impact_speed_m_s"], curve["normal_restitution"], "o", color=BLUE,
                 label="each grain")
    axes[0].axhline(quantities["normal_restitution"]["value"], color=ORANGE, label="mean")
    axes[0].set_xlabel("impact speed [m/s]")
    axes[0].set_ylabel("normal restitution")
    axes[0].set_ylim(0, 1.05)
    mean = quantities["normal_restitution"]["value"]
    axes[1].plot(curve["impact_speed_m_s"],
                 [1e3 * (e - mean) for e in curve["normal_restitution"]], "o", color=BLUE)
    axes[1].axhline(0, color=ORANGE)
    axes[1].set_xlabel("impact speed [m/s]")
    axes[1].set_ylabel("difference from the mean [1e-3]")


def impact(axes, curve, _, quantities):
    angle = curve["impact_angle_degree"]
    axes[0].plot(angle, curve["tangential_restitution"], "o", ms=4, color=BLUE,
                 label="tangential restitution")
    axes[0].plot(angle, curve["normal_restitution"], "s", ms=3, color=GREY,
                 label="normal restitution")
    axes[0].plot(angle, curve["sliding_line"], color=ORANGE, label="sliding throughout")
    axes[0].axhline(5 / 7, color=GREY, ls=":", label="rolls away: 5/7")
    axes[0].set_ylim(0, 1.15)
    axes[0].set_xlabel("angle of incidence [degree]")
    axes[1].plot(angle, curve["rebound_angle_degree"], "o", ms=4, color=BLUE,
                 label="rebound angle")
    axes[1].set_xlabel("angle of incidence [degree]")
    axes[1].set_ylabel("rebound angle [degree]")
    spin = axes[1].twinx()
    spin.plot(angle, curve["rebound_spin_rad_s"], "^", ms=4, color="#55a868")
    spin.set_ylabel("rebound spin [rad/s] (triangles)")


def compression(axes, curve, folder, _):
    axes[0].plot(curve["strain"], curve["stress_Pa"], lw=1, color=BLUE, label="read")
    axes[0].plot(curve["strain"], curve["line_Pa"], lw=2, color=ORANGE, label="fitted")
    axes[0].set_xlabel("strain from the lower stress on")
    axes[0].set_ylabel("stress on the upper plate [Pa]")
    side_view(axes[1], last_grains(folder / "particles/grains.dump"), "the end")


def shear(axes, curve, folder, quantities):
    axes[0].plot(curve["shear_strain"], curve["stress_ratio"], lw=0.8, color=BLUE, label="read")
    axes[0].axhline(math.tan(math.radians(quantities["internal_friction_angle"]["value"])),
                    color=ORANGE, label="mean of steady shear")
    axes[0].set_xlabel("shear strain")
    axes[0].set_ylabel("shear over normal stress")
    side_view(axes[1], last_grains(folder / "particles/grains.dump"), "the end")


def pull(axes, curve, _, quantities):
    gap = [1e6 * one for one in curve["gap_m"]]
    for axis, scale in zip(axes, ("linear", "log")):
        shown = [force if force > 0 or scale == "linear" else math.nan
                 for force in curve["force_N"]]
        axis.plot(gap, shown, lw=1.5, color=BLUE, label="attraction")
        axis.axvline(1e6 * quantities["rupture_distance"]["value"], color=ORANGE, label="rupture")
        axis.set_yscale(scale)
        axis.set_xlabel("gap [um]")
        axis.set_ylabel("force [N]")


def fragments(axes, curve, folder, _):
    axes[0].step(curve["fragment_size"], curve["share_of_grains_up_to_it"], where="post", lw=1.5,
                 color=BLUE, label="grains in fragments of up to this size")
    axes[0].set_xscale("log")
    axes[0].set_ylim(0, 1.02)
    axes[0].set_xlabel("size of a fragment [grains]")
    axes[0].set_ylabel("share of all grains")
    side_view(axes[1], last_grains(folder / "particles/grains.dump"), "after the impact")


# A kind of measurement: the function that draws it, on two axes.
KINDS = {
    "angle_of_repose": slope("particles/heap.dump", "the heap from the side",
                             "distance from the axis [m]"),
    "drained_angle": slope("particles/slope.dump", "what the box keeps",
                           "distance from the wall [m]"),
    "dynamic_angle": drum,
    "normal_restitution": bounce,
    "oblique_impact": impact,
    "constrained_modulus": compression,
    "internal_friction": shear,
    "force_distance": pull,
    "fragments": fragments,
}


def main(folder, target):
    measured = json.loads((folder / "measured.json").read_text(encoding="utf-8"))
    if measured["kind"] not in KINDS:
        raise SystemExit(f"{folder}/measured.json: no picture is known for the kind "
                         f"{measured['kind']}")
    quantities = {one["name"]: one for one in measured["quantities"]}
    figure, axes = plt.subplots(1, 2, figsize=(11, 4.4))
    KINDS[measured["kind"]](axes, read_curve(folder), folder, quantities)
    for axis in axes:
        axis.grid(True, color="#e5e5e5")
        axis.set_axisbelow(True)
        if axis.get_legend_handles_labels()[0]:
            axis.legend(fontsize=8.5, frameon=False)
    few = 3
    figure.suptitle("     ".join(text_of(one) for one in measured["quantities"]),
                    fontsize=10 if len(measured["quantities"]) <= few else 8.5)
    figure.tight_layout()
    figure.savefig(target, dpi=90)


def text_of(one):
    unit = "" if one["unit"] == "1" else " " + one["unit"]
    spread = f" ± {one['uncertainty']:.2g}" if one["uncertainty"] else ""
    return f"{one['name']} {one['value']:.4g}{spread}{unit}"


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    where = Path(sys.argv[1])
    main(where, Path(sys.argv[2]) if len(sys.argv) == 3 else where / "measured.png")
