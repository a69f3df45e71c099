"""Curve overlays as SVG: one panel, axes with round ticks, a legend, no dependencies."""
import math

WIDTH, HEIGHT = 760, 420
LEFT, RIGHT, TOP, BOTTOM = 62, 16, 16, 104
INK, GRID = "#333", "#ddd"
COLOURS = ["#b5442a", "#2b5f8a", "#6a8f3a"]  # the run, then its variants
LEVEL = "#8a5fa8"


def ticks(greatest, wanted=6):
    raw = greatest / wanted
    power = 10 ** math.floor(math.log10(raw))
    step = next(s * power for s in (1, 2, 2.5, 5, 10) if s * power >= raw)
    return [i * step for i in range(int(greatest / step + 1e-9) + 1)]


class Figure:
    """Lines, levels and points over displacement (or any x); everything starts at 0."""

    def __init__(self, x_label, y_label, x_max, y_max):
        self.x_max, self.y_max = x_max, y_max
        self.labels, self.body, self.legend = (x_label, y_label), [], []

    def x(self, value):
        return LEFT + (WIDTH - LEFT - RIGHT) * value / self.x_max

    def y(self, value):
        return HEIGHT - BOTTOM - (HEIGHT - TOP - BOTTOM) * value / self.y_max

    def line(self, points, name, colour, dash="", width=1.6):
        inside = [(a, b) for a, b in points if a <= self.x_max]
        path = " ".join(f"{self.x(a):.1f},{self.y(b):.1f}" for a, b in inside)
        style = f'fill="none" stroke="{colour}" stroke-width="{width}" stroke-dasharray="{dash}"'
        self.body.append(f'<polyline points="{path}" {style}/>')
        self.legend.append((name, colour, dash, width))

    def level(self, value, name):
        self.line([(0, value), (self.x_max, value)], name, LEVEL, "7 4", 1.4)

    def point(self, at, value, name, colour):
        self.body.append(f'<circle cx="{self.x(at):.1f}" cy="{self.y(value):.1f}" r="4" fill="white" '
                         f'stroke="{colour}" stroke-width="1.8"/>')
        self.legend.append((name, colour, None, 1.8))

    def axes(self):
        parts = []
        for t in ticks(self.x_max):
            parts.append(f'<line x1="{self.x(t):.1f}" x2="{self.x(t):.1f}" y1="{TOP}" y2="{HEIGHT - BOTTOM}" '
                         f'stroke="{GRID}"/><text x="{self.x(t):.1f}" y="{HEIGHT - BOTTOM + 18}" '
                         f'text-anchor="middle">{t:g}</text>')
        for t in ticks(self.y_max):
            parts.append(f'<line x1="{LEFT}" x2="{WIDTH - RIGHT}" y1="{self.y(t):.1f}" y2="{self.y(t):.1f}" '
                         f'stroke="{GRID}"/><text x="{LEFT - 8}" y="{self.y(t) + 4:.1f}" '
                         f'text-anchor="end">{t:g}</text>')
        parts.append(f'<path d="M{LEFT} {TOP}V{HEIGHT - BOTTOM}H{WIDTH - RIGHT}" fill="none" stroke="{INK}"/>')
        middle = (TOP + HEIGHT - BOTTOM) / 2
        parts.append(f'<text x="{(LEFT + WIDTH) / 2}" y="{HEIGHT - BOTTOM + 38}" '
                     f'text-anchor="middle">{self.labels[0]}</text>')
        parts.append(f'<text transform="translate(16 {middle}) rotate(-90)" '
                     f'text-anchor="middle">{self.labels[1]}</text>')
        return parts

    def legend_parts(self):
        parts = []
        for i, (name, colour, dash, width) in enumerate(self.legend):
            x, y = LEFT + (i % 2) * 350, HEIGHT - 36 + 17 * (i // 2)
            if dash is None:
                parts.append(f'<circle cx="{x + 13}" cy="{y - 4}" r="4" fill="white" stroke="{colour}" '
                             f'stroke-width="{width}"/>')
            else:
                parts.append(f'<line x1="{x}" x2="{x + 26}" y1="{y - 4}" y2="{y - 4}" stroke="{colour}" '
                             f'stroke-width="{width}" stroke-dasharray="{dash}"/>')
            parts.append(f'<text x="{x + 32}" y="{y}">{name}</text>')
        return parts

    def svg(self):
        rows = max(0, (len(self.legend) + 1) // 2 - 2)
        head = (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT + 17 * rows}" '
                f'font-family="sans-serif" font-size="13" fill="{INK}">')
        ground = f'<rect width="{WIDTH}" height="{HEIGHT + 17 * rows}" fill="white"/>'
        return "\n".join([head, ground] + self.axes() + self.body + self.legend_parts() + ["</svg>\n"])
