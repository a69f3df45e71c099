#!/usr/bin/env python3
"""Counts bodies, touching pairs, shared area and volume of OBJ and COMPAS files, with a method of its own:
faces in triangles, every pair of triangles of two bodies clipped. The numbers of tests/unit/io/mesh_files_test.cpp.

    count_faces.py FILE...
"""
import json
import math
import sys


def sub(a, b):
    return [a[i] - b[i] for i in range(3)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(a):
    length = math.sqrt(dot(a, a))
    return [x / length for x in a] if length else [0, 0, 0]


def read_obj(path):
    corners, bodies = [], []
    for line in open(path, encoding="utf-8"):
        words = line.split()
        if not words:
            continue
        if words[0] == "o":
            bodies.append([])
        elif words[0] == "v":
            corners.append([float(x) for x in words[1:4]])
        elif words[0] == "f":
            bodies[-1].append([corners[int(w.split("/")[0]) - 1] for w in words[1:]])
    return bodies


def mesh_faces(mesh):
    place = {k: [v.get(c, 0.0) for c in "xyz"] for k, v in mesh["vertex"].items()}
    return [[place[str(i)] for i in f] for f in mesh["face"].values()]


def read_compas(path):
    data = json.load(open(path, encoding="utf-8"))["data"]
    if "elements" in data:
        return [mesh_faces(e["data"]["geometry"]["data"]) for e in data["elements"].values()]
    graph = data["graph"].get("data", data["graph"])
    return [mesh_faces(n["block"].get("data", n["block"])) for n in graph["node"].values()]


def ears(face):
    """Triangles of a polygon in space, convex or not, by cutting ears in its mean plane."""
    normal = [0, 0, 0]
    for i, p in enumerate(face):
        c = cross(sub(p, face[0]), sub(face[(i + 1) % len(face)], face[0]))
        normal = [normal[k] + c[k] for k in range(3)]
    normal, rest, out = unit(normal), list(face), []
    if len(face) > 4 and max(abs(dot(sub(p, face[0]), normal)) for p in face) > 0.05:  # dome.obj: folded
        fans = [[(face[i], face[(i + k) % len(face)], face[(i + k + 1) % len(face)])
                 for k in range(1, len(face) - 1)] for i in range(len(face))]
        return min(fans, key=lambda fan: sum(math.dist((0, 0, 0), cross(sub(b, a), sub(c, a))) for a, b, c in fan))

    def turn(a, b, c):
        return dot(cross(sub(b, a), sub(c, a)), normal)

    while len(rest) > 3:
        n = len(rest)
        for i in range(n):
            a, b, c = rest[i - 1], rest[i], rest[(i + 1) % n]
            inside = any(turn(a, b, p) > 1e-12 and turn(b, c, p) > 1e-12 and turn(c, a, p) > 1e-12
                         for p in rest if p not in (a, b, c))
            if turn(a, b, c) > 1e-12 and not inside:
                out.append((a, b, c))
                del rest[i]
                break
        else:
            break
    out.append(tuple(rest[:3]))
    return out


def volume(triangles):
    o = triangles[0][0]
    return sum(dot(sub(a, o), cross(sub(b, o), sub(c, o))) for a, b, c in triangles) / 6


def clipped_area(t, s, normal):
    """Area of the common part of two triangles, both laid into the plane of `normal`."""
    across = unit(cross(normal, [1, 0, 0] if abs(normal[0]) < 0.7 else [0, 1, 0]))
    up = cross(normal, across)
    flat = lambda tri: [(dot(p, across), dot(p, up)) for p in tri]
    poly, by = flat(t), flat(s)[::-1]
    for i in range(3):
        (ax, ay), (bx, by_) = by[i], by[(i + 1) % 3]
        h = [(bx - ax) * (y - ay) - (by_ - ay) * (x - ax) for x, y in poly]
        out = []
        for k, (x, y) in enumerate(poly):
            j = (k + 1) % len(poly)
            if h[k] >= 0:
                out.append((x, y))
            if h[k] * h[j] < 0:
                w = h[k] / (h[k] - h[j])
                out.append((x + w * (poly[j][0] - x), y + w * (poly[j][1] - y)))
        poly = out
        if len(poly) < 3:
            return 0.0
    return abs(sum(poly[k - 1][0] * poly[k][1] - poly[k][0] * poly[k - 1][1] for k in range(len(poly)))) / 2


def main(path):
    bodies = read_obj(path) if path.endswith(".obj") else read_compas(path)
    solids, total = [], 0.0
    for faces in bodies:
        seen, own = set(), []
        for f in faces:  # dome.obj lists every face twice
            key = tuple(sorted(map(tuple, f)))
            if key not in seen:
                seen.add(key)
                own.append(f)
        triangles = [(t, unit(cross(sub(t[1], t[0]), sub(t[2], t[0])))) for f in own for t in ears(f)]
        triangles = [t for t in triangles if t[1] != [0, 0, 0]]
        points = [p for t, _ in triangles for p in t]
        box = [(min(p[k] for p in points), max(p[k] for p in points)) for k in range(3)]
        solids.append((triangles, box))
        total += abs(volume([t for t, _ in triangles]))
    size = max(max(s[1][k][1] for s in solids) - min(s[1][k][0] for s in solids) for k in range(3))
    near = 2e-4 * size
    pairs, area = 0, 0.0
    for i, (ti, bi) in enumerate(solids):
        for tj, bj in solids[i + 1:]:
            if any(bi[k][0] > bj[k][1] + near or bj[k][0] > bi[k][1] + near for k in range(3)):
                continue
            shared = 0.0
            for t, n in ti:
                for s, m in tj:
                    if dot(n, m) > -0.99 or abs(dot(sub(s[0], t[0]), n)) > 10 * near:
                        continue
                    if max(abs(dot(sub(p, t[0]), n)) for p in s) > 10 * near:
                        continue
                    shared += clipped_area(t, s, n)
            if shared > 1e-6 * size * size:
                pairs += 1
                if "-p" in sys.argv: print("P", i, solids.index((tj, bj)), f"{shared:.6g}")
                area += shared
    print(f"{path}: {len(bodies)} bodies, {pairs} pairs, area {area:.6g}, volume {total:.8g}")


if __name__ == "__main__":
    for name in sys.argv[1:]:
        main(name)
