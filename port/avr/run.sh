#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs an image in simavr:  sh port/avr/run.sh MCU IMAGE
# simavr colours what comes from the UART, and shows the end of a line as a dot before it; nothing
# else that it prints is coloured. It has no exit status of the program: the last line tells it.
# After a crash it would wait for a debugger, hence the time limit, for a machine that does more.
escape=$(printf '\033')
timeout 550 simavr -m "$1" -f 16000000 "$2" 2>&1 |
    sed -n "s/^\(${escape}\[0m\)*${escape}\[32m\(.*\)\.\$/\2/p" |
    awk '{ print; fflush(); last = $0 } END { exit last != "OK" }'
