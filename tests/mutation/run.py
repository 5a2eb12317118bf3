# SPDX-License-Identifier: MIT
"""python3 run.py BUILD SAMPLE SEED [FILE...]

Runs the unit tests on SAMPLE mutants of the FILEs (default: all of src/), two at a time, and demands
that they kill 90 % of them. BUILD has the tests with TEST_SHORT, BUILD/whole those at full length:
mutation.sh makes both. A mutant is killed if a suite fails, crashes or does not end: first the short form
of every suite that links the module, its own and the quick ones first, in float and in double; then, in
float, the module's own with the sanitizers of `make check`, and its own at full length (see `own`).
One that compiles to the same bytes, or not at all, does not count.

Known survivors are in survivors.txt with a reason; they still count as survivors. Prints the others, and
entries that are killed; an entry whose line is gone is a failure. V=1: a line for each mutant.
"""
import concurrent.futures
import filecmp
import functools
import glob
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time

import mutants

CC = os.environ["CC"].split()
FLAGS = ("-std=c99 -ffp-contract=off -fno-math-errno -O2 -w -Iinclude "
         "-ffunction-sections -fdata-sections").split()  # as the Makefile
FLAGS_OF = {"short": FLAGS + ["-DINVCAL_THERMAL_DEGREE=2"],  # the same code as in BUILD
            "own": FLAGS + ["-DINVCAL_THERMAL_DEGREE=2"], "full": FLAGS}
LEAST = 0.90
LEAST_VALID = 0.5  # of the mutants tried; nearly all compile, and to other bytes
SECONDS = {"short": 5, "own": 5, "full": 60}  # of the processor; suites take 0.2 and 10 at most
SANITIZE = ("-fsanitize=address,undefined", "-fno-sanitize-recover=all")  # as in `make check`
ROUNDS = (("short", "float", ()), ("short", "double", ()), ("own", "float", SANITIZE),
          ("full", "float", ()))  # which suites
RESULTS = ("killed", "survived", "same", "invalid")


def name_of(path):
    return os.path.splitext(os.path.basename(path))[0]


SOURCES = {name_of(path): path for path in glob.glob("src/*/*.c")}


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


# ---- building and running ------------------------------------------------------------------------

def compiled(folder, module, flags):
    """The object of a module of folder, or None if that does not compile."""
    path = "%s/%s.o" % (folder, module)
    done = subprocess.run([*CC, *flags, "-c", "-o", path, "%s/%s" % (folder, SOURCES[module])],
                          stderr=subprocess.DEVNULL, check=False)
    return path if done.returncode == 0 else None


def flags_of(kind, real, options):
    return [*FLAGS_OF[kind], "-DINVCAL_DOUBLE=%d" % (real == "double"), *options]


def same_bytes(a, b):
    return filecmp.cmp(a, b, shallow=False)


def link(tests, suite, objects, program, *options):
    return subprocess.run([*CC, "%s/tests/unit/%s.o" % (tests, suite), *objects,
                           tests + "/tests/unit/support.o", tests + "/unity.o",
                           tests + "/libinvcal.a", "-lm", "-o", program, *options],
                          check=True, capture_output=True, text=True).stdout


def passes(program, seconds):
    limits = 'ulimit -c 0; ulimit -t %d; exec "$0"' % seconds
    return subprocess.run(["sh", "-c", limits, program], stdout=subprocess.DEVNULL,
                          stderr=subprocess.DEVNULL, check=False).returncode == 0


