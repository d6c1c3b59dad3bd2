"""Running a script of LIGGGHTS or LAMMPS, and what its output says of the last timed run."""

import os
import re
import subprocess

TASKS = ("pair", "neighbour", "communication", "walls, integration, other")
# Of the hosts' tables of times; what is not here is the last of TASKS. LIGGGHTS has no row of its own for its fixes.
TASK_OF = {"Pair": TASKS[0], "Neigh": TASKS[1], "Comm": TASKS[2], "Outpt": TASKS[3], "Output": TASKS[3],
           "Modify": TASKS[3], "Other": TASKS[3]}
NUMBER = r"([\d.e+-]+)"


def script_name(words):
    return f"in.{re.sub('[^a-z0-9]+', '_', words.lower())}"


def launch(work, program, script, text, ranks):
    """What a program prints of a script."""
    (work / script).write_text(text)
    command = [*map(str, program), "-in", script, "-log", "none"]
    if ranks > 1:
        command = ["mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none", "-np", str(ranks), *command]
    environment = dict(os.environ, OMP_NUM_THREADS="1", OMPI_MCA_mpi_yield_when_idle="1")
    environment.pop("GASGRAIN_PAIR_STYLE", None)  # ours is timed as ours
    done = subprocess.run(command, cwd=work, env=environment, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise SystemExit(f"{' '.join(command)}\n{done.stdout[-2000:]}\n{done.stderr[-2000:]}")
    return done.stdout


def one_number(name, pattern, text):
    found = re.findall(pattern, text, flags=re.M)
    if len(found) != 1:
        raise SystemExit(f"dem.py: {len(found)} values of '{name}', and not one, in\n{text}")
    return float(found[0])


def shares(text):
    """Share of each task in the loop's time, of all ranks' mean."""
    seconds = dict.fromkeys(TASKS, 0.0)
    rows = re.findall(rf"^(\w+) +time \(%\) = {NUMBER}", text, flags=re.M)             # LIGGGHTS
    rows += re.findall(rf"^(\w+) +\|(?:[^|\n]*\|)? *{NUMBER} *\|[^|\n]*\|[^|\n]*\|", text, flags=re.M)  # LAMMPS
    for name, time in rows:
        seconds[TASK_OF[name]] += float(time)
    total = sum(seconds.values())
    if total <= 0.0:
        raise SystemExit(f"dem.py: no table of times in\n{text}")
    return {name: value / total for name, value in seconds.items()}


def kinetic_energies(text):
    """At the begin and the end of a run [J], of the rows of `thermo_style custom step ke`."""
    rows = re.findall(rf"^ *\d+ +{NUMBER}(?: +{NUMBER})? *$", text, flags=re.M)
    return float(rows[0][0]), float(rows[-1][0])
