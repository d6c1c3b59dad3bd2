"""The true force of a bridge between two equal spheres: Young and Laplace's equation without gravity.

Lengths in the radius r, forces in gamma r. With y the meridian's distance to the axis and phi its slope, the force
f pi = pi (2 y cos phi - P y^2) is the same at every section, so that the shape is an integral over y:
  cos phi = (f + P y^2) / (2 y),   x = integral dy cot phi,   V = integral pi y^2 dx
from the neck, y0 = f / (1 + (1 - P f)^(1/2)), to the contact circle sin beta, where cos phi = sin(beta + theta).
Half-filling angle beta and pressure P of a gap and a volume by Newton's method, from contact outwards. Another way
than tests/bridges/young_laplace.h goes; both agree (side_by_side.py)."""

import numpy as np

NODES, WEIGHTS = np.polynomial.legendre.leggauss(80)
T, W = 0.5 * (NODES + 1), 0.5 * WEIGHTS


def shape(beta, pressure, theta):
    """Gap, volume and force; None: no such bridge."""
    y1 = np.sin(beta)
    f = 2 * y1 * np.sin(beta + theta) - pressure * y1**2
    if f <= 0 or pressure * f >= 1:
        return None
    y0 = f / (1 + np.sqrt(1 - pressure * f))
    if not 0 < y0 < y1:
        return None
    # y = y0 + (y1 - y0) t^2 takes the root of sin phi at the neck away.
    y = y0 + (y1 - y0) * T**2
    # 1 - cos phi = (y - y0) (...) / (2 y), as y0 is a root of P y^2 - 2 y + f
    one_less = (y - y0) * (2 - pressure * (y + y0)) / (2 * y)
    cosine = 1 - one_less
    sine = np.sqrt(one_less * (1 + cosine))
    dx = W * 2 * (y1 - y0) * T * cosine / sine
    cap = 1 - np.cos(beta)
    return np.array([2 * (np.sum(dx) - cap), 2 * (np.sum(np.pi * y**2 * dx) - np.pi * cap**2 * (1 - cap / 3)),
                     np.pi * f])


def forces(volume, theta, gaps, first):
    """F / (gamma r) of V / r^3 at increasing gaps / r; NaN beyond the last bridge. first: (beta, P) to begin with, of
    a gap near gaps[0]."""
    state, found, at = np.array(first), [], None
    widest = 0.02 * volume**(1 / 3)
    for gap in gaps:
        steps = 1 if at is None else max(1, int(np.ceil((gap - at) / widest)))
        low = gap if at is None else at
        for n in range(1, steps + 1):
            state = solve(state, low + (gap - low) * n / steps, volume, theta) if state is not None else None
        at = gap
        found.append(np.nan if state is None else shape(*state, theta)[2])
    return np.array(found)


def solve(state, gap, volume, theta):
    def residual(s):
        got = shape(*s, theta)
        return None if got is None else np.array([(got[0] - gap) / volume**(1 / 3), got[1] / volume - 1])

    r = residual(state)
    for _ in range(80):
        if r is None:
            return None
        if np.abs(r).sum() < 1e-10:
            return state
        change = 1e-6 * np.array([state[0], abs(state[1]) + 0.1 / state[0]])
        beside = [residual(state + d) for d in np.diag(change)]
        if any(one is None for one in beside):
            return None
        step = np.linalg.solve(np.stack([(one - r) / d for one, d in zip(beside, change)], axis=1), -r)
        share = min(1.0, 0.2 * state[0] / abs(step[0]))
        for _ in range(25):
            tried = residual(state + share * step)
            if tried is not None and np.abs(tried).sum() < np.abs(r).sum():
                break
            share *= 0.5
        else:
            return None
        state, r = state + share * step, tried
    return None


def of_pair(bridge, gaps):
    """Forces [N] of bridge_formulas.Bridge between equal spheres at increasing gaps [m] above 0."""
    from bridge_formulas import toroid
    low, high = 1e-6, np.pi / 2 - bridge.theta
    s = gaps[0]
    for _ in range(60):
        middle = (low + high) / 2
        neck, _, volume = toroid(bridge, s, middle)
        low, high = (middle, high) if neck <= 0 or volume < bridge.volume else (low, middle)
    neck, curvature, _ = toroid(bridge, s, low)
    r = bridge.radius
    first = (low, r * (1 / neck - curvature))
    return bridge.tension * r * forces(bridge.volume / r**3, bridge.theta, np.asarray(gaps) / r, first)
