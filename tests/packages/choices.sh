#!/bin/sh
# SPDX-License-Identifier: MIT
# shellcheck disable=SC2154 # package.sh sets what is not set here
#
# A program and a library that were compiled with different choices have different structures, so they must
# not link. Tries each function with which the use of a structure begins.
. "$(dirname "$0")/../package.sh"
need cc

# links FUNCTION LIBRARY FLAG...: a program that calls it
links() {
    function=$1
    library=$2
    shift 2
    printf '#include "invcal/%s.h"\n' allan expert frame gyro magnetometer plan store thermal > "$out/$function.c"
    # The linker needs only its address, and that takes no arguments.
    echo "void (*volatile f)(void) = (void (*)(void))$function; int main(void) { return f == 0; }" \
        >> "$out/$function.c"
    cc -std=c99 -O2 -Iinclude "$@" "$out/$function.c" "$library" -lm -o "$out/program"
}

# The linker, not the compiler, refuses it, and names the function and the option.
refuses() { # FUNCTION LIBRARY [FLAG]
    option=$(echo "${3:--DINVCAL_DOUBLE}" | sed 's/-DINVCAL_//; s/=.*//' | tr '[:upper:]' '[:lower:]')
    ! links "$@" > "$out/said" 2>&1 && grep -q "undefined reference to .$1_.*${option}_" "$out/said"
}

for function in invcal_apply invcal_nominal invcal_load invcal_record_init \
    invcal_record_decode invcal_plan_position_at invcal_imu_record_init invcal_imu_record_decode \
    invcal_load_imu invcal_turns_begin invcal_sums_init invcal_linear_init invcal_full_vector_init \
    invcal_frame_init invcal_magnetometer_init invcal_dip_init; do
    check "$function links as the library was compiled" links $function "$build/float/libinvcal.a"
    check "$function: not from double to float" refuses $function "$build/float/libinvcal.a" -DINVCAL_DOUBLE=1
    check "$function: not from float to double" refuses $function "$build/double/libinvcal.a"
done
for function in invcal_calibrate invcal_calibrate_judged invcal_session_init invcal_session_begin \
    invcal_load_session invcal_session_resume invcal_calibrate_without invcal_calibrate_robust \
    invcal_calibrate_with_prior invcal_calibrate_six_faces invcal_background_init; do
    check "$function links as the library was compiled" links $function "$build/float/libinvcal.a"
    check "$function: not from double to float" refuses $function "$build/float/libinvcal.a" -DINVCAL_DOUBLE=1
    check "$function: not with fewer positions" refuses $function "$build/float/libinvcal.a" \
        -DINVCAL_MAX_POSITIONS=12
    check "$function: not with more positions" refuses $function "$build/float/libinvcal.a" \
        -DINVCAL_MAX_POSITIONS=64
done
for function in invcal_thermal_at invcal_thermal_calibrate invcal_thermal_start invcal_thermal_fit \
    invcal_thermal_judge invcal_thermal_record_decode; do
    check "$function links as the library was compiled" links $function "$build/float/libinvcal.a"
    for choice in THERMAL_DEGREE=2 MAX_POSITIONS=64 DOUBLE=1; do
        check "$function: not with $choice" refuses $function "$build/float/libinvcal.a" -DINVCAL_$choice
    done
done
for function in invcal_moves_init invcal_imu_solve invcal_turns_after invcal_imu_session_resume invcal_load_imu_session; do
    check "$function links as the library was compiled" links $function "$build/float/libinvcal.a"
    for choice in MAX_SEGMENTS=100 MAX_MOVES=14 DOUBLE=1; do
        check "$function: not with $choice" refuses $function "$build/float/libinvcal.a" -DINVCAL_$choice
    done
done
for function in invcal_imu_session_resume invcal_load_imu_session; do
    check "$function: not with more positions" refuses $function "$build/float/libinvcal.a" \
        -DINVCAL_MAX_POSITIONS=64
done
check "invcal_allan_init links as the library was compiled" links invcal_allan_init \
    "$build/float/libinvcal.a"
for choice in ALLAN_TAUS=31 ALLAN_OVERLAP=16 DOUBLE=1; do
    check "invcal_allan_init: not with $choice" refuses invcal_allan_init "$build/float/libinvcal.a" \
        -DINVCAL_$choice
done
finish
