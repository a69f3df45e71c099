"""What decides a shear wall: J4D and MI1 taken apart, one change at a time.

validation/why.csv           the changes: wall, question, change, settings laid over the wall's model
validation/why_results.csv   what each gives; written by `tools/validation why`, which also draws the cracks
docs/evidence/why_shear_walls.md      the page, from the two and from validation/why.md
"""
import csv
import os
import re

import cracks
import walls
from page import table

CHANGES, RESULTS, TEXTS = "validation/why.csv", "validation/why_results.csv", "validation/why.md"
COLUMNS = ["wall", "change", "peak_kN", "at_peak_mm", "at_80_mm", "is_bound", "mode", "judgement", "state", "build"]
OPEN, SLIPPED, CRUSHED, WHOLE = "#d9822b", "#2b5f8a", "#7a1f1f", "#ddd"


def slug(text):
    return re.sub(r"[^a-z0-9]+", "_", text.lower()).strip("_")


def run(wythe, folder_of, out, matches):
    """Runs each change; a row is kept as soon as it is known."""
    models = {t["wall"]: t for t in walls.read_csv(walls.WALLS)}
    for change in walls.read_csv(CHANGES):
        key = change["wall"], change["change"]
        if not matches(" ".join(key)):
            continue
        settings = walls.settings_of(models[change["wall"]], [o for o in change["settings"].split(";") if o])
        folder = folder_of(os.path.join(out, "why"), " ".join(key))
        row = walls.predicted_row("", change["wall"], wythe(models[change["wall"]]["model"], settings, folder))
        keep({**{c: row.get(c, "") for c in COLUMNS}, "change": change["change"]})
        if change["picture"]:
            draw(folder, f"docs/evidence/figures/why_{slug(' '.join(key))}.svg", change["picture"])
        print(f"{key[0]}, {key[1]}: {row['peak_kN']} kN, {row['mode']}, {row['judgement']}", flush=True)


def keep(row):
    rows = {(r["wall"], r["change"]): r for r in walls.read_csv(RESULTS) + [row]}
    order = [(c["wall"], c["change"]) for c in walls.read_csv(CHANGES)]
    with open(RESULTS, "w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows[key] for key in order if key in rows)


# --- pictures ---------------------------------------------------------------------------------------------

def draw(folder, path, at):
    """The joints of the stored state nearest to `at` [mm]: open orange, slipped blue, crushed dark; thicker is wider."""
    found = cracks.states(folder)
    place, arrays = min(found, key=lambda s: abs(s[0] - float(at)))
    points, ends, lines, begin = arrays["Points"], arrays["offsets"], [], 0
    xs, ys = points[0::3], points[1::3]
    scale = 360 / max(max(xs) - min(xs), max(ys) - min(ys))
    width, height = scale * (max(xs) - min(xs)) + 20, scale * (max(ys) - min(ys)) + 20
    for j, end in enumerate(ends):
        members = arrays["connectivity"][begin:end]
        begin = end
        (x1, y1), (x2, y2) = ((10 + scale * (xs[m] - min(xs)), height - 10 - scale * (ys[m] - min(ys)))
                              for m in (members[0], members[-1]))
        opening, slip = arrays["opening_mm"][j], abs(arrays["slip_mm"][j])
        colour, wide = WHOLE, 0.7
        if arrays["damage"][j] > 0.999 and max(opening, slip) > 0.02:
            colour, wide = (OPEN, opening) if opening >= slip else (SLIPPED, slip)
            wide = min(5, 1.2 + 2 * wide)
        if arrays["crushing"][j] > 0.05:
            colour, wide = CRUSHED, 4
        lines.append((wide, f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" stroke="{colour}" '
                            f'stroke-width="{wide:.1f}"/>'))
    body = "\n".join(line for _, line in sorted(lines))
    with open(path, "w", encoding="utf-8") as file:
        file.write(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.0f} {height:.0f}"><title>cracks at '
                   f'{place:.1f} mm</title><rect width="100%" height="100%" fill="white"/>\n{body}\n</svg>\n')


# --- the page ---------------------------------------------------------------------------------------------

def texts():
    with open(TEXTS, encoding="utf-8") as file:
        parts = re.split(r"^## +(.*)$", file.read(), flags=re.M)
    return dict(zip(parts[1::2], (p.strip() for p in parts[2::2])))


def rows_of(wall, results):
    base = results.get((wall, "base"))
    rows = []
    for change in walls.read_csv(CHANGES):
        row = results.get((wall, change["change"]))
        if change["wall"] != wall:
            continue
        if row is None:
            rows.append([change["question"], change["change"], "not run", "–", "–", "–", "–"])
            continue
        moved = (f"{100 * (float(row['peak_kN']) / float(base['peak_kN']) - 1):+.0f}"
                 if row["peak_kN"] and base["peak_kN"] else "–")
        bound = "> " if row["is_bound"] == "yes" else ""
        rows.append([change["question"], change["change"], row["peak_kN"] or "not known", moved, bound + row["at_80_mm"], row["mode"],
                     row["judgement"]])
    return rows


def write(page):
    results = {(r["wall"], r["change"]): r for r in walls.read_csv(RESULTS)}
    said = texts()
    lines = ["# Why: what decides a shear wall", "", "<!-- written by tools/validation page; edit validation/why.md instead -->", "",
             said["First"], ""]
    for wall in dict.fromkeys(c["wall"] for c in walls.read_csv(CHANGES)):
        lines += [f"## {wall}", "", said.get(wall, ""), ""]
        lines += table(["question", "change", "peak, kN", "change, %", "80 % at, mm", "failure", "push"], rows_of(wall, results))
        for change in walls.read_csv(CHANGES):
            name = f"figures/why_{slug(wall + ' ' + change['change'])}.svg"
            if change["wall"] == wall and change["picture"] and os.path.exists(os.path.join("docs/evidence", name)):
                lines += [f"![{wall}, {change['change']}: cracks]({name})", "", f"*{wall}, {change['change']}, at {change['picture']} mm.*", ""]
        lines += [said.get(f"{wall}, outcome", ""), ""]
    lines += [said.get("What decides", ""), ""]
    builds = sorted({row["build"] for row in results.values() if row.get("build")})
    lines += [f"Builds: {', '.join(builds)}."] if builds else []
    with open(page, "w", encoding="utf-8") as file:
        file.write(re.sub(r"\n{3,}", "\n\n", "\n".join(lines)).rstrip() + "\n")
