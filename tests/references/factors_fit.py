"""Writes factors_fit.csv and factors_rounded.csv: factors of cs16 on its support over every real n of a range.

residual(n) = 2π coef(n) Int(n) - 1, coef(n) = form/(divisor π), divisor 2 for the Phong models and 8 for the
Blinn-Phong ones. Closed-form Int (integrand.py); at every alternation point it is asserted against mpmath's
quadrature of the integrand in θ.

factors_fit.csv: for each form the least possible max |residual| and the parameters that reach it, 20 digits.
Exchange over reals; equioscillation at one point more than there are parameters is asserted. A level of 0 is
one that is 0 but for rounding at 70 digits.

factors_rounded.csv: the line a n + b of least loss max -residual among those with residual <= 0 for every real
n of 16..1024 and `digits` significant digits in a and in b. Exhaustive: every a whose loss at three fixed n
alone does not exceed the best loss found is tried, with the largest b that holds.

Rerun: python3 tests/references/factors_fit.py (half a minute)
"""
from fractions import Fraction

from mpmath import mp, mpf

from integrand import HALF_ANGLE, WITH_COSINE, closed_form, exact, limit_mp, relative, round_fraction, write

MODELS = ["phong", "phong-modified", "blinn-phong", "blinn-phong-modified"]
FORMS = {"proportional": 1, "linear": 2, "inverse": 3, "inverse-square": 4, "ratio": 4}
INF = mp.inf
TINY = mpf(10) ** -45  # of numbers that are 0 but for rounding; 70 digits are carried
GOLDEN = (mp.sqrt(5) - 1) / 2


def divisor(model):
    return 8 if model in HALF_ANGLE else 2


def quadrature(model, n):
    """Int(n) by mpmath in θ."""
    def integrand(theta):
        lobe = mp.cos(theta / 2 if model in HALF_ANGLE else theta)
        weight = mp.cos(theta) if model in WITH_COSINE else 1
        return (n * (lobe - 1) / 16 + 1) ** 16 * weight * mp.sin(theta)
    end = limit_mp(model, "cs16", "support", n)
    with mp.workdps(30):
        return mp.quad(integrand, [0, end / 4, end / 2, end])


class Integral:
    """g(m) = (2/divisor) n Int(n) at m = 1/n, sampled over a range of n and anywhere else."""

    def __init__(self, model, lo, hi, count=320):
        self.model, self.lo = model, mpf(lo)
        last = mpf(hi) if hi != INF else self.lo * 2**20
        step = mp.log(last / self.lo) / count
        ns = [self.lo * mp.exp(i * step) for i in range(count)] + [last]
        self.m = ([mpf(0)] if hi == INF else []) + [1 / n for n in reversed(ns)]
        self.g = [self.at(m) for m in self.m]

    def at(self, m):
        if m == 0:
            return mpf(16) / 17  # (2/divisor) 16 ∫ b^16 db times the integrand's weight 1 or 4 at the pole
        return 2 * closed_form(self.model, "cs16", "support", 1 / m) / (m * divisor(self.model))

    def extreme(self, f, i):
        """The largest f(m, g) between the neighbours of sample i."""
        a, b = self.m[max(i - 1, 0)], self.m[min(i + 1, len(self.m) - 1)]
        value = lambda m: f(m, self.at(m))
        best = (self.m[i], f(self.m[i], self.g[i]))
        x, y = b - GOLDEN * (b - a), a + GOLDEN * (b - a)
        fx, fy = value(x), value(y)
        while b - a > mpf(10) ** -17 * self.m[-1]:  # a value is flat there: 30 digits of it
            if fx > fy:
                b, y, fy = y, x, fx
                x = b - GOLDEN * (b - a)
                fx = value(x)
            else:
                a, x, fx = x, y, fy
                y = a + GOLDEN * (b - a)
                fy = value(y)
        return max([best, (x, fx), (y, fy)], key=lambda p: p[1])

    def maximum(self, f):
        values = [f(m, g) for m, g in zip(self.m, self.g)]
        return self.extreme(f, max(range(len(values)), key=values.__getitem__))

    def runs(self, f, refine):
        """The extreme of each run of equal sign."""
        values = [f(m, g) for m, g in zip(self.m, self.g)]
        tops = []
        for i, value in enumerate(values):
            if tops and (values[tops[-1]] < 0) == (value < 0):
                if abs(value) > abs(values[tops[-1]]):
                    tops[-1] = i
            else:
                tops.append(i)
        if not refine:
            return [(self.m[i], values[i]) for i in tops]
        found = []
        for i in tops:
            sign = -1 if values[i] < 0 else 1
            m, value = self.extreme(lambda m, g: sign * f(m, g), i)
            found.append((m, sign * value))
        return found


