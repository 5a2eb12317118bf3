#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Tests of what logs from elsewhere need: reading_test.sh path/to/invcal builddir
# Which columns are meant, truncated lines, rates that are not stated, missing rests, files that are not
# tables, and options that are easily misunderstood.
here=$(dirname "$0")
# shellcheck source=tests/tool/support.sh
. "$here/support.sh"

# Counts of 0.0006 m/s^2: t in seconds, x, y, z. The truth is what was simulated.
"$tool" simulate --truth "$work/truth.json" > "$work/plain.csv"
truth=$(json "$work/truth.json" offset)

first_lines() { tr '\n' ' ' < "$work/stdout" | grep -Fq -- "$1"; }
warns() { [ "$code" -eq 0 ] && grep -Eq -- "^invcal: warning: $1" "$work/stderr" || complain; }

# write HEADER ROW: $work/log.csv from the plain log; ROW is an expression of awk in t, x, y, z, n.
write() {
    {
        [ -z "$1" ] || printf '%b\n' "$1"
        awk -F, 'BEGIN { CONVFMT = "%.15g" }
            NR > 1 { n = NR - 2; t = $1; x = $2; y = $3; z = $4; print '"$2"' }' "$work/plain.csv"
    } > "$work/log.csv"
}

# is_right SENTENCE ARGUMENTS ...: calibrates $work/log.csv to the truth, 18 positions
is_right() {
    sentence_=$1
    shift
    run calibrate "$work/log.csv" --json "$@"
    check "$sentence_: the offset is the true one, within 4 counts" near 4 "$(json "$work/stdout" offset)" "$truth"
    check "$sentence_: 18 positions" test "$(json "$work/stdout" positions)" = 18
    run calibrate "$work/log.csv" "$@"
}

# ---- nine axes --------------------------------------------------------------------------------------

xyz='x "," y "," z'
nine='ax,ay,az,gx,gy,gz,mx,my,mz'
write "$nine" "$xyz \",1,2,3,40,50,60\""
is_right "nine axes" --rate 100
check "nine axes: the accelerometer is reported" first_lines "header in line 1; the accelerometer's ax ay az in counts"
check "nine axes: so is the magnetometer" first_lines \
    "gyroscope: gx gy gz; ignored: 3 other columns, including a magnetometer's (mx ..; --columns chooses)"
write "timestamp,mag_x,mag_y,mag_z,temp,gyro_x,gyro_y,gyro_z,accel_x,accel_y,accel_z" "t \",4,5,6,25,1,2,3,\" $xyz"
is_right "nine axes in another order, time and temperature"
check "nine axes in another order: it is reported" first_lines \
    "timestamp (s), the accelerometer's accel_x accel_y accel_z in counts (by their size), temp; gyroscope: gyro_x gyro_y gyro_z; ignored: 3 other"
write "# made by hand\n#t, $nine, temperature" "t \",\" $xyz \",1,2,3,4,5,6,25\""
is_right "a header of eleven columns behind #"
check "a header behind #: its line is reported" first_lines "header in line 2; t (s), the accelerometer's ax ay az"
write "# t z y x" 't " " z " " y " " x'
is_right "a header behind # names the order"
write "% some remark here" "t \",\" $xyz"
is_right "a comment that is not a header"
check "a comment that is not a header: none is reported" first_lines "no header; t (s), x y z"
write "# when who what" "$xyz"
is_right "a comment of as many words as columns, none of them an axis" --rate 100
check "such a comment is not a header" first_lines "no header; x y z"
write '#timestamp [ns],w_RS_S_x [rad s^-1],w_RS_S_y [rad s^-1],w_RS_S_z [rad s^-1],a_RS_S_x [m s^-2],a_RS_S_y [m s^-2],a_RS_S_z [m s^-2]' \
    't * 1e9 ",1,2,3," x * 0.0006 "," y * 0.0006 "," z * 0.0006'
run calibrate "$work/log.csv" --json
check "EuRoC: the offset is the true one" near 0.0012 "$(json "$work/stdout" offset)" \
    "$(echo "$truth" | tr -d '[],' | awk '{ print $1 * 0.0006, $2 * 0.0006, $3 * 0.0006 }')"
check "EuRoC: the unit is that of the header" test "$(json "$work/stdout" unit)" = '"m/s^2"'

