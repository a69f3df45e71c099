"""Pictures of results: curves for matplotlib, small ones as SVG, and what a notebook shows.

    import wythe.plot
    axes = wythe.plot.curve(run.curve)
    wythe.plot.curve(other.curve, axes)
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from html import escape
from typing import TYPE_CHECKING, Optional

from ._errors import needed_for
from ._types import Floats

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_TITLES = {"displacement_mm": "displacement [mm]", "reaction_kN": "reaction [kN]", "force_kN": "force [kN]"}


def curve(table: Mapping[str, Floats], axes: Optional[Axes] = None) -> Axes:
    """Force [kN] over displacement [mm] on matplotlib's axes, new ones unless given, which it gives back.

    ``table`` has the columns ``displacement_mm``, and ``reaction_kN`` or, of a mechanism, ``force_kN``.
    Raises MissingPackage without matplotlib.
    """
    with needed_for("plot()"):
        from matplotlib import pyplot
    force = "reaction_kN" if "reaction_kN" in table else "force_kN"
    if axes is None:
        axes = pyplot.subplots()[1]
    axes.plot(table["displacement_mm"], table[force])
    axes.set_xlabel(_TITLES["displacement_mm"])
    axes.set_ylabel(_TITLES[force])
    return axes


def curve_svg(table: Mapping[str, Floats], width: int = 420, height: int = 260) -> str:
    """The same as a small SVG picture of so many pixels, which needs no package but NumPy; "" of less than two rows.

    Rows that are not finite are left out.
    """
    with needed_for("the picture of a curve"):
        import numpy
    force = "reaction_kN" if "reaction_kN" in table else "force_kN"
    x, y, x_label, y_label = table["displacement_mm"], table[force], _TITLES["displacement_mm"], _TITLES[force]
    keep = numpy.isfinite(x) & numpy.isfinite(y)
    x, y = x[keep], y[keep]
    if len(x) < 2:
        return ""
    left, bottom, top = 52, 36, 10
    x_low, x_high = min(0.0, float(x.min())), max(0.0, float(x.max()))
    y_low, y_high = min(0.0, float(y.min())), max(0.0, float(y.max()))
    across = (width - left - 12) / ((x_high - x_low) or 1)
    up = (height - bottom - top) / ((y_high - y_low) or 1)
    points = " ".join(
        f"{left + (a - x_low) * across:.1f},{height - bottom - (b - y_low) * up:.1f}" for a, b in zip(x, y)
    )
    right, floor = width - 12, height - bottom
    return (
        f'<svg viewBox="0 0 {width} {height}" width="{width}" role="img" '
        f'aria-label="{y_label} over {x_label}" '
        'style="max-width:100%;font:12px sans-serif;fill:currentColor">'
        f'<path d="M{left} {top}V{floor}H{right}" fill="none" stroke="currentColor"/>'
        f'<polyline points="{points}" fill="none" stroke="#1f77b4" stroke-width="1.5"/>'
        f'<text x="{left - 4}" y="{top + 10}" text-anchor="end">{number(y_high, 3)}</text>'
        f'<text x="{left - 4}" y="{floor}" text-anchor="end">{number(y_low, 3)}</text>'
        f'<text x="{right}" y="{floor + 14}" text-anchor="end">{number(x_high, 3)}</text>'
        f'<text x="{left}" y="{floor + 14}">{number(x_low, 3)}</text>'
        f'<text x="{(left + right) / 2}" y="{height - 4}" text-anchor="middle">{x_label}</text>'
        f'<text transform="translate(12 {height / 2}) rotate(-90)" text-anchor="middle">{y_label}</text>'
        "</svg>"
    )


def number(value: Optional[float], digits: int = 4, unit: str = "") -> str:
    """A number with its unit; "not known" where there is none (None, NaN)."""
    if value is None or value != value:
        return "not known"
    return f"{value:.{digits}g}{unit}"


def rows_html(rows: Iterable[tuple[str, str]]) -> str:
    """Names and what they are, as a table of HTML."""
    cells = "".join(
        f'<tr><th style="text-align:left">{escape(name)}</th><td style="text-align:left">{escape(value)}</td></tr>'
        for name, value in rows
    )
    return f"<table>{cells}</table>"


def side_by_side(*parts: str) -> str:
    """Pieces of HTML beside each other; empty ones are left out."""
    inner = "".join(f'<div style="max-width:30rem">{part}</div>' for part in parts if part)
    return f'<div style="display:flex;flex-wrap:wrap;gap:1rem;align-items:flex-start">{inner}</div>'
