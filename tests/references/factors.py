"""Writes factors.csv: the factor 1/(2π Int(n)) of the bell lobe (1 - n (1 - c)/K)^K, 30 significant
digits, correctly rounded; n is an exact double.

Int(n) by rigorous quadrature of the integrand in θ as the paper writes it, over the lobe's whole support
on the hemisphere, in ball arithmetic (python-flint, acb.integral, 300 bits). Cross-checks, both asserted:
the integrand expanded in powers of w = 1 - c, exact in rationals up to the limit of integration, and
mpmath's own quadrature in θ (35 digits). Rerun: python3 tests/references/factors.py
"""
import random
import struct
from fractions import Fraction
from math import comb

from flint import acb, arb, ctx, fmpq
from mpmath import mp, mpf

from integrand import HALF_ANGLE, MODELS, WITH_COSINE, digits, relative, to_mpf, write

ctx.prec = 300
POWERS = [2, 4, 8, 16, 32, 64]
EDGE_HALF = 1 - (arb(1) / 2).sqrt()  # versine of π/4, where θ/2 ends


def single(x):
    """x rounded to the nearest float."""
    return struct.unpack("<f", struct.pack("<f", x))[0]


def around(x):
    """Floats: two below x > 0, and two at or above it."""
    bits = struct.unpack("<I", struct.pack("<f", x))[0]
    near = [struct.unpack("<f", struct.pack("<I", bits + i))[0] for i in range(-3, 4)]
    below, above = [n for n in near if n < x], [n for n in near if n >= x]
    return below[-2:] + above[:2]


# All exact in single precision; 0 and 1/2 lie below the range asked for.
COMMON = [0.0, 0.5, 1.0, 1.0 + 2.0 ** -23, 1.5, 3.0, 5.5, 27.625, 100.25, 777.75, 1024.0,
          12345.5, 99999.9921875, 1e5]
# Where the crate's rounding errors were found largest, over n >= 0: every float for the first column of
# each row, 40 000 doubles for the second. In the order of the first four models.
HARD = {
    2: [(0.7632018, 0.686634524997268), (2.0945733, 568493650.2417213),
        (3.840703, 1.146283585243879), (0.14376813, 0.7376569905830548)],
    4: [(1.768015, 1.8501561615559907), (1.4877454, 0.662373823612169),
        (6.0557384, 5.943221858901012), (6.374478, 6.273497848328939)],
    8: [(1.6075962, 1.6488269877531445), (0.389879, 0.48508681879479765),
        (13.225351, 0.6843037840145016), (8.585194, 0.10403404102937508)],
    16: [(1.6468596, 1.687511720176217), (0.16390085, 0.5251268667659277),
         (11.471464, 0.18366915724185373), (0.24232957, 0.7481768344493689)],
    32: [(0.038424693, 1.6107875212340694), (0.09580208, 0.046347012471743776),
         (5.381397, 24.629009583903656), (0.35570627, 0.9085954397098757)],
    64: [(1.58938, 7.357707689610035), (0.10925678, 0.023891411185670175),
         (25.6499, 0.660627452135193), (0.04799417, 8.61625489364225)],
}


def exponents(model, power):
    found = set(COMMON)
    found.update(around(power))
    found.update(around(float(power / EDGE_HALF.mid())))
    draw = random.Random(power)
    found.update(single(10 ** draw.uniform(0, 5)) for _ in range(4))
    found.update(10 ** draw.uniform(0, 5) for _ in range(2))
    if MODELS.index(model) < 4:
        first, second = HARD[power][MODELS.index(model)]
        found.update((single(first), second))
    return sorted(found)


def is_cut(model, power, n):
    """Whether the hemisphere ends before the lobe's zero does."""
    if model not in HALF_ANGLE:
        return n <= power
    reach = arb(n) * EDGE_HALF
    assert reach < power or reach > power
    return reach < power


def integral(model, power, n):
    half, cosine = model in HALF_ANGLE, model in WITH_COSINE

    def integrand(theta, _):
        c = (theta / 2 if half else theta).cos()
        return (1 - n * (1 - c) / power) ** power * theta.sin() * (theta.cos() if cosine else 1)

    end = arb.pi() / 2 if is_cut(model, power, n) else (1 - power / arb(n)).acos() * (2 if half else 1)
    value = acb.integral(integrand, 0, end)
    assert value.imag.contains(0)
    return value.real


def expanded(model, power, n):
    """The same in w, term by term: dw = -dc, sin θ dθ is dw, or 4 c dw in θ/2, where cos θ = 2 c² - 1."""
    half, cosine = model in HALF_ANGLE, model in WITH_COSINE
    weight = {(False, False): [1], (False, True): [1, -1],
              (True, False): [4, -4], (True, True): [4, -20, 24, -8]}[half, cosine]  # in powers of w
    terms = [Fraction(0)] * (power + len(weight) + 1)
    for j in range(power + 1):
        bell = comb(power, j) * (-Fraction(n) / power) ** j
        for i, factor in enumerate(weight):
            terms[i + j + 1] += bell * factor / (i + j + 1)
    if is_cut(model, power, n) and half:
        end, total = EDGE_HALF, arb(0)
        for term in reversed(terms):
            total = total * end + arb(fmpq(term.numerator, term.denominator))
        return to_mpf(total)
    end, total = Fraction(1) if is_cut(model, power, n) else power / Fraction(n), Fraction(0)
    for term in reversed(terms):
        total = total * end + term
    return mpf(total.numerator) / total.denominator


def quadrature(model, power, n):
    """The same by mpmath, in pieces of a lobe's width."""
    half, cosine = model in HALF_ANGLE, model in WITH_COSINE

    def integrand(theta):
        c = mp.cos(theta / 2 if half else theta)
        return (1 - n * (1 - c) / power) ** power * mp.sin(theta) * (mp.cos(theta) if cosine else 1)

    with mp.workdps(35):
        cut, n = is_cut(model, power, n), mpf(n)
        end = mp.pi / 2 if cut else mp.acos(1 - power / n) * (2 if half else 1)
        pieces = int(mp.ceil(end * mp.sqrt(n) / 3)) or 1
        return mp.quad(integrand, mp.linspace(0, end, pieces + 1))


rows, widest, worst_expanded, worst_quadrature = [], 0, 0, 0
for model in MODELS:
    for power in POWERS:
        for n in exponents(model, power):
            ball = integral(model, power, n)
            middle = to_mpf(ball)
            widest = max(widest, float(ball.rad() / ball.mid()))
            worst_expanded = max(worst_expanded, relative(expanded(model, power, n), middle))
            worst_quadrature = max(worst_quadrature, relative(quadrature(model, power, n), middle))
            rows.append([model, power, n, digits(1 / (2 * arb.pi() * ball))])

print(f"relative: ball radius {widest:.1e}, expanded {mp.nstr(worst_expanded, 2)}, "
      f"quadrature {mp.nstr(worst_quadrature, 2)}")
assert widest < 1e-60 and worst_expanded < mpf(10) ** -55 and worst_quadrature < mpf(10) ** -28
write("factors.csv", ["model", "power", "n", "value"], rows)
