#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Tests of the tables that people have: input_test.sh path/to/invcal builddir
# The same readings in every dress must give the same calibration; what was recognised is told; what
# is no such table is refused, with the reason and what to do.
here=$(dirname "$0")
# shellcheck source=tests/tool/support.sh
. "$here/support.sh"

field() { json "$work/stdout" "$1"; }

# ---- one log in every dress ---------------------------------------------------------------------

# Counts of 0.0006 m/s^2: t in seconds, x, y, z.
"$tool" simulate --truth "$work/truth.json" > "$work/plain.csv"
run calibrate "$work/plain.csv" --json
check "the plain log: offsets are those of the truth, within 2 counts" \
    near 2 "$(field offset)" "$(json "$work/truth.json" offset)"
plain_offset=$(field offset)

ms2=0.0006
g=$(awk 'BEGIN { printf "%.17g", 0.0006 / 9.80665 }')
mg=$(awk 'BEGIN { printf "%.17g", 0.6 / 9.80665 }')

# The first lines of the table, as one: "NAME: what was recognised ...".
recognised() { tr '\n' ' ' < "$work/stdout" | grep -Fq -- "$1 $2"; }

# Has no more to say than what it says.
ends_there() { tr '\n' ' ' < "$work/stdout" | grep -Fq -- "$1 $2 $3"; }

# write_dress SCALE HEADER ROW: $work/dress.csv from the plain log; ROW is an expression of awk in t
# (seconds), x, y, z (counts by SCALE) and n (from 0). HEADER goes through printf %b.
write_dress() {
    {
        [ -z "$2" ] || printf '%b\n' "$2"
        awk -F, -v k="$1" 'BEGIN { CONVFMT = "%.15g" }
            NR > 1 { n = NR - 2; t = $1; x = $2 * k; y = $3 * k; z = $4 * k; print '"$3"' }' "$work/plain.csv"
    } > "$work/dress.csv"
}

scaled() { # SCALE: the plain offset in other units
    echo "$plain_offset" | tr -d '[],' | awk -v k="$1" '{ printf "%.12g %.12g %.12g", $1 * k, $2 * k, $3 * k }'
}

# dress SENTENCE SCALE UNIT ORIGIN RECOGNISED HEADER ROW: calibrate, from the standard input
dress() {
    write_dress "$2" "$6" "$7"
    in=$work/dress.csv
    run calibrate - --json
    check "$1: the same offset" near "$(awk -v k="$2" 'BEGIN { print 0.05 * k }')" "$(field offset)" "$(scaled "$2")"
    check "$1: 18 positions at 100 samples a second" test "$(field positions)" = 18
    check "$1: the unit is $3, by $4" test "$(field unit) $(field unit_from)" = "\"$3\" \"$4\""
    run calibrate -
    in=/dev/null
    check "$1: it is told" ends_there "standard input:" "$5" "standard input: 12400 samples, 124 s at 100"
}

ax='x "," y "," z'
dress "names and units in brackets" "$g" g header \
    'CSV with commas, header in line 1; t (s), ax ay az in g' 't (s),ax (g),ay (g),az (g)' "t \",\" $ax"
dress "square brackets, another order" $ms2 'm/s^2' header \
    'CSV with commas, header in line 1; Time (ms), ax ay az in m/s²; ignored: 1 other column' \
    'az [m/s^2],Time [ms],n,ax [m/s^2],ay [m/s^2]' 'z "," t * 1000 "," n "," x "," y'
dress "units behind the names, semicolons" "$mg" mg header \
    'CSV with semicolons, header in line 1; t_ms (ms), acc_x_mg acc_y_mg acc_z_mg in mg' \
    't_ms;acc_x_mg;acc_y_mg;acc_z_mg' 't * 1000 ";" x ";" y ";" z'
dress "accel_x_mps2, tabs" $ms2 'm/s^2' header \
    'table with tabs, header in line 1; timestamp_ns (ns), accel_x_mps2 accel_y_mps2 accel_z_mps2 in m/s²' \
    'timestamp_ns\taccel_x_mps2\taccel_y_mps2\taccel_z_mps2' \
    't * 1e9 "\t" x "\t" y "\t" z'
dress "phyphox" $ms2 'm/s^2' header \
    'CSV with commas, header in line 1; Time (s), Acceleration x Acceleration y Acceleration z in m/s²; ignored: 1 other column' \
    '"Time (s)","Acceleration x (m/s^2)","Acceleration y (m/s^2)","Acceleration z (m/s^2)","Absolute acceleration (m/s^2)"' \
    "t \",\" $ax \",\" sqrt(x * x + y * y + z * z)"
