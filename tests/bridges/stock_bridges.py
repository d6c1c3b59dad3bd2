"""The two bridge models of stock LIGGGHTS 3.8, run in the stock program, and their formulas as its headers have
them (cohesion_model_easo_capillary_viscous.h, cohesion_model_washino_capillary_viscous.h), in SI units."""

from numpy import cbrt, cos, exp, log, pi, sin, sqrt

from wet_host import WATER, Wet

EASO, WASHINO = "easo/capillary/viscous", "washino/capillary/viscous"
DEGREE = pi / 180


def combined_angle(degrees_i, degrees_j):
    """Half the product of the two, in radians."""
    return 0.5 * degrees_i * DEGREE * degrees_j * DEGREE


def easo(s, r_i, r_j, theta, volume):
    larger = max(r_i, r_j)
    v = volume / larger**3
    big = (-0.148 * log(v) - 0.96) * theta**2 - 0.0082 * log(v) + 0.48
    return pi * WATER * sqrt(r_i * r_j) * (exp(-1.1 * v**-0.53 * s / larger + big) + 0.0018 * log(v) + 0.078)


def washino(s, r_i, r_j, theta, volume):
    radius = r_i * r_j / (r_i + r_j)
    root = -1 + sqrt(1 + 2 * volume / (pi * radius * s**2))
    alpha = sqrt(s / radius * root)
    return 2 * pi * radius * WATER * (cos(theta) / (1 + 1 / root) + sin(alpha) * sin(alpha + theta))


def rupture(theta, volume):
    return (1 + 0.5 * theta) * cbrt(volume)


def share(model, own, other):
    """Of a grain's film that counts as the bridge's."""
    return 0.05 if model == WASHINO else 0.5 * (1 - sqrt(1 - (other / (own + other))**2))


def film_of(model, volume, radius):
    """Liquid over grain volume of two equal grains whose bridge has this volume."""
    return volume / (2 * share(model, 1, 1)) / (4 / 3 * pi * radius**3)


def run_stock(model, grains, degrees, contents, minimum=0.01, greatest=1.5, viscosity=0.0, program="liggghts", **more):
    """contents: liquid over grain volume of each grain; minimum over the reduced radius, greatest over r_i + r_j."""
    before = f"""\
fix c1 all property/global surfaceLiquidContentInitial scalar 0
fix c2 all property/global surfaceTension scalar {WATER}
fix c3 all property/global fluidViscosity scalar {viscosity}
fix c4 all property/global contactAngle peratomtype {" ".join(f"{a:.17g}" for a in degrees)}
fix c5 all property/global minSeparationDistanceRatio scalar {minimum}
fix c6 all property/global maxSeparationDistanceRatio scalar {greatest}"""
    wetted = "run 0\n" + "\n".join(f"set atom {n} property/atom surfaceLiquidContent {c:.17g}"
                                   for n, c in enumerate(contents, 1))
    return Wet(grains, cohesion=model, before=before, after=wetted, types=len(degrees), program=program,
               extra=("f_surfaceLiquidContent",), **more)
