# SPDX-License-Identifier: MIT
"""A byte range of a table, which begins and ends between two lines."""
from __future__ import annotations

import csv
import io
import re
from codecs import BOM_UTF8
from typing import NamedTuple

import numpy as np

from ._graph import alone

#: Of the columns, as a header writes them, without capitals and what separates words. The first that it holds whole count.
_NAMES = (("x1", "y1", "x2", "y2"), ("x0", "y0", "x1", "y1"), ("xa", "ya", "xb", "yb"), ("ax", "ay", "bx", "by"),
          ("startx", "starty", "endx", "endy"), ("xstart", "ystart", "xend", "yend"), ("fromx", "fromy", "tox", "toy"),
          ("xfrom", "yfrom", "xto", "yto"), ("p1x", "p1y", "p2x", "p2y"), ("x", "y", "x2", "y2"))
_BETWEEN_WORDS = str.maketrans("", "", " \t_-.")


class Layout(NamedTuple):
    """How a table is written. With other separators than commas, a comma in a number is a decimal comma."""

    #: Of the fields; None: any blanks.
    separator: str | None
    #: Where the coordinates are.
    columns: list[int]


class Head(NamedTuple):
    """What comes before the first row of numbers, if no row came before the range."""

    #: The first row, which may be a header; None if there are only blank lines and comments.
    text: str | None
    #: In bytes.
    size: int
    lines: int
    #: How many of the lines are not blank.
    rows: int


class Count(NamedTuple):
    #: With those of the head.
    rows: int
    #: With blank ones, and with those of the head.
    lines: int
    head: Head


def count(block: bytes, first: bool) -> np.ndarray:
    """The Count of a range, alone. first: the range is the first one of its file."""
    begin = len(BOM_UTF8) if first and block.startswith(BOM_UTF8) else 0
    first_row, size = _head(block, begin)
    text = np.frombuffer(block, np.uint8)  # parts of it are no copies
    rows, lines = _rows_and_lines(text[begin:size])
    rows_below, lines_below = _rows_and_lines(text[size:])
    return alone(Count(rows + rows_below, lines + lines_below, Head(first_row, size, lines, rows)))


def _rows_and_lines(text: np.ndarray) -> tuple[int, int]:
    """How many lines are not blank, and how many there are."""
    ends = np.flatnonzero(text == ord("\n"))
    if len(text) and text[-1] != ord("\n"):
        ends = np.append(ends, len(text))
    lengths = np.diff(ends, prepend=-1) - 1
    returns = text[ends - 1] == ord("\r") if len(text) else lengths  # line breaks of Windows
    blank = (lengths == 0) | ((lengths == 1) & (returns == 1))
    return len(ends) - int(np.count_nonzero(blank)), len(ends)


def _head(block: bytes, size: int) -> tuple[str | None, int]:
    """The first row from byte `size` on, and the bytes before the first row of numbers."""
    file = io.BytesIO(block)
    file.seek(size)
    for line in file:
        text = line.decode("latin1").strip()
        if text and not text.startswith("#"):
            return text, size + len(line) * (not _is_number(re.split('[",;\\s]', text.lstrip('"'))[0]))
        size += len(line)
    return None, size


def layout_of(head: str, path: str) -> Layout:
    """The layout of a table with this first row."""
    for separator in (",", ";", "\t", None):
        fields = _fields(head, separator)
        if len(fields) > 3 and all(_is_number(field, separator) for field in fields[:4]):
            return Layout(separator, [0, 1, 2, 3])
        names = [field.lower().translate(_BETWEEN_WORDS) for field in fields]
        for wanted in _NAMES:
            if all(names.count(name) == 1 for name in wanted):
                return Layout(separator, [names.index(name) for name in wanted])
    if _is_number(_fields(head, ",")[0]):
        return Layout(",", [0, 1, 2, 3])  # a row that is refused when it is read
    raise ValueError(f"{path}: the first row must be four numbers or a header that names x1, y1, x2 and y2 once, but it is "
                     f"{_shown(head, 100)}")


def rows_of_numbers(block: bytes, path: str, line: int, layout: Layout, size: int, rows: int) -> np.ndarray:
    """The rows of a range, shape (rows, 4). size: of the head; line: the number of the first line after it."""
    body = block[size:]
    if rows == 0:
        return np.zeros((0, 4))
    if b'"' in body:
        _refuse_open_quotes(body, path, line)
    pointed = _pointed(body, path, line, layout)
    try:
        found = np.loadtxt(io.BytesIO(pointed), float, delimiter=layout.separator, quotechar='"',
                          comments=None, usecols=layout.columns, ndmin=2, encoding="latin1")
    except ValueError as error:
        raise ValueError(_fault(body, path, line, layout) or f"{path}, from line {line} on: {error}") from None
    if len(found) != rows:
        raise ValueError(f"{path}, from line {line} on: rows that were counted: {rows}; rows that are there: {len(found)}")
    return found


def _refuse_open_quotes(body: bytes, path: str, line: int) -> None:
    for i, text in enumerate(body.split(b"\n")):
        if text.count(b'"') % 2:
            raise ValueError(f"{path}, line {line + i}: a quoted field must not contain a line break, because the file is "
                             "read by ranges")


def _pointed(body: bytes, path: str, line: int, layout: Layout) -> bytes:
    """The rows with decimal points. Where a row has points as well, its commas may separate thousands."""
    if layout.separator == "," or b"," not in body:
        return body
    for i, raw in enumerate(body.split(b"\n") if b"." in body else []):
        fields = _fields(raw.decode("latin1"), layout.separator)
        numbers = "".join(fields[column] for column in layout.columns if column < len(fields))
        if "," in numbers and "." in numbers:
            raise ValueError(f"{path}, line {line + i}: this has both decimal commas and points: "
                             f"{_shown(raw.decode('latin1'), 60)}")
    return body.replace(b",", b".")


def _fault(body: bytes, path: str, line: int, layout: Layout) -> str | None:
    """What is wrong with the first row that is not four numbers."""
    for i, raw in enumerate(body.split(b"\n")):
        text = raw.decode("latin1").removesuffix("\r")
        fields = _fields(text, layout.separator)
        if fields and not all(column < len(fields) and _is_number(fields[column], layout.separator) for column in layout.columns):
            return f"{path}, line {line + i}: four numbers are needed, but this is {_shown(text, 60)}"
    return None


def _shown(text: str, length: int) -> str:
    """A text of a file for a message: read as latin1, so that every byte is a character, but most files are UTF-8."""
    return repr(text.encode("latin1").decode("utf-8", "replace")[:length])


def _fields(text: str, separator: str | None) -> list[str]:
    blanks = separator is None
    try:
        fields = next(csv.reader([text.replace("\0", " ").replace("\t", " " if blanks else "\t")], delimiter=separator or " ",
                                 skipinitialspace=blanks), [])
    except csv.Error:  # a field that is too long
        return text.split(separator)
    return [field for field in fields if field] if blanks else fields


def _is_number(field: str, separator: str | None = ",") -> bool:
    try:
        float(field if separator == "," else field.replace(",", "."))
    except ValueError:
        return False
    return "_" not in field
