"""How likely is it that a wall is weaker than 11 kN? Subset simulation of a rare failure.

The wall: validation/vasconcelos_dry_granite_walls, WS.40. Its mean capacity is near 15.5 kN. Plain Monte Carlo needs
about 100 / p walls for a probability p. Subset simulation (Au and Beck, Probabilistic Engineering Mechanics 16,
2001) goes there in steps: the weakest tenth of the walls gives the first threshold; Markov chains that start from
these walls and refuse to leave fill the set again; and so on, until a tenth or more lies below 11 kN. The
probability is the product of the steps. Each move keeps the normal distribution by itself: x' = r x + s u with
r^2 + s^2 = 1 (Papaioannou and others, Probabilistic Engineering Mechanics 41, 2015), so only the wall has to agree.

The check: this wall rocks, so its capacity is nearly a straight line in the load on top, and the probability that
follows from the line can be computed by hand.

  python3 examples/python/reliability.py            some 900 walls, about a minute on two cores
  python3 examples/python/reliability.py --quick    some 140 walls, and 12.5 kN
"""
import argparse
import pathlib
import statistics
import time

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import wythe

MODEL = pathlib.Path(__file__).resolve().parents[2] / "validation/vasconcelos_dry_granite_walls/model.toml"
KN, PHI, LOAD = "material.joint.normal_stiffness", "material.joint.friction_angle", "stage.precompression.beam_load"
SHARE = 0.1  # of the walls that go on to the next step
MOVE = 0.6  # length of a move; 1 forgets where it comes from

parser = argparse.ArgumentParser()
parser.add_argument("--quick", action="store_true")
parser.add_argument("--picture", default="reliability.png")
options = parser.parse_args()
count, DEMAND = (50, 12.5) if options.quick else (250, 11.0)  # DEMAND in kN
random = np.random.default_rng(5)
normal = statistics.NormalDist()

wall = wythe.Function(
    MODEL, {KN: "GPa/m", PHI: "deg", LOAD: "kN"},
    follow={"material.joint.shear_stiffness": (0.4, KN), "material.joint.residual_friction_angle": (1, PHI)},
    set={"stage.push.velocity": "10 mm/s", "stage.push.until": "30 mm", "stage.push.stop_below": 0.97},  # past the peak
)


def capacity(z):
    """Capacities [kN] of walls whose inputs come from independent standard normal numbers."""
    spread = np.sqrt(np.log(1 + 0.25**2))
    stiffness = 21.9 * np.exp(spread * z[:, 0] - spread**2 / 2)  # lognormal, CoV 0.25
    angle = 33.02 * (1 + 0.10 * z[:, 1])
    load = 40 * (1 + 0.10 * z[:, 2])
    return wall(np.column_stack([stiffness, angle, load]))[:, 0]


begin = time.perf_counter()
z = random.standard_normal((count, 3))
peak = capacity(z)
plain_z, plain_peak = z, peak
walls, probability, variance, levels = count, 1.0, 0.0, []
while True:
    order = np.argsort(peak)
    keep = int(SHARE * count)
    threshold = max(DEMAND, (peak[order[keep - 1]] + peak[order[keep]]) / 2)
    share = float(np.mean(peak <= threshold))
    levels.append((threshold, probability * share, peak))
    probability *= share
    variance += (1 - share) / (share * count)  # as if the walls of a step were independent: too small after the first
    print(f"step {len(levels)}: {share:.2f} of the walls are weaker than {threshold:.2f} kN; so far {probability:.2e}")
    if threshold == DEMAND:
        break
    if share == 0 or len(levels) == 12:
        raise SystemExit("the steps do not come nearer: take more walls or a lower demand")
    z, peak = z[order[:keep]], peak[order[:keep]]
    chains_z, chains_peak = [z], [peak]
    for _ in range(count // keep - 1):  # all chains move at once: one batch
        moved = np.sqrt(1 - MOVE**2) * z + MOVE * random.standard_normal(z.shape)
        found = capacity(moved)
        walls += keep
        stays = found > threshold
        z, peak = np.where(stays[:, None], z, moved), np.where(stays, peak, found)
        chains_z.append(z)
        chains_peak.append(peak)
    z, peak = np.concatenate(chains_z), np.concatenate(chains_peak)
seconds = time.perf_counter() - begin

line = np.polynomial.Polynomial.fit(plain_z[:, 2], plain_peak, 1).convert()
by_hand = normal.cdf((DEMAND - line.coef[0]) / line.coef[1])
cov = np.sqrt(variance)
print(f"probability {probability:.1e}, coefficient of variation at least {cov:.2f}; {walls} walls in {seconds:.0f} s")
print(f"by the straight line through the first {count} walls: {by_hand:.1e}")
print(f"plain Monte Carlo with the same coefficient of variation would need {1 / (probability * cov**2):.0f} walls")

figure, (left, right) = plt.subplots(1, 2, figsize=(8, 3.4), layout="constrained")
left.plot(plain_z[:, 2], plain_peak, ".", label="first step")
left.plot(z[:, 2], peak, ".", label="last step")
left.plot([-6, 3], line(np.array([-6, 3])), color="grey", linewidth=0.8)
left.axhline(DEMAND, color="black", linestyle=":")
left.set(xlabel="load on top [deviations from its mean]", ylabel="capacity [kN]")
left.legend()
before = 1.0
for number, (_, after, peaks) in enumerate(levels):
    right.semilogy(np.sort(peaks), before * (np.arange(len(peaks)) + 1) / len(peaks), label=f"step {number + 1}")
    before = after
right.axvline(DEMAND, color="black", linestyle=":")
right.set(xlabel="capacity [kN]", ylabel="probability of less")
right.legend()
figure.savefig(options.picture, dpi=120)