# ROS, flat: its linear acceleration includes gravity; a phone's does not.
write "stamp,linear_acceleration_x,linear_acceleration_y,linear_acceleration_z,angular_velocity_x,magnetic_field_x,magnetic_field_y,magnetic_field_z" \
    't "," x * 0.0006 "," y * 0.0006 "," z * 0.0006 ",1,4,5,6"'
run calibrate "$work/log.csv" --rate 100
check "ROS, flat: the accelerometer in m/s^2" first_lines \
    "the accelerometer's linear_acceleration_x linear_acceleration_y linear_acceleration_z in m/s²; ignored"
write "linear_acceleration_x,linear_acceleration_y,linear_acceleration_z,magnetic_field_x,magnetic_field_y,magnetic_field_z" "$xyz \",4,5,6\""
refuses "linear acceleration and a magnetometer: that is not taken for it" 3 'linear acceleration has gravity removed' \
    calibrate "$work/log.csv"
write "imu_ax,imu_ay,imu_az,imu_gx,imu_gy,imu_gz" "$xyz \",1,2,3\""
is_right "names that begin with imu" --rate 100

# ---- --columns --------------------------------------------------------------------------------------

write '' "t \",7,\" $xyz \",1,2,3,40,50,60,25\""
refuses "twelve columns without a header" 3 '12 columns, .* --columns 2,3,4 states x, y, z by number$' \
    calibrate "$work/log.csv"
is_right "columns by number" --columns 3,4,5 --rate 100
check "columns by number: they are reported" first_lines "(--columns 3,4,5); ignored: 9 other columns"
is_right "time, temperature and axes by number" --columns temperature=12,z=5,y=4,x=3,t=1
check "time by number gives the rate" first_lines "124 s at 100 samples per second "
write "when,p,q,r,s" "t \",\" $xyz \",9\""
is_right "columns by name" --columns time=when,x=P,y=q,z=4
check "columns by name: it is reported" first_lines "header in line 1; when (s), p q r in counts"
write "$nine" "\"40,50,60,1,2,3,\" $xyz"
is_right "the magnetometer of nine axes" --columns mx,my,mz --rate 100
echo '{"offset": [1, 2, 3], "matrix": [[2, 0, 0], [0, 2, 0], [0, 0, 1e0]]}' > "$work/simple.json"
printf '9,2,8,4,6\n9,1,8,2,3\n' > "$work/in"
run apply "$work/simple.json" "$work/in" --columns 2,4,5
check "apply --columns" test "$(cat "$work/stdout")" = "$(printf 'x,y,z\n2,4,3\n0,0,0')"
# A calibration of counts for readings in g.
echo '{"offset": [1, 2, 3], "matrix": [[2, 0, 0], [0, 2, 0], [0, 0, 1]], "unit": "counts"}' > "$work/counts.json"
printf 'x (g),y (g),z (g)\n9,8,6\n' > "$work/in"
run apply "$work/counts.json" "$work/in"
check "apply: readings in another unit" warns \
    '.*in: the header states readings in g, but the calibration was made from readings in counts: convert them,'
check "apply: they are corrected anyway" test "$(sed -n 2p "$work/stdout")" = 16,12,3
printf 'x (g),y (g),z (g)\n9,8\n' > "$work/in"
refuses "apply: if they cannot be, that is the only line" 3 'in:2: 2 columns, .*' apply "$work/counts.json" "$work/in"
check "apply: one line" test "$(wc -l < "$work/stderr")" -eq 1
for heading in 'x,y,z' 'x (counts),y (counts),z (counts)'; do
    printf '%s\n9,8,6\n' "$heading" > "$work/in"
    run apply "$work/counts.json" "$work/in"
    check "apply: no warning about $heading" is_empty "$work/stderr"
done
# Without a unit in the header their size shows it: a field of 10, scale 1; of three readings, two are off.
echo '{"offset": [0, 0, 0], "matrix": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "gravity": 10, "unit": "m/s^2"}' > "$work/ten.json"
sizes() { printf 'x,y,z\n%s,0,0\n0,%s,0\n0,0,%s\n' "$1" "$2" "$3" > "$work/in"; run apply "$work/ten.json" "$work/in" $4; }
sizes 101 101 10
check "apply: too large a result is reported" warns \
    '.*in: most corrected readings are more than 10 times the field: the calibration was made from readings in m/s²,'
