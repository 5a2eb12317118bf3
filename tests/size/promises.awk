# SPDX-License-Identifier: MIT
#
# awk -f promises.awk PAIRS FIGURES MEASURED HEADER...
# What the headers say of each function's stack and instructions ("Stack: about N bytes", "Cost: N instructions"),
# against what `make size` and `make bench` have measured on the Cortex-M4F: to 10 % or 10 bytes. PAIRS: function and
# its figure of FIGURES. Prints each that differs; ends with `N passed, N failed`.

function plain(name) { # without the build options
    sub(/_(float|double)(_[0-9]+)+$/, "", name)
    return name
}

function number_after(words, pattern) { # -1: none
    if (!match(words, pattern " [0-9,]+")) return -1
    words = substr(words, RSTART, RLENGTH)
    gsub(/.* |,/, "", words)
    return words + 0
}

function check(name, what, promised, measured) {
    if (measured == "") {
        print name ": " what " promised, but not measured"
        failed++
    } else if (promised - measured <= (measured > 100 ? measured / 10 : 10) &&
               measured - promised <= (measured > 100 ? measured / 10 : 10)) {
        passed++
    } else {
        print name ": " what ": the header says " promised ", measured: " measured
        failed++
    }
}

FNR == 1 { file++; text = ""; is_open = 0 }
file == 1 { figure_of[$1] = $2; next }
file == 2 { figure[$1] = $2; next }
file == 3 { if ($1 == "stack") stack[plain($3)] = $4; next }

/^\/\*/ { text = ""; is_open = 1 }
is_open { line = $0; sub(/^ \*/, "", line); text = text " " line; is_open = !/\*\//; next }
/^[a-z].* \*?invcal_[a-z0-9_]+\(/ && text != "" {
    match($0, /invcal_[a-z0-9_]+\(/)
    name = substr($0, RSTART, RLENGTH - 1)
    gsub(/ +/, " ", text)
    bytes = number_after(text, "Stack: (about|up to)")
    if (bytes >= 0) check(name, "stack", bytes, stack[name])
    if (name in figure_of) check(name, "instructions", number_after(text, "Cost:( up to)?"), figure[figure_of[name]])
    seen[name] = 1
}
!/^[ \t]/ { text = "" }

END {
    for (name in figure_of) if (!(name in seen)) {
        print name ": not in the headers"
        failed++
    }
    print passed + 0 " passed, " failed + 0 " failed"
    exit failed > 0 || passed == 0
}
