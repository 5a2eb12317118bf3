#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Tests of the tables that users have: input_test.sh path/to/invcal builddir
# The same readings in every form must give the same calibration, and a report of what was recognised;
# what is not such a table is refused, with the reason and what to do.
here=$(dirname "$0")
# shellcheck source=tests/tool/support.sh
. "$here/support.sh"

field() { json "$work/stdout" "$1"; }

# ---- one log in every form ----------------------------------------------------------------------

# Counts of 0.0006 m/s^2: t in seconds, x, y, z.
"$tool" simulate --truth "$work/truth.json" > "$work/plain.csv"
run calibrate "$work/plain.csv" --json
check "the plain log: offsets are those of the truth, within 2 counts" \
    near 2 "$(field offset)" "$(json "$work/truth.json" offset)"
plain_offset=$(field offset)

ms2=0.0006
g=$(awk 'BEGIN { printf "%.17g", 0.0006 / 9.80665 }')
mg=$(awk 'BEGIN { printf "%.17g", 0.6 / 9.80665 }')

# announces NAME RECOGNISED NEXT: the first lines of the table, joined, are NAME and what was recognised;
# the line after them begins with NEXT.
announces() { tr '\n' ' ' < "$work/stdout" | grep -Fq -- "$1 $2 $3"; }

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
    check "$1: the unit is $3, from $4" test "$(field unit) $(field unit_from)" = "\"$3\" \"$4\""
    run calibrate -
    in=/dev/null
    check "$1: it is reported" announces "standard input:" "$5" "standard input: 12400 samples, 124 s at 100"
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
dress "ISO 8859-1" $ms2 'm/s^2' header \
    'CSV with semicolons, header in line 1; time (µs), X Y Z in m/s²' \
    'time [\0265s];X [m/s\0262];Y [m/s\0262];Z [m/s\0262]' 't * 1e6 ";" x ";" y ";" z'
dress "PX4 sensor_combined by ulog2csv" $ms2 'm/s^2' header \
    'CSV with commas, header in line 1; timestamp (µs), accelerometer_m_s2[0] accelerometer_m_s2[1] accelerometer_m_s2[2] in m/s²; gyroscope: gyro_rad[0] gyro_rad[1] gyro_rad[2] in rad/s; ignored: 3 other columns' \
    'timestamp,gyro_rad[0],gyro_rad[1],gyro_rad[2],gyro_integral_dt,accelerometer_timestamp_relative,accelerometer_m_s2[0],accelerometer_m_s2[1],accelerometer_m_s2[2],accelerometer_integral_dt' \
    "t * 1e6 + 123456789 \",0.1,0.2,0.3,4000,0,\" $ax \",4000\""
check "PX4 sensor_combined: it is said to be corrected already" \
    says 'warning: .*: sensor_combined of PX4 is already corrected by the autopilot: use sensor_accel$'
dress "PX4 sensor_accel by ulog2csv" $ms2 'm/s^2' size \
    'CSV with commas, header in line 1; timestamp (µs), x y z in m/s² (by their size), temperature; ignored: 7 other columns' \
    'timestamp,timestamp_sample,device_id,x,y,z,temperature,error_count,clip_counter[0],clip_counter[1],clip_counter[2],samples' \
    "t * 1e6 \",\" t * 1e6 \",1310988,\" $ax \",35.5,0,0,0,0,8\""
check "PX4 sensor_accel: it is not" is_empty "$work/stderr"
dress "PX4 vehicle_acceleration by ulog2csv" $ms2 'm/s^2' size \
    'CSV with commas, header in line 1; timestamp (µs), xyz[0] xyz[1] xyz[2] in m/s² (by their size); ignored: 1 other column' \
    'timestamp,timestamp_sample,xyz[0],xyz[1],xyz[2]' "t * 1e6 \",\" t * 1e6 \",\" $ax"
betaflight='loopIteration, time (us), axisP[0], rcCommand[3], vbatLatest (V), gyroADC[0], gyroADC[1], gyroADC[2]'
behind='magADC[0], magADC[1], magADC[2], motor[0], flightModeFlags (flags)'
bf_row='n ", " t * 1e6 ", 0, 1000, 16.1, 5, 6, 7, " x ", " y ", " z ", 1, 2, 3, 1070, ANGLE|HORIZON"'
check "PX4 vehicle_acceleration: it is" says 'warning: .*: vehicle_acceleration of PX4 is already corrected '
dress "blackbox_decode" 1 counts header \
    'CSV with commas, header in line 1; time (µs), accSmooth[0] accSmooth[1] accSmooth[2] in counts; gyroscope: gyroADC[0] gyroADC[1] gyroADC[2]; ignored: 9 other columns' \
    "$betaflight, accSmooth[0], accSmooth[1], accSmooth[2], $behind" "$bf_row"
