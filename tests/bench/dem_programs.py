"""The lines of dem.py's table: each host's own styles and ours in it, on the same bed."""

from dem_beds import MATERIALS, MOTION, head

WASHINO = """\
fix viscosity all property/global fluidViscosity scalar 1e-3
fix tension all property/global surfaceTension scalar 0.0728
fix angle all property/global contactAngle peratomtype 0.35
fix least all property/global minSeparationDistanceRatio scalar 1.001
fix ratio all property/global maxSeparationDistanceRatio scalar 1.1
fix content all property/global surfaceLiquidContentInitial scalar 0.5
"""
LIQUID = ("fix liquid all liquid content 0.005 surface_tension 0.0728 contact_angle 0.35 viscosity 1e-3 "
          "minimum_separation 1e-6\n")
MODEL = "model hertz tangential history"
# The same spheres in the words of LAMMPS's own styles; damping as MODEL's at an overlap of 1 um.
OWN_LAW = "3.43e6 4.67e6 8.7e6 NULL 0.1 1"
GRANULAR = "hertz/material 5e6 0.9 0.17 damping tsuji tangential mindlin NULL 1.0 0.1"

STOCK_LIGGGHTS = {"dry": "LIGGGHTS gran", "wet": "LIGGGHTS gran, washino"}
STOCK_LAMMPS = ("LAMMPS granular", "LAMMPS gran/hertz/history")


class Program:
    """A line of the table: `models` are the script's lines of contacts and walls."""

    def __init__(self, name, host, ours, pair, wall, before="", coeff="* *", liquid="dry", replaces=None,
                 extra=False):
        self.name, self.host, self.ours, self.liquid = name, host, ours, liquid
        self.replaces = replaces  # the line that this one takes the place of
        self.extra = extra        # runs only where --only names it
        self.models = f"{before}pair_style {pair}\npair_coeff {coeff}\nfix floor all {wall}\n"

    def command(self, build):
        if self.host == "lammps":
            return ["lmp"]
        return [build / "gasgrain-liggghts"] if self.ours else ["liggghts"]

    def script(self, build, data, steps):
        """Warms up, runs what is timed, and counts the pairs that touch at its end."""
        return (head(self.host, build if self.ours else None, data) + self.models + MOTION +
                "thermo_style custom step ke\nthermo_modify norm no\nthermo 1000000\n"
                f"run {max(1, steps // 10)}\n"
                f'print "{TIMED}"\nrun {steps}\n'
                "compute touching all contact/atom\ncompute contacts all reduce sum c_touching\n"
                "thermo_style custom step c_contacts\n"
                f'print "{COUNTED}"\nrun 0\n')


TIMED, COUNTED = "bench: timed run", "bench: count of contacts"


def liggghts(name, style="gran", words="", before="", **more):
    return Program(name, "liggghts", more.pop("ours", True), f"{style} {MODEL} {words}",
                   f"wall/gran {MODEL} {words} primitive type 1 zplane 0.0 ", MATERIALS + before, **more)


def bridge(name, words, before="", **more):
    return Program(name, "lammps", True, f"gran/bridge {words}",
                   f"wall/gran/bridge {words} primitive type 1 zplane 0.0", MATERIALS + before, **more)


PROGRAMS = [
    liggghts("LIGGGHTS gran", ours=False),
    liggghts("LIGGGHTS gran/bridge", "gran/bridge", replaces="LIGGGHTS gran"),
    Program("LAMMPS granular", "lammps", False, "granular", f"wall/gran granular {GRANULAR} zplane 0.0 NULL",
            coeff=f"* * {GRANULAR}"),
    Program("LAMMPS gran/hertz/history", "lammps", False, f"gran/hertz/history {OWN_LAW}",
            f"wall/gran hertz/history {OWN_LAW} zplane 0.0 NULL"),
    bridge("LAMMPS gran/bridge hertz/history", f"hertz/history {OWN_LAW}", replaces="LAMMPS gran/hertz/history"),
    bridge("LAMMPS gran/bridge model hertz", MODEL, replaces="LAMMPS granular"),
    liggghts("LIGGGHTS gran, washino", words="cohesion washino/capillary/viscous", before=WASHINO, liquid="wet",
             ours=False),
    liggghts("LIGGGHTS gran/bridge, bridges", "gran/bridge", "cohesion bridge", LIQUID, liquid="wet",
             replaces="LIGGGHTS gran, washino"),
    bridge("LAMMPS gran/bridge, bridges", f"{MODEL} cohesion bridge", LIQUID, liquid="wet",
           replaces="LIGGGHTS gran, washino"),
    # One program under two names: what the machine's noise is worth.
    liggghts("LIGGGHTS gran in gasgrain-liggghts", replaces="LIGGGHTS gran", extra=True),
    # A cohesion that is named and finds no liquid.
    liggghts("LIGGGHTS gran/bridge, no liquid", "gran/bridge", "cohesion bridge",
             LIQUID.replace("content 0.005", "content 0"), replaces="LIGGGHTS gran", extra=True),
]
