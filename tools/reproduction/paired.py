"""What each changed choice moves: the runs of tools/paired_samples against their base; values of page.md by name."""
import importlib.machinery
import importlib.util
import math
import pathlib
import random
import statistics

import charts
from campaign import D, F, GROUPS, samples_of
from causes import cov, mean_of
from compare import NO, table
from paper import SHARES, TABLE_3

NOT_RUN = "(not run yet)"
EXAMPLE = "lintel: as examples/tuff_wall: timber, loose"  # the row that has the campaign's own choices
# two-sided 95 % quantiles of Student's t for n - 1 degrees of freedom: shares of groups of modes and bases other than
# the first row are in no comparison.json
STUDENT = {5: 2.571, 7: 2.365, 11: 2.201, 15: 2.131, 23: 2.069, 31: 2.040, 47: 2.012, 63: 1.998}
PAPER = {(q, kind): TABLE_3[q][kind][5] for q in (F, D) for kind in ("mean", "cov")}


class Paired:
    """The campaigns of `tools/paired_samples run` that are finished, by "group: variant"; the first is the base."""

    def __init__(self, folder, campaign):
        path = pathlib.Path(__file__).parent.with_name("paired_samples")
        loader = importlib.machinery.SourceFileLoader("paired_samples", str(path))
        self.tool = importlib.util.module_from_spec(importlib.util.spec_from_loader("paired_samples", loader))
        loader.exec_module(self.tool)
        first = self.tool.VARIANTS[0][:2]
        files = {f"{g}: {v}": pathlib.Path(folder) / ("base" if (g, v) == first else self.tool.slug(g, v)) / "samples.csv"
                 for g, v, _ in self.tool.VARIANTS}
        self.names, self.campaign = list(files), campaign
        self.runs = {name: samples_of(path) for name, path in files.items() if path.exists()}
        self.base = self.runs.get(self.names[0])
        self.changed = [n for n in self.names[1:] if n in self.runs and self.base]
        self.missing = [n for n in self.names if n not in self.runs]

    def change(self, name, value, base=None):
        """Mean of value(sample) over the same samples less that of the base, and its 95 % half-width (Student)."""
        base = base or self.base
        common = sorted(set(self.runs[name]) & set(base))
        gaps = [value(self.runs[name][k]) - value(base[k]) for k in common]
        if not any(gaps):
            return 0.0, 0.0
        t = STUDENT.get(len(gaps) - 1, 2.0)
        return statistics.mean(gaps), t * statistics.stdev(gaps) / math.sqrt(len(gaps))

    def effect(self, name, q, kind):
        """Change of the mean, or of the CoV: that one's half-width by drawing the pairs again (bootstrap)."""
        if kind == "mean":
            return self.change(name, lambda s: s[q])
        common = sorted(set(self.runs[name]) & set(self.base))

        def gap(keys):
            return cov(self.runs[name][k][q] for k in keys) - cov(self.base[k][q] for k in keys)
        source = random.Random(1)
        return gap(common), 1.96 * statistics.stdev(gap(source.choices(common, k=len(common))) for _ in range(500))

    def ours(self, q, kind):
        """What the campaign's value is with the base's choices, as the paired samples show it."""
        shift = self.effect(EXAMPLE, q, kind)[0] if EXAMPLE in self.runs else 0.0
        return self.campaign.table("all", q)[kind] - shift

    def our_share(self, group):
        share = self.campaign.statistics["shares"].get(group, {"share": 0.0})["share"]
        return 100 * share - (self.change(EXAMPLE, share_of(group))[0] if EXAMPLE in self.runs else 0.0)

    def of_campaign(self, name, q):
        """What all samples of the campaign would give with this row's choices: its mean and 95 % half-width."""
        t = self.campaign.table("all", q)
        value, half = self.change(name, lambda s: s[q], self.runs.get(EXAMPLE))
        return f"{t['mean'] + value:.1f} ± {math.hypot(half, (t['mean_interval'][1] - t['mean_interval'][0]) / 2):.1f}"


def share_of(group):
    return lambda s: 100.0 * (s["mode"] in GROUPS[group])


def summary(paired):
    """For each quantity what it lacks to the paper's, and the changes that surely move it, either way."""
    asked = [(what, digits, PAPER[q, kind] - paired.ours(q, kind), lambda name, q=q, kind=kind: paired.effect(name, q, kind))
             for what, digits, q, kind in (("mean F max [kN]", 1, F, "mean"), ("CoV of F max", 3, F, "cov"),
                                           ("mean D [mm]", 1, D, "mean"), ("CoV of D", 2, D, "cov"))]
    for group in GROUPS:
        asked.append((f"share of {group} [%]", 0, 100 * SHARES[group] - paired.our_share(group),
                      lambda name, group=group: paired.change(name, share_of(group))))
    rows, tally = [], {name: [0, 0] for name in paired.changed}
    for what, digits, need, effect in asked:
        sides = [[], []]
        for name in paired.changed:
            value, half = effect(name)
            if abs(value) > half:
                away = value * need < 0
                tally[name][away] += 1
                sides[away].append((abs(value), f"{name} {value:+.{digits}f}"))
        said = ["; ".join(words for _, words in sorted(side, reverse=True)) or NO for side in sides]
        rows.append([what, f"{need:+.{digits}f}", *said])
    several = sorted((n for n in tally if tally[n][0] > 1), key=lambda n: (tally[n][1] - tally[n][0], n))
    counted = "; ".join(f"{n} ({tally[n][0]} towards, {tally[n][1]} away)" for n in several)
    return {"what moves what": table(["", "needed", "towards the paper", "away from it"], rows),
            "towards in several": counted or "none so far"}


