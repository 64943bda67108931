"""Writes measured.csv, measured_samples.csv, student.csv and chi_square.csv: lobes fitted by scipy; Student's quantiles
and the tails of chi-square by mpmath.

measured_samples.csv holds 120 samples of 2.5 cos^80 with noise, an angle, a value and a sigma each, from a fixed
seed. measured.csv holds, for every family of two parameters and with sigma read as an absolute error, as a relative
weight, and not at all, scale, n, their standard errors and correlation by scipy.optimize.curve_fit (MINPACK's
Levenberg-Marquardt, tolerances 1e-15, analytic weights; curve_fit's Jacobian by finite differences is replaced by
complex steps, exact to rounding). student.csv holds t with P(|T| < t) = p to 25 digits: the root of the regularised
incomplete beta function. chi_square.csv holds P(X < x) and P(X > x) to 25 digits: the series of the incomplete gamma
function with 300 digits, checked by mpmath's own up to 9998 degrees.

Rerun: python3 tests/references/measured.py
"""
import csv

import numpy as np
from mpmath import betainc, erf, exp, findroot, gammainc, log, loggamma, mp, mpf, sqrt
from scipy.optimize import curve_fit

from integrand import HERE

# The adopted bells' coefficients are the crate's data, read from where it publishes them.
BELLS = {}
with open(HERE / "../../fits/kernels-cosn.csv", newline="") as file:
    for row in csv.DictReader(file):
        if row["printed"] == "false":
            BELLS[(int(row["degree"]), int(row["power"]))] = row


def poly(row, name, m):
    return sum(float(row[f"{name}{i}"] or 0) * m**i for i in range(3))


def bell(degree, power):
    row = BELLS[(degree, power)]

    def f(w, n):
        m = 1 / n
        y = n * w / poly(row, "t", m)
        p = (1 - y) * (1 + poly(row, "alpha", m) * y + poly(row, "beta", m) * y * y)
        return np.where(np.real(y) < 1, p, 0) ** power

    return f


FAMILIES = {
    "cos-n": lambda w, n: np.exp(n * np.log1p(-w)),
    "cs-16": lambda w, n: np.where(np.real(n * w) < 16, 1 - n * w / 16, 0) ** 16,
    "linear-4": bell(1, 4),
    "cubic-2": bell(3, 2),
    "cubic-4": bell(3, 4),
    "cubic-8": bell(3, 8),
    "spherical-gaussian": lambda w, n: np.exp(-n * w),
    "schlick": lambda w, n: (1 - w) / ((1 - w) + n * w),
}

rng = np.random.default_rng(80)
theta = np.round(rng.uniform(-28, 28, 120), 3)
sigma = np.round(rng.uniform(0.01, 0.08, 120), 4)
value = np.round(2.5 * np.cos(np.radians(theta)) ** 80 + sigma * rng.standard_normal(120), 4)
with open(HERE / "measured_samples.csv", "w", newline="") as file:
    writer = csv.writer(file, lineterminator="\n")
    writer.writerow(["theta_deg", "value", "sigma"])
    writer.writerows(zip(theta.tolist(), value.tolist(), sigma.tolist()))

w = 2 * np.sin(np.radians(theta) / 2) ** 2
STEP = 1e-30
with open(HERE / "measured.csv", "w", newline="") as file:
    writer = csv.writer(file, lineterminator="\n")
    writer.writerow(["family", "weighting", "scale", "n", "scale_error", "n_error", "correlation", "chi_square"])
    for family, f in FAMILIES.items():

        def model(w, a, n):
            return a * f(w, n)

        def jacobian(w, a, n):
            return np.stack([f(w, n), a * np.imag(f(w, n + 1j * STEP)) / STEP], axis=1)

        for weighting in ["equal", "weight", "sigma"]:
            noise = None if weighting == "equal" else sigma
            p, covariance = curve_fit(
                model, w, value, p0=[2.0, 60.0], sigma=noise, absolute_sigma=weighting == "sigma", jac=jacobian,
                ftol=1e-15, xtol=1e-15, gtol=1e-15, maxfev=10000,
            )
            error = np.sqrt(np.diag(covariance))
            residual = (value - model(w, *p)) / (1 if noise is None else sigma)
            numbers = [*p, *error, covariance[0, 1] / (error[0] * error[1]), np.sum(residual**2)]
            writer.writerow([family, weighting, *(f"{x:.12e}" for x in numbers)])

mp.dps = 40
with open(HERE / "student.csv", "w", newline="") as file:
    writer = csv.writer(file, lineterminator="\n")
    writer.writerow(["probability", "degrees", "quantile"])
    for p in ["0.5", "0.9", "0.95", "0.99", "0.999"]:
        near = findroot(lambda t: erf(t / sqrt(2)) - mpf(p), 2)
        writer.writerow([p, "", mp.nstr(near, 25)])
        for degrees in [1, 2, 3, 4, 5, 7, 10, 11, 20, 30, 60, 100, 101, 500, 1000, 1001, 2000, 9998, 1000000]:

            def within(t):
                return betainc(mpf(1) / 2, mpf(degrees) / 2, 0, t * t / (degrees + t * t), regularized=True)

            # From one degree on the root lies above the normal quantile.
            low, high = near, near
            while within(high) < mpf(p):
                low, high = high, high * 2
            if low == high:
                low = high / 2
            root = findroot(lambda t: within(t) - mpf(p), (low, high), solver="anderson", tol=1e-60)
            assert abs(within(root) - mpf(p)) < mpf(10) ** -28
            writer.writerow([p, degrees, mp.nstr(root, 25)])

with open(HERE / "chi_square.csv", "w", newline="") as file:
    writer = csv.writer(file, lineterminator="\n")
    writer.writerow(["degrees", "chi_square", "below", "above"])
    for degrees in [1, 2, 3, 5, 10, 31, 32, 33, 100, 1001, 9998, 5_000_000]:
        for z in [-10, -4, -1.5, -0.5, 0, 0.5, 1.5, 4, 10, 35]:
            x = round(degrees + z * (2 * degrees) ** 0.5, 2)
            if x <= 0:
                x = round(degrees * 2.0 ** (z - 4), 6)
            # The smallest tail is 1e-204: so many digits are left of its difference from 1.
            mp.dps = 300
            a, y = mpf(degrees) / 2, mpf(x) / 2
            term, total, k = mpf(1), mpf(1), a
            while term > mpf(10) ** -290 * total:
                k += 1
                term *= y / k
                total += term
            below = total * exp(a * log(y) - y - loggamma(a + 1))
            above = 1 - below
            mp.dps = 40
            if degrees < 10_000:
                for own, other in [(below, gammainc(a, 0, y, regularized=True)), (above, gammainc(a, y, regularized=True))]:
                    assert abs(own / other - 1) < mpf(10) ** -28, (degrees, x)
            writer.writerow([degrees, repr(x), mp.nstr(below, 25), mp.nstr(above, 25)])
