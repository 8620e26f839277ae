#!/usr/bin/env python3
"""The implicit surfaces of MathMod's public collection, rendered by graze-render and judged ray by ray.

    bench/formulas/collection.py build/release/bin/graze-render
    bench/formulas/collection.py build/release/bin/graze-render --only Chmutov --size 96 --json

The collection is taken from its repository (a fixed commit) unless --collection names a file. Constants and
functions of a model are written into its formula, the time t is 0; a model of several formulas is several. Each is rendered with proven depths
(.npz). Where the formula is a polynomial with rational coefficients, FLINT (python-flint) finds the exact
roots along the exact ray of each pixel, in the domain's exact part of it:

  wrong      a hit whose enclosure does not hold the first root, a miss where there is one
  undecided  by graze-render; `decidable` are those of them along which exact arithmetic decides

Needs numpy and python-flint (pip install numpy python-flint). Exit codes: 0 nothing wrong, 1 something is,
2 bad input.
"""
import argparse
import ast
import json
import re
import subprocess
import sys
import tempfile
import time
import urllib.request
from pathlib import Path

COMMIT = "622f2c63db64844dec1742f2c1c842e654afe3a9"
ADDRESS = f"https://raw.githubusercontent.com/parisolab/mathmod/{COMMIT}/mathmodcollection.js"
LONGEST = 60_000  # bytes of a formula
DEGREE = 40  # along a ray, of those that are judged: FLINT takes seconds a ray for much greater ones


class NotTaken(Exception):
    """Why a model is passed over."""


def parsed(text):
    """The expression, in Python's grammar: the same operators and precedence, ^ for powers."""
    text = re.sub(r"(?<![<>=!])=(?!=)", "==", text).replace("^", "**").replace("\n", " ")
    text = re.sub(r"\bif\s*\(", "if_(", text)
    try:
        return ast.parse(text.strip(), mode="eval").body
    except SyntaxError as e:
        raise NotTaken(f"not read: {e.msg}") from e


class Inlined(ast.NodeTransformer):
    """Constants by their expressions, functions by their bodies with the arguments in them."""

    def __init__(self, constants, functions, arguments=None):
        self.constants, self.functions, self.arguments = constants, functions, arguments or {}

    def visit_Name(self, node):
        if node.id in self.arguments:
            return self.arguments[node.id]
        if node.id in self.constants:
            return Inlined(self.constants, self.functions).visit(parsed(self.constants[node.id]))
        return node

    def visit_Call(self, node):
        given = [self.visit(a) for a in node.args]
        name = node.func.id if isinstance(node.func, ast.Name) else ""
        if name in self.functions:
            body = parsed(self.functions[name])
            r = Inlined(self.constants, self.functions, dict(zip("xyzt", given))).visit(body)
            if len(ast.unparse(r)) > LONGEST:
                raise NotTaken("longer than a formula may be")
            return r
        return ast.Call(node.func, given, [])


def definitions(entries):
    result = {}
    for entry in entries or []:
        name, _, body = entry.partition("=")
        result[name.strip()] = body
    return result


def in_graze(node):
    """As graze-render writes it."""
    if isinstance(node, ast.Compare):
        raise NotTaken("comparisons")
    text = ast.unparse(node).replace("**", "^")
    return re.sub(r"\bif_\(", "if(", text)


def model(entry, which):
    constants, functions = definitions(entry.get("Const")) | {"t": "0"}, definitions(entry.get("Funct"))
    if entry.get("Vect") or entry.get("Import"):
        raise NotTaken("vectors or imports")

    def inlined(text):
        try:
            return Inlined(constants, functions).visit(parsed(text))
        except RecursionError as e:
            raise NotTaken("nested too deep") from e
    f = inlined(entry["Fxyz"][which])
    names = {n.id for n in ast.walk(f) if isinstance(n, ast.Name)}
    if any(isinstance(n, (ast.Compare, ast.BoolOp, ast.BitOr, ast.BitAnd)) for n in ast.walk(f)) or "if_" in names:
        raise NotTaken("comparisons")
    ends = []
    for end in ("Xmin", "Xmax", "Ymin", "Ymax", "Zmin", "Zmax"):
        try:
            ends.append(float(eval(compile(ast.fix_missing_locations(ast.Expression(inlined(entry[end][min(which, len(entry[end]) - 1)]))), "end", "eval"),
                                   {"__builtins__": {}, "pi": 3.141592653589793})))
        except (NameError, TypeError, SyntaxError) as e:
            raise NotTaken(f"domain: {e}") from e
    text = in_graze(f)
    if len(text) > LONGEST:
        raise NotTaken("longer than a formula may be")
    return f, text, ends


