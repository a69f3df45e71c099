"""What stands for tables and figures of the paper: for each, values of the template page.md by name."""
import math
import os
import pathlib
import statistics

import charts
import paper
from campaign import D, D_MAX, F, GROUPS, INPUTS, MODES
from paper import N, SHARES, TABLE_2, TABLE_3, pearson, pearson_interval

NO, INSIDE, OUTSIDE, FEW = "–", "inside", "**outside**", "too few samples"
SYMBOL = {F: "F max", D: "D at 0.8 F max"}
GROUPS_OF_ALL = MODES + ["all"]


def table(head, rows):
    return "\n".join(f"| {' | '.join(map(str, row))} |" for row in (head, ["---"] * len(head), *rows))


def between(low, high, digits):
    return f"{low:.{digits}f} to {high:.{digits}f}"


def two(value):
    """Two digits without a negative zero."""
    return f"{round(value, 2) + 0.0:.2f}"


class Page:
    """What the sections share: the campaign, the verdicts so far, the folder of figures."""

    def __init__(self, campaign, page, figures):
        self.campaign, self.verdicts = campaign, []
        self.folder = pathlib.Path(figures)
        self.folder.mkdir(parents=True, exist_ok=True)
        self.link = os.path.relpath(figures, pathlib.Path(page).parent)

    def figure(self, name, words, panels, columns=1, key=()):
        return self.picture(name, words, charts.figure(panels, columns, key))

    def picture(self, name, words, svg):
        (self.folder / f"{name}.svg").write_text(svg, encoding="utf-8")
        return f"![{words}]({self.link}/{name}.svg)"

    def verdict(self, topic, what, inside):
        word = FEW if inside is None else INSIDE if inside else OUTSIDE
        self.verdicts.append((topic, what, word))
        return word

    def row(self, topic, what, ours, interval, said, around, digits, scale=1):
        """Cells beside each other: the paper's, ours, the difference, the verdict; `what` may carry a remark in brackets."""
        printed, name = f"{round(said * scale, 1 if scale == 100 else 6):g}", what.split(" (")[0]
        if ours is None or None in interval:
            return [what, printed, NO if ours is None else f"{ours * scale:.{digits}f}", NO, self.verdict(topic, name, None)]
        gap, (low, high) = paper.difference(ours, interval, said, around)
        low, high = low * scale, high * scale
        return [what, printed, f"{ours * scale:.{digits}f} ({between(*(v * scale for v in interval), digits)})",
                f"{gap * scale:+.{digits}f} ({low:+.{digits}f} to {high:+.{digits}f})", self.verdict(topic, name, low <= 0 <= high)]

    def of(self, word, topic=None):
        return [what for t, what, w in self.verdicts if w == word and topic in (None, t)]


def beside(title, found, width=460):
    """A chart of ours and the paper's by name, each with its interval."""
    values = [v for _, ours, interval, said, around in found for v in (ours, *interval, said, *around) if v is not None]
    panel = charts.Panel(title, None, charts.padded(values), names=[name for name, *_ in found], width=width)
    for i, (name, ours, interval, said, around) in enumerate(found):
        if said is not None:
            panel.estimate(i - 0.14, said, around, charts.COLOUR["paper"], hollow=True)
        if ours is not None:
            panel.estimate(i + 0.14, ours, interval, charts.colour_of(name))
    return panel


def density(kind, mean, cov):
    if kind == "normal":
        return statistics.NormalDist(mean, cov * mean).pdf
    variance = math.log(1 + cov * cov)
    logs = statistics.NormalDist(math.log(mean) - variance / 2, math.sqrt(variance))
    return lambda x: logs.pdf(math.log(x)) / x


def histogram(values, symbol, unit, kind, mean, cov):
    low, high = min(values), max(values)
    step = (high - low) / 16
    counted = [0] * 16
    for v in values:
        counted[min(15, int((v - low) / step))] += 1
    label = symbol if unit == "1" else f"{symbol} [{unit}]"
    panel = charts.Panel(f"{symbol}, {kind}", charts.padded(values), (0, 1.08 * max(counted)), label, "samples")
    for i, n in enumerate(counted):
        panel.bar(low + i * step, step, n, "#b9cfe0")
    f, xs = density(kind, mean, cov), [low + (high - low) * i / 80 for i in range(81)]
    panel.line([(x, len(values) * step * f(x)) for x in xs], charts.COLOUR["paper"], 2)
    return panel


