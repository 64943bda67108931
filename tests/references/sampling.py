"""Writes sampling.csv: inverses of the own angle's distribution function, and densities on the axis; 20 digits.

The own angle's versine w has the density f (1 - w)^cosines on 0 <= w <= 1; f is the bell (1 - n w/K)^K,
K = power, cut at its zero, or (1 - w)^n where power is empty. A row with u holds w with P(versine <= w) = u; one
with an empty u holds 1/integral, the density per solid angle on the axis times 2π. n and u are exact doubles.

Bells: n and u are rationals and the integral a polynomial in w, expanded binomially. Its root comes from a
bracketed search in mpmath; each printed value is proved by the polynomial's sign, in exact fractions, half a
unit of the last digit to either side. cos^n: closed form. Both are checked against mpmath's quadrature at
some rows. Rerun: python3 tests/references/sampling.py
"""
import struct
from fractions import Fraction
from math import comb

from mpmath import mp, mpf

from integrand import exact, relative, round_fraction, write

DIGITS = 20


def single(x):
    """x rounded to single precision, so that both types take it exactly."""
    return struct.unpack("f", struct.pack("f", x))[0]


US = [2.0**-40, 2.0**-20, single(0.01), 0.25, 0.5, 0.75, single(0.99), 1 - 2.0**-24, 1 - 2.0**-53]


def exponents(k):
    return sorted({0.0, 2.0**-30, 0.125, 1.0, k / 2, k - 0.25, float(k), k + 0.25, 3.0 * k, 1e4, 1e6})


def text(value):
    return f"{round_fraction(value, DIGITS):.{DIGITS - 1}e}"


def as_mpf(fraction):
    return mpf(fraction.numerator) / fraction.denominator


def primitive(k, m, x):
    """Coefficients of w^1, w^2, … of the integral of (1 - x w)^K (1 - w)^m from 0 to w, exact."""
    c = [Fraction(0)] * (k + 3)
    for j in range(k + 1):
        term = comb(k, j) * (-x) ** j
        c[j + 1] += term / (j + 1)
        if m:
            c[j + 2] -= term / (j + 2)
    return c[1:]


def at(coefficients, w):
    """The polynomial with no constant term, by Horner's rule in whatever w is."""
    total = 0 * w
    for c in reversed(coefficients):
        total = (total + (c if isinstance(w, Fraction) else as_mpf(c))) * w
    return total


def root(coefficients, goal, end):
    """The w in (0, end) where the increasing polynomial meets goal, proved to DIGITS digits."""
    lo, hi = Fraction(0), end
    for _ in range(60):  # a bracket for the search
        mid = Fraction((lo + hi) / 2).limit_denominator(2**70)
        lo, hi = (mid, hi) if at(coefficients, mid) < goal else (lo, mid)
        if lo > 0 and (hi - lo) < lo / 2**30:
            break
    with mp.workdps(200):
        goal_mp = as_mpf(goal)
        w = mp.findroot(lambda w: at(coefficients, w) - goal_mp, [as_mpf(lo), as_mpf(hi)],
                        solver="anderson", tol=mpf(10) ** -250, maxsteps=200, verify=False)
    printed = Fraction(text(exact(w)))
    ulp = Fraction(10) ** (int(text(exact(w)).split("e")[1]) - DIGITS + 1)
    assert at(coefficients, printed - ulp / 2) < goal <= at(coefficients, printed + ulp / 2), (w, goal)
    return printed


def check(f, w, end, u):
    """The share of f's integral that lies within w, by quadrature, against u."""
    with mp.workdps(40):
        share = mp.quad(f, [0, as_mpf(w)]) / mp.quad(f, [0, as_mpf(end)])
        assert relative(share, mpf(u)) < mpf(10) ** -(DIGITS - 2), (w, u, share)


def main():
    rows, checked = [], 0
    for m in (0, 1):
        for n in exponents(16):
            power = Fraction(n) + m
            rows.append(["", m, n, "", text(power + 1)])
            for u in US:
                w = exact(-mp.expm1(mp.log1p(-mpf(u)) / as_mpf(power + 1)))
                rows.append(["", m, n, u, text(w)])
                if u == 0.75 and 0.125 <= n <= 16:
                    check(lambda t: (1 - t) ** as_mpf(power), w, Fraction(1), u)
                    checked += 1
    for k in (2, 4, 8, 16, 32, 64):
        for m in (0, 1):
            for n in exponents(k):
                x = Fraction(n) / k
                end = min(Fraction(1), 1 / x) if x else Fraction(1)
                coefficients = primitive(k, m, x)
                mass = at(coefficients, end)
                rows.append([k, m, n, "", text(1 / mass)])
                for u in US:
                    w = root(coefficients, mass * Fraction(u), end)
                    rows.append([k, m, n, u, text(w)])
                    if u == 0.75 and k in (4, 16):
                        check(lambda t: (1 - n * t / mpf(k)) ** k * (1 - t) ** m, w, end, u)
                        checked += 1
    assert checked >= 50
    write("sampling.csv", ["power", "cosines", "n", "u", "value"], rows)


main()
