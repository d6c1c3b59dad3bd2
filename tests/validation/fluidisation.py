#!/usr/bin/python3
"""Minimum fluidisation: a bed of spheres in a flow that is slowly turned down, through both programs.

The pressure drop of the fixed bed, extrapolated to the bed's weight less buoyancy, gives u_mf; Ergun's
equation at the void fraction that the bed then has gives the reference. Above u_mf the fluid carries
the weight.

  fluidisation.py build           the test
  fluidisation.py build --full    the study of docs/validation.md: its data and its picture
  fluidisation.py build --plot    the picture, from the data
"""

import math
import unittest
from dataclasses import dataclass

import numpy as np

from suspension import (DOCS, GRAVITY, LEAST_STEPS_A_CONTACT, Run, gas_toml, grains_data, main,
                        random_spheres, read_csv, script, write_csv)

GRAIN = 2500.0       # kg/m3
FRICTION = 0.3
FIXED = (0.5, 0.85)  # of u_mf: the fixed bed that is extrapolated
ENDS = 2.0           # diameters next to floor and surface that the void fraction leaves out
TAPS = (0.2, 0.8)    # of the bed's height: pressures within the bed


@dataclass(frozen=True)
class Case:
    """Lengths in diameters, velocities in Ergun's u_mf at a void fraction of 0.39, times in s."""
    name: str = "water 2.5 mm"
    diameter: float = 2.5e-3
    density: float = 1000.0
    viscosity: float = 1e-3
    grains: int = 1130
    width: int = 6
    cell: tuple = (2.0, 1.0)     # along x and y; along z
    method: str = "exact"
    overlap: float = 0.004       # of the lowest grain under the bed's weight: more, and the bed swells
    #                              as the flow lifts it, 0.02 by 1 % of its void fraction
    greatest: float = 2.0        # velocity at first
    turn: float = 1.15           # down to this soon, then slowly: a bed in water sinks for seconds
    least: float = 0.5           # and at the end
    hold: float = 0.8            # at the greatest velocity
    fall: float = 4.0
    interval: float = 1e-3
    headroom: float = 2.0        # height above the floor over that of the bed


def ergun(velocity, eps, case):
    """Pressure gradient [Pa/m], S. Ergun, Chem. Eng. Prog. 48 (1952) 89, superficial velocity."""
    return (150 * (1 - eps)**2 / eps**3 * case.viscosity * velocity / case.diameter**2
            + 1.75 * (1 - eps) / eps**3 * case.density * velocity**2 / case.diameter)


def where_it_carries(linear, square, weight):
    """Root of linear U + square U^2 = weight."""
    return (-linear + math.sqrt(linear**2 + 4 * square * weight)) / (2 * square)


def ergun_u_mf(eps, case):
    linear = 150 * (1 - eps)**2 / eps**3 * case.viscosity / case.diameter**2
    square = 1.75 * (1 - eps) / eps**3 * case.density / case.diameter
    return where_it_carries(linear, square, (1 - eps) * (GRAIN - case.density) * GRAVITY)


def wen_yu_u_mf(case):
    """C.Y. Wen, Y.H. Yu, AIChE J. 12 (1966) 610: no void fraction needed."""
    archimedes = (GRAVITY * case.diameter**3 * case.density * (GRAIN - case.density)
                  / case.viscosity**2)
    reynolds = math.sqrt(33.7**2 + 0.0408 * archimedes) - 33.7
    return reynolds * case.viscosity / (case.density * case.diameter)


def solid_volume_below(heights, centres):
    """Of spheres of diameter 1, exactly, under each height."""
    depth = np.clip(np.subtract.outer(heights, np.asarray(centres) - 0.5), 0, 1)
    return (math.pi / 3 * depth**2 * (1.5 - depth)).sum(axis=-1)


def fit_fixed_bed(velocity, pressure):
    """The two coefficients of pressure = a U + b U^2."""
    return np.linalg.lstsq(np.stack([velocity, velocity**2], 1), pressure, rcond=None)[0]