def table_2(page):
    campaign, rows, panels = page.campaign, [], []
    drawn = {i["name"]: i for i in campaign.statistics["inputs"]}
    cut = dict(campaign.db.execute("SELECT name, cut_off FROM input WHERE is_random"))
    column = {c: [s[c] for s in campaign.of()] for c, v in campaign.of()[0].items() if isinstance(v, float)}
    for name, c, symbol, unit, kind, mean, cov in TABLE_2:
        i = drawn[name]
        rows.append([symbol if unit == "1" else f"{symbol} [{unit}]", kind, f"{mean:g}", f"{i['mean']:.4g}", f"{cov:g}",
                     f"{i['cov']:.3f}", f"{i['min']:.3g}", f"{i['max']:.3g}", f"{cut[name]:.0e}" if cut[name] else "none"])
        panels.append(histogram(column[c], symbol, unit, kind, mean, cov))
    follows = (("joint_cohesion_MPa", "ft_j_MPa", 1.5), ("unit_cohesion_MPa", "ft_u_MPa", 1.5),
               ("joint_GI_N_per_m", "ft_j_MPa", 29.0), ("joint_Gc_N_per_m", "fc_MPa", 3200.0))
    off = max(abs(a / (k * b) - 1) for y, x, k in follows for a, b in zip(column[y], column[x]))
    pairs = [(a, b) for k, a in enumerate(INPUTS) for b in list(INPUTS)[k + 1:]]
    worst, a, b = max((abs(pearson(column[a], column[b])), a, b) for a, b in pairs)
    return {"table 2": table(["", "distribution", "mean asked", "drawn", "CoV asked", "drawn", "least", "largest", "cut off"], rows),
            "deviation": f"{off:.0e}", "largest correlation drawn": f"{worst:.2f} ({INPUTS[a]}, {INPUTS[b]})",
            "by chance": f"{2.807 / math.sqrt(len(campaign.samples)):.2f}",
            "figure 7": page.figure("fig_7_inputs", "Histograms of the drawn inputs with the densities asked for", panels, 3)}


def table_3(page):
    values, panels = {}, []
    for q in (F, D):
        for kind, words, digits in (("mean", "mean", 1), ("cov", "CoV", 3)):
            rows, found = [], []
            for k, mode in enumerate(GROUPS_OF_ALL):
                t = page.campaign.table(mode, q)
                ours, interval = (t[kind], t[f"{kind}_interval"]) if t else (None, (None, None))
                said, around = TABLE_3[q][kind][k], paper.interval_of(q, kind, k)
                label = f"{mode} (n = {t['n'] if t else 0})"
                rows.append(page.row(f"{SYMBOL[q]}, {words}", label, ours, interval, said, around, digits))
                found.append((mode, ours, interval, said, around))
            values[f"table 3, {words} of {SYMBOL[q][0]}"] = table([words, "paper", "ours", "difference", ""], rows)
            unit = {F: " [kN]", D: " [mm]"}[q] if kind == "mean" else ""
            panels.append(beside(f"{SYMBOL[q]}, {words}{unit}", found))
    rows = []
    for k, mode in enumerate(GROUPS_OF_ALL):
        t, chosen = page.campaign.table(mode, D_MAX), page.campaign.of(mode)
        ours = [f"{t['mean']:.1f}", NO if t["cov"] is None else f"{t['cov']:.3f}"] if t else [NO, NO]
        said = [f"{TABLE_3[D_MAX][kind][k]:g}" for kind in ("mean", "cov")]
        rows.append([mode, said[0], ours[0], said[1], ours[1], f"{sum(s[D_MAX] < 49.9 for s in chosen)} of {len(chosen)}"])
    return values | {
        "table 3, D max": table(["", "paper, mean", "ours", "paper, CoV", "ours", "ended before 50 mm"], rows),
        "table 3, figure": page.figure("table_3", "Means and CoV by mode, the paper's beside ours", panels, 2),
        "censored": str((page.campaign.table("all", D) or {}).get("censored", 0)),
        "censored max": f"{page.campaign.table('all', D_MAX)['censored']} of {page.campaign.table('all', D_MAX)['n']}",
        "collapsed": str(page.campaign.statistics["samples"]["status"].get("collapsed", 0))}


