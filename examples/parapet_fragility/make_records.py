"""Makes records/*.csv: artificial earthquakes of 8 s, each from 30 sines with drawn phases under an envelope.

python3 make_records.py      No record of a real earthquake is in them.

  a(t) = e(t) sum_k A(f_k) sin(2 pi f_k t + p_k),   f_k from 0.8 to 12 Hz,   p_k drawn
  A(f) = 1 / sqrt((1 - (f/fg)^2)^2 + (2 z f/fg)^2), a ground of frequency fg and damping z = 0.6
  e(t) rises as t^2 up to 1.2 s, stays for d, and falls as exp(-1.2 (t - 1.2 - d))

fg and d are drawn for each record, so that records of one peak acceleration differ in frequency and length.
"""
import math
import pathlib

STEP, END, RECORDS = 0.01, 8.0, 16
SEED = 2024
state = SEED


def draw() -> float:  # a number in [0, 1), the same on every machine (Park and Miller)
    global state
    state = 48271 * state % 2147483647
    return state / 2147483647


def record() -> list[float]:
    ground, strong = 1.0 + 2.5 * draw(), 1.0 + 3.0 * draw()
    sines = []
    for k in range(30):
        f = 0.8 * 15 ** (k / 29)
        ratio = f / ground
        sines.append((f, 1 / math.hypot(1 - ratio**2, 1.2 * ratio), 2 * math.pi * draw()))

    def envelope(t: float) -> float:
        return (t / 1.2) ** 2 if t < 1.2 else 1.0 if t < 1.2 + strong else math.exp(-1.2 * (t - 1.2 - strong))

    times = [STEP * k for k in range(int(END / STEP) + 1)]
    values = [envelope(t) * sum(a * math.sin(2 * math.pi * f * t + p) for f, a, p in sines) for t in times]
    # take a share of the envelope off, so that the ground is at rest at the end
    weights = [envelope(t) for t in times]
    drift = sum(values) / sum(weights)
    values = [v - drift * w for v, w in zip(values, weights)]
    peak = max(map(abs, values))
    return [v / peak for v in values]


folder = pathlib.Path(__file__).parent / "records"
folder.mkdir(exist_ok=True)
for number in range(1, RECORDS + 1):
    lines = ["# artificial, by make_records.py; one value every 0.01 s, peak 1 m/s2", "acceleration_m_per_s2"]
    lines += [f"{value:.4f}" for value in record()]
    (folder / f"artificial_{number:02}.csv").write_text("\n".join(lines) + "\n")
