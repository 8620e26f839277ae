"""What the sections on intervals share: names of libraries and numbers on the page, and what is missing."""
import re

# of the programs: on the page, whether its caller has to hold a rounding mode
NAMES = {
    "interval<>": ("Graze scalar", False),
    "unprotected<upward>": ("Graze scalar, upward held", True),
    "interval<upward>": ("Graze scalar, upward", False),
    "unprotected<split>": ("Graze scalar, split held", True),
    "interval<split>": ("Graze scalar, split", False),
    "interval<switching>": ("Graze scalar, switching", False),
    "batch baseline": ("Graze 8-wide, baseline", False),
    "batch avx2": ("Graze 8-wide, AVX2", False),
    "batch avx512": ("Graze 8-wide, AVX-512", False),
    "Boost": ("Boost", False),
    "Boost unprotected": ("Boost unprotected", True),
    "Boost std": ("Boost, std", False),
    "Boost not rounded": ("Boost, raw", False),
    "CGAL": ("CGAL", False),
    "CGAL unprotected": ("CGAL unprotected", True),
    "MPFI": ("MPFI", False),
    "Arb": ("Arb", False),
    "inari": ("inari", False),
    "double": ("double", False),
    "double vectorised": ("double, vectorised", False),
}


def name(library):
    """On the page."""
    return NAMES.get(library, (library, False))[0]


def is_held(library):
    """Its caller must hold a rounding mode for its whole life."""
    return NAMES.get(library, (library, False))[1]


def group(library):
    """Graze scalar, Graze 8-wide, Boost, ...: a colour each."""
    return re.split(",| unprotected", name(library))[0]


def tell_missing(context, missing):
    """Records what a program's list "NAME (WHY); ..." says is left out."""
    for entry in filter(None, missing.split("; ")):
        library, _, why = entry.rstrip(")").partition(" (")
        debian = why.startswith("lib")
        context.missing(name(library), why if debian else "", "" if debian else why)


def short(x, digits=2):
    """A number of few digits."""
    return f"{float(f'{x:.{digits}g}'):g}"


def ulps(x):
    """An excess in few characters."""
    return short(x) if x < 1e4 else f"{x:.0e}".replace("e+0", "e").replace("e+", "e")
