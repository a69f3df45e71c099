"""The table of tested walls: runs them once, keeps what they predict, and tells bias and scatter by kind of failure.

validation/walls.csv     the tests: model file, kind of failure, measured peaks and drifts, statics. Fixed before any run.
validation/predicted.csv what the program says, one row a wall and set of settings; written by `tools/validation walls`
inputs.csv               beside a model of many walls: what is laid over it, a row a wall, a column a key of the model file

A wall enters the statistic unless the rule of `left_out` says why not. One model counts once: several tests of it are
averaged (logarithms), so that a pair of equal walls does not count twice.
"""
import csv
import math
import os

import bias

WALLS, PREDICTED = "validation/walls.csv", "validation/predicted.csv"
KINDS = ["shear", "sliding", "rocking", "mixed"]
# Settings laid over every model: the table itself, and what a choice of it moves.
WITHOUT_B = ["material.joint.mode_2_energy_per_pressure=0 mm"]
AS_BEDS = ["material.joint.head_joint_bond=1", *WITHOUT_B]
SETS = {
    "base": [],
    "eight walls": [],
    "without b": WITHOUT_B,
    "heads as beds": AS_BEDS,
    "2 corners": AS_BEDS + ["solve.point_rule=corners", "solve.points_per_face=2"],
    "cap of Css 9": AS_BEDS + ["material.joint.compression_cap=9"],
    "running bond": AS_BEDS + ["wall.bond=running"],
}
# Sets that are compared with another one than the base.
BESIDE = {name: "heads as beds" for name in ("2 corners", "cap of Css 9", "running bond")}
# The set "eight walls" pushes so many with the scatter of their masonry; all others one wall as it stands.
WALLS_PUSHED = 8
SCATTER = {"clay_brick": ["scatter.use=clay_brick"], "calcium_silicate": ["scatter.use=calcium_silicate"], "stone": ["scatter.use=stone"],
           "tuff": ["scatter.use=tuff"],
           # tensile strengths: JCSS Probabilistic Model Code 3.2, aerated concrete; cohesion as of the others
           "aerated_concrete": ["scatter.joint_tension=0.30", "scatter.joint_cohesion=0.25", "scatter.unit_tension=0.16"]}
# Every push adapts its speed.
PUSH = ["stage.push.velocity=0.1 mm/s", "stage.push.fast_velocity=5 mm/s", "stage.push.fast_below=1e-4"]
ONLY = {  # walls that a set is for; the others stay as they are
    "heads as beds": ("MI1 MI3 PUP1 COMP2_4 MA1 MA2 MA3 MA4 MA5 T1 T2 T3 T5 T6 YTO01 YTO02 YTO06 SW0.1 MW0.1 LW0.1 HfBW0.1 COMP1_3 W1 COMP2_1 PUP3 ISP3 T7 "
                      "YTO05 WI.100 WI.175 WI.250 R5 YTO03 YTO04 LfBW0.1 PUP4").split(),
    "eight walls": ("MI1 MI3 PUP1 J4D J6D MA1 MA2 MA3 MA4 MA5 T1 T2 T3 T5 T6 YTO01 YTO02 YTO06 SW0.1 MW0.1 LW0.1 HfBW0.1 PUP3 ISP3 T7 YTO03 YTO04 "
                    "LfBW0.1 PUP4").split(),
    "2 corners": "J4D J6D MI1 MI3 PUP1 PUP3 COMP2_4 COMP2_1 WI.100 R5 WS.40 WS.100 SW.100".split(),
    "cap of Css 9": "MI1 MI3 PUP1 PUP3 COMP2_4 COMP2_1".split(),
    "running bond": "MI1 MI3 COMP2_4 COMP2_1".split(),
}
COLUMNS = ["set", "wall", "peak_kN", "peak_is_bound", "peak_raw_kN", "at_peak_mm", "at_80_mm", "is_bound", "mode", "judgement", "lift_percent",
           "peak_scatter", "at_80_scatter", "status", "seconds", "build", "state"]
STATICS_EXCEEDED = 1.10  # a bed joint's tension of 0.1 MPa adds about 6 % to the statics of a wall without tension


def read_csv(path):
    if not os.path.exists(path):
        return []
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def numbers(text):
    return [float(x) for x in text.split()]


def geometric_mean(values):
    return math.exp(sum(map(math.log, values)) / len(values))


# --- measured -------------------------------------------------------------------------------------------

def measured_peak(test):
    """Mean of the two directions, or of an interval's ends [kN]."""
    return geometric_mean(numbers(test["peaks_kN"]))


def measured_drift(test):
    """(drift at 80 % [%], whether it is a lower bound); None where it is not told."""
    values = numbers(test["drifts_80_percent"])
    return (geometric_mean(values), test["drift_is_bound"] == "yes") if values else None


