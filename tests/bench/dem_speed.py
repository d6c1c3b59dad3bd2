#!/usr/bin/python3
"""Speed of the DEM part on the settled spouted bed: stock LIGGGHTS with its own pair_style gran, ours alone with
the scene's, ours coupled.

The three run one after the other, again and again, so that a noisy machine treats them alike; what
counts is the median and the ratio. The bed is packed once by the stock program.

    tests/bench/dem_speed.py [--build build] [--ranks 1] [--steps 2000] [--repeats 5]
"""

import argparse
import json
import os
import re
import statistics
import subprocess
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
SCENE = SOURCE / "inputs" / "spouted_bed"
GRAINS = 36500
DT = 1.0e-5         # s, of the scene
PACKED = 20000      # step at which the scene's gas starts


def without_gas(script):
    return re.sub(r"^fix gas .*?[^&]\n", "", script, flags=re.M | re.S)


def with_stock_pairs(script):
    return script.replace("pair_style    gran/bridge", "pair_style    gran")


def launch(folder, *programs):
    command = ["mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none"]
    for n, program in enumerate(programs):
        command += ([":"] if n else []) + [str(word) for word in program]
    environment = dict(os.environ, OMPI_MCA_mpi_yield_when_idle="1", OMP_NUM_THREADS="1")
    done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True,
                          check=False)
    if done.returncode != 0:
        raise SystemExit(f"{' '.join(command)}\n{done.stdout[-2000:]}\n{done.stderr[-2000:]}")
    return float(re.findall(r"Loop time of ([\d.e+-]+)", done.stdout)[-1])


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=Path, default=SOURCE / "build")
    parser.add_argument("--work", type=Path, default=SOURCE / "results" / "dem_speed")
    parser.add_argument("--ranks", type=int, default=1)
    parser.add_argument("--steps", type=int, default=2000)
    parser.add_argument("--repeats", type=int, default=5)
    options = parser.parse_args()
    work = options.work.resolve()
    build = options.build.resolve()
    for folder in ("checkpoint", "particles"):
        (work / folder).mkdir(parents=True, exist_ok=True)
    script = (SCENE / "in.liggghts").read_text()
    # Neither snapshots nor checkpoints in what is measured.
    timed = re.sub(r"^(dump|restart) .*\n", "", script, flags=re.M)
    (work / "in.coupled").write_text(timed)
    (work / "in.alone").write_text(without_gas(timed))
    (work / "in.stock").write_text(with_stock_pairs(without_gas(timed)))
    (work / "in.pack").write_text(with_stock_pairs(without_gas(script)))
    # Too little air to move the bed: all three do the same DEM work.
    (work / "gas.toml").write_text(
        re.sub(r"^mass_flow = .*", "mass_flow = 0.0005", (SCENE / "gas.toml").read_text(), flags=re.M))

    if not (work / f"checkpoint/dem.{PACKED}.restart").exists():
        print("packing the bed with stock LIGGGHTS ...", flush=True)
        launch(work, ["-np", 2, "liggghts", "-in", "in.pack", "-log", "none", "-var", "out", work,
                      "-var", "time", "0"])

    def dem(program, script_name):
        return ["-np", options.ranks, program, "-in", script_name, "-log", "none", "-var", "out", work,
                "-var", "restart", PACKED, "-var", "time", options.steps * DT]

    grain_steps = GRAINS * options.steps
    speeds = {"stock liggghts": [], "gasgrain-liggghts, alone": [],
              "gasgrain-liggghts, coupled: DEM part": [],
              "gasgrain-liggghts, coupled: all": []}
    shares = []
    for repeat in range(options.repeats):
        speeds["stock liggghts"].append(grain_steps / launch(work, dem("liggghts", "in.stock")))
        speeds["gasgrain-liggghts, alone"].append(
            grain_steps / launch(work, dem(build / "gasgrain-liggghts", "in.alone")))
        loop = launch(work, dem(build / "gasgrain-liggghts", "in.coupled"),
                      ["-np", 1, build / "gasgrain-gas", "gas.toml", "--out", work])
        tasks = json.loads((work / "ledger.json").read_text())["dem"]["tasks"]
        coupling = sum(task["mean_s"] for name, task in tasks.items()
                       if name.startswith("coupling:"))
        speeds["gasgrain-liggghts, coupled: DEM part"].append(grain_steps / (loop - coupling))
        speeds["gasgrain-liggghts, coupled: all"].append(grain_steps / loop)
        shares.append(coupling / loop)
        print(f"{repeat + 1} of {options.repeats}: "
              + ", ".join(f"{name} {values[-1]:.3g}" for name, values in speeds.items()), flush=True)

    stock = statistics.median(speeds["stock liggghts"])
    print(f"\n{GRAINS} settled spheres, {options.steps} steps, {options.ranks} DEM rank(s), "
          f"median of {options.repeats} (least to greatest)\n")
    print("| | particle-steps/s | of stock |\n|---|---|---|")
    for name, values in speeds.items():
        median = statistics.median(values)
        print(f"| {name} | {median:.3g} ({min(values):.3g} to {max(values):.3g}) | "
              f"{median / stock:.3f} |")
    print(f"\ngas, coupling and waiting: {100 * statistics.median(shares):.1f} % of the DEM ranks' loop")


if __name__ == "__main__":
    main()
