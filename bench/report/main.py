"""graze-report: measures graze beside its peers on the same work, and writes a page with figures.

usage: bench/graze-report [options]

  --quick               two minutes: smaller sizes and fewer repetitions (the full run: half an hour)
  --only SECTION[,...]  only these: intervals, traversals, images, hard_intervals, hard_rays, growth
  --out DIR             where index.html, README.md, report.json and the figures, SECTION-NUMBER.svg, are
                        written (default: out/report)
  --from FILE           draws the page again from a report.json, without measuring
  --core N              the core that measurements are pinned to (default: 0)
  --json                the last line is a JSON object: page, report, states of the sections, summary
  --no-install          measures with what is installed; what is missing is named on the page
  --help                this text

The first run installs what is missing (root or sudo, Debian 12) and builds. report.json is written
after every section; Ctrl-C loses nothing of the sections before it, and their page is written.

Exit codes: 0 done; 1 a section failed, or the page could not be written; 2 bad input; 130 interrupted.

Examples:
  bench/graze-report --quick
  bench/graze-report --only intervals,growth --out /tmp/report
  bench/graze-report --from docs/report/report.json --out /tmp/again
"""
# A section is a module of report/sections with NAME, TITLE, TARGETS (CMake targets), measure(context),
# which returns data for JSON, show(data), which returns page's blocks and reads nothing else, and,
# if it likes, summary(data), sentences for the page's top.
import argparse
import importlib
import json
import os
import pathlib
import shutil
import signal
import sys
import time
import traceback

HERE = pathlib.Path(__file__).resolve().parent
if __name__ == "__main__":  # the package's statistics must not hide the standard library's
    sys.path[0] = str(HERE.parent)

from report import context as contexts, figures, markdown, page  # noqa: E402

# name: seconds of a full and of a quick run, for the time that is left
SECTIONS = {"intervals": (500, 10), "traversals": (300, 20), "images": (820, 18), "hard_intervals": (1, 1),
            "hard_rays": (15, 3), "growth": (280, 35)}


class BadInput(Exception):
    """One line for who called."""


class Parser(argparse.ArgumentParser):
    def error(self, message):
        raise BadInput(message)


def options(arguments, names):
    parser = Parser(add_help=False, allow_abbrev=False)
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--only")
    parser.add_argument("--out", default=str(contexts.ROOT / "out" / "report"))
    parser.add_argument("--from", dest="source")
    parser.add_argument("--core", type=int, default=0)
    parser.add_argument("--json", action="store_true")
    parser.add_argument("--targets", action="store_true")  # prints what must be built
    parser.add_argument("--no-install", action="store_true")  # bench/graze-report has obeyed it
    parser.add_argument("--help", "-h", action="store_true")
    given = parser.parse_args(arguments)
    given.only = given.only.split(",") if given.only is not None else list(names)
    unknown = [name for name in given.only if name not in names]
    if unknown:
        raise BadInput(f"no section {unknown[0]!r}; there are {', '.join(names)}")
    given.only = [name for name in names if name in given.only]
    if given.core not in os.sched_getaffinity(0):
        raise BadInput(f"no core {given.core} here")
    return given


def load(name):
    """The section's module, or the one-line reason why there is none."""
    try:
        return importlib.import_module(f"report.sections.{name}")
    except Exception as error:  # a section's fault is its own
        return one_line(error)


def sections_here():
    return {name: load(name) for name in SECTIONS if (HERE / "sections" / f"{name}.py").exists()}


def one_line(error):
    return " ".join(f"{'' if isinstance(error, contexts.MeasurementFailed) else type(error).__name__ + ': '}"
                    f"{error}".split())[:400]


def write(path, text):
    """Whole or not at all."""
    new = path.with_name(path.name + ".new")
    with open(new, "w", encoding="utf-8") as file:
        file.write(text)
        file.flush()
        os.fsync(file.fileno())
    os.replace(new, path)


def clock(seconds):
    return f"{int(seconds) // 60}:{int(seconds) % 60:02}"


class Progress:
    """Lines to stderr: time since the start, time that is left by the sections' budgets, the section."""

    def __init__(self, names, quick):
        self.start, self.names = time.monotonic(), names
        self.budget = {name: SECTIONS.get(name, (60, 10))[1 if quick else 0] for name in names}
        self.now, self.began, self.done = None, self.start, set()

    def begin(self, name):
        self.now, self.began = name, time.monotonic()
        self("begins")

    def end(self, words):
        self.done.add(self.now)
        self(words)

    def left(self):
        rest = sum(self.budget[name] for name in self.names if name not in self.done and name != self.now)
        remaining = 0 if self.now in self.done else self.budget.get(self.now, 0) - (time.monotonic() - self.began)
        return rest + max(0, remaining)

    def __call__(self, words):
        print(f"[{clock(time.monotonic() - self.start)}, about {clock(self.left())} left] {self.now}: {words}",
              file=sys.stderr, flush=True)


class Interrupts:
    """SIGINT and SIGTERM raise KeyboardInterrupt within `with`, and are remembered elsewhere."""

    def __init__(self):
        self.seen = self.within = False
        for number in (signal.SIGINT, signal.SIGTERM):
            signal.signal(number, self.handle)

    def handle(self, _number, _frame):
        self.seen = True
        if self.within:
            self.within = False
            raise KeyboardInterrupt

    def __enter__(self):
        self.within = True
        if self.seen:
            raise KeyboardInterrupt

    def __exit__(self, *_):
        self.within = False


