"""Runs a small wall and reads its states with VTK itself; exit 77 where VTK or wythe is absent."""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml

try:
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
except ImportError:
    # the distribution's own python has the package where another one comes first in PATH
    if sys.executable != "/usr/bin/python3" and os.path.exists("/usr/bin/python3"):
        os.execv("/usr/bin/python3", ["/usr/bin/python3", __file__])
    print("python3-vtk9 is not installed")
    sys.exit(77)

MODEL = """
[wall]
length = "0.8 m"
height = "0.4 m"
thickness = "0.1 m"
bond = "running"
[wall.unit]
length = "0.2 m"
height = "0.1 m"
split = "middle"
density = "1800 kg/m^3"
"""
MATERIAL = """
[material.{name}]
normal_stiffness = "20 GPa/m"
shear_stiffness = "8 GPa/m"
tensile_strength = "0.15 MPa"
cohesion = "0.15 MPa"
friction_angle = "16.2 deg"
residual_friction_angle = "14.6 deg"
residual_cohesion = "0 MPa"
mode_1_energy = "4.3 N/m"
mode_2_energy = "125 N/m"
compressive_strength = "3.96 MPa"
compressive_energy = "12800 N/m"
"""
STAGES = """
[[stage]]
name = "gravity"
[[stage]]
name = "push"
at = { x = "0 m", y = "0.35 m" }
direction = "+x"
velocity = "20 mm/s"
until = "1 mm"
"""
# solids of 24, 6 and 12 litres that stand on each other: a box, a wedge, and a body of two parts
SOLIDS = """{"units": "m", "blocks": [
  {"id": "floor", "polygon": [[-0.5, -0.1], [1, -0.1], [1, 0], [-0.5, 0]], "z": [-0.5, 0.5], "fixed": true},
  {"id": "box", "polygon": [[0, 0], [0.4, 0], [0.4, 0.2], [0, 0.2]], "z": [0, 0.3]},
  {"id": "wedge", "polygon": [[0, 0.2], [0.2, 0.2], [0, 0.4]], "z": [0, 0.3]},
  {"id": "angle", "parts": [{"polygon": [[0.2, 0.2], [0.4, 0.2], [0.4, 0.3], [0.2, 0.3]], "z": [0, 0.3]},
                            {"polygon": [[0.3, 0.3], [0.4, 0.3], [0.4, 0.5], [0.3, 0.5]], "z": [0, 0.3]}]}]}"""
LITRES = {"box": [24.0], "wedge": [6.0], "angle": [6.0, 6.0]}
SPACE = """
[wall]
blocks = "solids.json"
[wall.unit]
density = "1800 kg/m^3"
"""
SPACE_STAGES = """
[[stage]]
name = "gravity"
[[stage]]
name = "push"
at = { block = "angle" }
along = [1, 0, 2]
velocity = "20 mm/s"
until = "1 mm"
"""
BLOCK_ARRAYS = {"displacement_mm", "rotation_mrad", "role", "course"}
SPACE_TURNS = {"rotation_x_mrad", "rotation_y_mrad", "rotation_z_mrad", "rotation_total_mrad"}
JOINT_ARRAYS = {"opening_mm", "slip_mm", "damage", "damage_tension", "damage_shear",
                "normal_stress_MPa", "shear_stress_MPa", "crushing", "kind"}


def read(path):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def arrays(grid):
    data = grid.GetCellData()
    return {data.GetArrayName(i): data.GetArray(i) for i in range(data.GetNumberOfArrays())}


def check_grid(path, cell_type, names, count):
    grid = read(path)
    assert grid.GetNumberOfCells() == count, f"{path}: {grid.GetNumberOfCells()} cells, not {count}"
    assert all(grid.GetCellType(i) == cell_type for i in range(count)), f"{path}: cell types"
    found = arrays(grid)
    assert names <= set(found), f"{path}: {names - set(found)} missing"
    return grid, found


def check_run(out):
    summary = json.loads((out / "summary.json").read_text())
    entries = xml.parse(out / "run.pvd").getroot().findall("Collection/DataSet")
    assert entries, "run.pvd lists nothing"
    times = [float(e.get("timestep")) for e in entries]
    assert times == sorted(times), f"run.pvd: {times} do not rise"
    for entry in entries:
        blocks = entry.get("part") == "0"
        grid, found = check_grid(out / entry.get("file"), 7 if blocks else 3,
                                 BLOCK_ARRAYS if blocks else JOINT_ARRAYS,
                                 summary["blocks" if blocks else "joints"])
        box = grid.GetBounds()
        # the wall is 0.8 m x 0.4 m and was pushed by 1 mm
        assert -0.05 < box[0] and box[1] < 0.85 and box[3] < 0.45, f"{entry.get('file')}: {box}"
        if blocks and float(entry.get("timestep")) == max(times):
            moved = found["displacement_mm"]
            assert moved.GetNumberOfComponents() == 3
            largest = max(moved.GetTuple3(i)[0] for i in range(moved.GetNumberOfTuples()))
            assert 0.9 < largest < 1.5, f"the driven block moved {largest} mm, not 1 mm"


