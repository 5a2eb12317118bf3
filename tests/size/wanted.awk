# SPDX-License-Identifier: MIT
#
# The linker options that keep the functions named in wanted, "%" for all. A name may end in a build's
# choices: invcal_apply_double_0, invcal_session_init_double_0_max_positions_24.
BEGIN {
    split(wanted, names, " ")
    for (i in names) is_wanted[plain(names[i])]
}
function plain(name) {
    sub(/_double_[01](_.*)?$/, "", name)
    return name
}
{
    if (wanted == "%" || plain($2) in is_wanted) print "-Wl,--require-defined=" $2
}