sizes 0.9 10 0.9
check "apply: and too small a one" warns '.*in: most corrected readings are less than 0\.1 times the field'
sizes 101 101 10 --quiet
check "apply --quiet: it is not" is_empty "$work/stderr"
for size in '99 99 101' '1.1 1.1 0.1' '101 10 0.9'; do
    # shellcheck disable=SC2086 # words
    sizes $size
    check "apply: but not $size" is_empty "$work/stderr"
done
echo '{"offset": [0, 0, 0], "matrix": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "gravity": [0, 0, 10]}' > "$work/ten.json"
sizes 101 101 10
check "apply: nor if the field is not known" is_empty "$work/stderr"
# The calibration of a magnetometer, for columns that are not of one.
echo '{"offset": [0, 0, 0], "matrix": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "gravity": 1, "unit": "uT", "magnetometer": {}}' \
    > "$work/ten.json"
for unit in 'g:g, or in gauss' 'mg:mg, or in milligauss' 'm/s2:a unit of another sensor'; do
    printf 'x (%s),y (%s),z (%s)\n1,0,0\n' "${unit%%:*}" "${unit%%:*}" "${unit%%:*}" > "$work/in"
    run apply "$work/ten.json" "$work/in"
    check "apply: a magnetometer's to readings in ${unit%%:*}" warns \
        ".*in: the header states readings in ${unit#*:}, but the calibration is of a magnetometer, from readings in µT:"
done
printf 'mx (G),my (G),mz (G)\n1,0,0\n' > "$work/in"
run apply "$work/ten.json" "$work/in"
check "apply: a magnetometer's own columns in gauss" warns '.*in: the header states readings in gauss, but the calibration was'
"$tool" simulate --plan edges | awk -F, 'NR == 1 { print "x (ug),y (ug),z (ug)"; next }
    { print $2 * 61 "," $3 * 61 "," $4 * 61 }' > "$work/ug"
run calibrate "$work/ug"
check "an unknown unit in the header" matches "$work/stdout" \
    'unknown: the unit in the header is not g, mg, m/s2 or counts; state --zero 0,0,0 and --lsb'
awk 'BEGIN { print "x;y;z"; for (i = 0; i < 150; i++) print "0,1;0,2;1,0" }' > "$work/commas"
run watch "$work/commas"
check "watch: a stream of decimal commas ends with an explanation" matches "$work/stderr" \
    'commas:101: 100 lines in a row cannot be read: is it the right file'
"$tool" simulate --plan faces --dwell 40 | awk -F, 'NR > 1 && $1 < 35 { print $2 ",0," $3 "," $4 "," $1 }' > "$work/rest"
accepts "allan --columns" allan "$work/rest" --columns t=5,x=1,y=3,z=4
accepts "watch --columns" watch "$work/log.csv" --columns mx,my,mz --rate 100
check "watch --columns: 18 positions" test "$(grep -c '^position .* taken' "$work/stdout")" -eq 18
choice() { # SENTENCE CODE PATTERN COLUMNS
    refuses "--columns: $1" "$2" "$3" calibrate "$work/log.csv" --columns "$4"
}
choice "two" 2 'x, y and z must all be given; give three' ax,ay
choice "four" 2 'more than three without a name' 1,2,3,4
choice "no meaning" 2 '--columns w=1: unknown name' w=1
choice "one twice" 2 'given twice' x=1,x=2,y=3,z=4
choice "an empty one" 2 'one is empty' ax,,az
choice "no such name" 3 "log\.csv:1: --columns: no column 'aw' for z among the 9: ax, ay, .*, mz$" ax,ay,aw
choice "no such number" 3 "no column '10' for z" 1,2,10
choice "a fraction" 3 "no column '1.5' for x" 1.5,2,3
choice "the same column" 3 'three different columns' ax,1,az

# ---- lines that are cut -----------------------------------------------------------------------------