dress "AndroSensor, with superscripts" $ms2 'm/s^2' header \
    'CSV with semicolons, header in line 1; ACCELEROMETER X ACCELEROMETER Y ACCELEROMETER Z in m/s²; ignored: 2 other columns' \
    'ACCELEROMETER X (m/s²);ACCELEROMETER Y (m/s²);ACCELEROMETER Z (m/s²);GYROSCOPE X (rad/s);note' \
    'x ";" y ";" z ";0.1;"'
dress "PX4 sensor_combined by ulog2csv" $ms2 'm/s^2' header \
    'CSV with commas, header in line 1; timestamp (µs), accelerometer_m_s2[0] accelerometer_m_s2[1] accelerometer_m_s2[2] in m/s²; ignored: 6 other columns' \
    'timestamp,gyro_rad[0],gyro_rad[1],gyro_rad[2],gyro_integral_dt,accelerometer_timestamp_relative,accelerometer_m_s2[0],accelerometer_m_s2[1],accelerometer_m_s2[2],accelerometer_integral_dt' \
    "t * 1e6 + 123456789 \",0.1,0.2,0.3,4000,0,\" $ax \",4000\""
dress "PX4 sensor_accel by ulog2csv" $ms2 'm/s^2' size \
    'CSV with commas, header in line 1; timestamp (µs), x y z in m/s² (by their size), temperature; ignored: 7 other columns' \
    'timestamp,timestamp_sample,device_id,x,y,z,temperature,error_count,clip_counter[0],clip_counter[1],clip_counter[2],samples' \
    "t * 1e6 \",\" t * 1e6 \",1310988,\" $ax \",35.5,0,0,0,0,8\""
dress "PX4 vehicle_acceleration by ulog2csv" $ms2 'm/s^2' size \
    'CSV with commas, header in line 1; timestamp (µs), xyz[0] xyz[1] xyz[2] in m/s² (by their size); ignored: 1 other column' \
    'timestamp,timestamp_sample,xyz[0],xyz[1],xyz[2]' "t * 1e6 \",\" t * 1e6 \",\" $ax"
betaflight='loopIteration, time (us), axisP[0], rcCommand[3], vbatLatest (V), gyroADC[0], gyroADC[1], gyroADC[2]'
behind='magADC[0], magADC[1], magADC[2], motor[0], flightModeFlags (flags)'
bf_row='n ", " t * 1e6 ", 0, 1000, 16.1, 5, 6, 7, " x ", " y ", " z ", 1, 2, 3, 1070, ANGLE|HORIZON"'
dress "blackbox_decode" 1 counts header \
    'CSV with commas, header in line 1; time (µs), accSmooth[0] accSmooth[1] accSmooth[2] in counts; ignored: 12 other columns' \
    "$betaflight, accSmooth[0], accSmooth[1], accSmooth[2], $behind" "$bf_row"
dress "blackbox_decode --unit-acceleration g" "$g" g header \
    'CSV with commas, header in line 1; time (µs), accSmooth[0] accSmooth[1] accSmooth[2] in g; ignored: 12 other columns' \
    "$betaflight, accSmooth[0] (g), accSmooth[1] (g), accSmooth[2] (g), $behind" "$bf_row"
dress "blackbox_decode --unit-acceleration m/s2" $ms2 'm/s^2' header \
    'CSV with commas, header in line 1; time (µs), accSmooth[0] accSmooth[1] accSmooth[2] in m/s²; ignored: 12 other columns' \
    "$betaflight, accSmooth[0] (m/s/s), accSmooth[1] (m/s/s), accSmooth[2] (m/s/s), $behind" "$bf_row"
dress "the explorer of Betaflight, with settings before" 1 counts header \
    'CSV with commas, 4 lines of settings, header in line 5; time (µs), accSmooth[0] accSmooth[1] accSmooth[2] in counts; ignored: 2 other columns' \
    '"Product","Blackbox flight data recorder by Nicholas Sherlock"\n"firmwareType",3\n"rollPID",42,85,35\n"Craft name",""\n"loopIteration","time","gyroADC[0]","accSmooth[0]","accSmooth[1]","accSmooth[2]"' \
    "n \",\" t * 1e6 \",7,\" $ax"
dress "ArduPilot IMU by mavlogdump.py" $ms2 'm/s^2' header \
    'CSV with commas, header in line 1; TimeUS (µs), AccX AccY AccZ in m/s²; ignored: 8 other columns' \
    'timestamp,TimeUS,I,GyrX,GyrY,GyrZ,AccX,AccY,AccZ,EG,EA,GHz' \
    "1.7e9 + t \",\" t * 1e6 \",0,.1,.2,.3,\" $ax \",0,0,1000\""
