#!/usr/bin/env python3
"""run_statement.py SOLVER FILE [--seconds N]: one statement over binary64, by one solver.

A statement holds if its negation is unsatisfiable (`; expected: unsat`). A statement made false on
purpose must have a model (`; expected: sat`), which is replayed here in exact arithmetic with
directed rounding. `; undecided: SOLVER` names one that is known to find no answer in reasonable time;
it gets a few seconds. What passed is not solved again until the statement or the solver changes
(--passed FOLDER). Exit codes: 0 as expected; 1 not so, or unknown; 77 no solver, or undecided as
foretold, which proves nothing.
"""
import argparse
import hashlib
import importlib.metadata
import math
import os
import re
import resource
import struct
import subprocess
import sys
import time
from fractions import Fraction
from pathlib import Path

SOLVERS = ("bitwuzla", "cvc5")
PRELUDE = Path(__file__).resolve().parent / "ray_bounds.smt2"


# The operations of ray_bounds.smt2, computed apart from the solvers.

def bits(x):
    return "nan" if math.isnan(x) else struct.pack(">d", x)


def finite_result(exact, up):
    """The double next to an exact rational number, downwards or upwards; not for zero."""
    try:
        near = float(exact)  # correctly rounded to nearest
    except OverflowError:
        near = math.inf if exact > 0 else -math.inf
    if math.isinf(near):
        largest = math.copysign(sys.float_info.max, near)
        return near if (near > 0) == up and abs(exact) > sys.float_info.max else largest
    if up and Fraction(near) < exact:
        return math.nextafter(near, math.inf)
    if not up and Fraction(near) > exact:
        return math.nextafter(near, -math.inf)
    return near


def directed(x, y, operation, exact, up):
    if not (math.isfinite(x) and math.isfinite(y)):
        return operation(x, y)  # exact: an infinity or NaN
    value = exact(Fraction(x), Fraction(y))
    if value == 0:
        return None
    result = finite_result(value, up)
    return math.copysign(result, 1 if value > 0 else -1)


def sub(x, y, up):
    result = directed(x, y, lambda a, b: a - b, lambda a, b: a - b, up)
    if result is not None:
        return result
    if x == 0 and y == 0 and math.copysign(1, x) != math.copysign(1, y):
        return x
    return 0.0 if up else -0.0


def mul(x, y, up):
    result = directed(x, y, lambda a, b: a * b, lambda a, b: a * b, up)
    return result if result is not None else x * y


def sub_down(x, y): return sub(x, y, False)
def sub_up(x, y): return sub(x, y, True)
def mul_down(x, y): return mul(x, y, False)
def mul_up(x, y): return mul(x, y, True)
def mul_nearest(x, y): return x * y
def mag(x): return 1.0 if x == 0 else abs(x)


def lowb(c_down, c_up, p, q):
    u = sub_down(p, q)
    return mul_down(c_up if u < 0 else c_down, u)


def uppb(c_down, c_up, p, q):
    u = sub_up(p, q)
    return mul_up(c_up if 0 < u else c_down, u)


def replay(text, model):
    """Evaluates the lines `; replay: name = function` on the model; True if `; shows:` is so."""
    names = {"isnan": math.isnan, "bits": bits}
    for name, function in re.findall(r"^; replay: (\w+) = (.*)$", text, re.M):
        function = eval(function, globals())
        arguments = function.__code__.co_varnames[:function.__code__.co_argcount]
        names[name] = function(*(model[argument] for argument in arguments))
        print(f"  {name} = {names[name].hex()}")
    return eval(re.search(r"^; shows: (.*)$", text, re.M).group(1), names)


def as_double(value):
    """A solver's (fp #b. #b........... #b...) or special value."""
    fields = re.fullmatch(r"\(fp #b([01]) #b([01]{11}) #b([01]{52})\)", value.strip())
    if fields:
        return struct.unpack(">d", int("".join(fields.groups()), 2).to_bytes(8, "big"))[0]
    special = re.fullmatch(r"\(_ ([+-]?)(zero|oo|NaN) 11 53\)", value.strip())
    magnitude = {"zero": 0.0, "oo": math.inf, "NaN": math.nan}[special.group(2)]
    return -magnitude if special.group(1) == "-" else magnitude


