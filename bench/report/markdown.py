"""The report as Markdown, for where repositories are read: the same blocks as page's, figures as files beside it."""
import html
import re

from report import page


def figure_file(section, number):
    """Of a section's figure, from 1."""
    return f"{section}-{number}.svg"


def inline(words):
    """A cell or caption in one line of Markdown; a red cross stays, and is bold."""
    text = str(words) if isinstance(words, page.Raw) else html.escape(str(words), quote=False)
    text = re.sub(r'<span class="bad">(.*?)</span>', r"<b>\1</b>", text, flags=re.S)
    text = re.sub(r"</?(span|div|small)[^>]*>", "", text)
    return re.sub(r"\s+", " ", text).replace("|", "\\|").replace("*", "\\*").replace("_", "\\_").strip()


def table(block):
    heads = [inline(head) or " " for head in block["heads"]]
    rows = [[inline(cell) for cell in row] for row in block["rows"]]
    lines = [heads, ["---"] * len(heads), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def section(name, title, entry, blocks, numbering):
    parts = [f"## {title}", page.state_text(entry), page.missing_text(entry.get("missing"))]
    drawn = 0
    for block in blocks:
        if block["kind"] == "text":
            parts.append(page.element(block["html"]))
        elif block["kind"] == "heading":
            parts.append(f"### {block['text']}")
        elif block["kind"] == "table":
            numbering.tables += 1
            parts += [f"**Table {numbering.tables}.** {inline(block['caption'])}", table(block)]
        else:
            numbering.figures += 1
            drawn += bool(block["svg"])
            picture = f"![Figure {numbering.figures}]({figure_file(name, drawn)})" if block["svg"] else "(Not drawn.)"
            parts += [picture, f"**Figure {numbering.figures}.** {inline(block['caption'])}"]
    return "\n\n".join(filter(None, parts))


def document(report, shown):
    """The report's text. `shown`: [(name, title, entry, blocks, sentences)], in order."""
    head, numbering = report["head"], page.Numbering()
    quick = " A quick run: fewer repetitions and smaller sizes than the full one." if head["quick"] else ""
    sentences = "\n".join(f"- {inline(words)}" for *_, all_words in shown for words in all_words)
    about = table({"heads": ["", ""], "rows": page.head_rows(head)})
    return "\n\n".join(filter(None, [
        "# graze-report: speed against error, beside what people use now",
        f"Written by `{head['command']}`; all numbers are in [report.json](report.json), the page for a browser is "
        f"index.html. Each result is judged by an exact or a multiple-precision oracle.{quick}", sentences,
        *(section(name, title, entry, blocks, numbering) for name, title, entry, blocks, _ in shown),
        "## Where and how this was measured", about])) + "\n"
