"""docs/sensitivity.md from the results of tools/sensitivity: one table a group, and the rate study."""
import csv
import os

from kept_text import kept_text

HEAD = """# Sensitivity of the tuff wall

Which choices change the result for the tuff wall, and by how much? The model is `examples/tuff_wall/model.toml` (Table 1 of the
paper) with the paper's lintel of 0.3 GPa as a chain of rigid segments (`PAPER_LINTEL` of `tools/paired_samples`). Each row changes
one thing. Forces are means over one row of the curve (a window of 0.1 mm) unless stated otherwise. D is the displacement at which the
force has fallen to 80 % of the peak; ">" means that the push ended before. "Drag" is the mean difference between reaction and base
shear, divided by the peak. "Ledger gap" is the energy that the energy ledger misses. Made by `tools/sensitivity run` and
`tools/sensitivity page`.
"""


def read(out):
    with open(os.path.join(out, "results.csv")) as file:
        return list(csv.DictReader(file))


def table(rows, base):
    lines = ["| variant | peak kN | against base | at mm | D mm | stiffness kN/mm | mode | drag % | ledger gap % |",
             "|---|---|---|---|---|---|---|---|---|"]
    for r in rows:
        change = 100 * (float(r["peak_kN"]) / base - 1)
        d80 = ("> " if r["censored_80"] == "1" else "") + r["d80_mm"]
        lines.append(f"| {r['variant']} | {r['peak_kN']} | {change:+.1f} % | {r['at_mm']} | {d80} | "
                     f"{r['stiffness_kN_per_mm']} | {r['mode']} | {r['shear_gap_percent']} | "
                     f"{r['energy_gap_percent']} |")
    return "\n".join(lines)


def line_fit(points):
    """Least squares y = a + b x."""
    n = len(points)
    mx = sum(x for x, _ in points) / n
    my = sum(y for _, y in points) / n
    sxx = sum((x - mx) ** 2 for x, _ in points)
    slope = sum((x - mx) * (y - my) for x, y in points) / sxx
    return my - slope * mx, slope


def rate_rows(rows):
    """{damping: [(velocity, row)]}, slowest first."""
    found = {}
    for r in rows:
        if r["group"] != "rate":
            continue
        velocity, damping = r["variant"].replace(" mm/s, damping", "").split()
        found.setdefault(float(damping), []).append((float(velocity), r))
    return {damping: sorted(runs, key=lambda run: run[0]) for damping, runs in found.items()}


def rate_section(rows):
    lines = ["## Rate and damping", "",
             "Local damping takes a share of every unbalanced force. So each vibration brakes the push, and the peak",
             "rises with velocity times damping. The last column is the value at zero velocity of the straight line",
             "through the three slowest velocities.", "",
             "| local damping | 10 mm/s | 5 mm/s | 2 mm/s | 1 mm/s | slope kN per mm/s | at zero rate |",
             "|---|---|---|---|---|---|---|"]
    for damping, runs in sorted(rate_rows(rows).items(), reverse=True):
        peak = {v: float(r["peak_kN"]) for v, r in runs}
        cells = [f"{peak[v]:.1f}" if v in peak else "-" for v in (10, 5, 2, 1)]
        zero, slope = line_fit([(v, peak[v]) for v, _ in runs[:3]]) if len(runs) > 2 else (float("nan"),) * 2
        lines.append(f"| {damping:g} | " + " | ".join(cells) + f" | {slope:.2f} | {zero:.1f} kN |")
    lines += ["", "D at 80 % of the peak (mm) and the mode, in the same order:", "",
              "| local damping | 10 mm/s | 5 mm/s | 2 mm/s | 1 mm/s |", "|---|---|---|---|---|"]
    for damping, runs in sorted(rate_rows(rows).items(), reverse=True):
        by = {v: f"{r['d80_mm']} {r['mode']}" for v, r in runs}
        lines.append(f"| {damping:g} | " + " | ".join(by.get(v, "-") for v in (10, 5, 2, 1)) + " |")
    return "\n".join(lines)


def write_page(out, page):
    rows = read(out)
    base = float(next(r for r in rows if r["group"] == "base")["peak_kN"])
    groups = []
    for r in rows:
        if r["group"] not in groups and r["group"] != "rate":
            groups.append(r["group"])
    parts = [HEAD, "## One change at a time", ""]
    lines = table([dict(r, variant=r["variant"] if g == "base" else f"{g}: {r['variant']}")
                   for g in groups for r in rows if r["group"] == g], base)
    parts += [lines, "", rate_section(rows), ""]
    parts += [kept_text(page).rstrip(), ""]
    hashes = ["## Hashes", "", "| variant | state hash | overrides |", "|---|---|---|"]
    hashes += [f"| {r['group']}: {r['variant']} | `{r['state_hash']}` | {r['overrides'].replace('|', '/')} |" for r in rows]
    with open(page, "w") as file:
        file.write("\n".join(parts + hashes) + "\n")
