#!/usr/bin/python3
"""Wall time of the small spouted bed with the gas beside the DEM ranks and inside them.

The launches run one after the other, again and again, so that a noisy machine treats them alike;
what counts is the ratio to the first one within a round.

    tests/bench/inner_gas_speed.py [--build build] [--time 0.05] [--repeats 3]
"""

import argparse
import os
import re
import shutil
import statistics
import subprocess
import tempfile
import time
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
SCENE = SOURCE / "inputs" / "spouted_bed_small"
PACKING = 0.04  # s without gas
LAUNCHES = {"1 + 1": (1, 1), "1 inside": (1, 0), "2 inside": (2, 0), "2 + 1": (2, 1)}


def measured(build, dem_ranks, gas_ranks, gas_time):
    """Wall seconds of the launch, and of its part with gas."""
    with tempfile.TemporaryDirectory(prefix="gasgrain-bench-") as folder:
        script = (SCENE / "in.liggghts").read_text()
        if gas_ranks == 0:
            script = script.replace("output ${out} mode", "output ${out} gas gas.toml mode")
        (Path(folder) / "in.liggghts").write_text(script)
        shutil.copy(SCENE / "gas.toml", folder)
        command = ["mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none",
                   "-np", str(dem_ranks), build / "gasgrain-liggghts", "-in", "in.liggghts",
                   "-var", "packing", str(PACKING), "-var", "time", str(gas_time)]
        if gas_ranks > 0:
            command += [":", "-np", str(gas_ranks), build / "gasgrain-gas", "gas.toml"]
        environment = dict(os.environ, OMPI_MCA_mpi_yield_when_idle="1", OMP_NUM_THREADS="1",
                           OMPI_MCA_btl_vader_single_copy_mechanism="none")
        begin = time.monotonic()
        done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True,
                              check=False)
        seconds = time.monotonic() - begin
    if done.returncode != 0:
        raise SystemExit(f"{done.stdout[-2000:]}\n{done.stderr[-2000:]}")
    return seconds, float(re.findall(r"Loop time of ([\d.e+-]+)", done.stdout)[-1])


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=Path, default=SOURCE / "build")
    parser.add_argument("--time", type=float, default=0.05, help="of gas [s]")
    parser.add_argument("--repeats", type=int, default=3)
    options = parser.parse_args()
    seconds = {name: [] for name in LAUNCHES}
    for _ in range(options.repeats):
        for name, ranks in LAUNCHES.items():
            seconds[name].append(measured(options.build.resolve(), *ranks, options.time))
    reference = seconds["1 + 1"]
    print("ranks      wall s (with gas)   over 1 + 1: median (range)")
    for name, rounds in seconds.items():
        whole, with_gas = (statistics.median(column) for column in zip(*rounds))
        ratios = [ours[0] / theirs[0] for ours, theirs in zip(rounds, reference)]
        print(f"{name:10s} {whole:6.2f} ({with_gas:.2f})       {statistics.median(ratios):.2f} "
              f"({min(ratios):.2f} to {max(ratios):.2f})")
    print("load of the machine:", " ".join(f"{load:.1f}" for load in os.getloadavg()))


if __name__ == "__main__":
    main()