dress "blackbox_decode --unit-acceleration g" "$g" g header \
    'CSV with commas, header in line 1; time (µs), accSmooth[0] accSmooth[1] accSmooth[2] in g; gyroscope: gyroADC[0] gyroADC[1] gyroADC[2]; ignored: 9 other columns' \
    "$betaflight, accSmooth[0] (g), accSmooth[1] (g), accSmooth[2] (g), $behind" "$bf_row"
dress "blackbox_decode --unit-acceleration m/s2" $ms2 'm/s^2' header \
    'CSV with commas, header in line 1; time (µs), accSmooth[0] accSmooth[1] accSmooth[2] in m/s²; gyroscope: gyroADC[0] gyroADC[1] gyroADC[2]; ignored: 9 other columns' \
    "$betaflight, accSmooth[0] (m/s/s), accSmooth[1] (m/s/s), accSmooth[2] (m/s/s), $behind" "$bf_row"
dress "the explorer of Betaflight, with settings before" 1 counts header \
    'CSV with commas, 4 lines of settings, header in line 5; time (µs), accSmooth[0] accSmooth[1] accSmooth[2] in counts; ignored: 2 other columns' \
    '"Product","Blackbox flight data recorder by Nicholas Sherlock"\n"firmwareType",3\n"rollPID",42,85,35\n"Craft name",""\n"loopIteration","time","gyroADC[0]","accSmooth[0]","accSmooth[1]","accSmooth[2]"' \
    "n \",\" t * 1e6 \",7,\" $ax"
dress "what a board sends when it starts" 1 counts size \
    'CSV with commas, 2 lines of settings, 5 lines of text before the header ignored, header in line 9; ms (ms), ax ay az in counts (by their size)' \
    'rst:0x1 (POWERON_RESET),boot:0x13\nmode:DIO, clock div:1\nets Jul 29 2019 12:21:46\nclk_drv:0x00,q_drv:0x00,d_drv:0x00\nentry 0x400805f0\nMPU6050 found\n\nReady!\nms,ax,ay,az' \
    "t * 1000 \",\" $ax"
dress "the same, without a header" 1 counts size \
    'CSV with commas, 1 line of text before the readings ignored, no header; t (s), x y z in counts (by their size)' \
    'MPU6050 found' "t \",\" $ax"
dress "the same, and readings with tabs" 1 counts size \
    'table with tabs, 1 line of text before the readings ignored, no header; t (s), x y z in counts (by their size)' \
    'Hello, World!\nStarting, please, wait' "t \"\\t\" x \"\\t\" y \"\\t\" z"
dress "commas with tabs behind" 1 counts size \
    'CSV with commas, header in line 1; x y z in counts (by their size)' 'x,\ty,\tz' 'x ",\t" y ",\t" z'
dress "ArduPilot IMU by mavlogdump.py" $ms2 'm/s^2' header \
    'CSV with commas, header in line 1; TimeUS (µs), AccX AccY AccZ in m/s², T; gyroscope: GyrX GyrY GyrZ in rad/s; ignored: 8 other columns' \
    'timestamp,TimeUS,I,GyrX,GyrY,GyrZ,AccX,AccY,AccZ,EG,EA,T,GH,AH,GHz,AHz' \
    "1.7e9 + t \",\" t * 1e6 \",0,.1,.2,.3,\" $ax \",0,0,45.5,1,1,1000,1000\""
dress "xacc yacc zacc, and a gyro" "$mg" mg size \
    'CSV with commas, header in line 1; millis (ms), xacc yacc zacc in mg (by their size); gyroscope: xgyro ygyro zgyro' \
    'millis,xacc,yacc,zacc,xgyro,ygyro,zgyro' "t * 1000 \",\" $ax \",1,2,3\""
dress "w and g columns are a gyro's" "$g" g size \
    'CSV with commas, header in line 1; t (s), a_x a_y a_z in g (by their size); gyroscope: g_x g_y g_z; ignored: 3 other columns' \
    't,g_x,g_y,g_z,a_x,a_y,a_z,wx,wy,wz' "t \",9,9,9,\" $ax \",8,8,8\""
dress "kalibr_bagextractor" $ms2 'm/s^2' header \
    'CSV with commas, header in line 1; timestamp (ns), alpha_x alpha_y alpha_z in m/s²; gyroscope: omega_x omega_y omega_z in rad/s' \
    'timestamp,omega_x,omega_y,omega_z,alpha_x,alpha_y,alpha_z' "t * 1e9 \",.1,.2,.3,\" $ax"
dress "a column called #" 1 counts size \
    'CSV with semicolons, header in line 1; AccX AccY AccZ in counts (by their size); ignored: 1 other column' \
    '#;Mode;AccZ;AccY;AccX' 'n ";RUN;" z ";" y ";" x'
