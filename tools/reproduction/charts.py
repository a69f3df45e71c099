"""Charts of the reproduction page as plain SVG: no variables, no scripts, so that any viewer shows them alike.

A Panel is one set of axes; shapes are added in the units of its axes. `figure` sets panels side by side.
"""
import html
import math
import re

COLOUR = {"FM-1": "#c8500a", "FM-2": "#e69f00", "FM-3": "#0a5a94", "FM-4": "#4aa3d8", "FM-5": "#1b8a63",
          "unclear": "#8a8f96", "all": "#20242a", "paper": "#8a1f5c"}
INK, SOFT, HAIR, FAINT = "#20242a", "#636b75", "#e4e0d8", "#d5d0c6"
STYLE = (f"<style>text{{font:12px system-ui,'Segoe UI',Roboto,Helvetica,Arial,sans-serif;fill:{INK}}}"
         f".soft{{fill:{SOFT}}}.bold{{font-weight:600}}.grid{{stroke:{HAIR}}}.axis{{fill:none;stroke:{SOFT}}}"
         ".halo{paint-order:stroke;stroke:#fff;stroke-width:4px;stroke-linejoin:round}path{stroke-linejoin:round}</style>")


def colour_of(name):
    return COLOUR.get(name, COLOUR["all"])


def ticks(low, high, wanted):
    raw = (high - low) / wanted
    power = 10 ** math.floor(math.log10(raw))
    step = next(m * power for m in (1, 2, 5, 10) if m * power >= raw * 0.999)
    return [i * step for i in range(math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9) + 1)]


def padded(values, air=0.06):
    low, high = min(values), max(values)
    air = air * (high - low) or 0.5
    return low - air, high + air


class Panel:
    """Axes with a title; `names` instead of numbers along x (or y) make it a chart of categories 0, 1, 2 ..."""

    def __init__(self, title, x, y, x_title="", y_title="", names=None, rows=None, width=380, height=270, left=56, wanted=5):
        self.x = (-0.5, len(names) - 0.5) if names else x
        self.y = (len(rows) - 0.5, -0.5) if rows else y
        self.width, self.height = width, height
        self.left, self.right, self.top, self.bottom = left, width - 14, 30, height - 44
        self.out = []
        for value, words in (enumerate(names) if names else ((t, f"{t:.6g}") for t in ticks(*x, wanted))):
            at = self.at(value, 0)[0]
            if not names:
                self.out.append(f'<path class="grid" d="M{at:.1f} {self.top}V{self.bottom}"/>')
            self.text(at, self.bottom + 16, words, "soft" if not names else "", "middle")
        for value, words in (enumerate(rows) if rows else ((t, f"{t:.6g}") for t in ticks(*y, 5))):
            at = self.at(0, value)[1]
            self.out.append(f'<path class="grid" d="M{self.left} {at:.1f}H{self.right}"/>')
            self.text(self.left - 7, at + 4, words, "" if rows else "soft", "end")
        self.out.append(f'<path class="axis" d="M{self.left} {self.top}V{self.bottom}H{self.right}"/>')
        self.text((self.left + self.right) / 2, self.bottom + 35, x_title, "", "middle")
        middle = (self.top + self.bottom) / 2
        if y_title:
            turned = f'transform="rotate(-90 13 {middle:.0f})"'
            self.out.append(f'<text x="13" y="{middle:.0f}" text-anchor="middle" {turned}>{html.escape(y_title)}</text>')
        self.text(self.left, 18, title, "bold", "start")

    def at(self, x, y):
        return (self.left + (x - self.x[0]) / (self.x[1] - self.x[0]) * (self.right - self.left),
                self.bottom - (y - self.y[0]) / (self.y[1] - self.y[0]) * (self.bottom - self.top))

    def text(self, x, y, words, kind="", anchor="start", colour=None):
        if words:
            fill = f' style="fill:{colour}"' if colour else ""
            at = f'x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}"'
            self.out.append(f'<text class="{kind}" {at}{fill}>{html.escape(words)}</text>')

    def label(self, x, y, words, colour=INK, anchor="start", lift=0):
        px, py = self.at(x, y)
        self.text(px, py - lift, words, "halo", anchor, colour)

    def dot(self, x, y, colour, r=3, hollow=False):
        px, py = self.at(x, y)
        inside, edge, width = ("#fff", colour, 1.6) if hollow else (colour, "#fff", 0.6)
        paint = f'fill="{inside}" stroke="{edge}" stroke-width="{width}"'
        self.out.append(f'<circle cx="{px:.1f}" cy="{py:.1f}" r="{r}" {paint}/>')

    def line(self, points, colour, width=1.5, dash="", opacity=1, fill="none"):
        """A polyline in whole tenths of a pixel, as relative moves: short for hundreds of curves."""
        pixels = [tuple(round(10 * v) for v in self.at(*p)) for p in points]
        words = f"M{pixels[0][0] / 10:g} {pixels[0][1] / 10:g}l"
        words += " ".join(f"{(b[0] - a[0]) / 10:g} {(b[1] - a[1]) / 10:g}" for a, b in zip(pixels, pixels[1:]))
        paint = f'fill="{fill}" stroke="{colour}" stroke-width="{width}"' if fill == "none" else f'fill="{fill}"'
        paint += (f' stroke-dasharray="{dash}"' if dash else "") + (f' opacity="{opacity}"' if opacity != 1 else "")
        self.out.append(f'<path {paint} d="{words}"/>')

    def band(self, x, low, high, colour, opacity=0.15):
        self.line(list(zip(x, high)) + list(zip(reversed(x), reversed(low))), colour, fill=colour, opacity=opacity)

    def bar(self, x, width, height, colour):
        (x0, y0), (x1, y1) = self.at(x, 0), self.at(x + width, height)
        self.out.append(f'<path fill="{colour}" stroke="#fff" d="M{x0:.1f} {y0:.1f}V{y1:.1f}H{x1:.1f}V{y0:.1f}z"/>')

    def interval(self, x, low, high, colour, level=False):
        """A whisker along y at x; along x where level, `x` then being the row."""
        ends = [(low, x), (high, x)] if level else [(x, low), (x, high)]
        self.line(ends, colour, 1.6)

    def estimate(self, x, value, interval, colour, hollow=False, level=False):
        if interval and None not in interval:
            self.interval(x, *interval, colour, level)
        self.dot(*((value, x) if level else (x, value)), colour, 4, hollow)


