"""How fast may a push be? Unlike walls at several speeds: peak, displacement capacity and name beside those of a push that adapts.

validation/speeds.csv       what each push gives; written by `tools/validation speeds`
docs/evidence/rate.md       the page, from it and from validation/speeds.md
"""
import csv
import os

import walls
from page import table

RESULTS, TEXT = "validation/speeds.csv", "validation/speeds.md"
# Tested walls by their name in walls.csv, and examples: some rock, slide, shear, have openings, lie dry.
WALLS = ["MI1", "MI3", "PUP1", "PUP3", "COMP2_1", "J4D", "J6D", "T3", "WS.40", "examples/brick_pier", "examples/brick_portal", "tuff wall"]
SPEEDS = {"1 mm/s": ["stage.push.velocity=1 mm/s"], "5 mm/s": ["stage.push.velocity=5 mm/s"], "adapted": walls.PUSH}
COLUMNS = ["wall", "push", "peak_kN", "at_peak_mm", "first_mm", "lasting_mm", "is_bound", "mode", "judgement", "steps", "state", "build"]


def run(wythe, folder_of, out, matches):
    """Runs each wall at each speed; a row is kept as soon as it is known."""
    tests = {t["wall"]: t for t in walls.read_csv(walls.WALLS)}
    for wall in WALLS:
        test = tests.get(wall)
        model, settings = (test["model"], walls.settings_of(test)) if test else (f"{wall}/model.toml", [])
        for push, speed in SPEEDS.items():
            if not matches(f"{wall} {push}"):
                continue
            said = wythe(model, settings + speed, folder_of(os.path.join(out, "speeds"), f"{wall} {push}"))
            keep({"wall": wall, "push": push, "peak_kN": rounded(said["peak_reaction_kN"]), "at_peak_mm": rounded(said["displacement_at_peak_mm"]),
                  "first_mm": rounded(said["first_fall_80_percent_mm"]), "lasting_mm": rounded(said["displacement_at_80_percent_mm"]),
                  "is_bound": "yes" if said["censored_80"] else "", "mode": said["failure_mode"]["name"],
                  "judgement": said["quasi_static"]["judgement"], "steps": said["steps"], "state": said["state_hash"],
                  "build": said["provenance"]["commit"]})
            print(f"{wall}, {push}: {said['peak_reaction_kN']} kN", flush=True)


def rounded(value):
    return "" if value is None else f"{value:.4g}"


def keep(row):
    rows = {(r["wall"], r["push"]): r for r in walls.read_csv(RESULTS) + [row]}
    with open(RESULTS, "w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows[wall, push] for wall in WALLS for push in SPEEDS if (wall, push) in rows)


def row_of(row):
    bound = "> " if row["is_bound"] else ""
    return [row["wall"], row["push"], row["peak_kN"] or "not known", row["at_peak_mm"] or "–", bound + (row["first_mm"] or "–"),
            bound + (row["lasting_mm"] or "–"), row["mode"] or "–", row["judgement"], f"{int(row['steps']) / 1e6:.2f}"]


def write(page):
    rows = walls.read_csv(RESULTS)
    with open(TEXT, encoding="utf-8") as file:
        lines = ["# How fast may a push be?", "", "<!-- written by tools/validation page; edit validation/speeds.md instead -->", "",
                 file.read().strip(), ""]
    lines += table(["wall", "push", "peak, kN", "at, mm", "first fall to 80 %, mm", "lasting, mm", "failure", "verdict", "million steps"],
                   [row_of(row) for row in rows])
    lines += [f"Builds: {', '.join(sorted({row['build'] for row in rows}))}."]
    with open(page, "w", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")
