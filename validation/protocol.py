"""What cycles do to a drift: tested walls under a protocol of levels and cycles, and pushed one way.

validation/protocol.csv           walls, levels and cycles; "own": of the test itself, "generic": a usual one, where the test's is not known
validation/protocol_measured.csv  energy of each cycle of recorded tests, with its turns and forces
validation/protocol_results.csv   what each push gives; written by `tools/validation protocol`
validation/protocol_cycles.csv    what each cycle of the runs gives; likewise
docs/evidence/protocol.md         the page, from them and from validation/protocol.md
"""
import csv
import json
import math
import os

import walls
from figure import COLOURS, Figure
from page import table
from readings import read_curve

PLAN, MEASURED, TEXT = "validation/protocol.csv", "validation/protocol_measured.csv", "validation/protocol.md"
RESULTS, CYCLES = "validation/protocol_results.csv", "validation/protocol_cycles.csv"
PUSHES = ["one way", "protocol"]
DRAWN = {"J4D": (5, 60), "SW0.1": (7, 100), "HfBW0.1": (10, 140)}  # walls with a figure: mm, kN
COLUMNS = ["wall", "push", "direction", "peak_kN", "at_peak_mm", "lasting_mm", "is_bound", "mode", "judgement", "steps", "state", "build"]
CYCLE_COLUMNS = ["wall", "cycle", "repeat", "kind", "max_mm", "min_mm", "max_kN", "min_kN", "dissipated_J", "drag_J", "damping_ratio", "strength_kept"]


def settings_of(plan, push):
    if push == "one way":
        return walls.PUSH
    levels = ", ".join(f"'{a} mm'" for a in plan["amplitudes_mm"].split())
    # to the last level, whatever is left: the ratio is of what both pushes keep
    return walls.PUSH + [f"stage.push.amplitudes=[{levels}]", f"stage.push.cycles={plan['cycles']}", "stage.push.stop_below=0"]


def run(wythe, folder_of, out, matches):
    """Pushes each wall one way and by its protocol; rows are kept as soon as they are known."""
    tests = {t["wall"]: t for t in walls.read_csv(walls.WALLS)}
    for plan in walls.read_csv(PLAN):
        test = tests[plan["wall"]]
        for push in PUSHES:
            name = f"{plan['wall']} {push}"
            if not matches(name):
                continue
            settings = walls.settings_of(test) + settings_of(plan, push)
            said = wythe(test["model"], settings, folder_of(os.path.join(out, "protocol"), name))
            keep(RESULTS, COLUMNS, plan["wall"], push, rows_of(plan["wall"], push, said))
            if "cyclic" in said:
                keep(CYCLES, CYCLE_COLUMNS, plan["wall"], None, cycles_of(plan["wall"], said))
            print(f"{name}: {said['peak_reaction_kN']} kN, {said['wall_seconds']:.0f} s", flush=True)


def rounded(value):
    return "" if value is None else f"{value:.4g}"


def rows_of(wall, push, said):
    ways = {"": said} if push == "one way" else {way: said["cyclic"][way] for way in ("positive", "negative")}
    return [{"wall": wall, "push": push, "direction": way, "peak_kN": rounded(of["peak_reaction_kN"]), "at_peak_mm": rounded(of["displacement_at_peak_mm"]),
             "lasting_mm": rounded(of["displacement_at_80_percent_mm"]), "is_bound": "yes" if of["censored_80"] else "",
             "mode": said["failure_mode"]["name"], "judgement": said["quasi_static"]["judgement"], "steps": said["steps"], "state": said["state_hash"],
             "build": said["provenance"]["commit"]} for way, of in ways.items()]


def cycles_of(wall, said):
    return [{"wall": wall, "cycle": k + 1, "repeat": c["repeat"], "kind": c["kind"], "max_mm": rounded(c["displacement_max_mm"]),
             "min_mm": rounded(c["displacement_min_mm"]), "max_kN": rounded(c["reaction_max_kN"]), "min_kN": rounded(c["reaction_min_kN"]),
             "dissipated_J": rounded(c["dissipated_J"]), "drag_J": rounded(c["drag_J"]), "damping_ratio": rounded(c["damping_ratio"]),
             "strength_kept": rounded(c["strength_kept"])} for k, c in enumerate(said["cyclic"]["cycles"])]


