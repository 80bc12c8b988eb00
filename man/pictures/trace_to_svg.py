"""A picture of what the threads of a run did: trace_to_svg.py TRACE SVG [FRAMES]

TRACE is a file of `carom run --trace`; drawn are its last frames, two if nothing else is said.
"""
import json
import sys

LABEL, WIDTH, ROW, GAP, MARGIN, HEAD = 84, 640, 18, 4, 12, 22
BACK, TEXT, WAIT = "#16181d", "#e6edf3", "#3b424c"
FRAME, COLOURS = "#8b949e", ["#7dcfff", "#ff9e64", "#f7768e", "#9ece6a", "#bb9af7", "#e0af68"]


def main(trace, svg, frames=2):
    with open(trace, encoding="utf-8") as file:
        events = json.load(file)["traceEvents"]
    names = {event["tid"]: event["args"]["name"] for event in events if event["name"] == "thread_name"}
    slices = [event for event in events if event["ph"] == "X"]
    shown = [event for event in slices if event["name"] == "do_frame"][-int(frames):]
    begin = shown[0]["ts"]
    end = shown[-1]["ts"] + shown[-1]["dur"]
    per = WIDTH / (end - begin)
    rows = sorted(names)
    phases = list(dict.fromkeys(event["name"] for event in sorted(slices, key=lambda event: event["ts"])
                                if event["name"] != "do_frame" and not event["name"].startswith("wait ")))
    colours = {"do_frame": FRAME} | {name: COLOURS[k % len(COLOURS)] for k, name in enumerate(phases)}
    height = HEAD + len(rows) * (ROW + GAP) + 24 + 2 * MARGIN
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{LABEL + WIDTH + 2 * MARGIN}" height="{height}" '
           f'role="img" font-family="sans-serif" font-size="12">\n<title>threads of carom in {len(shown)} frames</title>\n'
           f'<rect width="100%" height="100%" rx="8" fill="{BACK}"/>\n']
    x = MARGIN + LABEL
    for name in list(colours) + ["waiting"]:
        out.append(f'<rect x="{x}" y="{MARGIN}" width="10" height="10" fill="{colours.get(name, WAIT)}"/>'
                   f'<text x="{x + 14}" y="{MARGIN + 10}" fill="{TEXT}">{name}</text>\n')
        x += 34 + 6.6 * len(name)
    for number, thread in enumerate(rows):
        y = MARGIN + HEAD + number * (ROW + GAP)
        out.append(f'<text x="{MARGIN}" y="{y + 13}" fill="{TEXT}">{names[thread]}</text>\n')
        for event in slices:
            left, right = max(event["ts"], begin), min(event["ts"] + event["dur"], end)
            if event["tid"] != thread or right <= left:
                continue
            waits = event["name"].startswith("wait ")
            fill = WAIT if waits else colours[event["name"]]
            inset = 6 if waits else 0
            out.append(f'<rect x="{MARGIN + LABEL + (left - begin) * per:.2f}" y="{y + inset}" '
                       f'width="{(right - left) * per:.2f}" height="{ROW - 2 * inset}" fill="{fill}"/>\n')
    y = MARGIN + HEAD + len(rows) * (ROW + GAP) + 14
    out.append(f'<text x="{MARGIN + LABEL}" y="{y}" fill="{TEXT}">0</text>'
               f'<text x="{MARGIN + LABEL + WIDTH}" y="{y}" fill="{TEXT}" text-anchor="end">'
               f'{(end - begin) / 1000:.3g} ms of wall-clock time</text>\n</svg>\n')
    with open(svg, "w", encoding="utf-8") as file:
        file.write("".join(out))


if __name__ == "__main__":
    main(*sys.argv[1:])
