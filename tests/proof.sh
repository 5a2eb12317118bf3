#!/bin/sh
# SPDX-License-Identifier: MIT
#
# sh tests/proof.sh BUILD [MODULE...]
# Proves that the modules of src/, or those named, have no undefined behaviour, by Frama-C/Eva from the
# entry points tests/proof/MODULE.c, whose inputs are arbitrary. A module passes if there is no alarm
# and no warning that would make the analysis unsound, and if every statement of every function of the
# module is reached: what is not reached is not proved. Prints a line for each proof, and at the end
# `N passed, N failed`. DOUBLE=1: with invcal_real double; INT16=1: with an int of 16 bits, as on
# AVR. BRIEF=1: each in one configuration. JOBS=N: N at a time.
#
# Lines in tests/proof/MODULE.c:
#     // eva: OPTIONS           options of Eva for it
#     // config: -DX=1 ...      proved again in this configuration
#     // wide: -DX=1 ...        the same, unless int has 16 bits, where it does not fit
#     // trusted: N             exactly N ACSL annotations that it meets are taken for granted by Eva, not
#                               proved. Why they hold is said after them, in their own module
#     // stubs: MODULE ...      the file itself defines their functions, with any behaviour that the
#                               headers allow; their own proofs cover the real ones
#     // dead: FUNCTION N ...   N of its statements are reached by no input; why follows
# With -DX=1 after the colon, trusted and dead apply to that configuration, in place of those without.
cd "$(dirname "$0")/.." || exit 1

