"""Makes record.csv: an artificial earthquake of 8 s, from 40 sines with fixed phases under an envelope.

python3 make_record.py > record.csv      No record of a real earthquake is in it.
"""
import math

STEP, END = 0.005, 8.0
SEED = 2024
state = SEED


def draw() -> float:  # a number in [0, 1), the same on every machine (Park and Miller)
    global state
    state = 48271 * state % 2147483647
    return state / 2147483647


# from 1.2 to 14 Hz, less of the high ones; each phase drawn
sines = [(1.2 * 12 ** (k / 39), 2 * math.pi * draw()) for k in range(40)]


def envelope(t: float) -> float:
    return (t / 1.5) ** 2 if t < 1.5 else 1.0 if t < 4.5 else math.exp(-0.9 * (t - 4.5))


def raw(t: float) -> float:
    return envelope(t) * sum(math.sin(2 * math.pi * f * t + p) / (1 + f / 4) for f, p in sines)


times = [STEP * k for k in range(int(END / STEP) + 1)]
values = [raw(t) for t in times]
# take a line off the velocity, so that the ground is at rest at the end
drift = sum(values) / len(values)
weights = [envelope(t) for t in times]
values = [v - drift * len(values) * w / sum(weights) for v, w in zip(values, weights)]
peak = max(map(abs, values))
print("# artificial, by make_record.py; peak 1 m/s2")
print("time_s,acceleration_m_per_s2")
for t, v in zip(times, values):
    print(f"{t:.3f},{v / peak:.6f}")
