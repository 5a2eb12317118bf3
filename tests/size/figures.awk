# SPDX-License-Identifier: MIT
#
# From what was measured to what has a budget: "figure bytes".
# Usage: awk -f figures.awk MEASURED, which holds lines
#     kind.ROOM bytes                 by rooms.awk
#     own PROGRAM kind bytes          the library's part of a linked program
#     sizeof.STRUCTURE bytes
#     stack ...                       by stack.awk
$1 ~ /^(text|rodata)\./ {
    room = $1
    sub(/.*\./, "", room)
    if (!(room in flash)) rooms[++n] = room
    flash[room] += $2
    all += $2
}
$1 ~ /^data\./ { data += $2 }
$1 ~ /^bss\./ { bss += $2 }
$1 == "own" { own[$2, $3] = $4 }
$1 ~ /^sizeof\./ { size[$1] = $2; structure[++structures] = $1 }
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
END {
    print "flash", all
    print "data", data + 0
    print "bss", bss + 0
    print "text.core", own["core", "text"]
    print "text.everything", own["everything", "text"]
    print "rodata.core", own["core", "rodata"] + 0
    print "rodata.everything", own["everything", "rodata"] + 0
    # What must be there while a calibration is computed: the state, the result, the stack.
    print "memory.core", size["sizeof.invcal_normal"] + size["sizeof.invcal_solution"] + \
        most("observation_reading observation_exact normal_init normal_add solve apply")
    print "memory.session", size["sizeof.invcal_session"] + most("session_feed session_next session_solve")
    print "callers", calling + 0
    for (i = 1; i <= structures; i++) print structure[i], size[structure[i]]
    for (i = 1; i <= n; i++) print "flash." rooms[i], flash[rooms[i]]
    for (i = 1; i <= n; i++) if (rooms[i] in deepest) print "stack." rooms[i], deepest[rooms[i]] + 0
}
