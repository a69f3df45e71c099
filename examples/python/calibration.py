"""What does one measured curve tell about the joints of a wall? Bayesian calibration, and what it leaves open.

The wall: validation/lourenco_dry_stone_wall, SW.100, tested twice. Test 2 calibrates, test 1 is kept for the check.

    P = 100 kN on a beam      Known: sizes, weight, load.
       v                      Not known: the stiffness kn of the joints, their friction tan(phi), and how far the
  -> +-----+                  model is from the test (sigma: stones crack in the test, not in the model).
     |     |                  Before the test: kn between 2 and 30 GPa/m, tan(phi) near 0.62.
     +-----+

1. Walls spread over the priors are run. A polynomial in the unknowns stands in for the curve (surrogate).
2. A Metropolis chain draws from the posterior. Errors of the model at neighbouring displacements go together
   (correlation length 4 mm): ten readings of one curve are not ten tests.
3. Prediction: is test 2 inside the band that was fitted to it, and test 1, which was not used?

  python3 examples/python/calibration.py            80 walls, half a minute on two cores
  python3 examples/python/calibration.py --quick    30 walls
"""
import argparse
import pathlib
import time

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import wythe

FOLDER = pathlib.Path(__file__).resolve().parents[2] / "validation/lourenco_dry_stone_wall"
KN, PHI = "material.joint.normal_stiffness", "material.joint.friction_angle"
AT = np.array([0.5, 1, 1.5, 2, 3, 4, 6, 8, 10, 12.0])  # mm; at 13 mm a stone of the tested wall cracked
# Priors, independent: normal distributions of log kn, tan(phi), log sigma (sigma in kN).
MEAN, DEVIATION = np.array([np.log(7.7), 0.62, np.log(3.0)]), np.array([0.7, 0.12, 0.7])
NAMES = ["kn [GPa/m]", "tan(phi)", "sigma [kN]"]

parser = argparse.ArgumentParser()
parser.add_argument("--quick", action="store_true")
parser.add_argument("--picture", default="calibration.png")
options = parser.parse_args()
walls, steps = (30, 4000) if options.quick else (80, 40000)
random = np.random.default_rng(7)

wall = wythe.Function(
    FOLDER / "model.toml", {KN: "GPa/m", PHI: "deg"},
    follow={"material.joint.shear_stiffness": (0.4, KN), "material.joint.residual_friction_angle": (1, PHI)},
    set={"stage.push.until": "12.5 mm"},
)


def measured(test):
    """Force [kN] of a test at the displacements AT."""
    curve = np.genfromtxt(FOLDER / f"data/FD_SW100{test}.csv", delimiter=",", names=True)
    order = np.argsort(curve["top_displacement_mm"], kind="stable")
    return np.interp(AT, curve["top_displacement_mm"][order], curve["horizontal_force_kN"][order])


def terms(z):
    """Cubic polynomial in the two unknowns of the wall, in deviations of their priors."""
    return np.column_stack([z[:, 0] ** i * z[:, 1] ** j for i in range(4) for j in range(4 - i)])


# 1. The surrogate: walls out to 2.5 deviations, one in each slice of both inputs.
slices = (np.column_stack([random.permutation(walls) for _ in range(2)]) + random.random((walls, 2))) / walls
z = 5 * slices - 2.5
x = MEAN[:2] + DEVIATION[:2] * z
begin = time.perf_counter()
curves = wall.curves_at(np.column_stack([np.exp(x[:, 0]), np.degrees(np.arctan(x[:, 1]))]), AT)
seconds = time.perf_counter() - begin
inverse = np.linalg.pinv(terms(z))
weights = inverse @ curves
left_out = (curves - terms(z) @ weights) / (1 - np.einsum("ij,ji->i", terms(z), inverse))[:, None]
surrogate_error = np.sqrt((left_out**2).mean(axis=0))
print(f"{walls} walls in {seconds:.0f} s; error of the surrogate {surrogate_error.mean():.2f} kN, at most {surrogate_error.max():.2f} kN")

