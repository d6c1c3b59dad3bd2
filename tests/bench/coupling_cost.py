#!/usr/bin/python3
"""What the coupling costs in the spouted bed, by task and void-fraction method, as a Markdown table.

The packed bed (packed once by the stock program) is run on with the gas for a short time, on one
DEM rank and one gas rank that work in turn, with each method; the methods one after the other, again
and again, so that a noisy machine treats them alike. Figures are medians of the runs, of wall time.
100 % are the DEM steps between two couplings without anything of the coupling. On a machine with more
to do than cores wall time favours what follows a sleep, as the drag law does; so a second table has
processor time: of build/bench/exchange_bench, and of DEM steps alone.

    tests/bench/coupling_cost.py [--build build] [--time 0.02] [--repeats 3] [--methods offset ...]
"""

import argparse
import json
import re
import resource
import statistics
import subprocess
from pathlib import Path

from dem_speed import DT, PACKED, SCENE, SOURCE, launch, without_gas

METHODS = ["centre", "offset", "trilinear", "exact", "kernel", "particle_grid"]
EVERY = 100         # DEM steps a coupling, of the scene
PARTICLE_TASKS = ["void fraction", "drag law", "drag of the gas", "sampling"]
OTHER_TASKS = ["transport", "waiting for the gas", "forces", "history", "DEM ranks in step"]
LIMIT = {"exact": 10.0}     # % of the DEM steps for PARTICLE_TASKS
USUAL_LIMIT = 3.0
WHOLE_LIMIT = 15.0          # % with the gas step


def pack(work, script):
    (work / "in.pack").write_text(without_gas(script))
    if not (work / f"checkpoint/dem.{PACKED}.restart").exists():
        print("packing the bed with stock LIGGGHTS ...", flush=True)
        launch(work, ["-np", 2, "liggghts", "-in", "in.pack", "-log", "none", "-var", "out", work,
                      "-var", "time", "0"])


def tasks_of(ledger, side):
    return {name: task["max_s"] for name, task in ledger[side]["tasks"].items()}


def measure(work, build, method, time):
    """ms a coupling of each task of the DEM rank, of the DEM steps, and of the gas rank's tasks."""
    launch(work,
           ["-np", 1, build / "gasgrain-liggghts", "-in", f"in.{method}", "-log", "none", "-var", "out",
            work, "-var", "restart", PACKED, "-var", "time", time],
           ["-np", 1, build / "gasgrain-gas", "gas.toml", "--out", work])
    couplings = round(time / (EVERY * DT))
    ledger = json.loads((work / "ledger.json").read_text())
    dem = {name: 1e3 * s / couplings for name, s in tasks_of(ledger, "dem").items()}
    gas = {name: 1e3 * s / couplings for name, s in tasks_of(ledger, "gas").items()}
    coupling = {}
    for name, ms in dem.items():
        if name.startswith("coupling: "):
            task = name.split(": ")[1]
            task = "forces" if task.startswith("force") else task
            coupling[task] = coupling.get(task, 0.0) + ms
    coupling["DEM steps"] = dem["total"] - dem["setup"] - dem["other"] - sum(coupling.values())
    return coupling, gas


def processor_s(work, build, steps):
    """Of a launch of the DEM program without the gas."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    launch(work, ["-np", 1, build / "gasgrain-liggghts", "-in", "in.alone", "-log", "none", "-var", "out",
                  work, "-var", "restart", PACKED, "-var", "time", steps * DT])
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def processor_table(work, build, methods, repeats, steps=500):
    """The coupling's loops over particles against the DEM steps, in ms of processor time."""
    dem, loops = [], {}
    for _ in range(repeats):
        dem.append(1e3 * EVERY / steps
                   * (processor_s(work, build, steps) - processor_s(work, build, 0)))
        done = subprocess.run([build / "bench/exchange_bench", "--benchmark_format=json",
                               "--benchmark_filter=coupled_step|forces_of_100_steps"],
                              capture_output=True, text=True, check=True)
        for benchmark in json.loads(done.stdout)["benchmarks"]:
            loops.setdefault(benchmark["name"], []).append(benchmark["cpu_time"])
    steps_ms = statistics.median(dem)
    print(f"\nProcessor time, median of {repeats} (least to greatest); {EVERY} DEM steps take "
          f"{steps_ms:.0f} ({min(dem):.0f} to {max(dem):.0f}) ms\n")
    print("| | ms a coupling | % of the DEM steps |\n|---|---|---|")
    rows = [(f"`{method}`: deposit, drag, sampling", f"coupled_step/{method}") for method in methods]
    rows.append((f"forces of {EVERY} steps", "forces_of_100_steps/drag_and_pressure_gradient"))
    for name, benchmark in rows:
        ms = loops[benchmark]
        print(f"| {name} | {statistics.median(ms):.1f} ({min(ms):.1f} to {max(ms):.1f}) | "
              f"{100.0 * statistics.median(ms) / steps_ms:.1f} |")