def shares(page):
    found, rows, shown = page.campaign.statistics["shares"], [], {}
    for name in list(SHARES) + MODES[:4]:
        ours, (said, around) = found.get(name), paper.share_interval(name)
        share, interval = (ours["share"], ours["share_interval"]) if ours else (None, (None, None))
        label = f"{name} (n = {ours['count'] if ours else 0}{'' if name in SHARES else '; the paper inferred'})"
        rows.append(page.row("shares", label, share, interval, said, around, 1, 100))
        shown[name] = (share, interval, said, around)
    unclear = found.get("unclear", {"count": 0, "share": 0.0, "share_interval": (None, None)})
    shown["unclear"] = (unclear["share"], unclear["share_interval"], None, ())
    order = {m: m for m in MODES} | {"unclear": "unclear", "FM-1 + FM-2": "FM-1+2", "FM-3 + FM-4": "FM-3+4"}
    panel = beside("share", [(word, *shown[name]) for name, word in order.items()], 620)
    return {"table of shares": table(["", "paper [%]", "ours [%]", "difference", ""], rows),
            "figure 10": page.figure("fig_10_shares", "Shares of the failure modes, the paper's hollow, with intervals", [panel])}


def running(page):
    r, t = page.campaign.statistics["running"][F], page.campaign.table("all", F)
    n, mean, last = r["n"], r["mean"], r["mean"][-1]
    words = {"peak_reaction_kN": "mean F max", "displacement_at_80_percent_mm": "mean D at 0.8 F max", "share": "widest share"}
    rows = []
    for p in (p for p in page.campaign.statistics["precision"] if p["what"] in words):
        later = "not met" + (f", expected at {p['expected_at']}" if p["expected_at"] else "")
        now = NO if p["half_width_now"] is None else f"±{100 * p['half_width_now']:.2g} %"
        rows.append([f"{words[p['what']]} ±{100 * p['half_width_asked']:g} %", p["held_from"] or later, now])
    kept = [i for i, low in enumerate(r["low"]) if low is not None]
    settled = [v for i in kept if n[i] >= 30 for v in (r["low"][i], r["high"][i])] or [last]
    low, high = charts.padded([*settled, 163.25])
    panel = charts.Panel("running mean of F max", (0, n[-1]), (low, high), "samples", "F max [kN]", width=720, height=300)
    blue, purple = charts.COLOUR["FM-3"], charts.COLOUR["paper"]
    panel.band([n[i] for i in kept], [max(low, r["low"][i]) for i in kept], [min(high, r["high"][i]) for i in kept], blue)
    panel.line([(n[i], mean[i]) for i in kept if low <= mean[i] <= high], blue, 2)
    panel.line([(0, 163.25), (n[-1], 163.25)], purple, 1.5, "6 4")
    panel.label(n[-1], 163.25, "paper, 163.25 kN", purple, "end", 6)
    panel.label(n[-1], r["high"][-1], f"ours, {last:.1f} kN", blue, "end", 6)
    within = {x: max((k for k, m in zip(n, mean) if abs(m / last - 1) > x), default=0) + 1 for x in (0.01, 0.005)}
    return {"last running mean": f"{last:.1f}", "within 1 %": str(within[0.01]), "within 0.5 %": str(within[0.005]),
            "chance at 80": f"{196 * t['cov'] / math.sqrt(80):.1f}",
            "chance at 80, paper": f"{196 * TABLE_3[F]['cov'][5] / math.sqrt(80):.1f}",
            "table of precision": table(["half-width asked", "met for good from sample", "at the end"], rows),
            "figure 8": page.figure("fig_8_running_mean", "Running mean of the peak force with its 95 % interval", [panel])}


