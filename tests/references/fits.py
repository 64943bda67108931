"""Writes fits.csv: fits of the normalising factor of cs16 over the integers n = 16..1024, 20 significant digits.

coef(n) = (a n + b)/(divisor π), divisor 2 for the Phong models and 8 for the Blinn-Phong ones; wanted
is 2π coef(n) Int(n) = 1. Closed-form Int (integrand.py, asserted against integrals.csv), mpmath.

    ls-absolute   minimises Σ (a n + b - divisor/(2 Int))²
    ls-relative   minimises Σ (2 (a n + b) Int/divisor - 1)²
    minimax       minimises max |2 (a n + b) Int/divisor - 1|, by exchange; equioscillation asserted

form: `linear` (a, b) or `proportional` (b empty). Rerun: python3 tests/references/fits.py (after integrals.py)
"""
import csv

from mpmath import mp, mpf

from integrand import HERE, LIMITS, closed_form, exact, relative, round_fraction, write

MODELS = ["phong-modified", "blinn-phong", "blinn-phong-modified", "phong"]
NS = range(16, 1025)
TINY = mpf(10) ** -50  # of numbers that are 0 but for rounding; 70 digits are carried


def least_squares(weights, linear):
    """Minimises Σ weight² (a n + b - y)², given as (n, weight, weight y); normal equations, centred."""
    if not linear:
        return sum(n * w * r for n, w, r in weights) / sum((n * w) ** 2 for n, w, r in weights), None
    total = sum(w * w for _, w, _ in weights)
    n_mean = sum(n * w * w for n, w, _ in weights) / total
    y_mean = sum(w * r for _, w, r in weights) / total
    a = (sum((n - n_mean) * w * r for n, w, r in weights)
         / sum(((n - n_mean) * w) ** 2 for n, w, _ in weights))
    return a, y_mean - a * n_mean


def minimax(x):
    """a, b that minimise max |(a n + b) x_n - 1|: single-point exchange of three alternation points."""
    reference = [NS[0], NS[len(NS) // 2], NS[-1]]
    for _ in range(100):
        a, b, level = mp.lu_solve(
            mp.matrix([[n * x[n], x[n], (-1) ** i] for i, n in enumerate(reference)]), mp.matrix([1, 1, 1]))
        residual = {n: (a * n + b) * x[n] - 1 for n in NS}
        worst = max(NS, key=lambda n: abs(residual[n]))
        if abs(residual[worst]) <= abs(level) + TINY:
            break
        # The new point joins the reference; the one it displaces leaves the signs alternating.
        points = sorted(set(reference) | {worst})
        sign = [residual[n] > 0 for n in points]
        keep = [[m for m in points if m != out] for out in points if out != worst]
        reference = next(k for k in keep
                         if all((residual[p] > 0) != (residual[q] > 0) for p, q in zip(k, k[1:])))
    else:
        raise AssertionError("no convergence")
    values = [residual[n] for n in reference]
    assert max(abs(abs(v) - abs(residual[worst])) for v in values) <= 2 * TINY
    if abs(level) > TINY:  # otherwise the fit is exact
        assert values[0] * values[1] < 0 and values[1] * values[2] < 0
    return a, b, abs(level), reference


def text(value):
    """20 significant digits; what is 0 but for rounding is 0."""
    if value is None:
        return ""
    return "0" if abs(value) < TINY else f"{round_fraction(exact(value), 20):.19e}"


worst, compared = 0, 0
with open(HERE / "integrals.csv", encoding="utf-8") as file:
    for row in csv.DictReader(file):
        n = mpf(row["n"])
        value = closed_form(row["model"], row["lobe"], row["limit"], n)
        worst = max(worst, relative(value, mpf(row["value"])))
        compared += 1
print(f"closed form against {compared} rows of integrals.csv: {mp.nstr(worst, 2)}")
assert compared == 450 and worst < 6 * mpf(10) ** -30  # half a unit of 30 digits

rows = []
for model in MODELS:
    divisor = 8 if model.startswith("blinn") else 2
    for limit in LIMITS:
        x = {n: 2 * closed_form(model, "cs16", limit, n) / divisor for n in NS}
        for objective, weights in (("ls-absolute", [(n, mpf(1), 1 / x[n]) for n in NS]),
                                   ("ls-relative", [(n, x[n], mpf(1)) for n in NS])):
            for form in ("linear", "proportional"):
                a, b = least_squares(weights, form == "linear")
                # The residuals of a least-squares fit are orthogonal to what it is fitted by.
                left = [w * (a * n + (b or 0)) - r for n, w, r in weights]
                assert abs(sum(e * n * w for e, (n, w, _) in zip(left, weights))) < TINY
                assert form == "proportional" or abs(sum(e * w for e, (_, w, _) in zip(left, weights))) < TINY
                rows.append([model, limit, objective, form, text(a), text(b)])
        a, b, level, reference = minimax(x)
        print(f"{model} {limit}: minimax residual {mp.nstr(level, 5) if level > TINY else 0} at {reference}")
        rows.append([model, limit, "minimax", "linear", text(a), text(b)])

write("fits.csv", ["model", "limit", "objective", "form", "a", "b"], rows)
