"""The gas of the small coupled scenes: a jet through the middle of the floor; @jet@ is its speed [m/s]."""

GAS = """\
[grid]
lo = [0.0, 0.0, 0.0]
hi = [0.022, 0.022, 0.11]
cells = [4, 4, 20]
[time]
step = 1e-3
courant_max = 10
[boundary]
z_hi = "outlet"
[solver]
tolerance = 1e-10
[[inflow]]
side = "z_lo"
shape = "rectangle"
center = [0.011, 0.011]
size = [5.5e-3, 5.5e-3]
velocity = @jet@
ramp = 0.002
[output]
every = 0.01
pressure_probes = [0.01]
"""