def fig_15(page):
    everything, rows, panels = page.campaign.of(), [], []
    x, y = (charts.padded([s[c] for s in everything]) for c in ("ft_j_MPa", F))
    y = (y[0], max(y[1], 182))
    for k, mode in enumerate(GROUPS_OF_ALL):
        chosen = page.campaign.of(mode)
        n, cells, about = len(chosen), [], {}
        for column in INPUTS:
            r = pearson([s[column] for s in chosen], [s[F] for s in chosen]) if n > 4 else math.nan
            about[column] = pearson_interval(r, n)
            cells.append(NO if math.isnan(r) else f"{two(r)} ({between(*about[column], 2)})")
        low, high = about["ft_j_MPa"]
        said, inside = ("almost 1, high ft,j", high >= 0.9) if mode in ("FM-3", "FM-4") else ("significant", low > 0)
        said += {"FM-1": ", low ft,j", "FM-2": ", low ft,j", "FM-5": ", highest ft,j"}.get(mode, "")
        word = page.verdict("ft,j with F max", mode, None if math.isnan(low) else inside)
        rows.append([mode, n, *cells, f"{sum(s['ft_j_MPa'] < 0.15 for s in chosen)} of {n}", said, word])
        panel = charts.Panel(f"{mode}, r = {cells[0]}", x, y, "ft,j [MPa]", "F max [kN]")
        panel.line([(0.15, y[0]), (0.15, y[1])], charts.SOFT, 1, "3 3")
        panel.line([(x[0], TABLE_3[F]["mean"][k]), (x[1], TABLE_3[F]["mean"][k])], charts.COLOUR["paper"], 1.2, "6 4")
        for s in chosen:
            panel.dot(s["ft_j_MPa"], s[F], charts.colour_of(s["mode"]))
        panels.append(panel)
    return {"table of correlations": table(["", "n", *INPUTS.values(), "ft,j below 0.15 MPa", "paper", ""], rows),
            "figure 15": page.figure("fig_15_joint_strength", "Joint tensile strength against peak force by mode", panels, 3)}


def fig_16(page):
    chosen, rows, panels = page.campaign.of("FM-5"), [], []
    if len(chosen) < 5:
        return {"table of FM-5": f"Only {len(chosen)} samples of FM-5.", "figure 16": ""}
    means = {c: statistics.mean(s[c] for s in chosen) for c in ("ft_j_MPa", "fc_MPa", F, D)}
    percent = {c: [100 * (s[c] / means[c] - 1) for s in chosen] for c in means}
    for y, x in ((y, x) for y in (F, D) for x in ("ft_j_MPa", "fc_MPa")):
        r = pearson(percent[x], percent[y])
        low, high = pearson_interval(r, len(chosen))
        what = f"{INPUTS[x]} with {SYMBOL[y]}"
        if (x, y) == ("ft_j_MPa", F):  # counted among the rows of Fig. 15 already
            said, word = "significant", INSIDE if low > 0 else OUTSIDE
        else:
            said = "> 0.95" if y == F else "correlated"
            word = page.verdict("correlations in FM-5", what, high >= 0.95 if y == F else low > 0 or high < 0)
        rows.append([what, said, f"{two(r)} ({between(low, high, 2)})", word])
        panel = charts.Panel(f"{what}: r = {two(r)}", charts.padded(percent[x]), charts.padded(percent[y]),
                             f"change of {INPUTS[x]} [%]", f"change of {SYMBOL[y]} [%]")
        for a, b in zip(percent[x], percent[y]):
            panel.dot(a, b, charts.COLOUR["FM-5"])
        panels.append(panel)
    return {"table of FM-5": table(["", "paper", "ours, r", ""], rows),
            "figure 16": page.figure("fig_16_fm_5", "FM-5: force and displacement capacity with the strengths", panels, 2)}


def thin(x, y, step=1.0):
    """A point every `step` millimetres, the peak and the end: enough for a curve of 400 pixels."""
    top, kept, last = max(range(len(y)), key=y.__getitem__), [], -1
    for i, at in enumerate(x):
        if at - last >= step - 1e-9 or i in (top, len(x) - 1):
            kept.append((at, y[i]))
            last = at
    return kept


def fig_20(page):
    curves, panels = page.campaign.curves(), []
    for title, cut in (("to the end of the push", False), ("to 80 % of the peak", True)):
        panel = charts.Panel(title, (0, 50), (0, 170), "displacement [mm]", "F [kN]", width=520, height=330)
        for k, s in page.campaign.samples.items():
            points = thin(*curves[k])
            if cut and not s["censored_80"]:
                points = [p for p in points if p[0] < s[D]] + [(s[D], 0.8 * s[F])]
            panel.line(points, charts.colour_of(s["mode"]), 0.8, opacity=0.55)
        panels.append(panel)
    return {"figure 20": page.figure("fig_20_curves", "All force-displacement curves, coloured by mode", panels, 2,
                                    [*MODES, "unclear"])}


