"""Writes docs/evidence/validation_walls.md and its figures from the registry, the variants, the READMEs and the runs."""
import csv
import os
import re

import cracks
from figure import COLOURS, INK, Figure
from readings import load_json, read_curve

HERE = "validation"
# section, folder of its README, the registry's cases, figures
SECTIONS = [
    ("Ferris & Tin-Loi dry walls", "ferris_tinloi_walls", ["ferris wall 1", "ferris wall 2", "ferris wall 4"]),
    ("Dry granite walls WS.40 and WS.100", "vasconcelos_dry_granite_walls", ["WS.40", "WS.100"]),
    ("Dry stone wall SW.100", "lourenco_dry_stone_wall", ["SW.100"]),
    ("Tuff wall with one opening", "tuff_wall_opening", ["tuff wall"]),
]
CURVES = {
    "WS.40": ([("test", "vasconcelos_dry_granite_walls/data/FD_WS40_monotonic.csv")], 30, 18, [("rigid rocking bound", 16.9)]),
    "WS.100": ([("test", "vasconcelos_dry_granite_walls/data/FD_WS100_monotonic.csv")], 30, 42, [("rigid rocking bound", 39.6)]),
    "SW.100": ([("test 1", "lourenco_dry_stone_wall/data/FD_SW1001.csv"), ("test 2", "lourenco_dry_stone_wall/data/FD_SW1002.csv")],
               30, 55, [("rigid rocking bound", 51.8)]),
    "tuff wall": ([], 50, 190, [("mean of the paper's 250 runs, Table 2", 163.25)]),
}
SHOWN_VARIANTS = {"WS.40": ["joints 3 times softer"], "WS.100": ["joints 3 times softer"], "SW.100": ["joints 3 times softer"],
                  "tuff wall": ["1 mm/s, damping 0.8", "cohesion 1.5 ft as in Table 2"]}
PICTURES = ["10 mm", "20 mm", "30 mm"]


def read_csv(name):
    path = os.path.join(HERE, name)
    if not os.path.exists(path):
        return []
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def slug(text):
    return re.sub(r"[^a-z0-9]+", "_", text.lower()).strip("_")


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return lines + ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows] + [""]


def readme_part(folder, heading):
    """Text under `## heading` of the README, or "" where there is none; with "" the part before any ##."""
    with open(os.path.join(HERE, folder, "README.md"), encoding="utf-8") as file:
        parts = re.split(r"^## +(.*)$", file.read(), flags=re.M)
    if not heading:
        return parts[0].split("\n", 1)[1].strip()
    named = dict(zip(parts[1::2], parts[2::2]))
    return named.get(heading, "").strip()


def curve_figure(case, out, folder_of, figures):
    tests, x_max, y_max, levels = CURVES[case]
    own = read_curve(os.path.join(folder_of(out, case), "force_displacement.csv"))
    if not own:
        return []
    figure = Figure("displacement (mm)", "force (kN)", x_max, y_max)
    for (name, path), colour in zip(tests, (INK, "#888")):
        points = read_curve(os.path.join(HERE, path), "top_displacement_mm", "horizontal_force_kN")
        figure.line(points, "measured" + ("" if len(tests) == 1 else ", " + name), colour)
    for name, colour in zip(SHOWN_VARIANTS.get(case, []), COLOURS[1:]):
        points = read_curve(os.path.join(folder_of(out, f"{case}, {name}"), "force_displacement.csv"))
        if points:
            figure.line(points, "wythe, " + name, colour, width=1.2)
    figure.line(own, "wythe", COLOURS[0], width=2)
    for name, value in levels:
        figure.level(value, name)
    name = f"validation_{slug(case)}.svg"
    with open(os.path.join(figures, name), "w", encoding="utf-8") as file:
        file.write(figure.svg())
    return [f"![{case}: force and displacement](figures/{name})", ""]


def picture_style(style, svg):
    """The report's rules that the picture uses, without the dark and the printed variant."""
    used = set(re.findall(r'class="([^"]*)"', svg))
    used = {"." + name for names in used for name in names.split()}
    style = re.sub(r"@media[^{]*\{(?:[^{}]*\{[^{}]*\})*[^{}]*\}", "", style)
    rules = [(selector.strip(), body) for selector, body in re.findall(r"([^{}]+)\{([^{}]*)\}", style)]
    kept = [f"{selector}{{{body}}}" for selector, body in rules
            if "--ink:" in body or selector.startswith("svg") or used & set(re.findall(r"\.\w+", selector))]
    return "\n".join(kept)


