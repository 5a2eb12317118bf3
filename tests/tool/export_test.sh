#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Tests of export by its command line: export_test.sh path/to/invcal builddir
# CC and CFLAGS as for the library; the libraries are next to the tool.
here=$(dirname "$0")
# shellcheck source=tests/tool/support.sh
. "$here/support.sh"
# shellcheck disable=SC2154
build=$(dirname "$tool")
include=$here/../../include

# ---- a known sensor ----------------------------------------------------------------------------

# Counts; a driver takes `zero` from them and multiplies by `lsb`. calibrated = M (raw - offset).
gravity=9.8123
zero='32768 32700 32800'
lsb='0.0024 0.0025 -0.0023'
offset='33123.83 32275.155 32864.4937'
M='0.00247 0.00004 -0.00006 -0.00003 0.00244 0.00007 0.00005 0.00002 -0.00236'

# calibration UNIT-MEMBERS GRAVITY FACTOR: a file of that sensor, its matrix times a factor
calibration() {
    echo "$offset $M" | more=$1 awk -v g="$2" -v f="$3" '{
        printf "{\"offset\": [%s, %s, %s],\n \"matrix\": [", $1, $2, $3
        for (i = 0; i < 3; i++) {
            printf "%s[%.17g, %.17g, %.17g]", i ? ", " : "", f * $(4 + 3 * i), f * $(5 + 3 * i),
                f * $(6 + 3 * i)
        }
        printf "],\n %s \"gravity\": %s}\n", ENVIRON["more"], g
    }'
}

# truth DIRECTIONS SCALE ZERO LSB: readings of the sensor in a field of `gravity` times SCALE, as
# its driver delivers them ("0 0 0" and "1 1 1": raw), and that field. DIRECTIONS: axes, or a
# number of them, spread evenly (Fibonacci's lattice).
truth() {
    echo "$offset $M $3 $4" | awk -v which="$1" -v scale="$2" -v g="$gravity" '
    function minor(a, b, c, d) { return m[a] * m[d] - m[b] * m[c] }
    function reading(x, y, z,    r) {
        for (r = 0; r < 3; r++) {
            raw = o[r] + g * (inverse[r, 0] * x + inverse[r, 1] * y + inverse[r, 2] * z)
            printf "%.17g ", lsb[r] * (raw - zero[r])
        }
        printf "%.17g %.17g %.17g\n", g * scale * x, g * scale * y, g * scale * z
    }
    {
        for (i = 0; i < 3; i++) { o[i] = $(i + 1); zero[i] = $(i + 13); lsb[i] = $(i + 16) }
        for (i = 0; i < 9; i++) m[i] = $(i + 4)
        det = m[0] * minor(4, 5, 7, 8) - m[1] * minor(3, 5, 6, 8) + m[2] * minor(3, 4, 6, 7)
        inverse[0, 0] = minor(4, 5, 7, 8) / det; inverse[0, 1] = -minor(1, 2, 7, 8) / det
        inverse[0, 2] = minor(1, 2, 4, 5) / det; inverse[1, 0] = -minor(3, 5, 6, 8) / det
        inverse[1, 1] = minor(0, 2, 6, 8) / det; inverse[1, 2] = -minor(0, 2, 3, 5) / det
        inverse[2, 0] = minor(3, 4, 6, 7) / det; inverse[2, 1] = -minor(0, 1, 6, 7) / det
        inverse[2, 2] = minor(0, 1, 3, 4) / det
        if (which == "axes") {
            for (s = -1; s < 2; s += 2) { reading(s, 0, 0); reading(0, s, 0); reading(0, 0, s) }
            exit
        }
        for (i = 0; i < which; i++) {
            z = 1 - (2 * i + 1) / which
            r = sqrt(1 - z * z)
            a = 2.399963229728653 * i
            reading(r * cos(a), r * sin(a), z)
        }
    }'
}

commas() { echo "$1" | tr ' ' ','; }
driver="--zero $(commas "$zero") --lsb $(commas "$lsb")"

calibration '' "$gravity" 1 > "$work/cal.json"
truth 200 1 '0 0 0' '1 1 1' > "$work/raw"
truth 200 1 "$zero" "$lsb" > "$work/driven"
truth axes 1 "$zero" "$lsb" > "$work/axes"
truth 20000 1 "$zero" "$lsb" > "$work/sphere"

