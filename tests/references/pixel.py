"""Writes the tables of the pixel kernels, 20 significant digits, mpmath at 60 (areas and volumes at 30).

pixel_footprints.csv: Q of a point and the axes of J J^T and J J^T + I from the entries of the inverse matrix
and from trace and determinant, at 60 digits, where their cancellation does not matter. Arguments are floats of
single precision, so that both types read them exactly, except in rows beyond its range. Rows without u and v
are for the axes alone.

pixel_polygons.csv: u, v and their derivatives by the quotient rule.

pixel_coverage.csv: area of the unit square about (u, v) in the ellipse, by slices: the integral over v of the
length of the row inside, between the places where that length has a kink. half_plane: the square clipped
against the line at the distance (1 - sqrt Q)/|grad sqrt Q|, by Sutherland and Hodgman's algorithm.

pixel_clip.csv: volume of a Gaussian pixel beyond a line, whole by mpmath's erfc, and cut at a radius by one
integral over x = r cos psi of the normal density times erf; three rows are checked by a double integral.

Rerun: python3 tests/references/pixel.py (ten seconds)
"""
import csv
import random
from pathlib import Path

import numpy as np
from mpmath import atan2, cos, erf, erfc, exp, mp, mpf, nstr, pi, quad, sin, sqrt

HERE = Path(__file__).resolve().parent
mp.dps = 60


def text(value):
    return "0" if value == 0 else nstr(value, 20, strip_zeros=False, min_fixed=0, max_fixed=0)


def write(name, header, rows):
    with open(HERE / name, "w", newline="") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(header)
        out.writerows(rows)


def single(x):
    return float(np.float32(float(x)))


def matrix(j, pad):
    ux, vx, uy, vy = map(mpf, j)
    return ux * ux + uy * uy + pad, ux * vx + uy * vy, vx * vx + vy * vy + pad


def q(j, pad, u, v):
    uu, uv, vv = matrix(j, pad)
    u, v = mpf(u), mpf(v)
    return (vv * u * u - 2 * uv * u * v + uu * v * v) / (uu * vv - uv * uv)


def axes(j, pad):
    mp.dps = 1500  # aspects of 1e600, squared
    uu, uv, vv = matrix(j, pad)
    root = sqrt((uu - vv) ** 2 + 4 * uv * uv)
    found = sqrt((uu + vv + root) / 2), sqrt(abs(uu + vv - root) / 2)
    tilt = atan2(2 * uv, uu - vv) / 2 if root != 0 else mpf(0)
    if uu * vv == uv * uv:
        found = found[0], mpf(0)
    mp.dps = 60
    return (*map(lambda x: +x, found), +tilt)


def jacobian(draw, major, aspect, mirrored=False):
    """Rotation, axes, rotation, rounded to single precision, which alters the aspect a little."""
    a, b = draw.uniform(-3.2, 3.2), draw.uniform(-3.2, 3.2)
    major, minor = mpf(major), mpf(major) / mpf(aspect)
    m = [[cos(a) * major, -sin(a) * minor], [sin(a) * major, cos(a) * minor]]
    r = [[cos(b), -sin(b)], [sin(b), cos(b)]]
    p = [[sum(m[i][k] * r[k][l] for k in (0, 1)) for l in (0, 1)] for i in (0, 1)]
    j = [p[0][0], p[1][0], p[0][1], p[1][1]]
    return [single(-x if mirrored and i > 1 else x) for i, x in enumerate(j)]


EXTREME = [
    (1e20, 0.0, 0.0, 1e-20),
    (1e20, 1e-30, 1e20, 2e-30),
    (1.0, 1.0, 1.0, 1.0 + 2.0**-23),
    (1e38, 1e38, -1e38, 1e38),
    (1e-40, 0.0, 0.0, 3e-41),
    (3.0, 1.0, 6.0, 2.0),
    (0.0, 0.0, 0.0, 0.0),
    (0.0, 5.0, 0.0, 0.0),
    (2.0, -1.0, 1.0, 2.0),
    (2.0, 1.0, 1.0, -2.0),
    (0.0, 3.0, 2.0, 0.0),
    (1e300, 1e300, -1e-300, 1e-300),
    (1e-200, 1e200, 3e-200, 1e200),
    (1e-310, 0.0, 0.0, 1e300),
]


