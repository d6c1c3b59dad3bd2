"""bed.png: the particles from the front at some times of the gas stage, and their ParaView index."""

import json
import math
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import EllipseCollection
from matplotlib.colors import ListedColormap, Normalize
from matplotlib.patches import Rectangle

from report_read import ReportError, particle_files, read_box, read_particles

MOST_SNAPSHOTS = 8
PAGE = (13.0, 8.0)  # inches the panels share
# Without its darkest ends the outlines of the particles stay visible.
COLOURS = ListedColormap(plt.cm.turbo(np.linspace(0.08, 0.95, 256)))


def write_series(folder):
    """particles.vtk.series: ParaView opens it with the times of gas.xdmf."""
    files = [{"name": f"particles/{file.name}", "time": time}
             for time, file in particle_files(folder)]
    series = {"file-series-version": "1.0", "files": files}
    (Path(folder) / "particles.vtk.series").write_text(json.dumps(series, indent=1) + "\n")


def pick(files):
    """Files nearest to equally spaced times from the first to the last of the gas stage."""
    gas_stage = [entry for entry in files if entry[0] >= 0.0]
    if not gas_stage:
        raise ReportError("no particle file was written after the start of the gas")
    times = np.array([time for time, _ in gas_stage])
    wanted = np.linspace(times[0], times[-1], min(MOST_SNAPSHOTS, len(times)))
    picked = sorted({int(np.argmin(np.abs(times - time))) for time in wanted})
    return [gas_stage[n] for n in picked]


def view(snapshots, box):
    """(x lo, x hi, z lo, z hi) [m]: the box's width, the height that particles reached."""
    filled = [(centres, radii) for _, centres, radii, _ in snapshots if len(radii)]
    if not filled:
        raise ReportError("the particle files hold no particles")
    lo = np.min([np.min(centres - radii[:, None], axis=0) for centres, radii in filled], axis=0)
    hi = np.max([np.max(centres + radii[:, None], axis=0) for centres, radii in filled], axis=0)
    top = hi[2] + 0.03 * (hi[2] - lo[2])
    if box is None:
        return lo[0], hi[0], lo[2], top
    return box[0][0], box[0][1], box[2][0], min(top, box[2][1])


def layout(count, aspect):
    """(rows, columns, panel width, panel height) [inches] of the largest panels on a page."""
    best = None
    for rows in range(1, count + 1):
        columns = math.ceil(count / rows)
        width = min(PAGE[0] / columns, PAGE[1] / rows / aspect)
        if best is None or width > best[2]:
            best = (rows, columns, width, width * aspect)
    return best


def draw_snapshot(axis, snapshot, frame, box, colours):
    time, centres, radii, speeds = snapshot
    order = np.argsort(-centres[:, 1], kind="stable")  # the far ones first
    diameters = 2.0 * radii[order]
    axis.add_collection(EllipseCollection(
        diameters, diameters, np.zeros(len(order)), units="xy", offsets=centres[order][:, [0, 2]],
        offset_transform=axis.transData, array=speeds[order], norm=colours, cmap=COLOURS,
        linewidths=0.15, edgecolors="black"))
    x_lo, x_hi, z_lo, z_hi = frame
    if box is not None:
        (x0, x1), _, (z0, z1) = box
        axis.add_patch(Rectangle((x0, z0), x1 - x0, z1 - z0, fill=False, linewidth=1.0,
                                 clip_on=z1 > z_hi))
    margin = 0.02 * (x_hi - x_lo)
    axis.set_xlim(x_lo - margin, x_hi + margin)
    axis.set_ylim(z_lo - margin, z_hi)
    axis.set_aspect("equal")
    for side in ("top", "right", "left", "bottom"):
        axis.spines[side].set_visible(False)
    axis.tick_params(labelsize=7)
    axis.set_xlabel(f"t = {time:.3f} s", fontsize=10)


def draw(folder):
    files = pick(particle_files(folder))
    snapshots = [(time, *read_particles(file)) for time, file in files]
    box = read_box(files[0][1])
    frame = view(snapshots, box)
    # A few particles thrown out must not take the colours from all others.
    fastest = max(np.percentile(speeds, 99.5) if len(speeds) else 0.0 for *_, speeds in snapshots)
    colours = Normalize(0.0, fastest or 1.0)

    rows, columns, width, height = layout(len(snapshots),
                                          (frame[3] - frame[2]) / (frame[1] - frame[0]))
    figure, axes = plt.subplots(rows, columns, squeeze=False, layout="constrained", sharex=True,
                                sharey=True,
                                figsize=(columns * width + 1.6, rows * (height + 0.5) + 0.3))
    for axis in axes.flat[len(snapshots):]:
        axis.set_visible(False)
    for axis, snapshot in zip(axes.flat, snapshots):
        draw_snapshot(axis, snapshot, frame, box, colours)
        axis.tick_params(labelbottom=False, bottom=False)
    for axis in axes[:, 0]:
        axis.set_ylabel("height [m]")
    bar = figure.colorbar(plt.cm.ScalarMappable(colours, COLOURS), ax=axes, extend="max",
                          fraction=0.03, pad=0.01)
    bar.set_label("particle speed [m/s]")
    figure.savefig(Path(folder) / "bed.png", dpi=160)
    plt.close(figure)