# ---- the numbers of an export, in the order of export.awk ---------------------------------------

numbers() { tr -c '0-9.eE+-' ' '; echo; }

# parameters SEPARATOR KEY VALUE NAME ...: from a file with names and values in these columns, the
# values of the names, in this order
parameters() {
    separator=$1
    key=$2
    value=$3
    shift 3
    awk -F"$separator" -v names="$*" -v key="$key" -v value="$value" '
        !/^#/ { v[$key] = $value }
        END {
            n = split(names, name, " ")
            for (i = 1; i <= n; i++) {
                if (!(name[i] in v)) exit 1
                print v[name[i]]
            }
        }' "$work/stdout"
}
px4() {
    parameters '\t' 3 4 "$1_XOFF" "$1_YOFF" "$1_ZOFF" "$1_XSCALE" "$1_YSCALE" "$1_ZSCALE"
}
ardupilot() {
    parameters , 1 2 "$1OFFS_X" "$1OFFS_Y" "$1OFFS_Z" "$1SCAL_X" "$1SCAL_Y" "$1SCAL_Z"
}
yaml() { # the flow sequence of a member, over lines
    sed '/^#/d' "$work/stdout" | tr '\n' ' ' | sed "s/.*$1: \[\([^]]*\)\].*/\1/" | numbers
}
initialiser() { # of the C constant whose name is $1
    tr '\n' ' ' < "$work/stdout" | sed "s/.* $1 = {\([^}]*\)}.*/\1/; s/f\([,}]\)/\1/g; s/f\$//" |
        numbers
}

figures() { # figures SYSTEM TRUTH: of $work/numbers
    awk -v how="$1" -v field="$gravity" -f "$here/export.awk" "$work/numbers" "$2"
}

within() { # within TOLERANCE SYSTEM TRUTH: $work/numbers reproduce the truth
    awk -v how="$2" -v field=1 -v show=error -f "$here/export.awk" "$work/numbers" "$3" |
        awk -v tolerance="$1" '{ ok = $1 <= tolerance } END { exit !ok }'
}

export_to() { # export_to FORMAT ARGUMENTS ...: of the known sensor
    format=$1
    shift
    run export "$work/cal.json" --format "$format" "$@"
}
went_well() { [ "$code" -eq 0 ] || complain; }

# ---- full formats ------------------------------------------------------------------------------

# shellcheck disable=SC2086
accepts "ros: is exported" export "$work/cal.json" --format ros $driver
{ yaml SM; yaml bias; } > "$work/numbers"
check "ros: SM raw - bias is the truth" within 1e-6 ros "$work/driven"
check "ros: names the package that reads it" matches "$work/stdout" \
    'apply_calib of the package imu_calib'
check "ros: SM has 9 numbers and bias 3" sh -c '[ "$(wc -w < "$1")" -eq 12 ]' sh "$work/numbers"

accepts "imu_tk: is exported" export "$work/cal.json" --format imu_tk
# load() reads 21 numbers and no further.
awk '/^#/ { exit } { print }' "$work/stdout" > "$work/numbers"
check "imu_tk: 21 numbers come before anything else" \
    sh -c '[ "$(wc -w < "$1")" -eq 21 ]' sh "$work/numbers"
check "imu_tk: T K (X - B) is the truth" within 1e-6 imu_tk "$work/raw"
check "imu_tk: T has ones on its diagonal, K is diagonal" awk 'NF { row++ }
    row <= 3 && NF && $row != 1 { exit 1 }
    row > 3 && row <= 6 && NF { for (i = 1; i <= 3; i++) if (i != row - 3 && $i != 0) exit 1 }' \
    "$work/numbers"

# C writes floats: 24 bits of an offset of 33000 counts are 0.002 counts, 5e-7 of the field.
truth 200 "$(awk -v g="$gravity" 'BEGIN { printf "%.17g", 1 / g }')" '0 0 0' '1 1 1' > "$work/g"
accepts "fusion: is exported" export "$work/cal.json" --format fusion
for part in Misalignment Sensitivity Offset; do
    initialiser "accelerometer$part"
done > "$work/numbers"
check "fusion: M ((raw - b) s) is the truth in g" within 2e-6 inertial "$work/g"
check "fusion: M has ones on its diagonal" awk '
    NR == 1 && ($1 != 1 || $5 != 1 || $9 != 1) { exit 1 }' \
    "$work/numbers"
