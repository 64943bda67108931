"""rounding.csv: stand-ins for cos^n at high precision, with the arguments that a program would be handed.

Each row draws two unit vectors a, b at an angle theta whose versine is an exact double (in t = n w up to 1.5 of
the longest bell, and near 0). Beside the correctly rounded cos theta, 1 - cos theta and components stand the values of
every stand-in at the exact theta and n as two doubles, value = hi + lo to 30 digits. The bells' coefficients
are those of fits/kernels-cosn.csv; nothing of the crate's code is used.

    pip install mpmath && python3 tests/references/rounding.py
"""
import csv
import os
import random
from mpmath import mp, mpf, sqrt, exp, log

mp.dps = 60
HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.join(HERE, "..", "..")
EXPONENTS = [1.0, 3.5, 16.0, 64.0, 1000.0, 1e6, 1e12]
ROWS = 48


def bells():
    found = {}
    with open(os.path.join(ROOT, "fits", "kernels-cosn.csv")) as file:
        for row in csv.DictReader(file):
            name = f"{row['shape']}-{row['power']}" if row["printed"] == "false" else "cs-16"
            terms = [[mpf(float(row[f"{c}{i}"])) for i in range(3)] for c in ("t", "alpha", "beta")]
            found[name] = (int(row["power"]), terms)
    return found


def bell(formula, n, w):
    power, terms = formula
    reach, alpha, beta = [a + b / n + c / n**2 for a, b, c in terms]
    y = n * w / reach
    return max((1 - y) * (1 + alpha * y + beta * y * y), mpf(0)) ** power


def vectors(draw, w):
    """Unit vectors with |a - b|^2/2 = w."""
    def unit(v):
        length = sqrt(sum(x * x for x in v))
        return [x / length for x in v]
    a = unit([mpf(draw.gauss(0, 1)) for _ in range(3)])
    e = [mpf(draw.gauss(0, 1)) for _ in range(3)]
    along = sum(x * y for x, y in zip(a, e))
    e = unit([y - along * x for x, y in zip(a, e)])
    sine = sqrt(w * (2 - w))
    return a, [(1 - w) * x + sine * y for x, y in zip(a, e)]


def split(value):
    hi = float(value)
    return repr(hi), f"{float(value - mpf(hi)):.6e}"


def main():
    formulas = bells()
    names = sorted(formulas) + ["schlick", "spherical-gaussian", "pow"]
    draw = random.Random(20260101)
    with open(os.path.join(HERE, "rounding.csv"), "w", newline="") as file:
        out = csv.writer(file, lineterminator="\n")
        sides = [f"{v}{i}" for v in "ab" for i in range(3)]
        out.writerow(["n", "cosine", "versine"] + sides + [f"{x}:{part}" for x in names for part in ("hi", "lo")])
        for n in EXPONENTS:
            for k in range(ROWS):
                t = draw.uniform(0, 12) if k % 3 else 10 ** draw.uniform(-6, 1)
                w = mpf(min(t / n, 1.0) if t < n else draw.uniform(0, 1))
                if k == 0:
                    w = mpf(1)  # the hemisphere's edge
                a, b = vectors(draw, w)
                exact_n = mpf(n)
                values = {name: bell(formula, exact_n, w) for name, formula in formulas.items()}
                values["schlick"] = (1 - w) / (1 - w + exact_n * w)
                values["spherical-gaussian"] = exp(-exact_n * w)
                values["pow"] = exp(exact_n * log(1 - w)) if w < 1 else mpf(0)
                row = [repr(n), repr(float(1 - w)), repr(float(w))] + [repr(float(x)) for x in a + b]
                for name in names:
                    row += split(values[name])
                out.writerow(row)


main()
