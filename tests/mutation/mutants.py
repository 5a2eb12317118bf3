# SPDX-License-Identifier: MIT
"""Mutants of a C source: one small change each, such as a typing mistake makes.

Changes text, not a syntax tree: clang-format's layout tells a binary operator (a blank on both
sides) from a unary one. Leaves alone: comments, string literals, preprocessor lines except for the
values of #define, INVCAL_ASSERT, and the sizes of declared arrays (a larger one is not an error, and
the sanitizers of `make check` catch a smaller one).
"""
import collections
import hashlib
import re

TOKEN = re.compile(
    r"""(?P<skip>/\*.*?\*/|//[^\n]*|"(?:\\.|[^"\\])*"|'(?:\\.|[^'\\])*'
          |^[ ]*\#[ ]*define[ ]+\w+(?:\([\w, ]*\))?|^[ ]*\#(?:\\\n|[^\n])*|\\\n)
      |(?P<float>\d+\.\d*(?:[eE][-+]?\d+)?|\d+[eE][-+]?\d+)
      |(?P<int>0[xX][0-9a-fA-F]+|\d+)(?P<suffix>[uUlL]*)
      |(?P<name>[A-Za-z_]\w*)
      |(?P<op><<=|>>=|->|\+\+|--|<<|>>|<=|>=|==|!=|&&|\|\||[-+*/%&|^]=|[^\s\w])""",
    re.VERBOSE | re.DOTALL | re.MULTILINE)

BINARY = {  # only between blanks
    "+": "-", "-": "+", "*": "/", "/": "*", "%": "*", "<<": ">>", ">>": "<<", "&": "|", "|": "&",
    "^": "&", "+=": "-=", "-=": "+=", "*=": "/=", "/=": "*=", "|=": "&=", "&=": "|=", "^=": "|=",
    "<<=": ">>=", ">>=": "<<=", "&&": "||", "||": "&&"}
COMPARISON = {
    "<": ("<=", ">="), "<=": ("<", ">"), ">": (">=", "<="), ">=": (">", "<"),
    "==": ("!=",), "!=": ("==",)}
STEP = {"++": "--", "--": "++"}
NO_STATEMENT = set("return if else for while do switch case default goto typedef static const "
                   "struct enum union extern unsigned int char float double void".split())
STATEMENT = re.compile(r"((?:\*|\(void\))?\w[^;{}]*?([-+*/%&|^<>]?= |\()[^;{}]*|\w+(\+\+|--)|break|continue);")
DECLARATION = re.compile(r"\w+ \**\w")

Mutant = collections.namedtuple("Mutant", "file line before after start end replacement key")


def tokens_of(text):
    """Everything that may be changed, in order; drops INVCAL_ASSERT(...)."""
    tokens = [m for m in TOKEN.finditer(text) if m.lastgroup != "skip"]
    kept, i = [], 0
    while i < len(tokens):
        if tokens[i][0] == "INVCAL_ASSERT":
            i = closing(tokens, i + 1)
        else:
            kept.append(tokens[i])
        i += 1
    return kept


def closing(tokens, i):
    """The index of the bracket that closes the one at i."""
    depth = 0
    for k in range(i, len(tokens)):
        depth += (tokens[k][0] in "([{") - (tokens[k][0] in ")]}")
        if depth == 0:
            return k
    raise ValueError("no closing bracket")


def declares_array(tokens, i):
    """Is the bracket at i the size in `type name[...]`, or of what `type (*name)[...]` points to?"""
    while i > 0 and tokens[i - 1][0] == "]":
        i -= 1
        while tokens[i][0] != "[":
            i -= 1
    if tokens[i - 1][0] == ")":
        return any(t[0] == "(" and u[0] == "*" for t, u in (tokens[i - 4:i - 2], tokens[i - 3:i - 1]))
    return (i >= 2 and tokens[i - 1]["name"] and tokens[i - 2][0] != "return"
            and (tokens[i - 2]["name"] or (tokens[i - 2][0] == "*"
                                           and tokens[i - 2].end() == tokens[i - 1].start())))


def changes(text, statuses):
    """Yields (start, end, replacement)."""
    tokens = tokens_of(text)
    sizes = set()
    depth = 0  # of parentheses
    for i, t in enumerate(tokens):
        word, start, end = t[0], t.start(), t.end()
        depth += (word == "(") - (word == ")")
        before = tokens[i - 1][0] if i else ";"
        after = tokens[i + 1][0] if i + 1 < len(tokens) else ";"
        if word == "[" and declares_array(tokens, i):
            sizes.update(range(i, closing(tokens, i)))
        if i in sizes:
            continue
        if t["float"]:
            yield start, end, re.sub(r"^(\d+)(e|$)", r"\1.0\2", "%.9g" % (1.1 * float(word)))
            yield start, end, "-" + word
        elif t["int"]:
            n = int(t["int"], 0)
            for value in (n + 1, n - 1) if n else (1,):
                yield start, end, ("0x%X" if "x" in word.lower() else "%d") % value + t["suffix"]
        elif t["op"]:
            is_binary = text[start - 1] in " \n" and text[end] in " \n"
            for other in COMPARISON.get(word, ()):
                yield start, end, other
            if word in BINARY and is_binary:
                yield start, end, BINARY[word]
            elif word in "-!~" and not is_binary:
                yield start, end, ""
            elif word in STEP:
                yield start, end, STEP[word]
        elif word in statuses and before in ("return", "?", ":", "=") and after in (";", ":"):
            yield start, end, "INVCAL_UNDETERMINED" if word == "INVCAL_OK" else "INVCAL_OK"
        elif word.isupper() and before == "return" and after == ";":
            yield start, end, word + " + 1"
        elif word in ("if", "while"):
            inner = text[tokens[i + 1].end():tokens[closing(tokens, i + 1)].start()]
            if not re.search(r"[!=<>]|&&|\|\|", inner.replace("->", ".")):
                yield tokens[i + 1].end(), tokens[i + 1].end() + len(inner), "!(%s)" % inner
        label = before == ":" and "\n" in text[tokens[i - 1].end():start]
        if depth == (word == "(") and (label or before in "{};") and word not in NO_STATEMENT:
            statement = STATEMENT.match(text, start)
            if statement and not DECLARATION.match(statement[0]):
                yield start, statement.end(), ";"


def mutants_of(file, statuses, seed):
    """All of a file. `key` orders them at random, but does not depend on their line numbers."""
    text = open(file, encoding="utf-8").read()
    seen = collections.Counter()
    for start, end, replacement in changes(text, statuses):
        head = text.rfind("\n", 0, start) + 1
        tail = text.find("\n", end)
        was = " ".join(text[head:tail].split())
        now = " ".join((text[head:start] + replacement + text[end:tail]).split())
        seen[was, now] += 1
        name = "%s %s|%s|%s|%d" % (seed, file, was, now, seen[was, now])
        yield Mutant(file, text.count("\n", 0, start) + 1, was, now, start, end, replacement,
                     hashlib.sha256(name.encode()).hexdigest())


def apply(mutant, text):
    return text[:mutant.start] + mutant.replacement + text[mutant.end:]
