"""The figures of a report, each as data first (the rows of its .csv), then drawn from these by matplotlib.

A figure serves two readers. For a paper it is a file of its own, in the light colours: .pdf with embedded fonts,
.svg with its texts as text. On the page the same SVG is inlined: there its colours become the variables of
style.css, so that it follows light and dark, and its font the page's. Systems have colours, markers and, beyond ten,
dashes by their place in the experiment, so that one looks the same in all figures; the ten colours differ in
brightness as well as in hue, and the markers tell lines apart without any colour.
"""
import csv
import io
import math
import re
import warnings
import xml.etree.ElementTree as ET
from contextlib import contextmanager
from dataclasses import dataclass

from words import HOSTILE, decade_text, exponent_text, percent, power_of_ten, shown

# Colours as (light, dark): the page's variables --page, --ink, --muted, --rule, --s0, ...
GROUND = ("#ffffff", "#14171b")
INK, MUTED, RULE = ("#1b2026", "#e7eaee"), ("#5a6470", "#9ba5b1"), ("#d9dee4", "#333b44")
SERIES = (("#0067b1", "#5db1f0"), ("#cc4e00", "#ff8f4a"), ("#9a7000", "#e2b534"), ("#00805b", "#3fc49a"),
          ("#b0528f", "#e58cc4"), ("#3f97c4", "#a3d6f4"), ("#7a5c3e", "#c4a384"), ("#6b7280", "#a3abb8"),
          ("#8a1c4a", "#e0739f"), ("#2f8580", "#74cdc6"))
VARIABLES = {"page": GROUND, "ink": INK, "muted": MUTED, "rule": RULE}
VARIABLES |= {f"s{i}": colours for i, colours in enumerate(SERIES)}
MARKERS = "osv^D"  # filled, then empty
DASHES = ("-", "--", "-.")
SHORT_TITLE = 20  # characters that fit a column's head and a legend
LONGEST_NAME = 30

STYLE = {
    "svg.fonttype": "none", "svg.hashsalt": "report", "pdf.fonttype": 42, "text.parse_math": False,
    "font.family": "DejaVu Sans", "font.size": 9, "axes.titlesize": 9, "axes.labelsize": 8.5, "legend.fontsize": 8.5,
    "xtick.labelsize": 8.5, "ytick.labelsize": 8.5, "text.color": INK[0], "axes.titlecolor": INK[0],
    "axes.labelcolor": MUTED[0], "xtick.color": MUTED[0], "ytick.color": MUTED[0], "axes.edgecolor": MUTED[0],
    "axes.linewidth": 0.7, "axes.facecolor": "none", "axes.axisbelow": True, "axes.grid": True, "axes.grid.axis": "y",
    "grid.color": RULE[0], "grid.linewidth": 0.6, "axes.spines.top": False, "axes.spines.right": False,
    "axes.spines.left": False, "axes.titlelocation": "left", "ytick.major.size": 0, "xtick.major.size": 3,
    "xtick.major.width": 0.7, "lines.linewidth": 1.2, "lines.markersize": 3.6, "legend.frameon": False,
    "legend.handlelength": 2.2, "legend.borderaxespad": 0}


def label(experiment, system):
    """The title if it is short, else the name: what tables and figures call the system."""
    info = experiment.system[system]
    return info["title"] if info["title"] and len(info["title"]) <= SHORT_TITLE else info["name"]


def clean(text):
    """With a mark instead of characters that XML has not or that nobody should meet on a page."""
    return re.sub(f"(?![\t\n])[{HOSTILE}]", "\ufffd", text)


@dataclass
class Figure:
    name: str         # of its files, without the ending
    title: str
    description: str  # also for those who cannot see it
    columns: tuple    # of its data
    records: list     # one per point or bar
    draw: object      # a function of a matplotlib Figure

    def csv(self):
        out = io.StringIO()
        writer = csv.writer(out, lineterminator="\n")
        writer.writerow(self.columns)
        for record in self.records:
            writer.writerow([shown(cell) if isinstance(cell, str) else cell for cell in record])
        return out.getvalue()


# Parts of drawings.