sed 1d "$work/plain.csv" > "$work/rows"
cut_log() { # SENTENCE FIRST LAST SKIPPED: both by printf, LAST without an end of line
    { printf "$2"; cat "$work/rows"; printf "$3"; } > "$work/log.csv"
    is_right "$1"
    check "$1: it is reported" warns '.*log\.csv:[0-9]*: the (first|last) line is cut off, and ignored$'
    check "$1: once for each line" test "$(grep -c '^invcal: warning: ' "$work/stderr")" -eq "$4"
    check "$1: the table says so, too" matches "$work/stdout" "^ *$4 malformed line"
}
cut_log "the first line has lost columns" '46,13874,8846\n' '' 1
cut_log "the first line has one number left" '846\n' '' 1
cut_log "the first line begins in an exponent" 'e-05,378,13874,8846\n' '' 1
cut_log "the last line has lost columns" '' '124.00,378,13' 1
cut_log "the last line ends behind a comma" '' '124.00,378,13874,' 1
cut_log "the last line ends in a sign" '' '124.00,378,13874,-' 1
cut_log "both are cut" '8846\n' '124' 2
printf '3\n0.0,2,4,6\n0.1,2,4,' > "$work/log.csv"
run apply "$work/simple.json" "$work/log.csv"
check "apply: lines that are cut are left out" \
    test "$(cat "$work/stdout")" = "$(printf 't,x,y,z\n0.0,2,4,3')"
check "apply: both are reported" test "$(grep -c ' line is cut off, and ignored$' "$work/stderr")" -eq 2
{ cat "$work/plain.csv"; printf '124.00,37'; } > "$work/log.csv"
is_right "a last line that is cut, below a header"
{ cat "$work/rows"; printf '124.00,37\n'; cat "$work/rows"; } > "$work/log.csv"
refuses "a line cut in the middle is not one cut at the end" 3 \
    'log\.csv:12401: 2 columns, but line 1 has 4, separated by commas: correct the line, or delete it$' \
    calibrate "$work/log.csv"
{ cat "$work/rows"; printf '124.00,37,1,x\n'; } > "$work/log.csv"
{ cat "$work/rows"; printf 'a,b\n'; } > "$work/short.csv"
refuses "a last line of two words is not cut" 3 'short\.csv:12401: 2 columns, but line 1 has 4' \
    calibrate "$work/short.csv"
refuses "a last line with a word is not cut" 3 "log\.csv:12401: column 4 \(z\): 'x' is not a decimal number" \
    calibrate "$work/log.csv"
{ cat "$data/mpu9150_0_positions.csv"; printf '1,2'; } > "$work/log.csv"
refuses "position means stay strict" 3 ': 2 columns, but line .* has' calibrate "$work/log.csv" --positions

# ---- a rate that is not stated ----------------------------------------------------------------------

rate_log() { # HZ DWELL: 18 rests without times
    "$tool" simulate --rate "$1" --dwell "$2" | sed 1d | cut -d, -f2- > "$work/log.csv"
}
for hz in 25 50 100; do
    rate_log $hz 2.5
    is_right "$hz Hz without times"
    check "$hz Hz without times: $hz is guessed, which is reported" first_lines \
        "at $hz samples per second (a guess: state --rate)"
    run calibrate "$work/log.csv" --json
    check "$hz Hz without times: the JSON has the guess" test \
        "$(json "$work/stdout" rate) $(json "$work/stdout" rate_from)" = "$hz \"guess\""
    is_right "$hz Hz, stated" --rate $hz
done
rate_log 20 3
is_right "20 Hz without times"
check "20 Hz without times: it says that the rate is a guess" first_lines 'samples per second (a guess: state --rate)'
run calibrate "$work/log.csv" --rate 20 --json
check "20 Hz, stated: the JSON says so" test "$(json "$work/stdout" rate) $(json "$work/stdout" rate_from)" = \
    '20 "stated"'
rate_log 20 1.2
refuses "rests of 1 s at 20 Hz without times: what to do" 1 \
    'no rest of two seconds .* at 100 samples per second \(a guess\).* state --rate, and hold each position still for 3 s or longer, below 25 samples per second for 50 samples, or average each yourself and add --positions; for a magnetometer in motion: --magnetometer$' \
    calibrate "$work/log.csv"
refuses "rests of 1 s at 20 Hz: what to do" 1 \
    'no rest of 2\.5 seconds .* at 20 samples per second; refused [0-9]+: too short: .* \(near line [0-9]+, .*hold each position still for 3\.5 s or longer, or average each yourself and add --positions; for a magnetometer in motion: --magnetometer$' \
    calibrate "$work/log.csv" --rate 20
rate_log 20 3.5
is_right "rests of the stated length" --rate 20

# ---- too few ----------------------------------------------------------------------------------------