class Workshop:
    """What all mutants need: which suites link which modules, and what they cost."""

    def __init__(self, build, folder):
        self.tests = {"short": build, "own": build, "full": build + "/whole"}
        self.modules, self.cost = {}, {}
        for suite in map(name_of, glob.glob("tests/unit/test_*.c")):
            said = link(self.tests["short"] + "/float", suite, [], folder + "/suite", "-Wl,-M")
            self.modules[suite] = set(re.findall(r"libinvcal\.a\((\w+)\.o\)", said))
            start = time.perf_counter()
            if not passes(folder + "/suite", SECONDS["short"]):
                sys.exit(suite + " fails without a mutant")
            self.cost[suite] = time.perf_counter() - start

    @functools.lru_cache(maxsize=None)
    def own(self, file):
        """The suite of its name, or else the one that names most of its functions; if equal, most often. If
        no suite names any, all that have the name of a module around those that use it."""
        if "test_" + name_of(file) in self.modules:
            return ["test_" + name_of(file)]
        functions = re.findall(r"^\w.*?\b(invcal_\w+)\(", read(file), re.M)

        def named(suite):
            words = re.findall(r"\w+", read("tests/unit/%s.c" % suite))
            return len(set(functions) & set(words)), sum(map(functions.count, words))
        best = max(self.modules, key=named)
        near = ["test_" + n for n in neighbours(file)]
        return [best] if named(best)[0] else [s for s in near if s in self.modules] or [best]

    def suites(self, kind, file, modules):
        own = self.own(file)
        if kind != "short":
            return own
        return sorted((s for s in self.modules if self.modules[s] & modules),
                      key=lambda s: (s not in own, self.cost[s]))

    @functools.lru_cache(maxsize=None)
    def require(self, kind, suite, real, options, modules):
        """A suite that fails without a mutant, or for lack of sanitizers, kills nothing."""
        with tempfile.TemporaryDirectory() as folder:
            shutil.copytree("src", folder + "/src")
            objects = [compiled(folder, m, flags_of(kind, real, options)) for m in modules]
            link("%s/%s" % (self.tests[kind], real), suite, objects, folder + "/suite", *options)
            if not passes(folder + "/suite", SECONDS[kind]):
                sys.exit("%s fails (%s, %s) without a mutant" % (suite, kind, real))

    def judge(self, mutant):
        """One of RESULTS, and what killed it."""
        modules = modules_with(mutant.file)
        differs = False
        with tempfile.TemporaryDirectory() as folder:
            shutil.copytree("src", folder + "/src")
            with open("%s/%s" % (folder, mutant.file), "w", encoding="utf-8") as file:
                file.write(mutants.apply(mutant, read(mutant.file)))
            for kind, real, options in ROUNDS:
                tests = "%s/%s" % (self.tests[kind], real)
                objects = [compiled(folder, m, flags_of(kind, real, options)) for m in modules]
                if None in objects:
                    return "invalid", ""
                if ROUNDS.index((kind, real, options)) < 2:
                    if all(same_bytes(o, "%s/%s.o" % (tests, SOURCES[m][:-2]))
                           for o, m in zip(objects, modules)):
                        continue
                    differs = True
                if not differs:
                    break
                for suite in self.suites(kind, mutant.file, modules):
                    link(tests, suite, objects, folder + "/suite", *options)
                    if not passes(folder + "/suite", SECONDS[kind]):
                        self.require(kind, suite, real, options, modules)
                        return "killed", " ".join(["by", kind, suite, real, *options[:1]])
        return "survived" if differs else "same", ""


def included(file):
    """The names of the internal headers that a source includes."""
    return set(re.findall(r'#include "(?:\.\./\w+/)?(\w+)\.h"', read(file)))


def neighbours(file):
    """The names of the modules that use a source, directly or not, and of what those include."""
    includes = {f: included(f) for f in glob.glob("src/*/*.[ch]")}
    users, found = set(), {name_of(file)}
    while found - users:
        users |= found
        found = {name_of(f) for f in includes if includes[f] & users}
    users.discard(name_of(file))
    return sorted(users.union(*(includes[SOURCES[u]] for u in users if u in SOURCES)))


def modules_with(file):
    """The modules that a source is compiled into: itself, or those that include a header."""
    found = {file}
    for _ in range(4):  # headers include headers
        headers = {name_of(f) for f in found if f.endswith(".h")}
        found |= {f for f in glob.glob("src/*/*.[ch]") if headers & included(f)}
    return frozenset(name_of(f) for f in found if f.endswith(".c"))


