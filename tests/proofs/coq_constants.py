#!/usr/bin/env python3
"""usage: coq_constants.py ROOT [--self-test]

The constants of the C++ code that the Coq files repeat are the same numbers there. Each row: a file of
octree/geometry/include/graze/octree and a pattern with the constant, a file of proofs/coq and a pattern, in which a
double is (53-bit significand, exponent). --self-test: each row notices a constant that is another one.
Exit codes: 0 the same, 1 one is not, or is not found.
"""
import fractions
import pathlib
import re
import sys

CODE = "octree/geometry/include/graze/octree"
HEX = r"(-?0x[0-9a-f.]+(?:p[+-]?\d+)?)"
COQ_DOUBLE = r"Definition {} : double := @B754_finite 53 1024 false (\d+) \(?(-?\d+)\)? eq_refl"

ROWS = [
    # certainly_greater
    ("determinant_sign.hpp", r"double margin = " + HEX, "Exact_filter.v", COQ_DOUBLE.format("margin")),
    ("determinant_sign.hpp", r"double tiny = " + HEX, "Exact_filter.v", COQ_DOUBLE.format("tiny")),
    ("determinant_sign.hpp", r"most = " + HEX, "Exact_filter.v", COQ_DOUBLE.format("most")),
    ("determinant_sign.hpp", r"certain_distance = " + HEX, "Exact_filter.v", COQ_DOUBLE.format("certain_distance")),
    # direction_scale, scales_exactly
    ("exact_touch.hpp", r"largest < " + HEX + r" \?", "Exact_filter.v", COQ_DOUBLE.format("two_to_minus_400")),
    ("exact_touch.hpp", r"largest < \S+ \? " + HEX, "Exact_filter.v", COQ_DOUBLE.format("two_to_600")),
    ("exact_touch.hpp", r"largest > " + HEX + r" \?", "Exact_filter.v", COQ_DOUBLE.format("two_to_400")),
    ("exact_touch.hpp", r"largest > \S+ \? " + HEX, "Exact_filter.v", COQ_DOUBLE.format("two_to_minus_600")),
    ("exact_touch.hpp", r"fabs\(component\) >= " + HEX, "Exact_filter.v", COQ_DOUBLE.format("two_to_minus_422")),
    # determinant_sign
    ("determinant_sign.hpp", r"above >= (\d+) \|\|", "Determinant_sign.v", r"\((\d+) <=\? above\) \|\|"),
    ("determinant_sign.hpp", r"above <= (-\d+)\)", "Determinant_sign.v", r"\(above <=\? (-\d+)\) then None"),
    ("determinant_sign.hpp", r"fits = \(by_g \| by_l\) < (\d+)", "Determinant_sign.v", r"fits := \(by_g <\? (\d+)\)"),
    ("determinant_sign.hpp", r"\(by_g \| by_l\) < (\d+)", "Determinant_sign.v", r"&& \(by_l <\? (\d+)\)"),
    ("determinant_sign.hpp", r"times 2\^shift, shift < (\d+)", "Determinant_sign.v", r"2 \^ 170 -> 0 <= shift < (\d+) ->"),
    # sign_of_sum
    ("determinant_sign.hpp", r"int gap = (\d+);", "Sum_sign.v", r"term_exponent u <\? (\d+)"),
    ("determinant_sign.hpp", r"unsigned limbs = (\d+);", "Sum_sign.v", r"if 2 \^ (511) <=\? s"),
]


def number(text):
    """The exact value of a hexadecimal literal with its exponent, or of an integer."""
    if text.lstrip("-").startswith("0x"):
        mantissa, _, exponent = text.partition("p")
        whole, _, part = mantissa.partition(".")
        return (fractions.Fraction(int(whole + part, 16), 16 ** len(part)) *
                fractions.Fraction(2) ** int(exponent or 0))
    return fractions.Fraction(int(text))


def found(text, pattern):
    match = re.search(pattern, text)
    if not match:
        return None
    if match.lastindex == 2:
        return fractions.Fraction(int(match[1])) * fractions.Fraction(2) ** int(match[2])
    return number(match[1])


def problem(row, code, coq):
    """None, or why the row does not hold."""
    of_code, of_coq = found(code, row[1]), found(coq, row[3])
    if of_code is None or of_coq is None:
        return f"{row[0]} or {row[2]} has no match of its pattern: {row[1] if of_code is None else row[3]}"
    if "limbs" in row[1]:  # the sign is bit 64 limbs - 1
        of_code = 64 * of_code - 1
    return None if of_code == of_coq else f"{row[0]} has {of_code} where {row[2]} has {of_coq}: {row[1]}"


def changed(text, pattern):
    """The text with the constant made another one."""
    match = re.search(pattern, text)
    at = match.start(1)
    digit = next(i for i in range(match.end(1) - 1, at - 1, -1) if text[i].isdigit())
    return text[:digit] + str((int(text[digit]) + 1) % 10) + text[digit + 1:]


def main():
    root = pathlib.Path(sys.argv[1])
    wrong = 0
    for row in ROWS:
        code, coq = (root / CODE / row[0]).read_text(), (root / "proofs/coq" / row[2]).read_text()
        why = problem(row, code, coq)
        if "--self-test" in sys.argv[2:]:
            if not why and problem(row, changed(code, row[1]), coq):
                continue
            why = why or f"a change of {row[0]} goes unseen: {row[1]}"
        if why:
            print(why)
            wrong += 1
    print(f"{len(ROWS)} constants, {wrong} wrong")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
