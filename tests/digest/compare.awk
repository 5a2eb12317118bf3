# SPDX-License-Identifier: MIT
#
# awk -f tests/digest/compare.awk HOST LOG...
# Is the digest of a build the host's? It may be in several logs, of a part each. Prints `same`; or the
# first line that differs, or what is missing, and exits with 1.

function differs(text) {
    if (difference == "") difference = text
}

function where() {
    return part (set == "" ? "" : ", " set)
}

function leave_part() {
    part = set = ""
}

# A part that has begun must have come to its end.
function finish() {
    if (part != "") differs(where() ": nothing after " last)
    leave_part()
}

FNR == 1 { finish(); is_host = FILENAME == ARGV[1] }
/^FAIL/ { differs($0) } # by the board: its stack
$1 == "part" { finish(); part = $2; at = 0 }
part == "" { next }
$1 == "set" { set = substr($0, 5) }
{ at++; last = $0 }
is_host {
    host[part, at] = $0
    if ($1 == "crc") { name[++parts] = part; leave_part() }
    next
}
$0 != host[part, at] {
    differs(where() ": " $0 ", on the host " host[part, at])
    exit # to END
}
$1 == "crc" { done[part]; leave_part() }

END {
    finish()
    if (parts == 0) differs("the host has no digest")
    for (i = 1; i <= parts; i++) if (!(name[i] in done)) differs(name[i] ": it is missing")
    if (difference == "") difference = "same"
    print difference
    exit difference != "same"
}
