#!/usr/bin/python3
"""Pictures of a run, and its index for ParaView.

    tools/report.py DIR
        DIR/history.png           bed height, bubble diameter, pressures, energy, ledger over time
        DIR/bed.png               the particles from the front at some times, coloured by speed
        DIR/particles.vtk.series  the particle files with their times, to be opened with gas.xdmf
    tools/report.py --compare DIR1 DIR2 --data FILE.csv --out FILE.png
        bed height and bubble diameter of two runs beside published points, and a table of the
        errors in Markdown; the columns of FILE.csv are case,quantity,time_s,value_m with the
        quantities bed_height, bubble_diameter and these with _max, the cases in the order of the runs
"""

import argparse
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")

import report_bed
import report_compare
import report_history
from report_read import ReportError


def report(folder):
    """Makes what the folder has the data for; returns the reasons for what it has not."""
    reasons = []
    for make in (report_history.draw, report_bed.write_series, report_bed.draw):
        try:
            make(folder)
        except ReportError as reason:
            reasons.append(str(reason))
    return reasons


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path, metavar="DIR", help="results of a run")
    parser.add_argument("--compare", nargs=2, type=Path, metavar=("DIR1", "DIR2"))
    parser.add_argument("--data", type=Path, metavar="FILE.csv", help="published points")
    parser.add_argument("--out", type=Path, metavar="FILE.png")
    options = parser.parse_args()
    if (options.folder is None) == (options.compare is None):
        parser.error("give either DIR or --compare DIR1 DIR2")
    if options.compare and not (options.data and options.out):
        parser.error("--compare needs --data FILE.csv and --out FILE.png")
    try:
        if options.compare:
            report_compare.draw(options.compare, options.data, options.out)
            print(report_compare.table(options.compare, options.data))
            reasons = []
        else:
            reasons = report(options.folder)
    except ReportError as reason:
        reasons = [str(reason)]
    for reason in dict.fromkeys(reasons):
        print(f"report.py: {reason}", file=sys.stderr)
    return 1 if reasons else 0


if __name__ == "__main__":
    sys.exit(main())
