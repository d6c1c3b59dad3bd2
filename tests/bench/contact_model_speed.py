#!/usr/bin/python3
"""Price of our contact models: the same bed without, with a model whose parameter is 0, with it at work.

A settled bed in a box that is periodic to the sides, thrown up gently before it is timed. The variants run one
after the other, again and again, so that a noisy machine treats them alike; what counts are the median of
the ratios to the run without a model of the same round, and the ratio of the fastest rounds.

    tests/bench/contact_model_speed.py [--of wet|laws|dry] [--build build] [--grains 5000] [--steps 3000] [--repeats 5]
"""

import argparse
import re
import statistics
import subprocess
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
RADIUS = 1.0e-3  # m
SPEED = 0.005    # m/s: the bed is thrown up by some micrometres, and keeps its contacts
WATER = "surface_tension 0.0728 contact_angle 0.35"
VISCOUS = "viscosity 0.001 minimum_separation 1e-6"

HEAD = """
atom_style granular
atom_modify map array
boundary p p f
newton off
communicate single vel yes
units si
"""
MODELS = """
neighbor 0.0005 bin
neigh_modify delay 0
fix m1 all property/global youngsModulus peratomtype 5e6
fix m2 all property/global poissonsRatio peratomtype 0.45
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.7
fix m4 all property/global coefficientFriction peratomtypepair 1 0.5
pair_style gran model hertz tangential history {cohesion}
pair_coeff * *
timestep 1e-5
fix g all gravity 9.81 vector 0 0 -1
fix floor all wall/gran model hertz tangential history primitive type 1 zplane 0.0
fix lid all wall/gran model hertz tangential history primitive type 1 zplane {top}
fix nve all nve/sphere
"""


LIQUID = "fix wet all liquid content {} " + WATER
NECK = "".join(f"fix of_{name} all property/global {name} {kind} {value}\n" for name, kind, value in (
    ("neckSurfaceTension", "peratomtypepair 1", 2.0), ("neckTensileStrength", "peratomtypepair 1", 1e7),
    ("neckShearStrength", "peratomtypepair 1", 1e7), ("neckStiffness", "peratomtypepair 1", 1e3),
    ("neckLatticeConstant", "scalar", 2.87e-10), ("surfaceDiffusionPrefactor", "scalar", 5e-4),
    ("surfaceDiffusionEnergy", "scalar", 2.2e5), ("volumeDiffusionPrefactor", "scalar", 2e-4),
    ("volumeDiffusionEnergy", "scalar", 2.5e5)))


def wet():
    return {"bridge, no liquid": ("cohesion bridge", LIQUID.format(0)),
            "bridge, content 0.001": ("cohesion bridge", LIQUID.format(0.001)),
            "bridge, content 0.01": ("cohesion bridge", LIQUID.format(0.01)),
            "bridge, content 0.01, viscous": ("cohesion bridge", LIQUID.format(0.01) + " " + VISCOUS)}


def laws():
    return {law: ("cohesion bridge", LIQUID.format(0.01) + " law " + law)
            for law in ("willett", "willett_fit", "mikami", "rabinovich", "rabinovich_energy", "lian_toroid")}


def dry_models():
    hamaker = "fix of_h all property/global hamakerConstant peratomtype {}"
    work = "fix of_w all property/global workOfAdhesion peratomtypepair 1 {}"
    rolling = ("fix of_r all property/global coefficientRollingFriction peratomtypepair 1 0.1\n"
               "fix of_k all property/global rollingTimeConstant peratomtypepair 1 1e-3")
    return {"van_der_waals, 0": ("cohesion van_der_waals", hamaker.format(0)),
            "van_der_waals": ("cohesion van_der_waals", hamaker.format(1e-19)),
            "jkr, 0": ("cohesion jkr", work.format(0)),
            "jkr": ("cohesion jkr", work.format(0.05)),
            "sintered_neck": ("cohesion sintered_neck neck_temperature 1400 greatest_gap 1e-6", NECK),
            "rolling viscous": ("rolling_friction viscous", rolling),
            "rolling limited": ("rolling_friction limited", rolling)}


