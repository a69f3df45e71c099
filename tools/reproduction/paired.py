"""What each changed choice moves: the runs of tools/paired_samples against their base; values of page.md by name."""
import importlib.machinery
import importlib.util
import json
import math
import pathlib
import statistics
import subprocess
import tempfile

import charts
from campaign import D, F, GROUPS, samples_of
from causes import cov, mean_of
from compare import NO, table
from paper import SHARES, TABLE_3

NOT_RUN, NOT_KNOWN = "(not run yet)", "not known"
BASE = "base"  # what the program calls it
EXAMPLE = "lintel: as examples/tuff_wall: timber, loose"  # the row that has the campaign's own choices
PAPER = {(q, kind): TABLE_3[q][kind][5] for q in (F, D) for kind in ("mean", "cov")}


def compared(binary, folders):
    """What `wythe compare` says of these campaigns, the first the base: options by name."""
    with tempfile.TemporaryDirectory() as out:
        subprocess.run([binary, "compare", *map(str, folders), "--out", out], check=True, stdout=subprocess.DEVNULL)
        return options_of(pathlib.Path(out))


def options_of(folder):
    comparison = json.loads((folder / "comparison.json").read_text(encoding="utf-8"))
    return {option["name"]: option for option in comparison["option"] if option["pairs"]}


def half(interval):
    return (interval[1] - interval[0]) / 2


def difference(option, q):
    """Mean of the pairs' differences and its 95 % half-width; None where the pairs don't tell it."""
    found = option["response"][q]
    if found["difference"] is None or found["difference_interval"][0] is None:
        return None
    return found["difference"], half(found["difference_interval"])


def cov_change(option, q):
    found = option["response"][q]
    if None in (found["cov_base"], found["cov_option"], *found["cov_ratio_interval"]):
        return None
    return found["cov_option"] - found["cov_base"], found["cov_base"] * half(found["cov_ratio_interval"])


def share_change(option, group):
    """Of the pairs named on both sides [%]; None where the comparison does not take modes together."""
    if "group_shift" not in option["modes"]:
        return None
    for shift in option["modes"]["group_shift"]:
        if shift["mode"] == group:
            gap, interval = shift["share_difference"], shift.get("share_difference_interval")
            return None if gap is None else (100 * gap, 100 * half(interval))
    return 0.0, 0.0  # no wall fails so on either side


def shown(change, digits, unit=""):
    return NOT_KNOWN if change is None else f"{change[0]:+.{digits}f} ± {change[1]:.{digits}f}{unit}"


class Paired:
    """What `tools/paired_samples run` left in `folder`: its comparison, by "group: variant"; the first is the base."""

    def __init__(self, folder, campaign, binary):
        path = pathlib.Path(__file__).parent.with_name("paired_samples")
        loader = importlib.machinery.SourceFileLoader("paired_samples", str(path))
        tool = importlib.util.module_from_spec(importlib.util.spec_from_loader("paired_samples", loader))
        loader.exec_module(tool)
        folder = pathlib.Path(folder)
        self.names = [tool.name_of(group, variant) for group, variant, _ in tool.VARIANTS]
        self.campaign = campaign
        self.option = options_of(folder) if (folder / "comparison.json").exists() else {}
        self.changed = [name for name in self.names[1:] if name in self.option]
        self.missing = [name for name in self.names[1:] if name not in self.option] if self.option else self.names
        self.folder = {self.names[0]: folder / BASE} | {name: folder / self.option[name]["folder"] for name in self.changed}
        self.runs = {name: samples_of(self.folder[name] / "samples.csv") for name in self.folder} if self.changed else {}
        self.from_example = {}
        if EXAMPLE in self.changed:
            others = [path for name, path in self.folder.items() if name != EXAMPLE]
            self.from_example = compared(binary, [self.folder[EXAMPLE], *others])

    def effect(self, name, q, kind):
        return (difference if kind == "mean" else cov_change)(self.option[name], q)

    def ours(self, q, kind):
        """What the campaign's value is with the base's choices, as the paired samples show it; None where they don't."""
        ours = self.campaign.table("all", q)[kind]
        if EXAMPLE not in self.changed:
            return ours
        shift = self.effect(EXAMPLE, q, kind)
        return None if shift is None or ours is None else ours - shift[0]

    def our_share(self, group):
        share = self.campaign.statistics["shares"].get(group, {"share": 0.0})["share"]
        if EXAMPLE not in self.changed:
            return 100 * share
        change = share_change(self.option[EXAMPLE], group)
        return None if change is None else 100 * share - change[0]

    def of_campaign(self, name, q):
        """What all samples of the campaign would give with this row's choices: its mean and 95 % half-width."""
        t = self.campaign.table("all", q)
        option = self.from_example.get(BASE if name == self.names[0] else name)
        change = (0.0, 0.0) if name == EXAMPLE else difference(option, q) if option else None
        if change is None or None in t["mean_interval"]:
            return NOT_KNOWN
        return f"{t['mean'] + change[0]:.1f} ± {math.hypot(change[1], half(t['mean_interval'])):.1f}"


