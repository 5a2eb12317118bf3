# SPDX-License-Identifier: MIT
#
# What a linker kept, from its map: "section address size file", of .text and .rodata.
# Usage: awk -f hex.awk -f sections.awk program.map
/^Linker script and memory map/ { kept = 1 }
!kept { next }

# A long name has a line of its own.
/^ \.(text|rodata)[^ ]*$/ {
    name = $1
    next
}
/^ \.(text|rodata)[^ ]* +0x/ {
    name = $1
    $0 = " " $2 " " $3 " " $4
}
name != "" && $1 ~ /^0x/ && $2 ~ /^0x/ && hex($2) > 0 { print name, hex($1), hex($2), $3 }
{ name = "" }
