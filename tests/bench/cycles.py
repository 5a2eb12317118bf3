# SPDX-License-Identifier: MIT
"""Cycles of the operations of bench.c, from a trace of its emulated run.

Usage: qemu -d exec,nochain -D TRACE ...; python3 cycles.py PROCESSOR DISASSEMBLY FIGURES < TRACE
    DISASSEMBLY  objdump -d of the program, compiled with BENCH_TRACED
    FIGURES      what the program prints when it is counted: names and instructions, in order
Prints "name cycles" for each operation in the trace; fails if its instructions are not those counted.

qemu says where each run of instructions without a branch begins. An instruction takes the cycles that Arm's
technical reference manuals state, without wait states (Cortex-M4: 100166, 3.3.1 and 3.3.3, FPU 7.2.3; Cortex-M0+:
DDI 0484, 3.3, with the fast multiplier). One that its condition skips counts as if it were executed.
"""
import collections
import re
import sys

PAGE = 1024  # of qemu, which also begins a run at each
CONDITION = '(eq|ne|cs|cc|mi|pl|vs|vc|hi|ls|ge|lt|gt|le)?'
SIMPLE = ('(mov[wt]?|mvn|addw?|adc|subw?|sbc|rsb|neg|mul|mla|[us]mull|[us]mlal|and|orr|orn|eor|bic|tst|teq|cmp|cmn|'
          'lsl|lsr|asr|ror|rrx|[us]xta?[bh]|rev|rev16|sm(ul|la)[bt][bt]|clz|rbit|[us]bfx|bfi|bfc|[us]sat|adr|nop)s?')


def is_op(pattern):
    return re.compile(pattern + CONDITION + '$').match


branches = is_op('(b|bl|bx|blx|cbz|cbnz|tb[bh])')
moves_many = is_op('(push|pop|v?ldm(ia|db)?|v?stm(ia|db)?|vpush|vpop)')
loads_or_stores = is_op('(ldr|str)(b|h|sb|sh)?')
is_simple = is_op(SIMPLE)
float_arithmetic = is_op('v(add|sub|n?mul|div|sqrt|n?ml[as]|f?n?m[as]|cvtr?)')
float_simple = is_op('v(abs|neg|mov|cmpe?|mrs|msr|add|sub|n?mul|cvtr?)')

Instruction = collections.namedtuple('Instruction', 'op operands next')


def disassembled(lines):
    program = {}
    for line in lines:
        found = re.match(r' *([0-9a-f]+):\t([0-9a-f ]+?) *\t(\S+)\s*([^;@<]*)', line)
        if found:
            address = int(found[1], 16)
            size = len(found[2].replace(' ', '')) // 2
            op = found[3].split('.')[0]  # without .n, .w, .f32
            program[address] = Instruction(op, found[4].strip(), address + size)
    return program


def registers(i):
    """How many are in {r4-r7, lr}."""
    count = 0
    for part in re.search(r'\{(.*)\}', i.operands)[1].split(','):
        ends = re.findall(r'\d+', part) if '-' in part else [0, 0]
        count += int(ends[1]) - int(ends[0]) + 1
    return count


def result(i):
    return i.operands.split(',')[0]


def address(i):
    """The registers of an address."""
    return re.findall(r'\w+', i.operands[i.operands.find('['):])


def needs(i, register):
    """Does it read it? What it writes comes first, unless it adds to that, compares or stores."""
    reads_first = re.match('v(n?ml|f?n?m[as]|cmp|str|push|stm)|str|push|stm|cmp|tst', i.op)
    return re.search(rf'\b{register}\b', i.operands if reads_first else i.operands.partition(',')[2])


def unknown(i):
    sys.exit(f'cycles.py: how many cycles does {i.op} {i.operands} take?')


