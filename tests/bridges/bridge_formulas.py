"""The published forms of a bridge's force, rupture and viscosity, written from their papers for tests.

Nothing here is taken from fix_cfd_coupling/dem_physics: what the program computes is compared with this.
R = 2 r_i r_j / (r_i + r_j) [m], 2 r on a wall; theta mean of the contact angles [rad]; V [m3]; s gap [m]; g
surface tension [N/m]. Signs of the printed Mikami coefficients as docs/bridges.md has them."""

from dataclasses import dataclass

import numpy as np
from numpy import cos, exp, log, pi, sin, sqrt

NODES, WEIGHTS = np.polynomial.legendre.leggauss(60)


@dataclass
class Bridge:
    radius: float
    theta: float
    tension: float
    volume: float
    wall: bool = False

    @property
    def at_contact(self):
        return 2.0 * pi * self.radius * self.tension * cos(self.theta)


def mikami(b, s):
    # Chem. Eng. Sci. 53 (1998) 1927, in the radius of the grain
    r = b.radius / 2 if b.wall else b.radius
    v = b.volume / r**3
    low = log(max(v, 1e-5))
    if b.wall:
        a, big, c = -1.9 * v**-0.51, (-0.016 * low - 0.76) * b.theta**2 - 0.012 * low + 1.2, 0.013 * low + 0.18
    else:
        a, big, c = -1.1 * v**-0.53, (-0.034 * low - 0.96) * b.theta**2 - 0.019 * low + 0.48, 0.0042 * low + 0.078
    return pi * r * b.tension * (exp(a * s / r + big) + c)


def mikami_rupture(b):
    r = b.radius / 2 if b.wall else b.radius
    v = b.volume / r**3
    return r * ((0.22 * b.theta + 0.95) * v**0.32 if b.wall else (0.62 * b.theta + 0.99) * v**0.34)


def willett(b, s):
    # Langmuir 16 (2000) 9396, closed form
    x = s / 2 * sqrt(b.radius / b.volume)
    return b.at_contact / (1 + 2.1 * x + 10 * x**2)


def willett_rupture(b):
    v = b.volume / b.radius**3
    return b.radius * (1 + b.theta / 2) * (v**(1 / 3) + v**(2 / 3) / 10)


def willett_fit(b, s):
    # The same, appendix: polynomials in ln v (rows from the constant upwards) of polynomials in theta
    v = b.volume / b.radius**3
    if v < 1e-4:
        return willett(b, s)
    rows = {
        1: [(-0.44507, 0.050832, -1.1466), (-0.1119, -0.000411, -0.1490), (-0.012101, -0.0036456, -0.01255),
            (-0.0005, -0.0003505, -0.00029076)],
        2: [(1.9222, -0.57473, -1.2918), (-0.0668, -0.1201, -0.22574), (-0.0013375, -0.0068988, -0.01137)],
        3: [(1.268, -0.01396, -0.23566), (0.198, 0.092, -0.06418), (0.02232, 0.02238, -0.009853),
            (0.0008585, 0.001318, -0.00053)],
        4: [(-0.010703, 0.073776, -0.34742), (0.03345, 0.04543, -0.09056), (0.0018574, 0.004456, -0.006257)],
    }
    powers = np.array([1.0, b.theta, b.theta**2])
    f = {k: sum(np.dot(row, powers) * log(v)**n for n, row in enumerate(table)) for k, table in rows.items()}
    x = log(s / 2 * sqrt(b.radius / b.volume))
    return 2 * pi * b.radius * b.tension * exp(f[1] - f[2] * exp(f[3] * x + f[4] * x**2))


def immersion(b, s):
    # Langmuir 21 (2005) 10992
    return s / 2 * (-1 + sqrt(1 + 2 * b.volume / (pi * b.radius * s**2)))


def rabinovich_energy(b, s):
    return b.at_contact / (1 + s / (2 * immersion(b, s)))


def rabinovich(b, s):
    alpha = sqrt(2 * immersion(b, s) / b.radius)
    return rabinovich_energy(b, s) + 2 * pi * b.radius * b.tension * sin(alpha) * sin(b.theta + alpha)


def lian_rupture(b):
    return (1 + b.theta / 2) * b.volume**(1 / 3)


def toroid(b, s, beta):
    """Neck, curvature of the meridian and liquid of the toroid that meets two spheres at beta."""
    half = s / 2 + b.radius * (1 - cos(beta))
    curvature = cos(beta + b.theta) / half
    # A long arc in angle: y(phi) = centre - cos(phi) / curvature, x = sin(phi) / curvature
    end = pi / 2 - beta - b.theta
    phi = end / 2 * (NODES + 1)
    contact = b.radius * sin(beta)
    y = contact - (cos(phi) - cos(end)) / curvature
    volume = 2 * pi * np.sum(WEIGHTS * y**2 * cos(phi) / curvature) * end / 2
    cap = pi / 3 * b.radius**3 * (2 + cos(beta)) * (1 - cos(beta))**2
    neck = contact - (1 - cos(end)) / curvature
    return neck, curvature, volume - 2 * cap


def lian_toroid(b, s):
    # J. Colloid Interface Sci. 161 (1993) 138: suction and tension at the neck
    low, high = 1e-6, pi / 2
    for _ in range(60):
        middle = (low + high) / 2
        neck, _, volume = toroid(b, s, middle)
        if neck <= 0 or volume < b.volume:
            low = middle
        else:
            high = middle
    neck, curvature, _ = toroid(b, s, (low + high) / 2)
    return 2 * pi * neck * b.tension + pi * neck**2 * b.tension * (curvature - 1 / neck)


LAWS = {
    "mikami": (mikami, mikami_rupture),
    "willett": (willett, willett_rupture),
    "willett_fit": (willett_fit, willett_rupture),
    "rabinovich": (rabinovich, lian_rupture),
    "rabinovich_energy": (rabinovich_energy, lian_rupture),
    "lian_toroid": (lian_toroid, lian_rupture),
}


def work(law, b, start, end):
    """Integral of the force over the gap [J], in pieces that are short where the force is steep."""
    edges = start + (end - start) * np.linspace(0, 1, 13)**2
    total = 0.0
    for low, high in zip(edges, edges[1:]):
        s = low + (high - low) / 2 * (NODES + 1)
        total += (high - low) / 2 * np.sum(WEIGHTS * np.array([law(b, one) for one in s]))
    return total


def viscous_normal(b, viscosity, s):
    # Pitois, Moucheront and Chateau 2000: of the force between immersed spheres, the part of a finite bridge
    x = 1 - s / sqrt(s**2 + 2 * b.volume / (pi * b.radius))
    return 1.5 * pi * viscosity * b.radius**2 * x**2 / s


def viscous_tangential(b, viscosity, s):
    # Goldman, Cox and Brenner 1967, with the reduced radius
    reduced = b.radius / 2
    return 6 * pi * viscosity * reduced * (8 / 15 * log(reduced / s) + 0.9588)
