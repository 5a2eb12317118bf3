# SPDX-License-Identifier: MIT
#
# "text.ROOM bytes", and rodata, data, bss: the rooms' object files by `size -A`.
/^[^ ]+\.o  *:$/ {
    room = $1
    sub(/.*\//, "", room)
    sub(/\.o$/, "", room)
    rooms[++n] = room
    next
}
NF != 3 || $2 !~ /^[0-9]+$/ || $2 == 0 { next }
$1 ~ /^\.text/ { bytes["text", room] += $2; next }
$1 ~ /^\.(s?rodata|got2)/ { bytes["rodata", room] += $2; next }
$1 ~ /^\.s?data/ { bytes["data", room] += $2; next }
$1 ~ /^\.s?bss/ { bytes["bss", room] += $2; next }
$1 !~ /^\.(comment|note|debug|eh_frame|stack|gnu|ARM\.attributes|riscv\.attributes)/ {
    print "fault", room " has a section of an unknown kind, " $1
}
END {
    m = split("text rodata data bss", kind, " ")
    for (i = 1; i <= n; i++) for (k = 1; k <= m; k++) print kind[k] "." rooms[i], bytes[kind[k], rooms[i]] + 0
}
