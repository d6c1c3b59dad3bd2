"""Scripts written for LIGGGHTS in the words of the other host, for tests that both must pass."""

import re
import sys

# The host that a test file is run for: the word `lammps` after the folder of the build.
HOST = sys.argv.pop(2) if len(sys.argv) > 2 and sys.argv[2] in ("liggghts", "lammps") else "liggghts"

# What LIGGGHTS calls otherwise. Properties of grains are d_NAME, not the property/atom NAME of a fix f_NAME.
LAMMPS = (
    (r"^atom_style granular$", "include @build@/gasgrain.lmp\natom_style sphere"),
    (r"^communicate single vel yes$", "comm_modify mode single vel yes"),
    (r"property/atom (particlesPerParcel|liquidFilm)", r"d_\1"),
    (r"\bf_(particlesPerParcel|liquidFilm)\b", r"d_\1"),
    (r"^(dump_modify .*)\bformat \"", r'\1format line "'),
    (r"\bwall/gran (model .*)$", r"wall/gran/bridge \1"),
)


def in_words_of(host, script, build):
    """The script as `host` takes it."""
    if host == "lammps":
        for pattern, words in LAMMPS:
            script = re.sub(pattern, words, script, flags=re.MULTILINE)
    return script.replace("@build@", str(build))


def command_of(host, build, beside_gas=False):
    """Its program with the words that come before '-in SCRIPT'."""
    if host == "liggghts":
        return [str(build / "gasgrain-liggghts")]
    return ["lmp", *(["-m", "0"] if beside_gas else [])]