clock='sprintf("%02d:%02d:%05.2f", int(t / 3600 + 22), int(t / 60) % 60, t % 60)'
dress "times of the day" 1 counts size \
    'CSV with commas, header in line 1; time (s), ax ay az in counts (by their size)' 'time,ax,ay,az' "$clock \",\" $ax"
dress "times of the day, without a header" 1 counts size \
    'CSV with semicolons, no header; t (s), x y z in counts (by their size)' '' "\"2026-11-24T\" $clock \"Z;\" x \";\" y \";\" z"
dress "date and time, in a heading of milliseconds" 1 counts size \
    'CSV with commas, header in line 1; t_ms (ms), ax ay az in counts (by their size)' 't_ms,ax,ay,az' \
    "\"2026-11-24 \" $clock \",\" $ax"
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
    sentence_=$1 scale=$2 unit=$3 origin=$4 nominal=$5 text=$6
    write_positions "$2" "$7" "$8"
    shift 8
    in=$work/pos.csv
    run calibrate - --positions --json "$@"
    check "$sentence_: the offset is the true one" near "$(awk -v k="$scale" 'BEGIN { print 1e-9 * k }')" "$(field offset)" \
        "$(awk -v k="$scale" 'BEGIN { printf "%.15g %.15g %.15g", 0.02 * k, -0.03 * k, 0.05 * k }')"
    check "$sentence_: the unit is $unit, from $origin" test "$(field unit) $(field unit_from)" = "\"$unit\" \"$origin\""
    check "$sentence_: zero and scale come from $nominal" test "$(awk -F '"' '/"(zero|lsb)_from"/ { printf "%s ", $4 }' "$work/stdout")" = "${nominal% *} ${nominal#* } "
    run calibrate - --positions "$@"
    in=/dev/null
    check "$sentence_: it is reported" announces "standard input:" "$text" "standard input: 18 positions"
}

x='x "," y "," z'
dress_positions "positions in g, stated" 1 g header unit \
    'CSV with commas, header in line 1; x y z in g' 'x (g),y (g),z (g)' "$x"
check "positions in g: the table is in g" matches "$work/stdout" '^offset y .* g$'
check "positions in g: scales are in g" matches "$work/stdout" '^scale z .* g per m/s²$'
check "positions in g: zero and scale come from the unit" matches "$work/stdout" \
    '^nominal: zero and scale from the unit$'
check "positions in g: scale errors are those of the sensor, within 0.1 %" near 0.1 \
    "$(awk '/^scale error/ { printf "%s ", $4 }' "$work/stdout")" '1 -2 2'
dress_positions "positions in g, by size" 1 g size unit \
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
dress_positions "positions in m/s^2, by size" 9.80665 'm/s^2' size unit \
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
dress_positions "--unit overrides the header" 1000 mg option unit \
    'CSV with commas, header in line 1; x y z in mg (--unit)' 'x (g),y (g),z (g)' "$x" --unit mg
dress_positions "a stated unit with --zero" 1 g header 'given unit' \
    'CSV with commas, header in line 1; x y z in g' 'x (g),y (g),z (g)' "$x" --zero 0,0,0.1
dress_positions "a stated unit with --lsb" 1 g header 'unit given' \
    'CSV with commas, header in line 1; x y z in g' 'x (g),y (g),z (g)' "$x" --lsb 9.8
dress_positions "a field of 1 means g" 1 g header unit \
    'CSV with commas, header in line 1; x y z in g' 'x (g),y (g),z (g)' "$x" --gravity 1
dress_positions "a magnetometer: the size gives no unit" 48.5 unknown none range \
    'CSV with commas, header in line 1; mx my mz' 'mx,my,mz' "$x" --gravity 48.5
dress_positions "an unknown unit is not guessed" 1 unknown none range \
    'CSV with commas, header in line 1; mx my mz' 'mx (oersted),my (oersted),mz (oersted)' "$x"
dress_positions "a magnetometer's unit is reported, and gives no scale" 1 gauss header range \
    'CSV with commas, header in line 1; mx my mz in gauss' 'mx (gauss),my (gauss),mz (gauss)' "$x"
dress_positions "every line ends with a separator, but the header" 1 g header unit \
    'CSV with commas, header in line 1; x y z in g' 'x (g),y (g),z (g)' "$x \",\""
dress_positions "every line ends with a separator, the header too" 1 g header unit \
    'CSV with semicolons, header in line 1; x y z in g' 'x (g);y (g);z (g);' 'x ";" y ";" z ";"'
dress_positions "a row of units in brackets" 1 g header unit \
    'CSV with commas, header in line 1, units in line 2; X Y Z in g' 'X,Y,Z\n(g),(g),[g]' "$x"