def footprints():
    draw = random.Random(20)
    rows = []
    for major in (1e-18, 1e-6, 1.0, 40.0, 1e6, 1e18):
        for aspect in (1, 3, 100, 1e4, 1e6):
            for k in range(4):
                j = jacobian(draw, major, aspect, k % 2 == 1)
                x, y = draw.uniform(-1, 1), draw.uniform(-1, 1)
                u, v = single(j[0] * x + j[2] * y), single(j[1] * x + j[3] * y)
                rows.append((j, (u, v)))
    for major in (1e-150, 1e150):
        for aspect in (1, 1e6, 1e14):
            j = [x * major for x in jacobian(draw, 1.0, aspect)]
            rows.append((j, (j[0] * 0.75 + j[2] * 0.5, j[1] * 0.75 + j[3] * 0.5)))
    rows += [([x if abs(x) > 1e100 or 0 < abs(x) < 1e-100 else single(x) for x in j], None) for j in EXTREME]
    for j, at in rows:
        a, b, tilt = axes(j, 0)
        c, d, _ = axes(j, 1)
        points = (*map(repr, at), text(q(j, 0, *at)), text(q(j, 1, *at))) if at else [""] * 4
        yield (*map(repr, j), *points, *map(text, (a, b, tilt, c, d)))


def polygons():
    draw = random.Random(21)
    for k in range(60):
        rows = [[single(draw.uniform(-2, 2)) for _ in range(3)] for _ in range(2)]
        # Every third plane nears its horizon; the last fifteen are scaled.
        w = [single(draw.uniform(-1, 1) * 2.0 ** -(k % 3)) for _ in range(2)]
        x, y = single(draw.uniform(-8, 8)), single(draw.uniform(-8, 8))
        w.append(single(draw.uniform(0.01, 4) - w[0] * x - w[1] * y))
        if k >= 45:
            rows, w = [[c * 2.0**60 for c in row] for row in rows], [c * 2.0**40 for c in w]
        a, b, w3 = ([mpf(c) for c in row] for row in (*rows, w))
        value = lambda row: row[0] * mpf(x) + row[1] * mpf(y) + row[2]
        below = value(w3)
        u, v = value(a) / below, value(b) / below
        slope = lambda row, of, i: (row[i] - of * w3[i]) / below
        out = [u, v, slope(a, u, 0), slope(b, v, 0), slope(a, u, 1), slope(b, v, 1)]
        yield (*map(repr, (*rows[0], *rows[1], *w, x, y)), *map(text, out))


def sliced(j, pad, u, v):
    """Area of the square in the ellipse, and the length inside of a row, a function with kinks."""
    mp.dps = 30
    uu, uv, vv = matrix(j, pad)
    det = uu * vv - uv * uv
    u0, u1, v0, v1 = mpf(u) - 0.5, mpf(u) + 0.5, mpf(v) - 0.5, mpf(v) + 0.5
    height = sqrt(vv)

    def length(t):
        inside = 1 - t * t / vv
        if inside <= 0:
            return mpf(0)
        half, middle = sqrt(inside * det / vv), t * uv / vv
        return max(min(u1, middle + half) - max(u0, middle - half), mpf(0))

    kinks = {v0, v1, -height, height}
    for edge in (u0, u1):
        if edge * edge < uu:
            half, middle = sqrt((1 - edge * edge / uu) * det / uu), edge * uv / uu
            kinks |= {middle - half, middle + half}
    places = sorted(t for t in kinks if v0 <= t <= v1)
    area = sum(quad(length, [a, b]) for a, b in zip(places, places[1:]))
    mp.dps = 60
    return area


def clipped(j, pad, u, v):
    uu, uv, vv = matrix(j, pad)
    det = uu * vv - uv * uv
    u, v = mpf(u), mpf(v)
    gu, gv = (vv * u - uv * v) / det, (uu * v - uv * u) / det
    size, root = sqrt(gu * gu + gv * gv), sqrt(q(j, pad, u, v))
    distance = (1 - root) * root / size
    height = lambda p: distance - (p[0] * gu + p[1] * gv) / size
    half = mpf(1) / 2
    square = [(-half, -half), (half, -half), (half, half), (-half, half)]
    kept = []
    for a, b in zip(square, square[1:] + square[:1]):
        ha, hb = height(a), height(b)
        if ha >= 0:
            kept.append(a)
        if (ha >= 0) != (hb >= 0):
            t = ha / (ha - hb)
            kept.append((a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])))
    pairs = zip(kept, kept[1:] + kept[:1])
    return sum(a[0] * b[1] - a[1] * b[0] for a, b in pairs) / 2