def share_of(group):
    return lambda s: 100.0 * (s["mode"] in GROUPS[group])


def needed(paired, q, kind):
    ours = paired.ours(q, kind)
    return None if ours is None else PAPER[q, kind] - ours


def summary(paired):
    """For each quantity what it lacks to the paper's, and the changes that surely move it, either way."""
    asked = [(what, digits, needed(paired, q, kind), lambda name, q=q, kind=kind: paired.effect(name, q, kind))
             for what, digits, q, kind in (("mean F max [kN]", 1, F, "mean"), ("CoV of F max", 3, F, "cov"),
                                           ("mean D [mm]", 1, D, "mean"), ("CoV of D", 2, D, "cov"))]
    for group in GROUPS:
        share = paired.our_share(group)
        asked.append((f"share of {group} [%]", 0, None if share is None else 100 * SHARES[group] - share,
                      lambda name, group=group: share_change(paired.option[name], group)))
    rows, tally = [], {name: [0, 0] for name in paired.changed}
    for what, digits, need, effect in asked:
        sides = [[], []]
        for name in paired.changed:
            value, width = effect(name) or (0.0, 0.0)
            if need is not None and abs(value) > width:
                away = value * need < 0
                tally[name][away] += 1
                sides[away].append((abs(value), f"{name} {value:+.{digits}f}"))
        said = ["; ".join(words for _, words in sorted(side, reverse=True)) or NO for side in sides]
        rows.append([what, NOT_KNOWN if need is None else f"{need:+.{digits}f}", *said])
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
            cells += [shown(paired.effect(name, q, "mean"), 1), paired.of_campaign(name, q),
                      f"{scatter} ({shown(paired.effect(name, q, 'cov'), digits)})"]
        shares = " / ".join(f"{statistics.mean(share_of(g)(s) for s in run.values()):.0f}" for g in GROUPS)
        modes = paired.option[name]["modes"] if name in paired.option else None
        same = f"{modes['pairs'] - modes['unclear'] - len(modes['changed'])} of {modes['pairs']}" if modes else ""
        rows.append([name, *cells, shares, same])
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
        found = [(name, *effect) for name in paired.changed if (effect := paired.effect(name, q, "mean"))]
        need = needed(paired, q, "mean")
        ends = [v for _, value, width in found for v in (value - width, value + width)] + [0, need or 0]
        labels = [name.replace(" (the paper's setting)", "") for name, _, _ in found]
        panel = charts.Panel(title, charts.padded(ends), None, rows=labels, width=620, height=84 + 22 * len(found), left=290)
        for x, colour, dash in ((0, charts.SOFT, ""), (need, charts.COLOUR["paper"], "6 4")):
            if x is not None:
                panel.line([(x, -0.5), (x, len(found) - 0.5)], colour, 1.4, dash)
        for i, (_, value, width) in enumerate(found):
            sure = charts.COLOUR["FM-3"] if abs(value) > width else charts.COLOUR["unclear"]
            panel.estimate(i, value, (value - width, value + width), sure, level=True)
        panels.append(panel)
    return page.figure("paired_effects", "What each changed choice moves, and what the paper would need (dashed)", panels, 2)


def values(page, paired):
    """Tables, and single effects as `paired VARIANT | F`, `| D`, `| CoV F`, `| CoV D`."""
    found = {f"paired {name} | {what}": NOT_RUN for name in paired.names for what in ("F", "D", "CoV F", "CoV D")}
    for name in paired.changed:
        for short, q, unit, digits in (("F", F, "kN", 3), ("D", D, "mm", 2)):
            found[f"paired {name} | {short}"] = shown(paired.effect(name, q, "mean"), 1, f" {unit}")
            found[f"paired {name} | CoV {short}"] = shown(paired.effect(name, q, "cov"), digits)
    found["not run"] = "Not run yet: " + "; ".join(paired.missing) + "." if paired.missing else "All variants have run."
    found["n paired"] = str(len(paired.runs.get(paired.names[0], [])))
    if not paired.changed:
        return found | dict.fromkeys(("what moves what", "towards in several", "figure of effects", "table of variants",
                                      "table of order", "turned ft_j", "turned D"), NO)
    return found | summary(paired) | {"figure of effects": effects(page, paired), "table of variants": variants(paired),
                                      "table of order": order(paired)} | turned(paired)