def _painted(experiment, system, ours, size=1.0):
    """How the line of a system looks."""
    place = experiment.place[system]
    colour = SERIES[place % len(SERIES)][0]
    return {"color": colour, "marker": MARKERS[place % len(MARKERS)],
            "markerfacecolor": GROUND[0] if place % len(SERIES) >= len(MARKERS) else colour,
            "linestyle": DASHES[place // len(SERIES) % len(DASHES)], "linewidth": size * (2.2 if ours else 1.2),
            "markersize": size * (4.4 if ours else 3.6), "clip_on": False}


def _shown(text):
    """For a place with little room."""
    text = " ".join(clean(text).split())
    return text if len(text) <= LONGEST_NAME else text[:LONGEST_NAME - 1] + "…"


def _inches(texts):
    """Room for texts at the size of a legend: letters are about 0.6 times as wide as high."""
    return 0.08 + 0.6 * 8.5 / 72 * max(map(len, texts), default=0)


def _legend(figure, lines, names, left, top, columns=1):
    """Names are set afterwards: matplotlib leaves out those that begin with `_`."""
    legend = figure.legend(list(lines), ["M" * max(map(len, names))] * len(names), loc="upper left", ncol=columns,
                           bbox_to_anchor=(left, top), columnspacing=1.2)
    for text, name in zip(legend.get_texts(), names):
        text.set_text(name)


def decades(values):
    """Exponents of an axis of whole decades around the values, and those of its ticks."""
    low, high = math.floor(math.log10(min(values))), math.ceil(math.log10(max(values)))
    high = max(high, low + 1)
    return low, high, range(low, high + 1, 1 + (high - low) // 7)


def _logarithmic(axes, which, values):
    """Makes the axis `x` or `y` one of whole decades around the values."""
    low, high, ticks = decades(values)
    getattr(axes, f"set_{which}scale")("log")
    axis = getattr(axes, f"{which}axis")
    axis.set_ticks([10.0 ** e for e in ticks], [decade_text(e) for e in ticks])
    axis.set_ticks([], minor=True)
    getattr(axes, f"set_{which}lim")(10.0 ** low, 10.0 ** high)


# Failures against the distance to degeneracy.

RATE_COLUMNS = ("family", "system", "distance", "k", "runs", "judged", "failures", "failure_rate",
                "failure_rate_low", "failure_rate_high")


def _rate_records(study):
    """The distance is 10^-k of the operands' size, and 0 for operands in the degenerate position."""
    def places(k):
        return ("0", "exact") if k is None else ("1" if k == 0 else f"1e-{k}", k)
    return [(study.family or "all", curve.system, *places(p.k), p.tally.runs, p.tally.judged, p.tally.failures,
             p.tally.failure_rate, *p.tally.failure_interval) for curve in study.curves for p in curve.points]


def _draw_rates(axes, experiment, ours, records, most_ticks, size=1.0):
    """Systems stand beside each other at each distance, so that all are seen, each with the interval of its rate. Ours
    comes first, below the others: its line is the widest. `exact` stands apart from the line."""
    lines, systems = {}, list(dict.fromkeys(record[1] for record in records))
    last = max((record[3] for record in records if record[3] != "exact"), default=0)
    exact_place = last + 1 + math.ceil(last / 5)
    ticks = range(0, last + 1, math.ceil((last + 1) / most_ticks))
    for place, system in enumerate(systems):
        look = _painted(experiment, system, system == ours, size)
        aside = 0.7 * ((place + 0.5) / len(systems) - 0.5)
        own = [record for record in records if record[1] == system]
        points = [(aside + (exact_place if record[3] == "exact" else record[3]), record[7]) for record in own]
        joined = [point for point, record in zip(points, own) if record[3] != "exact"]
        lines[system] = axes.plot([x for x, _ in joined], [y for _, y in joined], **look)[0]
        if len(joined) < len(points):
            axes.plot(*points[-1], **look | {"linestyle": "none"})
        axes.vlines([x for x, _ in points], [record[8] for record in own], [record[9] for record in own],
                    colors=look["color"], linewidth=0.8 * size, alpha=0.6)
    exact = [exact_place] if any(record[3] == "exact" for record in records) else []
    axes.set_xlim(-0.6, (exact_place if exact else last) + 0.8)
    axes.set_ylim(0, 1.02)
    axes.set_xticks([*ticks, *exact], [*(power_of_ten(-k) for k in ticks), *("exact" for _ in exact)])
    axes.set_yticks([0, 0.25, 0.5, 0.75, 1], [percent(part) for part in (0, 0.25, 0.5, 0.75, 1)])
    return lines


def _distance_means(experiment, families):
    said = {experiment.family[family]["distance_means"] or "distance" for family in families}
    return said.pop() if len(said) == 1 else "10⁻ᵏ of each experiment"


def _all_rates(experiment, ours, study):
    records = _rate_records(study)

    def draw(figure):
        names = [_shown(label(experiment, curve.system)) for curve in study.curves]
        width, height, side = 8.0, 3.4, 0.5 + _inches(names)
        figure.set_size_inches(width, height)
        axes = figure.add_axes([0.72 / width, 0.5 / height, 1 - (0.85 + side) / width, 1 - 0.6 / height])
        lines = _draw_rates(axes, experiment, ours, records, 9)
        axes.set_xlabel(_distance_means(experiment, {row["family"] for row in experiment.rows if row["has_distance"]}))
        axes.set_ylabel("part of the runs that fail")
        _legend(figure, lines.values(), names, 1 - side / width, 1 - 0.1 / height)

    return Figure("failures", "Failures near degeneracy",
                  "Failure rate against distance to degeneracy, all families with a distance, a line per system, with "
                  "Wilson's intervals of 95 %",
                  RATE_COLUMNS, records, draw)


def _family_rates(experiment, ours, studies):
    """Families beside each other, with one legend."""
    records = [record for study in studies for record in _rate_records(study)]

    def draw(figure):
        shown = {record[1] for record in records}
        systems = [name for name in experiment.system if name in shown]
        names = [_shown(label(experiment, system)) for system in systems]
        across, cell = 3, 1.85
        columns = max(1, int(7.5 / (0.7 + _inches(names))))  # of the legend
        head = 0.15 + 0.19 * math.ceil(len(names) / columns)
        width, height = 8.0, head + cell * math.ceil(len(studies) / across) + 0.25
        figure.set_size_inches(width, height)
        handles = {}
        for place, study in enumerate(studies):
            row, column = divmod(place, across)
            axes = figure.add_axes([(0.55 + column * 2.5) / width, 1 - (head + (row + 1) * cell - 0.35) / height,
                                    2.25 / width, (cell - 0.7) / height])
            own = [record for record in records if record[0] == study.family]
            handles |= _draw_rates(axes, experiment, ours, own, 4, 0.75)
            axes.set_title(_shown(study.family))
            axes.tick_params(axis="y", labelleft=column == 0)
        _legend(figure, [handles[system] for system in systems], names, 0.5 / width, 1 - 0.05 / height, columns)
        figure.text(0.5, 0.05 / height, _distance_means(experiment, [study.family for study in studies]), ha="center",
                    va="bottom", color=MUTED[0], size=8.5)

    return Figure("failures-by-family", "Failures near degeneracy by family",
                  "Failure rate against distance to degeneracy in " + ", ".join(study.family for study in studies)
                  + ", a line per system", RATE_COLUMNS, records, draw)


# Time and memory against size.

def growth_figure(experiment, ours, study, what, cost, unit, unit_name):
    records, lines = [], {}
    for curve in study.curves:
        law = getattr(curve, what)
        for point in curve.points:
            if point.place > 0 and getattr(point, cost) > 0:
                value = getattr(point, cost) / unit
                quartiles = [y / unit for y in getattr(point, cost + "_quartiles")]
                records.append((study.family, curve.system, point.size, point.triangles, value, *quartiles, point.runs,
                                point.right, *((law.exponent, law.error) if law else ("", ""))))
                lines.setdefault(curve.system, []).append((point.place, value))
    if not records:
        return None
    laws = {curve.system: getattr(curve, what) for curve in study.curves}
    info = experiment.family[study.family]
    against = info["size_means"] if info["growth"] == "size" else "triangles of all operands"

    def draw(figure):
        systems = sorted(lines, key=lambda system: -lines[system][-1][1])  # as the ends of the lines
        names = [_shown(label(experiment, s)) + (f" {exponent_text(laws[s].exponent)} ± {exponent_text(laws[s].error)}" if laws[s] else "")
                 for s in systems]
        side = 0.5 + _inches(names)
        width, height = 3.2 + side, 2.7
        figure.set_size_inches(width, height)
        axes = figure.add_axes([0.68 / width, 0.5 / height, 1 - (0.8 + side) / width, 1 - 0.8 / height])
        handles = {system: axes.plot(*zip(*lines[system]), **_painted(experiment, system, system == ours))[0]
                   for system in lines}
        for system in lines:
            own = [record for record in records if record[1] == system]
            axes.vlines([x for x, _ in lines[system]], [r[5] for r in own], [r[6] for r in own], linewidth=0.8, alpha=0.6,
                        colors=_painted(experiment, system, False)["color"])
        _logarithmic(axes, "x", [x for line in lines.values() for x, _ in line])
        _logarithmic(axes, "y", [y for record in records for y in record[4:7] if y > 0])
        axes.set_title(_shown(study.family))
        axes.set_xlabel(_shown(against))
        axes.set_ylabel(f"{what}, {unit_name}")
        _legend(figure, [handles[system] for system in systems], names, 1 - side / width, 1 - 0.3 / height)

    return Figure(f"{what}-{study.family}", f"{what} against size: {study.family}",
                  f"Medians of {what} ({unit_name}) of {study.family} against {against}, with quartiles, a "
                  "line per system; numbers beside the names are fitted exponents with their standard errors",
                  ("family", "system", "size", "triangles", unit_name.replace("MB", "megabytes"), "lower_quartile",
                   "upper_quartile", "runs", "right",
                   "exponent", "standard_error"), records, draw)


# Time and memory as multiples of ours.

def _ratios(experiment, ratios, what):
    spreads = [(ratio.system, getattr(ratio, what)) for ratio in ratios if getattr(ratio, what).count]
    records = [(system, s.count, s.least, s.lower, s.median, s.upper, s.most) for system, s in spreads]
    if not records:
        return None

    def draw(figure):
        names = [_shown(label(experiment, record[0])) for record in records]
        side = 0.1 + _inches(names)
        width, height = 3.4 + side, 0.85 + 0.3 * len(records)
        figure.set_size_inches(width, height)
        axes = figure.add_axes([side / width, 0.48 / height, 1 - (side + 0.25) / width, 1 - 0.8 / height])
        axes.grid(False)
        axes.grid(True, axis="x")
        for place, (system, _, least, lower, median, upper, most) in enumerate(records):
            colour = SERIES[experiment.place[system] % len(SERIES)][0]
            y = len(records) - 1 - place
            axes.plot([least, most], [y, y], color=colour, linewidth=1.1, clip_on=False)
            axes.fill_between([lower, upper], y - 0.26, y + 0.26, facecolor=colour, alpha=0.35)
            axes.plot([lower, upper, upper, lower, lower],
                      [y - 0.26, y - 0.26, y + 0.26, y + 0.26, y - 0.26], color=colour, linewidth=1)
            axes.plot([median, median], [y - 0.26, y + 0.26], color=colour, linewidth=2.4, solid_capstyle="butt")
        axes.axvline(1, color=INK[0], linewidth=1)
        _logarithmic(axes, "x", [1, *(r[2] for r in records), *(r[6] for r in records)])
        axes.set_ylim(-0.6, len(records) - 0.4)
        axes.set_yticks(range(len(records)), names[::-1])
        for text, record in zip(axes.get_yticklabels(), reversed(records)):
            text.set_color(SERIES[experiment.place[record[0]] % len(SERIES)][0])
        axes.set_title(f"{what} as a multiple of ours")
        axes.set_xlabel("least, quartiles, median and most")

    return Figure(f"{what}-ratios", f"{what} as a multiple of ours",
                  f"{what} as a multiple of ours: least, quartiles, median and most, a bar per system; ours is 1",
                  ("system", "count", "min", "lower_quartile", "median", "upper_quartile", "max"), records, draw)


@dataclass
class Figures:
    """By the place on the page; None or missing where there is nothing to draw."""
    rates: Figure
    family_rates: Figure
    growth: dict  # (time, memory) by family
    ratios: list

    def all(self):
        found = [self.rates, self.family_rates, *(figure for pair in self.growth.values() for figure in pair),
                 *self.ratios]
        return [figure for figure in found if figure]


def figures_of(experiment, summary):
    ours = summary.ours
    rates = _all_rates(experiment, ours, summary.all_distances) if summary.all_distances.curves else None
    families = _family_rates(experiment, ours, summary.distances) if len(summary.distances) > 1 else None
    growth = {study.family: (growth_figure(experiment, ours, study, "time", "seconds", 1, "seconds"),
                             growth_figure(experiment, ours, study, "memory", "own_bytes", 1e6, "MB"))
              for study in summary.growth}
    figures = Figures(rates, families, growth, [_ratios(experiment, summary.ratios, what)
                                                for what in ("time", "memory")])
    names = set()
    for figure in figures.all():  # families may be called anything
        figure.name = stem = re.sub("[^A-Za-z0-9_-]+", "-", figure.name)
        number = 1
        while figure.name in names:
            number += 1
            figure.name = f"{stem}-{number}"
        names.add(figure.name)
    return figures


# Drawn.

SVG = "http://www.w3.org/2000/svg"
LINK = "{http://www.w3.org/1999/xlink}href"
NOT_SAID = {"svg": ("Date", "Creator", "Format", "Type"), "pdf": ("CreationDate", "Creator", "Producer")}
PAPER = "paper"  # the id of what is behind a figure: white in a file, nothing on the page


@contextmanager
def styled():
    """In here matplotlib is as it comes, whatever the user has set, but for the style above."""
    import matplotlib

    with matplotlib.rc_context(), warnings.catch_warnings():
        matplotlib.rcdefaults()
        matplotlib.rcParams.update(STYLE)
        warnings.simplefilter("ignore")  # of letters that the font has not
        yield


def drawn(figure, form, commit=""):
    """Its bytes as `svg` or `pdf`: the same whenever they are made. `commit` is that of the rows, which the file says
    of itself."""
    with styled():
        from matplotlib.figure import Figure as Canvas

        said = clean(figure.description) + (f". Rows of commit {clean(commit)}" if commit else "")
        words_of = {"svg": {"Title": clean(figure.title), "Description": said},
                    "pdf": {"Title": clean(figure.title), "Subject": said}}
        canvas, out = Canvas(), io.BytesIO()
        canvas.patch.set_gid(PAPER)
        figure.draw(canvas)
        canvas.savefig(out, format=form, metadata=dict.fromkeys(NOT_SAID[form]) | words_of[form])
    return out.getvalue()


def _without(element, gone):
    """The children of an element without those that are gone, and without groups that group nothing."""
    kept = []
    for child in element:
        if gone(child):
            continue
        child[:] = _without(child, gone)
        if child.tag == f"{{{SVG}}}g" and not child.attrib:
            kept += list(child)
        else:
            kept.append(child)
    return kept


def for_page(svg, figure):
    """The `svg` element alone, with the page's colours and font, and ids that begin with the figure's name."""
    ET.register_namespace("", SVG)
    root = ET.fromstring(svg)
    names = {name: f"{{{SVG}}}{name}" for name in ("metadata", "clipPath", "style", "title", "use")}
    root[:] = [child for child in root if child.tag != names["title"]]
    variable = {light: f"var(--{name})" for name, (light, _) in VARIABLES.items()}
    prefix = figure.name + "-"
    used = {element.get(LINK) for element in root.iter(names["use"])}
    paper = root.find(f".//*[@id='{PAPER}']")
    for element in root.iter():
        element.attrib.pop("clip-path", None)
        style = element.get("style")
        if style:
            style = re.sub("#[0-9a-f]{6}", lambda colour: variable.get(colour[0], colour[0]), style)
            element.set("style", re.sub(r"font: ([0-9.]+px) [^;]*", r"font-size: \1", style))
        name = element.attrib.pop("id", None)
        if name and "#" + name in used:
            element.set("id", prefix + name)
        link = element.attrib.pop(LINK, None)
        if link:
            element.set("href", "#" + prefix + link[1:])
    root[:] = _without(root, lambda child: child is paper or child.tag in names.values() and child.tag != names["use"])
    for attribute in ("width", "height", "version"):
        root.attrib.pop(attribute, None)
    root.set("role", "img")
    root.set("aria-labelledby", prefix + "title")
    title = ET.Element(names["title"], id=prefix + "title")
    title.text = clean(figure.description)
    root.insert(0, title)
    return re.sub(r"\s*\n\s*", "\n", ET.tostring(root, encoding="unicode"))
