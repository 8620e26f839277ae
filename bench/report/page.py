"""Blocks of the report and the page that is made of them: one HTML file that needs nothing else."""
import html
import re

STYLE = """
:root { --ink: #1c1e21; --faint: #5c6370; --paper: #fcfcfd; --card: #fff; --line: #d7dae0; --strong: #0b5fa5;
        --bad: #b3261e; --shade: #f1f3f6; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e4e6ea; --faint: #a2a9b4; --paper: #16181c; --card: #1f2228; --line: #3a3f48; --strong: #7cb8f0;
          --bad: #ff8a80; --shade: #23272e; } }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 1.5rem 1rem 4rem; max-width: 960px; background: var(--paper); color: var(--ink);
       font: 16px/1.5 system-ui, "DejaVu Sans", sans-serif; }
h1 { font-size: 1.7rem; line-height: 1.2; margin: 0 0 .5rem; }
h2 { font-size: 1.35rem; margin: 2.8rem 0 .6rem; padding-top: .8rem; border-top: 2px solid var(--line); }
h3 { font-size: 1.1rem; margin: 1.8rem 0 .4rem; }
a { color: var(--strong); }
code { font: .88em ui-monospace, "DejaVu Sans Mono", monospace; background: var(--shade); padding: .05em .3em;
       border-radius: 3px; overflow-wrap: anywhere; }
.faint { color: var(--faint); font-size: .9rem; }
.bad { color: var(--bad); font-weight: 600; }
.failed { border-left: 4px solid var(--bad); padding: .4rem .8rem; background: var(--shade); }
nav li { margin: .1rem 0; }
.summary li { margin: .35rem 0; }
figure { margin: 1.2rem 0 1.8rem; }
.card { background: #fff; border: 1px solid var(--line); border-radius: 6px; padding: 8px; }
.card svg { display: block; width: 100%; height: auto; }
figcaption { color: var(--faint); font-size: .92rem; margin-top: .5rem; }
figcaption.above { margin: 0 0 .4rem; }
figcaption b { color: var(--ink); }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-size: .88rem; font-variant-numeric: tabular-nums; min-width: 50%; }
th, td { padding: .3rem .65rem; border-bottom: 1px solid var(--line); text-align: left; vertical-align: top; }
th { border-bottom: 2px solid var(--line); vertical-align: bottom; }
td.number, th.number { text-align: right; white-space: nowrap; }
tbody tr:nth-child(even) { background: var(--shade); }
@media print {
  body { max-width: none; font-size: 11pt; } figure, tr { break-inside: avoid; } h2 { break-before: page; }
  nav, .wide { overflow: visible; } }
"""
NUMBER = re.compile(r"[-+−<>≤≥~±]?\s?[\d.∞][^a-zA-Z]{0,24}(\s?\w{1,5}(/\w+)?)?$|-$|inf$")


class Raw(str):
    """HTML that is taken as it is where a table's cell or a caption would be escaped."""


def bad(words):
    """A cell or word that tells of a wrong result."""
    return Raw(f'<span class="bad">✗ {escape(words)}</span>')


def escape(words):
    return words if isinstance(words, Raw) else Raw(html.escape(str(words)))


def text(words):
    """A paragraph, or several elements, of HTML."""
    return {"kind": "text", "html": words}


def heading(words):
    """A heading below the section's own."""
    return {"kind": "heading", "text": words}


def table(heads, rows, caption):
    """Cells are escaped (Raw is not); columns of numbers are set to the right."""
    return {"kind": "table", "heads": list(heads), "rows": [list(row) for row in rows], "caption": caption}


def figure(svg, caption):
    """An SVG of figures.py, and what to read from it."""
    if not caption:
        raise ValueError("a figure without a caption")
    return {"kind": "figure", "svg": svg, "caption": caption}


def is_number(cell):
    return bool(NUMBER.match(re.sub(r"<[^>]*>", "", str(cell)).strip()))


class Numbering:
    """Figures and tables are counted through the page."""

    def __init__(self):
        self.figures = self.tables = 0


def element(words):
    return words if words.lstrip().startswith("<") else f"<p>{words}</p>"


def table_html(block, number):
    rows = block["rows"]
    columns = range(len(block["heads"]))
    numeric = [bool(rows) and sum(is_number(r[k]) for r in rows if k < len(r)) * 2 > len(rows) for k in columns]

    def cell(tag, k, words):
        kind = ' class="number"' if k < len(numeric) and numeric[k] else ""
        return f"<{tag}{kind}>{escape(words)}</{tag}>"

    heads = "".join(cell("th", k, words) for k, words in enumerate(block["heads"]))
    body = "\n".join("<tr>" + "".join(cell("td", k, words) for k, words in enumerate(row)) + "</tr>" for row in rows)
    return (f'<figure id="table-{number}"><figcaption class="above"><b>Table {number}.</b> {escape(block["caption"])}'
            f'</figcaption>\n<div class="wide"><table><thead><tr>{heads}</tr></thead>\n<tbody>\n{body}\n</tbody>'
            "</table></div></figure>")


