# SPDX-License-Identifier: MIT
"""Checks pages and pictures: nothing is cut off, overlaps or is unreadable. See pages.sh."""
import base64
import collections
import html
import html.parser
import json
import os
import pathlib
import re
import subprocess
import sys
import time
import unicodedata
import xml.etree.ElementTree

import checks
import colours
from browser import Browser
from planted import planted

HERE = pathlib.Path(__file__).parent
LOOK = (HERE / "look.js").read_text()
RULES = (HERE / "rules.js").read_text()
SIGNS = "Az09±²µσΔ°·−–×"  # every font must have these

FEW_WORDS = 12  # a sheet with fewer is nearly empty
MORE = re.compile("At the stand|prior")  # what needs one more sheet
A4 = (794, 1123)  # CSS pixels
MARGIN = 38       # 1 cm, where the page states none
# Width, height, scale of the device, smallest font; CSS pixels, of which 8 are 6 pt.
VIEWS = {"phone": (360, 740, 2, 7.5), "desktop": (1280, 900, 1, 9), "print": (None, None, 1, 8)}
PICTURE_FONT = 6  # a picture alone shrinks to the phone, and can be enlarged
STRIP = 6000      # tallest screenshot, CSS pixels
SHOTS = os.environ.get("SHOTS") != "0"  # screenshots of what passes take half of the time
# Smallest CIEDE2000 difference of two data colours that nothing else distinguishes. The palette of Okabe
# and Ito, made for all eyes, has 10.9 between orange and purple for tritanopia.
UNLIKE = 10
SHOWN = 6         # faults shown for one check


class Source(html.parser.HTMLParser):
    """What the source of a page loads, runs, or does not close."""

    VOID = set("area base br col embed hr img input link meta source track wbr".split())
    ADDRESSES = set("src href xlink:href srcset data action formaction poster background".split())
    BANNED = set("script iframe object embed link base frame applet portal".split())

    def __init__(self, text):
        super().__init__()
        self.outside, self.unbalanced, self.open = [], [], []
        self.feed(text)
        self.close()
        self.unbalanced += ["<%s> is never closed" % tag for tag in self.open]

    def handle_starttag(self, tag, attrs):
        self.look(tag, attrs)
        if tag not in self.VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attrs):
        self.look(tag, attrs)
        if tag not in self.VOID and "svg" not in self.open and tag != "svg":
            self.unbalanced.append("<%s/> does not close itself in HTML" % tag)

    def handle_endtag(self, tag):
        if self.open and self.open[-1] == tag:
            self.open.pop()
        else:
            self.unbalanced.append("</%s> closes <%s>, line %d" % (
                tag, self.open[-1] if self.open else "", self.getpos()[0]))
            if tag in self.open:
                while self.open.pop() != tag:
                    pass

    def handle_data(self, data):
        if self.open and self.open[-1] == "style":
            self.look_at_css(data)

    def look(self, tag, attrs):
        names = [name for name, _ in attrs]
        if tag in self.BANNED:
            self.outside.append("<%s>" % tag)
        if len(set(names)) < len(names):
            self.unbalanced.append("<%s> has an attribute twice" % tag)
        for name, value in attrs:
            value = (value or "").strip()
            if name.startswith("on") or (name == "http-equiv" and value.lower() == "refresh"):
                self.outside.append("<%s %s>" % (tag, name))
            elif name in self.ADDRESSES and not value.startswith(("#", "data:")):
                self.outside.append("<%s %s=%s>" % (tag, name, value))
            else:
                self.look_at_css(value if name not in ("alt", "content", "title") else "")

    def look_at_css(self, css):
        self.outside += re.findall(r"@import[^;]*|url\(\s*['\"]?(?!#|data:|['\"#])[^)]*\)", css)


