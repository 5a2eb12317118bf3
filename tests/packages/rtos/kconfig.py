# SPDX-License-Identifier: MIT
#
# kconfig.py KCONFIG set [NAME=VALUE...]       the configuration, as CMake sees it: set(CONFIG_NAME VALUE)
# kconfig.py KCONFIG options [NAME=VALUE...]   a line for each option of INVCAL_: NAME LEAST MOST DEFAULT
# Any warning of Kconfig (out of range, no such option) is an error: one line, exit status 1.
import sys

import kconfiglib


def number(symbol):
    return symbol.str_value.replace("y", "1").replace("n", "0")


def main(path, command, *assignments):
    kconfig = kconfiglib.Kconfig(path, warn_to_stderr=False)
    for assignment in assignments:
        name, value = assignment.split("=")
        if name not in kconfig.syms or not kconfig.syms[name].nodes:
            sys.exit(f"{path}: no option {name}")
        symbol = kconfig.syms[name]
        symbol.set_value(value)
        if symbol.str_value != value:
            sys.exit(f"{path}: {name} cannot be {value}")
    if kconfig.warnings:
        sys.exit(kconfig.warnings[0])
    for symbol in kconfig.unique_defined_syms:
        if command == "set" and symbol.str_value not in ("", "n"):
            print(f"set(CONFIG_{symbol.name} {symbol.str_value})")
        if command == "options" and symbol.name.startswith("INVCAL_"):
            least, most = [low_high.str_value for low_high in symbol.ranges[0][:2]] \
                if symbol.ranges else ("0", "1")
            print(symbol.name, least, most, number(symbol))


main(*sys.argv[1:])