def cortex_m4(i, before, taken):
    refill = 2 if taken else 0  # 1 to 3
    if branches(i.op):
        return (2 if i.op.startswith('tb') else 1) + refill
    if moves_many(i.op):
        return 1 + registers(i) * (2 if '{d' in i.operands else 1) + refill
    if loads_or_stores(i.op):
        is_store = i.op.startswith('str')
        follows = before is not None and loads_or_stores(before.op) and before.op.startswith('ldr') and \
            result(before) not in address(i)
        return (1 if follows or is_store and '#' in i.operands else 2) + refill
    if is_op('(ldrd|strd)')(i.op):
        return 3
    if is_op('[us]div')(i.op):
        return 12
    if is_simple(i.op) or re.match('i[te]+$', i.op):
        return 1 + refill
    # The result of floating-point arithmetic comes a cycle late if the next instruction needs it.
    late = 1 if before is not None and float_arithmetic(before.op) and needs(i, result(before)) else 0
    if is_op('v(ldr|str)')(i.op):
        return (3 if i.operands.startswith('d') else 2) + late
    if is_op('v(div|sqrt)')(i.op):
        return 14 + late
    if is_op('v(n?ml[as]|f?n?m[as])')(i.op):
        return 3 + late
    if float_simple(i.op):
        return 1 + late
    return unknown(i)


def cortex_m0plus(i, _, taken):
    refill = 1 if taken else 0
    if i.op == 'bl':
        return 3
    if branches(i.op):
        return 1 + refill
    if moves_many(i.op):
        return registers(i) + (3 if taken else 1)
    if loads_or_stores(i.op):
        return 2
    if is_simple(i.op):
        return 1 + refill
    return unknown(i)


def ends_run(i):
    return branches(i.op) or 'pc' in (i.operands if i.op.startswith(('pop', 'ldm')) else result(i))


class Costs:
    """Instructions and cycles of runs. A run is where it begins, and where the next one does."""

    def __init__(self, program, cycles_of):
        self.program = program
        self.cycles_of = cycles_of
        self.known = {}

    def of_run(self, run):
        if run not in self.known:
            at, then = run
            before = None
            instructions = cycles = 0
            ends = False
            while not ends:
                i = self.program[at]
                ends = ends_run(i) or i.next == then and i.next % PAGE in (0, 2, PAGE - 2)
                instructions += 1
                cycles += self.cycles_of(i, before, ends and i.next != then)
                at, before = i.next, i
            self.known[run] = instructions, cycles
        return self.known[run]

    def total(self, runs):
        each = [(count, self.of_run(run)) for run, count in runs.items()]
        return [sum(count * cost[k] for count, cost in each) for k in (0, 1)]


def begins(trace):
    """Where each run begins, but for those that qemu stopped before they did."""
    last = None
    for line in trace:
        if line.startswith(b'Trace'):
            if last is not None:
                yield last
            at = line.index(b'/') + 1
            last = int(line[at:at + 8], 16)
        elif line.startswith(b'Stopped'):
            last = None


def operations(trace, clock, put):
    """The runs from one reading of the clock to the next, until something is printed, and how many readings began
    them. The first two readings have nothing between them, and nothing is printed after them."""
    runs, readings = collections.Counter(), 0
    inside, is_idle = False, True
    before = None
    for at in begins(trace):
        if inside:
            runs[before, at] += 1
        if at == clock:
            inside = not inside
            readings += inside
        if readings and not inside and (is_idle or at == put):
            yield runs, readings
            runs, readings, is_idle = collections.Counter(), 0, False
        before = at


def main():
    processor, disassembly, figures = sys.argv[1:]
    with open(disassembly, encoding='utf-8') as file:
        lines = file.readlines()
    with open(figures, encoding='utf-8') as file:
        counted = iter([m.groups() for m in map(re.compile(r'(\w+)(?<!_bytes) (\d+)$').match, file) if m])
    names = {m[2]: int(m[1], 16) for m in map(re.compile('([0-9a-f]+) <(.*)>:').match, lines) if m}
    costs = Costs(disassembled(lines), {'cortex-m4': cortex_m4, 'cortex-m0plus': cortex_m0plus}[processor])
    found = operations(sys.stdin.buffer, names['board_count'], names['board_put'])
    idle = costs.total(next(found)[0])
    for runs, readings in found:
        name, figure = next(counted)
        instructions, cycles = (all - readings * none for all, none in zip(costs.total(runs), idle))
        calls = round(instructions / int(figure))  # the figure may be the mean of several
        if abs(instructions - calls * int(figure)) > calls + 0.003 * instructions:
            sys.exit(f'cycles.py: {name}: {instructions} instructions traced, {figure} counted')
        print(name, round(cycles / calls))


main()
