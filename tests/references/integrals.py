"""Writes integrals.csv: Int(n) without the factor 2π, 30 significant digits, correctly rounded.

Rigorous quadrature of the integrand in θ as the paper writes it, in ball arithmetic (python-flint,
acb.integral, 300 bits): each row is an enclosure narrow enough to round one way. Cross-checks, both
asserted: a closed form (integrand.py, 70 digits) and mpmath's own quadrature (35 digits).

cs16 is the polynomial (1 - n (1 - c)/16)^16, unclamped: up to the limit `paper` it may run past its
zero, where the even power is positive. Rerun: python3 tests/references/integrals.py
"""
import random

from flint import acb, arb, ctx
from mpmath import mp, mpf

from integrand import HALF_ANGLE, LIMITS, MODELS, WITH_COSINE, closed_form, digits, limit_mp, relative, to_mpf, write

ctx.prec = 300
FIXED = [16, 17, 54, 55, 1024, 16.5, 54.625, 100.25, 777.75]  # all exact in binary
DRAWN = random.Random(16).sample([n for n in range(18, 1024) if n not in FIXED], 6)
EXPONENTS = sorted(FIXED + DRAWN)


def smaller(x, y):
    """The smaller of two balls, which must be decidable."""
    assert x < y or y < x
    return x if x < y else y


def limit_arb(model, lobe, limit, n):
    right = arb.pi() / 2
    if limit == "support" and lobe == "cos-n":
        return right
    if limit == "paper":
        return smaller(right, 6 / arb(n).sqrt())
    if limit == "card":
        return smaller(right, (6 / arb(n)).sqrt())
    if n <= 16:
        return right
    zero = (1 - 16 / arb(n)).acos()
    return smaller(right, 2 * zero) if limit == "support" and model in HALF_ANGLE else zero


def power(c, n, analytic):
    """c^n for an acb; around the branch point 0 of a fractional power, the disc |z| <= |c|^n."""
    if n == int(n):
        return c ** int(n)
    if not analytic and c.contains(0):
        radius = (arb(n) * c.abs_upper().log()).exp().upper()
        return acb(arb(0, radius), arb(0, radius))
    return c.pow(n, analytic=analytic)


def integral(model, lobe, limit, n):
    def integrand(theta, analytic):
        c = (theta / 2 if model in HALF_ANGLE else theta).cos()
        f = power(c, n, analytic) if lobe == "cos-n" else (1 - n * (1 - c) / 16) ** 16
        return f * theta.sin() * (theta.cos() if model in WITH_COSINE else 1)

    value = acb.integral(integrand, 0, limit_arb(model, lobe, limit, n))
    assert value.imag.contains(0)
    return value.real


def quadrature(model, lobe, limit, n):
    """The same by mpmath, in pieces of a lobe's width."""
    def integrand(theta):
        c = mp.cos(theta / 2 if model in HALF_ANGLE else theta)
        f = c ** n if lobe == "cos-n" else (1 - n * (1 - c) / 16) ** 16
        return f * mp.sin(theta) * (mp.cos(theta) if model in WITH_COSINE else 1)

    with mp.workdps(35):
        n = mpf(n)
        end = limit_mp(model, lobe, limit, n)
        pieces = int(mp.ceil(end * mp.sqrt(n) / 3))
        return mp.quad(integrand, mp.linspace(0, end, pieces + 1))


rows, widest, worst_closed, worst_quadrature = [], 0, 0, 0
for model in MODELS:
    for lobe, limits in (("cos-n", ["support"]), ("cs16", LIMITS)):
        for limit in limits:
            for n in EXPONENTS:
                ball = integral(model, lobe, limit, n)
                middle = to_mpf(ball)
                widest = max(widest, float(ball.rad() / ball.mid()))
                worst_closed = max(worst_closed, relative(closed_form(model, lobe, limit, n), middle))
                worst_quadrature = max(worst_quadrature, relative(quadrature(model, lobe, limit, n), middle))
                rows.append([model, lobe, limit, n, digits(ball)])

print(f"relative: ball radius {widest:.1e}, closed form {mp.nstr(worst_closed, 2)}, "
      f"quadrature {mp.nstr(worst_quadrature, 2)}")
assert widest < 1e-60 and worst_closed < mpf(10) ** -60 and worst_quadrature < mpf(10) ** -30
assert len(rows) == 450
write("integrals.csv", ["model", "lobe", "limit", "n", "value"], rows)
