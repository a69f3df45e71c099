"""Which input matters? Sobol indices of the dry wall WS.40, with the inputs of its study.

The wall: validation/vasconcelos_dry_granite_walls, stones without mortar, 40 kN on top, pushed sideways.
Four inputs are not known exactly. A first-order index S is the share of the variance of an answer that goes away
when this input is known. A total index T is the share that stays when everything else is known. S near T means
that the input acts alone; the sum of all S near 1 means that the inputs act side by side.

Estimators: Saltelli and others, Computer Physics Communications 181 (2010); intervals by bootstrap over rows.

  python3 examples/python/sobol.py            1152 walls, some two minutes on two cores
  python3 examples/python/sobol.py --quick    96 walls
"""
import argparse
import pathlib
import statistics
import time
import tomllib

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import wythe

FOLDER = pathlib.Path(__file__).resolve().parents[2] / "validation/vasconcelos_dry_granite_walls"
ANSWERS = {"peak_reaction_kN": "capacity", "initial_stiffness_kN_per_mm": "stiffness"}

parser = argparse.ArgumentParser()
parser.add_argument("--quick", action="store_true")
parser.add_argument("--picture", default="sobol.png")
options = parser.parse_args()
rows = 16 if options.quick else 192
random = np.random.default_rng(1)

# The inputs and their distributions stand in the study; numbers are in the units of its means.
study = tomllib.loads((FOLDER / "study.toml").read_text())
variables = study["variable"]
means = {name: wythe.Quantity(v["mean"]) for name, v in variables.items()}
wall = wythe.Function(
    FOLDER / "model.toml",
    {v["path"]: means[name].unit for name, v in variables.items()},
    list(ANSWERS),
    follow={"material.joint.shear_stiffness": (0.4, variables["kn"]["path"]),
            "material.joint.residual_friction_angle": (1, variables["phi"]["path"])},
    set={"stage.push.velocity": "10 mm/s", "stage.push.until": "30 mm", "stage.push.stop_below": 0.97},  # past the peak
)


def draw(uniforms):
    """Values of the inputs from numbers between 0 and 1, column by column."""
    columns = []
    for column, (name, v) in zip(uniforms.T, variables.items()):
        mean, cov = means[name].value, v["cov"]
        if v["distribution"] == "lognormal":
            spread = np.sqrt(np.log(1 + cov**2))
            inverse = statistics.NormalDist(np.log(mean) - spread**2 / 2, spread).inv_cdf
            columns.append(np.exp([inverse(u) for u in column]))
        else:
            columns.append([statistics.NormalDist(mean, cov * mean).inv_cdf(u) for u in column])
    return np.column_stack(columns)


# Two independent sets of rows, A and B, and for each input the rows of A with this input from B.
count = len(variables)
a, b = draw(random.random((rows, count))), draw(random.random((rows, count)))
mixed = [a.copy() for _ in range(count)]
for i in range(count):
    mixed[i][:, i] = b[:, i]
begin = time.perf_counter()
answers = wall(np.concatenate([a, b, *mixed]))  # one batch: all cores work
seconds = time.perf_counter() - begin
answers = answers.reshape(count + 2, rows, len(ANSWERS))


def indices(pick):
    """First-order and total indices (inputs, answers) from the rows `pick`."""
    of_a, of_b, of_mixed = answers[0, pick], answers[1, pick], answers[2:, pick]
    variance = np.concatenate([of_a, of_b]).var(axis=0)
    centre = np.concatenate([of_a, of_b]).mean(axis=0)
    first = ((of_b - centre) * (of_mixed - of_a)).mean(axis=1) / variance
    total = ((of_a - of_mixed) ** 2).mean(axis=1) / (2 * variance)
    return np.array([first, total])


best = indices(np.arange(rows))
low, high = np.percentile([indices(random.integers(rows, size=rows)) for _ in range(1000)], [2.5, 97.5], axis=0)
print(f"{answers.shape[0] * rows} walls in {seconds:.0f} s")
figure, axes = plt.subplots(1, len(ANSWERS), figsize=(8, 3), sharey=True, layout="constrained")
for k, (name, title) in enumerate(ANSWERS.items()):
    values = answers[:2, :, k].ravel()
    print(f"\n{name}: mean {values.mean():.3g}, CoV {values.std() / values.mean():.3f}")
    for i, variable in enumerate(variables):
        s, t = best[:, i, k]
        print(f"  {variable:8} S {s:5.2f} ({low[0, i, k]:5.2f} to {high[0, i, k]:5.2f})"
              f"   T {t:5.2f} ({low[1, i, k]:5.2f} to {high[1, i, k]:5.2f})")
    for j, label in enumerate(("first order", "total")):
        error = np.abs(np.array([low[j, :, k], high[j, :, k]]) - best[j, :, k])
        axes[k].bar(np.arange(count) + 0.36 * j - 0.18, best[j, :, k], 0.34, yerr=error, label=label, capsize=2)
    axes[k].set_xticks(range(count), variables)
    axes[k].set_title(title)
axes[0].set_ylabel("share of the variance")
axes[0].legend()
figure.savefig(options.picture, dpi=120)
