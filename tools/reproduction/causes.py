"""Why: which samples fail how, other names for the same pushes, and a gallery; values of page.md by name."""
import collections
import math
import pathlib
import re
import statistics
import subprocess
import tempfile

import charts
from campaign import CRACK, D, F, GROUPS, MODES, first_pier_crack, growth, renamed, slides, typical
from compare import NO, table, thin
from paper import TABLE_3, middle_counts, pearson

AT = (10, 20, 40)  # mm, as in the paper's Fig. 11-14
FRACTIONS = (0.9, 0.85, 0.8, 0.75, 0.7)


def mean_of(samples, column, digits=1):
    return f"{statistics.mean(s[column] for s in samples):.{digits}f}" if samples else NO


def cov(numbers):
    numbers = list(numbers)
    return statistics.stdev(numbers) / statistics.mean(numbers)


def falls(sample):
    return sample["flag"]["reaction: sudden fall, of the peak"] >= 0.2


def early(sample):
    return (first_pier_crack(sample) or 99) <= 25


def contradiction(campaign):
    """What the paper says of the modes beside what this campaign finds."""
    piers, spandrel, rocking = ([s for s in campaign.of() if s["mode"] in modes] for modes in GROUPS.values())
    if not (piers and spandrel and rocking):
        return "Too few samples."
    weak, strong = (statistics.mean(s["ft_j_MPa"] for s in group) for group in (piers, spandrel))
    means = {m: statistics.mean(s[F] for s in campaign.of(m)) for m in MODES if campaign.of(m)}
    order = sorted(means, key=means.get)
    soon, late = [s for s in piers if early(s)], [s for s in piers if not early(s)]
    r = pearson([s["ft_u_MPa"] for s in campaign.of()], [s[F] for s in campaign.of()])
    return table(["the paper", "here"], [
        ["FM-1 and FM-2 have weak joints, FM-3 and FM-4 strong ones, FM-5 the strongest",
         f"{'the opposite' if weak > strong else 'the same'}: mean ft,j {weak:.3f} MPa in FM-1+2, {strong:.3f} in FM-3+4; "
         f"{mean_of(rocking, 'ft_j_MPa', 3)} in FM-5"],
        ["piers fail early and suddenly: D 16 to 18 mm",
         f"D {mean_of(piers, D)} mm; {sum(map(falls, piers))} of {len(piers)} fall suddenly. Those with a cracked pier by 20 mm "
         f"({len(soon)}): D {mean_of(soon, D)} mm, ft,u {mean_of(soon, 'ft_u_MPa', 3)} MPa; later ({len(late)}): "
         f"{mean_of(late, D)} mm, {mean_of(late, 'ft_u_MPa', 3)} MPa"],
        ["the spandrel is ductile: D 36 to 42 mm",
         f"D {mean_of(spandrel, D)} mm; {sum(map(slides, spandrel))} of {len(spandrel)} slide in one bed, which opens nothing"],
        ["weakest FM-2, then FM-1, FM-3, FM-4, strongest FM-5; 33 kN apart",
         f"{', '.join(order)} from weakest to strongest; {means[order[-1]] - means[order[0]]:.0f} kN apart"],
        ["ft,u matters little or not",
         f"it decides whether strong joints leave the piers to split: mean ft,u {mean_of(piers, 'ft_u_MPa', 3)} MPa in FM-1+2, "
         f"{mean_of(rocking, 'ft_u_MPa', 3)} in FM-5; r with F max {r:.2f}"]])


