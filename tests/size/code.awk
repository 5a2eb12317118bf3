# SPDX-License-Identifier: MIT
#
# What a disassembled program does to its stack, a line each, addresses in decimal:
#     name ADDRESS SYMBOL            a symbol
#     push ADDRESS BYTES             takes bytes of stack
#     unread ADDRESS INSTRUCTION     changes the stack pointer by an unknown amount
#     call ADDRESS TARGET SYMBOL     returns here
#     jump ADDRESS TARGET SYMBOL     or a branch
#     pointer ADDRESS call|jump      goes where a register points; such a jump may be a switch
# Whatever frees stack is left out: the sum of a function's pushes is the most it can hold, as long
# as none is in a loop.
# Usage: PREFIXobjdump -d program.elf | awk -f hex.awk -f code.awk

/file format/ { machine = $NF; sub(/^elf32-(little|big)?/, "", machine); next }
/^[0-9a-f]+ <.*>:$/ {
    sub(/^</, "", $2)
    sub(/>:$/, "", $2)
    print "name", hex($1), $2
    next
}
!/^ *[0-9a-f]+:\t/ { next }
{
    split($0, field, "\t")
    address = field[1]
    gsub(/[ :]/, "", address)
    address = hex(address)
    rest = field[3] " " field[4] " " field[5]
    op = rest
    sub(/ .*/, "", op)
    sub(/^[^ ]+ +/, "", rest)
    sub(/ *([;@]|# ).*/, "", rest)
    sub(/ *<.*/, "", rest)
    target = symbol = ""
    if (match($0, /[0-9a-fx]+ <[^>]+>/)) {
        split(substr($0, RSTART, RLENGTH - 1), pair, " <")
        target = hex(pair[1])
        symbol = pair[2]
        sub(/\+0x.*/, "", symbol)
    }
    if (machine == "arm") arm()
    else if (machine == "riscv") riscv()
    else if (machine == "avr") avr()
    else if (machine == "powerpc") powerpc()
    else {
        print "code.awk: unknown machine " machine > "/dev/stderr"
        exit 1
    }
}

function out(what, value) { print what, address, value }
function go(what) { print what, address, target, symbol }

# Registers in {r0, r4-r7, lr}.
function registers(list,    part, ends, n, i, count) {
    gsub(/.*\{|\}.*| /, "", list)
    n = split(list, part, ",")
    for (i = 1; i <= n; i++) {
        count += split(part[i], ends, "-") == 2 ? substr(ends[2], 2) - substr(ends[1], 2) + 1 : 1
    }
    return count
}

# The number in an operand like "#-16" or "sp,sp,-48".
function number(text) {
    if (!match(text, /-?[0-9]+[^0-9]*$/)) return 0
    return substr(text, RSTART) + 0
}

function arm() {
    if (op ~ /^(push|stmdb|stmfd)/ && (op ~ /^push/ || rest ~ /^sp!/)) out("push", 4 * registers(rest))
    else if (op ~ /^(vpush|vstmdb)/) out("push", (rest ~ /\{d/ ? 8 : 4) * registers(rest))
    else if (op ~ /^str/ && rest ~ /\[sp, #-[0-9]+\]!/) out("push", -number(rest))
    else if (op ~ /^sub/ && rest ~ /^sp, (sp, )?#/) out("push", number(rest))
    else if (op ~ /^(add|sub|mov)/ && rest ~ /^sp, / && rest !~ /#/) out("unread", op " " rest)
    else if (op ~ /^blx?/ && op !~ /^(bls|blt|ble)/ && target != "") go("call")
    else if (op ~ /^blx/) out("pointer", "call")
    else if (op ~ /^bx/ && rest !~ /^lr/) out("pointer", "jump")
    else if (op ~ /^(b|cbn?z)/ && op !~ /^(bic|bf|bkpt|bx)/ && target != "") go("jump")
}

function riscv() {
    if (op ~ /^(c\.)?addi?(16sp)?$/ && rest ~ /^sp,sp,-[0-9]/) out("push", -number(rest))
    else if (op ~ /^(sub|add|mv)$/ && rest ~ /^sp,/ && rest !~ /^sp,sp,[0-9]/) out("unread", op " " rest)
    else if (op ~ /^jalr?$/ && target != "") go("call")
    else if (op == "jalr") out("pointer", "call")
    else if (op == "jr" && rest !~ /^(ra|t0)/ && target == "") out("pointer", "jump")
    else if (op ~ /^(j|jr|b.*)$/ && target != "") go("jump")
}

function avr() {
    if (op == "push") out("push", 1)
    else if (op == "rcall" && rest ~ /^\.\+0/) out("push", 2) # the shortest way to take two bytes
    else if (op == "out" && rest ~ /^0x3d/) out("unread", op " " rest)
    else if (op ~ /^r?call$/) go("call")
    else if (op ~ /^e?icall$/) out("pointer", "call")
    else if (op ~ /^e?ijmp$/) out("pointer", "jump")
    else if (op ~ /^(r?jmp|br.*)$/ && op != "break") go("jump")
}

function powerpc() {
    if (op == "stwu" && rest ~ /^r1,-/) { sub(/\(.*/, "", rest); out("push", -number(rest)) }
    else if (op ~ /^stwux$/ && rest ~ /^r1,/) out("unread", op " " rest)
    else if (op == "bl" && target != "") go("call")
    else if (op ~ /^b(ctrl|lrl)$/) out("pointer", "call")
    else if (op == "bctr") out("pointer", "jump")
    else if (op ~ /^b/ && target != "") go("jump")
}