calibration '' 1 "$(awk -v g="$gravity" 'BEGIN { printf "%.17g", 1 / g }')" > "$work/g.json"
accepts "fusion: a calibration in g is exported" export "$work/g.json" --format fusion --name acc
for part in Misalignment Sensitivity Offset; do
    initialiser "acc$part"
done > "$work/numbers"
check "fusion: it gives the same, under the requested name" within 2e-6 inertial "$work/g"

# A magnetometer: the same sensor in 48.5 uT.
calibration '' 48.5 "$(awk -v g="$gravity" 'BEGIN { printf "%.17g", 48.5 / g }')" > "$work/mag.json"
truth 200 "$(awk -v g="$gravity" 'BEGIN { printf "%.17g", 48.5 / g }')" '0 0 0' '1 1 1' \
    > "$work/magnetic"
accepts "fusion: a magnetometer is exported" export "$work/mag.json" --format fusion
{ initialiser magnetometerSoftIronMatrix; initialiser magnetometerHardIronOffset; } > "$work/numbers"
check "fusion: soft iron (raw - hard iron) is the truth" within 1e-4 magnetic "$work/magnetic"

# Its unit is that of its log; that of a stated field is not in the file.
run simulate --magnetometer
cp "$work/stdout" "$work/waved.csv"
run calibrate --magnetometer "$work/waved.csv" --out "$work/waved.json"
accepts "c: a magnetometer in uT is exported" export "$work/waved.json" --format c
check "c: with the unit of its field" matches "$work/stdout" '^ \* field: [0-9.]* uT$'
check "c: with that of its readings" matches "$work/stdout" 'raw in uT, calibrated in uT\.'
check "c: with that of its offsets" matches "$work/stdout" 'offset .* uT$'
run calibrate --magnetometer "$work/waved.csv" --gravity 0.485gauss --out "$work/waved.json"
accepts "c: with a field in another unit it is exported" export "$work/waved.json" --format c
check "c: whose unit is not claimed" matches "$work/stdout" 'raw in uT, calibrated in units of the field\.'

for f in px4 ardupilot ros imu_tk; do
    refuses "$f: a magnetometer is refused" 2 "--format $f is for accelerometers" \
        export "$work/mag.json" --format $f
done

# ---- without cross terms -----------------------------------------------------------------------

# The error averaged over the six axis directions is that over the sphere, because its square is
# a quadratic form; the rest is compared with 20000 directions.
truncated=$(echo "$M $lsb" | awk '{
    printf "%.17g %.17g %.17g", $1 / $10, $5 / $11, $9 / $12 }')
offsets=$(echo "$offset $zero $lsb" | awk '{
    printf "%.17g %.17g %.17g", $7 * ($1 - $4), $8 * ($2 - $5), $9 * ($3 - $6) }')

# stated LABEL: four figures from the comment
stated() { sed -n "s/^# *$1 *//p" "$work/export"; }

is_least() { # every number moved up or down leaves more
    least=$(figures diagonal "$work/axes")
    for k in 1 2 3 4 5 6; do
        for step in -0.0005 0.0005; do
            tr '\n' ' ' < "$work/numbers" | awk -v k=$k -v step=$step '{ $k += step; print }' \
                > "$work/moved"
            awk -v how=diagonal -v field="$gravity" -f "$here/export.awk" "$work/moved" \
                "$work/axes" | awk -v least="${least%% *}" '{ ok = $1 > least } END { exit !ok }' ||
                return 1
        done
    done
}

agree() { # agree "STATED" "SAMPLED": rms to the last digit, the others to what sampling can see
    echo "$1 $2" | awk '
        function close_to(a, b, t) { return a - b <= t && b - a <= t }
        { ok = NF == 8 && close_to($1, $5, 1e-4) && close_to($3, $7, 1e-3 * $7) &&
              $2 >= $6 - 1e-4 && $2 <= $6 * 1.001 + 1e-4 && $4 >= $8 - 1e-4 && $4 <= $8 * 1.001 + 1e-4 }
        END { exit !ok }'
}

