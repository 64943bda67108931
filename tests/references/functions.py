"""Writes functions.csv: elementary functions and suprema, 30 significant digits, correctly rounded.

Every argument is a double printed by repr(), used exactly. Values are ball arithmetic (python-flint,
500 bits). Suprema: interval bisection discards what cannot hold the extremum; on what is left the
second derivative keeps its sign, so the one zero of the first is bracketed and enclosed. All are
cross-checked against mpmath (70 digits; the suprema also against a scan), asserted.

    versine_ratio(y)          (1 - cos √y)/y
    pow(c, n)                 c^n
    difference_max(n)         max over θ in [0, π/2] of cos^n θ - cs16, cs16 cut at its exact zero
    difference_min(n)         min of the same
    gaussian_error_angle(n)   sup over θ in [0, π/2] of |cos^n θ - exp(-n θ²/2)|
    gaussian_error_cosine(n)  sup over θ in [0, π/2] of |cos^n θ - exp(-n (1 - cos θ))|
    bell_exp_error(K)         sup over t >= 0 of |exp(-t) - max(0, 1 - t/K)^K|

Rerun: python3 tests/references/functions.py
"""
import random

from flint import arb, arb_series, ctx
from mpmath import mp, mpf

from integrand import digits, relative, to_mpf, write

ctx.prec = 500
draw = random.Random(32)


def uniform(low, high, count):
    return [draw.uniform(low, high) for _ in range(count)]


def logarithmic(low, high, count):
    return [float(mpf(10) ** x) for x in uniform(low, high, count)]  # not libm's pow: the same everywhere


EXP = [0.0, -0.0, 1.0, -1.0, 5.0, -16.0, -708.0, -745.0, -750.0, 2.0**-53, -(2.0**-53), -(2.0**-54), -5e-324,
       *uniform(-750, 0, 10), *uniform(-20, 5, 10), *(-x for x in logarithmic(-20, -1, 8))]
LN = [1e-300, 1e-10, 0.5, 1.0, 2.0, 1e3, 1 - 2.0**-53, 1 + 2.0**-52, 1 - 2.0**-30, 1 + 2.0**-30,
      0.7071067811865476, 1.4142135623730951,
      *logarithmic(-300, 3, 10), *uniform(0.5, 2, 10), *(1 - x for x in logarithmic(-12, -2, 8))]
VERSINE = [1e-12, 1e-8, 1e-4, 0.25, 0.5, 1.0, 2.0, 2.5, 2.4674011002723395, *logarithmic(-12, 0, 12), *uniform(0, 2.5, 10)]
POW = [(0.5, 16.0), (0.5, 1024.0), (0.9, 16.0), (0.999, 1024.0), (1 - 2.0**-53, 1024.0), (1e-3, 64.0),
       (2.0**-60, 16.0), (0.99, 100.25), *zip(uniform(0, 1, 16), map(float, draw.sample(range(16, 1025), 16))),
       *zip((1 - x for x in logarithmic(-6, -1, 16)), uniform(16, 1024, 16))]


def power(x, n):
    """x^n by squaring: no logarithm, so fine on intervals through 0."""
    result = None
    for bit in bin(int(n))[2:]:
        result = x if result is None else result * result * (x if bit == "1" else 1)
    return result


def jet(f, x, order=3):
    """f, f', f''/2 on the ball x."""
    old, ctx.cap = ctx.cap, order
    series = f(arb_series([x, 1], prec=order))
    ctx.cap = old
    return [series[k] for k in range(order)]


def ball(low, high):
    return low.union(high)


def maximum(f, a, b, depth=60):
    """Enclosure of the maximum of f on [a, b] and its argument; the maximum must be inside and simple."""
    pieces, best = [(arb(a), arb(b))], f(arb(a)).lower()
    for _ in range(depth):
        halves = [half for low, high in pieces
                  for middle in [((low + high) / 2).mid()] for half in ((low, middle), (middle, high))]
        for low, high in halves:
            value = f(((low + high) / 2).mid()).lower()
            best = value if value > best else best
        pieces = []
        for low, high in halves:
            value, slope, _ = jet(f, ball(low, high))
            # Mean-value form and the plain enclosure: discard only what lies below a value reached.
            middle = ((low + high) / 2).mid()
            centred = f(middle) + slope * (ball(low, high) - middle)
            if not (value < best or centred < best):
                pieces.append((low, high))
        low, high = pieces[0][0], pieces[-1][1]
        if jet(f, ball(low, high))[2] < 0:
            break
    else:
        raise AssertionError("not isolated")
    assert low > a and high < b
    assert jet(f, low)[1] > 0 and jet(f, high)[1] < 0
    for _ in range(400):  # f' falls through zero between low and high
        middle = ((low + high) / 2).mid()
        slope = jet(f, middle)[1]
        if slope > 0:
            low = middle
        elif slope < 0:
            high = middle
        else:
            break
    # At a flat top f(x) <= maximum <= f(x) + |f'| width.
    hull, middle = ball(low, high), ((low + high) / 2).mid()
    return f(middle) + jet(f, hull)[1] * (hull - middle), hull


