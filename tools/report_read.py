"""Reads what a run writes: history.csv, run.json, and the particle files of LIGGGHTS."""

import csv
import json
import re
from pathlib import Path

import numpy as np


class ReportError(Exception):
    """Its text is the whole message for the user."""


def read_history(folder):
    """Columns of history.csv by name, from the start of the gas (time 0) on."""
    file = Path(folder) / "history.csv"
    try:
        with open(file, newline="") as stream:
            lines = [line for line in csv.reader(stream) if line]
    except OSError as error:
        raise ReportError(f"{file} cannot be read: {error.strerror}") from error
    names = [name.strip() for name in lines[0]] if lines else []
    if "time_s" not in names:
        raise ReportError(f"{file} has no column time_s")
    # The last line may still be in the writing.
    rows = [line for line in lines[1:] if len(line) == len(names)]
    values = np.array(rows, dtype=float).reshape(len(rows), len(names))
    time = values[:, names.index("time_s")]
    # A restart repeats the time since its checkpoint: the later lines count.
    latest = np.minimum.accumulate(time[::-1])[::-1]
    superseded = np.append(time[:-1] >= latest[1:], False) if len(time) else np.zeros(0, bool)
    values = values[(time >= 0.0) & ~superseded]
    if len(values) == 0:
        raise ReportError(f"{file} has no line after the start of the gas")
    return dict(zip(names, values.T))


def numbered_files(folder, name, absent):
    """(time [s], file) of every file whose NAME holds * for a step, in the order of time; 0 is when the gas starts."""
    folder = Path(folder)
    try:
        plan = json.loads((folder / "run.json").read_text())
        start, dt = int(plan["start_step"]), float(plan["dt_s"])
    except (OSError, ValueError, KeyError) as error:
        raise ReportError(f"{folder / 'run.json'} cannot be read: {error}") from error
    step_of = re.compile(re.escape(Path(name).name).replace(r"\*", r"(\d+)"))
    found = []
    for file in folder.glob(name):
        step = step_of.fullmatch(file.name)
        if step:
            found.append(((int(step[1]) - start) * dt, file))
    if not found:
        raise ReportError(f"{folder}: no file {name}: {absent}")
    return sorted(found)


def particle_files(folder):
    return numbered_files(folder, "particles/p_*.vtk", "the script writes no particle files")


class VtkFile:
    """A legacy VTK file, ASCII or binary (big-endian), taken apart from front to back."""

    KINDS = {"float": ">f4", "double": ">f8", "int": ">i4", "unsigned_int": ">u4", "long": ">i8",
             "vtktypeint64": ">i8", "vtkIdType": ">i8", "short": ">i2", "char": ">i1",
             "unsigned_char": ">u1"}

    def __init__(self, file):
        self.file = file
        try:
            self.bytes = Path(file).read_bytes()
        except OSError as error:
            raise ReportError(f"{file} cannot be read: {error.strerror}") from error
        self.at = 0
        if not self.line().startswith("# vtk DataFile"):
            raise ReportError(f"{file} is no legacy VTK file")
        self.line()  # title
        self.binary = self.line().strip() == "BINARY"

    def line(self):
        """The next line; empty at the end."""
        end = self.bytes.find(b"\n", self.at)
        end = len(self.bytes) if end < 0 else end
        text = self.bytes[self.at:end].decode("latin-1")
        self.at = min(end + 1, len(self.bytes))
        return text

    def headings(self):
        """The words of each line that is not values, up to the end."""
        while self.at < len(self.bytes):
            words = self.line().split()
            if words:
                yield words

    def values(self, count, kind):
        """The next `count` numbers."""
        if kind not in self.KINDS:
            raise ReportError(f"{self.file}: values of kind {kind} are not known")
        if self.binary:
            dtype = np.dtype(self.KINDS[kind])
            if self.at + count * dtype.itemsize > len(self.bytes):
                raise ReportError(f"{self.file} ends too early")
            array = np.frombuffer(self.bytes, dtype, count, self.at)
            self.at += count * dtype.itemsize + 1  # a line's end follows
            return array.astype(float)
        words = []
        while len(words) < count:
            if self.at >= len(self.bytes):
                raise ReportError(f"{self.file} ends too early")
            words.extend(self.line().split())
        return np.array(words, dtype=float)


def property_name(column):
    """Of a property of the grains, which LAMMPS writes as d_NAME and LIGGGHTS as f_NAME."""
    return "f_" + column[2:] if column.startswith("d_") else column


def read_fields(file):
    """(centres [m] of shape (n, 3), {name: values of shape (n, components)}) of a particle file."""
    vtk = VtkFile(file)
    centres = np.zeros((0, 3))
    fields = {}
    for words in vtk.headings():
        if words[0] == "POINTS":
            centres = vtk.values(3 * int(words[1]), words[2]).reshape(-1, 3)
        elif words[0] in ("OFFSETS", "CONNECTIVITY"):
            vtk.values(offsets if words[0] == "OFFSETS" else corners, words[1])
        elif words[0] == "VERTICES":
            offsets, corners = int(words[1]), int(words[2])
        elif len(words) == 4 and words[3] in vtk.KINDS and words[1].isdigit():
            components, tuples = int(words[1]), int(words[2])
            fields[words[0]] = vtk.values(components * tuples, words[3]).reshape(tuples, components)
    fields = {property_name(name): values for name, values in fields.items()}
    if "v" not in fields and all(name in fields for name in ("vx", "vy", "vz")):
        fields["v"] = np.hstack([fields[name] for name in ("vx", "vy", "vz")])
    return centres, fields


def read_particles(file):
    """(centres [m] of shape (n, 3), radii [m], speeds [m/s]) of a particle file."""
    centres, fields = read_fields(file)
    if len(centres) and not ("radius" in fields and "v" in fields):
        raise ReportError(f"{file} lacks radius or velocity: the dump of in.liggghts must list "
                          "id type x y z vx vy vz radius")
    if not len(centres):
        return centres, np.zeros(0), np.zeros(0)
    return centres, fields["radius"][:, 0], np.linalg.norm(fields["v"], axis=1)


def read_box(file):
    """((x lo, x hi), (y ..), (z ..)) [m] from p_boundingBox_STEP.vtk beside p_STEP.vtk, or None."""
    box_file = file.with_name(file.name.replace("p_", "p_boundingBox_"))
    if not box_file.exists():
        return None
    vtk = VtkFile(box_file)
    sides = {words[0][0].lower(): vtk.values(int(words[1]), words[2]) for words in vtk.headings()
             if words[0].endswith("_COORDINATES")}
    return [(sides[axis].min(), sides[axis].max()) for axis in "xyz"]
