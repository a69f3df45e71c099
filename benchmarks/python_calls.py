#!/usr/bin/python3
"""What calling wythe from Python costs: the import, one call against C, a batch against a campaign.

  PYTHONPATH=build/release/python benchmarks/python_calls.py [build/release]

The wall is tiny on purpose (four dry stones, some hundred steps), so that the call weighs more than the mathematics. Calls from
C and from Python alternate in rounds, so that a busy machine troubles both alike; medians are printed.
"""
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILD = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ROOT / "build/release").resolve()
TINY = """
wall = { length = "0.4 m", height = "0.2 m", thickness = "0.2 m", unit = { length = "200 mm", height = "100 mm", split = "none", density = "1800 kg/m^3" } }
stage = [{ name = "gravity" }, { name = "push", at = { x = "0 m", y = "0.15 m" }, velocity = "10 mm/s", until = "0.05 mm" }]
[material.joint]
normal_stiffness = "20 GPa/m"
shear_stiffness = "8 GPa/m"
tensile_strength = "0 MPa"
cohesion = "0 MPa"
residual_cohesion = "0 MPa"
friction_angle = "30 deg"
residual_friction_angle = "30 deg"
compressive_strength = "unlimited"
"""
STUDY = """
[study]
name = "tiny"
model = "tiny.toml"
samples = 1000
seed = 1
[variable.stiffness]
path = "material.joint.normal_stiffness"
distribution = "normal"
mean = "20 GPa/m"
cov = 0.05
"""


def median_ms(seconds):
    return 1e3 * statistics.median(seconds)


def imports():
    """Seconds of fresh interpreters with and without `import wythe`, in turn."""
    found = {"pass": [], "import wythe": []}
    processor = {"pass": [], "import wythe": []}
    for _ in range(21):
        for code, times in found.items():
            begin, before = time.perf_counter(), os.times()
            subprocess.run([sys.executable, "-c", code], check=True)
            times.append(time.perf_counter() - begin)
            after = os.times()
            processor[code].append(after.children_user + after.children_system - before.children_user - before.children_system)
    for of, times in (("by the clock", found), ("of the processor", processor)):
        print(f"import wythe: {median_ms(times['import wythe']) - median_ms(times['pass']):.0f} ms {of} more than an empty "
              f"interpreter ({median_ms(times['pass']):.0f} ms)")


def calls(model, folder):
    """One call from C and from Python."""
    import wythe
    program = folder / "c_calls"
    subprocess.run(["cc", "-O2", f"-I{ROOT}/include", "-o", program, ROOT / "benchmarks/c_calls.c", f"-L{BUILD}", "-lwythe",
                    f"-Wl,-rpath,{BUILD}"], check=True)
    of_c, of_python = [], []
    for _ in range(15):
        done = subprocess.run([program, model, "40"], check=True, capture_output=True, text=True)
        of_c += [float(line) for line in done.stdout.split()]
        for _ in range(40):
            begin = time.perf_counter()
            result = wythe.run(model, progress=False)
            result.curve["reaction_kN"]
            of_python.append(time.perf_counter() - begin)
    c, python = median_ms(of_c), median_ms(of_python)
    print(f"one call: C {c:.2f} ms, Python {python:.2f} ms, difference {python - c:.2f} ms (medians of {len(of_c)} calls)")


def batches(model, folder):
    """1000 walls as a batch, as a campaign, and one by one."""
    import numpy
    import wythe
    (folder / "study.toml").write_text(STUDY)
    drawn = wythe.campaign(folder / "study.toml", folder / "first", progress=False)
    column = next(name for name in drawn.inputs if name != "sample")
    values = numpy.array(drawn.inputs[column])
    seconds = {"batch": [], "campaign": []}
    for turn in range(5):
        begin = time.perf_counter()
        batch = wythe.run_many(model, {"material.joint.normal_stiffness": (values, "GPa/m")}, progress=False)
        seconds["batch"].append(time.perf_counter() - begin)
        begin = time.perf_counter()
        wythe.campaign(folder / "study.toml", folder / f"campaign_{turn}", progress=False)
        seconds["campaign"].append(time.perf_counter() - begin)
    same = sum(a == b for a, b in zip(batch.state_hash, drawn.state_hash))
    begin = time.perf_counter()
    for value in values[:100]:
        wythe.run(model, set={"material.joint.normal_stiffness": (float(value), "GPa/m")}, progress=False)
    alone = 10 * (time.perf_counter() - begin)
    print(f"1000 walls: batch {median_ms(seconds['batch']):.0f} ms, campaign with its store "
          f"{median_ms(seconds['campaign']):.0f} ms, one by one {1e3 * alone:.0f} ms; {same} of 1000 walls have the same bits (the others' input differs in its last digit: it went through its unit)")


with tempfile.TemporaryDirectory() as name:
    path = pathlib.Path(name) / "tiny.toml"
    path.write_text(TINY)
    imports()
    calls(path, path.parent)
    batches(path, path.parent)
