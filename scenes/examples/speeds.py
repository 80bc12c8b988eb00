"""The speeds of a gas against Maxwell, from a trajectory.

    carom run gas --trajectory gas.xyz --every 10
    python3 speeds.py gas.xyz
"""
import math
import sys

speeds = []
with open(sys.argv[1]) as trajectory:
    for frame, line in enumerate(trajectory):
        count = int(line)
        next(trajectory)
        for _ in range(count):
            words = next(trajectory).split()
            # The start is not yet in equilibrium.
            if frame > 0:
                speeds.append(math.hypot(float(words[7]), float(words[8])))

mean = sum(speeds) / len(speeds)
square = sum(v * v for v in speeds) / len(speeds)
width = 4 * mean / 20
bins = [0] * 20
for v in speeds:
    if v < 4 * mean:
        bins[int(v / width)] += 1
for k, n in enumerate(bins):
    v = (k + 0.5) * width
    maxwell = 2 * v / square * math.exp(-v * v / square)
    density = n / len(speeds) / width
    print(f"{v:8.4f} {density:8.5f} {maxwell:8.5f} {'#' * round(40 * density * mean)}")
print(f"mean speed^2 / mean square speed: {mean * mean / square:.5f}, of Maxwell {math.pi / 4:.5f}")
