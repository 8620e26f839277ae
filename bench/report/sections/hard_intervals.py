"""Expressions on which floating point fails: does the answer hold the true value, and how wide is it?"""
import math
import re

from report import page
from report.sections.interval_libraries import name, short, tell_missing, ulps

NAME = "hard_intervals"
TITLE = "Hard cases: expressions"
TARGETS = ["graze-hard-intervals", "graze-inari"]

GOOD = '<span style="color:#2e7d32">holds</span>'
USELESS = '<span style="color:#b26a00">holds, useless</span>'


def measure(context):
    """The program's verdicts; they take no time worth measuring."""
    command = [context.needed("graze-hard-intervals")]
    context.progress("expressions are evaluated")
    rows = context.json_lines(command, timeout=60)
    tell_missing(context, rows[0]["missing"])
    return {"answers": rows[1:], "command": "build/release/bin/graze-hard-intervals", "missing": rows[0]["missing"]}


def by_expression(data):
    """{formula: {library: answer}}, in order."""
    found = {}
    for answer in data["answers"]:
        found.setdefault(answer["formula"], {})[answer["library"]] = answer
    return found


def libraries(data):
    return list(dict.fromkeys(a["library"] for a in data["answers"]))


def width_text(answer):
    lower, upper = (float.fromhex(answer[k]) for k in ("lower", "upper"))
    if "width_ulps" in answer:
        words = ulps(answer["width_ulps"])
        return f"{words} ulp" + ("" if words == "1" else "s")
    return f"width {short(upper - lower)}" if math.isfinite(upper - lower) else "unbounded"


def point_cell(answer):
    """Plain double's: right, next to it, or how far off."""
    if answer["verdict"] in ("holds", "useless"):
        return page.Raw(GOOD.replace("holds", "exact"))
    if "error" not in answer:
        return page.bad("overflow")
    if float(answer["true"]) == 0:
        return page.bad(f"off by {short(answer['error'])}")
    if answer["error"] <= 1:
        return f"off by {answer['error']:.2g} ulp"
    return page.bad(f"off by {ulps(answer['error'])} ulps")


def cell(answer):
    """A library's answer in words and colour."""
    if answer is None:
        return "-"
    if answer["library"] == "double":
        return point_cell(answer)
    verdict = answer["verdict"]
    if verdict == "wrong":
        return page.bad(f"wrong: {interval_text(answer)}")
    if verdict == "no answer":
        return page.Raw(USELESS.replace("holds, useless", "no answer"))
    if verdict == "has no such function":
        return "has no such function"
    words = f"{GOOD if verdict == 'holds' else USELESS}, {width_text(answer)}"
    return page.Raw(words + ("; proves a root" if answer.get("proves") else ""))


def outward(x, up, digits=12):
    """A decimal no less (no greater) than x."""
    text = f"{x:.{digits - 1}e}"
    if not math.isfinite(x) or float(text) == x or (float(text) > x) == up:
        return shorter(text)
    mantissa, power = text.split("e")
    step = 10.0 ** -(digits - 1)
    return shorter(f"{float(mantissa) + (step if up else -step):.{digits - 1}f}e{power}")


def shorter(text):
    """1.50e+00 as 1.5."""
    if "e" not in text:
        return text
    mantissa, power = text.split("e")
    mantissa = mantissa.rstrip("0").rstrip(".") if "." in mantissa else mantissa
    if -5 <= int(power) <= 7:
        return f"{float(text):.{max(0, len(mantissa.lstrip('-').replace('.', '')) - 1 - int(power))}f}"
    return f"{mantissa}e{int(power)}"


def interval_text(answer):
    if answer is None or "lower" not in answer:
        return "-"
    lower, upper = (float.fromhex(answer[k]) + 0.0 for k in ("lower", "upper"))  # no -0
    return f"{lower:.17g}" if lower == upper else f"[{outward(lower, False)}, {outward(upper, True)}]"


def true_text(answer):
    """Twelve digits of the true value."""
    mantissa, e, power = answer["true"].partition("e")
    short_one = re.match(r"-?(\d{12,}|[0.]*(\d\.?){0,12})", mantissa)[0].rstrip(".")
    return answer["true"] if len(short_one) >= len(mantissa) else f"{short_one}…{e}{power}"