class Judge:
    """Exact roots along rays, by FLINT."""

    def __init__(self):
        import flint
        self.flint = flint

    def function(self, f):
        """f of three polynomials in t; nothing where it is no polynomial with rational coefficients."""
        q, poly = self.flint.fmpq, self.flint.fmpq_poly

        class Exact(ast.NodeTransformer):
            def visit_Constant(self, node):
                return ast.copy_location(ast.Call(ast.Name("number", ast.Load()), [ast.Constant(str(node.value))], []), node)

        def number(text):
            mantissa, _, exponent = text.lower().partition("e")
            whole, _, part = mantissa.partition(".")
            scale = int(exponent or 0) - len(part)
            value = q(int(whole + part), 1)
            return value * q(10) ** scale if scale >= 0 else value / q(10) ** -scale
        code = compile(ast.fix_missing_locations(ast.Expression(Exact().visit(ast.parse(ast.unparse(f), mode="eval").body))),
                       "f", "eval")

        class P:
            """A polynomial, or a constant, that is divided by constants alone."""
            def __init__(self, p):
                self.p = p if isinstance(p, poly) else poly([p])

            def _of(self, other):
                return other if isinstance(other, P) else P(other)

            def __add__(self, o): return P(self.p + self._of(o).p)
            def __radd__(self, o): return P(self._of(o).p + self.p)
            def __sub__(self, o): return P(self.p - self._of(o).p)
            def __rsub__(self, o): return P(self._of(o).p - self.p)
            def __mul__(self, o): return P(self.p * self._of(o).p)
            def __rmul__(self, o): return P(self._of(o).p * self.p)
            def __neg__(self): return P(-self.p)
            def __pos__(self): return self

            def constant(self):
                if self.p.degree() > 0:
                    raise NotTaken("no polynomial")
                return self.p[0]

            def __truediv__(self, o):
                c = self._of(o).constant()
                if c == 0:
                    raise NotTaken("a division by 0")
                return P(self.p / c)

            def __rtruediv__(self, o): return self._of(o) / self

            def __pow__(self, o):
                n = self._of(o).constant()
                if n.q != 1 or n < 0:
                    raise NotTaken("no polynomial")
                return P(self.p ** int(n.p))

        def at(x, y, z):
            try:
                r = eval(code, {"__builtins__": {}, "number": lambda t: P(number(t)), "x": P(x), "y": P(y), "z": P(z)})
            except (NameError, TypeError) as e:
                raise NotTaken("no polynomial") from e
            return r.p if isinstance(r, P) else poly([r])
        return at

    def exact(self, value):
        n, d = float(value).as_integer_ratio()
        return self.flint.fmpq(n, d)

    def span(self, origin, direction, ends):
        """The exact [entry, exit] of t >= 0 in the domain, or nothing."""
        lo, hi = self.flint.fmpq(0), None
        for a in range(3):
            o, d = self.exact(origin[a]), self.exact(direction[a])
            near, far = self.exact(ends[2 * a]), self.exact(ends[2 * a + 1])
            if d == 0:
                if not near <= o <= far:
                    return None
                continue
            s, e = sorted(((near - o) / d, (far - o) / d))
            lo = max(lo, s)
            hi = e if hi is None else min(hi, e)
        return (lo, hi) if lo <= hi else None

    def first_root(self, g, lo, hi):
        """Doubles below and above the first real root in [lo, hi], or nothing."""
        g = g.numer()
        first = None
        for part, _ in g.factor_squarefree()[1]:
            if part.degree() < 1:
                continue
            for root, _ in part.complex_roots():
                if root.imag != 0:
                    continue
                r = root.real
                if r < lo or r > hi:
                    continue
                if not (r >= lo and r <= hi):
                    r = self.at_end(part, r, lo, hi)
                    if r is None:
                        continue
                if first is None or r.mid() < first.mid():
                    first = r
        return first

    def at_end(self, part, r, lo, hi):
        """A root that its enclosure cannot tell from an end of the span: it is that end, or beside it."""
        for end in (lo, hi):
            if r.contains(end):
                value = part(end)
                if value == 0:
                    return self.flint.arb(end)
                inside = (r.mid() > end) if end == lo else (r.mid() < end)
                return r if inside else None
        return r


VERDICTS = ("hit", "miss", "undecided", "pole", "jump", "gap")


