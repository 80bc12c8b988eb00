"""How fast a gas forgets its start, by each method: chaos.py CAROM SCENE SVG

Runs SCENE with several methods, compares the trajectories with one of 50 digits, and draws the largest
distance of a ball against simulated time.
"""
import math
import subprocess
import sys
import tempfile

RUNS = [("overlap, 1/240 s", "#d1242f", ["--method", "overlap", "--step", str(1 / 240)]),
        ("overlap, 1/30720 s", "#bf8700", ["--method", "overlap", "--step", str(1 / 30720)]),
        ("event, 16 digits", "#0969da", ["--method", "event"])]
LEFT, TOP, WIDTH, HEIGHT, MARGIN = 70, 30, 560, 240, 40
LOWEST, HIGHEST = -17, 1


def trajectory(carom, scene, options, folder):
    file = f"{folder}/run.xyz"
    subprocess.run([carom, "run", scene, "--quiet", "--trajectory", file, *options], check=True)
    frames = []
    with open(file, encoding="utf-8") as lines:
        for line in lines:
            count = int(line)
            about = next(lines)
            size = [float(about.split('"')[1].split()[axis * 4]) for axis in (0, 1)]
            time = float(about.split("Time=")[1].split()[0])
            frames.append((time, size, [[float(word) for word in next(lines).split()[1:3]] for _ in range(count)]))
    return frames


def farthest(ours, reference):
    """The largest distance of a ball, the shorter way round the box."""
    _, size, places = ours
    distances = []
    for place, other in zip(places, reference[2]):
        steps = [math.remainder(a - b, length) for a, b, length in zip(place, other, size)]
        distances.append(math.hypot(*steps))
    return max(distances)


def main(carom, scene, svg):
    with tempfile.TemporaryDirectory() as folder:
        reference = trajectory(carom, scene, ["--method", "event", "--digits", "50"], folder)
        curves = [(name, fill, [(frame[0], farthest(frame, known)) for frame, known in
                                zip(trajectory(carom, scene, options, folder), reference)])
                  for name, fill, options in RUNS]
    end = reference[-1][0]

    def x(time):
        return LEFT + WIDTH * time / end

    def y(error):
        return TOP + HEIGHT * (HIGHEST - max(LOWEST, math.log10(error) if error else LOWEST)) / (HIGHEST - LOWEST)

    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{LEFT + WIDTH + 20}" height="{TOP + HEIGHT + MARGIN}" '
           'role="img" font-family="sans-serif" font-size="12" fill="#24292f">\n'
           '<title>error of position against simulated time</title>\n'
           '<rect width="100%" height="100%" rx="8" fill="#ffffff" stroke="#d0d7de"/>\n'
           f'<text x="{LEFT - 54}" y="18">largest distance of a ball from the run with 50 digits</text>\n']
    for power in range(-16, 2, 4):
        out.append(f'<line x1="{LEFT}" x2="{LEFT + WIDTH}" y1="{y(10.0 ** power):.1f}" y2="{y(10.0 ** power):.1f}" '
                   f'stroke="#d0d7de"/><text x="{LEFT - 8}" y="{y(10.0 ** power) + 4:.1f}" text-anchor="end">'
                   f'1e{power}</text>\n')
    for second in range(int(end) + 1):
        out.append(f'<text x="{x(second):.1f}" y="{TOP + HEIGHT + 16}" text-anchor="middle">{second} s</text>\n')
    for number, (name, fill, points) in enumerate(curves):
        line = " ".join(f"{x(time):.1f},{y(error):.1f}" for time, error in points if error)
        out.append(f'<polyline points="{line}" fill="none" stroke="{fill}" stroke-width="2"/>\n'
                   f'<text x="{LEFT + 350}" y="{TOP + HEIGHT - 60 + 18 * number}" fill="{fill}">{name}</text>\n')
    out.append(f'<text x="{LEFT + WIDTH}" y="{TOP + HEIGHT + 32}" text-anchor="end">simulated time</text>\n</svg>\n')
    with open(svg, "w", encoding="utf-8") as file:
        file.write("".join(out))


if __name__ == "__main__":
    main(*sys.argv[1:])
