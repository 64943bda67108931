"""Writes filter.csv: the gain of a pixel weight, cut at Q <= 1 and normalised, for a wave across the texture; 20 digits.

In coordinates where the ellipse is the unit disc the mean of cos(k.x) is G(kappa) = int_0^1 w(r^2) J0(kappa r) r dr
/ int_0^1 w(r^2) r dr, kappa = sqrt(k^T M k), k in radians a texel. By mpmath's quadrature at 40 digits; the box and
the weight (1 - Q)^8 are checked against Sonine's closed form G = m! (2/kappa)^m J_m(kappa) (m = 1 and 9). The last
column is the gain of the Gaussian that is not cut, exp(-sigma^2 kappa^2/2), empty for other weights.
Rerun: python3 tests/references/filter.py
"""
import csv
import os

from mpmath import besselj, exp, factorial, mp, mpf, nstr, quad

mp.dps = 40
KAPPAS = ["0.5", "1", "2", "4", "6", "8"]
WEIGHTS = [
    ("gaussian", "0.25", lambda q: exp(-q * 8)),
    ("gaussian", "0.5", lambda q: exp(-q * 2)),
    ("box", "", lambda q: mpf(1)),
    ("paper-r1", "", lambda q: (1 - q) ** 8),
    ("paper-r2", "", lambda q: (1 - 9 * q / 16) ** 8),
    ("paper-r3", "", lambda q: (1 - q / 2) ** 8),
    ("paper-r4", "", lambda q: (1 - q / 8) ** 8),
]


def gain(weight, kappa):
    ends = [mpf(i) / 8 for i in range(9)]
    top = quad(lambda r: weight(r * r) * besselj(0, kappa * r) * r, ends)
    return top / quad(lambda r: weight(r * r) * r, ends)


with open(os.path.join(os.path.dirname(__file__), "filter.csv"), "w", newline="") as file:
    out = csv.writer(file, lineterminator="\n")
    out.writerow(["weight", "sigma", "kappa", "gain", "uncut"])
    for name, sigma, weight in WEIGHTS:
        for text in KAPPAS:
            kappa = mpf(text)
            value = gain(weight, kappa)
            order = {"box": 1, "paper-r1": 9}.get(name)
            if order:
                closed = factorial(order) * (2 / kappa) ** order * besselj(order, kappa)
                assert abs(closed - value) < mpf(10) ** -30, (name, text)
            uncut = nstr(exp(-(mpf(sigma) * kappa) ** 2 / 2), 20) if sigma else ""
            out.writerow([name, sigma, text, nstr(value, 20), uncut])