def fall_of(points):
    """Drift at which a curve falls to 0.8 of its peak, and whether it does."""
    top = max(range(len(points)), key=lambda i: points[i][1])
    fallen = next((p for p in points[top:] if p[1] <= 0.8 * points[top][1]), None)
    return (fallen[0], True) if fallen else (points[-1][0], False)


def fig_21(page):
    height, rows = page.campaign.statistics["load_height_m"], []
    panel = charts.Panel("moving average of each mode", (0, 1.6), (0, 170), "drift at the load's height [%]", "F [kN]",
                         width=720, height=360)
    for k, mode in enumerate(MODES):
        low, high = paper.DRIFTS[mode]
        said = f"{low:g} to {high:g}" if math.isfinite(high) else f"> {low:g}"
        curve, t = page.campaign.statistics["mean_curves"].get(mode), page.campaign.table(mode, D)
        if not curve or not t or t["mean_interval"][0] is None:
            rows.append([mode, said, NO, NO, page.verdict("ultimate drift", mode, None)])
            continue
        points = [(d, f) for d, f, n in zip(curve["drift_percent"], curve["reaction_mean_kN"], curve["n"])
                  if f is not None and 2 * n >= curve["curves"]]
        panel.line(points, charts.colour_of(mode), 2.4)
        panel.line([(1.28, 40 - 8 * k), (1.36, 40 - 8 * k)], charts.colour_of(mode), 2.4)
        panel.label(1.38, 40 - 8 * k, f"{mode}, n = {t['n']}", lift=-4)
        drop, reached = fall_of(points)
        mean, first, last = (v / height / 10 for v in (t["mean"], *t["mean_interval"]))
        inside = low <= drop <= high or (first <= high and last >= low) or (not reached and drop < low)
        rows.append([mode, said, f"{'' if reached else '> '}{drop:.2f}", f"{mean:.2f} ({between(first, last, 2)})",
                     page.verdict("ultimate drift", mode, inside)])
    return {"load height": f"{height:.3f} m",
            "table of drifts": table(["", "paper [%]", "mean curve at 0.8 of its peak [%]", "mean of the samples [%]", ""], rows),
            "figure 21": page.figure("fig_21_moving_averages", "Mean force-drift curve of each failure mode", [panel])}


def in_short(page):
    """The headline numbers, and which of all compared lie inside; after all other sections."""
    rows = []
    for q, kind, words, digits in ((F, "mean", "mean F max [kN]", 1), (F, "cov", "CoV of F max", 3),
                                   (D, "mean", "mean D at 0.8 F max [mm]", 1), (D, "cov", "CoV of D", 2)):
        t = page.campaign.table("all", q)
        rows.append([words, f"{TABLE_3[q][kind][5]:g}", f"{t[kind]:.{digits}f}", between(*t[f"{kind}_interval"], digits)])
    for group, found in ((g, page.campaign.statistics["shares"].get(g)) for g in GROUPS):
        if found:
            rows.append([f"share of {group} [%]", f"{100 * SHARES[group]:.0f}", f"{100 * found['share']:.1f}",
                         between(*(100 * v for v in found["share_interval"]), 1)])
    topics = dict.fromkeys(topic for topic, _, _ in page.verdicts)
    return {"headline": table(["over all samples", "paper", "ours", "95 % interval"], rows),
            "compared": str(len(page.verdicts)), "inside": str(len(page.of(INSIDE))), "outside": str(len(page.of(OUTSIDE))),
            "too few": str(len(page.of(FEW))),
            "verdicts": table(["", "inside", "outside"],
                              [[t, *(", ".join(page.of(word, t)) or NO for word in (INSIDE, OUTSIDE))] for t in topics])}


def inferred():
    found = paper.counts()
    ranges = (f"{m} {min(c)} to {max(c)}" if min(c) < max(c) else f"{m} {c[0]}" for m, c in zip(MODES, zip(*found)))
    return {"sets of counts": str(len(found)), "counts": ", ".join(ranges), "N": str(N),
            "D max of the counts": f"{paper.weighted(D_MAX, paper.middle_counts()[:5]):.2f}"}


def values(page):
    found = {}
    for section in (table_2, table_3, shares, running, fig_15, fig_16, fig_20, fig_21, in_short):
        found |= section(page)
    return found | inferred()
