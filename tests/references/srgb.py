#!/usr/bin/env python3
"""Writes srgb.csv: linear light of the 8-bit sRGB codes, by the formula of IEC 61966-2-1, 25 digits."""

from pathlib import Path

from mpmath import mp, mpf, nstr

mp.dps = 50


def light(code: int) -> mpf:
    v = mpf(code) / 255
    if v <= mpf("0.04045"):
        return v / mpf("12.92")
    return ((v + mpf("0.055")) / mpf("1.055")) ** mpf("2.4")


rows = [f"{code},{nstr(light(code), 25) if code else 0}" for code in range(256)]
Path(__file__).with_name("srgb.csv").write_text("\n".join(["code,light", *rows]) + "\n")
