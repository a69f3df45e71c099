"""The numbers of statistics.json once more, from samples.csv alone and by other ways where there are any.

Means and CoV by Python's exact sums, bootstrap intervals with other random numbers. `check` returns what was
compared and what disagrees: beyond rounding (samples.csv has ten digits), or, for the bootstrap, beyond one standard
error: an end from 2000 replicates, far in the tail where the correction for bias puts it, scatters by up to 0.3 of them,
and here two such ends meet, a hundred times. Groups with fewer than ten different values have ends that jump: left out.
"""
import math
import random
import statistics

from campaign import INPUTS
from paper import Z, pearson, wilson

ROUNDING, REPLICATES, ENDS, NORMAL = 1e-6, 2000, 1.0, statistics.NormalDist()


def ranks(values):
    order = sorted(range(len(values)), key=values.__getitem__)
    out, i = [0.0] * len(values), 0
    while i < len(order):
        j = i
        while j + 1 < len(order) and values[order[j + 1]] == values[order[i]]:
            j += 1
        for k in range(i, j + 1):
            out[order[k]] = (i + j) / 2 + 1
        i = j + 1
    return out


def fisher(r, n, c=1.0):
    spread = Z * math.sqrt(c / (n - 3))
    return math.tanh(math.atanh(r) - spread), math.tanh(math.atanh(r) + spread)


def bca(values, statistic, seed=1):
    """Interval and standard error of the bootstrap, corrected for bias and acceleration."""
    source, n = random.Random(seed), len(values)
    found, here = sorted(statistic(source.choices(values, k=n)) for _ in range(REPLICATES)), statistic(values)
    z0 = NORMAL.inv_cdf(min(max(sum(v < here for v in found) / REPLICATES, 1e-6), 1 - 1e-6))
    jack = [statistic(values[:i] + values[i + 1:]) for i in range(n)]
    middle = statistics.fmean(jack)
    a = sum((middle - v) ** 3 for v in jack) / (6 * sum((middle - v) ** 2 for v in jack) ** 1.5)
    ends = []
    for z in (-Z, Z):
        level = NORMAL.cdf(z0 + (z0 + z) / (1 - a * (z0 + z)))
        ends.append(found[min(REPLICATES - 1, int(level * REPLICATES))])
    return ends, statistics.stdev(found)


def cov(values):
    m = sum(values) / len(values)
    return math.sqrt(sum((v - m) ** 2 for v in values) / (len(values) - 1)) / m


class Checked:
    def __init__(self):
        self.compared, self.faults, self.worst_bootstrap = 0, [], 0.0

    def same(self, what, ours, theirs, tolerance=ROUNDING):
        self.compared += 1
        if theirs is None or abs(ours - theirs) > tolerance * max(1.0, abs(theirs)):
            self.faults.append(f"{what}: {ours:.9g} recomputed, {theirs} written")

    def bootstrap(self, what, values, statistic, theirs):
        ends, error = bca(values, statistic)
        for end, mine, written in zip(("low", "high"), ends, theirs):
            self.worst_bootstrap = max(self.worst_bootstrap, abs(mine - written) / error)
            self.same(f"{what}, {end}", mine / error, written / error, ENDS / max(1.0, abs(written / error)))


def check(campaign):
    checked, s = Checked(), campaign.statistics
    for group, table in s["table"].items():
        chosen = [x for x in campaign.of() if x["mode"] in table["modes"]]
        if len(chosen) < 2:
            continue
        for response, t in ((r, t) for r, t in table.items() if r != "modes"):
            values, what = [x[response] for x in chosen], f"{group}, {response}"
            mean, deviation = statistics.mean(values), statistics.stdev(values)
            for word, value in (("n", len(values)), ("mean", mean), ("median", statistics.median(values)),
                                ("min", min(values)), ("max", max(values)), ("standard_deviation", deviation),
                                ("cov", deviation / mean)):
                checked.same(f"{what}, {word}", value, t[word])
            if len(set(values)) >= 10 and t["mean_interval"][0] is not None:
                checked.bootstrap(f"{what}, interval of the mean", values, lambda v: sum(v) / len(v), t["mean_interval"])
                checked.bootstrap(f"{what}, interval of the CoV", values, cov, t["cov_interval"])
    for group, share in s["shares"].items():
        count = sum(x["mode"] in share["modes"] for x in campaign.of())
        checked.same(f"{group}, count", count, share["count"])
        for end, value, written in zip(("low", "high"), wilson(count, len(campaign.samples)), share["share_interval"]):
            checked.same(f"{group}, share, {end}", value, written)
    correlations(campaign, checked)
    return checked


def correlations(campaign, checked):
    for c in (c for c in campaign.statistics["correlation"] if c["pearson"] is not None):
        chosen = [s for s in campaign.of() if s["mode"] in campaign.statistics["table"][c["group"]]["modes"]]
        name = next(n for n in INPUTS if n == c["input"] or n.startswith(c["input"] + "_"))
        x, y = [s[name] for s in chosen], [s[c["response"]] for s in chosen]
        r, rho = pearson(x, y), pearson(ranks(x), ranks(y))
        for word, value, spread in (("pearson", r, 1.0), ("spearman", rho, 1 + rho * rho / 2)):
            what = f"{c['group']}, {word} of {c['input']} with {c['response']}"
            checked.same(what, value, c[word])
            if abs(value) < 1 - 1e-12:
                for end, mine, written in zip(("low", "high"), fisher(value, len(chosen), spread), c[word + "_interval"]):
                    checked.same(f"{what}, {end}", mine, written)