dress "xacc yacc zacc, and a gyro" "$mg" mg size \
    'CSV with commas, header in line 1; millis (ms), xacc yacc zacc in mg (by their size); ignored: 3 other columns' \
    'millis,xacc,yacc,zacc,xgyro,ygyro,zgyro' "t * 1000 \",\" $ax \",1,2,3\""
dress "w and g columns are a gyro's" "$g" g size \
    'CSV with commas, header in line 1; t (s), a_x a_y a_z in g (by their size); ignored: 6 other columns' \
    't,g_x,g_y,g_z,a_x,a_y,a_z,wx,wy,wz' "t \",9,9,9,\" $ax \",8,8,8\""
dress "two clocks: the one that states its unit" 1 counts size \
    'CSV with commas, header in line 1; seconds_elapsed (s), x y z in counts (by their size); ignored: 1 other column' \
    'time,seconds_elapsed,z,y,x' '1.7e18 "," t "," z "," y "," x'
dress "a row of units, as Shimmer writes" $ms2 'm/s^2' header \
    'CSV with semicolons, header in line 2, units in line 3; time (ms), ax ay az in m/s²; ignored: 1 other column' \
    'sep=;\ntime;ax;ay;az;gx\nms;m/(s^2)*;m/(s^2)*;m/(s^2)*;deg/s' 't * 1000 ";" x ";" y ";" z ";1"'
dress "everything odd at once" 1 counts header \
    'CSV with semicolons, header in line 5; t (s), ax ay az in counts; ignored: 1 other column' \
    '\0357\0273\0277// made by hand\r\n% more\r\n; more\r\n# more; and more\r\n"t" ; "az (raw)";"ay (raw)"; "ax (raw)" ;"no;te"\r' \
    't ";" z "; \"" y "\" ;" x ";\"a;b\"\r"'
dress "a separator too many in each line" 1 counts size \
    'CSV with commas, no header; t (s), x y z in counts (by their size)' '' "t \",\" $ax \",\""

# ---- positions: generated here, so the offset is known -------------------------------------------

# write_positions SCALE HEADER ROW: six faces and twelve edges in a field of one g, offsets 0.02,
# -0.03, 0.05 g, scale errors and skew of some percent; ROW in x, y, z (g by SCALE), n from 0.
write_positions() {
    {
        [ -z "$2" ] || printf '%b\n' "$2"
        awk -v k="$1" 'function reading(a, b, c,    l) {
                l = sqrt(a * a + b * b + c * c)
                a /= l; b /= l; c /= l
                x = k * (1.01 * a + 0.004 * b + 0.02); y = k * (0.98 * b - 0.03)
                z = k * (1.02 * c + 0.003 * a + 0.05)
                '"print $3"'
                n++
            }
            BEGIN {
                CONVFMT = "%.15g"
                for (a = -1; a < 2; a++) for (b = -1; b < 2; b++) for (c = -1; c < 2; c++)
                    if ((l = a * a + b * b + c * c) && l < 3) reading(a, b, c)
            }'
    } > "$work/pos.csv"
}

# dress_positions SENTENCE SCALE UNIT ORIGIN NOMINAL RECOGNISED HEADER ROW [OPTIONS ...]
dress_positions() {
    sentence_=$1 scale=$2 unit=$3 origin=$4 nominal=$5 told=$6
    write_positions "$2" "$7" "$8"
    shift 8
    in=$work/pos.csv
    run calibrate - --positions --json "$@"
    check "$sentence_: the offset is the true one" near "$(awk -v k="$scale" 'BEGIN { print 1e-9 * k }')" "$(field offset)" \
        "$(awk -v k="$scale" 'BEGIN { printf "%.15g %.15g %.15g", 0.02 * k, -0.03 * k, 0.05 * k }')"
    check "$sentence_: the unit is $unit, by $origin" test "$(field unit) $(field unit_from)" = "\"$unit\" \"$origin\""
    check "$sentence_: zero and scale are by $nominal" test "$(awk -F '"' '/"(zero|lsb)_from"/ { printf "%s ", $4 }' "$work/stdout")" = "${nominal% *} ${nominal#* } "
    run calibrate - --positions "$@"
    in=/dev/null
    check "$sentence_: it is told" ends_there "standard input:" "$told" "standard input: 18 positions"
}

x='x "," y "," z'
dress_positions "positions in g, stated" 1 g header unit \
    'CSV with commas, header in line 1; x y z in g' 'x (g),y (g),z (g)' "$x"