# Rests of simulate begin at 0, 7, 14 ... s: 5 s still, 2 s to turn. Of the third 1 s is left.
awk -F, '$1 == "t" || $1 < 15 || ($1 > 19 && $1 < 32)' "$work/plain.csv" > "$work/log.csv"
run calibrate "$work/log.csv"
check "too few: how many" was_refused 1 'log\.csv: [34] positions are too few: 9 are needed, 12 or more are good; found: '
check "too few: where the rests were, and how long" says \
    'found: line [0-9]+, 0\.[0-9]* to 4\.[0-9]* s \(4\.[0-9]* s\); line 7[0-9]+, 7\.[0-9]* to 11\.[0-9]* s \(4\.[0-9]* s\);'
check "too few: what was refused, why and where" says '; refused 1: too short: samples lost \(near line 15[0-9][0-9]\)'
check "too few: what to do" says '; hold each position still for 3 s or longer$'
run calibrate "$work/log.csv" --json
check "too few: the JSON says the same" matches "$work/stdout" '"reason": "[34] positions are too few.*; found: line '

# ---- files that are not tables ----------------------------------------------------------------------

no_table() { # SENTENCE PATTERN BYTES
    printf "$3" > "$work/bad"
    refuses "no table: $1" 3 "bad: this is $2" calibrate "$work/bad"
    refuses "no positions: $1" 3 "bad: this is $2" calibrate "$work/bad" --positions
}
no_table "PNG" 'a picture \(PNG\): readings are needed, as CSV$' '\211PNG\r\n\032\n\000\000'
no_table "JPEG" 'a picture \(JPEG\): readings' '\377\330\377\340\000\020JFIF'
no_table "GIF" 'a picture \(GIF\)' 'GIF89a\001\000'
no_table "TIFF" 'a picture \(TIFF\)' 'MM\000*\000\010'
no_table "PDF" 'a PDF document: export the readings as CSV' '%%PDF-1.7\n%%\342\343\n'
no_table "zip" 'a ZIP file or an Excel workbook: unpack it' 'PK\003\004\024\000'
no_table "gz" 'a gzip file: unpack it with gunzip$' '\037\213\010\000'
no_table "bz2" 'a bzip2 file: unpack it with bunzip2$' 'BZh91AY\000'
no_table "xz" 'an xz file: unpack it with unxz$' '\3757zXZ\000'
no_table "HTML" 'a web page or XML: ' '<!DOCTYPE html>\n<html>'
no_table "MAT" 'a MATLAB file: save the table' 'MATLAB 5.0 MAT-file, Platform'
no_table "SQLite" 'an SQLite database' 'SQLite format 3\000'
no_table "JSON" 'JSON: a table with one sample per line is needed' '{"offset": [1, 2, 3]}\n'
printf '1,2,3\n\001\002\003\n' > "$work/bad"
refuses "other data that is not text" 3 'not a text file; export the readings as CSV$' calibrate "$work/bad"
: > "$work/bad"
refuses "an empty file" 3 'bad: is empty: was it copied whole\?$' calibrate "$work/bad"

# ---- samples given as position means ----------------------------------------------------------------

awk 'NR > 1 && NR % 12 == 0' "$work/plain.csv" | cut -d, -f2- > "$work/samples.csv"
run calibrate "$work/samples.csv" --positions
check "a raw log as positions: it is reported, and what to do" warns \
    '.*samples\.csv: this looks like a raw log, .* invcal calibrate reads a raw log without --positions$'
check "a raw log as positions: ten that are left out are listed" test "$(grep -c '^Left out: ' "$work/stdout")" -eq 10
check "a raw log as positions: and how many more" matches "$work/stdout" '^ +and [0-9]{2,} more$'
for file in xsens_mti mpu9150_0 mpu9150_1 t265; do
    accepts "position means are not taken for samples: $file" calibrate "$data/${file}_positions.csv" --positions
done

# ---- options ----------------------------------------------------------------------------------------

