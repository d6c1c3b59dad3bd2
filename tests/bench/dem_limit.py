#!/usr/bin/python3
"""The limit on paper of the time step of dry grains, Hertz with tangential history, on one core of this machine.

Bytes and operations are counted per grain, per pair in the list and per contact (docs/dem-speed.md has the sums); the
machine's rates are measured by machine_bench; pairs and contacts per grain are those of a table of dem.py.

    tests/bench/dem_limit.py [--build build] [--table docs/data/dem_speed.csv]
"""

import argparse
import csv
import json
import math
import subprocess
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]

# Doubles are 8 bytes, numbers of neighbours and types 4. Each array is fetched once in the sweep over pairs and once
# in one over grains that does both halves of the integration.
GRAIN_BYTES = (3 * 24 + 2 * 8 + 4    # pairs: x, v, omega; radius, mass; type
               + 2 * 2 * 24          # force and torque, read and written
               + 4 + 4 + 3 * 8       # its number, its count, where its neighbours, flags and history begin
               + 5 * 24 + 2 * 8      # motion: x, v, omega, force, torque; radius, mass
               + 3 * 24)             # x, v, omega written
# The hosts instead integrate in two sweeps (all of motion's arrays but x are read twice, v and omega are written
# twice), set force and torque to zero in one, and add the weight in one (force read and written; mass, mask).
SWEEPS_BYTES = (4 * 24 + 2 * 8 + 2 * 24) + 2 * 24 + (2 * 24 + 8 + 4)
PAIR_BYTES = 4 + 4                   # the neighbour's number; whether the contact is in use
CONTACT_BYTES = 2 * 3 * 8 + 4        # history read and written, flag written
# What instructions ask for: of the neighbour too, from whatever cache has it.
PAIR_ASKED = PAIR_BYTES + 24 + 8                              # x_j, radius_j
CONTACT_ASKED = CONTACT_BYTES + 2 * 24 + 8 + 4 + 2 * 2 * 24   # v_j, omega_j; mass_j; type_j; force_j, torque_j

# Sums and products; square roots; divisions.
GRAIN_WORK = (40, 0, 2)
PAIR_WORK = (11, 0, 0)
CONTACT_WORK = (121, 4, 3)


def machine(build):
    """Rates by name: bytes/s, results/s."""
    text = subprocess.run([build / "bench/machine_bench", "--benchmark_format=json"], check=True, text=True,
                          capture_output=True).stdout
    rates = {}
    for run in json.loads(text)["benchmarks"]:
        rates[run["name"]] = run.get("bytes_per_second") or run["items_per_second"]
    return rates


def moving_rate(rates, name, size):
    """Of the working set that is nearest to `size` [bytes], and its name."""
    sets = [key for key in rates if key.startswith(f"{name}/")]
    nearest = min(sets, key=lambda key: abs(math.log(float(key.split("/")[1][:-3]) * 1024 / size)))
    return rates[nearest], nearest


def moving(rates, grains, pairs, contacts):
    """ns a grain and step by what is moved; pairs and contacts are per grain."""
    once = GRAIN_BYTES + pairs * PAIR_BYTES + contacts * CONTACT_BYTES
    swept = once + SWEEPS_BYTES
    asked = GRAIN_BYTES + pairs * PAIR_ASKED + contacts * CONTACT_ASKED
    rate, level = moving_rate(rates, "copy", once * grains)
    return {f"moved once, {once:.0f} bytes ({level})": 1e9 * once / rate,
            f"moved by the hosts' sweeps, {swept:.0f} bytes ({level})": 1e9 * swept / rate,
            f"asked for, {asked:.0f} bytes (rows, smallest)": 1e9 * asked / moving_rate(rates, "rows", 1)[0]}


def computing(rates, pairs, contacts):
    """ns a grain and step of (sums and products, roots and quotients), by doubles in a vector."""
    work = [g + pairs * p + contacts * c for g, p, c in zip(GRAIN_WORK, PAIR_WORK, CONTACT_WORK)]
    # A product and a sum are one result of `fma`; roots and quotients wait for one unit.
    return {width: (1e9 * work[0] / 2 / rates[f"fma/{width}"],
                    1e9 * (work[1] / rates[f"sqrt/{width}"] + work[2] / rates[f"div/{width}"]))
            for width in (1, 2, 4, 8) if f"fma/{width}" in rates}


def speed(time):
    return f"{1e3 / time:.1f}"


def print_case(rates, case):
    grains = int(case[0]["grains"])
    pairs, contacts = float(case[0]["neighbours_per_grain"]), int(case[0]["contacts"]) / grains
    print(f"\n{case[0]['bed']} bed, {grains:,} grains: {pairs:.2f} pairs in the list and {contacts:.2f} contacts a "
          "grain\n\n| | ns a grain and step | 10^6 particle-steps/s |\n|---|---|---|")
    moved = moving(rates, grains, pairs, contacts)
    for name, time in moved.items():
        print(f"| {name} | {time:.1f} | {speed(time)} |")
    once, _, asked = moved.values()
    for width, (sums, roots) in computing(rates, pairs, contacts).items():
        name = "single doubles" if width == 1 else f"vectors of {width}"
        print(f"| sums and products, {name} | {sums:.1f} | {speed(sums)} |")
        print(f"| roots and quotients, {name} | {roots:.1f} | {speed(roots)} |")
        together, in_turn = max(once, asked, sums, roots), once + asked + sums + roots
        print(f"| **limit, {name}**: all at once; one after the other | {together:.1f}; {in_turn:.1f} "
              f"| {speed(together)}; {speed(in_turn)} |")
    for row in case:
        time = 1e9 / float(row["median"])
        print(f"| measured: {row['program']} | {time:.1f} | {speed(time)} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=Path, default=SOURCE / "build")
    parser.add_argument("--table", type=Path, default=SOURCE / "docs" / "data" / "dem_speed.csv")
    options = parser.parse_args()
    rates = machine(options.build)
    print("| machine_bench | 10^9/s |\n|---|---|")
    for name, rate in rates.items():
        print(f"| {name} | {rate / 1e9:.2f} |")
    with options.table.open(newline="") as file:
        rows = [row for row in csv.DictReader(file) if row["liquid"] == "dry" and row["ranks"] == "1"]
    for bed, grains in dict.fromkeys((row["bed"], row["grains"]) for row in rows):
        print_case(rates, [row for row in rows if (row["bed"], row["grains"]) == (bed, grains)])


if __name__ == "__main__":
    main()