def median(runs, value):
    return statistics.median(value(run) for run in runs)


def least_to_greatest(runs, value):
    values = [value(run) for run in runs]
    return f"{statistics.median(values):.2f} ({min(values):.2f} to {max(values):.2f})"


def particle_share(run):
    return 100.0 * sum(run[0][task] for task in PARTICLE_TASKS) / run[0]["DEM steps"]


def whole_share(run):
    coupling = sum(ms for task, ms in run[0].items() if task != "DEM steps")
    return 100.0 * coupling / run[0]["DEM steps"]


def print_tables(results):
    print("\n| ms a coupling | " + " | ".join(f"`{method}`" for method in results) + " |")
    print("|---" * (len(results) + 1) + "|")
    rows = [(task, lambda run, t=task: run[0][t])
            for task in [*PARTICLE_TASKS, *OTHER_TASKS, "DEM steps"]]
    for name, value in rows:
        print(f"| {name} | " + " | ".join(f"{median(runs, value):.2f}" for runs in results.values())
              + " |")
    for name, value, limit in [
            ("deposit, drag, sampling: % of the DEM steps", particle_share,
             lambda method: LIMIT.get(method, USUAL_LIMIT)),
            ("coupling with the gas step: % of the DEM steps", whole_share, lambda _: WHOLE_LIMIT)]:
        cells = []
        for method, runs in results.items():
            passed = median(runs, value) <= limit(method)
            text = least_to_greatest(runs, value)
            cells.append(text if passed else f"**{text}**, more than {limit(method):g}")
        print(f"| {name} | " + " | ".join(cells) + " |")
    print("\n| the gas rank, ms a coupling | " + " | ".join(f"`{method}`" for method in results) + " |")
    print("|---" * (len(results) + 1) + "|")
    for task in next(iter(results.values()))[0][1]:
        print(f"| {task} | "
              + " | ".join(f"{median(runs, lambda run: run[1].get(task, 0.0)):.2f}"
                           for runs in results.values()) + " |")


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=Path, default=SOURCE / "build")
    parser.add_argument("--work", type=Path, default=SOURCE / "results" / "coupling_cost")
    parser.add_argument("--time", type=float, default=0.02, help="gas time of a run [s]")
    parser.add_argument("--repeats", type=int, default=3)
    parser.add_argument("--methods", nargs="+", default=METHODS, choices=METHODS)
    options = parser.parse_args()
    work = options.work.resolve()
    build = options.build.resolve()
    for folder in ("checkpoint", "particles"):
        (work / folder).mkdir(parents=True, exist_ok=True)
    script = (SCENE / "in.liggghts").read_text()
    pack(work, script)
    # Neither snapshots nor checkpoints in what is measured.
    timed = re.sub(r"^(dump|restart) .*\n", "", script, flags=re.M)
    for method in options.methods:
        (work / f"in.{method}").write_text(re.sub(r"void_fraction \w+", f"void_fraction {method}", timed))
    (work / "in.alone").write_text(without_gas(timed))
    gas = (SCENE / "gas.toml").read_text()
    (work / "gas.toml").write_text(re.sub(r"^every = .*", "every = 1.0", gas, flags=re.M))

    results = {method: [] for method in options.methods}
    for repeat in range(options.repeats):
        for method, runs in results.items():
            runs.append(measure(work, build, method, options.time))
            print(f"{repeat + 1} of {options.repeats}, {method}: {particle_share(runs[-1]):.2f} % and "
                  f"{whole_share(runs[-1]):.1f} % of {runs[-1][0]['DEM steps']:.0f} ms", flush=True)
    print(f"\n{options.time:g} s, a coupling every {EVERY} DEM steps, median of {options.repeats} runs "
          "(least to greatest)")
    print_tables(results)
    processor_table(work, build, options.methods, options.repeats)


if __name__ == "__main__":
    main()