class Gate:
    def __init__(self, browser, folder, verbose):
        self.browser, self.folder, self.verbose = browser, folder, verbose
        self.passed = 0
        self.failed = []  # names of checks

    def check(self, where, name, faults, figure=""):
        self.passed += not faults
        if faults:
            self.failed.append(name)
        if self.verbose:
            print("pages: %s: %s%s: %s" % (where, name, figure, "FAIL" if faults else "PASS"))
            for fault in faults[:SHOWN]:
                print("    " + fault)
            if len(faults) > SHOWN:
                print("    and %d more" % (len(faults) - SHOWN))
            sys.stdout.flush()

    def page(self, path):
        """All checks of one page. A page that cannot be read or shown is one fault."""
        try:
            self.look_at(path, path.name, path.resolve().as_uri())
        except (EOFError, OSError, UnicodeDecodeError, subprocess.CalledProcessError) as error:
            self.check(path.name, "it can be checked", [str(error)])

    def look_at(self, path, name, address):
        text = path.read_text(encoding="utf-8")
        for old in self.folder.glob(name + "[-.]*"):
            if old.suffix in (".png", ".pdf"):
                old.unlink()
        asked = [url for url in self.browser.open(address) if url != address]
        if not self.source(name, text, path.suffix == ".svg", asked):
            return  # the browser shows no picture
        rules = self.run(RULES, SIGNS)
        self.check(name, checks.LISTEN, rules["wrong"])
        margins = [rules["margins"].get(side, MARGIN)
                   for side in ("Left", "Top", "Right", "Bottom")]
        for view in VIEWS:
            for scheme in ("light", "dark"):
                self.rendering(path, view, scheme, margins)
        self.paper(path, margins)

    def source(self, name, text, is_picture, asked):
        """Returns whether a browser can show it."""
        source = Source(text)
        self.check(name, checks.QUIET,
                   source.outside + ["requested " + url for url in asked if url[:5] != "data:"])
        if is_picture:
            try:
                xml.etree.ElementTree.fromstring(text)
            except xml.etree.ElementTree.ParseError as error:
                self.check(name, checks.FORMED, [str(error)])
                return False
        self.check(name, checks.FORMED, source.unbalanced)
        return True

    def run(self, script, argument):
        function = script[script.index("\n(") + 1:]  # below the comments
        return self.browser.evaluate("(%s)(%s)" % (function, json.dumps(argument)))

    def set_view(self, width, height, scale):
        self.browser.call("Emulation.setDeviceMetricsOverride", width=width, height=height,
                          deviceScaleFactor=scale, mobile=False)
        for _ in range(500):
            if self.browser.evaluate("innerWidth + 'x' + innerHeight") == "%dx%d" % (width, height):
                return self.browser.evaluate(
                    "Math.ceil(document.documentElement.getBoundingClientRect().height)")
            time.sleep(0.01)
        raise EOFError("the window does not become %d x %d" % (width, height))

    def set_media(self, view, scheme):
        self.browser.call("Emulation.setEmulatedMedia",
                          media="print" if view == "print" else "screen",
                          features=[{"name": "prefers-color-scheme", "value": scheme}])

    def rendering(self, path, view, scheme, margins):
        width, height, scale, font = VIEWS[view]
        if path.suffix == ".svg":
            font = min(font, PICTURE_FONT)
        if view == "print":
            width = int(A4[0] - margins[0] - margins[2])
            height = int(A4[1] - margins[1] - margins[3])
        self.set_media(view, scheme)
        high = max(height, self.set_view(width, height, scale))
        self.set_view(width, high, scale)  # all of it is visible
        found = self.run(LOOK, {"print": view == "print", "font": font})
        before = len(self.failed)
        where = "%s at %s, %s" % (path.name, view, scheme)
        self.check(where, checks.CUT, found["cut"])
        self.check(where, checks.OVERLAP, found["overlap"])
        self.check(where, checks.TEXT, found["text"])
        self.check(where, checks.MARKS, found["marks"])
        if view == "print":
            self.check(where, checks.WHITE, found["paper"])
        unit, scale = ("pt", 0.75) if view == "print" else ("px", 1)
        faults = found["small"] if found["smallest"] else ["there is no text"]
        self.check(where, checks.SMALL[view], faults,
                   ", smallest %.1f %s" % ((found["smallest"] or 0) * scale, unit))
        if view == "desktop":
            self.colours(where, found["colours"])
        self.words = found["words"]
        if SHOTS or len(self.failed) > before:
            self.screenshot("%s-%s-%s" % (path.name, view, scheme), width, high)

    def screenshot(self, name, width, high):
        for number, top in enumerate(range(0, high, STRIP)):
            part = {"x": 0, "y": top, "width": width, "height": min(STRIP, high - top), "scale": 1}
            data = self.browser.call("Page.captureScreenshot", clip=part)["data"]
            suffix = "-%d" % (number + 1) if high > STRIP else ""
            (self.folder / (name + suffix + ".png")).write_bytes(base64.b64decode(data))

    def colours(self, where, pictures):
        """Two colours of one picture differ enough for all eyes, or each has a shape or dash that the
        other lacks."""
        faults, least = [], None
        for used in pictures:
            for i, (a, kinds_a) in enumerate(used):
                for b, kinds_b in used[:i]:
                    difference, eye = colours.nearest(a, b)
                    least = difference if least is None else min(least, difference)
                    apart = set(kinds_a) - set(kinds_b) and set(kinds_b) - set(kinds_a)
                    if difference < UNLIKE and not apart:
                        faults.append("%s and %s: %.1f, %s" % (a, b, difference, eye))
        self.check(where, checks.COLOURS, faults,
                   ", nearest %.1f" % least if least is not None else "")

    def paper(self, path, margins):
        """The page as a PDF: every letter is within the margins of some sheet; a header, if it has one,
        is in the upper margin of each."""
        inches = [m / 96 for m in margins]
        pdf = self.folder / (path.name + ".pdf")
        data = self.browser.call(
            "Page.printToPDF", preferCSSPageSize=True, paperWidth=A4[0] / 96,
            paperHeight=A4[1] / 96, marginLeft=inches[0], marginTop=inches[1],
            marginRight=inches[2], marginBottom=inches[3])["data"]
        pdf.write_bytes(base64.b64decode(data))
        boxes = subprocess.run(["pdftotext", "-bbox", str(pdf), "-"], check=True,
                               capture_output=True, text=True).stdout
        faults, letters, sheets, headers = [], collections.Counter(), 0, []
        words = []  # of each sheet
        has_header = "@top-right" in path.read_text(encoding="utf-8")
        for line in boxes.splitlines():
            sheet = re.search(r'<page width="([\d.]+)" height="([\d.]+)"', line)
            word = re.search(r'<word xMin="(.*?)" yMin="(.*?)" xMax="(.*?)" yMax="(.*?)">(.*)</',
                             line)
            if sheet:
                sheets += 1
                headers.append("")
                words.append(0)
                width, height = float(sheet[1]), float(sheet[2])
                if abs(width - A4[0] * 0.75) > 2 or abs(height - A4[1] * 0.75) > 2:
                    faults.append("sheet %d is not A4: %g x %g pt" % (sheets, width, height))
            elif word:
                box = [float(word[i]) for i in range(1, 5)]
                edge = [m * 0.75 - 2 for m in margins]
                if has_header and 8 < box[1] and box[3] < edge[1] and box[2] <= width - edge[2]:
                    headers[-1] += word[5]
                    continue
                if (box[0] < edge[0] or box[1] < edge[1] or box[2] > width - edge[2] or
                        box[3] > height - edge[3]):
                    faults.append('"%s" on sheet %d: beyond the margin' % (word[5], sheets))
                words[-1] += 1
                letters.update(plain(html.unescape(word[5])))
        if has_header and (not headers[0] or len(set(headers)) > 1):
            faults.append("headers of the sheets: %s" % headers)
        if sheets > 1 and words[-1] < FEW_WORDS:
            faults.append("the last sheet has %d words" % words[-1])
        if "All 18 positions" in self.words and sheets > 3 and not MORE.search(self.words):
            faults.append("18 positions take %d sheets" % sheets)
        lost = collections.Counter(plain(self.words)) - letters
        if lost:
            faults.append("letters that are not on paper: " + " ".join(
                "%s (%d)" % item for item in lost.most_common()))
        self.check(path.name + " on paper", checks.SHEETS, faults,
                   ", A4, %d page%s" % (sheets, "" if sheets == 1 else "s"))
        if SHOTS or faults:
            subprocess.run(["pdftoppm", "-r", "80", "-png", str(pdf),
                            str(pdf.with_suffix(".pdf"))], check=True)


