"""Writes docs/evidence/validation.md, its figure of predicted against measured peaks, and the table of tested ranges that the program
holds (src/judge/modes/tested_walls.h), from walls.csv and predicted.csv alone: no run is needed."""
import math
import os

import walls
from figure import COLOURS, INK, LogSquare
from page import readme_part, table

MEANING = {"shear": "crack diagonally through joints and units", "sliding": "slide along their beds",
           "rocking": "rock or crush at a toe", "mixed": "rock with sliding or cracked stones", "all": "all of them"}
COLOUR = dict(zip(walls.KINDS, [COLOURS[0], COLOURS[1], COLOURS[2], "#8a5fa8"]))
HELD, CONSTANTS, LIMITS = "src/judge/modes/tested_walls.h", "validation/drift_constants.csv", "validation/drift_limits.csv"
VERIFIED, IN_SPACE = "docs/evidence/verification.md", "validation/in_space.csv"  # what stands for walls in space
LARGE = 0.5  # scatter beyond which "delta" of formulas for small scatter is no longer a bias
FEW = 3  # walls of a kind below which its bias is an anecdote


def figure_text(value, digits=2):
    return "–" if value is None else f"{value:.{digits}f}"


def interval_text(pair):
    return "" if pair is None else f" ({pair[0]:.2f} to {pair[1]:.2f})"


def verdict_text(found):
    """What a reader may do with a prediction of this kind."""
    if found is None:
        return "nothing known"
    if found["n"] < FEW:
        return f"too few walls ({found['n']}) to rely on"
    if found["sigma_M"] > LARGE:
        return "not to be relied on"
    percent = round(100 * abs(found["delta"] - 1))
    if found["delta"] > 1.15:
        return f"on the unsafe side, too large by {percent} % on average"
    if found["delta"] < 0.9:
        return f"on the safe side, too small by {percent} % on average"
    if found["sigma_M"] > 0.2:
        return "right on average, but the scatter is large"
    low, high = found["delta_interval"]
    if high > 1.15:  # what these walls can't rule out
        return (f"right on average; {found['n']} walls can't rule out a bias of {low:.2f} or {high:.2f}, so divide by the latter "
                "where it matters")
    return "usable as it stands"


def bias_text(b):
    """delta; where the scatter is so large that the formulas for small ones mean nothing, the median ratio."""
    if b["sigma_M"] is not None and b["sigma_M"] > LARGE:
        return f"– (median ratio {b['median']:.2f})"
    return figure_text(b["delta"]) + interval_text(b["delta_interval"])


def statistic_table(found):
    rows = []
    for kind in walls.KINDS + ["all"]:
        b = found[kind]
        if b is None:
            rows.append([MEANING[kind], 0, "–", "–", "–", "nothing known"])
            continue
        sigma = figure_text(b["sigma_M"]) + interval_text(b["sigma_M_interval"]) + (" *" if b["at_floor"] else "")
        count = f"{b['n']}" + (f" + {b['censored']} bounds" if b["censored"] else "")
        rows.append([MEANING[kind], count, bias_text(b), sigma, figure_text(b["sigma_E"]),
                     "see each kind" if kind == "all" else verdict_text(b)])
    return table(["walls that", "walls", "bias δ (95 % interval)", "scatter σ_M (95 % interval)", "tests' scatter σ_E",
                  "so a prediction is"], rows)


def constants_table():
    return table(["kind", "masonry", "tests", "median drift, %", "nine of ten, %", "sd of ln", "source"],
                 [[row["kind"], row["masonry"], row["walls"], row["median_percent"], f"{row['low_percent']} to {row['high_percent']}", row["log_scatter"],
                   row["source"]] for row in walls.read_csv(CONSTANTS)])


def limits_table():
    return table(["code", "clause", "limit state", "pier in", "drift", "the figure is"],
                 [[row["code"], row["clause"], row["limit_state"], row["kind"], row["limit"], row["known"]] for row in walls.read_csv(LIMITS)])