def static_bound(test):
    """Largest shear of a rigid wall without tension whose toes are crushed at fm over a rectangle [kN]; None: not statically
    determined. With a level top both ends carry a moment, with a free one the base alone."""
    if test["top"] not in ("level", "free"):
        return None
    length, area = float(test["length_m"]), float(test["length_m"]) * float(test["thickness_m"])
    strength = float(test["fm_MPa"]) * 1e3 if test["fm_MPa"] else math.inf

    def moment(force):
        return force * length / 2 * (1 - force / area / strength)
    top, base = float(test["top_load_kN"]), float(test["top_load_kN"]) + float(test["weight_kN"])
    if test["top"] == "level":
        return (moment(top) + moment(base)) / float(test["height_m"])
    return moment(base) / float(test["load_height_m"])


def left_out(test):
    """Why a test does not enter the statistic; "" where it does. Decided by what is measured alone."""
    if test["confidence"]:
        return test["confidence"]
    bound = static_bound(test)
    if bound is not None and measured_peak(test) > STATICS_EXCEEDED * bound:
        return f"measured peak is {measured_peak(test) / bound:.2f} of what statics allows with the stated axial stress and fm"
    return ""


# Scatter of the drift of replicates that failed alike, and its degrees of freedom: brick and block (EPFL data base of modern masonry walls);
# of stone walls it is 0.29 (37). Two directions of one specimen scatter less, by 0.15: they are no replicates.
DRIFT_SCATTER = 0.21, 18


def test_scatter(tests):
    """sigma_E of peaks from walls that were tested twice, and of drifts from replicates; [(sigma, degrees of freedom)]."""
    by_wall = {}
    for test in tests:
        if not left_out(test):
            by_wall.setdefault(test["wall"], []).append(measured_peak(test))
    peaks = [(values[0], values[1]) for values in by_wall.values() if len(values) == 2]
    return bias.scatter_of_pairs(peaks), DRIFT_SCATTER


# --- predicted -------------------------------------------------------------------------------------------

def predicted_row(name, wall, summary):
    meter = summary["quasi_static"]
    made = summary["provenance"]

    def rounded(value, digits=4):
        return "" if value is None else f"{value:.{digits}g}"
    return {"set": name, "wall": wall, "peak_kN": rounded(summary["peak_reaction_kN"]),
            "peak_is_bound": "yes" if summary["censored_peak"] else "", "peak_raw_kN": rounded(summary["peak_raw_kN"]), "at_peak_mm": rounded(summary["displacement_at_peak_mm"], 3),
            "at_80_mm": rounded(summary["displacement_at_80_percent_mm"], 3),
            "is_bound": "yes" if summary["censored_80"] else "", "mode": summary["failure_mode"]["name"],
            "judgement": meter["judgement"], "lift_percent": rounded(meter["lift_percent"], 2), "status": summary["status"],
            "seconds": rounded(summary["wall_seconds"], 2), "build": made["commit"], "state": summary["state_hash"]}


def predicted_of_walls(name, wall, said):
    """The same of several walls, statistics.json: medians; where too many displacements are bounds, the median of the bounds."""
    of, judged = said["walls"], said["samples"]["judgements"]
    far, peak = of["displacement_at_80_percent_mm"], of["peak_reaction_kN"]

    def rounded(value, digits=4):
        return "" if value is None else f"{value:.{digits}g}"
    modes = of["failure_modes"]
    doubtful = {k: n for k, n in judged.items() if k != "slow enough"}
    return {"set": name, "wall": wall, "peak_kN": rounded(peak["median"] or peak["at_least"]), "peak_is_bound": "" if peak["median"] else "yes",
            "at_peak_mm": rounded(of["displacement_at_peak_mm"]["at_least"], 3), "at_80_mm": rounded(far["median"] or far["at_least"], 3),
            "is_bound": "" if far["median"] else "yes", "mode": max(modes, key=lambda m: modes[m]["count"]) if modes else "",
            "judgement": "slow enough" if not doubtful else ", ".join(f"{n} {k}" for k, n in doubtful.items()),
            "peak_scatter": rounded(peak["log_scatter"], 2), "at_80_scatter": rounded(far["log_scatter"], 2), "status": f"{peak['n']} walls",
            "build": said["commit"]}


def settings_of(test, more=()):
    """What a test lays over its model: its wall's row of the inputs beside the model, its overrides, and `more`. An override with the kind of
    unit is there for the rule of b alone, so it goes where `more` states b: the program refuses a key that no rule asks for."""
    inputs = read_csv(os.path.join(os.path.dirname(test["model"]), "inputs.csv"))
    row = next((row for row in inputs if row["wall"] == test["wall"]), {})
    states_b = any(o.startswith("material.joint.mode_2_energy_per_pressure=") for o in more)
    overrides = [o for o in test["overrides"].split(";") if o and not (states_b and o.startswith("masonry.unit_type="))]
    return [f"{key}={value}" for key, value in row.items() if key != "wall"] + overrides + list(more)