# The sources that a module needs: those that define what is named in its code, in a header, or in
# the code of a source that it needs.
sources() { # MODULE
    awk -v module="$1" -v stubs="$(options stubs "$1")" '
        FNR == 1 {
            base = FILENAME
            sub(/.*\//, "", base)
            is_header = base ~ /h$/
            if (is_header) defined_in[base] = FILENAME
            if (FILENAME ~ /^src\//) file_of[base] = FILENAME
        }
        split($0, part, "\"") == 3 && /^#include/ {
            sub(/.*\//, "", part[2])
            names[FILENAME, ++count[FILENAME]] = part[2]
        }
        /^ \*|^\/\*/ || (is_header && !/^ |^#define/) { next }
        {
            gsub(/\/\*.*/, "")
            begins = /^[A-Za-z]/
            while (match($0, /invcali?_[a-z_0-9]+/)) {
                name = substr($0, RSTART, RLENGTH)
                $0 = substr($0, RSTART + RLENGTH)
                if (begins && /^\(/) defined_in[name] = FILENAME
                else names[FILENAME, ++count[FILENAME]] = name
            }
        }
        function visit(file,    i) {
            if (file in seen) return
            seen[file] = 1
            if (file ~ /^src\/.*c$/) print file
            for (i = 1; i <= count[file]; i++)
                if (names[file, i] in defined_in) visit(defined_in[names[file, i]])
        }
        END {
            count_stubs = split(stubs, stub, " ")
            for (i = 1; i <= count_stubs; i++) seen[file_of[stub[i] ".c"]] = 1
            visit(file_of[module ".c"])
            visit("tests/proof/" module ".c")
        }
    ' "tests/proof/$1.c" tests/proof/*.h include/invcal/[!d]*.h src/*/*.c src/*/[!n]*.h src/allan/noise.h
}

options() { # KEY MODULE: what follows the key in the module's file
    sed -n "s|^// $1: *||p" "tests/proof/$2.c"
}

analyse() { # MODULE MACROS
    # shellcheck disable=SC2046 # options and files are words
    frama-c -machdep "gcc_x86_$([ "$INT16" ] && echo 16 || echo 32)" \
        -cpp-extra-args="-Iinclude -Isrc -Itests/proof $2" \
        -kernel-warn-key parser:decimal-float=inactive,annot-error=abort \
        -warn-special-float none -warn-invalid-pointer -warn-right-shift-negative \
        -unspecified-access -eva -eva-precision 3 -eva-no-show-progress \
        -eva-msg-key=-initial-state,-final-states $(options eva "$1") \
        -metrics -metrics-by-function -metrics-eva-cover \
        "tests/proof/$1.c" $(sources "$1")
}

# Reads the log of an analysis; prints why it is not a proof, if it is not, and what it takes on trust.
judge() { # MODULE LOG MACROS
    { options trusted "$1" | sed 's/^/trusted /'; options dead "$1" | sed 's/^/dead /'; cat "$2"; } |
        awk -v module="$1" -v macros=" $3 " '
        $1 == "trusted" || $1 == "dead" {
            i = $2 ~ /^-D/ ? 3 : 2
            if (i == 3 && !index(macros, " " $2 " ")) next
            if ($1 == "trusted") allowed = $i
            else for (; $(i + 1) ~ /^[0-9]+$/; i += 2) dead[$i] = $(i + 1)
            next
        }
        # What follows the heading of an alarm, on its line or the next, says whether it is an
        # annotation that is not proved.
        /^\[eva:alarm\]/ { heading = $0 }
        heading != "" && (/ got status / || $0 != heading) {
            # invalid: in one of the states that Eva keeps apart, which no execution reaches
            if (/(assertion|invariant) got status (unknown|invalid)/) {
                split(heading, at, /[] :]+/)
                if (!trust[at[3] ":" at[4]]++) {
                    trusted++
                    for (n = 1; (getline line < at[3]) > 0; n++) if (n == at[4]) text = line
                    close(at[3])
                    sub(/^ */, "", text)
                    print "  on trust: " at[3] ":" at[4] ": " text
                }
            } else {
                if (shown <= 0 && $0 != heading) print "  " heading
                alarms++
                shown = 3
            }
            heading = ""
        }
        / alarms? generated by the analysis/ && $1 > 0 { alarms++ }
        /^ +Preconditions/ && $4 + $6 > 0 { alarms++ }
        /User Error|[Ff]ailure|aborted|: +[1-9][0-9]* errors? / { errors++; shown = 3 }
        /Warning:/ && !/^\[eva:alarm\]/ { warning = $0; next }
        warning != "" {
            if (!/Unspecified sequence with side effect/) { errors++; print "  " warning; shown = 3 }
            warning = ""
        }
        # Frama-C specifies libc; the behaviour of anything else without a body would be a guess
        /using specification for function/ &&
            !/function (Frama_C_[a-z_]+|(sqrt|sin|cos|fabs)f?|mem(cpy|set|cmp)|__builtin_clz)$/ { errors++; shown = 1 }
        /Stats for function </ {
            split($0, part, /[<>]/); n = split(part[2], path, "/")
            name = path[n]
            # of the copies of an inline function, one is enough
            if (path[n - 1] == module ".h") sub(/_[0-9]+$/, "", name)
            if (path[n - 1] ~ "^" module "[.][ch]$" && !(name in mine)) { mine[name] = 1; functions++ }
        }
        / stmts out of / {
            name = substr($1, 1, length($1) - 1)
            reached[name] = $6 - $2
            if (sub(/_[0-9]+$/, "", name) && !(name in reached && reached[name] < $6 - $2)) reached[name] = $6 - $2
            all += $2
        }
        shown-- > 0 { print "  " $0 }
        /^  100% of the logical|^  No logical properties|^    Assertions / { finished = 1 }
        END {
            for (f in mine)
                if (!(f in reached)) { print "  not reached: " f; errors++ }
                else if (reached[f] != dead[f] + 0) {
                    print "  " reached[f] " statements not reached: " f; errors++
                }
            if (trusted + 0 != allowed + 0) { print "  on trust: " trusted + 0 ", stated: " allowed + 0; errors++ }
            if (!finished || alarms || !functions) errors++
            printf "%d functions, %d statements with all that it calls", functions, all
            exit errors > 0
        }'
}

prove() { # BUILD MODULE MACROS: prints one line, then what is wrong
    log=$1/proof/$2$(printf %s "$3" | tr -c 'A-Za-z0-9=' _).log
    start=$(date +%s)
    analyse "$2" "$3" > "$log" 2>&1
    status=$?
    verdict=PASS
    why=$(judge "$2" "$log" "$3") && [ $status -eq 0 ] || verdict=FAIL
    printf '%s%s: %s (%s, %s s)\n' "$2" "${3:+ $3}" "$verdict" "$(printf '%s\n' "$why" | tail -n 1)" \
        $(($(date +%s) - start))
    printf '%s\n' "$why" | sed '$d'
}

if [ "$1" = --one ]; then
    prove "$2" "$3" "$4"
    exit
fi
out=$1
shift
mkdir -p "$out/proof"
# shellcheck disable=SC2046 # names without blanks
[ $# -gt 0 ] || set -- $(basename -s .c tests/proof/*.c)
for module; do
    if [ ! -f "tests/proof/$module.c" ]; then
        echo "MODULES='$module': there is no tests/proof/$module.c" >&2
        exit 1
    fi
done
for module; do
    { echo; [ "$BRIEF" ] || { options config "$module"; [ "$INT16" ] || options wide "$module"; }; } |
        while IFS= read -r macros; do
            macros="${DOUBLE:+-DINVCAL_DOUBLE=1}${DOUBLE:+${macros:+ }}$macros"
            printf '%s\n%s\n' "$module" "$macros"
        done
done > "$out/proof/jobs"
tr '\n' '\0' < "$out/proof/jobs" |
    xargs -0 -n 2 -P "${JOBS:-2}" sh tests/proof.sh --one "$out" | tee "$out/proof/summary"
# A proof without a result has crashed.
awk -v wanted="$(($(wc -l < "$out/proof/jobs") / 2))" '/: PASS \(/ { p++ } /: FAIL \(/ { f++ }
    END {
        if (p + f < wanted) f = wanted - p
        print p + 0 " passed, " f + 0 " failed"
        exit f > 0 || p == 0
    }' "$out/proof/summary"
