#!/usr/bin/env python3
"""usage: frame.py page|options|interrupt|failure|statistics|figures: one test of bench/report.

Exit code 0 passed, 1 failed, 77 skipped (python3-matplotlib is missing)."""
import contextlib
import html.parser
import io
import json
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import types

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "bench"))
from report import figures, main, page, statistics  # noqa: E402

RECORDED = pathlib.Path(__file__).with_name("growth.json")
VOID = {"meta", "br", "img", "hr", "path", "use", "rect"}
# a unit or that it is a number of something, behind a comma
UNIT = re.compile(r", (ns|ms|s|MiB|ulps|levels( of .*)?|number|times one thread)$")


class Page(html.parser.HTMLParser):
    """What is looked for in a page; tags must close in order."""

    def __init__(self):
        super().__init__()
        self.open, self.captions, self.axes, self.links, self.ids, self.fetched = [], [], [], [], set(), []
        self.below = False

    def handle_starttag(self, tag, attrs):
        attributes = dict(attrs)
        if tag not in VOID:
            self.open.append(tag)
        if tag == "figcaption":
            self.below = attributes.get("class") != "above"  # those of tables are above
            if self.below:
                self.captions.append("")
        if tag in ("script", "link", "img", "iframe"):
            self.fetched.append(tag)
        if tag == "a":
            self.links.append(attributes["href"])
        self.ids.add(attributes.get("id"))

    def handle_endtag(self, tag):
        if tag not in VOID:
            assert self.open and self.open[-1] == tag, f"</{tag}> closes {self.open[-1:]}"
            self.open.pop()

    def handle_data(self, data):
        if "figcaption" in self.open and self.below:
            self.captions[-1] += data
        if self.open[-1:] == ["desc"]:
            self.axes.append(data)


def run(arguments, modules=None):
    """Exit code, stdout and stderr of main."""
    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        code = main.main(arguments, modules)
    return code, out.getvalue(), err.getvalue()


def check(condition, words):
    if not condition:
        raise AssertionError(words)


def needs_matplotlib():
    if figures.matplotlib is None:
        print("python3-matplotlib is missing")
        sys.exit(77)


def test_page(folder):
    """The recorded measurements give a page that needs nothing else, each figure with axes, units and a caption."""
    needs_matplotlib()
    code, out, err = run(["--from", str(RECORDED), "--out", str(folder), "--json"])
    check(code == 0, err)
    result = json.loads(out)
    check(result["sections"] == {"growth": "done"} and result["summary"], out)
    text = (folder / "index.html").read_text()
    check(len(text) < 5e6, "the page is too large")
    read = Page()
    read.feed(text)
    read.close()
    check(not read.open, f"left open: {read.open}")
    check(not read.fetched, f"the page loads {read.fetched}")
    check(all(link.startswith("#") and link[1:] in read.ids for link in read.links), read.links)
    readme = (folder / "README.md").read_text()
    pictures = re.findall(r"!\[Figure \d+\]\(([^)]*)\)", readme)
    check(len(pictures) == len(read.axes), pictures)
    check(all((folder / name).read_text().startswith("<svg") for name in pictures), pictures)
    for row in re.findall(r"^\|.*\|$", readme, re.M):
        check("\n" not in row and "<span" not in row, row)
    check(len(read.captions) >= 5 and len(read.captions) == len(read.axes), f"{len(read.captions)} {len(read.axes)}")
    for caption in read.captions:
        check(len(caption) > 60 and "nan" not in caption.lower(), caption)
    for axes in read.axes:
        for labels in axes.split("; "):
            y, x = labels.split(": ")[-1].split(" against ")
            check(UNIT.search(x), f"no unit: {x}")
            check(UNIT.search(y), f"no unit: {y}")


