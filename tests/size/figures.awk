# SPDX-License-Identifier: MIT
#
# Computes the figures that have a budget from what was measured: "figure bytes".
# Usage: awk -f figures.awk MEASURED, which holds lines
#     kind.MODULE bytes               by modules.awk
#     linked.PROGRAM bytes            of a linked program, all libraries included
#     sizeof.STRUCTURE bytes
#     stack ...                       by stack.awk
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
$1 == "stack" {
    if ($4 > deepest[$2]) deepest[$2] = $4
    plain = $3
    sub(/_(float|double)_[0-9]+$/, "", plain)
    stack[plain] = $4
    calling += $5
}
function most(list,    name, i, count, found) {
    count = split(list, name, " ")
    for (i = 1; i <= count; i++) if (stack["invcal_" name[i]] > found) found = stack["invcal_" name[i]]
    return found
}
END {
    print "flash", all
    print "data", data + 0
    print "bss", bss + 0
    print "flash.core", size["linked.core"]
    print "flash.judged", size["linked.judged"]
    print "flash.product", size["linked.product"]
    print "flash.gyro", size["linked.imu"] - size["linked.product"]
    # What is needed while a calibration is computed: the state, the result, the stack.
    print "memory.core", size["sizeof.invcal_sums"] + size["sizeof.invcal_calibration"] + \
        most("sums_init sums_add solve apply")
    print "memory.session", size["sizeof.invcal_session"] + \
        most("session_feed session_next session_is_good session_solve")
    print "callers", calling + 0
    for (i = 1; i <= structures; i++) if (structure[i] ~ /^sizeof/) print structure[i], size[structure[i]]
    for (i = 1; i <= n; i++) print "module." modules[i], flash[modules[i]]
    for (i = 1; i <= n; i++) if (modules[i] in deepest) print "stack." modules[i], deepest[modules[i]] + 0
}
