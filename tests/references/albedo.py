"""Writes albedo.csv: the directional albedo with coef = 1, by nested quadrature over the light's own angles.

With V = (sin θ, 0, cos θ) and L = (-sin μ cos ψ, sin μ sin ψ, cos μ) the integral of f_r cos μ sin μ runs
over μ in [0, π/2] and ψ in [0, π], twice; the mirror direction is (θ, 0). f_r is written out in vectors
from the models' definitions. scipy's QUADPACK, absolute errors from its own estimates; the inner integral
is split where the V-cavities' G changes its branch, found by bisection. Cross-check, asserted: the same
with the order of integration exchanged and other break points.

cs16 is max(0, 1 - n (1 - c)/16)^16, cos-n is max(0, c)^n. θ is in radians, a double used exactly.
Rerun: python3 tests/references/albedo.py
"""
import csv
import os
from math import cos, pi, radians, sin, sqrt

from scipy.integrate import quad


def lobe_of(name, n):
    if name == "cos-n":
        return lambda versine: (1 - versine) ** n if versine < 1 else 0.0
    return lambda versine: (1 - n * versine / 16) ** 16 if n * versine < 16 else 0.0


def integrand(model, use, lobe, n, theta):
    """f_r (N·L) sin μ as a function of μ and ψ, and which branch of G holds there."""
    value = lobe_of(lobe, n)
    vx, vz = sin(theta), cos(theta)

    def of(mu, psi, branch=False):
        lx, ly, lz = -sin(mu) * cos(psi), sin(mu) * sin(psi), cos(mu)
        if lz <= 0:
            return 0.0
        if model.startswith("phong"):
            # |R - L|²/2 with R = (-vx, 0, vz)
            d = value(((lx + vx) ** 2 + ly ** 2 + (lz - vz) ** 2) / 2)
            return (d if model == "phong" else d * lz) * sin(mu)
        hx, hy, hz = lx + vx, ly, lz + vz
        length = sqrt(hx * hx + hy * hy + hz * hz)
        hx, hy, hz = hx / length, hy / length, hz / length
        d = value((hx * hx + hy * hy + (hz - 1) ** 2) / 2)
        vh = vx * hx + vz * hz
        if use == "microfacet":
            branches = [1.0, 2 * hz * vz / vh, 2 * hz * lz / vh]
            if branch:
                return branches.index(min(branches))
            return d * min(branches) / (4 * lz * vz) * lz * sin(mu)
        if model == "blinn-phong":
            return d * sin(mu)
        if model == "blinn-phong-modified":
            return d * lz * sin(mu)
        return d * (hz if model == "blinn-phong-heightfield" else 1.0) / (4 * vh) * sin(mu)

    return of


def pieces(low, high, centre, width, steps):
    ends = {low, high}
    for k in steps:
        ends |= {x for x in (centre - k * width, centre + k * width) if low < x < high}
    return sorted(ends)


def with_switches(branch, ends):
    """The ends, and between them every argument at which the branch changes."""
    found = set(ends)
    for a, b in zip(ends, ends[1:]):
        steps = [a + (b - a) * (k + 0.5) / 24 for k in range(24)]
        for low, high in zip(steps, steps[1:]):
            start = branch(low)
            if start == branch(high):
                continue
            for _ in range(50):
                middle = (low + high) / 2
                low, high = (middle, high) if branch(middle) == start else (low, middle)
            found.add(high)
    return sorted(found)


def nested(f, outer, inner, branch=None):
    """∫∫ f(outer, inner) and its error: outer's estimate and the inner ones' sum over the range."""
    worst = [0.0]

    def line(x):
        total = 0.0
        ends = with_switches(lambda y: branch(x, y), inner) if branch else inner
        for a, b in zip(ends, ends[1:]):
            value, error = quad(lambda y: f(x, y), a, b, epsabs=1e-16, epsrel=1e-13, limit=400)[:2]
            total += value
            worst[0] = max(worst[0], error)
        return total

    total, error = 0.0, 0.0
    for a, b in zip(outer, outer[1:]):
        value, estimate = quad(line, a, b, epsabs=1e-14, epsrel=1e-12, limit=400)[:2]
        total, error = total + value, error + estimate
    return 2 * total, 2 * (error + worst[0] * (len(inner) + 5) * (outer[-1] - outer[0]))


CASES = [
    ("phong", "printed", "cos-n", 16.0, 80), ("phong", "printed", "cs16", 64.0, 60),
    ("phong-modified", "printed", "cos-n", 64.0, 75), ("phong-modified", "printed", "cs16", 1024.0, 89),
    ("blinn-phong", "printed", "cos-n", 16.0, 45), ("blinn-phong", "printed", "cs16", 256.0, 70),
    ("blinn-phong-modified", "printed", "cos-n", 64.0, 60), ("blinn-phong-modified", "printed", "cs16", 16.0, 30),
    ("blinn-phong-ndf", "printed", "cos-n", 16.0, 30), ("blinn-phong-ndf", "printed", "cs16", 64.0, 85),
    ("blinn-phong-heightfield", "printed", "cos-n", 256.0, 80),
    ("blinn-phong-heightfield", "printed", "cs16", 16.0, 45),
    ("blinn-phong-ndf", "microfacet", "cos-n", 64.0, 45), ("blinn-phong-ndf", "microfacet", "cs16", 256.0, 75),
    ("blinn-phong-heightfield", "microfacet", "cos-n", 1024.0, 85),
    ("blinn-phong-heightfield", "microfacet", "cs16", 16.0, 60),
    ("blinn-phong-heightfield", "microfacet", "cos-n", 16.0, 20),
    ("blinn-phong-heightfield", "microfacet", "cs16", 64.0, 89),
]

rows, largest = [], 0.0
for model, use, lobe, n, degrees in CASES:
    theta = radians(degrees)
    f = integrand(model, use, lobe, n, theta)
    width = (1 if model.startswith("phong") else 2) / sqrt(n)
    mu = pieces(0.0, pi / 2, theta, width, (0, 1, 3, 6))
    psi = pieces(0.0, pi, 0.0, width / sin(theta), (1, 3, 6))
    branch = (lambda mu, psi: f(mu, psi, branch=True)) if use == "microfacet" else None
    exchange = (lambda psi, mu: branch(mu, psi)) if branch else None
    value, error = nested(f, mu, psi, branch)
    mu = pieces(0.0, pi / 2, theta, width, (0.3, 2, 5))
    psi = pieces(0.0, pi, 0.0, width / sin(theta), (0.7, 2, 5))
    other, other_error = nested(lambda psi, mu: f(mu, psi), psi, mu, exchange)
    assert abs(value - other) <= error + other_error, (model, use, lobe, n, degrees, value, other)
    best, stated = min((value, error), (other, other_error), key=lambda pair: pair[1])
    largest = max(largest, stated / best)
    rows.append([model, use, lobe, repr(n), repr(theta), f"{best:.15e}", f"{stated:.1e}"])
    print(rows[-1], f"exchanged: {value - other:.1e}", flush=True)

print(f"largest relative error {largest:.1e}")
assert largest < 1e-8
path = os.path.join(os.path.dirname(os.path.abspath(__file__)), "albedo.csv")
with open(path, "w", newline="") as file:
    writer = csv.writer(file, lineterminator="\n")
    writer.writerow(["model", "use", "lobe", "n", "theta", "value", "error"])
    writer.writerows(rows)