# 2. The posterior.
data = measured(2)
correlation = np.exp(-np.abs(AT[:, None] - AT) / 4.0)


def log_posterior(u):
    """Of u, the unknowns in deviations of their priors."""
    if np.abs(u[:2]).max() > 2.5:  # where no wall was run the surrogate knows nothing
        return -np.inf
    error = data - (terms(u[None, :2]) @ weights)[0]
    covariance = np.exp(2 * (MEAN[2] + DEVIATION[2] * u[2])) * correlation + np.diag(surrogate_error**2)
    factor = np.linalg.cholesky(covariance)
    return -0.5 * np.sum(np.linalg.solve(factor, error) ** 2) - np.log(np.diag(factor)).sum() - 0.5 * u @ u


def chain(start):
    here, value, kept, taken = start, log_posterior(start), [], 0
    for _ in range(steps):
        there = here + 0.5 * random.standard_normal(3)
        new = log_posterior(there)
        if np.log(random.random()) < new - value:
            here, value, taken = there, new, taken + 1
        kept.append(here)
    return np.array(kept[steps // 5:]), taken / steps


chains, shares = zip(*(chain(start) for start in random.uniform(-1, 1, (4, 3))))
between = np.var([c.mean(axis=0) for c in chains], axis=0)
within = np.mean([c.var(axis=0) for c in chains], axis=0)
draws = np.concatenate(chains)
values = MEAN + DEVIATION * draws
values[:, [0, 2]] = np.exp(values[:, [0, 2]])
print(f"4 chains of {steps} steps, {np.mean(shares):.0%} of the moves taken; "
      f"chains agree: R-hat {np.sqrt(1 + between / within).max():.3f} (1 is best)")
print("             prior 5 to 95 %      posterior 5 to 95 %    prior variance that is gone")
for i, name in enumerate(NAMES):
    prior = MEAN[i] + DEVIATION[i] * np.array([-1.645, 1.645])
    prior = np.exp(prior) if i != 1 else prior
    low, high = np.percentile(values[:, i], [5, 95])
    print(f"{name:12} {prior[0]:6.2f} to {prior[1]:6.2f}   {low:8.2f} to {high:6.2f}   {1 - draws[:, i].var():14.0%}")

# 3. The predictive check.
picked = random.choice(len(draws), 2000)
noise = random.standard_normal((2000, len(AT))) @ np.linalg.cholesky(correlation).T
predicted = terms(draws[picked, :2]) @ weights + values[picked, 2:] * noise
low, high = np.percentile(predicted, [5, 95], axis=0)
for test, role in ((2, "calibrated"), (1, "not used")):
    inside = np.mean((measured(test) >= low) & (measured(test) <= high))
    print(f"test {test} ({role}): {inside:.0%} of its readings lie inside the band of 90 %")
print(f"What this curve cannot tell: the friction. The wall rocks; the curve says that friction is enough for that, hardly below "
      f"{np.percentile(values[:, 1], 5):.2f}, and nothing about how much more it is.")

figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.6), layout="constrained")
left.fill_between(AT, low, high, alpha=0.3, label="predicted, 5 to 95 %")
left.plot(AT, measured(2), "o-", label="test 2, calibrated")
left.plot(AT, measured(1), "s--", label="test 1, not used")
left.set(xlabel="displacement [mm]", ylabel="force [kN]", ylim=(0, None))
left.legend()
right.plot(values[::50, 0], values[::50, 1], ".", markersize=2, label="posterior")
right.plot(np.exp(MEAN[0] + DEVIATION[0] * z[:, 0]), MEAN[1] + DEVIATION[1] * z[:, 1], "x", color="grey", label="walls that were run")
right.set(xlabel="kn [GPa/m]", ylabel="tan(phi)", xscale="log")
right.legend()
figure.savefig(options.picture, dpi=120)