def input_files(case, seed=1):
    d = case.diameter
    lateral, height = case.cell
    loose = case.grains * math.pi / 6 / 0.3 / case.width**2
    bed = case.grains * math.pi / 6 / 0.6 / case.width**2
    floor = max(2, math.ceil(2 / height)) * height
    layers = math.ceil((floor + max(case.headroom * bed, loose + 1)) / height)
    size = [case.width * d, case.width * d, layers * height * d]

    centres = random_spheres(case.grains, (case.width, case.width, loose), seed)
    centres[:, 2] += floor
    mass = GRAIN * math.pi / 6 * d**3
    weight = mass * GRAVITY * (1 - case.density / GRAIN) * bed
    contact = math.pi * math.sqrt(0.5 * mass * case.overlap * d / weight)
    every = math.ceil(case.interval * LEAST_STEPS_A_CONTACT / contact)
    step = case.interval / every
    packing = round(0.1 * math.sqrt(d / 1e-3) / case.interval) * every
    running = round((case.hold + case.fall) / case.interval) * every
    u = ergun_u_mf(0.39, case)
    probes = np.unique(np.linspace(0, (floor + bed) / height, 16).astype(int))
    text = script(d, mass, step, FRICTION, floor * d, size[2]) + f"""\
compute floor all reduce sum f_force_z_lo[3]
fix floor_force all ave/time 5 100 500 c_floor file floor.txt
fix calm all viscous {mass / 0.02!r}
fix gas all couple/gas every {every} start {packing} output out void_fraction {case.method} &
    drag ergun_wen_yu pressure_gradient
run {packing}
unfix calm
dump view all custom {running // 100} grains.dump id z vz
dump_modify view sort id
run {running}
"""
    # At once, but not as a blow: the bed would rise as a plug.
    table = [[0.0, 0.0], [0.2 * case.hold, case.greatest], [case.hold, case.greatest],
             [case.hold + 0.1 * case.fall, case.turn], [case.hold + case.fall, case.least]]
    more = (f'z_hi = "outlet"\n[[inflow]]\nside = "z_lo"\nvelocity = {u!r}\ntable = {table}\n[output]\n'
            f"pressure_probes = {[round((k + 0.5) * height * d, 9) for k in probes.tolist()]}\n")
    cells = [round(case.width / lateral)] * 2 + [layers]
    return {"grains.data": grains_data(centres * d, size, d, GRAIN), "in.liggghts": text,
            "gas.toml": gas_toml(size, cells, case.density, case.viscosity, case.interval, more),
            }, {"floor": floor, "top": size[2], "step": step, "packing": packing, "table": table,
                "velocity": u, "probes": (probes + 0.5) * height, "mass": mass}


