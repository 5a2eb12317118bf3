# SPDX-License-Identifier: MIT
"""Makes port/manual/report.png and residuals.png: parts of the tutorial's report.

    python3 tests/pages/picture.py BUILD 3< /dev/null 4< /dev/null     from the top of the repository
"""
import base64
import os
import subprocess
import sys
import tempfile

from browser import Browser

WIDTH = 760
# Each from one text to another, given by their beginnings; '' is the top.
PARTS = {"report.png": ("", "As a constant for a firmware"),
         "residuals.png": ("Residuals", "Where the positions lie")}
TOP = """(text) => text === '' ? 0 : [...document.querySelectorAll('h2,p')].find((e) =>
    e.textContent.startsWith(text)).getBoundingClientRect().top + scrollY"""


def report(tool, folder):
    """The tutorial's."""
    with open(folder + "/board.csv", "w") as log:
        subprocess.run([tool, "simulate", "--plan", "edges", "--seed", "7"], stdout=log, check=True)
    subprocess.run([tool, "calibrate", "board.csv", "--sensor", "mpu6050:2g", "--clip", "-32768,32767", "--out",
                    "cal.json", "--report", "report.html", "--quiet"], cwd=folder, check=True)
    return "file://" + folder + "/report.html"


def main():
    tool = os.path.abspath(sys.argv[1]) + "/invcal"
    with tempfile.TemporaryDirectory() as folder:
        browser = Browser(subprocess.DEVNULL)
        try:
            browser.call("Emulation.setDeviceMetricsOverride", width=WIDTH, height=900, deviceScaleFactor=1,
                         mobile=False)
            browser.open(report(tool, folder))
            for name, part in PARTS.items():
                top, end = (browser.evaluate("(%s)(%r)" % (TOP, text)) for text in part)
                shot = browser.call("Page.captureScreenshot", format="png", captureBeyondViewport=True,
                                    clip={"x": 0, "y": top, "width": WIDTH, "height": end - top, "scale": 1})
                with open("port/manual/" + name, "wb") as out:
                    out.write(base64.b64decode(shot["data"]))
        finally:
            browser.close()


main()