def launch(program, folder, name):
    done = subprocess.run([str(program), "-in", name, "-log", "none"], cwd=folder, capture_output=True,
                          text=True, check=False)
    if done.returncode != 0:
        raise SystemExit(f"{name}\n{done.stdout[-2000:]}\n{done.stderr[-2000:]}")
    return done.stdout


def times(text):
    """Of the last run: the whole loop and the pair part [s]."""
    return (float(re.findall(r"Loop time of ([\d.e+-]+)", text)[-1]),
            float(re.findall(r"Pair  time \(%\) = ([\d.e+-]+)", text)[-1]))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=Path, default=SOURCE / "build")
    parser.add_argument("--work", type=Path, default=SOURCE / "results" / "contact_model_speed")
    parser.add_argument("--grains", type=int, default=5000)
    parser.add_argument("--steps", type=int, default=3000)
    parser.add_argument("--repeats", type=int, default=5)
    parser.add_argument("--of", choices=("wet", "laws", "dry"), default="wet",
                        help="bridges; capillary laws at a content of 0.01; dry adhesion and rolling")
    options = parser.parse_args()
    work = options.work.resolve()
    work.mkdir(parents=True, exist_ok=True)
    program = options.build.resolve() / "gasgrain-liggghts"

    side = (options.grains / 40) ** (1 / 2) * 2.2 * RADIUS
    top = 40 * 3.2 * RADIUS
    box = f"region box block 0 {side:.6g} 0 {side:.6g} 0 {top:.6g} units box\n"
    models = MODELS.replace("{top}", f"{top:.6g}")
    packed = work / f"packed_{options.grains}.data"
    if not packed.exists():
        print("packing the bed ...", flush=True)
        (work / "in.pack").write_text(
            HEAD + box + "create_box 1 box\n" + models.format(cohesion="")
            + f"fix p all particletemplate/sphere 15485863 atom_type 1 density constant 2500 radius constant {RADIUS}\n"
            "fix d all particledistribution/discrete 32452843 1 p 1.0\n"
            f"fix i all insert/pack seed 32452867 distributiontemplate d vel constant 0 0 -0.5 insert_every once "
            f"overlapcheck yes all_in no particles_in_region {options.grains} region box\n"
            f"run 20000\nwrite_data {packed.name}\n")
        launch(program, work, "in.pack")

    variants = {"no model of ours": ("", "")} | {"wet": wet, "laws": laws, "dry": dry_models}[options.of]()
    for number, (model, lines) in enumerate(variants.values()):
        (work / f"in.{number}").write_text(
            HEAD + f"read_data {packed.name}\n" + models.format(cohesion=model) + lines
            + f"\nvelocity all set NULL NULL {SPEED} units box\nrun 1000\n"
            + f"velocity all set NULL NULL {SPEED} units box\nrun {options.steps}\n")
    loops = {name: [] for name in variants}
    pairs = {name: [] for name in variants}
    for repeat in range(options.repeats):
        for number, name in enumerate(variants):
            loop, pair = times(launch(program, work, f"in.{number}"))
            loops[name].append(loop)
            pairs[name].append(pair)
        print(f"{repeat + 1} of {options.repeats}", flush=True)

    base = next(iter(variants))

    def ratio(values, name):
        ratios = [a / b for a, b in zip(values[name], values[base])]
        return f"{statistics.median(ratios):.2f} ({min(ratios):.2f} to {max(ratios):.2f})"

    print(f"\n{options.grains} settled spheres, {options.steps} steps, 1 rank, median of {options.repeats} "
          "(least to greatest)\n")
    print("| | particle-steps/s, fastest | time | of the fastest rounds | pair part |\n|---|---|---|---|---|")
    for name in variants:
        speed = options.grains * options.steps / min(loops[name])
        fastest = min(loops[name]) / min(loops[base])
        print(f"| {name} | {speed:.3g} | {ratio(loops, name)} | {fastest:.2f} | {ratio(pairs, name)} |")


if __name__ == "__main__":
    main()