def block_html(block, numbering):
    if block["kind"] == "text":
        return element(block["html"])
    if block["kind"] == "heading":
        return f"<h3>{escape(block['text'])}</h3>"
    if block["kind"] == "table":
        numbering.tables += 1
        return table_html(block, numbering.tables)
    numbering.figures += 1
    picture = block["svg"] or "<p>(Not drawn: python3-matplotlib is missing.)</p>"
    return (f'<figure id="figure-{numbering.figures}"><div class="card">{picture}</div>\n<figcaption>'
            f"<b>Figure {numbering.figures}.</b> {escape(block['caption'])}</figcaption></figure>")


def missing_text(missing):
    """Which peers were not there."""
    if not missing:
        return ""
    items = "; ".join(f"<b>{escape(m['name'])}</b> ({escape(m['package'])}"
                      + (f": {escape(m['why'])}" if m.get("why") else "") + ")" for m in missing)
    return f'<p class="failed">Missing here, and so not measured: {items}.</p>'


def state_text(entry):
    """Of a section that has nothing to show."""
    words = {"failed": f"This section failed: {entry.get('error', '')}",
             "interrupted": "This section was interrupted before it had measured everything.",
             "waiting": "This section was not measured: the run ended before it."}.get(entry["state"])
    return f'<p class="failed">{escape(words)}</p>' if words else ""


def head_rows(head):
    machine = head["machine"]
    commit = head["commit"][:12] + {True: " and changes that are not committed", False: "", None: ""}[head["dirty"]]
    memory = f", {machine['memory_bytes'] / 2**30:.0f} GiB" if machine.get("memory_bytes") else ""
    peers = ", ".join(f"{name} {version}" for name, version in head["packages"].items() if version)
    absent = ", ".join(name for name, version in head["packages"].items() if not version)
    rows = [("processor", f"{machine['processor']}, {machine['cores']} cores{memory}"),
            ("system", f"{machine['system']}, kernel {machine['kernel']}; frequency governor: {machine['governor']}; "
                       f"load at the start: {machine['load']}"),
            ("compiler", f"{head['compiler']}; {head['build_type']}, {head['flags']}"),
            ("commit", commit), ("measured", f"{head['date']}{', --quick' if head['quick'] else ''}, pinned to core "
                                             f"{head['core']}"),
            ("packages", peers)]
    if absent:
        rows.append(("not installed", absent))
    if head.get("cargo"):
        rows.append(("cargo", head["cargo"]))
    return rows


def page_html(report, shown):
    """The page of a report. `shown`: [(name, title, entry, blocks, sentences)], in order."""
    head, numbering = report["head"], Numbering()
    contents = "\n".join(f'<li><a href="#{name}">{escape(title)}</a>'
                         + ("" if entry["state"] == "done" else f' <span class="bad">{entry["state"]}</span>') + "</li>"
                         for name, title, entry, _, _ in shown)
    sentences = "\n".join(f"<li>{escape(words)}</li>" for *_, all_words in shown for words in all_words)
    about = "\n".join(f"<tr><th>{key}</th><td>{escape(value)}</td></tr>" for key, value in head_rows(head))
    parts = []
    for name, title, entry, blocks, _ in shown:
        took = f'<p class="faint">Measured in {entry["seconds"]:.0f} s.</p>' if entry.get("seconds") else ""
        parts.append("\n".join([f'<section id="{name}">', f"<h2>{escape(title)}</h2>", state_text(entry),
                                missing_text(entry.get("missing")), *(block_html(b, numbering) for b in blocks), took,
                                "</section>"]))
    quick = " This was a quick run: fewer repetitions and smaller sizes than the full one." if head["quick"] else ""
    summary = f'<h2 id="summary">Summary</h2>\n<ul class="summary">\n{sentences}\n</ul>' if sentences else ""
    return f"""<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>graze-report</title>
<style>{STYLE}</style>
</head>
<body>
<h1>graze-report: speed against error, beside what people use now</h1>
<p>Graze and its peers on the same work in one run, each result judged by an exact or a multiple-precision oracle.
Times are medians; bars and bands are quartiles.{quick} Repeated by <code>{escape(head['command'])}</code>; all
numbers of this page are in <code>report.json</code> beside it.</p>
<nav><b>Contents</b>
<ul>
{contents}
<li><a href="#measured-on">Where and how this was measured</a></li>
</ul></nav>
{summary}
{chr(10).join(parts)}
<h2 id="measured-on">Where and how this was measured</h2>
<div class="wide"><table><tbody>
{about}
</tbody></table></div>
</body>
</html>
"""
