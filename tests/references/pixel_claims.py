"""References for tests/pixel_claims.rs: the numbers that the pixel paper's claims come to.

Writes pixel_claims.csv beside itself: claim, reading, lo, hi (equal but for a range over the rim), 20 digits.
Everything from definitions by mpmath's quadrature and root finding at 40 digits; nothing here knows the
closed forms that the crate uses. Suprema of products are confirmed over the whole ellipse by a grid.
"""

import csv
import pathlib

import numpy as np
from mpmath import mp, mpf

mp.dps = 40
DIGITS = 20
rows = []


def row(claim, reading, lo, hi=None):
    hi = lo if hi is None else hi
    text = lambda x: mp.nstr(x, DIGITS, strip_zeros=False)
    rows.append([claim, reading, text(lo), text(hi)])


def largest(f, lo, hi, steps=4000):
    """Largest |f| on [lo, hi]: a scan, then ternary search around the best point."""
    lo, hi = mpf(lo), mpf(hi)
    fast = [abs(float(f(lo + (hi - lo) * k / steps))) for k in range(steps + 1)]
    k = int(np.argmax(fast))
    a, b = lo + (hi - lo) * max(k - 1, 0) / steps, lo + (hi - lo) * min(k + 1, steps) / steps
    golden = (mp.sqrt(5) - 1) / 2
    c, d = b - golden * (b - a), a + golden * (b - a)
    fc, fd = abs(f(c)), abs(f(d))
    # The value at a maximum is known to twice the digits of its place.
    for _ in range(110):
        if fc > fd:
            b, d, fd = d, c, fc
            c = b - golden * (b - a)
            fc = abs(f(c))
        else:
            a, c, fc = c, d, fd
            d = a + golden * (b - a)
            fd = abs(f(d))
    return max(abs(f(a)), abs(f(b)), fc, fd)


# The Gaussian and its base: σ = 1/6 of the diameter, r in diameters.
sigma = mpf(1) / 6
ring = lambda r: r / sigma**2 * mp.exp(-(r**2) / (2 * sigma**2))
inside = mp.quad(ring, [0, 0.25, 0.5])
row("P3", "volume 1/plane", inside + mp.quad(ring, [0.5, 1, 2, 4]))
row("P3", "volume 1/ellipse", inside)
row("P4", "beyond the base", 1 - inside)


# (8): t = n x²/2.
def bell(t, reach, power):
    return max(1 - t / reach, mpf(0)) ** power


def distance(reach, power, to=60):
    return largest(lambda t: mp.exp(-t) - bell(t, reach, power), 0, to)


for power in (2, 4, 8, 16):
    name = f"how accurate/{power}/"
    row("P8", name + "sup", distance(mpf(power), power))
    # n = 8: along x, and around the axis.
    end = mp.sqrt(mpf(power) / 4)
    curve = lambda x: (1 - 4 * x**2 / power) ** power
    gauss = lambda x: mp.exp(-4 * x**2)
    row("P8", name + "volume", mp.quad(lambda x: curve(x) * x, [0, end]) / mp.quad(lambda x: gauss(x) * x, [0, mp.inf]))
    row("P8", name + "area", mp.quad(curve, [0, end]) / mp.quad(gauss, [0, mp.inf]))

    # Least where the largest error on either side is the same: by two tangencies.
    def balance(reach, power=power):
        slope = lambda t: -mp.exp(-t) + power / reach * (1 - t / reach) ** (power - 1)
        ts = [mpf(k) / 50 for k in range(1, int(50 * reach))]
        signs = [slope(t) for t in ts]
        roots = [
            mp.findroot(slope, (ts[i], ts[i + 1]), solver="anderson", tol=1e-60)
            for i in range(len(ts) - 1)
            if signs[i] * signs[i + 1] < 0
        ]
        errors = [mp.exp(-t) - bell(t, reach, power) for t in roots] + [mp.exp(-reach)]
        return max(errors), -min(errors)

    lo, hi = mpf(power), mpf(2 * power + 2)
    for _ in range(80):
        mid = (lo + hi) / 2
        below, above = balance(mid)
        if below > above:
            lo = mid
        else:
            hi = mid
    row("P8", name + "best-sup", max(balance(lo)))
    row("P8", name + "best-n", 8 * power / lo)
