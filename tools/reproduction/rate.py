"""The same samples at the paper's rate: a second campaign beside the first; values of page.md by name."""
import math
import statistics
import tempfile

import charts
import compare
from campaign import D, F, GROUPS, INPUTS, MODES
from compare import GROUPS_OF_ALL, NO, between, table
from paper import SHARES, TABLE_3

NOT_RUN = "(not run yet: give its folder by `--slow`)"
NAMES = ("slow velocity", "slow damping", "slow samples", "slow headline", "slow verdict", "slow modes", "slow names", "slow kept",
         "figure rate", "slow change F", "slow change D")


def paired(pairs):
    """Mean of the differences and its 95 % half-width."""
    gaps = [b - a for a, b in pairs]
    return statistics.mean(gaps), 1.96 * statistics.stdev(gaps) / math.sqrt(len(gaps))


def spread(mean, half, digits, unit):
    return f"{mean:+.{digits}f} ± {half:.{digits}f} {unit}"


def both(fast, slow):
    common = sorted(set(fast.samples) & set(slow.samples))
    if any(fast.samples[k][c] != slow.samples[k][c] for k in common for c in INPUTS) or len(common) < 3:
        raise SystemExit(f"{slow.folder}: not the samples of {fast.folder}")
    return [(s, slow.samples[k]) for k, s in sorted(fast.samples.items()) if k in slow.samples]


def headline(fast, slow):
    rows = []
    for q, kind, words, digits in ((F, "mean", "mean F max [kN]", 1), (F, "cov", "CoV of F max", 3),
                                   (D, "mean", "mean D at 0.8 F max [mm]", 1), (D, "cov", "CoV of D", 2)):
        cells = [f"{t[kind]:.{digits}f} ({between(*t[f'{kind}_interval'], digits)})"
                 for t in (fast.table("all", q), slow.table("all", q))]
        rows.append([words, f"{TABLE_3[q][kind][5]:g}", *cells])
    for group in GROUPS:
        cells = []
        for campaign in (fast, slow):
            found = campaign.statistics["shares"].get(group)
            cells.append(f"{100 * found['share']:.1f} ({between(*(100 * v for v in found['share_interval']), 1)})" if found else "0")
        rows.append([f"share of {group} [%]", f"{100 * SHARES[group]:.0f}", *cells])
    return table(["over all samples", "paper, 1 mm/s", f"ours, {fast.push()['velocity']}", f"ours, {slow.push()['velocity']}"], rows)


def by_mode(slow):
    rows = []
    for k, mode in enumerate(GROUPS_OF_ALL):
        f, d = slow.table(mode, F), slow.table(mode, D)
        cells = [f["n"] if f else 0]
        for t, q, digits in ((f, F, 1), (d, D, 1)):
            cells.append(f"{TABLE_3[q]['mean'][k]:g} ({TABLE_3[q]['cov'][k]:g})")
            shown = NO if not t else f"{t['mean']:.{digits}f}" + (f" ({t['cov']:.2f})" if t["cov"] is not None else "")
            cells.append(shown)
        rows.append([mode, *cells])
    return table(["", "n", "F max, paper [kN] (CoV)", "ours", "D, paper [mm] (CoV)", "ours"], rows)


def names(pairs, fast, slow):
    words = MODES + ["unclear"]
    rows = [[a, *(sum(f["mode"] == a and s["mode"] == b for f, s in pairs) or NO for b in words)] for a in words]
    return table([f"{fast.push()['velocity']} ↓, {slow.push()['velocity']} →", *words], rows)


def figure(page, pairs, fast, slow):
    panels = []
    for q, words in ((F, "F max [kN]"), (D, "D at 0.8 F max [mm]")):
        around = charts.padded([s[q] for pair in pairs for s in pair])
        panel = charts.Panel(words, around, around, fast.push()["velocity"], slow.push()["velocity"], width=420, height=380)
        panel.line([(around[0], around[0]), (around[1], around[1])], charts.SOFT, 1, "4 4")
        for f, s in pairs:
            panel.dot(f[q], s[q], charts.colour_of(s["mode"]))
        panels.append(panel)
    return page.figure("rate", "Peak force and D of the same samples at two rates; colours: mode at the slower", panels, 2,
                       [*MODES, "unclear"])


def values(page, slow):
    fast = page.campaign
    if slow is None:
        return dict.fromkeys(NAMES, NOT_RUN)
    with tempfile.TemporaryDirectory() as folder:
        judged = compare.Page(slow, "page.md", folder)
        judged_values = compare.values(judged)
    pairs = both(fast, slow)
    s = slow.statistics["samples"]
    return {"slow velocity": slow.push()["velocity"], "slow damping": slow.push()["damping"], "slow samples": f"{s['answered']} of {s['asked']}",
            "slow headline": headline(fast, slow),
            "slow verdict": f"{judged_values['inside']} of {judged_values['compared']} inside, {judged_values['outside']} outside",
            "slow modes": by_mode(slow), "slow names": names(pairs, fast, slow),
            "slow kept": f"{sum(a['mode'] == b['mode'] for a, b in pairs)} of {len(pairs)}",
            "slow change F": spread(*paired([(a[F], b[F]) for a, b in pairs]), 1, "kN"),
            "slow change D": spread(*paired([(a[D], b[D]) for a, b in pairs]), 1, "mm"),
            "figure rate": figure(page, pairs, fast, slow)}