def per_n(form, p, m):
    if form == "ratio":
        return p[0] + p[1] * m + p[2] * m * m / (1 + p[3] * m)
    return sum(c * m**k for k, c in enumerate(p))


def window(extremes, count):
    """So many of the extremes, alternating, the largest among them: the smallest go, inner ones in pairs."""
    kept = list(extremes)
    while len(kept) > count:
        i = min(range(len(kept)), key=lambda i: abs(kept[i][1]))
        if len(kept) == count + 1 or i in (0, len(kept) - 1):
            del kept[0 if abs(kept[0][1]) < abs(kept[-1][1]) else -1]
        else:
            j = min(i - 1, i + 1, key=lambda j: abs(kept[j][1]))
            del kept[min(i, j):max(i, j) + 1]
    assert len(kept) == count, "the extremes do not alternate"
    return [m for m, _ in kept]


def start(integral, count):
    lo, hi = integral.m[0], integral.m[-1]
    return [lo + (hi - lo) * (1 - mp.cos(mp.pi * i / (count - 1))) / 2 for i in range(count)]


def linear_exchange(integral, form, pole=None, refine=True):
    """p (without p3 for a ratio with given pole), level, reference."""
    free = 3 if pole is not None else FORMS[form]
    basis = lambda m: [m**k / (1 + (pole * m if pole is not None and k == 2 else 0)) for k in range(free)]
    reference = start(integral, free + 1)
    for _ in range(60):
        rows = [[integral.at(m) * b for b in basis(m)] + [(-1) ** i] for i, m in enumerate(reference)]
        *p, level = mp.lu_solve(mp.matrix(rows), mp.matrix([1] * (free + 1)))
        residual = lambda m, g: sum(c * b for c, b in zip(p, basis(m))) * g - 1
        extremes = integral.runs(residual, refine)
        worst = max(abs(v) for _, v in extremes)
        if worst < TINY or worst <= abs(level) * (1 + mpf(10) ** (-22 if refine else -3)):
            return p, worst, reference
        reference = window(extremes, free + 1)
    raise AssertionError("no convergence")


def ratio_exchange(integral):
    """The rational problem: five points, Newton on g P = (1 ± h) Q inside an exchange."""
    lo = integral.lo
    trial = lambda u: linear_exchange(integral, "ratio", lo * (mpf(2) ** u - 1), refine=False)
    u = min((mpf(k) / 4 for k in range(-20, 21)), key=lambda u: trial(u)[1])
    pole = lo * (mpf(2) ** u - 1)
    p, level, _ = linear_exchange(integral, "ratio", pole, refine=False)
    p = list(p) + [pole]
    extremes = integral.runs(lambda m, g: per_n("ratio", p, m) * g - 1, False)
    reference = window(extremes, 5) if len(extremes) >= 5 else start(integral, 5)
    for _ in range(60):
        sign = 1 if per_n("ratio", p, reference[0]) * integral.at(reference[0]) > 1 else -1
        g = [integral.at(m) for m in reference]
        # Unknowns: P = a0 + a1 m + a2 m², Q = 1 + q m, h.
        x = [p[0], p[1] + p[0] * p[3], p[2] + p[1] * p[3], p[3], sign * level]
        for _ in range(100):
            a0, a1, a2, q, h = x
            rows, target = [], []
            for i, (m, gi) in enumerate(zip(reference, g)):
                wanted = 1 + (-1) ** i * h
                rows.append([gi, gi * m, gi * m * m, -m * wanted, -((-1) ** i) * (1 + q * m)])
                target.append(wanted * (1 + q * m) - gi * (a0 + a1 * m + a2 * m * m))
            step = mp.lu_solve(mp.matrix(rows), mp.matrix(target))
            x = [a + b for a, b in zip(x, step)]
            if max(abs(s) for s in step) < mpf(10) ** -40:
                break
        else:
            raise AssertionError("Newton's method does not converge")
        a0, a1, a2, q, h = x
        p = [a0, a1 - a0 * q, a2 - (a1 - a0 * q) * q, q]
        assert 1 + q * integral.m[-1] > 0
        extremes = integral.runs(lambda m, g: per_n("ratio", p, m) * g - 1, True)
        level = max(abs(v) for _, v in extremes)
        if level < mpf(10) ** -30 or level <= abs(h) * (1 + mpf(10) ** -22):
            return p, (mpf(0) if level < mpf(10) ** -30 else level), reference
        reference = window(extremes, 5)
    raise AssertionError("no convergence")