def bound_text(value, is_bound, unit="", digits=3):
    return ("> " if is_bound else "") + f"{value:.{digits}g}{unit}"


def verified():
    """(case, what) -> (reference, computed, deviation) of docs/evidence/verification.md, as the tests wrote it."""
    found = {}
    for line in open(VERIFIED, encoding="utf-8"):
        cells = [cell.strip() for cell in line.split("|")[1:-1]]
        if len(cells) == 7 and cells[0] not in ("case", "---"):
            found[cells[0], cells[1]] = cells[2], cells[3], cells[4]
    return found


def shortened(value):
    """"4729.556 Pa" -> "4730 Pa": four digits are enough to compare."""
    number, _, unit = value.partition(" ")
    digits = f"{float(number):.4g}" if abs(float(number)) < 1e4 else f"{float(number):.0f}"
    return f"{digits} {unit}".strip()


def space_table():
    """Walls in space against what is known of them: rows of validation/in_space.csv, figures of docs/evidence/verification.md. `bracket`: the
    test says that it stands below and falls above, and no figure of its own."""
    known, rows = verified(), []
    for row in walls.read_csv(IN_SPACE):
        if (row["case"], row["row"]) not in known:
            raise KeyError(f"{IN_SPACE}: docs/evidence/verification.md has no row {row['case']}, {row['row']}; run the tests and "
                           "tools/verification_table, or correct the row")
        reference, ours, deviation = known[row["case"], row["row"]]
        percent = 100 * float(deviation.split()[0])
        difference = f"{percent:+.1f} %" if abs(percent) >= 0.05 else "below 0.1 %"
        rows.append([row["what"], row["reference"], shortened(reference), row["bracket"] or shortened(ours),
                     "within 3 %" if row["bracket"] else difference, row["case"]])
    return table(["what was run", "reference", "its value", "ours", "difference", "test"], rows)


def wall_rows(name):
    answers = walls.predicted(name)
    rows = []
    for test in walls.read_csv(walls.WALLS):
        answer = answers.get(test["wall"])
        ratio = walls.peak_ratio(test, answer)
        told = walls.measured_drift(test)
        drift = float(answer["at_80_mm"]) / 10 / float(test["drift_height_m"]) if answer and answer["at_80_mm"] else None
        rows.append([
            test["test"], test["published_failure"], test["peaks_kN"].replace(" ", ", "),
            "not run" if answer is None else bound_text(float(answer["peak_kN"]), answer["peak_is_bound"] == "yes", digits=4)
            if answer["peak_kN"] else "not known", figure_text(ratio),
            "–" if answer is None else answer["mode"] or "–", "–" if told is None else bound_text(*told),
            "–" if drift is None else bound_text(drift, answer["is_bound"] == "yes"),
            "–" if answer is None else answer["judgement"], "no" if walls.left_out(test) else "yes", test["source"]])
    return rows


def wall_table(name="base"):
    return table(["test", "failed in the test by", "measured peaks, kN", "predicted, kN", "ratio", "predicted failure",
                  "measured drift at 80 %, %", "predicted, %", "push", "counts", "source"], wall_rows(name))


def left_out_lines(tests):
    all_too = walls.statistics(everything=True)["peak"]
    told = "; ".join(f"{kind} {bias_text(all_too[kind])}" for kind in ("shear", "rocking", "all") if all_too[kind])
    return [f"- **{t['test']}**: {walls.left_out(t)}." for t in tests if walls.left_out(t)] + [
        "", f"If the measured peaks among them counted, δ would be: {told}.", ""]


def kinds_agree(tests, answers):
    pairs = [(t["kind"], walls.kind_of_mode(answers[t["wall"]]["mode"])) for t in tests if t["wall"] in answers]
    return sum(a == b or a == "mixed" for a, b in pairs), len(pairs)