def test_options(folder):
    """What is wrong is refused in one line, with exit code 2, and nothing is written."""
    broken = folder / "broken.json"
    broken.write_text("{")
    other = folder / "other.json"
    other.write_text("[]")
    for arguments in (["--only", "nosuch"], ["--only", ""], ["--core", "100000"], ["--core", "one"], ["--nosuch"],
                      ["--from", str(folder / "none.json")], ["--from", str(broken)], ["--from", str(other)]):
        code, out, err = run([*arguments, "--out", str(folder / "out")])
        check(code == 2 and out == "" and err.startswith("graze-report: ") and err.count("\n") == 1,
              f"{arguments}: {code} {out!r} {err!r}")
    check(not (folder / "out").exists(), "something was written")
    code, out, _ = run(["--help"])
    check(code == 0 and "Exit codes" in out, out)
    command = subprocess.run([ROOT / "bench" / "graze-report", "--only", "nosuch", "--no-install"],
                             stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    check(command.returncode == 2 and command.stderr.count("\n") == 1, command)


def stub(name, measure):
    return types.SimpleNamespace(NAME=name, TITLE=f"Section {name}", TARGETS=[], measure=measure,
                                 show=lambda data: [page.text(f"<p>{data['said']}</p>")])


def stubs():
    """A section that is done at once, one that waits for an interrupt, one behind it."""
    return {"first": stub("first", lambda context: {"said": "measured"}),
            "second": stub("second", lambda context: context.run(["sleep", "100000"])),
            "third": stub("third", lambda context: {"said": "never"})}


def test_interrupt(folder):
    """An interrupt leaves a valid report of what was measured and a page that says what is missing."""
    process = subprocess.Popen([sys.executable, __file__, "run-stubs", str(folder)], stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE, text=True)
    for line in process.stderr:
        if "second: begins" in line:
            break
    report = json.loads((folder / "report.json").read_text())
    check(report["sections"]["first"]["data"] == {"said": "measured"}, "not written after the first section")
    process.send_signal(signal.SIGINT)
    out, err = process.communicate()
    check(process.returncode == 130, f"{process.returncode} {err}")
    report = json.loads((folder / "report.json").read_text())
    states = {name: entry["state"] for name, entry in report["sections"].items()}
    check(states == {"first": "done", "second": "interrupted", "third": "waiting"}, states)
    text = (folder / "index.html").read_text()
    check("measured" in text and "was interrupted" in text and "was not measured" in text, text)
    check(not list(folder.glob("*.new")) and not (folder / "work").exists(), list(folder.iterdir()))


def test_failure(folder):
    """A section that fails is named with its line; the others go on, and a missing peer is said to be missing."""
    def fails(context):
        context.missing("Arb <2>", "libflint-arb-dev", "not installed")
        context.run(["bash", "-c", "echo no luck >&2; exit 3"])

    modules = {"bad": stub("bad", fails), "slow": stub("slow", lambda c: c.run(["sleep", "40"], timeout=0.2)),
               "odd": stub("odd", lambda c: {}["key"]), "broken": "No module named 'x'",
               "good": stub("good", lambda c: {"said": str(c.measured(["true"]).peak_bytes > 0)})}
    code, out, err = run(["--out", str(folder)], modules)
    check(code == 1, f"{code} {err}")
    sections = json.loads((folder / "report.json").read_text())["sections"]
    check(sections["bad"]["error"] == "bash ended with 3: no luck", sections["bad"])
    check(sections["slow"]["error"] == "sleep took longer than 0.2 s", sections["slow"])
    check(sections["slow"]["seconds"] < 30, "the time's end was not obeyed")
    check(sections["odd"]["error"] == "KeyError: 'key'", sections["odd"])
    check(sections["broken"]["error"] == "No module named 'x'", sections["broken"])
    check(sections["good"]["data"] == {"said": "True"}, sections["good"])
    text = (folder / "index.html").read_text()
    check("bash ended with 3: no luck" in text and "Arb &lt;2&gt;" in text and "<p>True</p>" in text, text)


def test_statistics(_folder):
    """Quartiles and fits of numbers whose answers are known."""
    check(statistics.spread([4, 1, 3, 2, 5]) == {"median": 3, "low": 2, "high": 4, "repetitions": 5}, "quartiles")
    fit = statistics.exponent([1, 2, 4, 8], [3 * n ** 1.5 for n in (1, 2, 4, 8)])
    check(abs(fit["exponent"] - 1.5) < 1e-12 and abs(fit["factor"] - 3) < 1e-12 and fit["error"] < 1e-9, fit)
    # slope 1/2, residuals -1/2, 1, -1/2, sum of squares 3/2, of the abscissas 2
    fit = statistics.line([0, 1, 2], [0, 2, 1])
    check(abs(fit["slope"] - 0.5) < 1e-12 and abs(fit["slope_error"] - 0.75 ** 0.5) < 1e-12, fit)
    check(statistics.line([0, 1], [0, 2])["slope_error"] is None, "two points have no error")


def test_figures(_folder):
    """Zeros, infinities and wrong results have their places; a figure without axes' labels is refused."""
    needs_matplotlib()
    points = [{"library": name, "x": x, "y": y, "marked": name == "MPFI", "text": name}
              for name, x, y in (("graze scalar", 2, 0), ("MPFI", 300, 0.5), ("Boost.Interval", 20, float("inf")))]
    svg = figures.scatter(points, "time, ns", "excess width, ulps", marked_label="unsound")
    check("<desc>excess width, ulps against time, ns</desc>" in svg and figures.WRONG in svg, svg[:400])
    check(re.search(r"\b(nan|inf)\b", svg) is None, "a coordinate is no number")
    check(figures.scatter(points, "time, ns", "excess width, ulps", marked_label="unsound") == svg, "not repeatable")
    for family in (["graze scalar", "graze 8-wide", "Boost", "MPFI", "CGAL", "FLINT/Arb", "inari", "double"],
                   ["sound", "exact", "published", "plain", "Gargantini", "Revelles", "Amanatides-Woo", "slabs", "PCL",
                    "OctoMap", "OpenVDB", "NanoVDB", "Embree", "CGAL"], ["certified", "descent", "POV-Ray"]):
        check(len({figures.look(name) for name in family}) == len(family), f"looks are alike: {family}")
    check(figures.look("CGAL Interval_nt") == figures.look("cgal"), "a library has one look")
    figure, _ = figures.new()
    try:
        figures.finish(figure)
    except ValueError:
        return
    raise AssertionError("axes without labels were accepted")


def start():
    if sys.argv[1] == "run-stubs":
        return main.main(["--out", sys.argv[2]], stubs())
    with tempfile.TemporaryDirectory() as folder:
        globals()[f"test_{sys.argv[1]}"](pathlib.Path(folder))
    return 0


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    sys.exit(start())
