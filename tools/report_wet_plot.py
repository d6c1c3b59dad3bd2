"""Pictures of wet beds beside each other."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import EllipseCollection
from matplotlib.colors import ListedColormap, LogNorm

import report_clusters
from report_read import read_fields

SNAPSHOTS = 3
COLOURS = ListedColormap(plt.cm.turbo(np.linspace(0.08, 0.95, 256)))
ALONE = "#d9d9d9"


def draw_beds(runs, file):
    """A column a run, a row a time; grains that hold to no other are grey."""
    end = min(run.files[-1][0] for run in runs)
    times = end * (1.0 + np.arange(SNAPSHOTS)) / SNAPSHOTS
    top = max(np.max(run.history["bed_height_m"]) for run in runs)
    (x0, x1), _, (z0, _) = runs[0].box
    colours = LogNorm(2, max(run.count for run in runs))
    aspect = 1.05 * top / (x1 - x0)
    figure, axes = plt.subplots(SNAPSHOTS, len(runs), squeeze=False, sharex=True, sharey=True,
                                layout="constrained",
                                figsize=(1.8 * len(runs) + 1.4, SNAPSHOTS * 1.65 * aspect + 0.4))
    for column, run in zip(axes.T, runs):
        column[0].set_title(run.name(), fontsize=10)
        for axis, time in zip(column, times):
            at, particles = min(run.files, key=lambda entry: abs(entry[0] - time))
            draw_bed(axis, particles, run.holding.at(at), colours)
            axis.text(0.03, 0.97, f"{at:.2f} s", transform=axis.transAxes, va="top", fontsize=8)
            axis.set(xlim=(x0, x1), ylim=(z0, 1.05 * top), aspect="equal", xticks=[])
            axis.tick_params(labelsize=7)
    figure.supylabel("height [m]", fontsize=9)
    bar = figure.colorbar(plt.cm.ScalarMappable(colours, COLOURS), ax=axes, fraction=0.04, pad=0.01)
    bar.set_label("grains that have held together for 50 ms")
    figure.savefig(file, dpi=72, pil_kwargs={"optimize": True})
    plt.close(figure)


def draw_bed(axis, particles, sizes, colours):
    centres, fields = read_fields(particles)
    numbers = fields["id"][:, 0].astype(int)
    order = np.argsort(-centres[:, 1], kind="stable")  # the far ones first
    size = sizes[numbers - 1][order] if sizes is not None else np.ones(len(order))
    faces = np.where((size > 1)[:, None], COLOURS(colours(np.maximum(size, 2))),
                     plt.matplotlib.colors.to_rgba(ALONE))
    diameters = 2.0 * fields["radius"][order, 0]
    axis.add_collection(EllipseCollection(
        diameters, diameters, np.zeros(len(order)), units="xy", offsets=centres[order][:, [0, 2]],
        offset_transform=axis.transData, facecolors=faces, linewidths=0.15, edgecolors="black"))


def draw_time(runs, begin, density, file):
    figure, axes = plt.subplots(3, 2, layout="constrained", figsize=(10, 8))
    (drop, height), (energy, size), (bridges, sizes) = axes
    for n, run in enumerate(runs):
        style = {"color": f"C{n}", "linewidth": 1.1, "label": run.name()}
        time, pressure = run.pressure_drop()
        drop.plot(time, pressure / run.weight(density), **style)
        height.plot(time, 1e3 * run.history["bed_height_m"], **style)
        energy.semilogy(time, 1e6 * run.history["kinetic_energy_J"], **style)
        holding = run.holding
        late = holding.times >= 0.0
        mean = holding.of_each(report_clusters.mean_size)
        size.semilogy(holding.times[late], mean[late], **style)
        bridges.plot(holding.times[late], 2.0 * holding.bridges[late] / run.count, **style)
        draw_sizes(sizes, run, begin, style)
    drop.set(ylabel="pressure drop / weight", ylim=(0.5, 1.4))
    height.set(ylabel="bed height [mm]")
    energy.set(ylabel="kinetic energy [uJ]", ylim=(10.0, None))
    size.set(ylabel="agglomerate, mean [grains]")
    bridges.set(ylabel="bridges of a grain")
    sizes.set(xscale="log", xlabel="agglomerate of up to [grains]", ylabel="share of the grains",
              ylim=(0, 1.02))
    sizes.legend(fontsize=8)
    for axis in axes.flat:
        axis.grid(alpha=0.3)
        if axis is not sizes:
            axis.set_xlabel("time [s]", fontsize=8)
    figure.savefig(file, dpi=80)
    plt.close(figure)


def draw_sizes(axis, run, begin, style):
    """Share of the grains whose agglomerate is no larger than this, from `begin` on."""
    holding = run.holding
    found = [s for t, s in zip(holding.times, holding.sizes) if t >= begin and s is not None]
    if not found:
        return
    ordered = np.sort(np.concatenate(found))
    axis.step(ordered, (1.0 + np.arange(len(ordered))) / len(ordered), where="post", **style)
