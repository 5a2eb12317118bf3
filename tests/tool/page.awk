# SPDX-License-Identifier: MIT
#
# Checks a page: tags are closed in order, attributes are quoted, there is no stray < or &, and nothing
# is loaded or run. Prints nothing, or one line that says what is wrong.
function wrong(what) {
    if (!said) print "wrong: " what
    said = 1
}
function open_tag(tag,    name, rest) {
    name = tag
    sub(/[ \/].*/, "", name)
    if (name ~ /^(script|iframe|object|embed|link|img|base|form|use|image)$/) wrong("<" name ">")
    if (tag ~ / (on[a-z]*|src|href|srcset|action)=/) wrong("it would load or run: " tag)
    rest = tag
    gsub(/ +[a-zA-Z0-9:-]+="[^"<]*"/, "", rest)
    sub(/\/$/, "", rest)
    sub(/ open$/, "", rest) # <details open>
    if (rest != name) wrong("attributes of " tag)
    if (name == "meta" || tag ~ /\/$/) return
    stack[++depth] = name
}
function close_tag(name) {
    if (depth == 0 || stack[depth] != name) wrong("</" name "> after <" stack[depth] ">")
    else depth--
}
BEGIN { RS = "<" }
/url\(|@import|javascript:/ { wrong("a reference to elsewhere") }
NR <= 2 {
    if ($0 != (NR == 1 ? "" : "!DOCTYPE html>\n")) wrong("no doctype")
    next
}
{
    at = index($0, ">")
    if (at == 0) { wrong("a stray <"); exit }
    tag = substr($0, 1, at - 1)
    gsub(/\n/, " ", tag)
    text = substr($0, at + 1)
    if (tag ~ /^\//) close_tag(substr(tag, 2))
    else open_tag(tag)
    if (stack[depth] == "style") next
    gsub(/&(amp|lt|gt|quot|#39);/, "", text)
    if (text ~ /&|>/) wrong("a stray & or >: " text)
}
END {
    if (NR < 2) wrong("no doctype")
    if (depth) wrong("<" stack[depth] "> is left open")
}