def measure(given, modules, report, keep):
    """Measures section after section; `keep` writes the report. Returns whether it was interrupted."""
    interrupts, progress = Interrupts(), Progress(given.only, given.quick)
    for name in given.only:
        if interrupts.seen:
            return True
        module, entry = modules[name], report["sections"][name]
        context = contexts.Context(given.out, given.quick, given.core, progress)
        began = time.monotonic()
        progress.begin(name)
        try:
            with interrupts:
                if isinstance(module, str):
                    raise contexts.MeasurementFailed(module)
                entry["data"] = json.loads(json.dumps(module.measure(context)))
                entry["state"] = "done"
        except KeyboardInterrupt:
            entry["state"] = "interrupted"
        except Exception as error:  # the others go on
            entry.update(state="failed", error=one_line(error))
            if not isinstance(error, contexts.MeasurementFailed):
                traceback.print_exc()
        finally:
            shutil.rmtree(context.scratch, ignore_errors=True)
        entry["seconds"] = round(time.monotonic() - began, 1)
        entry["missing"] = context.missing_peers
        keep()
        progress.end(entry["state"] + (f": {entry['error']}" if "error" in entry else ""))
    return interrupts.seen


def shown(report, modules):
    """[(name, title, entry, blocks, sentences)] for the page; a fault in showing is the section's failure."""
    result = []
    for name, entry in report["sections"].items():
        module, blocks, sentences = modules.get(name), [], []
        if entry["state"] == "done":
            try:
                if module is None or isinstance(module, str):
                    raise contexts.MeasurementFailed(module or "there is no such section")
                blocks = module.show(entry["data"])
                sentences = module.summary(entry["data"]) if hasattr(module, "summary") else []
            except figures.NotDrawn as error:
                entry = {**entry, "state": "failed", "error": str(error)}
            except Exception as error:
                traceback.print_exc()
                entry = {**entry, "state": "failed", "error": f"the page of it: {one_line(error)}"}
        result.append((name, entry["title"], entry, blocks, sentences))
    return result


def read(path):
    try:
        report = json.loads(pathlib.Path(path).read_text(encoding="utf-8"))
    except OSError as error:
        raise BadInput(f"{path}: {error.strerror}") from error
    except ValueError as error:
        raise BadInput(f"{path}: {one_line(error)}") from error
    if not isinstance(report, dict) or report.get("graze-report") != 1:
        raise BadInput(f"{path}: is no report of graze-report")
    return report


def new_report(given, arguments, modules):
    titles = {name: getattr(modules[name], "TITLE", name) for name in given.only}
    entries = {name: {"title": titles[name], "state": "waiting"} for name in given.only}
    return {"graze-report": 1, "head": contexts.head(arguments, given.quick, given.core), "sections": entries}


def finish(given, report, modules, out):
    """Writes the page; tells of it on stdout. Returns whether every section is there."""
    all_shown = shown(report, modules)
    write(out / "index.html", page.page_html(report, all_shown))
    for name, _, _, blocks, _ in all_shown:
        drawn = [block["svg"] for block in blocks if block["kind"] == "figure" and block["svg"]]
        for number, svg in enumerate(drawn, 1):
            write(out / markdown.figure_file(name, number), svg)
    write(out / "README.md", markdown.document(report, all_shown))
    states = {name: entry["state"] for name, _, entry, _, _ in all_shown}
    sentences = [words for *_, all_words in all_shown for words in all_words]
    if given.json:
        print(json.dumps({"page": str(out / "index.html"), "report": str(out / "report.json"), "sections": states,
                          "summary": sentences}))
    else:
        print("\n".join([*sentences, *(f"{name}: {state}" for name, state in states.items() if state != "done"),
                         str(out / "index.html")]))
    return all(state == "done" for state in states.values())


def make_report(arguments, modules):
    given = options(arguments, modules)
    if given.help:
        print(__doc__.strip())
        return 0
    if given.targets:
        wanted = [] if given.source else [modules[n] for n in given.only if not isinstance(modules[n], str)]
        print("\n".join(dict.fromkeys(target for module in wanted for target in module.TARGETS)))
        return 0
    out = pathlib.Path(given.out)
    report = read(given.source) if given.source else None
    try:
        out.mkdir(parents=True, exist_ok=True)
        interrupted = False
        if report is None:
            report = new_report(given, arguments, modules)
            interrupted = measure(given, modules, report,
                                  lambda: write(out / "report.json", json.dumps(report, indent=1)))
        else:
            report["sections"] = {n: e for n, e in report["sections"].items() if n in given.only}
        whole = finish(given, report, modules, out)
    except OSError as error:
        print(f"graze-report: {error.filename or given.out}: {error.strerror}", file=sys.stderr)
        return 1
    return 130 if interrupted else 0 if whole else 1


def main(arguments, modules=None):
    try:
        return make_report(arguments, sections_here() if modules is None else modules)
    except BadInput as error:
        print(f"graze-report: {error}", file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
