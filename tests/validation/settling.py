#!/usr/bin/python3
"""A suspension settles in a closed column, through both programs, against Richardson & Zaki (1954).

What sinks displaces fluid upwards: in a closed column the velocity of the grains is the superficial
slip, V = eps |u - v| = v_t eps^n. Beside it stands what the drag law itself gives for grains spread
evenly, K |u - v| = eps V_p (rho_p - rho) g, so that the error is known to be the law's or the code's.

  settling.py build           the test
  settling.py build --full    the study of docs/validation.md: its data and its picture
  settling.py build --plot    the picture, from the data
"""

import math
import unittest
from dataclasses import dataclass

import numpy as np

from suspension import (DOCS, GRAVITY, Run, gas_toml, grains_data, main, random_spheres, read_csv, script,
                        write_csv)

GRAIN = 2500.0          # kg/m3
MIDDLE = (0.35, 0.65)   # of the column: what is looked at, above the sediment, below the front
WINDOW = 3.0            # diameters of fall looked at
RELAXATIONS = 3         # of a grain's velocity, before it


@dataclass(frozen=True)
class Case:
    """Lengths in diameters; the fluid of given density and viscosity, the diameter follows."""
    archimedes: float = 100.0
    solids: float = 0.15
    density: float = 1000.0
    viscosity: float = 1e-3
    law: str = "di_felice"
    method: str = "trilinear"
    size: tuple = (12, 12, 48)
    cell: float = 3.0
    seed: int = 1
    fall: float = 0.0        # how far, if further than the window
    fluidised: bool = False  # fluid comes from below with the velocity of Richardson and Zaki

    @property
    def diameter(self):
        return (self.archimedes * self.viscosity**2
                / (GRAVITY * self.density * (GRAIN - self.density)))**(1 / 3)


def drag_di_felice(eps, re):
    root = 0.63 * math.sqrt(re) + 4.8
    power = 3.7 - 0.65 * math.exp(-0.5 * (1.5 - math.log10(max(re, 1e-12)))**2)
    return eps * eps**-power * root**2 / 24


def drag_ergun_wen_yu(eps, re):
    if eps < 0.8:
        return (150 * (1 - eps) + 1.75 * re) / (18 * eps)
    return eps**-2.65 * (1 + 0.15 * re**0.687 if re < 1000 else 0.44 * re / 24)


def drag_koch_hill(eps, re):
    s = 1 - eps
    if s < 0.4:
        f0 = 1 + 3 * math.sqrt(s / 2) + 16.14 * s
        f0 += 135 / 64 * s * math.log(s) if s > 0 else 0
        f0 /= 1 + 0.681 * s - 8.48 * s**2 + 8.16 * s**3
    else:
        f0 = 10 * s / eps**3
    return eps**2 * (f0 + (0.0673 + 0.212 * s + 0.0232 / eps**5) * re / 2)


# K / (3 pi mu d) over void fraction and superficial Reynolds number, as in docs/exchange.md; written
# again here, so that the code's own is tested.
LAWS = {"di_felice": drag_di_felice, "ergun_wen_yu": drag_ergun_wen_yu, "koch_hill": drag_koch_hill}


def settling_reynolds(law, eps, archimedes):
    """Re = rho V d / mu with 18 f(eps, Re) Re = eps^2 Ar, by bisection."""
    low, high = 1e-9, 1e6
    for _ in range(200):
        middle = math.sqrt(low * high)
        surplus = 18 * LAWS[law](eps, middle) * middle > eps**2 * archimedes
        low, high = (low, middle) if surplus else (middle, high)
    return low


def richardson_zaki_exponent(re):
    """J.F. Richardson, W.N. Zaki, Trans. Inst. Chem. Eng. 32 (1954) 35, no walls; Re_t of one grain."""
    if re < 0.2:
        return 4.65
    if re < 1:
        return 4.35 * re**-0.03
    return 4.45 * re**-0.1 if re < 500 else 2.39


def predictions(case, solids):
    """Re_t; V / v_t after Richardson and Zaki; V / v_t of the drag law."""
    re_t = settling_reynolds(case.law, 1.0, case.archimedes)
    return (re_t, (1 - solids)**richardson_zaki_exponent(re_t),
            settling_reynolds(case.law, 1 - solids, case.archimedes) / re_t)


