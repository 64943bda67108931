"""Writes clip-volume.csv, clip-recipe.csv, clip-fits.csv, skew.csv and weight-errors.csv: the pixel paper's studies.

clip-volume.csv: the volume of a pixel of base diameter 1 beyond a line at distance d, 30 digits, mpmath at 50; by
quadrature of the bell itself over half planes (polar form: the bell times the arc that lies beyond), which shares
nothing with closed forms, except for the whole Gaussian, which is erfc.

clip-recipe.csv: the volume of the whole Gaussian at d = 0, 0.05, ..., 0.5, 30 digits.

clip-fits.csv: least-squares quadratics of the whole Gaussian on equidistant points and continuous, from the normal
equations in mpmath at 50 digits (continuous: moments by quadrature); and minimax polynomials, 12 digits, from linear
programs on a grid refined at its extremes (scipy), with the largest error on a grid ten times as fine.

skew.csv: semi-axes and tilt of J for angle and ratio, from numpy's SVD.

weight-errors.csv: largest |e^(-9Q/2) - weight| over all Q >= 0 and over Q <= 1, on the rim, and the volume ratio, 10
digits: for sums a scan and mpmath's findroot on the derivative, for products a scan in both squares.

Rerun: python3 tests/references/pixel_study.py   (numpy 2.4.6, scipy 1.17.1, mpmath 1.3.0)
"""
import csv
import os

import numpy
from mpmath import acos, erfc, exp, findroot, lu_solve, matrix, mp, mpf, pi, quad, sqrt
from scipy.optimize import linprog
from scipy.special import erfc as erfc_64

mp.dps = 50
HERE = os.path.dirname(os.path.abspath(__file__))


def text(value, digits):
    return mp.nstr(mpf(value), digits, strip_zeros=False, min_fixed=0, max_fixed=0)