def figure(panels, columns, key=()):
    """Panels of equal size in one standalone SVG; `key` names colours in a line above them."""
    width, height = panels[0].width, panels[0].height
    columns = min(columns, len(panels))
    top = 24 if key else 0
    w, h = width * columns, height * math.ceil(len(panels) / columns) + top
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {w} {h}" width="{w}" height="{h}">',
           STYLE, '<rect width="100%" height="100%" fill="#fff"/>']
    for i, name in enumerate(key):
        x = 60 + 70 * i
        out += [f'<circle cx="{x}" cy="12" r="4" fill="{colour_of(name)}"/>', f'<text x="{x + 9}" y="16">{name}</text>']
    for i, panel in enumerate(panels):
        out += [f'<g transform="translate({i % columns * width} {i // columns * height + top})">', *panel.out, "</g>"]
    return "\n".join(out) + "\n</svg>\n"


def moves(d):
    """A path of M, L, Z as relative moves in tenths; open pieces that touch are joined, and
    the letters l left out as SVG allows (a path that begins with m begins at that point)."""
    out, here, start = "", None, None
    for kind, x, y in re.findall(r"([MLZ])(?:(-?[\d.]+) (-?[\d.]+))?", d):
        if kind == "Z":
            out, here = out + "z", start
            continue
        point = round(10 * float(x)), round(10 * float(y))
        if kind == "M" and point == here and not out.endswith("z"):
            continue
        step = point if here is None else (point[0] - here[0], point[1] - here[1])
        out += ("m" if kind == "M" else " ") + f"{step[0] / 10:g} {step[1] / 10:g}"
        start, here = point if kind == "M" else start, point
    return re.sub(r"(\.\d) \.", r"\1.", re.sub(r" -", "-", re.sub(r"(?<!\d)0\.", ".", out)))


def joined(lines):
    """Neighbouring <line> elements as one path for each look."""
    looks = {}
    for look, x1, y1, x2, y2 in re.findall(r'<line (.*?) x1="(.*?)" y1="(.*?)" x2="(.*?)" y2="(.*?)"></line>', lines):
        looks[look] = looks.get(look, "") + f"M{x1} {y1}L{x2} {y2}"
    return "".join(f'<path {look} d="{d}"/>\n' for look, d in looks.items())


def plain(svg):
    """A picture of the wall made small: colours in place of variables, no tooltips, no dark variant, short paths."""
    colours = dict(re.findall(r"(--\w+):\s*([^;}]+)", svg[svg.index(":root{"):svg.index("@media")]))
    svg = re.sub(r"@media[^{]*\{:root\{[^}]*\}\}|:root\{[^}]*\}|<title>[^<]*</title>", "", svg)
    svg = re.sub(r"var\((--\w+)\)", lambda m: colours[m[1]].strip(), svg)
    svg = svg.replace("<style>", "<style>text{font-family:system-ui,'Segoe UI',Roboto,Helvetica,Arial,sans-serif}")
    svg = svg.replace(' opacity="1.00"', "").replace('xmlns="http://www.w3.org/2000/svg" class="wall"', 'class="wall"')
    svg = re.sub(r"(<line [^>]*></line>\s*)+", lambda m: joined(m[0]), svg)
    return re.sub(r"\n+", "\n", re.sub(r' d="([^"]*)"', lambda m: f' d="{moves(m[1])}"', svg))
