# SPDX-License-Identifier: MIT
"""Faults for the self-test: name, the check that must turn red, the edit of clean.html."""
from checks import (COLOURS, CUT, FORMED, LISTEN, MARKS, OVERLAP, QUIET, SHEETS, SMALL, TEXT,
                    WHITE)

END = "</main>"
STYLE = "</style>\n</head>"
SECOND = '<text class="ink" x="100" y="30">second</text>'
CIRCLE = '<circle class="c1 full" cx="200" cy="60" r="5"/>'


def last(markup):
    """Adds to the end of the page."""
    return END, markup + END


def css(rules):
    return STYLE, rules + STYLE


EDITS = [
    ("clean", None, last("")),
    ("wide", CUT, ('<div class="wide">', "<div>")),
    ("hidden", CUT, last('<p style="overflow:hidden;white-space:nowrap;width:9em">'
                         "more words than there is space for</p>")),
    ("low", CUT, last('<p style="overflow:hidden;height:1em;width:9em">'
                      "more words than there is space for</p>")),
    ("outside", CUT, (SECOND, SECOND.replace("100", "380"))),
    ("mark-outside", CUT, (CIRCLE, CIRCLE.replace('cy="60"', 'cy="198"'))),
    ("clipped", CUT, last('<p style="clip-path:inset(0 50% 0 0)">half of this</p>')),
    ("number", CUT, last('<p style="overflow-wrap:anywhere;width:3em">1.23456789</p>')),
    ("print-wide", CUT, ("  .wide { overflow-x: visible }\n  td { white-space: normal }\n",
                         "  .wide { width: 200px }\n")),
    ("overlap", OVERLAP, (SECOND, SECOND.replace("100", "30"))),
    ("tight-lines", OVERLAP, last('<p style="line-height:0.6;width:4em">'
                                  "gypsy bold gypsy bold gypsy bold</p>")),
    ("html-upon-svg", OVERLAP, last('<p style="margin:-180px 0 180px 110px;width:6em">beta</p>')),
    ("faint", TEXT, last('<p style="color:#7f7f7f">faint by day</p>')),
    ("faint-by-day", TEXT, css("@media (prefers-color-scheme:light){p{color:#999}}")),
    ("faint-by-night", TEXT, css("@media screen and (prefers-color-scheme:dark){p{color:#555}}")),
    ("faint-in-print", TEXT, css("@media print{p{color:#999}}")),
    ("opacity", TEXT, last('<div style="opacity:0.4"><p>as if behind a veil</p></div>')),
    ("on-bar", TEXT, (SECOND, '<rect class="c1 full" x="90" y="15" width="80" height="20"/>'
                      + SECOND)),
    ("on-gradient", TEXT, (SECOND, '<linearGradient id="g"><stop stop-color="#fff"/>'
                           '<stop offset="1" stop-color="#444"/></linearGradient><rect '
                           'class="shade" fill="url(#g)" x="90" y="15" width="80" height="20"/>'
                           + SECOND)),
    ("covered", TEXT, (SECOND, SECOND + '<rect class="c1 full" x="95" y="15" width="80" '
                       'height="20"/>')),
    ("line-through", TEXT, (SECOND, '<line class="c1 curve" x1="120" y1="5" x2="121" y2="60"/>'
                            + SECOND)),
    ("faint-mark", MARKS, (CIRCLE, '<circle fill="#9a9a9a" opacity="0.4" cx="200" cy="160" r="5"/>'
                           + CIRCLE)),
    ("faint-line", MARKS, (CIRCLE, CIRCLE + '<line x1="20" y1="180" x2="380" y2="180" '
                           'stroke="#777" stroke-opacity="0.5"/>')),
    ("faint-outline", MARKS, (CIRCLE, '<circle fill="#aaa" stroke="#ddd" cx="200" cy="160" '
                              'r="5"/>' + CIRCLE)),
    ("dark-paper", WHITE, css("@media print{p{background:#333;color:#fff;"
                              "print-color-adjust:exact}}")),
    ("small", SMALL["desktop"], last('<p style="font-size:8.4px">fine print</p>')),
    ("small-phone", SMALL["phone"], css("@media (max-width:500px){p{font-size:7px}}")),
    ("small-print", SMALL["print"], css("@media print{p{font-size:5.5pt}}")),
    ("alike", COLOURS, (' stroke-dasharray="6 4"', "")),
    ("script", QUIET, last("<script></script>")),
    ("event", QUIET, last('<p onclick="x()">press</p>')),
    ("image", QUIET, last('<img alt="" src="x.png">')),
    ("link", QUIET, last('<p><a style="color:inherit" href="https://example.org/">away</a></p>')),
    ("font", QUIET, css("@font-face{font-family:f;src:url(f.woff)}")),
    ("import", QUIET, css('@import "x.css";')),
    ("escaped", QUIET, css("main::after{content:u\\72l(x.png)}")),  # only the request shows it
    ("unclosed", FORMED, last("<p><b>bold</p>")),
    ("void", FORMED, last("<div/></div>")),
    ("lang", LISTEN, ('<html lang="en">', "<html>")),
    ("no-title", LISTEN, ("<title>A page without a fault</title>", "")),
    ("same-id", LISTEN, last('<p id="a">one</p><p id="a">two</p>')),
    ("jump", LISTEN, last("<h4>deep</h4>")),
    ("two-h1", LISTEN, last("<h1>again</h1>")),
    ("no-viewport", LISTEN, ('<meta name="viewport" content="width=device-width, initial-scale=1">',
                             "")),
    ("mute-picture", LISTEN, ("<title>Two lines</title>\n", "")),
    ("no-role", LISTEN, ('role="img" ', "")),
    ("scope", LISTEN, ('<th scope="col">value', "<th>value")),
    ("caption", LISTEN, ("<caption>Parameters</caption>\n", "")),
    ("two-mains", LISTEN, last("</main><main>")),
    ("letter", SHEETS, ("size: A4", "size: letter")),
    ("torn", SHEETS, last('<svg role="img" aria-label="tall" width="300" height="2400">'
                          '<g font-size="14" class="ink">' +
                          "".join('<text x="9" y="%d">line</text>' % y
                                  for y in range(20, 2390, 16)) +
                          "</g></svg>")),
]


def planted(clean):
    """Yields file name, check and text of each page and picture."""
    for name, check, (old, new) in EDITS:
        assert clean.count(old) == 1, name
        yield name + ".html", check, clean.replace(old, new)
    style = clean[clean.index("<style>"):clean.index("</style>")] + "</style>"
    picture = clean[clean.index("<svg"):clean.index("</svg>")] + style + "</svg>\n"
    picture = picture.replace("<svg", '<svg xmlns="http://www.w3.org/2000/svg"')
    yield "clean.svg", None, picture
    yield "ampersand.svg", FORMED, picture.replace("first", "a & b")
    yield "outside.svg", CUT, picture.replace(SECOND, SECOND.replace("100", "380"))