dress_positions "rostopic echo -p" 9.80665 'm/s^2' header unit \
    'CSV with commas, header in line 1; %time (ns), field.linear_acceleration.x field.linear_acceleration.y field.linear_acceleration.z in m/s²; ignored: 2 other columns' \
    '%time,field.header.seq,field.angular_velocity.x,field.linear_acceleration.x,field.linear_acceleration.y,field.linear_acceleration.z' \
    "n \",1,0.1,\" $x"
dress_positions "ROS, a bag as CSV" 9.80665 'm/s^2' header unit \
    'CSV with commas, header in line 1; linear_acceleration.x linear_acceleration.y linear_acceleration.z in m/s²; ignored: 2 other columns' \
    'header.stamp.sec,angular_velocity.x,linear_acceleration.x,linear_acceleration.y,linear_acceleration.z' \
    "n \",0.1,\" $x"
dress_positions "Physics Toolbox" 1 g header unit \
    'CSV with commas, header in line 1; time (s), gFx gFy gFz in g; ignored: 1 other column' \
    'time,gFx,gFy,gFz,TgF' "n \",\" $x \",1\""

# ---- apply --------------------------------------------------------------------------------------

echo '{"offset": [1, 2, 3], "matrix": [[2, 0, 0], [0, 2, 0], [0, 0, 1e0]]}' > "$work/simple.json"
applied() { # applied SENTENCE INPUT OUTPUT, both by printf
    printf "$2" > "$work/in"
    printf "$3" > "$work/expected"
    in=$work/in
    run apply "$work/simple.json" -
    in=/dev/null
    check "apply: $1" sh -c '[ "$1" -eq 0 ] && cmp -s "$2" "$3"' sh "$code" "$work/stdout" \
        "$work/expected"
}
applied "microseconds become seconds, to the last digit" \
    'timestamp,timestamp_sample,x,y,z\n1234567890123456,0,2,4,6\n7,0,1,2,3\n' \
    't,x,y,z\n1234567890.123456,2,4,3\n7e-06,0,0,0\n'
applied "milliseconds" 't_ms;ax;ay;az\n1500;2;4;6\n' 't,x,y,z\n1.5,2,4,3\n'
applied "seconds are copied as they were" 'Time (s),ax,ay,az\n1.500,2,4,6\n' \
    't,x,y,z\n1.500,2,4,3\n'
applied "units, a separator too many, comments" \
    '\357\273\277"sep=;"\r\n// a\r\naz [g];ay [g];ax [g];\r\n6;4;2;\r\n%% b\r\n3;2;1;\r\n' \
    'x,y,z\n2,4,3\n0,0,0\n'
applied "a row of units" 'time,ax,ay,az\nms,g,g,g\n250,2,4,6\n' 't,x,y,z\n0.25,2,4,3\n'
applied "settings before the header" 'name,sensor 5\nrange,16,g\nx,y,z\n2,4,6\n' 'x,y,z\n2,4,3\n'

# ---- watch --------------------------------------------------------------------------------------

write_dress "$g" 'time (us),ax (g),ay (g),az (g),gyro_x,gyro_y,gyro_z' \
    't * 1e6 "," x "," y "," z ",1,2,3"'
in=$work/dress.csv
run watch -
check "watch: the first line says what was recognised" test "$(head -n 1 "$work/stdout")" = \
    'standard input: CSV with commas, header in line 1; time (µs), ax ay az in g; gyroscope: gyro_x gyro_y gyro_z'
check "watch: 18 positions of a log in g" test "$(grep -c '^position .* taken' "$work/stdout")" -eq 18
run watch - --json
check "watch: with --json it goes to stderr" matches "$work/stderr" '^standard input: CSV .* in g;'
check "watch: the offset in g" near "$(awk -v k="$g" 'BEGIN { print 0.05 * k }')" "$(field offset)" \
    "$(scaled "$g")"
write_dress "$mg" '' 't "," x "," y "," z'
run watch - --unit mg
check "watch: --unit is reported" test "$(head -n 1 "$work/stdout")" = \
    'standard input: CSV with commas, no header; t (s), x y z in mg (--unit)'
check "watch: --unit gives zero and scale" matches "$work/stdout" \
    '^nominal: zero and scale from the unit$'
in=/dev/null

# ---- refusals -----------------------------------------------------------------------------------

# bad_line SENTENCE PATTERN BYTES: the bytes, through printf, as a log, as positions, and for apply
bad_line() {
    printf "$3" > "$work/bad.csv"
    refuses "calibrate LOG: $1" 3 "$2" calibrate "$work/bad.csv"
    refuses "calibrate --positions: $1" 3 "$2" calibrate "$work/bad.csv" --positions
    refuses "apply: $1" 3 "$2" apply "$work/simple.json" "$work/bad.csv"
}
bad() { # the same for what watch does not skip either
    bad_line "$@"
    refuses "watch: $1" 3 "$2" watch "$work/bad.csv"
}
bad "a PX4 ulog" 'bad\.csv: this is a PX4 ulog: convert it with ulog2csv, and use its sensor_accel' \
    'ULog\001\022\065\001\000\000'
