# SPDX-License-Identifier: MIT
#
# Adds Doxygen's markup to a header's comments, which are laid out for people.
#
#     the comment at the top, and one by itself             belongs to the file
#     a comment before a declaration                        to the declaration
#     a comment after a member or a value                   to that
#     name   text, name a parameter of the declaration      \param
#     Returns ...; below it  INVCAL_...  text               \return, \retval
#     Cost: ..., Stack: ..., Error: ...                     a paragraph with this title
#     invcal_..., INVCAL_... in the text                    a link
#
# The macros that put a build's choices into names are left out, with their comments: functions are called by their
# names.
{ line[NR] = $0 }

END {
    for (i = 1; i <= NR; i++) {
        if (is_left_out(i)) {
            while (line[i] ~ /\\$/) {
                i++
            }
        } else if (line[i] ~ /^ *\/\*/) {
            i = comment(i)
        } else if (line[i] ~ /;.*\/\*|,.*\/\*|^ +INVCAL_.*\/\*|^#define.*\/\*/) {
            i = behind(i)
        } else {
            print line[i]
        }
    }
}

function is_left_out(i) {
    return line[i] ~ /^#define invcal_/
}

# From line i to the end of the comment.
function end_of(i) {
    while (line[i] !~ /\*\//) {
        i++
    }
    return i
}

# Does a declaration with parameters begin in line i?
function has_parameters(i,    text) {
    while (i < NR && line[i] !~ /[;{]/ && line[i] !~ /^$/) {
        text = text line[i++]
    }
    return (text line[i]) ~ /\(/
}

# Names of the library become links, but for those of files, and of what is not public.
function linked(text,    out, name) {
    while (match(text, /(invcal|INVCAL)_[A-Za-z0-9_]+/)) {
        name = substr(text, RSTART, RLENGTH)
        out = out substr(text, 1, RSTART - 1)
        out = out (name ~ /_$/ || out ~ /[A-Za-z0-9_]$/ ? "" : "#") name
        text = substr(text, RSTART + RLENGTH)
    }
    return out text
}

# A member or value, or several, and the comment behind: each gets it. Returns the comment's last line.
function behind(i,    last, at, text, code, type, names, n, k) {
    last = end_of(i)
    at = index(line[i], "/*")
    code = substr(line[i], 1, at - 1)
    text = substr(line[i], at + 2)
    while (i < last) {
        sub(/^ +/, " ", line[++i])
        text = text line[i]
    }
    n = 1
    if (code ~ /^    [a-z0-9_]+ [^()]*,[^()]*; *$/) {
        type = substr(code, 1, match(substr(code, 5), / /) + 4)
        n = split(substr(code, length(type) + 1), names, /, |; *$/) - 1
    }
    for (k = 1; k <= n; k++) {
        print (n > 1 ? type names[k] "; " : code) "/**<" linked(text)
    }
    return last
}

# A comment that begins line i. Returns its last line.
function comment(i,    last, of, k, text, mode, is_file) {
    last = end_of(i)
    if (is_left_out(last + 1)) {
        return last
    }
    is_file = i == 1 || (last > i && (line[last + 1] == "" || (line[i] ~ /^\/\* ---/ && line[last + 1] ~ /^#if/)))
    if (line[last + 1] == "" && !is_file) {
        print line[i]
        return last
    }
    print is_file ? "/** \\file" : "/**"
    of = !is_file && has_parameters(last + 1)
    mode = ""
    for (k = i; k <= last; k++) {
        text = line[k]
        sub(/^ *\/?\*/, "", text)
        sub(/ *\*\/ *$/, "", text)
        if (k == 1) {
            text = "" # the licence
        }
        if (i == 1 && sub(/^ invcal\/[a-z_]+\.h: /, "", text)) {
            text = " " toupper(substr(text, 1, 1)) substr(text, 2)
        }
        if (text ~ /^ -----* /) { # a rule with a title
            gsub(/^ -+ | -+$/, "", text)
            text = " " toupper(substr(text, 1, 1)) substr(text, 2) "."
            text = is_file ? " \\details **" substr(text, 2) "**" : text
        }
        mode = say(text, of, mode)
    }
    print " */"
    return last
}

# One line of a comment. Returns what is going on: "", param, return, retval, par,
# list, text, code, and gap: a line left blank in code.
function say(text, of, mode,    names, rest) {
    if (text ~ /^ *$/) {
        print " *"
        return mode == "code" ? "gap" : ""
    }
    if ((mode == "" || mode == "code" || mode == "gap") && text ~ /^     /) {
        print " *" text
        return "code"
    }
    if (of && match(text, /^ [A-Za-z_]+(, [A-Za-z_]+)*  +/)) {
        names = substr(text, 2, RLENGTH - 1)
        rest = substr(text, RLENGTH + 1)
        sub(/ +$/, "", names)
        gsub(/, /, ",", names)
        print " * \\param " names " " linked(rest)
        return "param"
    }
    if (text ~ /^ Returns /) {
        print " *\n * \\return " linked(substr(text, 10))
        return "return"
    }
    if ((mode == "return" || mode == "retval") && match(text, /^  +INVCAL_[A-Z_]+(, INVCAL_[A-Z_]+)*  +/)) {
        names = substr(text, 1, RLENGTH)
        rest = substr(text, RLENGTH + 1)
        gsub(/^ +| +$/, "", names)
        gsub(/, /, ",", names)
        print " * \\retval " names " " linked(rest)
        return "retval"
    }
    if (match(text, /^ (Cost|Stack|Error|Relative error): /)) {
        print " *\n * \\par " substr(text, 2, RLENGTH - 3) "\n * " linked(substr(text, RLENGTH + 1))
        return "par"
    }
    if (text ~ /^ - / || (mode == "list" && text ~ /^   /)) {
        print " *" linked(text)
        return "list"
    }
    if ((mode == "param" || mode == "retval") && text !~ /^  /) {
        print " *" # the list is over
        mode = ""
    }
    sub(/^ +/, " ", text)
    print " *" linked(text)
    return mode == "code" || mode == "gap" ? "" : mode == "" ? "text" : mode
}