def wall_pictures(out, folder_of, figures):
    """The inline pictures of the run's report, with its style, as files; the displacement stands in the caption."""
    path = os.path.join(folder_of(out, "tuff wall"), "report.html")
    if not os.path.exists(path):
        return []
    with open(path, encoding="utf-8") as file:
        text = file.read()
    style = "".join(re.findall(r"<style[^>]*>(.*?)</style>", text, re.S))
    found = re.findall(r'(<svg[^>]*class="wall".*?</svg>)\s*<figcaption>(.*?)</figcaption>', text, re.S)
    lines = []
    for svg, caption in found:
        words = re.sub(r"<[^>]+>", "", caption)
        label = next((p for p in PICTURES if words.startswith(p + ":")), None)
        if label is None:
            continue
        begin = svg.rfind("<svg xmlns")  # skip the legend's little pictures
        svg = svg[max(begin, 0):]
        head, rest = svg.split(">", 1)
        name = f"validation_tuff_wall_{slug(label)}.svg"
        with open(os.path.join(figures, name), "w", encoding="utf-8") as file:
            file.write(f"{head}>\n<style><![CDATA[{picture_style(style, svg)}]]></style>\n"
                       f'<rect width="100%" height="100%" fill="white"/>{rest}\n')
        lines += [f"![the wall at {label}](figures/{name})", "", words.removeprefix(label + ": "), ""]
    key = ("Orange: open; blue: slipped; brown: closed again; dashed: softening, not cracked through; dot: crushed end. "
           "Thicker is wider.")
    return [key, ""] + lines if lines else []


def crack_table(out, folder_of):
    folder = folder_of(out, "tuff wall")
    if not os.path.exists(os.path.join(folder, "run.pvd")):
        return []
    rows = [[f"{r['at']:.1f}", r["pier bases"], r["connections"], r["pier shafts"], r["spandrel"],
             f"{100 * r['crossing']:.0f} %", r["levels"], r["upright"]] for r in cracks.crack_rows(folder)]
    rows = [row for row, before in zip(rows, [None] + rows) if row != before]  # the state at the peak may be one asked for
    head = ["displacement, mm", "pier bases", "connections", "pier shafts", "spandrel, inner",
            "inner columns with a broken bed joint", "bed joints slipped over 1 mm: levels",
            "upright joints broken, inner spandrel"]
    return ["Joints cracked through, by zone:", ""] + table(head, rows)


def registry_table(rows):
    body = [[r["case"], r["quantity"], r["unit"], r["role"], r["measured_or_published"], r["source_kind"],
             r["computed"] or "not run", r["ratio"], r["sigma_E"], r["note"]] for r in rows]
    return table(["case", "quantity", "unit", "role", "reference", "which is", "wythe", "ratio", "sigma_E", "note"], body)


def variant_table(rows):
    if not rows:
        return []
    body = [[r["run"], r["quantity"], r["base"], r["computed"], r["change_percent"]] for r in rows]
    return ["What moves it:", ""] + table(["run", "quantity", "base", "variant", "change, %"], body)


def section(title, folder, cases, registry, variants):
    lines = [f"## {title}", "", readme_part(folder, ""), ""]
    lines += registry_table([r for r in registry if r["case"] in cases])
    outcome = readme_part(folder, "Outcome")
    if outcome:
        lines += ["### Outcome", "", outcome, ""]
    return lines, variant_table([r for r in variants if r["case"] in cases])


def made_with(out, folder_of):
    """Which builds the runs come from, with the number of runs of each."""
    builds = {"base runs": {}, "variants": {}}
    for run in read_csv("runs.csv"):
        summary = load_json(folder_of(out, run["run"]), "summary.json")
        if summary is None:
            continue
        made = summary["provenance"]
        found = builds["base runs" if run["group"] == "base" else "variants"]
        build = f"wythe {made['version']} {made['commit']}, {made['compiler']}"
        found[build] = found.get(build, 0) + 1
    told = [f"{count} {kind} with {build}" for kind, found in builds.items() for build, count in found.items()]
    return "Builds: " + "; ".join(told) + "." if told else ""


def write(out, page, folder_of):
    figures = os.path.join(os.path.dirname(page), "figures")
    os.makedirs(figures, exist_ok=True)
    registry, variants = read_csv("registry.csv"), read_csv("variants.csv")
    lines = ["# Validation, single walls in detail", "", "<!-- written by tools/validation page; edit validation/ instead -->", "",
             "Published walls are computed here and compared with tests and calculations of others. *Blind* means that nothing was",
             "fitted to the reference; *calibration*, that somebody fitted the inputs to it. A *measured* reference is a test, a",
             "*computed* one is a calculation of others or a closed form. Ratios are computed value over reference. Inputs,",
             "assumptions and data are in the folders of validation/.", "",
             made_with(out, folder_of), "", readme_overview(), ""]
    for title, folder, cases in SECTIONS:
        head, moves = section(title, folder, cases, registry, variants)
        lines += head
        for case in cases:
            if case in CURVES:
                lines += curve_figure(case, out, folder_of, figures)
        if cases == ["tuff wall"]:
            lines += crack_table(out, folder_of) + wall_pictures(out, folder_of, figures)
        lines += moves
    with open(page, "w", encoding="utf-8") as file:
        file.write("\n".join(lines).rstrip() + "\n")
    print(page)


def readme_overview():
    path = os.path.join(HERE, "OVERVIEW.md")
    if not os.path.exists(path):
        return ""
    with open(path, encoding="utf-8") as file:
        return file.read().strip()