bad "a blackbox log" 'bad\.csv: this is a Betaflight or INAV blackbox log: .* with blackbox_decode$' \
    'H Product:Blackbox flight data recorder by Nicholas Sherlock\nH Data version:2\n'
bad "a dataflash log" 'this is an ArduPilot dataflash log: convert it with mavlogdump\.py' \
    '\243\225\200\200\131FMT\000'
bad "a dataflash log as text" 'this is an ArduPilot text log: .* mavlogdump\.py' \
    'FMT, 128, 89, FMT, BBnNZ, Type,Length,Name,Format,Columns\n'
bad "a ROS bag" 'this is a ROS bag: convert its IMU topic with rostopic echo -p$' '#ROSBAG V2.0\n'
bad "a workbook" 'this is a ZIP file or an Excel workbook: unpack it, or save the sheet as CSV$' \
    'PK\003\004\024\000'
bad "an old workbook" 'this is an old Excel workbook: save the sheet as CSV$' '\320\317\021\340\241'
bad "a gzip file" 'this is a gzip file: unpack it with gunzip$' '\037\213\010\000'
bad "UTF-16, little end first" 'this is UTF-16 text: save it as UTF-8$' '\377\376x\000,\000'
bad "UTF-16, big end first" 'this is UTF-16 text: save it as UTF-8$' '\376\377\000x\000,'
in=$work/bad.csv
refuses "UTF-16 from the standard input" 3 '^invcal: standard input: this is UTF-16' calibrate -
in=/dev/null

bad_line "a gyroscope without an accelerometer" 'bad\.csv:1: the header names a gyroscope \(omega_x, ..\), but no accelerometer' \
    'timestamp,omega_x,omega_y,omega_z,w,alpha_x,alpha_y,alpha_z\n1,2,3,4,5,6,7,8\n'
bad_line "decimal commas between semicolons" \
    "bad\.csv:2: column 1 \(x\): '1,5' has a decimal comma: save with decimal points$" \
    'x;y;z\n1,5;2,5;3,5\n'
bad_line "decimal commas in quotes" "bad\.csv:2: column 2 \(y\): '-2,5' .* decimal comma: save with" \
    'x,y,z\n1,"-2,5",3\n'
bad_line "decimal commas that look like separators" \
    'bad\.csv:2: 6 columns, but line 1 has 3, .* if these are decimal commas, save the table with decimal points$' \
    'x,y,z\n1,5,2,5,3,5\n'
bad_line "the same, some numbers whole" 'bad\.csv:2: 4 columns, .* decimal points$' 'x,y,z\n1,5,2,3\n'
bad_line "the same without a header" \
    'bad\.csv:1: 6 columns, .* if these are decimal commas, save the table with decimal points$' \
    '0,05,2,5,3,5\n'
bad_line "decimal commas between tabs" "column 1 \(x\): '1,5' has a decimal comma" \
    'x\ty\tz\n1,5\t2,5\t3,5\n'
bad_line "decimal commas between tabs, without a header" "column 2 \(y\): '-2,5' .* decimal comma" \
    '1\t-2,5\t3,5\n'
bad_line "decimal commas between blanks" "bad\.csv:1: column 1 \(x\): '1,5' .* decimal comma" \
    '1,5 2,5 3,5\n'
bad_line "thousands separators" "column 1 \(x\): '1,234.5' has thousands separators: save without them$" \
    'x;y;z\n1,234.5;2;3\n'
bad_line "Swiss thousands separators" "column 2 \(y\): '1'234' .* thousands separators" \
    "x;y;z\n1;1'234;3\n"

bad "a gyro alone" 'record both in one log. .*invcal allan --columns gyroADC\[0\],gyroADC\[1\],gyroADC\[2\]$' \
    'time (us),gyroADC[0],gyroADC[1],gyroADC[2],wx,wy,wz,gx,gy,gz\n0,1,2,3,4,5,6,7,8,9\n'
bad "a header of as many names as there are readings, below text" \
    'bad\.csv:2: the header names no columns x, y, z .*there are: u, v, w$' 'MPU6050 found\nu,v,w\n1,2,3\n4,5,6\n'
bad "the same, separated by blanks" \
    'bad\.csv:2: the header names no columns x, y, z .*there are: u, v, w$' 'MPU6050 found\nu v w\n1 2 3\n4 5 6\n'
bad "a header of more names than readings" \
    'bad\.csv:1: the header names no columns x, y, z .*there are: u, v, w, q$' 'u,v,w,q\n1,2,3\n4,5,6\n'
bad "a header of unknown names and a line of units" \
    'bad\.csv:1: the header names no columns x, y, z .*there are: u, v, w$' 'u,v,w\nm,m,m\n1,2,3\n4,5,6\n'
