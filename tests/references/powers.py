"""Writes powers.csv: c^n for doubles c and whole n, 20 significant digits, mpmath at 60.

c is printed so that it reads back; near 1, where lobes live, as 1 - k/n for several k, and between.

Rerun: python3 tests/references/powers.py
"""
import csv
import random

from mpmath import mp, mpf

from integrand import HERE

mp.dps = 60
random.seed(16)

rows = []
for n in [1, 2, 3, 7, 16, 31, 64, 100, 1000, 1023, 1024, 4097, 65536]:
    for k in [0.01, 0.5, 1, 3, 9, 30]:
        c = 1 - k / n
        if c > 0:
            rows.append((c, n))
    rows.append((random.random(), n))

with open(HERE / "powers.csv", "w", newline="") as file:
    writer = csv.writer(file, lineterminator="\n")
    writer.writerow(["c", "n", "power"])
    for c, n in rows:
        value = mpf(c) ** n
        if value > mpf("1e-290"):
            writer.writerow([repr(c), n, mp.nstr(value, 20, strip_zeros=False, min_fixed=0, max_fixed=0)])
