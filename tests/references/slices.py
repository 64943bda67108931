"""Writes slices.csv: powers and exponentials beyond double precision, mpmath at 60 digits.

Columns: width (32 or 64: the type that x and n are numbers of), function (cosine: x^n; versine: (1 - x)^n; exp:
e^x), x, n, and the value as the nearest double and what it leaves, also a double. Where the value is below
the least double, both are 0.

With the word polynomials it prints instead the coefficients of src/slice/lanes.rs and src/slice/power.rs: the
polynomials of least largest relative error, by the exchange algorithm of Remez, before they are rounded.

Rerun: python3 tests/references/slices.py [polynomials]
"""
import csv
import random
import struct
import sys
from pathlib import Path

from mpmath import atanh, cos, exp, expm1, log, lu_solve, matrix, mp, mpf, nstr, pi, polyval, sign, sqrt

mp.dps = 60


def single(x):
    return struct.unpack("f", struct.pack("f", float(x)))[0]


def arguments(draw, width):
    """(function, x, n): spread, near 1, near the ends of the range, and where the significand wraps."""
    number = single if width == 32 else float
    least = 126 if width == 32 else 1022
    deepest = least + (24 if width == 32 else 53)
    steep = 20 if width == 32 else 45
    for _ in range(400):
        yield "cosine", number(draw.random()), number(2 ** draw.uniform(-4, 12))
    for _ in range(300):  # n log2 c anywhere in the range
        c = number(1 - 2 ** draw.uniform(-steep, -1))
        yield "cosine", c, number(-draw.uniform(0, deepest) / log(mpf(c), 2))
    for _ in range(150):  # subnormal results
        c = number(draw.uniform(0.01, 0.999))
        yield "cosine", c, number(-draw.uniform(least, deepest) / log(mpf(c), 2))
    for _ in range(150):
        c = number(2 ** (-draw.randrange(0, 9) - mpf(1) / 2) * (1 + draw.uniform(-1, 1) * 1e-6))
        yield "cosine", c, number(draw.uniform(0.1, 100))
    for _ in range(50):  # subnormal cosines
        yield "cosine", number(draw.random() * 2.0 ** -least), number(draw.uniform(0.001, 1))
    for _ in range(150):
        w = number(2 ** draw.uniform(-100, -1))
        yield "versine", w, number(draw.uniform(0, 20) / w)
    for _ in range(50):
        yield "versine", number(draw.random()), number(2 ** draw.uniform(-2, 8))
    for _ in range(300):
        yield "exp", number(draw.uniform(-mpf(deepest) * log(2), 20)), 0.0
    for _ in range(100):
        yield "exp", number(draw.uniform(-1, 1)), 0.0


def value(function, x, n):
    x, n = mpf(x), mpf(n)
    return {"cosine": lambda: x**n, "versine": lambda: (1 - x) ** n, "exp": lambda: exp(x)}[function]()


def table():
    draw = random.Random(16)
    with open(Path(__file__).parent / "slices.csv", "w", newline="") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(["width", "function", "x", "n", "value", "rest"])
        for width in (32, 64):
            for function, x, n in arguments(draw, width):
                y = value(function, x, n)
                rounded = float(y)
                out.writerow([width, function, repr(x), repr(n), repr(rounded), repr(float(y - mpf(rounded)))])


def remez(f, a, b, degree):
    n = degree + 1
    places = [(a + b) / 2 + (b - a) / 2 * cos(pi * k / n) for k in range(n + 1)]
    for _ in range(8):
        system, right = matrix(n + 1, n + 1), matrix(n + 1, 1)
        for i, x in enumerate(places):
            for j in range(n):
                system[i, j] = x**j
            system[i, n] = (-1) ** i * f(x)
            right[i] = f(x)
        solution = lu_solve(system, right)
        c = [solution[j] for j in range(n)]
        grid = [(a + b) / 2 + (b - a) / 2 * cos(pi * k / mpf(24 * n)) for k in range(24 * n + 1)]
        errors = [polyval(c[::-1], x) / f(x) - 1 for x in grid]
        extremes, current = [], 0
        for k in range(1, len(grid)):
            if sign(errors[k]) != sign(errors[current]):
                extremes.append(current)
                current = k
            elif abs(errors[k]) > abs(errors[current]):
                current = k
        extremes.append(current)
        assert len(extremes) == n + 1
        places = [grid[k] for k in extremes]
        sizes = [abs(errors[k]) for k in extremes]
        if max(sizes) < 1.05 * min(sizes):
            return c, max(sizes)
    raise ArithmeticError("the exchange does not settle")


def polynomials():
    tiny = mpf(10) ** -20

    def logarithm(f):
        return (1 - f / 2) / log(2) if abs(f) < tiny else log(1 + f) / f / log(2)

    def exponential_2(f):
        return log(2) + f * log(2) ** 2 / 2 if abs(f) < tiny else (mpf(2) ** f - 1) / f

    def exponential(r):
        return 1 + r / 2 if abs(r) < tiny else expm1(r) / r

    def artanh(q):
        if q < mpf(10) ** -8:
            return sum(q**k / (2 * k + 5) for k in range(6))
        return ((atanh(sqrt(q)) / sqrt(q) - 1) / q - mpf(1) / 3) / q

    root = sqrt(mpf(2))
    half_ln_2 = log(mpf(2)) / 2 * mpf("1.0001")
    for name, f, a, b, degree in [
        ("f32 LOG2", logarithm, 1 / root - 1, root - 1, 9),
        ("f32 EXP2", exponential_2, -mpf(1) / 2, mpf(1) / 2, 5),
        ("f32 EXP", exponential, -half_ln_2, half_ln_2, 5),
        ("power.rs LOG2", logarithm, 1 / root - 1, root - 1, 12),
        ("power.rs EXP2", exponential_2, -mpf(1) / 2, mpf(1) / 2, 6),
        ("power.rs ATANH", artanh, mpf(0), ((root - 1) / (root + 1)) ** 2, 7),
        ("f64 LOG2", logarithm, 1 / root - 1, root - 1, 20),
        ("f64 EXP2", exponential_2, -mpf(1) / 2, mpf(1) / 2, 10),
        ("f64 EXP", exponential, -half_ln_2, half_ln_2, 10),
    ]:
        coefficients, error = remez(f, a, b, degree)
        print(f"{name}, largest relative error {nstr(error, 3)}")
        for c in coefficients:
            print("   ", repr(single(c)) if name.startswith("f32") else repr(float(c)))


if __name__ == "__main__":
    polynomials() if "polynomials" in sys.argv[1:] else table()