def measure(case, seed=1):
    files, made = input_files(case, seed)
    with Run(files) as run:
        history = run.history()
        frames = [(step, rows[:, 1:].copy()) for step, rows in run.frames()]
        floor_force = np.loadtxt(run.folder / "floor.txt")
        seconds = run.seconds
    d, times = case.diameter, np.array(made["table"])
    time_s = history["time_s"]
    velocity = made["velocity"] * np.interp(time_s, times[:, 0], times[:, 1])
    area = (case.width * d)**2
    weight = case.grains * made["mass"] * (1 - case.density / GRAIN) * GRAVITY / area
    columns = [key for key in history if key.startswith("p_")]
    # Without the fluid's own weight
    drop = history[columns[0]] - case.density * GRAVITY * (made["top"] - made["probes"][0] * d)
    falling = time_s > case.hold

    def time_of(step):
        return (step - made["packing"]) * made["step"]

    # Of the bed at rest, while its pressure drop is looked at
    at_rest = [rows[:, 0] for step, rows in frames if time_of(step) > case.hold and
               np.interp(time_of(step), times[:, 0], times[:, 1]) < FIXED[1]]
    centres = np.mean(at_rest, axis=0) / d
    surface = np.sort(centres)[-case.grains // 50]

    def void_fraction(low, high):
        below = solid_volume_below([low, high], centres)
        return 1 - (below[1] - below[0]) / (case.width**2 * (high - low))

    eps = void_fraction(made["floor"] + ENDS, surface - ENDS)
    reference = ergun_u_mf(eps, case)
    fixed = falling & (velocity > FIXED[0] * reference) & (velocity < FIXED[1] * reference)
    u_mf = where_it_carries(*fit_fixed_bed(velocity[fixed], drop[fixed]), weight)

    # The same between two heights within the bed
    probes = made["probes"]
    height = surface - made["floor"]
    low = int(np.argmax(probes > made["floor"] + TAPS[0] * height))
    high = int(np.argmax(probes > made["floor"] + TAPS[1] * height)) - 1
    between = (probes[high] - probes[low]) * d
    inner_eps = void_fraction(probes[low], probes[high])
    inner_drop = (history[columns[low]] - history[columns[high]]
                  - case.density * GRAVITY * between)
    inner = where_it_carries(*fit_fixed_bed(velocity[fixed], inner_drop[fixed]),
                             (1 - inner_eps) * (GRAIN - case.density) * GRAVITY * between)

    # The fluidised bed's momentum at both ends of the window, so that it need not be steady
    window = (0.4 * case.hold, case.hold)
    inside = [(time_of(step), made["mass"] * rows[:, 1].sum()) for step, rows in frames
              if window[0] <= time_of(step) <= window[1]]
    (begin, first), (end, last) = inside[0], inside[-1]
    flowing = (time_s > begin) & (time_s <= end)
    floor_time = time_of(floor_force[:, 0])
    on_floor = floor_force[(floor_time > begin) & (floor_time <= end), 1].mean()
    result = {
        "case": case.name, "cell_z_by_d": case.cell[1], "bed_height_by_d": float(height + 0.5),
        "method": case.method, "grains": case.grains, "void_fraction": float(eps), "Re_mf":
        u_mf * case.density * d / case.viscosity, "u_mf_m_s": u_mf, "ergun_m_s": reference,
        "error": u_mf / reference - 1, "error_within_bed": inner / ergun_u_mf(inner_eps, case) - 1,
        "wen_yu_m_s": wen_yu_u_mf(case), "wen_yu_by_ergun": wen_yu_u_mf(case) / reference - 1,
        "pressure_by_weight": float(drop[flowing].mean() / weight),
        "floor_by_weight": float(on_floor / area / weight),
        "rise_of_momentum_by_weight": float((last - first) / (end - begin) / area / weight),
        "spread_of_pressure": float(drop[flowing].std() / weight), "seconds": seconds,
        "ledger_residual": float(history["ledger_residual"][-1])}
    curve = {"velocity": velocity, "drop": drop / weight, "falling": falling}
    return result, curve


def described(result):
    return (f"{result['case']}, {result['method']}, cells {result['cell_z_by_d']:g} d high, "
            f"bed {result['bed_height_by_d']:.1f} d: void fraction {result['void_fraction']:.4f}, "
            f"u_mf {result['u_mf_m_s']:.5f} m/s, Ergun {result['ergun_m_s']:.5f} "
            f"({result['error']:+.1%}; within the bed {result['error_within_bed']:+.1%}), "
            f"Wen and Yu {result['wen_yu_m_s']:.5f}; fluidised: pressure drop "
            f"{result['pressure_by_weight']:.4f} of the weight, floor {result['floor_by_weight']:.4f}, "
            f"rise of momentum {result['rise_of_momentum_by_weight']:+.4f}; "
            f"{result['seconds']:.0f} s")


class Fluidisation(unittest.TestCase):
    def test_minimum_fluidisation_is_ergun_s_and_the_flow_carries_the_weight(self):
        result, _ = measure(Case(cell=(2.0, 0.5), overlap=0.006, fall=3.6, least=0.56))
        print(described(result))
        self.assertLess(abs(result["error"]), 0.05)
        self.assertLess(abs(result["error_within_bed"]), 0.05)
        self.assertAlmostEqual(result["pressure_by_weight"], 1, delta=0.02)
        # Newton's second law for all grains together: what is left is how often each was sampled.
        self.assertAlmostEqual(result["pressure_by_weight"] + result["floor_by_weight"],
                               1 + result["rise_of_momentum_by_weight"], delta=0.01)
        self.assertLess(result["ledger_residual"], 1e-8)


AIR = {"density": 1.2, "viscosity": 18.27e-6, "greatest": 1.6, "overlap": 0.006, "headroom": 3.5}
FLUIDS = [Case(), Case(name="air 1 mm", diameter=1e-3, hold=1.2, fall=1.0, interval=5e-4, **AIR),
          Case(name="air 2.5 mm", hold=1.8, fall=1.5, **AIR)]
COARSE = {"cell": (2.0, 2.0), "method": "trilinear"}
ENDS_OF_BEDS = [Case(cell=(2.0, 2.0)), Case(cell=(2.0, 0.5)), Case(grains=565), Case(**COARSE),
                Case(**COARSE, grains=565),
                Case(**COARSE, grains=2260, hold=1.2, fall=6.0, overlap=0.008)]
DATA = DOCS / "data" / "fluidisation.csv"
CURVES = DOCS / "data" / "fluidisation-curves.csv"
PICTURE = DOCS / "images" / "fluidisation.png"


def thinned(case, curve, bins=60):
    """Means over bins of the velocity, of the flow that is turned down."""
    velocity, drop = (curve[key][curve["falling"]] for key in ("velocity", "drop"))
    edges = np.linspace(velocity.min(), velocity.max(), bins + 1)
    for low, high in zip(edges, edges[1:]):
        inside = (velocity >= low) & (velocity <= high)
        if inside.any():
            yield {"case": case.name, "velocity_m_s": float(velocity[inside].mean()),
                   "pressure_by_weight": float(drop[inside].mean())}


def study():
    results, curves = [], []
    for case in FLUIDS + ENDS_OF_BEDS:
        result, curve = measure(case)
        print(described(result), flush=True)
        results.append(result)
        if case in FLUIDS:
            curves += thinned(case, curve)
        write_csv(DATA, results)
        write_csv(CURVES, curves)


def plot():
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    results, points = read_csv(DATA), read_csv(CURVES)
    colours = dict(zip((case.name for case in FLUIDS), ("#4c72b0", "#c44e52", "#dd8452")))
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4.6))
    for result in results[:len(FLUIDS)]:
        name, reference = result["case"], result["ergun_m_s"]
        own = [p for p in points if p["case"] == name]
        velocity = np.array([p["velocity_m_s"] for p in own])
        drop = np.array([p["pressure_by_weight"] for p in own])
        fixed = (velocity > FIXED[0] * reference) & (velocity < FIXED[1] * reference)
        fit = fit_fixed_bed(velocity[fixed], drop[fixed])
        line = np.linspace(0, result["u_mf_m_s"], 50)
        left.plot(velocity / reference, drop, "o", ms=3, color=colours[name],
                  label=f"{name}, Re_mf = {result['Re_mf']:.0f}")
        left.plot(line / reference, fit[0] * line + fit[1] * line**2, "-", lw=1, color=colours[name])
    left.axhline(1, color="black", lw=0.8)
    left.axvline(1, color="black", lw=0.8, ls=":")
    left.set(xlim=(0, 2), ylim=(0, 1.25), xlabel="U / u_mf of Ergun at the bed's void fraction",
             ylabel="pressure drop / weight per area",
             title="flow turned down; fixed bed extrapolated")
    left.legend(fontsize=8.5, frameon=False, loc="lower right")

    for result in results:
        ratio = result["cell_z_by_d"] / result["bed_height_by_d"]
        style = {"marker": "o" if result["method"] == "exact" else "s", "ms": 6, "ls": "",
                 "color": colours[result["case"]]}
        right.plot(ratio, 100 * result["error"], **style)
        right.plot(ratio, 100 * result["error_within_bed"], mfc="white", **style)
    right.axhline(0, color="black", lw=0.8)
    for bound in (-5, 5):
        right.axhline(bound, color="black", lw=0.8, ls=":")
    right.set(xlabel="height of a cell / height of the bed", ylabel="error of u_mf, %",
              title="filled: whole bed; open: between two heights within")
    right.set_xlim(left=0)
    for marker, method in (("o", "exact, cells 2 x 2 d wide"), ("s", "trilinear, 2 x 2 x 2 d")):
        right.plot([], [], marker, color="black", label=method)
    right.legend(fontsize=8.5, frameon=False, loc="upper left")
    figure.tight_layout()
    figure.savefig(PICTURE, dpi=110)


if __name__ == "__main__":
    main(study, plot)
