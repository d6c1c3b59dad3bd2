"""Pictures of injection into a channel, as figures 2 to 8 of the paper."""

import matplotlib.pyplot as plt
import numpy as np

from report_read import particle_files, read_particles

HALF_SLICE = 0.005  # m, of the parcels about the axis of the jet
AXIS = 0.045  # m, its y

VELOCITIES = {"liquid_velocity_m_s": ("-", "liquid"), "injected_velocity_m_s": ("-", "injected"),
              "equilibrium_velocity_m_s": ("--", "equilibrium"), "rms_velocity_m_s": (":", "rms")}
NAMES = {"case1": "1", "case2": "2: 100 um", "case3": "3: 40 %", "case4": "4: 10 m/s",
         "case5": "5: solid", "case1_fine": "1, fine grid"}
COLOURS = {name: f"C{n}" for n, name in enumerate(NAMES)}


def draw_velocities(axis, lines, of, injected="liquid_velocity_m_s"):
    for name in of:
        line = lines[name]
        for column in (injected, "equilibrium_velocity_m_s", "rms_velocity_m_s"):
            values = line[column]
            seen = values > 0.0
            style, what = VELOCITIES[column]
            axis.plot(100 * line["position_m"][seen], values[seen], style, color=COLOURS[name],
                      linewidth=1.2, label=f"{NAMES[name]}, {what}")
    axis.set(ylabel="velocity [m/s]", ylim=(0, None))


def draw_column(axis, lines, of, column, label):
    for name in of:
        line = lines[name]
        seen = line[column] > 0.0
        axis.semilogy(100 * line["position_m"][seen], line[column][seen], color=COLOURS[name],
                      linewidth=1.2, label=NAMES[name])
    axis.set(ylabel=label, ylim=(None, 10.0 ** np.ceil(np.log10(axis.get_ylim()[1] / 1.5))))


def finish(figure, file):
    for axis in figure.axes:
        axis.grid(alpha=0.3)
        axis.set(xlabel="distance from the nozzle [cm]", xlim=(0, 60))
        axis.legend(fontsize=7)
    figure.savefig(file, dpi=80, pil_kwargs={"optimize": True})
    plt.close(figure)


def draw_lines(lines, file):
    """What figures 3 to 8 show, of the cases that there are."""
    have = lambda *of: [name for name in of if name in lines]
    figure, axes = plt.subplots(3, 2, layout="constrained", figsize=(10, 11))
    draw_velocities(axes[0, 0], lines, have("case1", "case4"))
    draw_column(axes[0, 1], lines, have("case1", "case4"), "collision_time_s", "collision time [s]")
    draw_velocities(axes[1, 0], lines, have("case1", "case5"), "injected_velocity_m_s")
    draw_column(axes[1, 1], lines, have("case1", "case2", "case3", "case5"), "collision_time_s",
                "collision time [s]")
    draw_velocities(axes[2, 0], lines, have("case1", "case2"))
    draw_column(axes[2, 1], lines, have("case1", "case2", "case3", "case4"), "eta", "eta")
    for axis, figure_of_paper in zip(axes.flat, (3, 4, 5, 6, 7, 8)):
        axis.set_title(f"as figure {figure_of_paper}", fontsize=9)
    finish(figure, file)


def draw_grids(lines, file):
    """Case 1 on both grids."""
    of = ("case1", "case1_fine")
    figure, axes = plt.subplots(1, 3, layout="constrained", figsize=(12, 3.8))
    draw_velocities(axes[0], lines, of)
    draw_column(axes[1], lines, of, "collision_time_s", "collision time [s]")
    draw_column(axes[2], lines, of, "eta", "eta")
    finish(figure, file)


def draw_slices(folders, file):
    """Parcels about the vertical plane of the jet, by their speed, at the end of each run."""
    figure, axes = plt.subplots(len(folders), 1, squeeze=False, layout="constrained",
                                figsize=(9, 2.5 * len(folders) + 0.4))
    for axis, folder in zip(axes.flat, folders):
        time, particles = particle_files(folder)[-1]
        centres, _, speeds = read_particles(particles)
        near = np.abs(centres[:, 1] - AXIS) < HALF_SLICE
        order = np.argsort(speeds[near])
        dots = axis.scatter(100 * centres[near, 0][order], 100 * centres[near, 2][order],
                            c=speeds[near][order], s=min(6.0, 3e4 / near.sum()), linewidths=0,
                            cmap="turbo", vmin=1.0, vmax=5.0)
        axis.set(aspect="equal", xlim=(0, 60), ylim=(0, 15), ylabel="height [cm]")
        axis.set_title(f"{folder.rstrip('/').split('/')[-1]}, {time:.1f} s, "
                       f"{near.sum()} parcels", fontsize=9)
    axes[-1, 0].set_xlabel("distance from the nozzle [cm]")
    figure.colorbar(dots, ax=axes, fraction=0.03, pad=0.01, label="speed [m/s]")
    figure.savefig(file, dpi=80, pil_kwargs={"optimize": True})
    plt.close(figure)
