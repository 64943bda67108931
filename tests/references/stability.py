"""Writes stability.csv, 40 significant digits, mpmath at 80: values to hold the double-double reference to.

Arguments are exact doubles, printed so that they read back. Rerun: python3 tests/references/stability.py
"""
import csv
from pathlib import Path

from mpmath import acos, cos, erf, erfc, exp, log, mp, mpf, pi, quad, sin, sqrt

mp.dps = 80
HERE = Path(__file__).parent

ANGLES = [1e-8, 3.7e-6, 1e-3, 0.1, 0.7, 1.2, 1.5, 1.5707963267948966]
EXPONENTS = [1.0, 16.0, 200.0, 1e6, 1e12]


def text(value):
    return mp.nstr(value, 40, strip_zeros=False, min_fixed=0, max_fixed=0) if value else "0"


def factor_cos_n(model, n):
    """1/(2 pi Int) by the integral's closed form in c = cos of the lobe's own angle."""
    q = mpf(2) ** (-n / 2)
    return {
        "phong": (n + 1) / (2 * pi),
        "phong-modified": (n + 2) / (2 * pi),
        "blinn-phong": (n + 2) / (4 * pi * (2 - q)),
        "blinn-phong-modified": (n + 2) * (n + 4) / (8 * pi * (q + n)),
    }[model]


def factor_cs_16(model, n):
    """1/(2 pi Int) by quadrature over w = 1 - cos of the lobe's own angle."""
    half = model.startswith("blinn")
    edge = 1 - sqrt(mpf(1) / 2) if half else mpf(1)
    end = min(16 / n, edge)

    def weight(c):
        if model == "phong":
            return 1
        if model == "phong-modified":
            return c
        return 4 * c if model == "blinn-phong" else 4 * c * (2 * c * c - 1)

    return 1 / (2 * pi * quad(lambda w: (1 - n * w / 16) ** 16 * weight(1 - w), [0, end / 2, end]))


def clip_cut(d, sigma):
    """The pixel's volume beyond d, cut at r = 1/2: in polar coordinates."""
    radius = mpf(1) / 2
    rim = exp(-radius**2 / (2 * sigma**2))
    alpha = acos(d / radius)
    inner = lambda phi: exp(-(d / cos(phi)) ** 2 / (2 * sigma**2)) - rim
    # Close to alpha the exponential turns within d of it.
    ends = [mpf(0)] + [alpha - alpha / 4**k for k in range(1, 16)] + [alpha]
    return quad(inner, ends) / (pi * (1 - rim))


rows = []
for x in ANGLES:
    theta = mpf(x)
    rows.append(["versine", x, "", 2 * sin(theta / 2) ** 2])
    rows.append(["cosine", x, "", cos(theta)])
    rows.append(["sine", x, "", sin(theta)])
    for n in EXPONENTS:
        t, c = n * 2 * sin(theta / 2) ** 2, cos(theta)
        power = exp(n * log(c))
        if power > mpf(10) ** -280:
            rows.append(["cos-n", x, n, power])
        rows.append(["cs-16", x, n, max(1 - t / 16, mpf(0)) ** 16])
        rows.append(["schlick", x, n, c / (c + t)])
        if t < 600:
            rows.append(["spherical-gaussian", x, n, exp(-t)])
for x in [1e-20, 1e-9, 0.25, 0.37, 0.38, 0.5, 0.9, 0.9999]:
    rows.append(["log-one-minus", x, "", log(1 - mpf(x))])
for x in [-640.0, -20.25, -1.0, -1e-3, 0.0, 1e-9, 0.3, 37.0]:
    rows.append(["exp", x, "", exp(mpf(x))])
for x in [1e-10, 1e-3, 0.5, 1.0, 2.1, 3.5]:
    rows.append(["erf", x, "", erf(mpf(x))])
for n in [0.5, 1.0, 7.3, 16.0, 40.0, 60.0, 1e6, 1e12]:
    for model in ["phong", "phong-modified", "blinn-phong", "blinn-phong-modified"]:
        rows.append(["cos-n-factor/" + model, n, "", factor_cos_n(model, mpf(n))])
        rows.append(["cs-16-factor/" + model, n, "", factor_cs_16(model, mpf(n))])
SIGMA = 1 / 6
for x in [1e-8, 1e-4, 0.01, 0.1, 0.25, 0.35, 0.36, 0.45, 0.499]:
    rows.append(["clip-volume", x, SIGMA, erfc(mpf(x) / (mpf(SIGMA) * sqrt(2))) / 2])
    rows.append(["clip-volume-cut", x, SIGMA, clip_cut(mpf(x), mpf(SIGMA))])

with open(HERE / "stability.csv", "w", newline="") as file:
    out = csv.writer(file, lineterminator="\n")
    out.writerow(["function", "x", "y", "value"])
    for function, x, y, value in rows:
        out.writerow([function, repr(x), repr(y) if y != "" else "", text(value)])
