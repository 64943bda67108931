"""Writes bells.csv and bell-integrals.csv, 20 significant digits, mpmath at 50.

bells.csv: the cubic p of least max |exp(-t) - p(t)^K| over t >= 0, p = 1 - c1 z + c2 z^2 - c3 z^3, z = t/K,
cut at its zero. The unknowns c1, c2, c3, the four extremes t1..t4 and the level are one system: error and
its derivative at each. Newton's method from three-digit starts; that no other t does worse is asserted
on a grid.

bell-integrals.csv: n Int(n) of a bell p^K, p = (1 - y)(1 + a y + b y^2), y = n (1 - cos psi)/T, with T, a, b
polynomials in 1/n, by quadrature in theta up to its cut or the hemisphere's edge; psi is theta, or theta/2
for the Blinn-Phong models over L.

Rerun: python3 tests/references/bells.py
"""
import csv

from mpmath import acos, cos, exp, findroot, log, mp, mpf, pi, quad, sin

from integrand import HALF_ANGLE, HERE, MODELS, WITH_COSINE

mp.dps = 50

STARTS = {  # c1, c2, c3, extremes, level
    2: ([0.974, 0.403, 0.0645], [0.318, 1.61, 3.73, 5.59], 3.5e-3),
    4: ([0.996, 0.468, 0.102], [0.279, 1.45, 3.61, 6.92], 4.8e-4),
    8: ([0.9995, 0.491, 0.131], [0.255, 1.32, 3.35, 7.20], 5.4e-5),
    16: ([0.99994, 0.498, 0.1486], [0.242, 1.26, 3.19, 6.95], 6.0e-6),
}

# K, then T, a and b as polynomials in 1/n: numbers of no other meaning than to be near those of a fit.
FORMULAS = [
    (2, [5.75, -1.5, 0.25], [-1.75, -0.5, 0.0], [1.5, -3.0, 0.5]),
    (4, [8.75, 0.0, 0.0], [-1.125, -0.25, 0.0], [1.0, -7.0, 2.0]),
    (8, [14.75, 12.0, 0.0], [-0.875, -1.5, 1.0], [0.875, -10.0, -48.0]),
    (16, [16.5, -10.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 0.0]),
]
EXPONENTS = [16, 20, 31.5, 64, 1024, 1e6]


def text(value):
    return mp.nstr(value, 20, strip_zeros=False, min_fixed=0, max_fixed=0)


def p(c, z):
    return 1 - z * (c[0] - z * (c[1] - z * c[2]))


def error(power, c, t):
    return exp(-t) - p(c, t / power) ** power


def slope(power, c, t):
    z = t / power
    return -exp(-t) + p(c, z) ** (power - 1) * (c[0] - 2 * c[1] * z + 3 * c[2] * z * z)


def equioscillating(power):
    c, places, level = STARTS[power]
    first = 1 if error(power, c, mpf(places[0])) > 0 else -1

    def system(*x):
        c, places, level = x[:3], x[3:7], x[7]
        signs = [first * (-1) ** i for i in range(4)]
        return ([error(power, c, t) - s * level for s, t in zip(signs, places)]
                + [slope(power, c, t) for t in places])

    x = findroot(system, [mpf(v) for v in c + places + [level]], tol=mpf(10) ** -45)
    c, places, level = list(x[:3]), list(x[3:7]), abs(x[7])
    cut = findroot(lambda t: p(c, t / power), places[3] * mpf("1.3") if power > 2 else mpf("5.72"))
    grid = [cut * i / 2000 for i in range(2001)]
    assert all(p(c, a / power) > p(c, b / power) for a, b in zip(grid, grid[1:])), "not decreasing"
    assert max(abs(error(power, c, t)) for t in grid) <= level * (1 + mpf(10) ** -40), "not the largest"
    assert exp(-cut) < level
    return c, places, level, cut


def scaled_integral(model, power, reach, linear, square, n):
    n = mpf(n)
    t_end, a, b = (sum(mpf(c) / n**j for j, c in enumerate(row)) for row in (reach, linear, square))
    own = mpf(1) / 2 if model in HALF_ANGLE else mpf(1)
    end = min(pi / 2, acos(1 - t_end / n) / own if t_end < 2 * n else pi)

    def integrand(theta):
        y = n * 2 * sin(own * theta / 2) ** 2 / t_end
        weight = cos(theta) if model in WITH_COSINE else 1
        return ((1 - y) * (1 + a * y + b * y * y)) ** power * weight * sin(theta)

    return n * quad(integrand, [end * i / 4 for i in range(5)])


with open(HERE / "bells.csv", "w", newline="") as file:
    out = csv.writer(file, lineterminator="\n")
    out.writerow(["power", "c1", "c2", "c3", "level", "cut"])
    for power in STARTS:
        c, _, level, cut = equioscillating(power)
        out.writerow([power, *map(text, c), text(level), text(cut)])

with open(HERE / "bell-integrals.csv", "w", newline="") as file:
    out = csv.writer(file, lineterminator="\n")
    out.writerow(["model", "power"] + [f"{name}{j}" for name in ("t", "a", "b") for j in range(3)] + ["n", "scaled"])
    for power, reach, linear, square in FORMULAS:
        for model in MODELS:
            for n in EXPONENTS:
                value = scaled_integral(model, power, reach, linear, square, n)
                out.writerow([model, power, *reach, *linear, *square, n, text(value)])