for f in px4 ardupilot; do
    # shellcheck disable=SC2086
    export_to $f $driver
    check "$f: is exported" went_well
    cp "$work/stdout" "$work/export"
    case $f in
    px4) px4 CAL_ACC0 ;;
    ardupilot) ardupilot INS_ACC ;;
    esac > "$work/numbers"
    check "$f: six parameters" sh -c '[ "$(wc -l < "$1")" -eq 6 ]' sh "$work/numbers"
    check "$f: offsets are those of the driver's readings" \
        near 1e-6 "$(head -n 3 "$work/numbers" | tr '\n' ' ')" "$offsets"
    axes=$(figures diagonal "$work/axes")
    sphere=$(figures diagonal "$work/sphere")
    check "$f: the stated error is right" \
        agree "$(stated 'this best fit')" "${axes%% *} ${sphere#* }"
    check "$f: stderr states it, too, in one line" says \
        "best fit leaves $(stated 'this best fit' | awk '{ print $1 " mg rms, " $2 " mg" }') at most"
    check "$f: no other offset or scale leaves less" is_least
    { head -n 3 "$work/numbers"; echo "$truncated"; } > "$work/cut"
    mv "$work/cut" "$work/numbers"
    cut_axes=$(figures diagonal "$work/axes")
    cut_sphere=$(figures diagonal "$work/sphere")
    check "$f: without cross terms, the stated error remains" \
        agree "$(stated 'cross terms dropped')" "${cut_axes%% *} ${cut_sphere#* }"
    check "$f: which is more" sh -c 'echo "$1 $2" | awk "{ exit !(\$1 < \$2) }"' sh \
        "${axes%% *}" "${cut_axes%% *}"
done

# shellcheck disable=SC2086
refuses "px4: a fifth sensor is refused" 2 '--instance: must be a whole number from 0 to 3' \
    export "$work/cal.json" --format px4 $driver --instance 4
# shellcheck disable=SC2086
export_to px4 $driver --instance 2 --device-id 1310988
check "px4: the instance is in the names, the device ID is an int32" sh -c \
    '[ "$(grep -c "CAL_ACC2_" "$1")" -eq 7 ] &&
        grep -q "^1	1	CAL_ACC2_ID	1310988	6\$" "$1"' sh "$work/stdout"
check "px4: QGroundControl finds five fields in each line" awk -F'\t' \
    '!/^#/ && (NF != 5 || $1 != 1 || $2 != 1 || ($5 != 9 && $5 != 6)) { exit 1 }' "$work/stdout"
check "px4: it says which log is not corrected yet" matches "$work/stdout" '^# .*sensor_accel:'
# shellcheck disable=SC2086
export_to ardupilot $driver --instance 1 --device-id 1310988
check "ardupilot: the instance is in the names" sh -c \
    'grep -q "^INS_ACC2_ID,1310988\$" "$1" && grep -q "^INS_ACC2SCAL_Z," "$1" &&
        [ "$(grep -c "^INS_ACC2OFFS_[XYZ],[-0-9.e]*\$" "$1")" -eq 3 ]' sh "$work/stdout"
check "ardupilot: and there" matches "$work/stdout" '^# .* record with offsets 0 and scales 1'
# shellcheck disable=SC2086
refuses "ardupilot: a fourth sensor is refused" 2 'must be 0 to 2 for ArduPilot' \
    export "$work/cal.json" --format ardupilot $driver --instance 3
refuses "a fraction of a sensor is refused" 2 'whole number from 0 to 3' \
    export "$work/cal.json" --format px4 --instance 0.5
refuses "ardupilot: a scale beyond its range is refused" 1 'scale of x would be 1.2.*0.8 to 1.2' \
    export "$work/cal.json" --format ardupilot --zero "$(commas "$zero")" --lsb 0.002,0.0025,-0.0023
refuses "ardupilot: an offset beyond its range is refused" 1 'offset of y would be -19' \
    export "$work/cal.json" --format ardupilot --zero 32768,40000,32800 --lsb "$(commas "$lsb")"
refuses "px4: a scale beyond its range is refused" 1 'scale of z would be -0.98.*0.1 to 3' \
    export "$work/cal.json" --format px4 --zero "$(commas "$zero")" --lsb 0.0024
run export "$work/cal.json" --format ardupilot --zero 31500,32700,32800 --lsb "$(commas "$lsb")"
check "ardupilot: a large offset gives a warning" matches "$work/stderr" '3.8.*range of \+-3.5'

# One that PX4 may ignore.
cat > "$work/small.json" <<'EOF'
{"offset": [0.001, 0.002, 0.003], "matrix": [[1.001, 0, 0], [0, 0.999, 0], [0, 0, 1]],
 "gravity": 9.80665, "unit": "m/s^2"}