def keep(path, columns, wall, push, new):
    """Puts the rows of one run in the place of its earlier ones."""
    rows = [r for r in walls.read_csv(path) if r["wall"] != wall or (push and r["push"] != push)] + new
    order = [plan["wall"] for plan in walls.read_csv(PLAN)]
    rows.sort(key=lambda r: (order.index(r["wall"]), PUSHES.index(r["push"]) if push else 0))
    with open(path, "w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, columns, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


# --- the page --------------------------------------------------------------------------------------------

def mean_drift(rows):
    """Geometric mean of the directions, and whether it is a bound: None where one has none."""
    if not rows or not all(r["lasting_mm"] for r in rows):
        return None
    return walls.geometric_mean([float(r["lasting_mm"]) for r in rows]), all(r["is_bound"] for r in rows), any(r["is_bound"] for r in rows)


def told(found):
    if found is None:
        return "–"
    return f"{'> ' if found[2] else ''}{found[0]:.3g}"


def ratio_of(cyclic, one_way):
    """Of cyclic to one-way drift, with its sense where one of them is a bound; "" where neither was seen to fall."""
    if cyclic is None or one_way is None or (cyclic[2] and one_way[2]):
        return "–"
    return f"{'> ' if cyclic[2] else '< ' if one_way[2] else ''}{cyclic[0] / one_way[0]:.2f}"


def drift_rows():
    results, tests = walls.read_csv(RESULTS), {t["test"]: t for t in walls.read_csv(walls.WALLS)}
    rows = []
    for plan in walls.read_csv(PLAN):
        of = {push: [r for r in results if r["wall"] == plan["wall"] and r["push"] == push] for push in PUSHES}
        if not all(of.values()):
            continue
        one_way, cyclic = (mean_drift(of[push]) for push in PUSHES)
        peaks = " / ".join(r["peak_kN"] or "–" for r in of["protocol"])
        test = tests[plan["test"]]
        drift = walls.measured_drift(test)
        measured = "–" if drift is None else f"{'> ' if drift[1] else ''}{10 * drift[0] * float(test['drift_height_m']):.3g}"
        rows.append([plan["wall"], plan["basis"], test["kind"], of["one way"][0]["peak_kN"], peaks, told(one_way), told(cyclic), ratio_of(cyclic, one_way),
                     measured, of["one way"][0]["mode"], of["protocol"][0]["mode"], of["protocol"][0]["build"]])
    return rows


def damping(energy, high, low, force_high, force_low):
    """Equivalent viscous damping ratio of a full cycle (docs/reference/results.md)."""
    return energy / (math.pi * (high * force_high + low * force_low))


def energy_rows():
    """Recorded cycles beside those of the run that come closest in displacement, first cycles alone."""
    computed = [c for c in walls.read_csv(CYCLES) if c["kind"] == "full" and c["repeat"] == "1"]
    wall_of = {plan["test"]: plan["wall"] for plan in walls.read_csv(PLAN)}
    rows = []
    for m in walls.read_csv(MEASURED):
        of = [c for c in computed if c["wall"] == wall_of.get(m["test"])]
        if not of:
            continue
        at = 0.5 * (float(m["plus_mm"]) + float(m["minus_mm"]))
        near = min(of, key=lambda c: abs(float(c["max_mm"]) - at))
        if abs(float(near["max_mm"]) - at) > 0.1 * at:
            continue
        xi = damping(float(m["energy_J"]), *(float(m[k]) for k in ("plus_mm", "minus_mm", "plus_kN", "minus_kN")))
        rows.append([m["test"], f"{at:.1f}", m["energy_J"], near["dissipated_J"], f"{float(near['dissipated_J']) / float(m['energy_J']):.2f}",
                     f"{100 * xi:.1f}", f"{100 * float(near['damping_ratio']):.1f}" if near["damping_ratio"] else "–"])
    return rows


def draw(out, folder_of, figures):
    """The envelopes of both directions over the push one way, where the runs are there; the lines that show them."""
    lines = []
    for wall, (far, force) in DRAWN.items():
        name = f"protocol_{wall.lower().replace('.', '_')}.svg"
        folders = [folder_of(os.path.join(out, "protocol"), f"{wall} {push}") for push in PUSHES]
        if all(os.path.exists(os.path.join(folder, "summary.json")) for folder in folders):
            figure = Figure("displacement (mm)", "force (kN)", far, force)
            with open(os.path.join(folders[1], "summary.json"), encoding="utf-8") as file:
                cyclic = json.load(file)["cyclic"]
            figure.line(read_curve(os.path.join(folders[0], "force_displacement.csv")), "one way", COLOURS[0], width=2)
            for way, colour, words in (("positive", COLOURS[1], "cycles, along"), ("negative", COLOURS[2], "cycles, against")):
                envelope = cyclic[way]["envelope"]
                figure.line(list(zip(envelope["displacement_mm"], envelope["reaction_kN"])), words, colour)
            with open(os.path.join(figures, name), "w", encoding="utf-8") as file:
                file.write(figure.svg())
        if os.path.exists(os.path.join(figures, name)):
            lines += [f"![{wall}: pushed one way, and the envelope of each direction of its cycles](figures/{name})", ""]
    return lines


def write(page, out, folder_of):
    results = walls.read_csv(RESULTS)
    if not results:
        return
    with open(TEXT, encoding="utf-8") as file:
        lines = ["# The test's own protocol: what cycles do to a drift", "", "<!-- written by tools/validation page; edit validation/protocol.md instead -->",
                 "", file.read().strip(), "", "## Drift to and fro, and one way", ""]
    lines += table(["wall", "protocol", "kind", "peak one way, kN", "peaks to and fro", "d(0.8) one way, mm", "to and fro", "ratio", "measured",
                    "failure one way", "to and fro", "build"], drift_rows())
    lines += draw(out, folder_of, os.path.join(os.path.dirname(page), "figures"))
    lines += ["## Energy of each cycle", ""]
    lines += table(["test", "level, mm", "measured, J", "computed, J", "ratio", "damping measured, %", "computed, %"], energy_rows())
    lines += ["## Levels", ""]
    lines += table(["wall", "levels of", "basis", "cycles", "amplitudes, mm"],
                   [[p["wall"], p["test"], p["basis"], p["cycles"], p["amplitudes_mm"]] for p in walls.read_csv(PLAN)])
    lines += [f"Builds: {', '.join(sorted({row['build'] for row in results}))}."]
    with open(page, "w", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")
