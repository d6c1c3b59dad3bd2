#!/usr/bin/python3
"""The objects that are compiled for an instruction set hold no function that another object may hold as well.

The linker keeps one of all functions of a name: if it kept one with AVX-512 in it, the program would fail on
machines without.

    tests/unit/lane_symbols.py LIBRARY
"""
import re
import subprocess
import sys

listing = subprocess.run(["nm", "-C", "--defined-only", sys.argv[1]], capture_output=True, text=True, check=True).stdout
seen = set()
faults = []
isa = None
for line in listing.splitlines():
    member = re.match(r"(lane_stacks_(\w+)|.*)\.cpp\.o:$", line)
    if member:
        isa = member.group(2)
        if isa:
            seen.add(isa)
    symbol = re.match(r"[0-9a-f]* ([A-Za-z]) (.+)", line)
    if isa and symbol and symbol.group(1) in "TWVuiD" and f"contact::{isa}" not in symbol.group(2):
        faults.append(f"{isa}: {line}")
if not seen:
    faults.append("no object lane_stacks_* is in the library")
print("\n".join(faults) or f"{', '.join(sorted(seen))}: all their functions are of their own names")
sys.exit(1 if faults else 0)