def difference(n):
    """cos^n - cs16 in c = cos θ, where cs16 is not cut."""
    return lambda c: power(c, n) - power(1 - (1 - c) * arb(n) / 16, 16)


rows, worst, worst_scan = [], 0, 0


def put(function, first, second, value, check):
    global worst
    worst = max(worst, relative(check, to_mpf(value)))
    rows.append([function, repr(first), "" if second is None else repr(second), digits(value)])


def scan(function, n, value, f, a, b, sup=abs):
    """mpmath: the largest sup(f) on a grid lies below the value, and close; polished, it agrees."""
    global worst_scan
    steps = 20000
    with mp.workdps(25):
        grid = [a + (b - a) * mpf(i) / steps for i in range(steps + 1)]
        heights = [sup(f(x)) for x in grid]
        at = max(range(steps + 1), key=heights.__getitem__)
        reached = heights[at]
    reference = to_mpf(value)
    assert reached <= reference * (1 + mpf(10) ** -20), (function, n)
    worst_scan = max(worst_scan, relative(reached, reference))
    return sup(f(mp.findroot(lambda x: mp.diff(f, x), (grid[at - 1], grid[at + 1]), solver="anderson", tol=1e-60)))


for x in EXP:
    put("exp", x, None, arb(x).exp(), mp.exp(mpf(x)))
for x in LN:
    put("ln", x, None, arb(x).log(), mp.log(mpf(x)))
for y in VERSINE:
    put("versine_ratio", y, None, (1 - arb(y).sqrt().cos()) / arb(y), 2 * mp.sin(mp.sqrt(mpf(y)) / 2) ** 2 / mpf(y))
for c, n in POW:
    put("pow", c, n, (arb(n) * arb(c).log()).exp() if c != 0.5 else power(arb(c), n), mpf(c) ** mpf(n))


def cut_difference_mp(n):
    return lambda c: c ** n - max(mpf(0), 1 - n * (1 - c) / 16) ** 16


for n in (17.0, 64.0, 256.0, 1024.0):
    # Beyond the cut cs16 is 0 and cos^n falls: the end of the support stands for it.
    value, _ = maximum(difference(n), (1 - 16 / arb(n)).lower(), arb(1))
    assert value > 0
    put("difference_max", n, None, value,
        scan("difference_max", n, value, cut_difference_mp(mpf(n)), mpf(0), mpf(1), sup=lambda x: x))
for n in (10.0, 11.0):  # the zero lies beyond π/2
    f = difference(n)
    value, _ = maximum(lambda c: -f(c), arb(0), arb(1))
    put("difference_min", n, None, -value,
        -scan("difference_min", n, value, lambda c: -cut_difference_mp(mpf(n))(c), mpf(0), mpf(1), sup=lambda x: x))
for n in (16.0, 64.0, 256.0, 1024.0):
    # cos θ <= exp(-θ²/2) and c <= exp(c - 1): the Gaussian is never below.
    value, _ = maximum(lambda x: (x * x * arb(-n / 2)).exp() - power(x.cos(), n), arb(0), (arb.pi() / 2).upper())
    put("gaussian_error_angle", n, None, value,
        scan("gaussian_error_angle", n, value, lambda x: mp.exp(-n * x * x / 2) - mp.cos(x) ** n, mpf(0), mp.pi / 2))
for n in (16.0, 64.0, 256.0, 1024.0):
    value, _ = maximum(lambda c: ((c - 1) * arb(n)).exp() - power(c, n), arb(0), arb(1))
    put("gaussian_error_cosine", n, None, value,
        scan("gaussian_error_cosine", n, value, lambda c: mp.exp(-n * (1 - c)) - c ** n, mpf(0), mpf(1)))
for k in (4.0, 8.0, 16.0, 32.0):
    # 1 - t/K <= exp(-t/K): the bell is never above; beyond K the difference is exp(-t), which falls.
    value, _ = maximum(lambda t: (-t).exp() - power(1 - t / arb(k), k), arb(0), arb(k))
    put("bell_exp_error", k, None, value,
        scan("bell_exp_error", k, value, lambda t: mp.exp(-t) - max(mpf(0), 1 - t / k) ** k, mpf(0), 2 * mpf(k)))

print(f"relative: mpmath {mp.nstr(worst, 2)}; largest gap to a scan {mp.nstr(worst_scan, 2)}")
assert worst < mpf(10) ** -45 and worst_scan < mpf(10) ** -3
write("functions.csv", ["function", "argument1", "argument2", "value"], rows)