def run_walls(wythe, folder_of, out, names, matches):
    """Runs each model once for each set in `names`; keeps rows of walls that are not run."""
    kept = {(row["set"], row["wall"]): row for row in read_csv(PREDICTED)}
    models = {t["wall"]: t for t in read_csv(WALLS)}
    for name in names:
        for wall, test in models.items():
            if not matches(wall) or wall not in ONLY.get(name, [wall]):
                continue
            settings, folder = settings_of(test, PUSH + SETS[name]), folder_of(os.path.join(out, "walls"), f"{wall} {name}")
            if name == "eight walls" and test["masonry"] in SCATTER:
                answer = wythe(test["model"], settings + SCATTER[test["masonry"]], folder, WALLS_PUSHED)
                row = kept[name, wall] = predicted_of_walls(name, wall, answer)
            else:
                row = kept[name, wall] = predicted_row(name, wall, wythe(test["model"], settings, folder))
            print(f"{name}, {wall}: {row['peak_kN']} kN, {row['mode']}, {row['judgement']}", flush=True)
    order = [(name, wall) for name in SETS for wall in models]
    with open(PREDICTED, "w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(kept[key] for key in order if key in kept)


def predicted(name="base", alone=False):
    """{wall: row}; a wall that a set was not run for is as in the base, or left out with `alone`."""
    wanted = [name] if alone else ["base", BESIDE.get(name, "base"), name]
    rows = read_csv(PREDICTED)
    return {row["wall"]: row for each in wanted for row in rows if row["set"] == each}


def kind_of_mode(mode):
    """The program's name of a failure in the words of the table."""
    for word, kind in (("shear", "shear"), ("sliding", "sliding"), ("rocking", "rocking"), ("toe crushing", "rocking"),
                       ("flexural", "rocking")):
        if word in mode:
            return kind
    return "unclear"


def peak_ratio(test, answer):
    """Predicted over measured peak, or None where the program knows no peak."""
    return float(answer["peak_kN"]) / measured_peak(test) if answer and answer["peak_kN"] else None


def peak_bounds(test, answer):
    """ln(predicted / measured) peak as an interval: a force that still rose where the push ended is a bound, unless the test
    went no farther: then both are the largest force up to there."""
    if peak_ratio(test, answer) is None:
        return None
    went_as_far = bool(test["test_end_mm"]) and float(answer["at_peak_mm"]) >= 0.99 * float(test["test_end_mm"])
    return bias.bounds_of(float(answer["peak_kN"]), measured_peak(test), answer["peak_is_bound"] == "yes" and not went_as_far)


def drift_bounds(test, answer):
    """ln(predicted / measured) drift at 80 % as an interval; None where nothing is known."""
    told = measured_drift(test)
    if told is None or not answer or not answer["at_80_mm"]:
        return None
    drift = float(answer["at_80_mm"]) / 10 / float(test["drift_height_m"])
    return bias.bounds_of(drift, told[0], answer["is_bound"] == "yes", told[1])


# --- the statistic ---------------------------------------------------------------------------------------

def merged(intervals):
    """One model's tests as one: the mean of the logarithms; of bounds the mean bound where all point one way."""
    known = [i for i in intervals if i is not None]
    if not known:
        return None
    exact = [i for i in known if i[0] == i[1]]
    use = exact or known
    low, high = sum(i[0] for i in use) / len(use), sum(i[1] for i in use) / len(use)
    return None if math.isinf(low) and math.isinf(high) else (low, high)


def sample_of(tests, answers, quantity, everything=False):
    """One interval of ln(P/M) for each wall among `tests` that enters the statistic, or of every measured one."""
    by_wall = {}
    for test in tests:
        if left_out(test) and not (everything and is_measured(test)):
            continue
        answer = answers.get(test["wall"])
        interval = peak_bounds(test, answer) if quantity == "peak" else drift_bounds(test, answer)
        by_wall.setdefault(test["wall"], []).append(interval)
    return {wall: merged(intervals) for wall, intervals in by_wall.items()}


def is_measured(test):
    return test["top"] != "portal"  # the tuff wall's reference is computed


def statistics(name="base", everything=False):
    """{quantity: {kind or "all": bias_and_scatter(...)}} of one set of settings, None where no wall says anything."""
    tests, answers = read_csv(WALLS), predicted(name)
    scatter = dict(zip(("peak", "drift"), test_scatter(tests)))
    found = {}
    for quantity in ("peak", "drift"):
        groups = {kind: [t for t in tests if t["kind"] == kind] for kind in KINDS}
        groups["all"] = tests
        found[quantity] = {
            kind: bias.bias_and_scatter(sample_of(group, answers, quantity, everything).values(), scatter[quantity][0])
            for kind, group in groups.items()}
    return found