def solve(solver, text, constants):
    """In a process of its own, which the caller can stop: prints the result and the values."""
    if solver == "bitwuzla":
        import bitwuzla
        manager, options = bitwuzla.TermManager(), bitwuzla.Options()
        options.set(bitwuzla.Option.PRODUCE_MODELS, True)
        parser = bitwuzla.Parser(manager, options)
        parser.parse(text, True, False)
        engine = parser.bitwuzla()
        result = str(engine.check_sat()).lower()
        result = result.split(".")[-1]
        value = lambda name: str(engine.get_value(parser.parse_term(name)))
    else:
        import cvc5
        engine = cvc5.Solver()
        engine.setOption("produce-models", "true")
        engine.setLogic("QF_FP")
        parser = cvc5.InputParser(engine)
        parser.setStringInput(cvc5.InputLanguage.SMT_LIB_2_6, text, "statement")
        symbols = parser.getSymbolManager()
        while not (command := parser.nextCommand()).isNull():
            command.invoke(engine, symbols)
        answer = engine.checkSat()
        result = "sat" if answer.isSat() else "unsat" if answer.isUnsat() else "unknown"
        declared = {str(term): term for term in symbols.getDeclaredTerms()}
        value = lambda name: str(engine.getValue(declared[name]))
    print("result", result)
    if result == "sat":
        for name in constants:
            print("value", name, value(name))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("solver", choices=SOLVERS)
    parser.add_argument("file", type=Path)
    parser.add_argument("--seconds", type=int, default=120)
    parser.add_argument("--passed", type=Path, help="where it is kept what has passed")
    parser.add_argument("--python", help="the interpreter that has the solvers, if this one has not")
    parser.add_argument("--solve", action="store_true", help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    text = arguments.file.read_text()
    expected = re.search(r"^; expected: (sat|unsat)$", text, re.M).group(1)
    constants = re.findall(r"\(declare-const (\w+) F\)", text)
    if arguments.solve:
        solve(arguments.solver, PRELUDE.read_text() + text, constants)
        return 0
    try:
        __import__(arguments.solver)
    except ImportError:
        other = arguments.python
        if other and os.path.exists(other) and os.path.abspath(sys.executable) != os.path.abspath(other):
            sys.stdout.flush()
            os.execv(other, [other] + sys.argv)
        print(f"skipped: {arguments.solver} is not installed (proofs/smt/requirements.txt)")
        return 77
    print("\n".join(line for line in text.splitlines() if re.match("; (?!replay|shows)", line)))
    version = importlib.metadata.version(arguments.solver)
    key = hashlib.sha256((PRELUDE.read_text() + text + Path(__file__).read_text()).encode()).hexdigest()
    stamp = arguments.passed and arguments.passed / f"{arguments.file.stem}.{arguments.solver}"
    if stamp and stamp.exists() and stamp.read_text() == f"{version} {key}":
        print(f"{arguments.solver} {version}: {expected}, as of an earlier run; nothing has changed since")
        return 0
    foretold = re.search(rf"^; undecided: .*\b{arguments.solver}\b", text, re.M) is not None
    if foretold:
        arguments.seconds = min(arguments.seconds, 5)
    started = time.monotonic()
    try:
        done = subprocess.run([sys.executable, __file__, arguments.solver, arguments.file, "--solve"],
                              text=True, capture_output=True, timeout=10 * arguments.seconds,
                              # Seconds of the processor: a busy machine changes no verdict.
                              preexec_fn=lambda: resource.setrlimit(
                                  resource.RLIMIT_CPU, (arguments.seconds, arguments.seconds)))
        if done.returncode < 0:
            raise subprocess.TimeoutExpired(done.args, arguments.seconds)
    except subprocess.TimeoutExpired:
        print(f"{arguments.solver}: unknown, nothing after {arguments.seconds} s: not proved")
        return 77 if foretold else 1
    seconds = time.monotonic() - started
    result = re.search(r"^result (\w+)$", done.stdout, re.M)
    if done.returncode or not result:
        print(done.stdout + done.stderr)
        return 1
    result = result.group(1)
    print(f"{arguments.solver}: {result} after {seconds:.1f} s")
    if result != expected:
        print(f"expected {expected}: {'not proved' if result == 'unknown' else 'WRONG'}")
        return 1
    if result == "sat":
        model = {name: as_double(value)
                 for name, value in re.findall(r"^value (\w+) (.*)$", done.stdout, re.M)}
        for name, value in model.items():
            print(f"  {name} = {value.hex()}")
        if not replay(text, model):
            print("the model does not show it in exact arithmetic")
            return 1
    if stamp:
        stamp.parent.mkdir(parents=True, exist_ok=True)
        stamp.write_text(f"{version} {key}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
