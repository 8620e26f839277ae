"""The one style of the report's figures: matplotlib to SVG, for a white card of 900 pixels.

A library, method or path has one colour and one marker on every figure (`look`). What is wrong
(unsound, missed) is marked by a red cross. Zeros on a logarithmic axis stand on a line of their own below
its numbers, infinities at its upper end.
"""
import functools
import io
import itertools
import math
import re

try:
    import matplotlib
    matplotlib.use("svg")
    from matplotlib import figure as matplotlib_figure, ticker
    from matplotlib.backends.backend_agg import FigureCanvasAgg
except ModuleNotFoundError:
    matplotlib = None

# by the beginning of a name, the longest that fits: colour and marker; graze's are blue
LOOKS = {
    "graze": ("#0b5fa5", "o"), "graze scalar": ("#0b5fa5", "o"), "graze 8-wide": ("#00a3d7", "D"),
    "certified": ("#0b5fa5", "o"), "descent": ("#00a3d7", "D"), "exact": ("#123a63", "p"), "sound": ("#0b5fa5", "o"),
    "avx512": ("#0b5fa5", "o"), "avx2": ("#00a3d7", "D"), "baseline": ("#6f8fd8", "s"), "scalar": ("#123a63", "p"),
    "boost": ("#d55e00", "s"), "mpfi": ("#8c564b", "^"), "cgal": ("#009e73", "v"), "arb": ("#b0579a", "P"),
    "flint": ("#b0579a", "P"), "inari": ("#c99700", "h"), "double": ("#808080", "."),
    "published": ("#d55e00", "s"), "plain": ("#a65628", "<"), "gargantini": ("#8c564b", "^"),
    "revelles": ("#b0579a", ">"), "amanatides": ("#c99700", "h"), "slab": ("#7a7a00", "P"), "pcl": ("#5b8c00", "8"),
    "octomap": ("#e377c2", "*"), "openvdb": ("#ff7f0e", "H"), "nanovdb": ("#c45b00", "d"), "embree": ("#505050", "X"),
    "pov": ("#009e73", "v"), "fidget": ("#b0579a", "P"), "certified hits": ("#002b55", "H"),
    "descent avx512": ("#0b5fa5", "o"), "descent avx2": ("#00a3d7", "D"), "descent baseline": ("#6f8fd8", "s"),
    "descent upward": ("#5a6b80", "p"),
}
SPARE = ["#3f6b2a", "#7b4fa0", "#a31f50", "#4c7f8c", "#8a6d00", "#555555"]
WRONG = "#d00000"
STYLE = {
    "font.family": "DejaVu Sans", "font.size": 10, "axes.titlesize": 11, "axes.labelsize": 10.5,
    "axes.spines.top": False, "axes.spines.right": False, "axes.edgecolor": "#555", "axes.grid": True,
    "grid.color": "#dcdfe4", "grid.linewidth": 0.7, "axes.axisbelow": True, "legend.frameon": False,
    "legend.fontsize": 9.5, "svg.fonttype": "path", "svg.hashsalt": "graze", "text.color": "#1c1e21",
    "axes.labelcolor": "#1c1e21", "xtick.color": "#333", "ytick.color": "#333", "lines.linewidth": 1.8,
    "figure.facecolor": "white", "axes.facecolor": "white", "axes.titlelocation": "left",
}


class NotDrawn(Exception):
    """matplotlib is not here."""