def settings_table(name):
    """How the peaks move with another set of settings. Walls that it leaves as they are, to the bit, are only counted."""
    beside = walls.BESIDE.get(name, "base")
    base, other = walls.predicted(beside), walls.predicted(name, alone=True)
    rows = [[wall, base[wall]["peak_kN"] or "–", other[wall]["peak_kN"] or "–",
             f"{100 * (float(other[wall]['peak_kN']) / float(base[wall]['peak_kN']) - 1):+.1f}"
             if base[wall]["peak_kN"] and other[wall]["peak_kN"] else "–", other[wall]["mode"]]
            for wall in base if wall in other and other[wall]["state"] != base[wall]["state"]]
    same = sum(wall in other and other[wall]["state"] == base[wall]["state"] for wall in base)
    if not rows:
        return []
    found = walls.statistics(name)["peak"]
    told = [f"{kind}: δ {figure_text(found[kind]['delta'])}, σ_M {figure_text(found[kind]['sigma_M'])}"
            for kind in walls.KINDS + ["all"] if found[kind]]
    return [f"### {name}" + (f", against {beside}" if beside != "base" else ""), "", "; ".join(told) + "."
            + (f" {same} more walls end in the same state." if same else ""), ""] + table(["wall", "peak, kN", f"{name}, kN", "change, %", "failure"], rows)


def draw(figures, found):
    """Predicted against measured peaks with the bands of the tests' scatter and of the model's about its bias."""
    figure = LogSquare("measured peak (kN)", "predicted peak (kN)", 10, 1000)
    everything = found["all"]
    if everything and everything["sigma_M"] is not None:
        figure.band(everything["delta"] * math.exp(-2 * everything["sigma_M"]), everything["delta"] * math.exp(2 * everything["sigma_M"]),
                    "#b5442a", "model: δ and ± 2 σ_M, all kinds")
        figure.ray(everything["delta"], "#b5442a", "5 4")
    figure.band(math.exp(-2 * found["sigma_E"]), math.exp(2 * found["sigma_E"]), "#333", "tests: ± 2 σ_E")
    figure.ray(1, INK)
    answers = walls.predicted()
    for test in walls.read_csv(walls.WALLS):
        answer = answers.get(test["wall"])
        if walls.peak_ratio(test, answer) is None:
            continue
        figure.point(walls.measured_peak(test), float(answer["peak_kN"]), COLOUR[test["kind"]], not walls.left_out(test), test["test"])
    for kind in walls.KINDS:
        figure.key(COLOUR[kind], MEANING[kind])
    figure.key(INK, "hollow: does not count", hollow=True)
    with open(os.path.join(figures, "validation_peaks.svg"), "w", encoding="utf-8") as file:
        file.write(figure.svg())


def draw_drifts(figures):
    """Predicted against measured drifts at 80 % of the peak; hollow where either is a bound or the test does not count."""
    figure = LogSquare("measured drift (%)", "predicted drift (%)", 0.02, 5, "%")
    figure.ray(1, INK)
    answers = walls.predicted()
    for test in walls.read_csv(walls.WALLS):
        answer, told = answers.get(test["wall"]), walls.measured_drift(test)
        if told is None or not answer or not answer["at_80_mm"]:
            continue
        drift = float(answer["at_80_mm"]) / 10 / float(test["drift_height_m"])
        known = not walls.left_out(test) and answer["is_bound"] != "yes" and not told[1]
        figure.point(told[0], drift, COLOUR[test["kind"]], known, test["test"])
    for kind in walls.KINDS:
        figure.key(COLOUR[kind], MEANING[kind])
    figure.key(INK, "hollow: a bound, or does not count", hollow=True)
    with open(os.path.join(figures, "validation_drifts.svg"), "w", encoding="utf-8") as file:
        file.write(figure.svg())