def write(name, header, rows):
    with open(os.path.join(HERE, name), "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(header)
        writer.writerows(rows)


def whole(s, d):
    return erfc(d * s / sqrt(2)) / 2


def beyond(bell, d):
    """The arc of radius r beyond the line is 2 arccos(d/r); r = d + (1/2 - d) t^2 smooths its root."""
    d = mpf(d)
    span = mpf(1) / 2 - d

    def part(t):
        r = d + span * t * t
        return bell(r) * r * 2 * acos(d / r) * 2 * span * t if r > 0 else mpf(0)

    total = quad(lambda r: bell(r) * r * 2 * pi, [0, mpf(1) / 2])
    return quad(part, [0, mpf(1) / 2, 1]) / total


def clip_volumes():
    distances = ["0", "0.0625", "0.125", "0.25", "0.375", "0.4375", "0.484375"]
    rows = []
    for s in (6, 5, 4):
        rows += [("gaussian", s, d, text(whole(s, mpf(d)), 30)) for d in distances + ["0.5"]]
    bells = [("gaussian-cut", s, lambda r, s=s: exp(-r * r * s * s / 2)) for s in (6, 5, 4)]
    bells += [("cone", "", lambda r: 1 - 2 * r)]
    names = {0: "disk", 1: "parabola-1", 2: "parabola-2", 8: "parabola-8"}
    bells += [(names[k], "", lambda r, k=k: (1 - 4 * r * r) ** k) for k in (0, 1, 2, 8)]
    for name, s, bell in bells:
        rows += [(name, s, d, text(beyond(bell, mpf(d)), 20)) for d in distances]
    write("clip-volume.csv", ["target", "reciprocal_sigma", "d", "volume"], rows)


def recipe():
    rows = [(s, f"{i / 20:g}", text(whole(s, mpf(i) / 20), 30)) for s in (6, 5) for i in range(11)]
    write("clip-recipe.csv", ["reciprocal_sigma", "d", "volume"], rows)


def squares(s, points, half):
    """c of the quadratic, by the normal equations."""
    first = 1 if half else 0
    offset = mpf(1) / 2 if half else mpf(0)
    powers = range(first, 3)
    if points:
        ds = [mpf(i) / (2 * (points - 1)) for i in range(points)]
        moment = lambda k: sum(d**k for d in ds)
        image = lambda k: sum((whole(s, d) - offset) * d**k for d in ds)
    else:
        moment = lambda k: (mpf(1) / 2) ** (k + 1) / (k + 1)
        image = lambda k: quad(lambda d: (whole(s, d) - offset) * d**k, [0, 0.25, 0.5])
    system = matrix([[moment(j + k) for j in powers] for k in powers])
    c = list(lu_solve(system, matrix([image(k) for k in powers])))
    return [offset] * first + c


def minimax(s, degree, half, falling):
    """Coefficients and level by linear programming."""
    def volume(d):
        return 0.5 * erfc_64(d * s / numpy.sqrt(2.0))

    grid = numpy.linspace(0.0, 0.5, 801)
    for _ in range(4):
        basis = numpy.stack([grid**j for j in range(degree + 1)], 1)
        ones = numpy.ones((len(grid), 1))
        above = [numpy.hstack([basis, -ones]), numpy.hstack([-basis, -ones])]
        right = [volume(grid), -volume(grid)]
        equal, to = [], []
        if falling:
            slope = numpy.stack([j * grid ** max(j - 1, 0) if j else 0 * grid for j in range(degree + 1)], 1)
            above.append(numpy.hstack([slope, 0 * ones]))
            right.append(0 * grid)
            equal.append([0.5**j for j in range(degree + 1)] + [0])
            to.append(0)
        if half:
            equal.append([1] + [0] * (degree + 1))
            to.append(0.5)
        found = linprog([0] * (degree + 1) + [1], A_ub=numpy.vstack(above), b_ub=numpy.concatenate(right),
                        A_eq=equal or None, b_eq=to or None, bounds=[(None, None)] * (degree + 2), method="highs-ds",
                        options={"primal_feasibility_tolerance": 1e-10, "dual_feasibility_tolerance": 1e-10})
        c = found.x[:-1]
        fine = numpy.linspace(0.0, 0.5, 200001)
        error = numpy.abs(sum(c[j] * fine**j for j in range(degree + 1)) - volume(fine))
        inner = numpy.flatnonzero((error[1:-1] >= error[:-2]) & (error[1:-1] >= error[2:])) + 1
        near = [fine[i] + numpy.linspace(-2e-4, 2e-4, 41) for i in inner]
        grid = numpy.unique(numpy.clip(numpy.concatenate([grid] + near), 0.0, 0.5))
    assert error.max() <= found.x[-1] * (1 + 1e-7), "the grid misses an extreme"
    return c, found.x[-1]


def clip_fits():
    rows = []
    for s in (6, 5, 4):
        for points in (6, 11, 21, 51, 101, 0):
            for half in (False, True):
                c = squares(s, points, half)
                rows.append([s, points or "continuous", "half" if half else "free", "ls"]
                            + [text(x, 20) for x in c] + ["", ""])
        for degree in (2, 3):
            for half in (False, True):
                for falling in ((False, True) if s == 6 else (False,)):
                    c, level = minimax(s, degree, half, falling)
                    rows.append([s, "", "half" if half else "free", "minimax-falling" if falling else "minimax"]
                                + [text(x, 12) for x in c] + [""] * (3 - degree) + [text(level, 8)])
    write("clip-fits.csv",
          ["reciprocal_sigma", "points", "constant", "objective", "p0", "p1", "p2", "p3", "level"], rows)


def skews():
    rows = []
    for degrees in (1, 10, 30, 45, 60, 80, 90, 110, 135, 170, -20, -100):
        for ratio in (0.125, 0.5, 0.75, 1.0, 1.25, 3.0):
            if degrees == 90 and ratio == 1.0:
                continue  # a circle: no tilt
            phi = numpy.radians(float(degrees))
            j = numpy.array([[1.0, ratio * numpy.cos(phi)], [0.0, ratio * numpy.sin(phi)]])
            u, sizes, _ = numpy.linalg.svd(j)
            tilt = numpy.degrees(numpy.arctan2(u[1, 0], u[0, 0])) % 180.0
            rows.append([degrees, ratio] + [repr(float(x)) for x in (sizes[0], sizes[1], tilt)])
    write("skew.csv", ["degrees", "ratio", "major", "minor", "tilt_degrees"], rows)


def weight_errors():
    gauss = lambda q: exp(-mpf(9) / 2 * q)
    sums = [(f"r{i}-sum", lambda q, c=c: max(1 - c * q, mpf(0)) ** 8)
            for i, c in enumerate([mpf(1), mpf(9) / 16, mpf(1) / 2, mpf(1) / 8], 1)]
    sums += [(f"bell-{k}", lambda q, k=k: max(1 - mpf(9) / 2 * q / k, mpf(0)) ** k) for k in (2, 4, 8, 16, 32, 64)]
    ends = {"r1-sum": [1], "r2-sum": [mpf(16) / 9], "r3-sum": [2], "r4-sum": [8],
            **{f"bell-{k}": [mpf(2 * k) / 9] for k in (2, 4, 8, 16, 32, 64)}}
    rows = []
    for name, f in sums:
        def largest(end):
            error = lambda q: gauss(q) - f(q)
            scan = [mpf(end) * i / 2000 for i in range(2001)]
            i = max(range(2001), key=lambda i: abs(error(scan[i])))
            if i in (0, 2000):
                return abs(error(scan[i]))
            at = findroot(lambda q: mp.diff(error, q), (scan[i - 1], scan[i + 1]), solver="anderson", tol=1e-25)
            return abs(error(at))
        volume = quad(f, [0, ends[name][0]]) * mpf(9) / 2
        rows.append([name, text(max(largest(1), largest(8)), 10), text(largest(1), 10),
                     text(abs(gauss(mpf(1)) - f(mpf(1))), 10), text(volume, 10)])
    share = numpy.linspace(0.0, 0.5, 1001)[None, :]
    for i, c in enumerate([1.0, 9 / 16, 0.5, 0.125], 1):
        def largest(qs):
            q = qs[:, None]
            bell = lambda x: numpy.maximum(1 - c * x, 0.0) ** 8
            return float(numpy.abs(numpy.exp(-4.5 * q) - bell(q * share) * bell(q * (1 - share))).max())
        side = quad(lambda a: (1 - mpf(c) * a * a) ** 8, [0, 1 / sqrt(mpf(c))])
        volume = 4 * side * side * mpf(9) / (2 * pi)
        rows.append([f"r{i}-product", text(largest(numpy.linspace(0, 8, 16001)), 10),
                     text(largest(numpy.linspace(0, 1, 8001)), 10), text(largest(numpy.array([1.0])), 10),
                     text(volume, 10)])
    write("weight-errors.csv", ["weight", "plane", "ellipse", "rim", "volume"], rows)


clip_volumes()
recipe()
clip_fits()
skews()
weight_errors()
