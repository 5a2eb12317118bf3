# SPDX-License-Identifier: MIT
#
# "text.MODULE bytes", and rodata, data, bss, from `size -A` of the modules' object files.
/^[^ ]+\.o  *:$/ {
    module = $1
    sub(/.*\//, "", module)
    sub(/\.o$/, "", module)
    modules[++n] = module
    next
}
NF != 3 || $2 !~ /^[0-9]+$/ || $2 == 0 { next }
$1 ~ /^\.(text|progmem)/ { bytes["text", module] += $2; next }
$1 ~ /^\.(s?rodata|got2)/ { bytes["rodata", module] += $2; next }
$1 ~ /^\.s?data/ { bytes["data", module] += $2; next }
$1 ~ /^\.s?bss/ { bytes["bss", module] += $2; next }
$1 !~ /^\.(comment|note|debug|eh_frame|stack|gnu|ARM\.attributes|riscv\.attributes)/ {
    print "fault", module " has a section of an unknown kind, " $1
}
END {
    m = split("text rodata data bss", kind, " ")
    for (i = 1; i <= n; i++) for (k = 1; k <= m; k++) print kind[k] "." modules[i], bytes[kind[k], modules[i]] + 0
}