def tested_kinds(found):
    """[(kind, walls, bias, low, high, scatter, slenderness low, high, axial ratio low, high)] of the walls that count."""
    rows = []
    for kind in ("shear", "sliding", "rocking"):
        tests = [t for t in walls.read_csv(walls.WALLS) if t["kind"] == kind and not walls.left_out(t)]
        b = found["peak"][kind] or {"n": 0, "delta": None, "delta_interval": None, "sigma_M": None}
        slender = [float(t["height_m"]) / float(t["length_m"]) for t in tests]
        axial = [(float(t["top_load_kN"]) + float(t["weight_kN"])) / 1e3 / float(t["length_m"]) / float(t["thickness_m"])
                 / float(t["fm_MPa"]) for t in tests if t["fm_MPa"]]
        rows.append((kind, b["n"], b["delta"], *(b["delta_interval"] or (None, None)), b["sigma_M"], min(slender), max(slender),
                     min(axial), max(axial)))
    return rows


def own_drifts(found):
    """[(kind, walls, middle ratio, factor of scatter)] of predicted over measured drifts; bounds are in the statistic."""
    rows = []
    for kind in ("shear", "rocking", "mixed"):
        b = found["drift"][kind]
        known = b is not None and b["sigma_M"] is not None
        rows.append((kind, b["n"] + b["censored"] if known else 0, b["median"] if known else None,
                     math.exp(math.hypot(b["sigma_M"], b["sigma_E"])) if known else None))
    return rows


def header(found):
    """The table as the program holds it."""
    def number(value):
        return "kUnset" if value is None else f"{value:.3g}"
    lines = ["// Written by tools/validation page from validation/walls.csv and predicted.csv:",
             "// results of the tested walls by failure kind (docs/evidence/validation.md).", "#pragma once", "", '#include "wythe/parts/result.h"', "", "namespace wythe::study {", "",
             "struct TestedKind {", "  const char* kind;", "  int walls;",
             "  double bias, bias_low, bias_high, scatter;  // of predicted over measured peaks",
             "  double slender_low, slender_high;           // height over length of the walls",
             "  double axial_low, axial_high;               // pressure at the base over compressive strength", "};",
             "// clang-format off", "inline constexpr TestedKind kTestedKinds[] = {"]
    lines += [f'    {{"{kind}", {n}, {", ".join(map(number, rest))}}},' for kind, n, *rest in tested_kinds(found)]
    lines[-1] = lines[-1][:-1] + "};"
    lines += ["", "// Drift at which walls of a kind have lost 20 % of their peak [-]: validation/drift_constants.csv.",
              "struct TestedDriftKind {", "  const char* kind;", "  bool stone;", "  int walls;",
              "  double median, low, high;  // low to high contains nine of ten walls", "};",
              "inline constexpr TestedDriftKind kTestedDrifts[] = {"]
    lines += [f'    {{"{row["kind"]}", {"true" if row["masonry"] == "stone" else "false"}, {row["walls"]}, '
              + ", ".join(f"{float(row[key + '_percent']) / 100:.4g}" for key in ("median", "low", "high")) + "},"
              for row in walls.read_csv(CONSTANTS)]
    lines[-1] = lines[-1][:-1] + "};"
    lines += ["", "// Predicted over measured drifts by kind: median ratio, and exp(sd of ln) about it.",
              "struct OwnDrift {", "  const char* kind;", "  int walls;", "  double ratio, factor;", "};",
              "inline constexpr OwnDrift kOwnDrifts[] = {"]
    lines += [f'    {{"{kind}", {n}, {number(ratio)}, {number(factor)}}},' for kind, n, ratio, factor in own_drifts(found)]
    lines[-1] = lines[-1][:-1] + "};"
    lines.append("// clang-format on")
    return "\n".join(lines + ["", "}  // namespace wythe::study", ""])


