# SPDX-License-Identifier: MIT
"""A frame of `invcal watch` as a picture: what a terminal shows, whichever fonts there are.

    python3 screen_svg.py TEXT < TYPED > PICTURE.svg     TYPED: what a terminal got; the first frame that has TEXT
"""
import re
import sys
from html import escape

WIDE, HIGH, EDGE, COLUMNS = 8, 17, 12, 80
BEGIN, END = "\x1b[?25l\x1b[H", "\x1b[?25h"
INK = {"": "#d5dce3", "1": "#ffffff", "1;32": "#7ddc8f", "1;33": "#f5c451"}
# Of the eight bits of U+2800 and following: column and row of the dot.
DOTS = [(0, 0), (0, 1), (0, 2), (1, 0), (1, 1), (1, 2), (0, 3), (1, 3)]


def marks(character):
    """What is drawn instead of a letter: rectangles (x, y, width, height) in a cell."""
    code = ord(character)
    if 0x2800 <= code < 0x2900:
        return [(1.2 + 4 * x, 1 + 4.1 * y, 2, 2) for bit, (x, y) in enumerate(DOTS) if (code - 0x2800) >> bit & 1]
    if 0x2588 <= code <= 0x258F:  # from the left, so many eighths of a cell
        return [(0, 3, WIDE * (0x2590 - code) / 8, HIGH - 6)]
    return []


def frame(typed, text):
    for part in typed.replace("\r", "").split(BEGIN)[1:]:
        if text in part:
            return part.split(END)[0].rstrip("\n").split("\n")
    sys.exit("screen_svg.py: no frame has: " + text)


def cells(line):
    """(column, character, style) of all but blanks."""
    column, style = 0, ""
    for piece in re.findall(r"\x1b\[[0-9;?]*[A-Za-z]|.", line):
        if piece.startswith("\x1b"):
            if piece.endswith("m"):
                style = piece[2:-1] if piece != "\x1b[0m" else ""
            continue
        if piece != " ":
            yield column, piece, style
        column += 1


def draw(lines):
    words, shapes = [], {}
    for row, line in enumerate(lines):
        top = EDGE + row * HIGH
        after = None  # column and style of a letter that would go on the last word
        for column, character, style in cells(line):
            left = EDGE + column * WIDE
            boxes = marks(character)
            for x, y, width, height in boxes:
                shapes.setdefault(style, []).append(
                    "M%g %gh%gv%gh%gz" % (left + x, top + y, width, height, -width))
            if boxes:
                continue
            if after == (column, style):
                words[-1][2] += character
            else:
                words.append([left, top + 13, character, style])
            after = column + 1, style
    return words, shapes


def main():
    for stream in sys.stdin, sys.stdout:
        stream.reconfigure(encoding="utf-8")
    lines = frame(sys.stdin.read(), sys.argv[1])
    words, shapes = draw(lines)
    width, height = COLUMNS * WIDE + 2 * EDGE, len(lines) * HIGH + 2 * EDGE
    print('<svg xmlns="http://www.w3.org/2000/svg" role="img" width="%d" height="%d" viewBox="0 0 %d %d"\n'
          'font-family="ui-monospace, Menlo, Consolas, DejaVu Sans Mono, monospace" font-size="13">' %
          (width, height, width, height))
    print('<title>The screen of invcal watch</title>\n<rect width="100%" height="100%" rx="6" fill="#161b20"/>')
    for style, paths in shapes.items():
        print('<path fill="%s" d="%s"/>' % (INK[style], "\n".join(paths)))
    for left, base, word, style in words:
        weight = ' font-weight="bold"' if style else ""
        print('<text x="%d" y="%d" textLength="%d" fill="%s"%s>%s</text>' %
              (left, base, WIDE * len(word), INK[style], weight, escape(word)))
    print("</svg>")


main()
