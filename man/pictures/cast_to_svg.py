"""An animated SVG of an asciicast v2 that carom wrote: cast_to_svg.py CAST SVG

The frames stand side by side in a strip, which moves behind a window of one frame's size.
"""
import json
import re
import sys

CELL_WIDTH, LINE, FONT, MARGIN = 8.4, 16, 14, 10
BACK, BORDER = "#16181d", "#6e7681"
COLOURS = ["#f4a3ff", "#ff9e64", "#7dcfff", "#9ece6a", "#f7768e", "#e0af68", "#73daca", "#bb9af7",
           "#ffd866", "#7aa2f7"]
STEP = re.compile(r"\x1b\[(\d+);(\d+)H|\x1b\[([?\d;]*)([A-Za-z])|(.)")


def colour(glyph):
    if glyph in "+-|":
        return BORDER
    return "#ffffff" if glyph == "O" else COLOURS[int(glyph, 36) % len(COLOURS)]


class Screen:
    def __init__(self, columns, rows):
        self.columns, self.rows = columns, rows
        self.clear()

    def clear(self):
        self.cells = [[" "] * self.columns for _ in range(self.rows)]
        self.row = self.column = 0

    def write(self, text):
        for row, column, _, final, glyph in STEP.findall(text):
            if row:
                self.row, self.column = int(row) - 1, int(column) - 1
            elif final == "J":
                self.clear()
            elif glyph:
                self.cells[self.row][self.column] = glyph
                self.column += 1


def runs(row):
    """Where glyphs of one colour stand side by side: (column, text, colour)."""
    column = 0
    while column < len(row):
        end = column + 1
        if row[column] != " ":
            ours = colour(row[column])
            while end < len(row) and row[end] != " " and colour(row[end]) == ours:
                end += 1
            yield column, "".join(row[column:end]), ours
        column = end


def text_of(cells, kinds):
    lines = []
    for number, row in enumerate(cells):
        spans = "".join(f'<tspan x="{column * CELL_WIDTH:g}" class="{kinds.setdefault(ours, "c%d" % len(kinds))}">'
                        f"{text}</tspan>" for column, text, ours in runs(row))
        if spans:
            lines.append(f'<text y="{number * LINE + FONT}">{spans}</text>')
    return "".join(lines)


def main(cast, svg):
    with open(cast, encoding="utf-8") as file:
        header = json.loads(file.readline())
        events = [json.loads(line) for line in file]
    screen = Screen(header["width"], header["height"])
    pictures, times = [], []
    for time, _, text in events:
        screen.write(text)
        pictures.append([row[:] for row in screen.cells])
        times.append(time)
    # What never changes, as the border, is drawn once.
    still = [[cells[0] if len(set(cells)) == 1 else " " for cells in zip(*rows)] for rows in zip(*pictures)]
    kinds = {}
    frames = [text_of([[" " if fixed != " " else glyph for fixed, glyph in zip(*rows)]
                       for rows in zip(still, picture)], kinds) for picture in pictures]
    width, height = header["width"] * CELL_WIDTH, header["height"] * LINE + 4
    seconds = times[-1] + (times[1] - times[0])
    # A frame of the last moment stays for a second.
    total = seconds + 1
    stops = "".join(f"{100 * time / total:.3g}%{{transform:translateX({-number * width:g}px)}}"
                    for number, time in enumerate(times))
    strip = "".join(f'<g transform="translate({number * width:g},0)">{frame}</g>'
                    for number, frame in enumerate(frames))
    back = text_of(still, kinds)
    classes = "".join(f".{name}{{fill:{ours}}}" for ours, name in kinds.items())
    with open(svg, "w", encoding="utf-8") as file:
        file.write(
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{width + 2 * MARGIN:g}" '
            f'height="{height + 2 * MARGIN:g}" role="img">\n'
            f"<title>{header['title']}, played by carom</title>\n"
            f"<style>text{{font:{FONT}px ui-monospace,Menlo,Consolas,'DejaVu Sans Mono',monospace;"
            f"white-space:pre}}{classes}"
            f"#strip{{animation:play {total:g}s step-end infinite}}"
            f"@keyframes play{{{stops}}}</style>\n"
            f'<rect width="100%" height="100%" rx="8" fill="{BACK}"/>\n'
            f'<svg x="{MARGIN}" y="{MARGIN}" width="{width:g}" height="{height:g}">'
            f'{back}<g id="strip">{strip}</g></svg>\n</svg>\n')


if __name__ == "__main__":
    main(*sys.argv[1:])