EOF
run export "$work/small.json" --format px4
check "px4: a warning if it may be ignored" matches "$work/stderr" 'releases ignore an offset shorter'
check "px4: a diagonal calibration leaves nothing" matches "$work/stdout" \
    '^# +this best fit +0\.0000 +0\.0000 +0\.0000 +0\.0000$'

# ---- whose scale it is -------------------------------------------------------------------------

hint='--zero X,Y,Z --lsb S'
for members in '' '"unit": "counts",' '"unit": "unknown",' \
    '"nominal": {"zero": [1, 2, 3], "lsb": [1, 1, 1]},' \
    '"nominal": {"zero": [1, 2, 3], "lsb": [1, 1, 1], "zero_from": "range", "lsb_from": "given"},' \
    '"nominal": {"zero": [1, 2, 3], "lsb": [1, 1, 1], "zero_from": "earlier", "lsb_from": "earlier"},'; do
    calibration "$members" "$gravity" 1 > "$work/unknown.json"
    for f in px4 ardupilot ros; do
        refuses "$f: no scale is invented: ${members:-nothing stated}" 2 "$hint" \
            export "$work/unknown.json" --format $f
    done
done
calibration "\"unit\": \"counts\", \"nominal\": {\"zero\": [$(commas "$zero")],
    \"lsb\": [$(commas "$lsb")], \"zero_from\": \"given\", \"lsb_from\": \"given\"}," \
    "$gravity" 1 > "$work/given.json"
accepts "ros: a nominal scale that was given is the driver's" \
    export "$work/given.json" --format ros
{ yaml SM; yaml bias; } > "$work/numbers"
check "ros: it gives the truth" within 1e-6 ros "$work/driven"

# A log in g or mg, calibrated in g: readings and result both become m/s^2, 9.80665 to the g.
known_unit() { # known_unit UNIT MS2-PER-UNIT FIELD-LENGTH
    awk -v k="$2" -v f="$3" 'BEGIN {
        printf "{\"offset\": [%.17g, %.17g, %.17g], \"matrix\": [", 0.1 / k, -0.2 / k, 0.3 / k
        s = k * f / 9.80665
        printf "[%.17g, %.17g, 0], [0, %.17g, %.17g], [%.17g, 0, %.17g]],", 1.01 * s, 0.02 * s,
            0.98 * s, -0.01 * s, 0.005 * s, 1.03 * s
        printf "\"unit\": \"'"$1"'\", \"gravity\": %.17g}\n", f }' > "$work/unit.json"
    accepts "ros: a log in $1, a field of $3" export "$work/unit.json" --format ros
    { yaml SM; yaml bias; } | tr '\n' ' ' > "$work/numbers"
    check "ros: the same matrix and bias in m/s^2" near 1e-9 "$(cat "$work/numbers")" \
        '1.01 0.02 0 0 0.98 -0.01 0.005 0 1.03 0.097 -0.199 0.3095'
}
known_unit m/s^2 1 9.80665
known_unit g 9.80665 1
known_unit mg 0.00980665 1000
known_unit mg 0.00980665 9.80665

# ---- C -----------------------------------------------------------------------------------------

# Reads the numbers of a file and then readings; compares every number of the constants, bit by
# bit, with its text; prints the readings, calibrated by the library and by the plain arrays.
cat > "$work/try.c" <<'EOF'
#include <stdio.h>
#include <stdlib.h>
#include "invcal/invcal.h"
#include "accel.h"
#include "arrays.h"

static float as_float(const char *text)
{
    return strtof(text, NULL);
}

static invcal_real as_real(const char *text)
{
#if INVCAL_DOUBLE
    return strtod(text, NULL);
#else
    return strtof(text, NULL);
#endif
}

static int differs(double a, double b)
{
    return a < b || a > b;
}