bad "text only" 'bad\.csv:2: the header names no columns x, y, z .*there are: no, sensor$' 'MPU6050 found\nno sensor\n'
bad "two axes" 'bad\.csv:1: the header names no columns x, y, z .*such as --columns 2,3,4; there are: ax, ay, gz$' \
    'ax,ay,gz\n1,2,3\n'
bad "linear acceleration" \
    "bad\.csv:1: 'Linear Acceleration x': linear acceleration has gravity removed .* accelerometer itself$" \
    '"Time (s)","Linear Acceleration x (m/s^2)","Linear Acceleration y (m/s^2)","Linear Acceleration z (m/s^2)"\n0,1,2,3\n'
bad_line "phyphox with decimal commas" \
    "bad\.csv:2: column [12] \([tx]\): '1,01E[+-]01' has a decimal comma" \
    '"Time (s)";"Acceleration x (m/s^2)";"Acceleration y (m/s^2)";"Acceleration z (m/s^2)"\n1,01E-01;1,01E+01;2,0E-01;3\n'
bad "LabVIEW" 'bad\.csv: this is a LabVIEW measurement file: delete the lines before' \
    'LabVIEW Measurement\t\nWriter_Version\t2\t\n'
printf 't,x,y,z\n01.05.2026 10:00:00,1,2,3\n' > "$work/bad.csv"
refuses "a date in another form is not a time, and it says what to do" 3 \
    "column 1 \(t\): '01.05.2026 10:00:00' is not a decimal number: convert it to seconds, or ignore the column with --columns t=none$" \
    calibrate "$work/bad.csv"
run apply "$work/simple.json" "$work/bad.csv" --columns t=none
check "a column of time that is ignored" test "$(head -n 1 "$work/stdout")" = x,y,z
printf '0,1,2,3\nnoon,1,2,3\n' > "$work/bad.csv"
refuses "the same without a header" 3 'convert it to seconds, or ignore the column with --columns 2,3,4$' \
    calibrate "$work/bad.csv"
run apply "$work/simple.json" "$work/bad.csv" --columns 2,3,4
check "the same, ignored" test "$(head -n 1 "$work/stdout")" = x,y,z

# ---- text above the table -------------------------------------------------------------------------

write_dress 1 'MPU6050 found\nReady!' "t \",\" $ax"
run watch "$work/dress.csv" --json
check "watch: text above the readings, the same calibration" \
    near 0.05 "$(field offset)" "$plain_offset"
run apply "$work/simple.json" "$work/dress.csv"
check "apply: it says that text is ignored" says 'warning: .*dress\.csv: 2 lines of text before the readings ignored$'
check "apply: and corrects all readings" test "$(wc -l < "$work/stdout")" -eq "$(wc -l < "$work/plain.csv")"
printf 'MPU6050 found\n# ax ay az\n1 2 3\n' > "$work/dress.csv"
run apply "$work/simple.json" "$work/dress.csv"
check "apply: a header in a comment below the text" \
    says 'warning: .*dress\.csv: 1 line of text before the header ignored$'
printf 'hello\nt,x,y,z\n0,\017\n' > "$work/dress.csv"
run apply "$work/simple.json" "$work/dress.csv"
check "apply: if the line below the text is bad, that is all it says" \
    test "$(cat "$work/stderr")" = "invcal: $work/dress.csv:3: byte 3 of the line has the value 15: not a text file; export the readings as CSV"

for bytes in 'a,1,2\n' 'a,1,2\n# x y z\n'; do
    printf "$bytes" > "$work/dress.csv"
    refuses "apply: a line of text, and nothing else" 3 "dress\.csv:[12]: column 1 \(x\): 'a' is not a decimal number" \
        apply "$work/simple.json" "$work/dress.csv"
done

# ---- an unknown temperature -----------------------------------------------------------------------

# PX4 writes nan until a driver knows the temperature, others leave the cell empty: a column that is not needed
# must not cost the log.
write_dress 1 't,x,y,z,temperature' "t \",\" $ax \",\" (n < 50 ? \"nan\" : 35.5)"
mv "$work/dress.csv" "$work/nan.csv"
not_finite="temperature ignored: 'nan' in column 5 is not a finite number$"
run calibrate "$work/nan.csv" --json
check "nan: one warning that says where" says "warning: .*nan\.csv:2: $not_finite"
check "nan: the same calibration" test "$code $(field offset)" = "0 $plain_offset"
run calibrate "$work/nan.csv"
check "nan: the table has no temperature either" \
    matches "$work/stdout" 't \(s\), x y z in counts .*; ignored: 1 other column'
