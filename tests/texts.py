#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every text of the program can be translated: Qt's lupdate finds it, in the one context of
app/base/text.h. Usage: tests/texts.py LUPDATE ROOT"""
import pathlib
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

LITERAL = r'"(?:\\.|[^"\\\n])*"'
TEXT = re.compile(r'(?:\bText::tr\(|\bQT_TRANSLATE_NOOP\(\s*"Text",)\s*(%s(?:\s*%s)*)' % (LITERAL, LITERAL))
OTHER = re.compile(r'(?<![\w:.>])tr\(\s*"|\btranslate\(\s*"|QT_TRANSLATE_NOOP\(\s*"(?!Text")|QT_TR_NOOP')
ESCAPES = {"n": "\n", "t": "\t", '"': '"', "\\": "\\"}


def value(literals):
    """The text of adjacent literals."""
    joined = "".join(literal[1:-1] for literal in re.findall(LITERAL, literals))
    joined = re.sub(r"\\u([0-9A-Fa-f]{4})", lambda m: chr(int(m[1], 16)), joined)
    return re.sub(r"\\(.)", lambda m: ESCAPES[m[1]], joined)


def main(lupdate, root):
    found = set()
    with tempfile.TemporaryDirectory() as work:
        file = pathlib.Path(work, "found.ts")
        subprocess.run([lupdate, "-silent", "-I", ".", "app", "ui", "-ts", file], cwd=root,
                       check=True, stderr=subprocess.DEVNULL)
        for context in xml.etree.ElementTree.parse(file).getroot().iter("context"):
            if context.findtext("name") == "Text":
                found |= {source.text for source in context.iter("source")}
    faults, count = [], 0
    for path in sorted(p for room in ("app", "ui") for p in (root / room).rglob("*.[ch]*")):
        code = re.sub(r"\s//[^\n]*|(?<=Text::)\s+", "", path.read_text(encoding="utf-8"))
        texts = [value(match[1]) for match in TEXT.finditer(code)]
        count += len(texts)
        faults += [f"{path}: lupdate does not find “{text}”" for text in texts if text not in found]
        faults += [f"{path}: use Text::tr rather than {other}" for other in OTHER.findall(code)]
    print(*faults, f"{count} texts", sep="\n")
    return 1 if faults or count == 0 else 0


sys.exit(main(sys.argv[1], pathlib.Path(sys.argv[2]).resolve()))