cp "$work/plain.csv" "$work/log.csv"
accepts "--lsb as a quotient" calibrate "$work/log.csv" --lsb 9.80665/16344.4 --json
cp "$work/stdout" "$work/quotient"
run calibrate "$work/log.csv" --lsb "$(awk 'BEGIN { printf "%.17g", 9.80665 / 16344.4 }')" --json
check "--lsb as a quotient is the number" same "$work/stdout" "$work/quotient"
accepts "three quotients" calibrate "$work/log.csv" --lsb 9.80665/16344,9.80665/16300,0.0006
lsb() { # PATTERN VALUE
    refuses "--lsb $2" 2 "^invcal: --lsb.*$1" calibrate "$work/log.csv" --lsb "$2"
}
lsb 'is field per count, not counts per field: .* use --lsb 9\.80665/16384, which is 0\.00059855;' 16384
lsb 'use --lsb 1/1666\.67, which is 0\.000599999;' 1666.67
# The log has 16384 counts a g, of the data sheet; scale errors of 1 %.
size() { # PATTERN VALUE [ARGUMENTS]
    pattern=$1
    shift
    value=$1
    shift
    refuses "--lsb $value $*" 2 "^invcal: with --lsb $value the readings are $pattern" calibrate "$work/log.csv" \
        --lsb "$value" "$@"
}
size '0\.50[0-9]* times the field: use --lsb 9\.80665/16384 \(m/s\^2 per count\); see' 9.80665/32768
size '2\.0[0-9] times the field: use --lsb 9\.80665/16384 \(m/s\^2 per count\); see' 9.80665/8192
size '0\.10[0-9] times the field: use --lsb 9\.80665/16384 \(m/s\^2 per count\), or --gravity 1 if it is in g; see' 1/16384
size '0\.10[0-9] times the field: use --lsb 9\.80665/16384 \(m/s\^2 per count\), or --gravity 1 if' 1/16384 --latitude 47
size '9\.8[0-9] times the field: use --lsb 1/16384 \(g per count\); see' 9.80665/16384 --gravity 1
size '0\.20[0-9] times the field: by the data sheet it should be about 9\.80665/16384 \(m/s\^2 per count\); see' 1/8192
size '2\.0[0-9] times the field: use' 9.80665/8192 --zero 0,0,0
accepts "--gravity 1: --lsb in g" calibrate "$work/log.csv" --gravity 1 --lsb 1/16384
accepts "--lsb of another axis each, whose mean is right" calibrate "$work/log.csv" \
    --lsb 9.80665/8192,9.80665/32768,-9.80665/16384
# What is wrong is the zero, which is not found out by a scale.
awk -F, -v OFS=, 'NR > 1 { $2 += 32768; $3 += 32768; $4 += 32768 } 1' "$work/log.csv" > "$work/unsigned.csv"
accepts "--lsb of unsigned counts" calibrate "$work/unsigned.csv" --lsb 9.80665/16384
refuses "a zero that was forgotten" 1 'position 1 reads .* check --gravity, the nominal zero' \
    calibrate "$work/unsigned.csv" --zero -160000,0,0 --lsb 9.80665/16384
# Readings in another unit than stated.
in_unit() { # FACTOR
    awk -F, -v OFS=, -v f="$1" 'NR > 1 { for (i = 2; i <= 4; i++) $i *= f } 1' "$work/log.csv" > "$work/unit.csv"
}
cp "$work/log.csv" "$work/unit.csv"
unit() { # PATTERN UNIT
    refuses "--unit $2 of others: $1" 1 "unit\.csv: the readings are $1\$" calibrate "$work/unit.csv" --unit "$2"
}
unit '164[0-9][0-9] times the field in the stated unit, g; check --unit: counts' g
unit '16\.[0-9] times the field in the stated unit, mg; check --unit: counts' mg
in_unit 0.00059855
unit '9\.8[0-9] times the field in the stated unit, g; check --unit: m/s2' g
in_unit 0.000061035
unit '0\.10[0-9] times the field in the stated unit, m/s²; check --unit: g' m/s2
in_unit 0.061035
unit '10[0-9][0-9] times the field in the stated unit, g; check --unit: mg or counts' g
lsb "'9/0' is not a finite number" 9/0
lsb "'9/x' is not a decimal number" 9/x
lsb "'9/' is empty" 9/
lsb "'1/2/3' is not a decimal number" 1/2/3
for c in calibrate watch allan; do
    refuses "$c: an empty LOG" 2 '^invcal: LOG is empty: is a shell variable not set\?; see' $c ''
    refuses "$c: an empty --out" 2 '^invcal: --out: its value is empty: is a shell variable' $c "$work/log.csv" --out ''
    refuses "$c: an empty --gravity" 2 '^invcal: --gravity: its value is empty: is a shell variable' $c "$work/log.csv" --gravity=
done
refuses "apply: an empty CAL.json" 2 '^invcal: CAL\.json is empty' apply '' "$work/log.csv"
refuses "an empty command" 2 '^invcal: COMMAND is missing' ''

finish