run calibrate "$work/nan.csv" --report "$work/nan.html"
check "nan: a page" is_page "$work/nan.html"
check "nan: it does not mention temperature" lacks "$work/nan.html" 'NaN|[ ",]nan[ ",]|and temperature'
write_dress 1 't,x,y,z,temperature' "t \",\" $ax \",\" (n < 5000 ? 35.5 : \"\")"
run calibrate "$work/dress.csv" --json
check "empty, in the middle of the log: one warning" \
    says 'warning: .*dress\.csv:5002: temperature ignored: column 5 is empty$'
check "empty: the same calibration" test "$code $(field offset)" = "0 $plain_offset"
run watch "$work/nan.csv" --json
check "watch: the same warning" matches "$work/stderr" "warning: .*nan\.csv:2: $not_finite"
check "watch: and the same calibration" test "$code $(field offset)" = "0 $plain_offset"
run allan "$work/nan.csv" --json
check "allan: the same warning" matches "$work/stderr" "warning: .*nan\.csv:2: $not_finite"
for option in "--thermal 1" "--columns temperature=5"; do
    # shellcheck disable=SC2086 # words
    refuses "nan with $option, which needs it" 3 \
        "nan\.csv:2: column 5 \(temperature\): 'nan' is not a finite number: correct the line, or ignore .*=none$" \
        calibrate "$work/nan.csv" $option
done
printf 'x,y,z,temp\n1,2,3,nan\n1,2,3,\n1,2,3,21\n' > "$work/cells.csv"
run apply "$work/simple.json" "$work/cells.csv"
check "apply: the cells are left empty, the others are copied" \
    test "$(cut -d , -f 4 "$work/stdout" | tr '\n' ' ')" = 'temperature   21 '
check "apply: one warning" \
    says "warning: .*cells\.csv:2: temperature left empty: 'nan' in column 4 is not a finite number$"
printf 'x,y,z,temp\n1,2,3,warm\n' > "$work/bad.csv"
run calibrate "$work/bad.csv"
check "a temperature that is a word is ignored, too" matches "$work/stderr" \
    "bad\.csv:2: temperature ignored: 'warm' in column 4 is not a decimal number$"
refuses "but refused where it is needed" 3 \
    "'warm' is not a decimal number: correct the line, or ignore the column with --columns temperature=none$" \
    calibrate "$work/bad.csv" --thermal 1
run apply "$work/simple.json" "$work/bad.csv" --columns temperature=none
check "a temperature that is ignored by an option" test "$(head -n 1 "$work/stdout")" = x,y,z

bad "two accelerometers" \
    "bad\.csv:1: x, y and z are there twice \('accSmooth\[0\]' and 'accADC\[0\]'\): choose one set with --columns, or delete" \
    'accSmooth[0],accSmooth[1],accSmooth[2],accADC[0],accADC[1],accADC[2]\n1,2,3,4,5,6\n'
bad "axes in different units" \
    "bad\.csv:1: 'ax \(g\)' and 'az \(mg\)' are in different units: convert one of them$" \
    'ax (g),ay (g),az (mg)\n1,2,3\n'
bad "one axis without a unit" "bad\.csv:1: 'ax \(g\)' and 'ay' are in different units" \
    'ax (g),ay,az (g)\n1,2,3\n'
bad "two clocks of one rank" "bad\.csv:1: more than one column could be 't': delete one, or choose with --columns t=NAME$" \
    't_ms,time (us),x,y,z\n1,2,3,4,5\n'
bad "settings, but no table" "bad\.csv:2: lines of two columns, the first one a name, are not a table" \
    'name,sensor 5\nrate,100\n'
printf 'TimeUS,I,GyrX,AccX,AccY,AccZ\n0,0,9,1,2,3\n0,1,9,1,2,3\n' > "$work/bad.csv"
turns='bad\.csv:3: column 2 \(I\): the rows of several sensors are interleaved: keep those of one$'
refuses "calibrate LOG: several sensors of ArduPilot in one table" 3 "$turns" calibrate "$work/bad.csv"
refuses "apply: several sensors of ArduPilot in one table" 3 "$turns" apply "$work/simple.json" "$work/bad.csv"
printf 'time,x,y,z\n0,1,2,3\n1000,1,2,3\n2000,1,2,3\n3000,1,2,3\n' > "$work/bad.csv"
refuses "calibrate LOG: times without a unit that are no seconds" 3 \
    'bad\.csv:2: the times advance by 1000, .* put the unit into the heading \(t_ms, t_us\), or state --rate$' \
    calibrate "$work/bad.csv"
for u in furlong '' m/s gauss mgal; do
    [ -z "$u" ] || refuses "--unit $u is refused by its name" 2 \
        "^invcal: --unit $u: must be g, mg, m/s2 or counts; see invcal calibrate --help\$" \
        calibrate "$work/plain.csv" --unit "$u"
done
refuses "--unit without a value" 2 '--unit: its value is missing' calibrate "$work/plain.csv" --unit

