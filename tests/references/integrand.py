"""Shared by the reference scripts: correctly rounded printing, and closed forms used as cross-checks.

`digits` prints a value only if every number of its ball rounds to the same decimals.
`closed_form` is Int(n) by hand, in mpmath. integrals.py does not print it, it only compares with it.
"""
import csv
import pathlib
from decimal import ROUND_HALF_EVEN, Context, Decimal
from fractions import Fraction

from mpmath import mp, mpf

HERE = pathlib.Path(__file__).resolve().parent
mp.dps = 70

MODELS = ["phong", "phong-modified", "blinn-phong", "blinn-phong-modified",
          "blinn-phong-ndf", "blinn-phong-heightfield"]
LIMITS = ["paper", "card", "exact-zero", "support"]
HALF_ANGLE = {"blinn-phong", "blinn-phong-modified"}  # lobe in θ/2
WITH_COSINE = {"phong-modified", "blinn-phong-modified", "blinn-phong-heightfield"}  # times cos θ


def round_fraction(value, count):
    """A Fraction rounded once, half to even, to `count` significant digits."""
    # Decimal's division is correctly rounded for integers of any length.
    context = Context(prec=count, rounding=ROUND_HALF_EVEN, Emin=-10**6, Emax=10**6)
    return context.divide(Decimal(value.numerator), Decimal(value.denominator))


def exact(x):
    """The exact value of an exact arb, or of an mpf."""
    mantissa, exponent = (int(part) for part in (x.man_exp if isinstance(x, mpf) else x.man_exp()))
    if isinstance(x, mpf) and x < 0:  # mpmath keeps the sign apart
        mantissa = -mantissa
    return Fraction(mantissa) * Fraction(2) ** exponent


def digits(ball, count=30):
    """An arb's value to `count` significant digits, correctly rounded; fails if the ball is too wide."""
    middle, radius = exact(ball.mid()), exact(ball.rad())
    low, high = (round_fraction(middle + r, count) for r in (-radius, radius))
    assert low == high, f"ball too wide: {ball}"
    assert low != 0 or radius == 0
    return "0" if low == 0 else f"{low:.{count - 1}e}"


def to_mpf(ball):
    """An arb's midpoint as an mpf, rounded to the working precision."""
    value = exact(ball.mid())
    return mpf(value.numerator) / value.denominator


def relative(x, reference):
    return abs(x - reference) / abs(reference) if reference else abs(x)


def write(name, header, rows):
    with open(HERE / name, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(header)
        writer.writerows(rows)
    print(f"{name}: {len(rows)} rows")


def limit_mp(model, lobe, limit, n):
    """The upper limit of θ, in mpmath."""
    right = mp.pi / 2
    zero = mp.acos(max(mpf(0), 1 - 16 / n))
    if limit == "paper":
        return min(right, 6 / mp.sqrt(n))
    if limit == "card":
        return min(right, mp.sqrt(6 / n))
    if limit == "support" and lobe == "cos-n":
        return right
    return min(right, 2 * zero) if limit == "support" and model in HALF_ANGLE else zero


def closed_form(model, lobe, limit, n):
    """Int(n) with c the cosine of the lobe's own angle.

    dw = -dc; sin θ dθ is dw, or 4 c dw in θ/2; cos θ is c, or 2 c² - 1. The weight beside the lobe is
    then sum w_k c^k, each term integrated exactly: for cos^n as a power of c, for cs16 in the
    variable p = 1 - n (1 - c)/16, c = (n - 16 + 16 p)/n.
    """
    n = mpf(n)
    half = model in HALF_ANGLE
    end = mp.cos(limit_mp(model, lobe, limit, n) / (2 if half else 1))
    weight = {(False, False): {0: 1}, (False, True): {1: 1},
              (True, False): {1: 4}, (True, True): {3: 8, 1: -4}}[half, model in WITH_COSINE]
    if lobe == "cos-n":
        return sum(w * (1 - end ** (n + k + 1)) / (n + k + 1) for k, w in weight.items())
    p_end = 1 - n * (1 - end) / 16
    total = mpf(0)
    for k, w in weight.items():
        for j in range(k + 1):  # binomial expansion of c^k in p
            term = mp.binomial(k, j) * (1 - 16 / n) ** (k - j) * (16 / n) ** j
            total += w * term * (1 - p_end ** (17 + j)) / (17 + j)
    return total * 16 / n