def first_lines(peak, drift, ensemble):
    def told(b):
        large = b["sigma_M"] is not None and b["sigma_M"] > LARGE
        ratio = f"the median ratio of predicted to measured is {b['median']:.2f}" if large else f"the ratio of predicted to measured is {bias_text(b)}"
        return f"{ratio}, its scatter {figure_text(b['sigma_M'])}"
    lines = []
    for kind, called in (("shear", "Peak force of walls that fail in shear"), ("rocking", "Peak force of walls that rock")):
        if peak[kind]:
            lines.append(f"**{called}** ({peak[kind]['n']} walls): {verdict_text(peak[kind])}. T{told(peak[kind])[1:]}.")
    if peak["all"]:
        lines.append(f"**Peak force of all walls** ({peak['all']['n']}): {told(peak['all'])}.")
    if drift["all"]:
        lines.append(f"**Drift at 80 % of the peak** ({drift['all']['n']} walls, {drift['all']['censored']} more as bounds): "
                     f"{verdict_text(drift['all'])}. T{told(drift['all'])[1:]}.")
    for kind, called in (("shear", "walls that fail in shear"), ("mixed", "walls that flex or rock and crack")):
        b = ensemble[kind]
        if b:
            lines.append(f"**The same, median of eight walls, {called}** ({b['n']} walls, {b['censored']} more as bounds): "
                         f"{verdict_text(b)}. T{told(b)[1:]}.")
    return [line + "\n" for line in lines]


def write(page, held=HELD):
    figures = os.path.join(os.path.dirname(page), "figures")
    tests, answers = walls.read_csv(walls.WALLS), walls.predicted()
    found = walls.statistics()
    (scatter, pairs), (drift_scatter, drift_pairs) = walls.test_scatter(tests)
    draw(figures, {"sigma_E": scatter, "all": found["peak"]["all"]})
    agree, named = kinds_agree(tests, answers)
    builds = sorted({row["build"] for row in answers.values()})
    lines = ["# Validation: for which walls the program is reliable", "",
             "<!-- written by tools/validation page; edit validation/ instead -->", ""]
    eight = walls.statistics("eight walls")
    lines += first_lines(found["peak"], found["drift"], eight["drift"])
    lines += [readme_part(".", "Range"), "", "![predicted against measured peaks](figures/validation_peaks.svg)", "",
              "## Peak force", ""] + statistic_table(found["peak"])
    draw_drifts(figures)
    lines += ["## Drift where the force has fallen to 80 % of the peak", "", "![predicted against measured drifts](figures/validation_drifts.svg)", ""]
    lines += ["One wall of mean values:", ""] + statistic_table(found["drift"])
    lines += ["Medians of eight walls whose strengths scatter:", ""] + statistic_table(eight["drift"])
    lines += ["A constant for each kind can replace a computed drift. These are drifts of tests (validation/drift_constants.csv):", ""]
    lines += constants_table() + [readme_part(".", "Limits"), ""] + limits_table()
    lines += ["\\* The scatter equals that of the tests; these data cannot show a smaller one.", "",
              readme_part(".", "Reading"), "",
              f"Here σ_E of peaks is {scatter:.2f}, from {pairs} walls that were tested twice. For drifts it is {drift_scatter:.2f}, from replicates of "
              f"brick and block walls with the same failure ({drift_pairs} degrees of freedom).", "", "## Wall by wall", ""]
    lines += wall_table() + [f"The predicted kind of failure is that of the test in {agree} of {named} tests. Builds: {', '.join(builds)}.", "",
                             "Not counted:", ""] + left_out_lines(tests)
    lines += [readme_part(".", "Rules"), "", "### What was changed after a result had been seen", "",
              readme_part(".", "Changes").split("\n", 2)[2], "", "## What a setting moves", ""]
    for name in list(walls.SETS)[1:]:
        lines += settings_table(name)
    lines += ["## Walls in space", "", readme_part(".", "In space"), ""] + space_table()
    lines += ["## Misses", "", readme_part(".", "Misses"), "", readme_part(".", "Further"), ""]
    with open(page, "w", encoding="utf-8") as file:
        file.write("\n".join(lines).rstrip() + "\n")
    with open(held, "w", encoding="utf-8") as file:
        file.write(header(found))