write_positions 1 'x (mg),y (mg),z (mg)' "$x"
refuses "a header that states another unit than that of the readings" 1 \
    'pos\.csv: the readings are 0\.0010[0-9]* times the field in the header.s unit, mg; check the header, or state --unit g$' \
    calibrate "$work/pos.csv" --positions
refuses "an option that states another unit" 1 'times the field in the stated unit, mg; check --unit: g$' \
    calibrate "$work/pos.csv" --positions --unit mg
run calibrate "$work/pos.csv" --positions --unit g --json
check "--unit corrects it" near 1e-9 "$(field offset)" '0.02 -0.03 0.05'

# A header is shown, but only its text reaches the terminal.
write_positions 1 'x\0177\0303\0274 (g),y (g),z (g)' "$x"
sed 's/^x/ax/; 1s/,y/,ay/; 1s/,z/,az/' "$work/pos.csv" > "$work/odd.csv"
in=$work/odd.csv
run calibrate - --positions
check "a control character in a heading is shown as ?" matches "$work/stdout" '; ax\?ü ay az in g$'
awk 'NR == 1 { for (i = 0; i < 300; i++) printf "w"; printf " (g)," } NR > 1 { printf "0," } { print }' "$work/pos.csv" > "$work/odd.csv"
run calibrate - --positions
in=/dev/null
check "a heading of 300 letters is ignored" matches "$work/stdout" 'ignored: 1 other column$'
printf 'x(,y),z[],((,)),[,]\n1,2,3,4,5,6,7\n' > "$work/bad.csv"
refuses "brackets that do not match do no harm" 3 "'x\(' and 'z\[\]' are in different units" calibrate "$work/bad.csv"

# ---- the manual's remedies for other logs -------------------------------------------------------

manual=$here/../../port/manual/tool.md
# remedied SENTENCE FILE OPTIONS: the manual's command for such a log, run in its folder, restores the plain log
remedied() {
    remedy=$(sed -n "/^| $1/s/[^\`]*[\`]\([^\`]*> [^\`]*\)[\`].*/\1/p" "$manual")
    check "$1: the manual has a command" test -n "$remedy"
    (cd "$work" && eval "$remedy") || complain
    shift
    file=$1
    shift
    run calibrate "$work/$file" "$@" --json
    check "$remedy: the same offset" near 0.2 "$(field offset)" "$plain_offset" # a gap moves the ends of rests
}
# log.csv from the plain log; HEADER and ROW as of write_dress
copy() { # HEADER ROW
    write_dress 1 "$1" "$2"
    cp "$work/dress.csv" "$work/log.csv"
}
copy 't;ax;ay;az' 't ";" x ";" y ";" z'
tr . , < "$work/dress.csv" > "$work/log.csv"
remedied "decimal commas" point.csv
copy 'Zeit [ms];Beschl. 1 [counts];Beschl. 2 [counts];Beschl. 3 [counts]\r' 't * 1000 ";" x ";" y ";" z "\r"'
run calibrate "$work/log.csv" --columns t=1,x=2,y=3,z=4 --json
check "headings in another language: the option in the manual" near 0.05 "$(field offset)" "$plain_offset"
copy 'Zeit;Beschl. 1;Beschl. 2;Beschl. 3;Drehrate 1;Drehrate 2;Drehrate 3\r' \
    't * 1000 ";" x ";" y ";" z ";" n % 2 ";0;0\r"'
remedied "the same, and a gyroscope" own.csv --accelerometer-only
copy 'time,ax,ay,az' '"24.11.2026 12:00:" t "," x "," y "," z'
options=$(sed -n '/^| times in another form/s/.*[`]\(--columns t=none\)[`].*[`]\(--rate 100\)[`].*/\1 \2/p' "$manual")
# shellcheck disable=SC2086 # words
run calibrate "$work/log.csv" ${options:-none} --json
check "times in another form: the options in the manual" near 0.2 "$(field offset)" "$plain_offset"
copy '' '"X: " x "\tY: [" y "] Z: " z'
cp "$work/dress.csv" "$work/log.txt"
remedied "words or brackets around" log.csv
copy 't,ax,ay,az' 't "," (n < 16 ? "nan,NaN,nan" : x "," y "," z)'
refuses "rows of nan are refused" 3 "log\.csv:2: column 2 \(x\): 'nan' is not a finite number" calibrate "$work/log.csv"
remedied "rows of nan" clean.csv
copy 't,ax,ay,az' 't "," x "," y "," z'
tr '\n' '\r' < "$work/dress.csv" > "$work/log.csv"
remedied "lines that end with CR alone" lines.csv
# cut in a move, from 61 s to 63 s
head -n 6200 "$work/plain.csv" > "$work/one.csv"
sed -n '1p; 6201,$p' "$work/plain.csv" | awk -F, -v OFS=, 'NR > 1 { $1 -= 55 } { print }' > "$work/two.csv"
remedied "its positions in two files" both.csv

finish