def coverages():
    draw = random.Random(22)
    cases = []
    for major, aspect in [(0.25, 1), (0.5, 8), (0.7, 1), (1, 3), (3, 2), (3, 30), (20, 1), (20, 40), (500, 3), (500, 500)]:
        for k in range(12):
            j = jacobian(draw, major, aspect, k % 2 == 1)
            # Near the rim, but for every fourth; the smallest also near the middle.
            t = draw.uniform(0, 6.28)
            r = draw.uniform(0, 1.2) if k % 4 == 0 else 1
            u, v = (j[i] * r * float(cos(t)) + j[i + 2] * r * float(sin(t)) for i in (0, 1))
            cases.append((j, 0, u + draw.uniform(-0.5, 0.5), v + draw.uniform(-0.5, 0.5)))
    for k in range(10):
        j = jacobian(draw, 0.5 + k, 1000)
        cases.append((j, 1, j[0] + draw.uniform(-1, 1), j[1] + draw.uniform(-1, 1)))
    # The middle, corners and edges on the rim, tangent edges, an ellipse within the square.
    circle = lambda r: [r, 0.0, 0.0, r]
    cases += [(circle(0.5), 0, 0.0, 0.0), (circle(0.25), 0, 0.25, 0.125), (circle(0.625), 0, 0.0, 0.0)]
    cases += [(circle(2.0), 0, 2.5, 0.0), (circle(2.0), 0, 2.25, 0.0), (circle(5.0), 0, 3.5, 4.5)]
    cases += [(circle(5.0), 0, 2.5, 3.5), ([3.0, 0.0, 0.0, 0.0625], 0, 0.25, 0.0)]
    for j, pad, u, v in cases:
        u, v = single(u), single(v)
        half = text(clipped(j, pad, u, v)) if (u, v) != (0.0, 0.0) else ""
        yield (*map(repr, j), "padded" if pad else "plain", repr(u), repr(v), text(sliced(j, pad, u, v)), half)


def clips():
    cases = [(k / 64, 1 / 6, 0.5) for k in range(33)]
    for s, r in [(1 / 6, 1.0), (0.25, 0.5), (1.0, 0.5), (50.0, 0.5), (1e6, 0.5), (0.05, 0.5), (0.02, 0.5), (3.0, 17.0)]:
        cases += [(r * t, s, r) for t in (0.0, 1e-9, 1e-3, 0.1, 0.5, 0.7, 0.70710678, 0.72, 0.9, 0.999)]
    for index, (d, s, r) in enumerate(cases):
        d, s, r = (single(x) for x in (d, s, r))
        mp.dps = 40
        dd, ss, rr = mpf(d), mpf(s), mpf(r)
        whole = erfc(dd / (ss * sqrt(mpf(2)))) / 2
        a = mp.acos(dd / rr)
        density = lambda x: exp(-x * x / (2 * ss * ss)) / (ss * sqrt(2 * pi))
        slice_ = lambda psi: rr * sin(psi) * density(rr * cos(psi)) * erf(rr * sin(psi) / (ss * sqrt(mpf(2))))
        # Where the Gaussian is narrow, its peak is at the end of the range.
        norm = -mp.expm1(-rr * rr / (2 * ss * ss))
        cut = quad(slice_, [a * k / 8 for k in range(9)]) / norm
        if index in (8, 20, 47):
            mp.dps = 20
            plane = lambda x, y: exp(-(x * x + y * y) / (2 * ss * ss)) / (2 * pi * ss * ss)
            row = lambda x: 2 * quad(lambda t: sqrt(rr * rr - x * x) * plane(x, t * sqrt(rr * rr - x * x)), [0, 1])
            assert abs(quad(row, [dd, rr]) / norm - cut) < mpf("1e-15"), (d, s, r)
        mp.dps = 60
        yield (repr(d), repr(s), repr(r), text(whole), text(cut))


if __name__ == "__main__":
    write(
        "pixel_footprints.csv",
        "ux,vx,uy,vy,u,v,q,q_padded,major,minor,tilt,major_padded,minor_padded".split(","),
        footprints(),
    )
    write("pixel_polygons.csv", "a1,b1,c1,a2,b2,c2,d,e,f,x,y,u,v,ux,vx,uy,vy".split(","), polygons())
    write("pixel_coverage.csv", "ux,vx,uy,vy,padding,u,v,area,half_plane".split(","), coverages())
    write("pixel_clip.csv", "d,sigma,radius,whole,cut".split(","), clips())
