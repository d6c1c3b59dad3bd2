"""Two spheres pulled apart with `cohesion bridge` and with stock LIGGGHTS's two models, and the curves of
docs/bridges-side-by-side.md."""

from pathlib import Path

import numpy as np

import stock_bridges as stock
from bridge_formulas import LAWS, Bridge, lian_rupture
from stock_bridges import DEGREE, EASO, WASHINO, run_stock
from wet_host import WATER, Grain, Wet
from young_laplace import of_pair

R = 1e-3
BOX = 0.02


def two(gap, film=0.0, radii=(R, R), **of_second):
    return [Grain((0, 0, 0), radii[0], film), Grain((radii[0] + radii[1] + gap, 0, 0), radii[1], film, 2, **of_second)]


def going(speed, steps, first=4):
    return {"body": "group b id 2", "run": f"run {first}\nfix off b move linear {speed} 0 0\nrun {steps}"}


def pull_of(wet):
    return -wet.frames["fx"][:, 1]


def ours(grains, degrees, law="willett", more="formation 2e-9", **motion):
    angles = " ".join(f"{d * DEGREE:.17g}" for d in degrees)
    return Wet(grains, f"film 0 gives 1 surface_tension {WATER} contact_angle {angles} law {law} every 100000 {more}",
               size=BOX, **motion)


def stock_pair(model, volume, degrees, gap=-1e-9, motion=None, radii=(R, R), **more):
    """Two grains whose bridge has this volume, the same liquid over volume on both."""
    content = volume / sum(stock.share(model, own, other) * 4 / 3 * np.pi * own**3
                           for own, other in (radii, radii[::-1]))
    return run_stock(model, two(gap, radii=radii), degrees, (content, content), size=BOX,
                     **(motion or going(0.1, 5000)), **more)


def at(wet, gap):
    """Attraction at the gap nearest to this one, the last of equals, and that gap."""
    gaps = wet.gaps(0, 1)
    k = len(gaps) - 1 - np.argmin(abs(gaps[::-1] - gap))
    return pull_of(wet)[k], gaps[k]


CURVES = ("willett", "willett_fit", "lian_toroid", "easo", "washino")


def compare(points=0):
    """Of two volumes and two contact angles: gaps and forces of all, as the programs computed them. points: so many
    gaps up to 0.6 of Lian's rupture distance; 0: all the way."""
    for v in (1e-3, 5e-2):
        for degrees in (10, 40):
            b = Bridge(R, degrees * DEGREE, WATER, v * R**3)
            rupture = lian_rupture(b)
            asked = rupture * (np.linspace(1e-3, 0.6, points) if points else np.linspace(2e-3, 1.25, 90))
            # 2e-6 m between two frames, the same ones in all runs
            motion = going(0.1, int(asked[-1] / 1e-7) + 20) | {"every": 20}
            row = {"v": v, "degrees": degrees}
            for name in CURVES:
                if name in LAWS:
                    wet = ours(two(1e-9, b.volume / 2), (degrees, degrees), name, **motion)
                else:
                    wet = stock_pair(EASO if name == "easo" else WASHINO, b.volume, (degrees, degrees), gap=-1e-9,
                                     motion=motion)
                gaps = wet.gaps(0, 1)
                frames = sorted({1 + int(np.argmin(abs(gaps[1:] - s))) for s in asked})
                row.setdefault("gap", gaps[frames])
                np.testing.assert_allclose(gaps[frames], row["gap"], atol=3e-9)
                row[name] = pull_of(wet)[frames]
            row["young_laplace"] = of_pair(b, row["gap"])
            yield row


def write(folder):
    import csv

    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    folder = Path(folder)
    rows = list(compare())
    (folder / "data").mkdir(parents=True, exist_ok=True)
    (folder / "images").mkdir(parents=True, exist_ok=True)
    names = ("young_laplace",) + CURVES
    with open(folder / "data" / "bridges-side-by-side.csv", "w", newline="", encoding="ascii") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(["volume_over_r3", "contact_angle_degree", "gap_m", *(name + "_N" for name in names)])
        for row in rows:
            for k, gap in enumerate(row["gap"]):
                out.writerow([row["v"], row["degrees"], f"{gap:.6g}", *(f"{row[name][k]:.6g}" for name in names)])
    looks = {"young_laplace": ("Young and Laplace", "k", "-", 3), "willett": ("ours: willett", "C0", "-", 1.5),
             "willett_fit": ("ours: willett_fit", "C2", "-", 1.5), "lian_toroid": ("ours: lian_toroid", "C9", "-", 1.5),
             "easo": ("stock: easo", "C1", "--", 1.8), "washino": ("stock: washino", "C3", "--", 1.8)}
    figure, axes = plt.subplots(2, 2, figsize=(10, 7.5), sharey=True)
    for axis, row in zip(axes.flat, rows):
        for name, (label, colour, line, width) in looks.items():
            force = np.array(row[name], dtype=float) / (2 * np.pi * R * WATER)
            force[force <= 0] = np.nan
            axis.plot(np.array(row["gap"]) / R, force, line, color=colour, lw=width, label=label)
        axis.set_title(f"$V / r^3$ = {row['v']:g}, contact angles {row['degrees']} degrees", fontsize=10)
        axis.set_xlim(0)
        axis.set_ylim(0, 1.25)
        axis.grid(alpha=0.3)
    for axis in axes[1]:
        axis.set_xlabel("gap / r")
    for axis in axes[:, 0]:
        axis.set_ylabel(r"force / $2 \pi r \gamma$")
    axes[0, 0].legend(fontsize=8)
    figure.tight_layout()
    figure.savefig(folder / "images" / "bridges-side-by-side.png", dpi=110)