def text(value, count=20):
    """Significant digits; an mpf's mantissa has no sign."""
    sign = "-" if value < 0 else ""
    return "0" if abs(value) < TINY else f"{sign}{round_fraction(exact(abs(value)), count):.{count - 1}e}"


def minimax_rows():
    rows, worst = [], 0
    for model in MODELS:
        for lo, hi in ((16, 1024), (16, INF), (1, 16)):
            integral = Integral(model, lo, hi)
            for form, count in FORMS.items():
                if model == "phong" and lo == 16 and form != "proportional":
                    continue  # exact already
                p, level, reference = (ratio_exchange(integral) if form == "ratio"
                                       else linear_exchange(integral, form))
                if level > TINY:
                    values = [per_n(form, p, m) * integral.at(m) - 1 for m in reference]
                    assert len(values) == count + 1
                    assert all(abs(abs(v) / level - 1) < mpf(10) ** -20 for v in values), values
                    assert all(v * w < 0 for v, w in zip(values, values[1:]))
                    for m in reference:
                        if m > 0:
                            by_theta = quadrature(model, 1 / m)
                            worst = max(worst, relative(closed_form(model, "cs16", "support", 1 / m), by_theta))
                p = [text(c) for c in p] + [""] * (4 - len(p))
                print(model, lo, hi, form, mp.nstr(level, 5), flush=True)
                rows.append([model, form, lo, "inf" if hi == INF else hi, text(level), *p])
    print(f"closed form against quadrature: {mp.nstr(worst, 2)}")
    assert worst < mpf(10) ** -24
    return rows


def floor_to(value, digits):
    """The largest decimal of so many significant digits that is at most a positive value, as a Fraction."""
    assert value > 0
    value = exact(value)
    step = Fraction(10) ** (digits - 1)
    size = abs(value)
    while size >= 10:
        size, step = size / 10, step / 10
    while size and size < 1:
        size, step = size * 10, step * 10
    return Fraction((value * step).__floor__()) / step


def rounded_rows():
    rows = []
    for model in MODELS[1:]:
        integral = Integral(model, 16, 1024)
        (a, b), level, reference = linear_exchange(integral, "linear")
        points = [(m, integral.at(m)) for m in reference]
        to_mpf = lambda f: mpf(f.numerator) / f.denominator
        for digits in range(3, 7):
            best = None
            first = floor_to(a / (1 + level), digits)
            assert 1 < first < 2
            step = Fraction(1, 10 ** (digits - 1))
            for direction in (-1, 1):
                k = 0 if direction == -1 else 1
                while True:
                    slope = first + direction * k * step
                    k += 1
                    s = to_mpf(slope)
                    # What three points alone say of the loss, whatever b.
                    highest = min((1 / g - s) / m for m, g in points)
                    if best and max(1 - (s + highest * m) * g for m, g in points) > best[0]:
                        break
                    room = -integral.maximum(lambda m, g: (s - 1 / g) / m)[1]
                    offset = floor_to(room, digits)
                    o = to_mpf(offset)
                    loss = integral.maximum(lambda m, g: 1 - (s + o * m) * g)[1]
                    if best is None or loss < best[0]:
                        best = (loss, slope, offset)
            loss, slope, offset = best
            decimal = lambda f: f"{round_fraction(f, digits).normalize():f}"
            print(model, digits, decimal(slope), decimal(offset), mp.nstr(loss, 8), flush=True)
            rows.append([model, digits, decimal(slope), decimal(offset), text(loss)])
    return rows


if __name__ == "__main__":
    write("factors_fit.csv", ["model", "form", "n_lo", "n_hi", "level", "p0", "p1", "p2", "p3"], minimax_rows())
    write("factors_rounded.csv", ["model", "digits", "a", "b", "loss"], rounded_rows())
