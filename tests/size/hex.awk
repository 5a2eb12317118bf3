# SPDX-License-Identifier: MIT
#
# A hexadecimal number, with or without 0x; awk itself reads decimal ones only.
function hex(text,    i, value) {
    text = tolower(text)
    sub(/^0x/, "", text)
    for (i = 1; i <= length(text); i++) {
        value = value * 16 + index("0123456789abcdef", substr(text, i, 1)) - 1
    }
    return value
}
