# SPDX-License-Identifier: MIT
#
# Computes the figures that have a budget from what was measured: "figure bytes".
# Usage: awk -v level=Os -f figures.awk MEASURED, which holds lines
#     kind.MODULE bytes               by modules.awk
#     linked.PROGRAM bytes            of a linked program, all libraries included
#     own PROGRAM kind bytes          the library's part of it
#     static.program, frame.main      of the program of README.md
#     called FUNCTION                 by it
#     sizeof.STRUCTURE bytes
#     stack ...                       by stack.awk
# At another level than Os only the programs have figures, with "-level" at the end of the name.
$1 ~ /^(text|rodata)\./ {
    module = $1
    sub(/.*\./, "", module)
    if (!(module in flash)) modules[++n] = module
    flash[module] += $2
    all += $2
}
$1 ~ /^data\./ { data += $2 }
$1 ~ /^bss\./ { bss += $2 }
$1 ~ /^(sizeof|linked)\./ { size[$1] = $2; structure[++structures] = $1 }
$1 == "own" && $2 == "core" { own += $4 }
$1 == "static.program" || $1 == "frame.main" { program += $2 }
$1 == "called" { called = called " " substr($2, 8) }
$1 == "stack" {
    if ($4 > deepest[$2]) deepest[$2] = $4
    stack[$3] = $4
    calling += $5
}
function most(list,    name, i, count, found) {
    count = split(list, name, " ")
    for (i = 1; i <= count; i++) if (stack["invcal_" name[i]] > found) found = stack["invcal_" name[i]]
    return found
}
function figure(name, bytes) { print name (level == "Os" ? "" : "-" level), bytes }
END {
    if (level == "Os") {
        print "flash", all
        print "data", data + 0
        print "bss", bss + 0
        print "flash.gyro", size["linked.imu"] - size["linked.product"]
    }
    figure("own.core", own)
    figure("flash.core", size["linked.core"])
    figure("flash.judged", size["linked.judged"])
    figure("flash.product", size["linked.product"])
    figure("flash.program", size["linked.program"])
    # What is needed while a calibration is computed: the state, the result, the stack.
    figure("memory.core", size["sizeof.invcal_sums"] + size["sizeof.invcal_calibration"] + \
        most("sums_init sums_add solve apply"))
    figure("memory.session", size["sizeof.invcal_session"] + \
        most("session_feed session_next session_is_good session_solve"))
    figure("memory.program", program + most(called))
    if (level != "Os") exit
    print "callers", calling + 0
    for (i = 1; i <= structures; i++) if (structure[i] ~ /^sizeof/) print structure[i], size[structure[i]]
    for (i = 1; i <= n; i++) print "module." modules[i], flash[modules[i]]
    for (i = 1; i <= n; i++) if (modules[i] in deepest) print "stack." modules[i], deepest[modules[i]] + 0
}