def input_files(case):
    d, eps = case.diameter, 1 - case.solids
    re_t, zaki, _ = predictions(case, case.solids)
    v_t = re_t * case.viscosity / (case.density * d)
    # m / K of a grain that settles, and of one in the sediment: how fast it takes on a new velocity
    buoyancy = (1 - case.density / GRAIN) * GRAVITY
    relaxation = v_t * zaki / (eps**2 * buoyancy)
    sediment = v_t * settling_reynolds(case.law, 0.36, case.archimedes) / re_t / (0.36**2 * buoyancy)
    step = min(0.004 * d / v_t, 0.1 * relaxation, 0.1 * sediment)
    every = max(1, min(10, int(0.4 * sediment / step)))
    # Grains that rest in the rising fluid have the velocity they need.
    start = 1.0 if case.fluidised else max(1.0, RELAXATIONS * relaxation * v_t * zaki / d)
    seconds = (1.15 * start + max(WINDOW, case.fall)) * d / (v_t * zaki)
    frames = 200 if case.fall else 60
    between = math.ceil(seconds / (frames * every * step)) * every
    size = [s * d for s in case.size]
    mass = GRAIN * math.pi / 6 * d**3
    count = round(case.solids * math.prod(case.size) * 6 / math.pi)
    inflow = v_t * zaki if case.fluidised else 0.0
    more = f'z_hi = "outlet"\n[[inflow]]\nside = "z_lo"\nvelocity = {inflow!r}\n'
    text = script(d, mass, step, 0, 0.0, size[2]) + f"""\
fix gas all couple/gas every {every} output out void_fraction {case.method} drag {case.law} &
    pressure_gradient
dump view all custom {between} grains.dump id z vz
dump_modify view sort id
run {frames * between}
"""
    cells = [round(s / case.cell) for s in case.size]
    centres = random_spheres(count, case.size, case.seed) * d
    files = {"grains.data": grains_data(centres, size, d, GRAIN),
             "in.liggghts": text,
             "gas.toml": gas_toml(size, cells, case.density, case.viscosity, every * step,
                                  more if case.fluidised else "")}
    return files, {"v_t": v_t, "step": step, "start": start, "inflow": inflow}


def measure(case):
    """Result of the window, and (diameters fallen, solids, V / v_t, its spread) over time."""
    files, made = input_files(case)
    with Run(files) as run:
        frames = list(run.frames())
        residual = float(run.history()["ledger_residual"][-1])
        seconds = run.seconds
    d = case.diameter
    height = case.size[2] * d
    fallen, series, before, last_speed = 0.0, [], 0.0, 0.0
    for step, rows in frames:
        z, speed = rows[:, 1] / height, made["inflow"] - rows[:, 2]
        middle = (z > MIDDLE[0]) & (z < MIDDLE[1])
        mean = float(speed[middle].mean())
        fallen += 0.5 * (mean + last_speed) * (step * made["step"] - before) / d
        before, last_speed = step * made["step"], mean
        solids = middle.sum() * math.pi / 6 / (math.prod(case.size) * (MIDDLE[1] - MIDDLE[0]))
        series.append((fallen, float(solids), mean / made["v_t"],
                       float(speed[middle].std() / made["v_t"])))
    series = np.array(series)
    inside = (series[:, 0] >= made["start"]) & (series[:, 0] <= made["start"] + WINDOW)
    _, solids, speed, spread = series[inside].mean(axis=0)
    re_t, zaki, law = predictions(case, solids)
    result = {"Re_t": re_t, "law": case.law, "method": case.method, "cell_by_d": case.cell,
              "density_ratio": GRAIN / case.density,
              "solids": float(solids), "exponent": richardson_zaki_exponent(re_t),
              "measured": float(speed), "richardson_zaki": zaki, "of_law": law,
              "error": float(speed / zaki - 1), "error_of_law": law / zaki - 1,
              "error_of_code": float(speed / law - 1), "spread": float(spread / speed),
              "seed": case.seed, "grains": len(frames[0][1]), "fallen_from_d": made["start"],
              "seconds": seconds, "ledger_residual": residual}
    return result, series


def described(r):
    return (f"Re_t {r['Re_t']:.3g}, {r['law']}, solids {r['solids']:.4f}: V / v_t {r['measured']:.4f}, "
            f"Richardson and Zaki {r['richardson_zaki']:.4f} ({r['error']:+.1%}: "
            f"law {r['error_of_law']:+.1%}, code {r['error_of_code']:+.1%}), "
            f"spread of V {r['spread']:.1%}; from {r['fallen_from_d']:.1f} d on, {r['seconds']:.0f} s")