int main(int argc, char **argv)
{
    double x, y, z;
    int wrong = argc != 13;

    for (int i = 0; i < 3 && !wrong; i++) {
        wrong |= differs((double)accel.offset[i], (double)as_real(argv[1 + i]));
        wrong |= differs((double)plain_offset[i], (double)as_float(argv[1 + i]));
        for (int j = 0; j < 3; j++) {
            const char *text = argv[4 + 3 * i + j];
            wrong |= differs((double)accel.matrix[i][j], (double)as_real(text));
            wrong |= differs((double)plain_matrix[i][j], (double)as_float(text));
        }
    }
    while (!wrong && scanf("%lf %lf %lf%*[^\n]", &x, &y, &z) == 3) {
        const invcal_real raw[3] = {(invcal_real)x, (invcal_real)y, (invcal_real)z};
        invcal_real a[3];
        invcal_real b[3] = {0, 0, 0};
        invcal_apply(&accel, raw[0], raw[1], raw[2], a);
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++) {
                b[i] += (invcal_real)plain_matrix[i][j] * (raw[j] - (invcal_real)plain_offset[j]);
            }
        }
        printf("%.17g %.17g %.17g %.17g %.17g %.17g\n", (double)a[0], (double)a[1], (double)a[2],
               (double)b[0], (double)b[1], (double)b[2]);
    }
    return wrong;
}
EOF

compile() { # compile 0|1: the program in $work, with a library in float or double
    # shellcheck disable=SC2086
    ${CC:-cc} $CFLAGS -std=c99 -Wall -Wextra -Werror -pedantic -Wconversion -Wdouble-promotion \
        -Wshadow -DINVCAL_DOUBLE="$1" -I"$include" -I"$work" "$work/try.c" \
        "$build/$([ "$1" -eq 1 ] && echo double || echo float)/libinvcal.a" -lm -o "$work/try"
}

# calibrated TOLERANCE TOLERANCE-OF-ARRAYS: $work/printed against the truth
calibrated() {
    paste -d ' ' "$work/printed" "$work/raw" | awk -v t="$1" -v arrays="$2" '
        function far(a, b, t) { return !(a - b <= t && b - a <= t) }
        { for (i = 1; i <= 3; i++) {
            if (far($i, $(i + 9), t) || far($(i + 3), $(i + 9), arrays)) exit 1
        } n++ }
        END { exit !n }'
}

try_c() { # try_c SENTENCE CAL.json: exported, compiled and run in both builds
    accepts "c: $1 is exported" export "$2" --format c --name accel --out "$work/accel.h"
    accepts "c-arrays: $1 is exported" export "$2" --format c-arrays --name plain \
        --out "$work/arrays.h"
    constants=$(tr -d ' \n' < "$2" |
        sed 's/.*"offset":\[\([^]]*\)\].*"matrix":\[\(\[[^}]*\]\)\],.*/\1,\2/' |
        sed 's/\]\],".*//' | tr '[],' '   ')
    for real in 0 1; do
        check "c: $1 compiles without a warning, INVCAL_DOUBLE=$real" compile $real
        # shellcheck disable=SC2086
        "$work/try" $constants < "$work/raw" > "$work/printed"
        report $? "c: $1: every number reads back exactly, INVCAL_DOUBLE=$real"
        # raw counts in float are good to 0.002, 5e-6 m/s^2
        check "c: $1 gives the truth, INVCAL_DOUBLE=$real" \
            calibrated "$([ $real -eq 1 ] && echo 1e-9 || echo 3e-5)" 3e-5
    done
}
try_c "a calibration" "$work/cal.json"
check "c-arrays: no include, and no name of the library" lacks "$work/arrays.h" 'include|invcal_'
awk '{ gsub(/33123\.83/, "33124"); print }' "$work/cal.json" > "$work/whole.json"
accepts "c: whole numbers" export "$work/whole.json" --format c --name accel --out "$work/accel.h"
check "c: whole numbers have a point in front of the suffix" matches "$work/accel.h" \
    'INVCAL_REAL\(33124\.0\)'
check "c: they compile in float" compile 0
sed 's/33123\.83/1e60/' "$work/cal.json" > "$work/huge.json"
for f in c c-arrays fusion; do
    refuses "$f: a number beyond a float is refused" 1 'exceed the range of a float' \
        export "$work/huge.json" --format $f
done

# Fusion's types are unions, and its own examples initialise them by flat braces.
cat > "$work/fusion.c" <<'EOF'
typedef union { float array[3][3]; } FusionMatrix;
typedef union { float array[3]; } FusionVector;
#include "fusion.h"
float all(int i, int j);
float all(int i, int j)
{
    return accelerometerMisalignment.array[i][j] + accelerometerSensitivity.array[i] +
           accelerometerOffset.array[j];
}
EOF
accepts "fusion: to a file" export "$work/cal.json" --format fusion --out "$work/fusion.h"
# shellcheck disable=SC2086
check "fusion: it compiles" ${CC:-cc} $CFLAGS -std=c99 -Wall -Wextra -Werror -pedantic \
    -Wno-missing-braces -Wdouble-promotion -c "$work/fusion.c" -o "$work/fusion.o"

