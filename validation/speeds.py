"""How fast may a push be? Unlike walls at several speeds: peak, displacement capacity and name beside those of a push that adapts.

validation/speeds.csv       what each push gives and what its verdicts say; written by `tools/validation speeds`
docs/evidence/rate.md       the page, from it and from validation/speeds.md
"""
import csv
import os

import walls
from page import table

RESULTS, TEXT = "validation/speeds.csv", "validation/speeds.md"
# Tested walls by their name in walls.csv, and examples: some rock, slide, shear, have openings, lie dry.
WALLS = ["MI1", "MI3", "PUP1", "PUP3", "COMP2_1", "J4D", "J6D", "T3", "WS.40", "examples/brick_pier", "examples/brick_portal", "tuff wall"]
SPEEDS = ["1 mm/s", "5 mm/s", "adapted"]
# Pushes that the verdicts on displacement and mode are held against: the slowest of a wall is what they are to promise. A push to less than the
# others (END) is worth its first fall alone, and is held against nothing.
SLOWEST = {"MI1": "0.1 mm/s", "MI3": "0.1 mm/s", "PUP1": "0.1 mm/s", "PUP3": "0.1 mm/s", "COMP2_1": "1 mm/s", "J4D": "0.1 mm/s", "J6D": "0.1 mm/s",
           "T3": "0.2 mm/s", "WS.40": "0.1 mm/s", "examples/brick_pier": "0.1 mm/s", "examples/brick_portal": "0.2 mm/s", "examples/tuff_wall": "0.5 mm/s",
           "tuff wall": "0.5 mm/s"}
END = {("COMP2_1", "0.1 mm/s"): ["stage.push.until=6 mm", "output.window=0.04 mm", "output.states=['2 mm']"]}
MORE = [("COMP2_1", "0.1 mm/s"), ("COMP2_1", "2 mm/s"), ("COMP2_1", "10 mm/s"), ("COMP2_1", "20 mm/s"), ("COMP2_1", "1 mm/s, damping 0.8"), ("COMP2_1", "2 mm/s, damping 0.8"),
        ("COMP2_1", "5 mm/s, damping 0.8"), ("COMP2_1", "5 mm/s, damping 0.5"), ("tuff wall", "10 mm/s"),
        *(("examples/tuff_wall", push) for push in ("1 mm/s", "3 mm/s", "5 mm/s", "10 mm/s", "adapted", "1 mm/s, damping 0.8", "5 mm/s, damping 0.8", "10 mm/s, damping 0.8"))]
RUNS = [(wall, push) for wall in WALLS for push in SPEEDS] + MORE + [push for push in SLOWEST.items() if push[1] not in SPEEDS]
SAME = 0.1  # of the displacement: what a verdict promises
COLUMNS = ["wall", "push", "peak_kN", "at_peak_mm", "first_mm", "lasting_mm", "is_bound", "mode", "judgement", "displacement", "mode_verdict", "steps", "state",
           "build"]


def settings_of(wall, push):
    if push == "adapted":
        return walls.PUSH
    speed, _, damping = push.partition(", damping ")
    return [f"stage.push.velocity={speed}"] + ([f"stage.push.damping={damping}"] if damping else []) + END.get((wall, push), [])


def run(wythe, folder_of, out, matches):
    """Pushes each wall as RUNS says; a row is kept as soon as it is known."""
    tests = {t["wall"]: t for t in walls.read_csv(walls.WALLS)}
    for wall, push in RUNS:
        if not matches(f"{wall} {push}"):
            continue
        test = tests.get(wall)
        model, settings = (test["model"], walls.settings_of(test)) if test else (f"{wall}/model.toml", [])
        said = wythe(model, settings + settings_of(wall, push), folder_of(os.path.join(out, "speeds"), f"{wall} {push}"))
        meter = said["quasi_static"]
        keep({"wall": wall, "push": push, "peak_kN": rounded(said["peak_reaction_kN"]), "at_peak_mm": rounded(said["displacement_at_peak_mm"]),
              "first_mm": rounded(said["first_fall_80_percent_mm"]), "lasting_mm": rounded(said["displacement_at_80_percent_mm"]),
              "is_bound": "yes" if said["censored_80"] else "", "mode": said["failure_mode"]["name"],
              "judgement": meter["judgement"], "displacement": meter["displacement"]["verdict"], "mode_verdict": meter["mode"]["verdict"],
              "steps": said["steps"], "state": said["state_hash"], "build": said["provenance"]["commit"]})
        print(f"{wall}, {push}: {said['peak_reaction_kN']} kN", flush=True)


