#!/usr/bin/env python3
"""Writes the tables beside it: make_tables.py [--check]

Each entry is computed by mpmath with 300 bits and rounded to nearest; logarithm_table.hpp's reciprocals
have the most bits with which r x - 1 is a double for every double x of their interval
and the error bound of logarithm_pair.cpp holds. --check writes nothing. Exit codes: 0 the tables are so, or were written; 1 one
differs; 2 bad input."""
import argparse
import pathlib
import re
import sys
from fractions import Fraction

HERE = pathlib.Path(__file__).resolve().parent


def hexadecimal(x):
    """As the tables have it: a double's shortest hexadecimal form."""
    mantissa, exponent = float(x).hex().split("p")
    return re.sub(r"\.?0+$", "", mantissa) + "p" + exponent if float(x) else "0x0p+0"


def pair(value, step=None):
    """(high, low): high rounded to nearest, among multiples of `step` if given; low the rest."""
    from mpmath import mpf, nint
    high = mpf(float(value)) if step is None else nint(value / step) * step
    return [hexadecimal(high), hexadecimal(value - high)]


def exponentials():
    from mpmath import mpf
    for i in range(128):
        yield pair(mpf(2) ** (mpf(i) / 128))


def angles():
    from mpmath import atan, mpf
    for j in range(129):
        yield pair(atan(mpf(j) / 128), mpf(2) ** -48)


def sines():
    from mpmath import mpf, sinpi
    for j in range(512):
        yield pair(sinpi(mpf(j) / 256))


def reciprocal(first, last, unit):
    """r and -log r for x in [first, last), whose doubles are multiples of `unit`."""
    from mpmath import log, mpf, nint
    if 1 in (first, last):
        return Fraction(1), mpf(0)  # log is relative to x - 1 there
    for bits in range(20, 0, -1):
        r = Fraction(round(2 ** bits * 2 / (first + last)), 2 ** bits)
        minus_log = -log(mpf(r.numerator) / r.denominator)
        high = abs(Fraction(int(nint(minus_log * 2 ** 42)), 2 ** 42))
        size = max(abs(r * first - 1), abs(r * last - 1))
        if size <= Fraction(1, 2 ** 7) and size <= unit * 2 ** (53 - bits) and (high == 0 or size <= high):
            return r, minus_log
    raise AssertionError(f"no reciprocal for [{first}, {last})")


def logarithms():
    from mpmath import mpf
    x = Fraction(11, 16)
    while x < Fraction(11, 8):
        width, unit = (Fraction(1, 2 ** 8), Fraction(1, 2 ** 53)) if x < 1 else (Fraction(1, 2 ** 7), Fraction(1, 2 ** 52))
        r, minus_log = reciprocal(x, x + width, unit)
        yield [hexadecimal(r), *pair(minus_log, mpf(2) ** -42)]
        x += width


TABLES = {"exponential": exponentials, "logarithm": logarithms, "angle": angles, "sine": sines}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true")
    given = parser.parse_args()
    try:
        import mpmath
    except ImportError:
        print("make_tables.py needs mpmath (Debian: python3-mpmath)", file=sys.stderr)
        return 2
    mpmath.mp.prec = 300
    different = 0
    for name, rows in TABLES.items():
        path = HERE / f"{name}_table.hpp"
        text = path.read_text()
        made = "".join("    {" + ", ".join(row) + "},\n" for row in rows())
        whole = re.sub(r"(= \{\n)(?:    \{.*\},\n)+", lambda m: m[1] + made, text)
        different += whole != text
        print(f"{path.name}: {'the same' if whole == text else 'another table'}")
        if not given.check:
            path.write_text(whole)
    return 1 if given.check and different else 0


if __name__ == "__main__":
    sys.exit(main())