def judged(judge, f, ends, proof):
    """Over the pixels: (rays, wrong, decidable, the first that is wrong)."""
    at = judge.function(f)
    exact = judge.exact
    eye = proof["eye"]
    if at(*(judge.flint.fmpq_poly([k, k + 2]) for k in (1, 2, 3))).degree() > DEGREE:
        raise NotTaken("of too high a degree")
    wrong, decidable, example, rays = 0, 0, "", 0
    for row, column in ((r, c) for r in range(proof["verdict"].shape[0]) for c in range(proof["verdict"].shape[1])):
        direction = proof["direction"][row, column]
        said = VERDICTS[proof["verdict"][row, column]]
        span = judge.span(eye, direction, ends)
        root, within = None, False
        if span is not None:
            g = at(*(judge.flint.fmpq_poly([exact(eye[a]), exact(direction[a])]) for a in range(3)))
            within = g.degree() < 0
            root = judge.flint.arb(span[0]) if within else judge.first_root(g, *span)
        rays += 1
        if said == "undecided":
            decidable += 1
            continue
        right = root is None
        if said == "hit":  # depth = t |direction|; squared, so that no root is taken
            depth2 = None if root is None else root * root * sum((exact(d) ** 2 for d in direction), judge.flint.fmpq(0))
            right = depth2 is not None and not depth2 < exact(proof["depth_lower"][row, column]) ** 2 and \
                not depth2 > exact(proof["depth_upper"][row, column]) ** 2
        if not right:
            wrong += 1
            example = example or f"pixel {column},{row}: {said}, exact root {root}"
    return rays, wrong, decidable, example


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("render", type=Path, help="graze-render")
    parser.add_argument("--collection", type=Path, help="mathmodcollection.js, rather than taking it from its repository")
    parser.add_argument("--only", default="", help="models whose name holds this regular expression")
    parser.add_argument("--size", type=int, default=48, help="pixels a side")
    parser.add_argument("--seconds", type=float, default=60, help="for a picture")
    parser.add_argument("--no-judge", action="store_true", help="verdicts are counted only")
    parser.add_argument("--json", action="store_true", help="a JSON object a model")
    given = parser.parse_args()
    try:
        text = given.collection.read_text(encoding="utf-8") if given.collection else \
            urllib.request.urlopen(ADDRESS, timeout=60).read().decode("utf-8")
        entries = json.loads(text, strict=False)["MathModels"]
    except (OSError, ValueError, KeyError) as e:
        print(f"collection.py: the collection cannot be read: {e}", file=sys.stderr)
        return 2
    judge = None if given.no_judge else Judge()
    import numpy
    totals = {"models": 0, "passed_over": 0, "refused": 0, "judged": 0, "rays": 0, "wrong": 0, "undecided": 0,
              "decidable": 0}
    surfaces = [(e["Iso3D"], i) for e in entries if "Iso3D" in e for i in range(len(e["Iso3D"]["Fxyz"]))]
    for entry, which in surfaces:
        name = entry["Name"][0] + (f"[{which}]" if len(entry["Fxyz"]) > 1 else "")
        if not re.search(given.only, name):
            continue
        row = {"model": name}
        try:
            f, formula, ends = model(entry, which)
        except NotTaken as e:
            totals["passed_over"] += 1
            if given.json:
                print(json.dumps(row | {"passed_over": str(e)}), flush=True)
            continue
        totals["models"] += 1
        with tempfile.TemporaryDirectory() as folder:
            out = Path(folder) / "proof.npz"
            start = time.monotonic()
            try:
                done = subprocess.run([given.render, "--formula", formula, "--domain=" + ",".join(map(repr, ends)),
                                       "--size", str(given.size), "--json", "-o", out], capture_output=True,
                                      text=True, timeout=given.seconds)
            except subprocess.TimeoutExpired:
                row["refused"] = f"took over {given.seconds:.0f} s"
                done = None
            row["seconds"] = round(time.monotonic() - start, 3)
            if done is not None and done.returncode != 0:
                row["refused"] = done.stderr.strip().splitlines()[0][:200] if done.stderr.strip() else "?"
            if "refused" in row:
                totals["refused"] += 1
            else:
                said = json.loads(done.stdout.splitlines()[-1])
                row |= {k: said[k] for k in ("hits", "misses", "poles", "jumps", "gaps", "undecided") if k in said}
                totals["undecided"] += said["undecided"]
                if judge is not None:
                    try:
                        rays, wrong, decidable, example = judged(judge, f, ends, numpy.load(out))
                        row |= {"judged": True, "wrong": wrong, "decidable": decidable}
                        totals["judged"] += 1
                        totals["rays"] += rays
                        totals["wrong"] += wrong
                        totals["decidable"] += decidable
                        if example:
                            row["example"] = example
                    except NotTaken as e:
                        row["not_judged"] = str(e)
        print(json.dumps(row) if given.json else
              f"{name:40.40} " + "  ".join(f"{k} {v}" for k, v in row.items() if k != "model"), flush=True)
    print(json.dumps(totals) if given.json else "  ".join(f"{k} {v}" for k, v in totals.items()))
    return 1 if totals["wrong"] else 0


if __name__ == "__main__":
    sys.exit(main())