def terciles(campaign):
    """Counts of modes by thirds of joint and unit strength."""
    def limits(column):
        ordered = sorted(s[column] for s in campaign.of())
        return ordered[len(ordered) // 3], ordered[2 * len(ordered) // 3]
    tj, tu = limits("ft_j_MPa"), limits("ft_u_MPa")
    cells = {}
    for s in campaign.of():
        key = sum(s["ft_j_MPa"] >= t for t in tj), sum(s["ft_u_MPa"] >= t for t in tu)
        cells.setdefault(key, []).append(s["mode"])
    rows = []
    for j, word in enumerate(("low", "middle", "high")):
        counted = [collections.Counter(cells.get((j, u), [])).most_common() for u in range(3)]
        rows.append([f"ft,j {word}", *(", ".join(f"{m} {n}" for m, n in c) or NO for c in counted)])
    return {"table of thirds": table(["", "ft,u low", "ft,u middle", "ft,u high"], rows),
            "thirds": f"ft,j {tj[0]:.3f} and {tj[1]:.3f}, ft,u {tu[0]:.3f} and {tu[1]:.3f} MPa"}


def medians(campaign):
    rows = []
    for mode, chosen in ((m, campaign.of(m)) for m in MODES + ["unclear"] if campaign.of(m)):
        columns = (("ft_j_MPa", 3), ("ft_u_MPa", 3), ("fc_MPa", 2), ("phi_deg", 1), (F, 1), (D, 1))
        seen = [c for c in map(first_pier_crack, chosen) if c is not None]
        rows.append([mode, len(chosen), *(f"{statistics.median(s[c] for s in chosen):.{digits}f}" for c, digits in columns),
                     f"{statistics.median(seen):.0f} ({len(seen)} of {len(chosen)})" if seen else "none",
                     f"{100 * sum(map(slides, chosen)) / len(chosen):.0f} %", f"{statistics.median(map(growth, chosen)):.1f}",
                     f"{100 * sum(map(falls, chosen)) / len(chosen):.0f} %"])
    return table(["", "n", "ft,j MPa", "ft,u MPa", "fc MPa", "φ deg", "F max kN", "D mm", "pier crack mm", "bed sliding",
                  "growth mm", "sudden fall"], rows)


def fractions(campaign):
    """D where the force first falls below other shares of the peak, from the stored curves."""
    def fall(x, y, fraction):
        top = max(range(len(y)), key=y.__getitem__)
        return next((x[i] for i in range(top, len(y)) if y[i] < fraction * y[top]), x[-1])
    curves, rows = campaign.curves(), []
    for k, mode in enumerate(MODES + ["all"]):
        chosen = [curves[s["sample"]] for s in campaign.of(mode)]
        if chosen:
            rest = [next((f for d, f in zip(x, y) if d >= 30), y[-1]) / max(y) for x, y in chosen]
            rows.append([mode, *(f"{statistics.mean(fall(x, y, f) for x, y in chosen):.1f}" for f in FRACTIONS),
                         f"{TABLE_3[D]['mean'][k]:g}", f"{statistics.median(rest):.2f}"])
    return table(["D [mm] at", *(f"{f:g} F max" for f in FRACTIONS), "paper, at 0.8", "F at 30 mm / F max, median"], rows)


def names(campaign):
    """The same pushes under other names: samples, mean F max, mean D, mean ft,j."""
    samples, counts = campaign.of(), middle_counts()

    def row(words, name):
        chosen = [[s for s in samples if name(s) == m] for m in MODES]
        cells = [" · ".join([str(len(c)), mean_of(c, F), mean_of(c, D), mean_of(c, "ft_j_MPa", 3)]) if c else NO for c in chosen]
        return [words, *cells, len(samples) - sum(map(len, chosen)) or NO]
    said = [f"{n} · {f:.1f} · {d:.1f}" for n, f, d in zip(counts[:5], TABLE_3[F]["mean"], TABLE_3[D]["mean"])]
    return table(["named", *MODES, "other"], [
        ["paper (counts inferred)", *said, NO],
        row("**as the program does, at 40 mm**", lambda s: s["mode"]),
        *(row(f"at {at} mm", lambda s, at=at: s["reading"].get(f"at {at} mm")) for at in (20, 30, 50)),
        row("at 40 mm by yes or no, never unclear", renamed),
        row("piers with less than 8 mm growth count as whole", lambda s: renamed(s, True, False)),
        row("bed sliding of the spandrel not seen", lambda s: renamed(s, False, True)),
        row("both", lambda s: renamed(s, True, True))])


def scatter(groups):
    """Standard deviation within and between groups of (n, mean, variance)."""
    n = sum(g[0] for g in groups)
    middle = sum(k * m for k, m, _ in groups) / n
    return [f"{math.sqrt(sum(g[0] * part(g) for g in groups) / n):.1f}" for part in (lambda g: g[2], lambda g: (g[1] - middle) ** 2)]


def drag(campaign):
    """The program's own estimate of how far each peak stands above a slow push, median [%]."""
    verdicts = campaign.rows("SELECT sample, rate_verdict FROM sample")
    found = [re.search(r"about ([\d.]+) % above", v or "") for _, v in verdicts]
    return f"{statistics.median(float(m[1]) for m in found if m):.1f} %" if any(found) else NO


def numbers(campaign):
    """Single numbers that the text names."""
    everything = campaign.of()
    found = {"n": str(len(everything)), "unclear": str(len(campaign.of("unclear"))), "drag": drag(campaign),
             "highest F": f"{max(s[F] for s in everything):.1f}"}
    for k, mode in enumerate(MODES + ["all"] + list(GROUPS)[:2]):
        chosen = [s for s in everything if mode == "all" or s["mode"] in GROUPS.get(mode, [mode])]
        found[f"n {mode}"] = str(len(chosen))
        for short, column, digits in (("F", F, 1), ("D", D, 1), ("ft_j", "ft_j_MPa", 3)):
            found[f"{short} {mode}"] = mean_of(chosen, column, digits)
            if short in "FD":
                found[f"CoV {short} {mode}"] = f"{cov(s[column] for s in chosen):.3f}" if len(chosen) > 1 else NO
            if short in "FD" and k < 6 and chosen:
                found[f"gap {short} {mode}"] = f"{statistics.mean(s[column] for s in chosen) - TABLE_3[column]['mean'][k]:+.1f}"
        found |= {f"sliding {mode}": str(sum(map(slides, chosen))), f"early {mode}": str(sum(map(early, chosen))),
                  f"D below 20 {mode}": str(sum(s[D] < 20 for s in chosen))}
    for at in (20, 30, 50):
        found[f"renamed at {at} mm"] = str(sum(s["reading"].get(f"at {at} mm") != s["mode"] for s in everything))
    thresholds = [what for what in everything[0]["reading"] if " x " in what]
    changed = [sum(s["reading"][what] != s["mode"] for s in everything) for what in thresholds] or [0]
    found["renamed by a threshold"] = f"{min(changed)} to {max(changed)}"
    forces = [[s[F] for s in campaign.of(m)] for m in MODES if campaign.of(m)]
    ours = [(len(f), statistics.mean(f), statistics.pvariance(f)) for f in forces]
    said = [(n, m, (m * v) ** 2) for n, m, v in zip(middle_counts()[:5], TABLE_3[F]["mean"], TABLE_3[F]["cov"])]
    for who, groups in (("ours", ours), ("paper", said)):
        found[f"sd within {who}"], found[f"sd between {who}"] = scatter(groups)
    for words, hidden in (("thin", (True, False)), ("bed", (False, True))):
        named = [(renamed(s, *hidden), s) for s in everything]
        found |= {f"{words}: n {m}": str(sum(name == m for name, _ in named)) for m in MODES}
        for group, members in GROUPS.items():
            chosen = [s for name, s in named if name in members]
            found |= {f"{words}: ft_j {group}": mean_of(chosen, "ft_j_MPa", 3), f"{words}: D {group}": mean_of(chosen, D)}
    return found


def caption(s):
    said = []
    for element, state in s["element"].items():
        if "toe" in element:
            lost = s["sign"][element, "toe crushing"][0]
            state = f"{100 * lost:.0f} % of its strength lost" if lost >= 0.05 else "intact"
        elif CRACK in state:
            value, threshold, first = s["sign"][element, CRACK]
            state += f", parted over {value:.2f} m (at least {threshold:.2f})" + (f", seen from {first:.0f} mm" if first else "")
        if state != "intact":
            said.append(f"{element}: {state}")
    at = ", ".join(f"{mode} {what}" for what, mode in s["reading"].items() if re.fullmatch(r"at [1-5]0 mm", what))
    changed = [mode for what, mode in s["reading"].items() if not what.startswith("at ")]
    best = ", ".join(f"{m} {v:.2f}" for m, v in sorted(s["score"].items(), key=lambda m: -m[1])[:2])
    return (f"Sample {s['sample']}: {s['sentence']}. ft,j {s['ft_j_MPa']:.3f}, ft,u {s['ft_u_MPa']:.3f}, fc {s['fc_MPa']:.2f} MPa, "
            f"φ {s['phi_deg']:.1f}°, R {s['R']:.2f}. F max {s[F]:.1f} kN at {s['displacement_at_peak_mm']:.1f} mm, D {s[D]:.1f} mm.\n"
            f"{'; '.join(said)}.\nScores {best}; elsewhere {at}; the same name in {changed.count(s['mode'])} of {len(changed)} "
            "changes of a threshold by a quarter.")


def states(page, sample, binary, name, words):
    with tempfile.TemporaryDirectory() as folder:
        drawn = pathlib.Path(folder) / "states.svg"
        subprocess.run([binary, "picture", str(page.campaign.folder), "--sample", str(sample), "--at", *map(str, AT),
                        "--out", str(drawn)], check=True, capture_output=True)
        return page.picture(name, words, charts.plain(drawn.read_text(encoding="utf-8")))


def gallery(page, binary):
    """A typical sample of each mode: its curve among those of its mode, and its states."""
    campaign, curves, panels, parts = page.campaign, page.campaign.curves(), [], []
    for mode, s in ((m, typical(campaign.of(m))) for m in MODES + ["unclear"] if campaign.of(m)):
        title = f"{mode}: sample {s['sample']} among {len(campaign.of(mode))}"
        panel = charts.Panel(title, (0, 50), (0, 170), "displacement [mm]", "F [kN]")
        for other in campaign.of(mode):
            panel.line(thin(*curves[other["sample"]], step=2), charts.FAINT, 0.8)
        panel.line(thin(*curves[s["sample"]], step=0.5), charts.colour_of(mode), 2.2)
        panels.append(panel)
        parts.append(f"### {mode}\n{caption(s)}")
        if mode != "unclear":
            name, words = mode.lower().replace("-", "_") + "_states", f"{mode}, sample {s['sample']} at 10, 20 and 40 mm"
            parts.append(states(page, s["sample"], binary, name, words) if binary else f"![{words}]({page.link}/{name}.svg)")
    return {"figure 11 to 14": page.figure("fig_11_to_14_curves", "Curve of the typical sample among those of its mode", panels, 3),
            "gallery": "\n\n".join(parts)}


def values(page, binary):
    campaign = page.campaign
    return (numbers(campaign) | terciles(campaign) | gallery(page, binary)
            | {"contradiction": contradiction(campaign), "table of medians": medians(campaign),
               "table of fractions": fractions(campaign), "table of names": names(campaign)})
