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
BLOCK_ARRAYS = {"displacement_mm", "rotation_mrad", "role", "course"}
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


if __name__ == "__main__":
    main()
