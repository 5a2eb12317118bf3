# SPDX-License-Identifier: MIT
#
# A hexadecimal number, with or without 0x; awk itself reads decimal ones only. Of an address the
# first of eight digits is left out, which tells memories apart: some awks print no more than 2^31.
function hex(text,    i, value) {
    text = tolower(text)
    sub(/^0x/, "", text)
    for (i = 1; i <= length(text); i++) {
        value = value * 16 + index("0123456789abcdef", substr(text, i, 1)) - 1
    }
    return value % 268435456
}
