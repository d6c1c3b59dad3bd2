#!/usr/bin/python3
"""Price of liquid bridges: the same bed with no cohesion model, with the model but no liquid, wet.

A settled bed in a box that is periodic to the sides, thrown up gently before it is timed. The variants run one
after the other, again and again, so that a noisy machine treats them alike; what counts is the median of the
ratios to the dry run of the same round.

    tests/bench/wet_speed.py [--build build] [--grains 5000] [--steps 3000] [--repeats 5] [--laws]
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
    parser.add_argument("--work", type=Path, default=SOURCE / "results" / "wet_speed")
    parser.add_argument("--grains", type=int, default=5000)
    parser.add_argument("--steps", type=int, default=3000)
    parser.add_argument("--repeats", type=int, default=5)
    parser.add_argument("--laws", action="store_true", help="every capillary law at a content of 0.01")
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

    wet = "fix wet all liquid content {} " + WATER
    variants = {"dry, no cohesion model": ("", ""),
                "cohesion bridge, content 0": ("cohesion bridge", wet.format(0)),
                "content 0.001": ("cohesion bridge", wet.format(0.001)),
                "content 0.01": ("cohesion bridge", wet.format(0.01)),
                "content 0.01, viscous": ("cohesion bridge", wet.format(0.01) + " " + VISCOUS)}
    if options.laws:
        for law in ("mikami", "willett_fit", "rabinovich", "rabinovich_energy", "lian_toroid"):
            variants[f"content 0.01, {law}"] = ("cohesion bridge", wet.format(0.01) + " law " + law)
    for number, (cohesion, liquid) in enumerate(variants.values()):
        (work / f"in.{number}").write_text(
            HEAD + f"read_data {packed.name}\n" + models.format(cohesion=cohesion) + liquid
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

    dry = next(iter(variants))

    def ratio(values, name):
        ratios = [a / b for a, b in zip(values[name], values[dry])]
        return f"{statistics.median(ratios):.2f} ({min(ratios):.2f} to {max(ratios):.2f})"

    print(f"\n{options.grains} settled spheres, {options.steps} steps, 1 rank, median of {options.repeats} "
          "(least to greatest)\n")
    print("| | particle-steps/s | time of dry | pair part of dry |\n|---|---|---|---|")
    for name in variants:
        speed = options.grains * options.steps / statistics.median(loops[name])
        print(f"| {name} | {speed:.3g} | {ratio(loops, name)} | {ratio(pairs, name)} |")


if __name__ == "__main__":
    main()
