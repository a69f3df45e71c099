"""One finished campaign as its folder holds it: samples.csv, statistics.json, and what the store campaign.db adds."""
import csv
import ctypes
import ctypes.util
import json
import pathlib
import re
import sqlite3
import statistics
import struct
import tomllib

MODES = ["FM-1", "FM-2", "FM-3", "FM-4", "FM-5"]
GROUPS = {"FM-1 + FM-2": MODES[:2], "FM-3 + FM-4": MODES[2:4], "FM-5": MODES[4:]}
CRACK, SLIDING = "diagonal shear crack", "sliding"
F, D, D_MAX = "peak_reaction_kN", "displacement_at_80_percent_mm", "displacement_max_mm"
INPUTS = {"ft_j_MPa": "ft,j", "fc_MPa": "fc", "ft_u_MPa": "ft,u", "phi_deg": "φ", "R": "R"}


def samples_of(path):
    """Rows of a samples.csv that answered, by sample number; numbers as numbers, the mode also as `mode`."""
    with open(path, encoding="utf-8") as file:
        rows = [row for row in csv.DictReader(file) if row[F]]
    return {int(r["sample"]): {k: number(v) for k, v in r.items()} | {"sample": int(r["sample"]), "mode": r["failure_mode"]}
            for r in rows}


def number(text):
    try:
        return float(text)
    except ValueError:
        return text


class Campaign:
    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.statistics = json.loads((self.folder / "statistics.json").read_text(encoding="utf-8"))
        self.samples = samples_of(self.folder / "samples.csv")
        self.db = sqlite3.connect(f"file:{self.folder / 'campaign.db'}?mode=ro", uri=True)
        self.study = dict(self.db.execute("SELECT key, value FROM study"))
        self.unpacked = None
        self.add_evidence()

    def add_evidence(self):
        """To each sample what the program saw: signs (value, threshold, first seen at), flags, other readings, scores."""
        for s in self.samples.values():
            s |= {"sign": {}, "flag": {}, "reading": {}, "score": {}, "element": {}}
        for k, element, state, value, threshold, first in self.rows(
                "SELECT g.sample, e.element, g.state, g.value, g.threshold, 1e3 * g.displacement_first_m FROM sign g "
                "JOIN element e ON e.sample = g.sample AND e.position = g.of_element"):
            self.samples[k]["sign"][element, state] = value, threshold, first
        for k, element, measure, value in self.rows("SELECT sample, element, measure, value FROM flag"):
            self.samples[k]["flag"][element + ": " + measure] = value
        for k, what, mode in self.rows("SELECT sample, what, failure_mode FROM reading"):
            self.samples[k]["reading"][what] = mode
        for k, mode, score in self.rows("SELECT sample, failure_mode, score FROM score"):
            self.samples[k]["score"][mode] = score
        for k, element, state in self.rows("SELECT sample, element, state FROM element ORDER BY sample, position"):
            self.samples[k]["element"][element] = state
        for k, sentence in self.rows("SELECT sample, failure_sentence FROM sample"):
            self.samples[k]["sentence"] = sentence

    def rows(self, query):
        return [row for row in self.db.execute(query) if row[0] in self.samples]

    def of(self, mode="all"):
        return [s for s in self.samples.values() if mode in ("all", s["mode"])]

    def table(self, mode, response):
        """n, mean, CoV with intervals of one mode, group or all, as in statistics.json; None without samples."""
        found = self.statistics["table"].get(mode, {}).get(response)
        return found if found and found["n"] else None

    def curves(self):
        """Displacement [mm] and reaction [kN] of every sample, from the packed arrays of the store."""
        if self.unpacked is None:
            found = self.rows("SELECT sample, rows, columns, data FROM curve")
            self.unpacked = {k: unpack(data, rows, columns.split(",")) for k, rows, columns, data in found}
        return self.unpacked

    def push(self):
        """Velocity and damping of the push: the model's, then the study's settings over them."""
        push = next(stage for stage in tomllib.loads(self.study["model"])["stage"] if stage["name"] == "push")
        said = {"velocity": push.get("velocity"), "damping": push.get("damping")}
        for setting in (self.study.get("settings") or "").splitlines():
            match = re.match(r"stage\.push\.(velocity|damping)\s*=\s*\"?([^\"]*)", setting)
            if match:
                said[match[1]] = match[2]
        return said


def unpack(data, rows, columns):
    """Displacement [mm] and reaction [kN] of a stored curve; by libzstd, which the program itself needs."""
    library = ctypes.CDLL(ctypes.util.find_library("zstd") or "libzstd.so.1")
    library.ZSTD_decompress.restype = ctypes.c_size_t
    size = 8 * rows * len(columns)
    buffer = ctypes.create_string_buffer(size)
    got = library.ZSTD_decompress(buffer, ctypes.c_size_t(size), data, ctypes.c_size_t(len(data)))
    if got != size:
        raise SystemExit(f"campaign.db: a curve of {rows} rows does not unpack; the store is damaged")
    numbers = struct.unpack(f"<{rows * len(columns)}d", buffer.raw)

    def column(name, factor):
        first = columns.index(name) * rows
        return [factor * v for v in numbers[first:first + rows]]
    return column("displacement_m", 1e3), column("reaction_N", 1e-3)


def holds(sample, element, state):
    value, threshold, _ = sample["sign"][element, state]
    return value >= threshold


def renamed(sample, thin_splits_hidden=False, bed_sliding_hidden=False):
    """The name an eye might give that overlooks thin splits of a pier, or sliding that opens nothing."""
    def cracked(pier):
        seen = holds(sample, pier, CRACK) or holds(sample, pier, SLIDING)
        return seen and not (thin_splits_hidden and sample["flag"][pier + ": growth of its width"] < 8)
    left, right = cracked("left pier"), cracked("right pier")
    hidden = bed_sliding_hidden and slides(sample)
    if not hidden and (holds(sample, "spandrel", CRACK) or holds(sample, "spandrel", SLIDING)):
        return "FM-3" if left or right else "FM-4"
    return "FM-2" if left and right else "FM-1" if left or right else "FM-5"


def slides(sample):
    """The spandrel slides over 0.9 of its length in one bed without opening it."""
    return sample["flag"]["spandrel: length sliding in one bed"] >= 0.9


def first_pier_crack(sample):
    """Displacement of the first stored state that shows a pier's diagonal crack [mm], or None."""
    seen = [sample["sign"][pier, CRACK][2] for pier in ("left pier", "right pier")]
    return min((d for d in seen if d is not None), default=None)


def growth(sample):
    return max(sample["flag"][f"{side} pier: growth of its width"] for side in ("left", "right"))


def typical(samples):
    """The sample nearest to the medians of peak and D, each distance divided by its standard deviation."""
    if len(samples) < 3:
        return samples[0] if samples else None
    middle = {q: statistics.median(s[q] for s in samples) for q in (F, D)}
    scatter = {q: statistics.stdev(s[q] for s in samples) or 1 for q in (F, D)}
    return min(samples, key=lambda s: sum(((s[q] - middle[q]) / scatter[q]) ** 2 for q in (F, D)))