def look(library):
    """(colour, marker) of a library, method or path."""
    name = str(library).lower()
    fits = [key for key in LOOKS if name.startswith(key)]
    if fits:
        return LOOKS[max(fits, key=len)]
    code = sum(ord(c) * (k + 1) for k, c in enumerate(name))
    return SPARE[code % len(SPARE)], "sPv^hd"[code // 7 % 6]


def colour(library):
    return look(library)[0]


def new(width=900, height=480, rows=1, columns=1, **options):
    """A figure of width x height pixels and its axes (an array where there are several)."""
    if matplotlib is None:
        raise NotDrawn("python3-matplotlib is missing: this section's figures cannot be drawn")
    with matplotlib.rc_context(STYLE):
        fig = matplotlib_figure.Figure(figsize=(width / 100, height / 100), dpi=100, layout="constrained")
        return fig, fig.subplots(rows, columns, **options)


def finish(fig):
    """The figure as SVG to be put into a page. Its description names the axes."""
    labels = [(ax.get_title(loc="left") or ax.get_title(), ax.get_xlabel(), ax.get_ylabel()) for ax in fig.axes]
    description = "; ".join(f"{title}: {y} against {x}".strip(": ") for title, x, y in labels if x and y)
    if not description:
        raise ValueError("a figure whose axes have no labels")
    with matplotlib.rc_context(STYLE):
        file = io.StringIO()
        fig.savefig(file, format="svg", metadata={"Date": None, "Creator": None})
    svg = file.getvalue()
    svg = svg[svg.index("<svg"):]
    svg = re.sub(r"<metadata>.*?</metadata>\s*", "", svg, flags=re.S)
    svg = re.sub(r"<!--.*?-->\s*", "", svg, flags=re.S)
    svg = re.sub(r'<g id="[a-zA-Z0-9_. ]+"', "<g", svg)
    svg = re.sub(r"(\d+\.\d\d\d)\d+", r"\1", svg)
    description = description.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
    return re.sub(r"(<svg[^>]*)>", rf'\1 role="img">\n<desc>{description}</desc>', svg, count=1)


def drawn(draw):
    """A kind of figure: empty, not an error, where matplotlib is not here."""
    @functools.wraps(draw)
    def kind(*arguments, **options):
        if matplotlib is None:
            return ""
        with matplotlib.rc_context(STYLE):
            return draw(*arguments, **options)
    return kind


def axis_scale(ax, axis, values, log):
    """Linear from 0, or logarithmic; zeros have a place at the axis's lower end. Returns the place of infinities."""
    finite = [v for v in values if v is not None and math.isfinite(v)]
    positive = [v for v in finite if v > 0]
    scale = ax.set_xscale if axis == "x" else ax.set_yscale
    limits = ax.set_xlim if axis == "x" else ax.set_ylim
    if not log or not positive:
        top = max(finite, default=1) * 1.08 or 1
        limits(min(0, min(finite, default=0)), top)
        return top
    low, high = min(positive), max(positive)
    infinite = len(finite) < len([v for v in values if v is not None])
    margin = max(1.25, (high / low) ** 0.06)
    top = high * margin * (margin if infinite else 1)
    if min(finite) <= 0:
        decade = 10.0 ** math.floor(math.log10(low))
        scale("symlog", linthresh=decade, linscale=0.5)
        limits(-0.25 * decade, top)
        which = ax.xaxis if axis == "x" else ax.yaxis
        which.set_major_locator(ticker.SymmetricalLogLocator(base=10, linthresh=decade))
    else:
        scale("log")
        limits(low / margin, top)
    number_axis(ax.xaxis if axis == "x" else ax.yaxis, low, high)
    return top


def number_axis(axis, low, high):
    """Plain numbers where there are few decades, powers of ten elsewhere."""
    if 1e-3 <= low and high < 1e5:
        axis.set_major_formatter(ticker.FuncFormatter(lambda v, _: f"{v:g}"))
        if high / low < 100:
            axis.set_minor_formatter(ticker.FuncFormatter(few_minor))
        else:
            axis.set_minor_formatter(ticker.NullFormatter())


def ticks_at(ax, ticks):
    """Ticks {value: label} where they are few."""
    if 0 < len(ticks) <= 10:
        ax.set_xticks(list(ticks), ticks.values())
        ax.set_xticks([], minor=True)


def few_minor(value, _):
    """2 and 5 of a decade."""
    lead = value / 10 ** math.floor(math.log10(value)) if value > 0 else 0
    return f"{value:g}" if round(lead) in (2, 5) else ""


def bars_of(points, axis):
    """Lengths of error bars below and above; none where a point has none."""
    low = [p[axis] - p[f"{axis}_low"] if p.get(f"{axis}_low") is not None else 0 for p in points]
    high = [p[f"{axis}_high"] - p[axis] if p.get(f"{axis}_high") is not None else 0 for p in points]
    return [[max(0, v) for v in low], [max(0, v) for v in high]] if any(low) or any(high) else None


def draw_scatter(ax, points, x_label, y_label, title="", log_x=True, log_y=True, marked_label="wrong", texts=True):
    """Points on axes that may be one panel of several; see scatter."""
    top = {axis: axis_scale(ax, axis, [p.get(k) for p in points for k in (axis, f"{axis}_low", f"{axis}_high")], log)
           for axis, log in (("x", log_x), ("y", log_y))}
    placed = [{**p, **{a: top[a] if math.isinf(p[a]) else p[a] for a in "xy"}} for p in points]
    for library in dict.fromkeys(p["library"] for p in placed):
        own = [p for p in placed if p["library"] == library]
        shade, marker = look(library)
        ax.errorbar([p["x"] for p in own], [p["y"] for p in own], xerr=bars_of(own, "x"), yerr=bars_of(own, "y"),
                    fmt=marker, color=shade, markersize=7, elinewidth=1.2, label=library, linestyle="none",
                    markeredgecolor="white", markeredgewidth=0.6, clip_on=False, zorder=3)
    marked = [p for p in placed if p.get("marked")]
    if marked:
        ax.plot([p["x"] for p in marked], [p["y"] for p in marked], "x", color=WRONG, markersize=12,
                markeredgewidth=2, linestyle="none", label=marked_label, clip_on=False, zorder=4)
    ax.set_xlabel(x_label)
    ax.set_ylabel(y_label)
    ax.set_title(title)
    ax.graze_points = [(p["x"], p["y"]) for p in placed]
    if texts:
        ax.graze_texts = [(p["x"], p["y"], p["text"], colour(p["library"])) for p in placed if p.get("text")]


def place_texts(fig):
    """Writes the points' texts where they hide neither each other nor a point."""
    for ax in fig.axes:
        items = getattr(ax, "graze_texts", [])
        if not items:
            continue
        canvas = FigureCanvasAgg(fig)
        canvas.draw()
        renderer = canvas.get_renderer()
        spots = [ax.transData.transform((x, y)) for x, y, _, _ in items]
        points = [ax.transData.transform(p) for p in ax.graze_points]
        taken = [(x - 5, y - 5, x + 5, y + 5) for x, y in points]
        frame = ax.get_window_extent(renderer)
        for (x, y, words, shade), (px, py) in zip(items, spots):
            best = None
            for distance, (side, up) in itertools.product((8, 16, 28, 42), ((1, 0), (-1, 0), (0, 1), (0, -1), (1, 1),
                                                                             (-1, 1), (1, -1), (-1, -1))):
                note = ax.annotate(words, (x, y), xytext=(side * distance, up * distance), textcoords="offset pixels",
                                   fontsize=8.5, color=shade, va="center" if not up else "bottom" if up > 0 else "top",
                                   ha="center" if not side else "left" if side > 0 else "right")
                note.set_in_layout(False)
                box = note.get_window_extent(renderer)
                place = (box.x0 - 1, box.y0 - 1, box.x1 + 1, box.y1 + 1)
                cost = sum(overlap(place, other) for other in taken) + 10 * outside(place, frame) + distance
                if best is None or cost < best[0]:
                    if best:
                        best[1].remove()
                    best = (cost, note, place)
                else:
                    note.remove()
            taken.append(best[2])


def overlap(a, b):
    """Of two rectangles (left, low, right, high), the area."""
    return max(0, min(a[2], b[2]) - max(a[0], b[0])) * max(0, min(a[3], b[3]) - max(a[1], b[1]))


def outside(box, frame):
    """By how many pixels a rectangle leaves the axes."""
    return sum(max(0, v) for v in (frame.x0 - box[0], box[2] - frame.x1, frame.y0 - box[1],
                                   box[3] - frame.y1 - 20))


def legend_of(fig):
    """One legend right of the first row's last panel, each name once."""
    names = {}
    for ax in fig.axes:
        for handle, name in zip(*ax.get_legend_handles_labels()):
            names.setdefault(name, handle)
    if len(names) > 1:
        names = dict(sorted(names.items(), key=lambda item: getattr(item[1], "get_marker", str)() == "x"))
        ax = [ax for ax in fig.axes if ax.get_subplotspec().is_first_row()][-1]
        ax.legend(names.values(), names.keys(), loc="upper left", bbox_to_anchor=(1.01, 1), borderaxespad=0)


@drawn
def scatter(points, x_label, y_label, title="", log_x=True, log_y=True, marked_label="wrong", width=900, height=500):
    """Points dict(library, x, y, x_low=, x_high=, y_low=, y_high=, marked=False, text=""), bars for quartiles."""
    fig, ax = new(width, height)
    draw_scatter(ax, points, x_label, y_label, title, log_x, log_y, marked_label)
    legend_of(fig)
    place_texts(fig)
    return finish(fig)


def draw_lines(ax, series, x_label, y_label, title="", log_x=False, log_y=False, x_ticks=None):
    """Series on axes that may be one panel of several; see lines."""
    every = {a: [v for s in series for k in (a, f"{a}_low", f"{a}_high") for v in s.get(k) or []] for a in "xy"}
    if log_x:
        axis_scale(ax, "x", every["x"], True)
    ticks_at(ax, x_ticks or ({v: f"{v:g}" for v in sorted(set(every["x"]))} if log_x else {}))
    axis_scale(ax, "y", every["y"], log_y)
    for s in series:
        shade, marker = look(s["library"])
        name = s.get("label", s["library"])
        dashed = s.get("dashed", False)
        ax.plot(s["x"], s["y"], color=s.get("colour", shade), marker="" if dashed else s.get("marker", marker),
                markersize=5, linestyle=":" if dashed else "-", label=name)
        if s.get("y_low"):
            ax.fill_between(s["x"], s["y_low"], s["y_high"], color=s.get("colour", shade), alpha=0.18, linewidth=0)
        if s.get("marked"):
            at = [k for k, wrong in enumerate(s["marked"]) if wrong]
            ax.plot([s["x"][k] for k in at], [s["y"][k] for k in at], "x", color=WRONG, markersize=11,
                    markeredgewidth=2, label=s.get("marked_label", "wrong"))
    ax.set_xlabel(x_label)
    ax.set_ylabel(y_label)
    ax.set_title(title)


@drawn
def lines(series, x_label, y_label, title="", log_x=False, log_y=False, x_ticks=None, width=900, height=440):
    """Series dict(library, x, y, label=, colour=, marker=, y_low=, y_high=, dashed=False, marked=[...]); bands are
    quartiles. x_ticks: {value: label}."""
    fig, ax = new(width, height)
    draw_lines(ax, series, x_label, y_label, title, log_x, log_y, x_ticks)
    legend_of(fig)
    return finish(fig)


@drawn
def line_panels(panels, width=900, height=400):
    """Several of `lines` side by side: [dict(series, x_label, y_label, title=, log_x=, log_y=)]; a panel has a legend
    where a name of it was in no panel before."""
    fig, axes = new(width, height, 1, len(panels), squeeze=False)
    named = set()
    for ax, panel in zip(axes[0], panels):
        draw_lines(ax, **panel)
        names = set(ax.get_legend_handles_labels()[1])
        if len(names) > 1 and not names <= named:
            ax.legend(loc="best")
        named |= names
    return finish(fig)


@drawn
def scatter_panels(panels, columns=2, width=900, row_height=360):
    """Several of `scatter` in a grid with one legend: [dict(points, x_label, y_label, title=, ...)]."""
    rows = math.ceil(len(panels) / columns)
    fig, axes = new(width, rows * row_height, rows, columns, squeeze=False)
    for ax, panel in itertools.zip_longest(axes.flat, panels):
        if panel is None:
            ax.remove()
        else:
            draw_scatter(ax, **panel)
    legend_of(fig)
    place_texts(fig)
    return finish(fig)


@drawn
def bars(groups, y_label, x_label="", title="", log_y=False, width=900, height=440):
    """Groups [dict(name, bars=[dict(library, y, y_low=, y_high=, marked=False)])], a library one colour."""
    fig, ax = new(width, height)
    axis_scale(ax, "y", [v for g in groups for b in g["bars"] for v in (b["y"], b.get("y_high"))], log_y)
    libraries = list(dict.fromkeys(b["library"] for g in groups for b in g["bars"]))
    wide = min(0.82 / len(libraries), 0.4)
    for k, library in enumerate(libraries):
        bars_at = [(at, b) for at, g in enumerate(groups) for b in g["bars"] if b["library"] == library]
        xs = [at + (k - (len(libraries) - 1) / 2) * wide for at, _ in bars_at]
        all_bars = [b for _, b in bars_at]
        ax.bar(xs, [b["y"] for b in all_bars], wide * 0.92, color=colour(library), label=library,
               yerr=bars_of(all_bars, "y"), error_kw={"elinewidth": 1, "ecolor": "#333"})
        wrong = [(x, b["y"]) for x, b in zip(xs, all_bars) if b.get("marked")]
        if wrong:
            ax.plot(*zip(*wrong), "x", color=WRONG, markersize=11, markeredgewidth=2, linestyle="none", label="wrong")
    ax.set_xticks(range(len(groups)), [g["name"] for g in groups])
    ax.grid(axis="x", visible=False)
    ax.set_xlabel(x_label or title or " ")
    ax.set_ylabel(y_label)
    ax.set_title(title)
    legend_of(fig)
    return finish(fig)
