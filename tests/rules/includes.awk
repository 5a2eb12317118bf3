# SPDX-License-Identifier: MIT
#
# The includes of the library and of the tool: awk -f includes.awk folders.txt src/*/*.[ch] port/host/*/*.[ch]
#
# A file includes headers of its own folder or of those before it in folders.txt, and includes within
# a folder form no cycle. A file is its .c and its .h together. The tool includes what port/host does not
# have from src, all of which comes before it.
FNR == 1 && FILENAME ~ /folders[.]txt$/ { reading = 1 }
FNR == 1 && FILENAME !~ /folders[.]txt$/ {
    reading = 0
    folder = tree = FILENAME
    sub(/\/[^\/]*$/, "", folder)
    sub(/\/[^\/]*\/[^\/]*$/, "", tree)
    module = FILENAME
    sub(/[.][ch]$/, "", module)
    if (!(folder in place)) {
        print FILENAME ": its folder is not in folders.txt"
    }
    modules[module] = folder
    base = module
    sub(/.*\//, "", base)
    if (tree == "src" && base in path_of && path_of[base] != module) {
        print FILENAME ": has the name of " path_of[base] ", but objects of a static library have no folder"
    }
    path_of[base] = module
}
reading && !/^#/ && NF > 0 {
    place[$1] = ++places
}
function exists(path,    line, is_there) {
    is_there = (getline line < path) >= 0
    close(path)
    return is_there
}
# "../core/vector.h" in src, "text/figure.h" in port/host, "fit.h" of the same folder.
!reading && /^#include "/ && !/^#include "invcal\// {
    split($2, quoted, "\"")
    to = quoted[2]
    sub(/^[.][.]\//, "", to)
    sub(/[.]h$/, "", to)
    if (tree == "port/host" && to ~ /\// && !exists(tree "/" to ".h") && exists("src/" to ".h")) {
        next
    }
    to = (to ~ /\// ? tree : folder) "/" to
    to_folder = to
    sub(/\/[^\/]*$/, "", to_folder)
    if (to == module) {
        next
    }
    if (!(to_folder in place) || place[to_folder] > place[folder]) {
        print FILENAME ":" FNR ": " folder " comes before " to_folder " in folders.txt"
    } else if (to_folder == folder) {
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
