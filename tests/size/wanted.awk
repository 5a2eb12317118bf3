# SPDX-License-Identifier: MIT
#
# The linker options that keep the functions named in wanted, "%" for all. A name may end in a build's
# choices: invcal_apply_float_9, invcal_allan_init_float_16_4.
BEGIN {
    split(wanted, names, " ")
    for (i in names) is_wanted[plain(names[i])]
}
function plain(name) {
    sub(/_(float|double)_[0-9_]+$/, "", name)
    return name
}
{
    if (wanted == "%" || plain($2) in is_wanted) print "-Wl,--require-defined=" $2
}
