#!/bin/sh
# SPDX-License-Identifier: MIT
#
# sh tests/fleet/fleet.sh BUILD: the manual's fleet, with GNU parallel and with Apache Spark from PyPI in local mode.
# Follows port/manual/fleet.md word by word, and compares the results of both for its logs with those of the
# tool for each log. Ends with `N passed, N failed`.
build=$(cd "$1" && pwd) || exit 1
cd "$(dirname "$0")/../.." || exit 1
venv=$build/fleet/venv
work=$build/tutorial/fleet/work
passed=0
failed=0
mkdir -p "$build/fleet" || exit 1

check() { # SENTENCE COMMAND ...
    sentence=$1
    shift
    if "$@"; then
        passed=$((passed + 1))
        echo "$sentence: PASS"
    else
        failed=$((failed + 1))
        echo "$sentence: FAIL"
    fi
}

# A virtual environment of Debian's python, in the build folder.
if ! cmp -s tests/fleet/requirements.txt "$venv/installed"; then
    rm -rf "$venv"
    { /usr/bin/python3 -m venv "$venv" && "$venv/bin/pip" install -q -r tests/fleet/requirements.txt; } \
        > "$build/fleet/pip.log" 2>&1 || { cat "$build/fleet/pip.log"; exit 1; }
    cp tests/fleet/requirements.txt "$venv/installed"
fi

# Spark talks only to itself.
PATH=$build:$venv/bin:$PATH
SPARK_LOCAL_IP=127.0.0.1
PYSPARK_PYTHON=$venv/bin/python3
unset SPARK_HOME PYTHONPATH
export PATH SPARK_LOCAL_IP PYSPARK_PYTHON
check "fleet.md: its commands print what it says" sh tests/tutorial.sh "$build" fleet
check "fleet.py: 40 lines at most" [ "$(wc -l < "$work/fleet.py")" -le 40 ]

# One log after the other, each by itself.
cd "$work" || exit 1
while read -r log; do
    invcal calibrate "$log" --gravity 9.80665 --json-lines 2> stderr
done < logs.txt > alone.jsonl
without_record() { sed 's/"record": {[^}]*}, //' "$1"; }
without_record calibrations.jsonl > parallel.jsonl
check "parallel: prints the lines that the tool prints for each log" cmp alone.jsonl parallel.jsonl
check "there are calibrations, and refusals" \
    [ "$(grep -c '"verdict": "good"' alone.jsonl) $(grep -c '"error"' alone.jsonl)" = "12 2" ]

# file,verdict,error,reason,accuracy95,offset_x,offset_y,offset_z,m11,m12,...
"$venv/bin/python3" - alone.jsonl table/part-*.csv << 'END'
import csv
import json
import sys

with open(sys.argv[1], encoding="utf-8") as lines, open(sys.argv[2], encoding="utf-8") as table:
    alone = [json.loads(line) for line in lines]
    rows = list(csv.DictReader(table, escapechar="\\"))
assert len(alone) == len(rows) == 14, (len(alone), len(rows))
for line, row in zip(alone, rows):
    for name in ("file", "verdict", "error", "reason"):
        assert row[name] == line.get(name, ""), (name, row, line)
    if "error" in line:
        assert not row["offset_x"] and not row["m33"], row
        continue
    numbers = [line["accuracy95"], *line["offset"], *sum(line["matrix"], [])]
    found = [float(row[name]) for name in list(row)[4:]]
    assert found == numbers, (found, numbers)
END
check "Spark: its table has every line, and every number to the last bit" [ $? -eq 0 ]

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
