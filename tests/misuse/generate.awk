# SPDX-License-Identifier: MIT
#
# awk -f generate.awk include/invcal/*.h: a table of every public function, for misuse.c. What may be null, overwritten
# or equal to another argument is read from the comment before the declaration.
FNR == 1 { comment = text = "" }
/^\/\*/ { comment = ""; in_comment = 1 }
in_comment { comment = comment "\n" $0; if (/\*\//) in_comment = 0; next }
/^[a-zA-Z].*[( ]$|^[a-zA-Z].*\(|^[a-zA-Z].*,$/ && !/^(typedef|static|enum|extern)/ || text != "" { text = text " " $0 }
text != "" && /;$/ {
    if (text ~ /invcal_[a-z0-9_]+\(/) {
        declare(text)
    }
    text = ""
}
/^}/ { text = "" }

# What the comment says of one parameter, from its name to the next one; of several at once, what names this one.
function said(name,    n, lines, i, on, all) {
    n = split(comment, lines, "\n")
    for (i = 1; i <= n; i++) {
        if (lines[i] ~ /^ \* +[a-z_]+(, [a-z_]+)*  +[^ ]/ || lines[i] ~ /^ \*$/ || lines[i] ~ /^ \* (Returns|Cost)/) {
            on = lines[i] ~ "^ \\* +([a-z_]+, )*" name "(, [a-z_]+)*  "
            several = lines[i] ~ /^ \* +[a-z_]+, /
        }
        if (on && (!several || lines[i] ~ name " (may|is)")) {
            all = all " " lines[i]
        }
    }
    return all
}

function declare(text,    name, list, n, i, part, type, array, pointer, constant, call, kinds, returns, words) {
    gsub(/[ \n]+/, " ", text)
    sub(/^ *(INVCAL_NODISCARD )?/, "", text)
    match(text, /invcal_[a-z0-9_]+\(/)
    name = substr(text, RSTART, RLENGTH - 1)
    returns = substr(text, 1, RSTART - 1)
    sub(/ $/, "", returns)
    list = substr(text, RSTART + RLENGTH)
    sub(/\);$/, "", list)
    n = split(list, part, /, */)
    call = kinds = ""
    for (i = 1; i <= n; i++) {
        array = ""
        while (match(part[i], /\[[^]]*\]$/)) {
            array = array (array == "" ? "" : ") * (") substr(part[i], RSTART + 1, RLENGTH - 2)
            part[i] = substr(part[i], 1, RSTART - 1)
        }
        constant = part[i] ~ /^const /
        sub(/^const /, "", part[i])
        pointer = part[i] ~ /\*/ || array != ""
        sub(/\*/, "", part[i])
        match(part[i], /[a-z0-9_]+$/)
        param = substr(part[i], RSTART)
        type = substr(part[i], 1, RSTART - 1)
        gsub(/ /, "", type)
        words = tolower(said(param))
        call = call (i > 1 ? ", " : "") (pointer ? "a[" i - 1 "].p" : type == "invcal_real" ? "a[" i - 1 "].real" : \
            "(" type ")a[" i - 1 "].integer")
        kinds = kinds "    {\"" param "\", \"" type "\", " \
            (pointer ? (array != "" ? "(" array ") * " : "") "sizeof(" type ")" : 0) ", " pointer ", " constant ", " \
            (words ~ /null/ ? 1 : 0) ", " (words ~ /overwritten/ || tolower(comment) ~ /(they|which) are overwritten/ || \
            tolower(comment) ~ /on failure[^.]*overwritten|may be overwritten on failure|is overwritten/ ? 1 : 0) ", " \
            (words ~ /may equal/ ? 1 : 0) "},\n"
    }
    if (list == "void" || list == "") {
        n = 0
        call = ""
        kinds = "    {0, 0, 0, 0, 0, 0, 0, 0},\n"
    }
    gsub(/\n/, " ", comment)
    print "static const parameter parameters_of_" name "[] = {\n" kinds "};"
    print "static long call_" name "(const argument *a)\n{"
    print "    (void)a;"
    if (returns == "void") {
        print "    " name "(" call ");\n    return 0;"
    } else if (returns ~ /\*$/) {
        print "    return " name "(" call ") == NULL;"
    } else if (returns == "invcal_status" || returns == "invcal_event") {
        print "    return (long)" name "(" call ");"
    } else {
        print "    (void)" name "(" call ");\n    return 0;"
    }
    print "}\n"
    table = table "    {\"" name "\", " (returns == "invcal_status") ", " (returns ~ /\*$/) ", " n ", parameters_of_" name \
        ", call_" name "},\n"
}

END { print "static const function functions[] = {\n" table "};" }
