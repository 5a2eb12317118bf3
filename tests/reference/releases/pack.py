# SPDX-License-Identifier: MIT
"""What version 0.2.0 writes, packed by the tables of store.h, thermal.h and gyro.h, apart from the library:
the library must write the same bytes.

    cd tests/reference/releases && python3 pack.py > 0.2.0.txt

No number stands twice, so that none can be taken for another.
"""
import struct
import zlib

MATRIX = [[2.46e-4, -4.2e-7, -1.12e-6], [-4.27e-7, 2.47e-4, -2.63e-6], [-1.13e-6, -2.62e-6, 2.48e-4]]
OFFSET = [33123.75, 33275.125, 32364.5]


def frame(kind, content, version=2):
    head = struct.pack("<BBH", kind, version, len(content) + 8)
    return head + content + struct.pack("<I", zlib.crc32(head + content))


def calibration(offset, matrix):
    return struct.pack("<12f", *offset, *[x for row in matrix for x in row])


def record(date=0x65432101, temperature=-12.5, offset=None, matrix=None):
    """WEAK, with parameters 1, 6 and 8 weak."""
    sigma = [7.6e-5, 7.9e-5, 8.3e-5, 1.02e-4, 1.04e-4, 1.07e-4, 1.9e-4, 2.1e-4, 2.3e-4]
    return frame(0xCA, bytes.fromhex("1122334455667788") +
                 struct.pack("<IHHHBB", date, 0x1234, 0x0142, 0x0181, 5, temperature is not None) +
                 struct.pack("<6f", 9.81744, 0.0005, temperature or 0, 1.25e-4, 9.5e-5, 13.75) +
                 calibration(offset or OFFSET, matrix or MATRIX) + struct.pack("<9f", *sigma))


# ---- thermal calibrations ------------------------------------------------------------------------

def inverse(m):
    minor = [[m[(i + 1) % 3][(j + 1) % 3] * m[(i + 2) % 3][(j + 2) % 3] -
              m[(i + 1) % 3][(j + 2) % 3] * m[(i + 2) % 3][(j + 1) % 3] for j in range(3)]
             for i in range(3)]
    det = sum(m[0][j] * minor[0][j] for j in range(3))
    return [[minor[j][i] / det for j in range(3)] for i in range(3)]


def times(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)] for i in range(3)]


def at_reference(zero, nominal, x):
    """u = (I + S) eta + delta, u = N (raw - zero): offset = zero + N^-1 delta, (I + S)^-1 N."""
    delta, dk, xy, xz, zy = x[0:3], x[3:6], x[6] / 2, x[7] / 2, x[8] / 2
    triad = [[1 + dk[0], xy, xz], [xy, 1 + dk[1], zy], [xz, zy, 1 + dk[2]]]
    back = inverse(nominal)
    offset = [zero[i] + sum(back[i][j] * delta[j] for j in range(3)) for i in range(3)]
    return offset, times(inverse(triad), nominal)


def thermal(degree):
    zero = [32768.5, 32767.25, 32766.75]
    nominal = [[(2.44e-4 if i == j else 1e-7) * (1 + 0.01 * (3 * i + j)) for j in range(3)]
               for i in range(3)]
    x = [[0.001 * (r + 1) + 0.0001 * k for r in range(9)] for k in range(degree + 1)]
    offset, matrix = at_reference(zero, nominal, x[0])
    fitted, fallback = (0, 2) if degree == 1 else (degree, 0) # of a narrow range, or as asked
    return frame(0xCB, record(temperature=22.5, offset=offset, matrix=matrix) +
                 struct.pack("<4B", degree, fitted, fallback, 0) +
                 struct.pack("<4f", 22.5, 47.25, -20.75, 69.5) + calibration(zero, nominal) +
                 b"".join(struct.pack("<9f", *row) for row in x))


# ---- both sensors --------------------------------------------------------------------------------

def imu_record():
    """WEAK, with parameters 2 and 8 of the gyroscope weak, and those of the record."""
    matrix = [[2.63e-4, 3.1e-6, -1.3e-6], [-2.9e-6, 2.71e-4, 1.9e-6], [8.7e-7, -2.3e-6, 2.59e-4]]
    slope = [0.0011, -0.0012, 0.0013, 0.0021, 0.0014, -0.0015, 0.0016, -0.0022, 0.0017, 0.0018, -0.0019, 0.0023]
    return frame(0xCC, record(date=0x65432102, temperature=31.25) +
                 struct.pack("<HHBBBB", 0x0104, 0x0117, 5, 23, 1, 0) +
                 struct.pack("<3f", 4.25e-4, 1.6e-3, 4.375e-3) +
                 calibration([85.5, -131.25, 24.125], matrix) +
                 struct.pack("<9f", *[1.1e-4 + 7e-6 * i for i in range(9)]) +
                 struct.pack("<12f", *slope) + struct.pack("<12f", *[3.1e-5 + 3e-6 * i for i in range(12)]), 1)


# ---- a flash ---------------------------------------------------------------------------------------

def slot(sequence, content, granularity=8):
    """A slot that its content fills."""
    head = struct.pack("<BBHI", 0x5C, 1, len(content), sequence) + content
    padded = head + b"\xff" * (-(len(head) + 4) % granularity)
    return padded + struct.pack("<I", zlib.crc32(padded)) + bytes(granularity)


def show(name, data):
    print("\n" + name)
    for i in range(0, len(data), 32):
        print(data[i:i + 32].hex())


def main():
    print("# SPDX-License-Identifier: MIT\n#\n# What invcal 0.2.0 writes, by pack.py.")
    show("record", record())
    show("record_cold", record(temperature=None))
    for degree in range(3):
        show("thermal_record_%d" % degree, thermal(degree))
    show("imu_record", imu_record())
    show("store", slot(0, record(date=0x65432100)) + slot(1, record()))


main()
