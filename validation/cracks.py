"""Order of cracking in the tuff wall, from the joint states a run has written."""
import base64
import os
import re
import struct

THROUGH = 0.999
LINTEL_KINDS = (4, 5)  # lintel chain and its bearing
BED = 0
# Zones by the middle of a joint, undeformed [m]: the wall is 5.10 x 3.62, opening 1.70 to 3.40, soffit 2.63.
ZONES = {
    "pier bases": lambda x, y: y < 0.45,
    "connections": lambda x, y: y > 2.2 and (abs(x - 1.70) < 0.40 or abs(x - 3.40) < 0.40),
    "spandrel": lambda x, y: y > 2.70 and 2.10 <= x <= 3.00,
    "pier shafts": lambda x, y: 0.45 <= y <= 2.2,
}


def read_arrays(path):
    """The arrays of a .vtu file of ours: base64 of an 8-byte length and little-endian values."""
    with open(path, encoding="utf-8") as file:
        text = file.read()
    arrays = {}
    for kind, name, data in re.findall(r'<DataArray type="(\w+)" Name="(\w+)"[^>]*format="binary">([^<]*)<', text):
        raw = base64.b64decode(data)[8:]
        code, size = {"Float64": ("d", 8), "Int32": ("i", 4), "Int64": ("q", 8), "UInt8": ("B", 1)}[kind]
        arrays[name] = struct.unpack(f"<{len(raw) // size}{code}", raw)
    return arrays


def states(folder):
    """[(displacement [mm], arrays of the joints)] in time order."""
    with open(os.path.join(folder, "run.pvd"), encoding="utf-8") as file:
        text = file.read()
    found = re.findall(r'timestep="([^"]+)" part="1" name="joints" file="([^"]+)"', text)
    return [(float(at), read_arrays(os.path.join(folder, name))) for at, name in found]


def middles(arrays):
    points, ends = arrays["Points"], arrays["offsets"]
    result, begin = [], 0
    for end in ends:
        members = [arrays["connectivity"][k] for k in range(begin, end)]
        result.append((sum(points[3 * m] for m in members) / len(members),
                       sum(points[3 * m + 1] for m in members) / len(members)))
        begin = end
    return result


def crack_rows(folder):
    """One row a state: joints cracked through in each zone; of the spandrel's inner part the share of columns with a
    broken bed joint (crossing), the bed joints' levels with slip above 1 mm, the upright joints cracked through."""
    sequence = states(folder)
    at_start = dict(zip(sequence[0][1]["joint"], middles(sequence[0][1])))
    kinds = dict(zip(sequence[0][1]["joint"], sequence[0][1]["kind"]))
    columns = {round(x, 2) for j, (x, y) in at_start.items() if kinds[j] == BED and ZONES["spandrel"](x, y)}
    rows = []
    for at, arrays in sequence:
        row = {"at": at, "upright": 0, **{zone: 0 for zone in ZONES}}
        crossed, levels = set(), set()
        for j, damage, slip in zip(arrays["joint"], arrays["damage"], arrays["slip_mm"]):
            if damage < THROUGH or kinds[j] in LINTEL_KINDS:
                continue
            x, y = at_start[j]
            zone = next((name for name, holds in ZONES.items() if holds(x, y)), None)
            if zone:
                row[zone] += 1
            if zone == "spandrel" and kinds[j] == BED:
                crossed.add(round(x, 2))
                if abs(slip) > 1:
                    levels.add(round(y, 2))
            elif zone == "spandrel":
                row["upright"] += 1
        row["levels"] = len(levels)
        row["crossing"] = len(crossed) / len(columns) if columns else 0.0
        rows.append(row)
    return rows
