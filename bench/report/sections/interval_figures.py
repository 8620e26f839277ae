"""Scatters of time against excess width, with a band for an excess of 0."""
import math

from report import figures
from report.sections.interval_libraries import group, is_held, name

LEAST, MOST = 1e-4, 1e20  # excesses on the axis, in ulps
ROOM = 190  # pixels of the overview above the band
BOTTOM = math.log10(LEAST) - 0.35  # below it is the band


class Band:
    """The places of excesses on an axis of decades, with a band of zeros of some height below them."""

    def __init__(self, decades):
        self.decades = decades

    def place(self, excess, lane=0.5):
        """0 is in the band, at `lane` of 0 to 1."""
        if excess <= 0:
            return BOTTOM - self.decades * (1 - lane)
        return math.log10(min(max(excess, LEAST), MOST))

    def draw(self, ax, top, labels=True, step=3):
        """The axis up to `top`, with a number every `step` decades."""
        ax.set_ylim(BOTTOM - self.decades, top)
        ax.axhspan(BOTTOM - self.decades, BOTTOM, color="#e8f0e4", zorder=0, linewidth=0)
        decades = [d for d in range(-3 if step == 3 else 0, 21, step) if d < top]
        text = {-3: "0.001", 0: "1", 3: "1000"}
        ax.set_yticks([BOTTOM - self.decades / 2, *decades],
                      ["0", *(text.get(d, f"$10^{{{d}}}$") for d in decades)] if labels else [])


def lanes(groups):
    """A line within the band for each library."""
    return {g: (k + 0.5) / len(groups) for k, g in enumerate(reversed(groups))}


def draw_point(ax, x, y, library, marked, worst=None, label=None, size=6):
    """A library's place; a bar up to the worst; hollow if its caller holds a mode; crossed out if unsound."""
    shade, marker = figures.look(name(library))
    if worst is not None and worst > y:
        ax.plot([x, x], [y, worst], color=shade, linewidth=0.9, alpha=0.6)
        ax.plot([x], [worst], marker="_", color=shade, markersize=5, alpha=0.6)
    ax.plot([x], [y], marker=marker, color=shade, markersize=size, linestyle="none", label=label,
            markerfacecolor="white" if is_held(library) else shade, markeredgewidth=1.2)
    if marked:
        ax.plot([x], [y], marker="x", color=figures.WRONG, markersize=size + 3, markeredgewidth=1.6, linestyle="none")


def draw_panel(ax, results, operation, band, lane_of):
    """Returns the upper end of the axis."""
    top = 4
    for library in results.libraries:
        if not results.has(library, operation):
            continue
        v, lane = results.verdict(library, operation), lane_of[group(library)]
        mean, worst = (v[f"{k}_excess_ulps"] for k in ("mean", "worst"))
        y = band.place(mean, lane)
        high = band.place(worst) if mean > 0 else None
        draw_point(ax, results.time(library, operation)["ns"], y, library, results.unsound(library, operation) > 0,
                   high, size=5)
        top = max(top, (high or y) + 0.8)
    ax.set_xscale("log")
    ax.set_title(operation, fontsize=10)
    return top


@figures.drawn
def grid(results, operations, width=900):
    """An operation a panel, one legend below."""
    operations = [o for o in operations if any(results.has(x, o) for x in results.libraries)]
    columns = 4
    rows = math.ceil(len(operations) / columns)
    groups = list(dict.fromkeys(group(x) for x in results.libraries))
    fig, axes = figures.new(width, 250 * rows + 70, rows, columns, squeeze=False, sharex=True)
    band, lane_of = Band(11), lanes(groups)
    panels = list(zip(axes.flat, operations))
    top = max(draw_panel(ax, results, operation, band, lane_of) for ax, operation in panels)
    for k, (ax, _) in enumerate(panels):
        band.draw(ax, top, labels=k % columns == 0)
        ax.set_xlim(0.05, 2e4)
        ax.set_xticks([0.1, 1, 10, 100, 1000, 10000], ["0.1", "1", "10", "100", "1000", "$10^4$"])
        ax.tick_params(labelsize=8, labelbottom=True)
        ax.set_xticks([], minor=True)
        if k % columns == 0:
            ax.set_ylabel("mean excess, ulps", fontsize=9)
        if k >= len(panels) - columns:
            ax.set_xlabel("ns an operation", fontsize=9)
    for ax in axes.flat[len(panels):]:
        ax.remove()
    legend_below(fig, handles(groups), 60 / (250 * rows + 70), 5)
    return figures.finish(fig)


