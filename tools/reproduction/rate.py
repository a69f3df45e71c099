"""The same samples at the paper's rate: a second campaign beside the first; values of page.md by name."""
import tempfile

import charts
import compare
import paired
from campaign import D, F, GROUPS, MODES
from compare import GROUPS_OF_ALL, NO, between, table
from paper import SHARES, TABLE_3

NOT_RUN = "(not run yet: give its folder by `--slow`)"
NAMES = ("slow velocity", "slow damping", "slow samples", "slow headline", "slow verdict", "slow modes", "slow names", "slow kept",
         "figure rate", "slow change F", "slow change D")


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


def names(modes, fast, slow):
    place, count = {mode: i for i, mode in enumerate(modes["modes"])}, modes["count"]
    words = [mode for mode in MODES + ["unclear"] if mode in place]
    rows = [[a, *(count[place[a]][place[b]] or NO for b in words)] for a in words]
    return table([f"{fast.push()['velocity']} ↓, {slow.push()['velocity']} →", *words], rows)


def figure(page, option, fast, slow):
    panels = []
    for q, words in ((F, "F max [kN]"), (D, "D at 0.8 F max [mm]")):
        pair = option["response"][q]["pair"]
        ours, theirs = pair["base"]["value"], pair["option"]["value"]
        around = charts.padded(ours + theirs)
        panel = charts.Panel(words, around, around, fast.push()["velocity"], slow.push()["velocity"], width=420, height=380)
        panel.line([(around[0], around[0]), (around[1], around[1])], charts.SOFT, 1, "4 4")
        for sample, a, b in zip(pair["sample"], ours, theirs):
            panel.dot(a, b, charts.colour_of(slow.samples[sample]["mode"]))
        panels.append(panel)
    return page.figure("rate", "Peak force and D of the same samples at two rates; colours: mode at the slower", panels, 2,
                       [*MODES, "unclear"])


def values(page, slow, binary):
    fast = page.campaign
    if slow is None:
        return dict.fromkeys(NAMES, NOT_RUN)
    with tempfile.TemporaryDirectory() as folder:
        judged = compare.Page(slow, "page.md", folder)
        judged_values = compare.values(judged)
    option = next(iter(paired.compared(binary, [fast.folder, slow.folder]).values()), None)
    if option is None:
        raise SystemExit(f"{slow.folder}: no sample answered there and in {fast.folder}")
    modes, s = option["modes"], slow.statistics["samples"]
    return {"slow velocity": slow.push()["velocity"], "slow damping": slow.push()["damping"], "slow samples": f"{s['answered']} of {s['asked']}",
            "slow headline": headline(fast, slow),
            "slow verdict": f"{judged_values['inside']} of {judged_values['compared']} inside, {judged_values['outside']} outside",
            "slow modes": by_mode(slow), "slow names": names(modes, fast, slow),
            "slow kept": f"{modes['pairs'] - modes['unclear'] - len(modes['changed'])} of {modes['pairs']}",
            "slow change F": paired.shown(paired.difference(option, F), 1, " kN"),
            "slow change D": paired.shown(paired.difference(option, D), 1, " mm"),
            "figure rate": figure(page, option, fast, slow)}
