# SPDX-License-Identifier: MIT
#
# The linker options that keep the functions named in wanted, "%" for all.
BEGIN {
    split(wanted, names, " ")
    for (i in names) is_wanted[names[i]]
}
{
    if (wanted == "%" || $2 in is_wanted) print "-Wl,--require-defined=" $2
}