# ---- what apply does ---------------------------------------------------------------------------

"$tool" calibrate "$data/xsens_mti_positions.csv" --positions --gravity 9.81744 \
    --out "$work/real.json" > "$work/table"
cut -d, -f1-3 "$data/xsens_mti_positions.csv" > "$work/real.csv"
"$tool" apply "$work/real.json" "$work/real.csv" | tail -n +2 > "$work/applied"
tail -n +2 "$work/real.csv" | paste -d, - "$work/applied" | tr ',' ' ' > "$work/truth"
in=$work/real.json
run export - --format imu_tk
in=/dev/null
check "a calibration comes from standard input" went_well
check "a rough calibration is exported with a warning" says 'warning: standard input: rough calibration'
awk '/^#/ { exit } { print }' "$work/stdout" > "$work/numbers"
check "imu_tk: a real sensor: as apply" within 1e-6 imu_tk "$work/truth"
check "its comment has verdict, positions, sigma, gravity and source" sh -c '
    for word in "verdict: rough" "positions: 38" "offset  *0.2" "gravity: 9.81744 m.s^2" "standard input"; do
        grep -q "^# .*$word" "$1" || exit 1
    done' sh "$work/stdout"
run export "$work/real.json" --format ros --zero 32768,32768,32768 --lsb 0.0024
{ yaml SM; yaml bias; } > "$work/numbers"
awk '{ for (i = 1; i <= 3; i++) $i = 0.0024 * ($i - 32768); print }' CONVFMT=%.17g OFMT=%.17g \
    "$work/truth" > "$work/truth_driven"
check "ros: a real sensor: as apply" within 1e-6 ros "$work/truth_driven"

# The truth of a simulation is a calibration too; it has no verdict and a list of positions.
"$tool" simulate --plan edges --truth "$work/simulated.json" > "$work/simulated.csv"
accepts "the truth of a simulation is exported" export "$work/simulated.json" --format c

# ---- warnings, hostile texts -------------------------------------------------------------------

"$tool" simulate --plan per-group:5 --outliers 3 --seed 33 --noise 0.002 > "$work/doubt.csv"
"$tool" calibrate "$work/doubt.csv" --quiet --out "$work/doubt.json"
run export "$work/doubt.json" --format c
check "one whose positions contradict one another is exported with a warning, too" says \
    'warning: .*doubt\.json: 4 positions contradict one another'
check "and with a comment" matches "$work/stdout" '4 positions contradict one another'
"$tool" calibrate "$data/t265_positions.csv" --positions --gravity 9.8016 --out "$work/weak.json" \
    > "$work/table"
run export "$work/weak.json" --format c
check "a weak calibration is exported" went_well
check "with a warning that names what is poorly determined" says \
    'warning: .*weak calibration: gamma_xy, gamma_xz, gamma_zy poorly determined'
check "and the same in its comment" sh -c \
    'grep -q "verdict: weak" "$1" && grep -q "poorly determined: gamma_xy, gamma_xz, gamma_zy" "$1"' \
    sh "$work/stdout"

mkdir "$work/evil*"
evil="$work/evil*/"'
int evil; *??
\'
calibration '"verdict": "*/ int evil; /* \u000a#evil\\", "frame": "a\nb*/",
    "undetermined": ["*/\n", "x"],' "$gravity" 1 > "$evil"
run export "$evil" --format c --name accel --out "$work/accel.h"
check "hostile texts: exported" went_well
check "hostile texts: the warning is one line" says 'warning: '
run export "$evil" --format c-arrays --name plain --out "$work/arrays.h"
check "hostile texts stay inside a C comment" compile 0
# shellcheck disable=SC2086
run export "$evil" --format px4 $driver
check "hostile texts stay inside a # comment" awk \
    '!/^(# |1\t1\tCAL_ACC0_[XYZ](OFF|SCALE)\t)/ { exit 1 }' "$work/stdout"

# ---- refusals ----------------------------------------------------------------------------------

