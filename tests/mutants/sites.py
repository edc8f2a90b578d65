# SPDX-License-Identifier: GPL-3.0-or-later
"""Where a small fault can be put into a C++ file, as text: nothing is parsed. The files are formatted by clang-format, so
that binary operators have spaces around them, and templates, pointers and signs have not."""
from __future__ import annotations

import re
from typing import Iterator, NamedTuple


class Mutant(NamedTuple):
    kind: str
    begin: int  # of the characters that are replaced
    end: int
    text: str


LEFT_OUT = re.compile(r"""//[^\n]*|/\*.*?\*/|R"(?P<mark>\w*)\(.*?\)(?P=mark)"|"(?:\\.|[^"\\\n])*"
                       |^[ \t]*\#(?:\\\n|[^\n])*|\b(?:static_assert|assert|Q_ASSERT)\([^;]*;
                       |(?P<number>\b\d[\w'.]*)|'(?:\\.|[^'\\\n])*'""", re.S | re.M | re.X)
OPERATORS = {
    "comparison": {"<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "=="},
    "arithmetic": {"+": "-", "-": "+", "*": "/", "/": "*", "+=": "-=", "-=": "+=", "%": "*"},
    "logic": {"&&": "||", "||": "&&", "&": "|", "|": "&"},
}
NUMBER = re.compile(r"(?<![\w.])(?:\d[\d']*\.\d+|\d[\d']*)(?![\w.'])")
NO_STATEMENT = re.compile(r"(?:if|for|while|switch|return|else|do|case|default|break|continue|using|namespace|template|"
                          r"class|struct|public|private|protected|static|constexpr|const|auto|throw|goto|try|catch)\b")
STATEMENT = re.compile(r"(?:emit )?[\w:]+(?:\(|\[|\.|->| [-+*/|&]?= |\+\+|--)")
CONNECTION = re.compile(r"(?:QObject::)?connect\(")
HANDLER = re.compile(r"^void (?:\w+::)+\w*(?:Event|Triggered|Changed)\([^;{]*\)(?: const)?\s*(?=\{)", re.M)
PAIRS = {"(": ")", "[": "]", "{": "}"}


def code_of(text: str) -> str:
    """The text with spaces for comments, strings, preprocessor lines and assertions.

    >>> code_of('f("a + b", 1\\'000); // x < y')
    "f(       , 1'000);         "
    """
    def blank(found: re.Match[str]) -> str:
        return found[0] if found["number"] else re.sub(r"[^\n]", " ", found[0])

    return LEFT_OUT.sub(blank, text)


def closing(code: str, at: int, stop: str = "") -> int:
    """The index after the bracket that closes the one at `at`; or of the first `stop` outside brackets; or -1.

    >>> closing("f(a[1], b) + c", 1), closing("f(a); g();", 0, ";"), closing("f(a", 1)
    (10, 4, -1)
    """
    open_brackets: list[str] = []
    for i in range(at, len(code)):
        if code[i] in PAIRS:
            if not open_brackets and stop and code[i] == "{":
                return -1  # a function, not a statement
            open_brackets.append(PAIRS[code[i]])
        elif open_brackets and code[i] == open_brackets[-1]:
            open_brackets.pop()
            if not open_brackets and not stop:
                return i + 1
        elif code[i] in ")]}":
            return -1
        elif not open_brackets and stop and code[i] == stop:
            return i
    return -1


def mutants(text: str) -> Iterator[Mutant]:
    """Every fault that this knows, in a text.

    >>> text = "void f(int a)\\n{\\n    if (a < 3)\\n        g(a + 1);\\n    connect(x, &X::y, [] {\\n        h();\\n    });\\n}\\n"
    >>> for m in mutants(text): print(m.kind, "|", text[m.begin:m.end].split()[0], "=>", m.text)
    comparison | < => <=
    arithmetic | + => -
    constant | 3 => 4
    constant | 1 => 2
    condition | a => !(a < 3)
    statement | g(a => ;
    connection | connect(x, => ;
    statement | h(); => ;
    """
    code = code_of(text)
    for kind, changes in OPERATORS.items():
        for found in re.finditer(r"(?<=\s)(?:%s)(?=\s)" % "|".join(map(re.escape, sorted(changes, key=len)[::-1])), code):
            yield Mutant(kind, found.start(), found.end(), changes[found[0]])
    for found in NUMBER.finditer(code):
        number = found[0]
        yield Mutant("constant", *found.span(), repr(2 * float(number.replace("'", "")) or 1.0) if "." in number
                     else str(int(number.replace("'", "")) + 1))
    for found in re.finditer(r"\b(?:true|false)\b", code):
        yield Mutant("constant", *found.span(), "false" if found[0] == "true" else "true")
    for found in re.finditer(r"\b(?:if|while) (?=\()", code):
        end = closing(code, found.end())
        condition = text[found.end() + 1:end - 1]
        if end > 0 and not re.search(r"[^=!<>]=[^=]|;", condition):
            yield Mutant("condition", found.end() + 1, end - 1, f"!({condition})")
    yield from statements(code)
    for found in HANDLER.finditer(code):
        end = closing(code, found.end())
        if end > 0:
            yield Mutant("handler", found.end(), end, "{}")


def statements(code: str) -> Iterator[Mutant]:
    """Calls and assignments, which are left out."""
    for found in re.finditer(r"(?:[;{})]|\belse)\s*\n\s*", code):
        begin = found.end()
        if STATEMENT.match(code, begin) and not NO_STATEMENT.match(code, begin):
            end = closing(code, begin, ";")
            if end > 0:
                kind = "connection" if CONNECTION.match(code, begin) else "statement"
                yield Mutant(kind, begin, end + 1, ";")