def plain(text):
    """The letters to count: ligatures split, no blanks, no case."""
    text = unicodedata.normalize("NFKC", text).casefold()
    return "".join(text.split()).replace("\u00ad", "").replace("\u200b", "")


def look_at_fonts(gate):
    gate.browser.open("data:text/html,<!DOCTYPE html><p>")
    missing = gate.run(RULES, SIGNS + "\ue000")["missing"]
    faults = [] if "\ue000" in missing else ["cannot detect a missing sign"]
    faults += ["no font has %s: make deps" % sign for sign in missing if sign != "\ue000"]
    gate.check("fonts", "some font has each of " + SIGNS, faults)


def self_test(gate, folder):
    """Each planted fault turns its check red, and no other; the page without one is green. (What
    is cut off in print may be missing from the sheets, too.)"""
    passed = failed = 0
    follows = {checks.CUT: {checks.SHEETS}}

    def result(what, good, rest=""):
        nonlocal passed, failed
        passed += good
        failed += not good
        print("pages: %s: %s" % (what, "PASS" if good else "FAIL" + rest), flush=True)

    result("colour differences are the published ones", colours.self_test())
    for name, check, text in planted((HERE / "clean.html").read_text(encoding="utf-8")):
        page = folder / name
        page.write_text(text, encoding="utf-8")
        gate.failed = []
        gate.page(page)
        red = set(gate.failed)
        result("planted %s: %s" % (name, "only '%s' is red" % check if check else "all is green"),
               red - follows.get(check, set()) == {check} - {None},
               ", red: %s" % sorted(red))
    return passed, failed


def main():
    build, paths = pathlib.Path(sys.argv[1]), sys.argv[2:]
    testing = paths == ["--self-test"]
    folder = build / ("pages/planted" if testing else "pages")
    os.makedirs(folder, exist_ok=True)
    with open(folder / "chromium.log", "ab") as log:
        try:
            browser = Browser(log)
        except (EOFError, OSError) as error:
            print("pages: %s, see %s: FAIL\n0 passed, 1 failed" % (error, log.name))
            return 1
        try:
            gate = Gate(browser, folder, verbose=not testing)
            if testing:
                passed, failed = self_test(gate, folder)
            else:
                look_at_fonts(gate)
                for path in paths:
                    gate.page(pathlib.Path(path))
                passed, failed = gate.passed, len(gate.failed)
        finally:
            browser.close()
    print("%d passed, %d failed" % (passed, failed))
    return failed > 0


if __name__ == "__main__":
    sys.exit(main())