best = rows[[r[1] for r in rows].index("how accurate/8/best-sup")]
row("P8", "no other n is nearer", mpf(best[2]))
row("P8", "nearer with larger K", distance(mpf(2), 2))
row("P8", "for every x, uncut", 1 - mp.exp(-16))

# (9) against e^(-9 Q/2), Q = a² + b².
scales = {"R1": mpf(1), "R2": mpf(9) / 16, "R3": mpf(1) / 2, "R4": mpf(1) / 8}


def weight(c, shape, aa, bb):
    cut = lambda x: max(1 - c * x, mpf(0)) ** 8
    return cut(aa + bb) if shape == "sum" else cut(aa) * cut(bb)


def grid(c, shape, to):
    """Largest distance over a grid of (Q, share of a²), in doubles."""
    q, share = np.meshgrid(np.linspace(0, to, 1601), np.linspace(0, 1, 401))
    cut = lambda x: np.maximum(1 - float(c) * x, 0) ** 8
    w = cut(q) if shape == "sum" else cut(q * share) * cut(q * (1 - share))
    return np.max(np.abs(np.exp(-4.5 * q) - w))


for name, c in scales.items():
    for shape in ("sum", "product"):
        error = {}
        for region, to in (("ellipse", mpf(1)), ("plane", mpf(16))):
            lines = [mpf(1)] if shape == "sum" else [mpf(1), mpf(1) / 2]
            error[region] = max(
                largest(lambda q, s=s: weight(c, shape, q * s, q * (1 - s)) - mp.exp(-mpf(9) / 2 * q), 0, to)
                for s in lines
            )
            seen = grid(c, shape, float(to))
            assert seen <= error[region] + mpf("1e-12") and seen > error[region] - mpf("1e-4"), (name, shape, region)
            row("P9", f"how far from the Gaussian/{name}/{shape}/sup/{region}", error[region])
            row("P9", f"the nearest of the four/{name}/{shape}/{region}", error[region])
        end = min(mpf(1), 1 / c)
        gaussian = 2 * mp.pi / 9
        if shape == "sum":
            whole = lambda to: mp.pi * mp.quad(lambda q: (1 - c * q) ** 8, [0, to])
            ellipse, plane = whole(end), whole(1 / c)
        else:
            line = mp.quad(lambda a: (1 - c * a**2) ** 8, [0, 1 / mp.sqrt(c)])
            plane = 4 * line**2
            # By columns: ∫ over b up to √(1 - a²).
            inner = lambda a: mp.quad(lambda b: (1 - c * b**2) ** 8, [0, mp.sqrt(1 - a**2)])
            ellipse = 4 * mp.quad(lambda s: (1 - c * mp.sin(s) ** 2) ** 8 * inner(mp.sin(s)) * mp.cos(s), [0, mp.pi / 2])
        row("P9", f"how far from the Gaussian/{name}/{shape}/volume/ellipse", ellipse / gaussian)
        row("P9", f"how far from the Gaussian/{name}/{shape}/volume/plane", plane / gaussian)
        row("P9", f"has/{name}/{shape}/volume", plane / gaussian)
        rim = [weight(c, shape, mp.cos(f) ** 2, mp.sin(f) ** 2) - mp.exp(-mpf(9) / 2) for f in mp.linspace(0, mp.pi / 2, 201)]
        row("P9", f"how far on the rim/{name}/{shape}", min(rim), max(rim))

# P(d) against volumes cut off, d in diameters.
P = lambda d: mpf("0.5") - d * (mpf("2.151") - mpf("2.358") * d)


def gaussian_marginal(m):
    return lambda x: m / mp.sqrt(2 * mp.pi) * mp.exp(-((m * x) ** 2) / 2)


def radial_marginal(g):
    """Of a height g(r) on r ≤ ½: by quadrature along the chord, y = √(¼ - x²) sin."""
    total = mp.quad(lambda r: 2 * mp.pi * r * g(r), [0, 0.25, 0.5])

    def marginal(x):
        end = mp.sqrt(mpf(1) / 4 - x**2)
        # tanh-sinh copes with the cone's steep middle.
        return 2 * mp.quad(lambda y: g(mp.sqrt(x**2 + y**2)), [0, end / 64, end]) / total

    return marginal


