# SPDX-License-Identifier: MIT
"""Files that the tool of this version writes, one of each kind, of logs with a known truth.

    python3 tool.py path/to/invcal            writes VERSION-KIND.json here: once, with the release
    python3 tool.py path/to/invcal --check    it still writes every key that the newest files here have, of the same type
"""
import json
import math
import os
import random
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
DELTA, DK, GAMMA = [0.03, -0.02, 0.01], [0.02, -0.03, 0.01], [0.01, -0.02, 0.015]
PER_KELVIN = [1e-4, -2e-4, 5e-5]  # of the offsets
CUBIC = [0.004, -0.003, 0.005]
NOMINAL = ["--zero", "5,5,5", "--lsb", "9.80665/16384"]
HALF = math.sqrt(0.5)
FACES = [[s if i == k else 0.0 for i in range(3)] for k in range(3) for s in (1.0, -1.0)]
EDGES = [[0.0 if i == k else HALF * (s if i == (k + 1) % 3 else t) for i in range(3)]
         for k in range(3) for s in (1, -1) for t in (1, -1)]


def read(eta, dice, kelvin=0.0, cubic=(0, 0, 0), noise=5e-5):
    """u = (I + S) eta + delta + cubic terms, over field."""
    xy, xz, zy = (g / 2 for g in GAMMA)
    s = [[DK[0], xy, xz], [xy, DK[1], zy], [xz, zy, DK[2]]]
    return [eta[i] + sum(s[i][j] * eta[j] for j in range(3)) + DELTA[i] + PER_KELVIN[i] * kelvin +
            cubic[i] * eta[i] ** 3 + dice.gauss(0, noise) for i in range(3)]


def table(name, heading, rows):
    with open(name, "w") as out:
        out.write(heading + "\n" + "".join(",".join("%.9g" % x for x in row) + "\n" for row in rows))
    return name


def counts(etas, dice):
    return [[round(16384 * x + 5) for x in read(eta, dice)] for eta in etas]


def positions(dice):
    return ["--positions"] + NOMINAL + ["--device", "board 7", "--serial", "0815",
            "--operator", "A. N.", "--date", "2026-11-24", "--note", "a file of a release",
            table("positions.csv", "x,y,z", counts(FACES + EDGES, dice))]


def six_faces(dice):
    return ["--positions", "--six-faces", "--noise", "0.0005"] + NOMINAL + [
        table("faces.csv", "x,y,z", counts(FACES, dice))]


def thermal(dice):
    rows = [read(eta, dice, t - 25) + [t] for t in (-20.0, 25.0, 70.0) for eta in FACES + EDGES]
    return ["--positions", "--unit", "g", "--gravity", "1", "--thermal", "1",
            table("thermal.csv", "x,y,z,temperature", rows)]


def nonlinear(dice):
    return ["--positions", "--unit", "g", "--gravity", "1", "--cubic",
            table("cubic.csv", "x,y,z", [read(eta, dice, cubic=CUBIC) for eta in FACES + EDGES + FACES])]


def magnetometer(dice):
    rows = []
    for k in range(6000):
        a, b = 0.02 * k + math.sin(0.01 * k), 0.0073 * k
        eta = [math.sin(a) * math.cos(b), math.sin(a) * math.sin(b), math.cos(a)]
        rows.append([48 * x for x in read(eta, dice, noise=0.005)])
    return ["--magnetometer", table("waved.csv", "mx (uT),my (uT),mz (uT)", rows)]


def gyroscope(_):
    with open("moves.csv", "w") as log:
        subprocess.run([TOOL, "simulate", "--plan", "edges", "--gyro", "--seed", "5"], stdout=log, check=True)
    return ["--sensor", "mpu6050:2g", "moves.csv"]


def noise(dice):
    return ["--rate", "100", "--unit", "m/s2", table("rest.csv", "x,y,z", [[dice.gauss(0, 0.01), dice.gauss(0, 0.01),
                                                          9.8 + dice.gauss(0, 0.01)] for _ in range(12000)])]


KINDS = {"calibration": positions, "six-faces-calibration": six_faces, "thermal": thermal, "nonlinear": nonlinear,
         "magnetometer": magnetometer, "gyroscope": gyroscope, "noise": noise}


def write(kind, to):
    command = "allan" if kind == "noise" else "calibrate"
    arguments = KINDS[kind](random.Random(kind))
    subprocess.run([TOOL, command, "--quiet", "--out", to] + arguments, check=True)


def lost(old, new, at=""):
    """The keys of old that new has not, or of another type. Null may become a value."""
    if isinstance(old, dict) and isinstance(new, dict):
        return [k for key, value in old.items()
                for k in (lost(value, new[key], at + "." + key) if key in new else [at + "." + key])]
    if isinstance(old, list) and isinstance(new, list):
        return lost(old[0], new[0], at + "[0]") if old and new else []
    number = (int, float)
    same = old is None or new is None or type(old) is type(new) or isinstance(old, number) and isinstance(new, number)
    return [] if same else [at]


def check():
    failed = []
    for kind in KINDS:
        write(kind, "now.json")
        newest = sorted(f for f in os.listdir(HERE) if f.split("-", 1)[1:] == [kind + ".json"])[-1]
        with open(os.path.join(HERE, newest)) as old, open("now.json") as new:
            failed += [newest + ": " + key for key in lost(json.load(old), json.load(new))]
        os.remove("now.json")
    if failed:
        sys.exit("no longer written, or of another type:\n" + "\n".join(failed))


if len(sys.argv) not in (2, 3):
    sys.exit("usage: tool.py path/to/invcal [--check]")
TOOL = os.path.abspath(sys.argv[1])
with tempfile.TemporaryDirectory() as work:
    os.chdir(work)
    if sys.argv[2:] == ["--check"]:
        check()
    else:
        version = subprocess.run([TOOL, "--version"], capture_output=True, text=True, check=True).stdout.split()[1]
        for each in KINDS:
            write(each, os.path.join(HERE, version + "-" + each + ".json"))
    os.chdir(HERE)
