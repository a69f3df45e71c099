"""Figures as SVG, without dependencies: curve overlays, and predicted against measured values."""
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
    """Lines and levels over displacement (or any x); everything starts at 0."""

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


class LogSquare:
    """Predicted against measured on two equal logarithmic axes, with rays of equal ratio and bands between them."""
    SIZE, LEFT, TOP = 420, 62, 16

    def __init__(self, x_label, y_label, low, high, unit="kN"):
        self.low, self.high, self.labels, self.unit = low, high, (x_label, y_label), unit
        self.bands, self.rays, self.points, self.keys = [], [], [], []

    def at(self, value):
        return self.SIZE * math.log(value / self.low) / math.log(self.high / self.low)

    def xy(self, measured, predicted):
        return self.LEFT + self.at(measured), self.TOP + self.SIZE - self.at(predicted)

    def _ends(self, ratio):
        """The ray predicted = ratio measured, inside the square."""
        a = max(self.low, self.low / ratio)
        b = min(self.high, self.high / ratio)
        return self.xy(a, ratio * a), self.xy(b, ratio * b)

    def band(self, low, high, colour, name):
        (a, b), (c, d) = self._ends(low), self._ends(high)
        corner = self.xy(self.low, self.low), self.xy(self.high, self.high)
        around = [corner[0], a, b, corner[1], d, c]
        path = " ".join(f"{x:.1f},{y:.1f}" for x, y in around)
        self.bands.append(f'<polygon points="{path}" fill="{colour}" fill-opacity="0.12"/>')
        self.keys.append((f'<rect x="{{x}}" y="{{y}}" width="22" height="10" fill="{colour}" fill-opacity="0.25"/>', name))

    def ray(self, ratio, colour, dash=""):
        (x1, y1), (x2, y2) = self._ends(ratio)
        self.rays.append(f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" stroke="{colour}" stroke-dasharray="{dash}"/>')

    def point(self, measured, predicted, colour, is_full, name):
        x, y = self.xy(measured, predicted)
        self.points.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4.5" fill="{colour if is_full else "white"}" stroke="{colour}" '
                           f'stroke-width="1.6"><title>{name}: {predicted:g} for {measured:.4g} {self.unit}</title></circle>')

    def key(self, colour, name, hollow=False):
        fill = "white" if hollow else colour
        self.keys.append((f'<circle cx="{{cx}}" cy="{{cy}}" r="4.5" fill="{fill}" stroke="{colour}" stroke-width="1.6"/>', name))

    def axes(self):
        parts = []
        for t in (0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000):
            if not self.low <= t <= self.high:
                continue
            x, y = self.xy(t, t)
            parts.append(f'<line x1="{x:.1f}" x2="{x:.1f}" y1="{self.TOP}" y2="{self.TOP + self.SIZE}" stroke="{GRID}"/>'
                         f'<line x1="{self.LEFT}" x2="{self.LEFT + self.SIZE}" y1="{y:.1f}" y2="{y:.1f}" stroke="{GRID}"/>'
                         f'<text x="{x:.1f}" y="{self.TOP + self.SIZE + 18}" text-anchor="middle">{t}</text>'
                         f'<text x="{self.LEFT - 8}" y="{y + 4:.1f}" text-anchor="end">{t}</text>')
        middle = self.SIZE / 2
        parts.append(f'<text x="{self.LEFT + middle}" y="{self.TOP + self.SIZE + 38}" text-anchor="middle">{self.labels[0]}</text>'
                     f'<text transform="translate(16 {self.TOP + middle}) rotate(-90)" text-anchor="middle">{self.labels[1]}</text>')
        return parts

    def key_parts(self):
        parts = []
        for i, (mark, name) in enumerate(self.keys):
            x, y = self.LEFT + self.SIZE + 20, self.TOP + 8 + 22 * i
            parts.append(mark.format(x=x, y=y, cx=x + 11, cy=y + 5) + f'<text x="{x + 30}" y="{y + 9}">{name}</text>')
        return parts

    def svg(self):
        width, height = self.LEFT + self.SIZE + 330, self.TOP + self.SIZE + 50
        head = (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-family="sans-serif" font-size="13" '
                f'fill="{INK}"><rect width="{width}" height="{height}" fill="white"/>')
        return "\n".join([head] + self.axes() + self.bands + self.rays + self.points + self.key_parts() + ["</svg>\n"])