def variants(paired):
    rows = []
    for name in [paired.names[0]] + paired.changed:
        run, cells = paired.runs[name], []
        for q, digits in ((F, 3), (D, 2)):
            scatter = f"{cov(s[q] for s in run.values()):.{digits}f}"
            if name == paired.names[0]:
                cells += [mean_of(list(run.values()), q), paired.of_campaign(name, q), scatter]
                continue
            (value, half), (gap, spread) = paired.effect(name, q, "mean"), paired.effect(name, q, "cov")
            cells += [f"{value:+.1f} ± {half:.1f}", paired.of_campaign(name, q),
                      f"{scatter} ({gap:+.{digits}f} ± {spread:.{digits}f})"]
        shares = " / ".join(f"{statistics.mean(share_of(g)(s) for s in run.values()):.0f}" for g in GROUPS)
        same = sum(run[k]["mode"] == paired.base[k]["mode"] for k in run if k in paired.base)
        rows.append([name, *cells, shares, f"{same} of {len(run)}"])
    said = [f"{PAPER[key]:g}" for key in ((F, "mean"), (F, "cov"), (D, "mean"), (D, "cov"))]
    rows.append(["**paper**", "", *said[:2], "", *said[2:], " / ".join(f"{100 * s:.0f}" for s in SHARES.values()), ""])
    head = ["change", "F max kN", "of 250, kN", "CoV", "D mm", "of 250, mm", "CoV", "FM-1+2 / 3+4 / 5 %", "same name"]
    return table(head, rows)


def order(paired):
    """Does a change turn the order of the modes?"""
    rows = []
    for name in [paired.names[0]] + paired.changed:
        groups = [[s for s in paired.runs[name].values() if s["mode"] in members] for members in GROUPS.values()]
        rows.append([name, *(f"{mean_of(c, column, digits)} ({len(c)})" if c else NO
                             for column, digits in (("ft_j_MPa", 3), (D, 1)) for c in groups)])
    rows.append(["**paper**", "low", "high", "highest", "16 to 18", "36 to 42", "43"])
    return table(["change", "ft,j of FM-1+2 MPa", "of FM-3+4", "of FM-5", "D of FM-1+2 mm", "of FM-3+4", "of FM-5"], rows)


def turned(paired):
    """In how many runs, the base's too, piers fail with weaker joints, or at smaller D, than the spandrel does."""
    found = {}
    for column, key in (("ft_j_MPa", "turned ft_j"), (D, "turned D")):
        count = 0
        for run in paired.runs.values():
            piers, spandrel = ([s[column] for s in run.values() if s["mode"] in members]
                               for members in list(GROUPS.values())[:2])
            count += bool(piers and spandrel) and statistics.mean(piers) < statistics.mean(spandrel)
        found[key] = f"{count or 'none'} of {len(paired.runs)}"
    return found


def effects(page, paired):
    panels = []
    for q, title in ((F, "change of mean F max [kN]"), (D, "change of mean D at 0.8 F max [mm]")):
        found = [paired.effect(name, q, "mean") for name in paired.changed]
        need = PAPER[q, "mean"] - paired.ours(q, "mean")
        ends = [v for value, half in found for v in (value - half, value + half)] + [0, need]
        labels = [n.replace(" (the paper's setting)", "") for n in paired.changed]
        panel = charts.Panel(title, charts.padded(ends), None, rows=labels, width=620, height=84 + 22 * len(found), left=290)
        for x, colour, dash in ((0, charts.SOFT, ""), (need, charts.COLOUR["paper"], "6 4")):
            panel.line([(x, -0.5), (x, len(found) - 0.5)], colour, 1.4, dash)
        for i, (value, half) in enumerate(found):
            sure = charts.COLOUR["FM-3"] if abs(value) > half else charts.COLOUR["unclear"]
            panel.estimate(i, value, (value - half, value + half), sure, level=True)
        panels.append(panel)
    return page.figure("paired_effects", "What each changed choice moves, and what the paper would need (dashed)", panels, 2)


def values(page, paired):
    """Tables, and single effects as `paired VARIANT | F`, `| D`, `| CoV F`, `| CoV D`."""
    found = {f"paired {name} | {what}": NOT_RUN for name in paired.names for what in ("F", "D", "CoV F", "CoV D")}
    for name in paired.changed:
        for short, q, unit, digits in (("F", F, "kN", 3), ("D", D, "mm", 2)):
            (value, half), (gap, spread) = paired.effect(name, q, "mean"), paired.effect(name, q, "cov")
            found[f"paired {name} | {short}"] = f"{value:+.1f} ± {half:.1f} {unit}"
            found[f"paired {name} | CoV {short}"] = f"{gap:+.{digits}f} ± {spread:.{digits}f}"
    found["not run"] = "Not run yet: " + "; ".join(paired.missing) + "." if paired.missing else "All variants have run."
    found["n paired"] = str(len(paired.base or []))
    if not paired.changed:
        return found | dict.fromkeys(("what moves what", "towards in several", "figure of effects", "table of variants",
                                      "table of order", "turned ft_j", "turned D"), NO)
    return found | summary(paired) | {"figure of effects": effects(page, paired), "table of variants": variants(paired),
                                      "table of order": order(paired)} | turned(paired)