heights = {
    "gaussian-6-base": lambda r: mp.exp(-18 * r**2),
    "disk": lambda r: mpf(1),
    "cone": lambda r: 1 - 2 * r,
    "bell-8": lambda r: (1 - 4 * r**2) ** 8,
}
totals = {name: mp.quad(lambda r: 2 * mp.pi * r * g(r), [0, 0.25, 0.5]) for name, g in heights.items()}
marginals = {f"gaussian-{m}": gaussian_marginal(m) for m in (6, 5, 4)}
marginals |= {name: radial_marginal(g) for name, g in heights.items()}


def beyond(name, d):
    if name in ("gaussian-6", "gaussian-5", "gaussian-4"):
        return mp.quad(marginals[name], [d, 0.5, 1, 2, 4])
    # By rings: the ring of radius r lies beyond the edge over the angle 2 arccos(d/r).
    g = heights[name]
    ring = lambda r: 2 * r * g(r) * mp.acos(min(d / r, mpf(1)))
    return mp.quad(ring, [d, (d + mpf(1) / 2) / 2, mpf(1) / 2]) / totals[name]


def farthest(name):
    """Extremes of P - V are where P' = -marginal, or at an end."""
    f = lambda d: mpf("2.151") - 2 * mpf("2.358") * d - marginals[name](d)
    ds = [mpf(k) / 400 for k in range(1, 200)]
    mp.dps = 15
    signs = [f(d) for d in ds]
    mp.dps = 30
    places = [mp.findroot(f, (ds[i], ds[i + 1]), solver="anderson", tol=1e-40) for i in range(len(ds) - 1) if signs[i] * signs[i + 1] < 0]
    assert places, name
    return max(abs(P(d) - beyond(name, d)) for d in places + [mpf(0), mpf(1) / 2])


def solve(name, points, fixed):
    ds = [mpf(i) / (2 * (points - 1)) for i in range(points)]
    powers = [1, 2] if fixed else [0, 1, 2]
    a = mp.matrix([[d**k for k in powers] for d in ds])
    v = mp.matrix([VOLUMES[name, d] - (mpf("0.5") if fixed else 0) for d in ds])
    return -mp.lu_solve(a.T * a, a.T * v)[len(powers) - 2]


mp.dps = 30
for name in ("gaussian-6", "gaussian-6-base", "gaussian-5", "gaussian-4", "disk", "cone", "bell-8"):
    row("P10", f"how far from the volume/{name}", farthest(name))
VOLUMES = {}
for name in ("gaussian-6", "gaussian-6-base", "gaussian-5"):
    for points in (6, 11, 21, 51, 101):
        for i in range(points):
            d = mpf(i) / (2 * (points - 1))
            if (name, d) not in VOLUMES:
                VOLUMES[name, d] = beyond(name, d)
    for points in (6, 11, 21, 51, 101):
        for term, fixed in (("free", False), ("fixed", True)):
            row("P10", f"least squares/{name}/{points}/{term}", solve(name, points, fixed))
turn = mpf("2.151") / (2 * mpf("2.358"))
row("P10", "as d grows/falls", P(turn), mpf("0.5"))
row("P10", "as d grows/zero-at-base", P(turn), mpf("0.5"))
row("P10", "a part's volume/-/-", P(turn), mpf("0.5"))
row("P10", "a part's volume/+/-", mpf("0.5"), 1 - P(turn))
row("P10", "a part's volume/-/+", mpf("0.5") - mpf("2.151") / 2 - mpf("2.358") / 4, mpf("0.5"))
row("P10", "a part's volume/+/+", mpf("0.5"), mpf("0.5") + mpf("2.151") / 2 + mpf("2.358") / 4)

# The unit circle in the unit square around (1, 0).
mp.dps = 30
width = lambda x: 2 * min(mpf(1) / 2, mp.sqrt(1 - x**2))
row("P12", "counting/half-plane", mp.quad(width, [0.5, mp.sqrt(3) / 2, 1]))
row("P12", "counting/area", +mp.pi)
row("P12", "counting P(d)", P(mpf(1) / 4))

path = pathlib.Path(__file__).with_name("pixel_claims.csv")
with path.open("w", newline="", encoding="utf-8") as file:
    writer = csv.writer(file, lineterminator="\n")
    writer.writerow(["claim", "reading", "lo", "hi"])
    writer.writerows(rows)
print(len(rows), "rows")
