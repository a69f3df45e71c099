"""What the paper printed, and how a number of ours is compared with one of its numbers."""
import functools
import math

CITATION = ("B. Pulatsu, S. Gonen, F. Parisi, E. Erdogmus, K. Tuncay, M. F. Funari, P. B. Lourenço: Probabilistic approach "
            "to assess URM walls with openings using discrete rigid block analysis (D-RBA), J. Build. Eng. 61 (2022)")
N, Z = 250, 1.959964
# Table 2: input of ours, column, symbol, unit, distribution, mean, CoV
TABLE_2 = [("fc", "fc_MPa", "fc", "MPa", "normal", 3.96, 0.125),
           ("ft_j", "ft_j_MPa", "ft,j", "MPa", "lognormal", 0.15, 0.30),
           ("ft_u", "ft_u_MPa", "ft,u", "MPa", "lognormal", 0.23, 0.22),
           ("phi", "phi_deg", "φ", "deg", "normal", 16, 0.20),
           ("R", "R", "R", "1", "normal", 0.5, 0.20)]
# Table 3, by mode and last over all; half of the last digit printed is in HALF
TABLE_3 = {"peak_reaction_kN": {"mean": [157.6, 146.5, 165.3, 168.3, 179.5, 163.25],
                                "cov": [0.03, 0.04, 0.05, 0.04, 0.05, 0.07]},
           "displacement_max_mm": {"mean": [44.7, 42.2, 48.8, 48.8, 50.0, 47.30],
                                   "cov": [0.05, 0.05, 0.05, 0.07, 0.02, 0.09]},
           "displacement_at_80_percent_mm": {"mean": [16.3, 18.5, 36.2, 41.9, 42.6, 32.11],
                                            "cov": [0.25, 0.32, 0.26, 0.17, 0.16, 0.43]}}
HALF = {"mean": [0.05] * 5 + [0.005], "cov": [0.005] * 6}
SHARES = {"FM-1 + FM-2": 0.37, "FM-3 + FM-4": 0.54, "FM-5": 0.08}
# ultimate drifts the text reads off Fig. 21 [%]
DRIFTS = {"FM-1": (0.8, 1.0), "FM-2": (0.8, 1.0), "FM-3": (1.5, math.inf), "FM-4": (1.5, math.inf), "FM-5": (1.0, math.inf)}


@functools.cache
def counts():
    """All numbers of samples by mode that agree with what the paper printed.

    Shares of three groups to a percent, and the means over all samples of F max and of D at 0.8 F max,
    which must be those of the modes weighted by their counts, within the digits printed.
    """
    found = []
    for piers in range(N + 1):
        for spandrel in range(N + 1 - piers):
            given = (piers, spandrel, N - piers - spandrel)
            if any(abs(n / N - s) > 0.005 for n, s in zip(given, SHARES.values())):
                continue
            for first in range(piers + 1):
                for third in range(spandrel + 1):
                    n = [first, piers - first, third, spandrel - third, given[2]]
                    if all(abs(weighted(q, n) - TABLE_3[q]["mean"][5]) < 0.055
                           for q in ("peak_reaction_kN", "displacement_at_80_percent_mm")):
                        found.append(n)
    return found


def weighted(quantity, n):
    """Mean over all samples from the means of the modes."""
    return sum(a * b for a, b in zip(n, TABLE_3[quantity]["mean"])) / N


def middle_counts():
    """The paper's counts by mode, the middle of those possible, and N."""
    return [round((min(c) + max(c)) / 2) for c in zip(*counts())] + [N]


def wilson(count, n):
    p = count / n
    middle, root = p + Z * Z / (2 * n), Z * math.sqrt(p * (1 - p) / n + Z * Z / (4 * n * n))
    return (middle - root) / (1 + Z * Z / n), (middle + root) / (1 + Z * Z / n)


def interval_of(quantity, kind, k):
    """Interval of a number of Table 3 from its own scatter and the digits printed; k = 0 ... 4 the modes, 5 all."""
    n, cov, half = middle_counts()[k], TABLE_3[quantity]["cov"][k], HALF[kind][k]
    value = TABLE_3[quantity][kind][k]
    spread = half + Z * cov * (value / math.sqrt(n) if kind == "mean" else math.sqrt(1 / (2 * n) + cov * cov / n))
    return value - spread, value + spread


def share_interval(name):
    """Share of a group as printed, or of one mode as inferred, and its interval."""
    if name in SHARES:
        share, half = SHARES[name], 0.005
    else:
        possible = [c[int(name[3]) - 1] for c in counts()]
        share, half = middle_counts()[int(name[3]) - 1] / N, (max(possible) - min(possible)) / 2 / N
    low, high = wilson(share * N, N)
    return share, (low - half, high + half)


def pearson(x, y):
    mx, my = sum(x) / len(x), sum(y) / len(y)
    sxx, syy = sum((a - mx) ** 2 for a in x), sum((b - my) ** 2 for b in y)
    return sum((a - mx) * (b - my) for a, b in zip(x, y)) / math.sqrt(sxx * syy) if sxx * syy > 0 else math.nan


def pearson_interval(r, n):
    if n < 5 or not abs(r) < 1:
        return math.nan, math.nan
    spread = Z / math.sqrt(n - 3)
    return math.tanh(math.atanh(r) - spread), math.tanh(math.atanh(r) + spread)


def difference(ours, interval, paper, paper_interval):
    """Ours minus the paper's with its interval, from both intervals (Zou and Donner's MOVER)."""
    gap = ours - paper
    return gap, (gap - math.hypot(ours - interval[0], paper_interval[1] - paper),
                 gap + math.hypot(interval[1] - ours, paper - paper_interval[0]))
