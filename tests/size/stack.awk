# SPDX-License-Identifier: MIT
#
# The worst-case stack of functions, from the frames that the compiler states (-fstack-usage) and
# the calls that the linked program makes. Prints for each public function
#     "stack" module function bytes callbacks path
# where callbacks is 1 if some function that it calls, directly or not, calls through a pointer, and
# path has the frames of the deepest call chain, "function:bytes,function:bytes"; and "fault ..." for
# each recursion, frame without a bound, unknown frame, use of the heap, and call by the library for
# arithmetic in double, which the compiler's library does where the processor cannot. (Some compilers'
# own conversion of 64-bit integers to float goes through double.)
#
# A function is a section (-ffunction-sections). For functions outside the library no compiler states a
# frame: it is the sum of all that their instructions push, or, where that cannot be read, what the
# budgets allow in lines "frame.FUNCTION". That reading is checked on the library's own functions: it
# must never find less than the compiler states.
#
# Usage: awk -v library=FOLDER/src/ -f stack.awk FRAMES PUBLIC SECTIONS CODE SU...
#     FRAMES    lines "frame.FUNCTION bytes", a return address that a call pushes not counted
#     PUBLIC    lines "header function", by public.awk
#     SECTIONS  by sections.awk; library: how the file names of the library's begin
#     CODE      by code.awk
#     SU        written by -fstack-usage

FNR == 1 { file++ }
file == 1 { allowed[substr($1, 7)] = $2; next }
file == 2 { function_of[++publics] = $2; next }
file == 3 { if ($1 ~ /^\.text/) section(); next }
file == 4 { code[++codes] = $0; next }
{ usage() }

function section() {
    if ($2 < end[nodes]) fault("sections are out of order at " $1)
    begin[++nodes] = $2
    end[nodes] = $2 + $3
    owned[nodes] = index($4, library) == 1
    label = $1
    sub(/^\.text\.?(unlikely\.)?/, "", label)
    object[nodes] = $4
    name[nodes] = label
}

# A .su line: "src/core/vector.h:23:27:invcali_dot.constprop <tab> 16 <tab> static". Clones may have the
# same name here, or lack their number: the largest counts.
function usage(    part, n, key, at) {
    at = FILENAME
    sub(/su$/, "o", at)
    n = split($0, part, "\t")
    key = part[1]
    sub(/.*:/, "", key)
    sub(/\.[0-9]+$/, "", key)
    key = at SUBSEP key
    if (!(key in stated) || part[2] > stated[key]) stated[key] = part[2] + 0
    if (part[3] !~ /^static|bounded/) unbounded[key] = 1
}

# The node at an address: sections come in ascending order.
function node_at(address,    low, high, middle) {
    low = 1
    high = nodes
    while (low < high) {
        middle = int((low + high + 1) / 2)
        if (begin[middle] <= address) low = middle
        else high = middle - 1
    }
    return address >= begin[low] && address < end[low] ? low : 0
}

function fault(text) { if (!printed[text]++) print "fault", text }

function edge(from, to, kind) {
    if (seen[from, to, kind]++) return
    edges[from]++
    to_of[from, edges[from]] = to
    kind_of[from, edges[from]] = kind
}

# Routines that compiled functions share to save and restore registers. What the former push stays
# pushed when they return, so it belongs to their caller.
function saves(symbol) { return symbol ~ /^(__riscv_save_|__prologue_saves__)/ }
function restores(symbol) { return symbol ~ /^(__riscv_restore_|__epilogue_restores__)/ }

function read_line(    part, at, to) {
    split(code[line], part, " ")
    at = node_at(part[2])
    if (part[1] == "name") {
        here = part[3]
        if (!at) return
        address_of[here] = at
        if (!owned[at] && !named[at]++) name[at] = here
    } else if (!at) return
    else if (part[1] == "push") {
        pushed[at] += part[3]
        pushed_in[here] += part[3]
    } else if (part[1] == "unread") unread[at] = unread_in[here] = 1
    else if (part[1] == "pointer") { if (part[3] == "call" || owned[at]) calls_back[at] = 1 }
    else {
        to = node_at(part[3])
        if (!to) lost[at] = part[4]
        else if (saves(part[4])) saver[at] = part[4]
        else if (restores(part[4])) return
        else if (to != at) edge(at, to, part[1])
        else if (part[1] == "call" && owned[at]) edge(at, at, "call")
        else if (part[1] == "call") pushed[at] += return_size
    }
}

function frame_of(n,    key, label, none) {
    label = name[n]
    if (owned[n]) {
        sub(/\.[0-9]+$/, "", label)
        key = object[n] SUBSEP label
        if (!(key in stated)) fault(name[n] " has no frame stated by the compiler")
        if (key in unbounded) fault(name[n] " has a frame without a bound")
        # On PowerPC the compiler states the smallest frame, 16 bytes, even where there is none.
        none = !pushed[n] && stated[key] <= 16
        if (!unread[n] && !none && pushed[n] + return_size < stated[key]) {
            fault(name[n] " pushes " pushed[n] + return_size ", but its frame is " stated[key])
        }
        return stated[key]
    }
    return read_frame(label, pushed[n], unread[n]) + return_size + \
        (n in saver ? read_frame(saver[n], pushed_in[saver[n]], unread_in[saver[n]]) : 0)
}

function read_frame(label, bytes, beyond) {
    if (label in allowed) return allowed[label]
    if (beyond) fault(label " changes the stack pointer by an unknown amount: state frame." label)
    return bytes
}

function is_double(symbol) { return symbol ~ /^__(aeabi_(d|[a-z]+2d)|[a-z]*df)/ }

# The most stack that node n takes, including what it calls. A function of the library frees its frame
# before it jumps to another one; others may not.
function worst(n,    i, to, below, most, held) {
    if (state[n] == 2) return total[n]
    if (state[n] == 1) {
        fault("recursion through " name[n])
        return 0
    }
    state[n] = 1
    if (n in lost) fault(name[n] " goes to an unknown address, " lost[n])
    if (name[n] ~ /^_?(malloc|calloc|realloc|free|sbrk)(_r)?$/) fault("the heap is used: " name[n])
    held = frame[n] = frame_of(n)
    most = held
    for (i = 1; i <= edges[n]; i++) {
        to = to_of[n, i]
        if (owned[n] && is_double(name[to])) fault(name[n] " computes double: " name[to])
        below = worst(to)
        if (kind_of[n, i] == "call" || !owned[n]) below += held
        if (calls_back[to]) calls_back[n] = 1
        if (below > most) {
            most = below
            next_of[n] = to
        }
    }
    state[n] = 2
    return total[n] = most
}

function path(n,    text) {
    for (text = name[n] ":" frame[n]; n in next_of; text = text "," name[n] ":" frame[n]) n = next_of[n]
    return text
}

function module(file) {
    gsub(/.*\/|\.o$/, "", file)
    return file
}

END {
    for (line = 1; line <= codes; line++) read_line()
    for (p = 1; p <= publics; p++) {
        n = address_of[function_of[p]]
        if (!n) fault(function_of[p] " is declared, but not in the program")
        else print "stack", module(object[n]), function_of[p], worst(n), calls_back[n] + 0, path(n)
    }
}