class Settling(unittest.TestCase):
    def test_hindered_settling_is_richardson_and_zaki_s(self):
        for solids in (0.05, 0.15, 0.3):
            with self.subTest(solids=solids):
                result, _ = measure(Case(solids=solids))
                print(described(result))
                self.assertLess(abs(result["error"]), 0.10)
                # Grains that stand at random see other void fractions than the mean one.
                self.assertLess(abs(result["error_of_code"]), 0.03)
                self.assertLess(result["ledger_residual"], 1e-8)


ARCHIMEDES = (10.0, 100.0, 1e4)
SOLIDS = (0.05, 0.1, 0.15, 0.2, 0.3)
FEW = (0.05, 0.15, 0.3)
EVEN = [Case(archimedes=ar, solids=s) for ar in ARCHIMEDES for s in SOLIDS]
VARIED = [Case(solids=s, **change) for change in (
    {"cell": 2.0}, {"method": "exact"}, {"law": "koch_hill"}, {"law": "ergun_wen_yu"}) for s in FEW]
AIR = {"density": 1.2, "viscosity": 18.27e-6}
LONG = [Case(solids=0.05, size=(12, 12, 64), fall=300.0, fluidised=True, **fluid)
        for fluid in ({}, AIR)]
DATA = DOCS / "data" / "settling.csv"
SERIES = DOCS / "data" / "settling-clusters.csv"
PICTURE = DOCS / "images" / "settling.png"


def study():
    results, fall = [], []
    for case in EVEN + LONG + VARIED:
        result, series = measure(case)
        print(described(result), flush=True)
        if case not in LONG:
            results.append(result)
            write_csv(DATA, results)
            continue
        for fallen, solids, speed, spread in series.tolist():
            fall.append({
                "density_ratio": GRAIN / case.density, "solids_at_first": case.solids,
                "fallen_by_d": fallen, "solids": solids, "spread_by_V": spread / speed,
                "V_by_richardson_zaki": speed / predictions(case, solids)[1]})
        write_csv(SERIES, fall)


def plot():
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    colours = dict(zip(ARCHIMEDES, ("#4c72b0", "#55a868", "#c44e52")))
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4.6))
    solids = np.linspace(0, 0.35, 71)
    results = read_csv(DATA)[:len(EVEN)]
    for archimedes in ARCHIMEDES:
        case = Case(archimedes=archimedes)
        own = [r for made, r in zip(EVEN, results) if made.archimedes == archimedes]
        expected = np.array([predictions(case, s)[1:] for s in solids])
        left.semilogy(solids, expected[:, 0], "-", lw=1.2, color=colours[archimedes])
        left.semilogy(solids, expected[:, 1], "--", lw=1.0, color=colours[archimedes])
        left.semilogy([r["solids"] for r in own], [r["measured"] for r in own], "o", ms=4.5,
                      color=colours[archimedes],
                      label=f"Re_t = {own[0]['Re_t']:.3g}, n = {own[0]['exponent']:.2f}")
    left.plot([], [], "-", color="black", lw=1.2, label="Richardson and Zaki")
    left.plot([], [], "--", color="black", lw=1.0, label="di_felice, grains spread evenly")
    left.set(xlabel="share of solids", ylabel="settling velocity / terminal velocity",
             title="closed column, density ratio 2.5", xlim=(0, 0.35))
    left.set_yticks([0.2, 0.3, 0.5, 0.7, 1.0], ["0.2", "0.3", "0.5", "0.7", "1"])
    left.minorticks_off()
    left.legend(fontsize=8.5, frameon=False, loc="lower left")

    fall = read_csv(SERIES)
    for ratio, colour in zip(dict.fromkeys(row["density_ratio"] for row in fall),
                             ("#4c72b0", "#c44e52")):
        own = [row for row in fall if row["density_ratio"] == ratio]
        right.plot([r["fallen_by_d"] for r in own], [r["V_by_richardson_zaki"] for r in own],
                   lw=1.3, color=colour, label=f"density ratio {ratio:.4g}, solids 0.05")
    right.axhline(1, color="black", lw=0.8)
    for bound in (0.9, 1.1):
        right.axhline(bound, color="black", lw=0.8, ls=":")
    right.set(xlabel="way through the fluid / diameter", ylabel="V / Richardson and Zaki",
              xlim=(0, 300), ylim=(0.88, 1.18),
              title="fluidised with that velocity: clusters")
    right.legend(fontsize=8.5, frameon=False, loc="upper left")
    figure.tight_layout()
    figure.savefig(PICTURE, dpi=110)


if __name__ == "__main__":
    main(study, plot)
