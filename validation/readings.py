"""Quantities read from the files of a run."""
import csv
import json
import os


def load_json(folder, name):
    path = os.path.join(folder, name)
    if not os.path.exists(path):
        return None
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def read_curve(path, x="displacement_mm", y="reaction_kN"):
    """[(x, y)] of a CSV file; [] where there is none."""
    if not os.path.exists(path):
        return []
    with open(path, encoding="utf-8", newline="") as file:
        return [(float(row[x]), float(row[y])) for row in csv.DictReader(file)]


def force_at(curve, displacement):
    for (a, f), (b, g) in zip(curve, curve[1:]):
        if a <= displacement <= b and b > a:
            return f + (g - f) * (displacement - a) / (b - a)
    return None


def secant(curve, share):
    """Stiffness of the line from the origin to the first point with that share of the peak."""
    peak = max(f for _, f in curve)
    for (a, f), (b, g) in zip(curve, curve[1:]):
        if f < share * peak <= g:
            return share * peak / (a + (b - a) * (share * peak - f) / (g - f))
    return None


def read_quantity(folder, quantity):
    """None where the run or the quantity is missing."""
    summary = load_json(folder, "summary.json")
    if summary is None:
        return None
    if quantity == "collapse factor":
        bracket = load_json(folder, "bracket.json")
        return bracket and 0.5 * (bracket["stood"] + bracket["fell"])
    plain = {"load factor of the ramp": "load_factor", "peak": "peak_reaction_kN",
             "initial stiffness": "initial_stiffness_kN_per_mm",
             "displacement at 0.8 of the peak": "first_fall_80_percent_mm"}  # as the paper reads it
    if quantity in plain:
        return summary[plain[quantity]]
    curve = read_curve(os.path.join(folder, "force_displacement.csv"))
    if quantity.startswith("force at "):
        return force_at(curve, float(quantity.split()[2]))
    if quantity == "stiffness at 0.7 of the peak":
        return secant(curve, 0.7)
    raise ValueError(f"no such quantity: {quantity}")