def volume_and_centroid(cell):
    """Of a closed polyhedron whose faces look outwards, by tetrahedra to the origin."""
    volume, sum_x = 0.0, [0.0, 0.0, 0.0]
    for f in range(cell.GetNumberOfFaces()):
        points = cell.GetFace(f).GetPoints()
        corner = [points.GetPoint(k) for k in range(points.GetNumberOfPoints())]
        for a, b in zip(corner[1:], corner[2:]):
            o = corner[0]
            six = (o[0] * (a[1] * b[2] - a[2] * b[1]) - o[1] * (a[0] * b[2] - a[2] * b[0])
                   + o[2] * (a[0] * b[1] - a[1] * b[0]))
            volume += six / 6
            sum_x = [s + six / 24 * (o[c] + a[c] + b[c]) for c, s in enumerate(sum_x)]
    return volume, [s / volume for s in sum_x]


def area_of(cell):
    points = cell.GetPoints()
    corner = [points.GetPoint(k) for k in range(points.GetNumberOfPoints())]
    twice = [0.0, 0.0, 0.0]
    for p, q in zip(corner, corner[1:] + corner[:1]):
        for c in range(3):
            twice[c] += p[c - 2] * q[c - 1] - p[c - 1] * q[c - 2]
    return 0.5 * sum(t * t for t in twice) ** 0.5


def check_space(out):
    """Polyhedra as VTK itself reads them: their number, faces and volumes, and that they moved as their arrays say."""
    summary = json.loads((out / "summary.json").read_text())
    entries = xml.parse(out / "run.pvd").getroot().findall("Collection/DataSet")
    blocks = [out / e.get("file") for e in entries if e.get("part") == "0"]
    joints = [out / e.get("file") for e in entries if e.get("part") == "1"]
    litres = [v for body in LITRES.values() for v in body]
    first = last = None
    for path in blocks:
        grid, found = check_grid(path, 42, BLOCK_ARRAYS | SPACE_TURNS | {"block"}, len(litres))
        assert [int(found["block"].GetTuple1(i)) for i in range(4)] == [0, 1, 2, 2], path
        cells = []
        for i, expected in enumerate(litres):
            cell = grid.GetCell(i)
            assert cell.GetNumberOfFaces() == (5 if i == 1 else 6), f"{path}: faces of cell {i}"
            volume, centroid = volume_and_centroid(cell)
            assert abs(1e3 * volume / expected - 1) < 1e-12, f"{path}: cell {i} holds {1e3 * volume} l"
            cells.append((centroid, found["displacement_mm"].GetTuple3(i)))
        first = first or cells
        last = cells
    assert summary["blocks"] == 3
    for i in (0, 1):  # bodies of one part: the array is the way of the centroid
        for c in range(3):
            moved = 1e3 * (last[i][0][c] - first[i][0][c])
            told = last[i][1][c] - first[i][1][c]
            assert abs(moved - told) < 1e-9, f"cell {i} moved {moved} mm, its array says {told} mm"
    way = (last[2][1][0] - first[2][1][0] + 2 * (last[2][1][2] - first[2][1][2])) / 5 ** 0.5
    assert abs(way - 1) < 0.05, f"the pushed body moved {way} mm along the push, not 1 mm"
    for path in joints:
        grid, found = check_grid(path, 7, JOINT_ARRAYS, summary["joints"])
        areas = sorted(round(area_of(grid.GetCell(i)), 3) for i in range(summary["joints"]))
        assert areas == [0.06, 0.06, 0.12], f"{path}: areas {areas}"


def main():
    program = os.environ.get("WYTHE", "build/release/wythe")
    with tempfile.TemporaryDirectory() as folder:
        model = pathlib.Path(folder) / "model.toml"
        names = ("joint", "unit", "foundation")
        model.write_text(MODEL + "".join(MATERIAL.format(name=n) for n in names) + STAGES)
        out = pathlib.Path(folder) / "out"
        done = subprocess.run([program, "run", str(model), "--out", str(out), "--quiet"],
                              capture_output=True, text=True, check=False)
        assert done.returncode in (0, 3), f"exit {done.returncode}: {done.stderr}"
        check_run(out)
        (pathlib.Path(folder) / "solids.json").write_text(SOLIDS)
        model.write_text(SPACE + MATERIAL.format(name="joint") + SPACE_STAGES)
        out = pathlib.Path(folder) / "space"
        done = subprocess.run([program, "run", str(model), "--out", str(out), "--quiet"],
                              capture_output=True, text=True, check=False)
        assert done.returncode in (0, 3), f"exit {done.returncode}: {done.stderr}"
        check_space(out)


if __name__ == "__main__":
    main()
