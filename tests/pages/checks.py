# SPDX-License-Identifier: MIT
"""The checks, by name."""
QUIET = "it requests nothing and runs nothing"
FORMED = "it is well formed"
LISTEN = "a screen reader can read it"
CUT = "nothing is cut off"
OVERLAP = "no two texts overlap"
TEXT = "text stands out from what is behind it"
MARKS = "lines and markers stand out"
WHITE = "the paper is white"
SMALL = {"phone": "no text is below 7.5 px, or 6 in a picture alone", "desktop": "no text is below 9 px",
         "print": "no text is below 6 pt"}
COLOURS = "data colours differ for every eye"
SHEETS = "all text is on the sheets"