def legend_below(fig, entries, share, columns):
    """A legend in the lowest `share` of the figure."""
    fig.get_layout_engine().set(rect=(0, share, 1, 1 - share))
    fig.legend(handles=entries, loc="lower center", ncol=columns, fontsize=9)


def handles(groups):
    """Of the legend: a library each, then what hollow and crossed out mean."""
    from matplotlib.lines import Line2D
    found = [Line2D([], [], linestyle="none", color=figures.look(g)[0], marker=figures.look(g)[1], label=g)
             for g in groups]
    found.append(Line2D([], [], linestyle="none", color="#555", marker="o", markerfacecolor="white",
                        label="rounding mode held"))
    found.append(Line2D([], [], linestyle="none", color=figures.WRONG, marker="x", label="unsound results"))
    return found


def draw_overview(ax, title, points, band):
    """Points with their names: those without excess one below the other, by time."""
    tight = sorted((p for p in points if p["y"] == 0), key=lambda p: -p["x"])
    for k, p in enumerate(tight):
        p["place"] = band.place(0, (k + 0.5) / len(tight))
    before, lift = (0, 0), 0  # names of points that lie together stand above them, one above the other
    for p in sorted(points, key=lambda p: (p["y"] == 0, p["x"])):
        y = p.get("place", band.place(p["y"]))
        together = p["y"] > 0 and p["x"] < 3 * before[0] and abs(y - before[1]) < 1
        before, lift = (p["x"], y), lift + 11 if together else 11 if p["y"] > 0 else 0
        draw_point(ax, p["x"], y, p["library"], p["marked"], size=6)
        ax.annotate(name(p["library"]), (p["x"], y), xytext=(8, lift), textcoords="offset points", fontsize=8.5,
                    va="center", color=figures.look(name(p["library"]))[0])
    ax.set_xscale("log")
    low, high = min(p["x"] for p in points), max(p["x"] for p in points)
    ax.set_xlim(low / 1.6, high * (high / low) ** 0.45)
    ax.set_title(title, fontsize=9.5)
    ax.set_xlabel("time as a multiple of plain double's, geometric mean")
    ax.xaxis.set_major_formatter(figures.ticker.FuncFormatter(lambda v, _: f"{v:g}"))


@figures.drawn
def overview(panels, width=900):
    """[(title, points)] below each other, as high as they have names."""
    panels = [(title, points) for title, points in panels if points]
    tight = [sum(p["y"] == 0 for p in points) for _, points in panels]
    heights = [22 * n + ROOM for n in tight]  # a line for each that is tight, and room for the others
    fig, axes = figures.new(width, sum(heights) + 90 * len(panels) + 30, len(panels), 1, squeeze=False,
                            gridspec_kw={"height_ratios": heights})
    for ax, (title, points), n in zip(axes.flat, panels, tight):
        worst = max(p["y"] for p in points)
        top = max(2, math.log10(worst) + 4) if worst else 1
        band = Band((top - BOTTOM) * 22 * n / ROOM)
        draw_overview(ax, title, points, band)
        band.draw(ax, top, step=6 if top > 12 else 3)
        ax.set_ylabel("worst excess, ulps")
    legend_below(fig, handles([]), 30 / (sum(heights) + 90 * len(panels) + 30), 2)
    return figures.finish(fig)
