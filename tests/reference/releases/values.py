# SPDX-License-Identifier: MIT
"""What stands in the bytes that released versions wrote, read by the tables of their headers (store.h,
thermal.h and gyro.h), apart from the library. Records and sessions of version 1, of 0.1.0, are not read any more.

    cd tests/reference/releases && python3 values.py > values.h
"""
import pathlib
import struct
import textwrap
import zlib


class Reader:
    """Takes numbers from bytes, the least significant byte first."""

    def __init__(self, data, kind):
        size = struct.unpack_from("<H", data, 2)[0]
        assert data[0] == kind and data[1] == (1 if kind == 0xCC else 2), "kind and version"
        assert size <= len(data), "length"
        assert zlib.crc32(data[:size - 4]) == struct.unpack_from("<I", data, size - 4)[0], "CRC"
        self.data, self.size, self.at = data, size, 4

    def take(self, letter, count=1):
        found = struct.unpack_from("<%d%s" % (count, letter), self.data, self.at)
        self.at += struct.calcsize("<%d%s" % (count, letter))
        return found[0] if count == 1 else list(found)

    def end(self):
        assert self.at == self.size - 4, "%d bytes of %d have a meaning" % (self.at, self.size - 4)


# ---- C --------------------------------------------------------------------------------------------

def literal(value):
    """A C constant of just this value: nine digits tell every float."""
    if isinstance(value, int):
        return str(value) if value < 65536 else "%du" % value
    return "FLOAT(%r)" % float("%.9g" % value)


def initializer(value):
    if isinstance(value, dict):
        return "{%s}" % ", ".join(".%s = %s" % (k, initializer(v)) for k, v in value.items())
    if isinstance(value, list):
        return "{%s}" % ", ".join(initializer(v) for v in value)
    return value if isinstance(value, str) else literal(value)


def rows(numbers):
    return [numbers[0:3], numbers[3:6], numbers[6:9]]


# ---- the formats ----------------------------------------------------------------------------------

REFUSED = {"date": 0}  # no value matters


def calibration(r):
    offset, matrix = r.take("f", 3), r.take("f", 9)
    return {"offset": offset, "matrix": rows(matrix)}


def record(data):
    if data[1] == 1:
        return REFUSED
    r = Reader(data, 0xCA)
    out = {"sensor": r.take("B", 8), "date": r.take("I"), "positions": r.take("H"),
           "weak": r.take("H"), "held": r.take("H"), "verdict": 16 * r.take("B"),
           "temperature_known": r.take("B")}
    for name in ("field", "field_sigma", "temperature", "noise", "rms", "condition"):
        out[name] = r.take("f")
    out["calibration"] = calibration(r)
    out["sigma"] = r.take("f", 9)
    r.end()
    return out


def thermal_record(data):
    if data[1] == 1:
        return {"record": REFUSED}
    r = Reader(data, 0xCB)
    inner = record(data[4:140])
    r.at = 140
    out = {name: r.take("B") for name in ("degree", "fitted", "fallback")}
    triangular = r.take("B")
    for name in ("reference", "span", "min", "max"):
        out[name] = r.take("f")
    out["nominal"] = calibration(r)
    x = [r.take("f", 9) for _ in range(out["degree"] + 1)]
    r.end()
    return {"record": inner, "thermal": out, "is_triangular": triangular, "x": x}


def imu_record(data):
    r = Reader(data, 0xCC)
    out = {"accelerometer": record(r.data[4:140])}
    r.at = 140
    for name, letter in (("weak", "H"), ("dof", "H"), ("verdict", "B"), ("moves", "B"), ("g_is_used", "B")):
        out[name] = r.take(letter)
    out["verdict"] *= 16
    assert r.take("B") == 0, "byte 147"
    for name in ("move_noise", "move_rms", "move_max"):
        out[name] = r.take("f")
    out["gyro"] = calibration(r)
    out["sigma"] = r.take("f", 9)
    out["slope"] = [r.take("f", 4) for _ in range(3)]
    out["slope_sigma"] = [r.take("f", 4) for _ in range(3)]
    r.end()
    return out


def session(data):
    assert data[0] == 0xC5, "kind"
    return {"version": data[1]} # of another procedure


def store(data):
    """The record of two slots that is loaded: the confirmed one with the later number."""
    best = None
    slot_size = len(data) // 2
    for slot in (data[:slot_size], data[slot_size:]):
        assert slot[0] == 0x5C and slot[1] == 1, "kind and version"
        size, number = struct.unpack_from("<HI", slot, 2)
        end = slot_size - 8  # one granule, of 8 bytes
        assert zlib.crc32(slot[:end - 4]) == struct.unpack_from("<I", slot, end - 4)[0], "CRC"
        assert slot[end:] == bytes(8), "confirmed"
        if best is None or number > best[0]:
            best = number, record(slot[8:8 + size])
    return best[1]


# What the names of such bytes begin with, the table of C they go to, and who reads them.
FORMATS = [("record", "stored_record records", record),
           ("thermal_record", "stored_thermal thermals", thermal_record),
           ("imu_record", "stored_imu imus", imu_record),
           ("session", "stored_session sessions", session),
           ("store", "stored_flash flashes", store)]


def read(path):
    """The names and bytes of a file: a name, and below it lines of hexadecimal digits."""
    found, name = {}, None
    for line in path.read_text().splitlines():
        if name and line and set(line) <= set("0123456789abcdef"):
            found[name] += bytes.fromhex(line)
        elif line and not line.startswith("#"):
            name = line
            found[name] = b""
    return found


def wrapped(text):
    return textwrap.fill(text, 100, subsequent_indent="    ", break_long_words=False)


def main():
    print("/* SPDX-License-Identifier: MIT\n *\n * What releases wrote, and what it means."
          " Generated by values.py: do not edit. */\n#ifndef VALUES_H\n#define VALUES_H\n\n"
          "#define FLOAT(x) ((invcal_real)x##f) /* that float, whatever invcal_real is */")
    entries = {table: [] for _, table, _ in FORMATS}
    for path in sorted(pathlib.Path(__file__).parent.glob("*.txt")):
        for name, data in read(path).items():
            table, meaning = next((table, meaning) for prefix, table, meaning in FORMATS
                                  if name.startswith(prefix))
            array = "%s_%s" % (name, path.stem.replace(".", "_"))
            print("\n" + wrapped("static const uint8_t %s[] = {%s};" %
                                 (array, ", ".join("0x%02x" % b for b in data))))
            entries[table].append("    " + wrapped("{\"%s of %s\", %s, sizeof %s, %s}" % (
                name, path.stem, array, array, initializer(meaning(data)))))
    for table, lines in entries.items():
        print("\nstatic const %s[] = {\n%s,\n};" % (table, ",\n".join(lines)))
    print("\n#endif")


main()