def rounded(value):
    return "" if value is None else f"{value:.4g}"


def keep(row):
    rows = {(r["wall"], r["push"]): r for r in walls.read_csv(RESULTS) + [row]}
    with open(RESULTS, "w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows[run] for run in RUNS if run in rows)


def row_of(row):
    bound = "> " if row["is_bound"] else ""
    return [row["wall"], row["push"], row["peak_kN"] or "not known", row["at_peak_mm"] or "–", bound + (row["first_mm"] or "–"),
            bound + (row["lasting_mm"] or "–"), row["mode"] or "–", row["judgement"], f"{int(row['steps']) / 1e6:.2f}"]


def true_promises(row, slow):
    """Whether a push gives the displacement and the mode of the slow one; None: not known. A bound is right where the slow wall stands so long."""
    if not row["lasting_mm"]:
        return False, None
    at, slow_at = float(row["lasting_mm"]), float(slow["lasting_mm"])
    if row["is_bound"] or slow["is_bound"]:
        displacement = slow_at >= (1 - SAME) * at and (bool(row["is_bound"]) or at >= (1 - SAME) * slow_at)
    else:
        displacement = abs(at - slow_at) <= SAME * slow_at
    return displacement, None if ends_early(slow) else row["mode"] == slow["mode"]


def ends_early(row):
    return (row["wall"], row["push"]) in END


def verdicts(rows):
    """A line for each push but the slowest of its wall, and how many promises were kept."""
    by = {(row["wall"], row["push"]): row for row in rows}
    table_rows, counts = [], {}
    for row in rows:
        slow = by.get((row["wall"], SLOWEST[row["wall"]]))
        if slow is None or row is slow or ends_early(row):
            continue
        cells = [row["wall"], row["push"], row["judgement"]]
        slow_mode = by[row["wall"], "1 mm/s"] if ends_early(slow) else slow
        for quantity, said, truth in zip(("displacement", "mode"), (row["displacement"], row["mode_verdict"]),
                                         (true_promises(row, slow)[0], true_promises(row, slow_mode)[1])):
            if row is slow_mode and quantity == "mode":
                truth = None
            kind = "adapted" if row["push"] == "adapted" else "one speed"
            if truth is not None:
                key = quantity, kind, said == "slow enough", truth
                counts[key] = counts.get(key, 0) + 1
            cells += [said, {True: "the same", False: "**another**", None: "–"}[truth]]
        table_rows.append(cells)
    return table_rows, counts


def write(page):
    rows = walls.read_csv(RESULTS)
    with open(TEXT, encoding="utf-8") as file:
        lines = ["# How fast may a push be?", "", "<!-- written by tools/validation page; edit validation/speeds.md instead -->", "",
                 file.read().strip(), ""]
    lines += table(["wall", "push", "peak, kN", "at, mm", "first fall to 80 %, mm", "lasting, mm", "failure", "verdict on the force", "million steps"],
                   [row_of(row) for row in rows])
    judged, counts = verdicts(rows)
    lines += ["## What the verdicts promised, and what a slow push gave", "",
              f"The same: within {100 * SAME:.0f} % of the displacement, or a bound that the slow wall reaches; the same name. A slow push is the slowest above.", ""]
    lines += table(["wall", "push", "force", "displacement", "in a slow push", "mode", "in a slow push"], judged)
    lines += table(["verdict", "push", "promised and kept", "promised and false", "not known, though true", "not known, and another"],
                   [[quantity, kind] + [str(counts.get((quantity, kind, *key), 0)) for key in ((True, True), (True, False), (False, True), (False, False))]
                    for quantity in ("displacement", "mode") for kind in ("one speed", "adapted")])
    lines += [f"Builds: {', '.join(sorted({row['build'] for row in rows}))}."]
    with open(page, "w", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")
