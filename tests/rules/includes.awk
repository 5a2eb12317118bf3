# SPDX-License-Identifier: MIT
#
# The tool's includes: awk -f includes.awk folders.txt port/host/*/*.[ch]
#
# A file includes headers of its own folder or of those before it in folders.txt, and includes within
# a folder form no cycle. A file is its .c and its .h together.
FNR == 1 && FILENAME ~ /folders[.]txt$/ { reading = 1 }
FNR == 1 && FILENAME !~ /folders[.]txt$/ {
    reading = 0
    n = split(FILENAME, names, "/")
    folder = names[n - 1]
    module = folder "/" names[n]
    sub(/[.][ch]$/, "", module)
    if (!(folder in place)) {
        print FILENAME ": its folder is not in folders.txt"
    }
    modules[module] = folder
}
reading && !/^#/ && NF > 0 {
    place[$1] = ++places
}
!reading && /^#include "[a-z_]+\/[a-z_0-9]+[.]h"/ {
    split($2, quoted, "\"")
    to = quoted[2]
    sub(/[.]h$/, "", to)
    split(to, parts, "/")
    if (parts[1] == "invcal" || to == module) {
        next
    }
    if (place[parts[1]] > place[folder]) {
        print FILENAME ":" FNR ": " folder " comes before " parts[1] " in folders.txt"
    } else if (parts[1] == folder) {
        includes[module, ++count[module]] = to
    }
}
# state: 1 while a file is being visited, 2 once all that it includes has been.
function visit(module, path,    i, to) {
    state[module] = 1
    for (i = 1; i <= count[module]; i++) {
        to = includes[module, i]
        if (state[to] == 1) {
            print "a cycle: " path " > " to
        } else if (!state[to]) {
            visit(to, path " > " to)
        }
    }
    state[module] = 2
}
END {
    for (module in modules) {
        if (!state[module]) {
            visit(module, module)
        }
    }
}
