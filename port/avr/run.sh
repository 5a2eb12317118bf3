#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs an image in simavr:  sh port/avr/run.sh MCU IMAGE
# simavr colours only what comes from the UART, and shows the end of a line as a dot before it. It
# does not return the program's exit status: the last line has to be OK. After a crash it would wait for a
# debugger, hence the time limit, which allows for a busy machine.
escape=$(printf '\033')
timeout 550 simavr -m "$1" -f 16000000 "$2" 2>&1 |
    sed -n "s/^\(${escape}\[0m\)*${escape}\[32m\(.*\)\.\$/\2/p" |
    awk '{ print; fflush(); last = $0 } END { exit last != "OK" }'
