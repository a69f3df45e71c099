"""A surrogate of a wall: a formula that stands in for it, and how wrong the formula is.

The wall: validation/lourenco_dry_stone_wall. Inputs: the stiffness and friction of its joints and the load on top.
The formula: a polynomial of first, second and third degree, fitted to the capacities of some walls by least squares.

Two errors are told apart. What the fit leaves at its own walls always falls with more terms and proves nothing.
Leaving out each wall in turn and predicting it (cross-validation) is honest: for least squares it needs no new
fit, the residual is divided by 1 - h, with h the wall's leverage. Last, fresh walls tell whether that was true.

  python3 examples/python/surrogate.py            160 walls, half a minute on two cores
  python3 examples/python/surrogate.py --quick    60 walls
"""
import argparse
import itertools
import pathlib
import time

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import wythe

MODEL = pathlib.Path(__file__).resolve().parents[2] / "validation/lourenco_dry_stone_wall/model.toml"
KN, PHI, LOAD = "material.joint.normal_stiffness", "material.joint.friction_angle", "stage.precompression.beam_load"
LOW, HIGH = np.array([3.0, 15.0, 60.0]), np.array([15.0, 40.0, 140.0])

parser = argparse.ArgumentParser()
parser.add_argument("--quick", action="store_true")
parser.add_argument("--picture", default="surrogate.png")
options = parser.parse_args()
known, fresh = (40, 20) if options.quick else (100, 60)
random = np.random.default_rng(3)

wall = wythe.Function(
    MODEL, {KN: "GPa/m", PHI: "deg", LOAD: "kN"},
    follow={"material.joint.shear_stiffness": (0.4, KN), "material.joint.residual_friction_angle": (1, PHI)},
    set={"stage.push.until": "15 mm"},
    bounds="take",  # a wall that slides keeps its force: the capacity is then the force at 15 mm
)


def spread_out(count):
    """Rows between LOW and HIGH: a Latin hypercube, one row in each of `count` slices of every input."""
    slices = np.column_stack([random.permutation(count) for _ in LOW])
    return LOW + (slices + random.random(slices.shape)) / count * (HIGH - LOW)


def terms(x, degree):
    """All products of inputs up to a degree; the inputs run from -1 to 1."""
    x = 2 * (x - LOW) / (HIGH - LOW) - 1
    powers = [p for p in itertools.product(range(degree + 1), repeat=len(LOW)) if sum(p) <= degree]
    return np.column_stack([np.prod(x**p, axis=1) for p in powers])


x, x_fresh = spread_out(known), spread_out(fresh)
begin = time.perf_counter()
peaks = wall(np.concatenate([x, x_fresh]))[:, 0]
seconds = time.perf_counter() - begin
y, y_fresh = peaks[:known], peaks[known:]
print(f"{len(peaks)} walls in {seconds:.0f} s; capacity {peaks.min():.1f} to {peaks.max():.1f} kN, deviation {y.std():.2f} kN")

print("degree  terms  at its own walls  left out in turn  fresh walls    Q2")
errors = {}
for degree in (1, 2, 3):
    matrix = terms(x, degree)
    weights = np.linalg.lstsq(matrix, y, rcond=None)[0]
    leverage = np.einsum("ij,ji->i", matrix, np.linalg.pinv(matrix))
    residual = y - matrix @ weights
    left_out = residual / (1 - leverage)
    predicted = terms(x_fresh, degree) @ weights
    own, cross, new = (np.sqrt(np.mean(e**2)) for e in (residual, left_out, y_fresh - predicted))
    errors[degree] = (own, cross, new, predicted)
    print(f"{degree:6} {matrix.shape[1]:6} {own:14.2f} kN {cross:14.2f} kN {new:9.2f} kN   {1 - (cross / y.std()) ** 2:.3f}")
best = min(errors, key=lambda degree: errors[degree][1])
print(f"chosen by cross-validation: degree {best}, error {errors[best][1]:.2f} kN; fresh walls say {errors[best][2]:.2f} kN")

figure, (left, right) = plt.subplots(1, 2, figsize=(8, 3.4), layout="constrained")
for place, label in enumerate(("at its own walls", "left out in turn", "fresh walls")):
    left.plot(list(errors), [e[place] for e in errors.values()], "o-", label=label)
left.set(xlabel="degree", ylabel="error [kN]", xticks=list(errors), ylim=(0, None))
left.legend()
right.plot(y_fresh, errors[best][3], ".")
right.axline((30, 30), slope=1, color="grey", linewidth=0.8)
right.set(xlabel="fresh walls, run [kN]", ylabel=f"formula of degree {best} [kN]")
figure.savefig(options.picture, dpi=120)