see='see invcal export --help'
refuses "a missing format is refused" 2 "--format: must be one of c, .*$see" export "$work/cal.json"
refuses "an unknown format is refused" 2 '--format: must be one of c' export "$work/cal.json" --format matlab
refuses "a missing file name is refused" 2 'CAL.json is missing' export --format c
refuses "a file that is not there is refused" 3 'nowhere.json' export nowhere.json --format c
for name in 1st a-b 'a b' int '_a' 'x*/' "$(printf 'a%060d' 0)"; do
    refuses "the name '$name' is refused" 2 '--name: must be a C identifier' \
        export "$work/cal.json" --format c "--name=$name"
done
for o in --zero=1,2,3 --lsb=1 --instance=1 --device-id=1; do
    refuses "c: ${o%%=*} is refused" 2 "${o%%=*}: --format c does not use it" \
        export "$work/cal.json" --format c $o
done
refuses "px4: --name is refused" 2 '--name: --format px4 does not use it' \
    export "$work/cal.json" --format px4 --name a
refuses "--lsb alone is refused" 2 '--lsb: state both' export "$work/cal.json" --format px4 --lsb 1
refuses "a scale of 0 is refused" 2 '--lsb: a scale must not be 0' \
    export "$work/cal.json" --format px4 --zero 0,0,0 --lsb 0
refuses "a scale too large to compute with is refused" 2 'the scale of the driver is out of range' \
    export "$work/cal.json" --format ros --zero 0,0,0 --lsb 1e-320
refuses "--out over CAL.json is refused" 2 '--out: would overwrite CAL.json' \
    export "$work/cal.json" --format c --out "$work/cal.json"
sed 's/"gravity": [0-9.]*/"other": 1/' "$work/cal.json" > "$work/none.json"
for f in px4 ros imu_tk fusion; do
    # shellcheck disable=SC2046
    refuses "$f: a file without gravity is refused" 3 '"gravity".* is missing' \
        export "$work/none.json" --format $f
done
accepts "c: it needs no gravity" export "$work/none.json" --format c
for members in '"sigma": {"dk": [1, 2]},' '"sigma": {"dk": [1, 2, "x"]},' '"positions": "many",' \
    '"unit": 5,' '"nominal": [1],' '"undetermined": {},' '"nominal": {"zero": [1, "x", 3]},'; do
    calibration "$members" "$gravity" 1 > "$work/bad.json"
    refuses "a malformed member is refused: $members" 3 'bad.json:[0-9]+: ' \
        export "$work/bad.json" --format c
done
calibration '"sigma": {"offset": [null, null, null], "dk": [null, 1, 2]},' "$gravity" 1 \
    > "$work/null.json"
accepts "unknown sigma is accepted" export "$work/null.json" --format c
check "and reported" matches "$work/stdout" 'standard deviations: unknown'
printf '{"offset": [0,0,0], "matrix": [[1,2,3],[2,4,6],[0,0,1]], "gravity": 1}' > "$work/flat.json"
refuses "a singular matrix is refused" 3 'singular' export "$work/flat.json" --format c
printf '{"offset": [0,0,0], "matrix": [[0,1,0],[1,0,0],[0,0,1]], "gravity": 1}' > "$work/turned.json"
for f in imu_tk fusion; do
    refuses "$f: interchanged axes are refused" 1 'does not respond along x' \
        export "$work/turned.json" --format $f
done
mkdir "$work/full"
refuses "an output that cannot be written is refused" 3 'cannot be written' \
    export "$work/cal.json" --format c --out "$work/full"

# ---- help --------------------------------------------------------------------------------------

accepts "--help all succeeds" export --help all
check "--help all has usage, exit codes and an example" sh -c \
    'grep -q "^usage: invcal" "$1" && grep -q "^exit codes:" "$1" && grep -q "^example:" "$1"' \
    sh "$work/stdout"
for o in name zero lsb instance device-id out format; do
    check "--help all explains --$o" matches "$work/stdout" "^  --$o "
done
mkdir "$work/example"
ln -s "$(cd "$here/.." && pwd)" "$work/example/tests"
sed -n '1,/^example:/d; s|^  invcal|"$tool"|; p' "$work/stdout" > "$work/example/run"
check "the example of --help all works" sh -c 'cd "$1" && [ -s run ] && tool=$2 sh -e ./run > out 2> err &&
    grep -q CAL_ACC0_XOFF out && grep -q "invcal_calibration accelerometer" out' \
    sh "$work/example" "$tool"

finish