check "positions in g: the table is in g" matches "$work/stdout" '^offset y .* g$'
check "positions in g: scales are in g" matches "$work/stdout" '^scale z .* g per m/s²$'
check "positions in g: zero and scale are by the unit" matches "$work/stdout" \
    '^nominal: zero and scale by the unit that is stated'
check "positions in g: scale errors are those of the sensor, within 0.1 %" near 0.1 \
    "$(awk '/^scale error/ { printf "%s ", $4 }' "$work/stdout")" '1 -2 2'
dress_positions "positions in g, by size" 1 g size range \
    'CSV with commas, no header; x y z in g (by their size)' '' "$x"
dress_positions "positions in mg" 1000 mg header unit \
    'table with blanks, header in line 1; mean_x_mg mean_y_mg mean_z_mg in mg' \
    'mean_x_mg mean_y_mg mean_z_mg' 'x " " y " " z'
dress_positions "positions in mg, by size" 1000 mg size range \
    'table with tabs, no header; x y z in mg (by their size)' '' 'x "\t" y "\t" z'
dress_positions "positions in m/s^2" 9.80665 'm/s^2' header unit \
    'CSV with commas, header in line 1; mean_x mean_y mean_z in m/s², std_x, std_y, std_z, n_samples' \
    'mean_x (m/s^2),mean_y (m/s^2),mean_z (m/s^2),std_x (m/s^2),std_y (m/s^2),std_z (m/s^2),n_samples' \
    "$x \",0.01,0.01,0.01,100\""
dress_positions "positions in m/s^2, by size" 9.80665 'm/s^2' size range \
    'CSV with commas, no header; x y z in m/s² (by their size), std, n' '' "$x \",0.01,100\""
dress_positions "positions in counts" 16384 counts header range \
    'CSV with commas, header in line 1; ax_raw ay_raw az_raw in counts' 'ax_raw,ay_raw,az_raw' "$x"
dress_positions "counts of 2048 by size" 2048 counts size range \
    'CSV with commas, no header; x y z in counts (by their size)' '' "$x"
dress_positions "--unit states what no header does" 1000 mg option unit \
    'CSV with commas, no header; x y z in mg (--unit)' '' "$x" --unit mg
dress_positions "--unit m/s2" 9.80665 'm/s^2' option unit \
    'CSV with commas, no header; x y z in m/s² (--unit)' '' "$x" --unit m/s2
dress_positions "--unit counts keeps the range" 1000 counts option range \
    'CSV with commas, no header; x y z in counts (--unit)' '' "$x" --unit counts
dress_positions "--unit knows better than the header" 1000 mg option unit \
    'CSV with commas, header in line 1; x y z in mg (--unit)' 'x (g),y (g),z (g)' "$x" --unit mg
dress_positions "a stated unit with --zero" 1 g header 'given unit' \
    'CSV with commas, header in line 1; x y z in g' 'x (g),y (g),z (g)' "$x" --zero 0,0,0.1
dress_positions "a stated unit with --lsb" 1 g header 'range given' \
    'CSV with commas, header in line 1; x y z in g' 'x (g),y (g),z (g)' "$x" --lsb 9.8
dress_positions "a field of 1 keeps the range" 1 g header range \
    'CSV with commas, header in line 1; x y z in g' 'x (g),y (g),z (g)' "$x" --gravity 1
dress_positions "a magnetometer: no size tells a unit" 48.5 unknown none range \
    'CSV with commas, header in line 1; mx my mz' 'mx,my,mz' "$x" --gravity 48.5
dress_positions "a unit that is not known is not guessed" 1 unknown none range \
    'CSV with commas, header in line 1; mx my mz' 'mx (gauss),my (gauss),mz (gauss)' "$x"
dress_positions "every line ends with a separator, but the header" 1 g header unit \
    'CSV with commas, header in line 1; x y z in g' 'x (g),y (g),z (g)' "$x \",\""
dress_positions "every line ends with a separator, the header too" 1 g header unit \
    'CSV with semicolons, header in line 1; x y z in g' 'x (g);y (g);z (g);' 'x ";" y ";" z ";"'
dress_positions "a row of units in brackets" 1 g header unit \
    'CSV with commas, header in line 1, units in line 2; X Y Z in g' 'X,Y,Z\n(g),(g),[g]' "$x"
dress_positions "a stream of ROS begins with %time" 9.80665 'm/s^2' size range \
    'CSV with commas, header in line 1; %time (ns), x y z in m/s² (by their size)' '%time,x,y,z' "n \",\" $x"
finish