# ---- what is known, and what came out ------------------------------------------------------------

def known_survivors():
    """All (file, before, after): `file`, then `- before` and `+ after`, under reasons."""
    file, before = "", ""
    for line in read("tests/mutation/survivors.txt").splitlines():
        if line.startswith("src/"):
            file = line
        elif line.startswith("- "):
            before = line[2:]
        elif line.startswith("+ "):
            yield file, before, line[2:]


def show(mutant, result, by, known):
    change = "    - %s\n    + %s" % (mutant.before, mutant.after)
    if os.environ.get("V"):
        print("%s:%d %s %s\n%s" % (mutant.file, mutant.line, result, by, change), flush=True)
    elif result == "survived" and (mutant.file, mutant.before, mutant.after) not in known:
        print("%s:%d survived, and is not in survivors.txt:\n%s" %
              (mutant.file, mutant.line, change), flush=True)


def summary(counts):
    total = [sum(count[i] for count in counts.values()) for i in range(len(RESULTS))]
    print("%-20s %8s %8s %8s %8s %8s" % (("", ) + RESULTS + ("killed", )))
    for file, count in sorted(counts.items()) + [("all", total)]:
        valid = count[0] + count[1]
        print("%-20s %8d %8d %8d %8d %6.1f %%" %
              (file, *count, 100 * count[0] / valid if valid else 100))
    valid = total[0] + total[1]
    if valid < LEAST_VALID * sum(total):
        print("only %d of %d compile to other bytes: FAIL" % (valid, sum(total)))
        return False
    return total[0] >= LEAST * valid > 0


def enough(possible):
    """Has src/ as many mutants as tests/floors.txt states? That is three quarters: code may become shorter."""
    if os.environ.get("FLOORS") == "update":
        possible = possible * 3 // 4
    return subprocess.run(["sh", "tests/floor.sh", "%d+" % possible, "mutants"], check=False,
                          env={**os.environ, "WHAT": "mutants"}).returncode == 0


def main():
    build, sample, seed = sys.argv[1], int(sys.argv[2]), sys.argv[3]
    files = sys.argv[4:] or sorted(glob.glob("src/*/*.[ch]"))
    header = read("include/invcal/invcal.h").split("INVCAL_STATUS_END")[0]
    statuses = set(re.findall(r"^    (INVCAL_\w+)", header.rsplit("typedef enum {")[-1], re.M))
    everything = [m for f in files for m in mutants.mutants_of(f, statuses, seed)]
    chosen = sorted(everything, key=lambda m: m.key)[:sample]
    known = {k for k in known_survivors() if k[0] in files}
    gone = known - {(m.file, m.before, m.after) for m in everything}
    counts, results = {}, {}
    with tempfile.TemporaryDirectory() as folder, \
            concurrent.futures.ThreadPoolExecutor(2) as pool:
        workshop = Workshop(build, folder)
        for mutant, (result, by) in zip(chosen, pool.map(workshop.judge, chosen)):
            show(mutant, result, by, known)
            counts.setdefault(mutant.file, [0] * len(RESULTS))[RESULTS.index(result)] += 1
            results.setdefault((mutant.file, mutant.before, mutant.after), set()).add(result)
    killed = {k for k in known if k in results and "survived" not in results[k]}
    for file, before, after in sorted(gone | killed):
        print("survivors.txt is stale, this is %s: %s\n    - %s\n    + %s" %
              ("gone" if (file, before, after) in gone else "killed", file, before, after))
    good = bool(summary(counts) and not gone and (sys.argv[4:] or enough(len(everything))))
    print("%d of %d possible mutants tried; at least %.0f %% must be killed" %
          (len(chosen), len(everything), 100 * LEAST))
    print("%d passed, %d failed" % (good, not good))
    sys.exit(not good)


main()
