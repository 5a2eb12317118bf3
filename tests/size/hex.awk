# SPDX-License-Identifier: MIT
#
# A hexadecimal number, with or without 0x; awk itself reads only decimal ones. Drops the first of an
# address's eight digits, which only distinguishes memories: some awks print no more than 2^31.
function hex(text,    i, value) {
    text = tolower(text)
    sub(/^0x/, "", text)
    for (i = 1; i <= length(text); i++) {
        value = value * 16 + index("0123456789abcdef", substr(text, i, 1)) - 1
    }
    return value % 268435456
}