def counts(data, library):
    """{verdict: how often}."""
    found = {}
    for answer in data["answers"]:
        if answer["library"] == library:
            found[answer["verdict"]] = found.get(answer["verdict"], 0) + 1
    return found


def wrong(data):
    """[(library, [expressions])] of interval libraries whose answer does not hold the true value."""
    found = {}
    for answer in data["answers"]:
        if answer["verdict"] == "wrong" and answer["library"] != "double":
            found.setdefault(answer["library"], []).append(answer["formula"])
    return list(found.items())


def widths(data):
    """[(peer, formula, peer's width / Graze's)] of sound peers, finite widths that differ."""
    found = []
    for formula, answers in by_expression(data).items():
        ours = answers.get("interval<>", {}).get("width_ulps")
        for library, answer in answers.items():
            if library not in ("interval<>", "double") and ours and answer["verdict"] in ("holds", "useless") \
                    and answer.get("width_ulps", ours) != ours:
                found.append((library, formula, answer["width_ulps"] / ours))
    return found


def verdict_text(data):
    """Sentences of the caption, all from the data."""
    ours, double = counts(data, "interval<>"), counts(data, "double")
    total = sum(ours.values())
    words = [f"Graze holds the true value in {ours.get('holds', 0) + ours.get('useless', 0)} of {total} expressions, "
             f"and plain double's answer is the true value in {double.get('holds', 0)}."]
    for library, formulas in wrong(data):
        words.append(f"{name(library)} is wrong on {'; '.join(formulas)}.")
    if ours.get("useless"):
        words.append(f"{ours['useless']} of Graze's answers hold the value and tell no digit of it: evaluated "
                     "in 53 bits, these formulas need more bits or another form.")
    narrower = [(x, f, q) for x, f, q in widths(data) if q < 1]
    if narrower:
        words.append("Narrower than Graze and sound: " + "; ".join(f"{name(x)} on {f} ({q:.2g} of the width)"
                                                                   for x, f, q in narrower) + ".")
        if any(x == "Arb" for x, _, _ in narrower):
            words.append("(A ball's radius may be far below an ulp of its midpoint; an inexact value between doubles "
                         "is at least an ulp wide.)")
    return " ".join(words)


def summary(data):
    """A sentence for the head of the page."""
    ours, double = counts(data, "interval<>"), counts(data, "double")
    bad = ", ".join(f"{name(library)} is wrong on {len(formulas)}" for library, formulas in wrong(data))
    return [f"Of {sum(ours.values())} expressions on which floating point fails Graze holds the true value in "
            f"{sum(ours.values()) - ours.get('wrong', 0) - ours.get('no answer', 0)}, plain double hits it in "
            f"{double.get('holds', 0)}{'; ' + bad if bad else ''}."]


def show(data):
    names = libraries(data)
    rows, answers = [], []
    for formula, by_library in by_expression(data).items():
        any_of = next(iter(by_library.values()))
        rows.append([page.Raw(f"<b>{page.escape(any_of['expression'])}</b><br>{page.escape(formula)}"),
                     *(cell(by_library.get(x)) for x in names)])
        answers.append([formula, true_text(any_of), *(interval_text(by_library.get(x))
                                                    for x in ("interval<>", "double"))])
    heads = ["expression", *map(name, names)]
    return [
        page.text("<p>Each expression is one template, evaluated by every library as it stands, constants enclosed "
                  "where they are no doubles. The true value is MPFR's with 4,000 bits, checked with 2,000. "
                  f"Repeated by <code>{page.escape(data['command'])}</code>.</p>"),
        page.table(heads, rows, "Does the answer hold the true value? Widths in ulps of the true value. "
                   "Useless: wider than the value itself (than 1/2 where it is 0). Wrong: the true value is outside; "
                   "for plain double its error. " + verdict_text(data)),
        page.table(["expression", "true value", "Graze's enclosure, rounded outwards", "plain double's answer"],
                   answers, "The answers themselves."),
    ]
