# SPDX-License-Identifier: MIT
"""A byte range of a table, which begins and ends between two lines."""
from __future__ import annotations

import csv
import io
from codecs import BOM_UTF8
from typing import NamedTuple, Sequence

import numpy as np

from ._graph import alone

_NAMES = ("x1", "y1", "x2", "y2")


class Head(NamedTuple):
    """What comes before the first row of numbers, if no row came before the range."""

    #: Of the first row, which may be a header; None if there are only blank lines and comments.
    fields: list[str] | None
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
    fields, size = _head(block, begin)
    text = np.frombuffer(block, np.uint8)  # parts of it are no copies
    rows, lines = _rows_and_lines(text[begin:size])
    rows_below, lines_below = _rows_and_lines(text[size:])
    return alone(Count(rows + rows_below, lines + lines_below, Head(fields, size, lines, rows)))


def _rows_and_lines(text: np.ndarray) -> tuple[int, int]:
    """How many lines are not blank, and how many there are."""
    ends = np.flatnonzero(text == ord("\n"))
    if len(text) and text[-1] != ord("\n"):
        ends = np.append(ends, len(text))
    lengths = np.diff(ends, prepend=-1) - 1
    returns = text[ends - 1] == ord("\r") if len(text) else lengths  # line breaks of Windows
    blank = (lengths == 0) | ((lengths == 1) & (returns == 1))
    return len(ends) - int(np.count_nonzero(blank)), len(ends)


def _head(block: bytes, size: int) -> tuple[list[str] | None, int]:
    """The fields of the first row from byte `size` on, and the bytes before the first row of numbers."""
    file = io.BytesIO(block)
    file.seek(size)
    for line in file:
        text = line.decode("latin1").strip()
        if text and not text.startswith("#"):
            fields = _fields(text)
            return fields, size + len(line) * (not _is_number(fields[0]))
        size += len(line)
    return None, size


def columns_of(head: list[str], path: str) -> list[int]:
    """Where x1, y1, x2 and y2 are."""
    if _is_number(head[0]):
        return [0, 1, 2, 3]
    names = [field.strip().lower() for field in head]
    if any(names.count(column) != 1 for column in _NAMES):
        raise ValueError(f"{path}: the first row must be four numbers or a header that names x1, y1, x2 and y2 once, "
                         f"but it is {_shown(','.join(head), 100)}")
    return [names.index(column) for column in _NAMES]


def rows_of_numbers(block: bytes, path: str, line: int, columns: Sequence[int], size: int, rows: int) -> np.ndarray:
    """The rows of a range, shape (rows, 4). size: of the head; line: the number of the first line after it."""
    body = block[size:]
    if rows == 0:
        return np.zeros((0, 4))
    if b'"' in body:
        _refuse_open_quotes(body, path, line)
    try:
        found = np.loadtxt(io.BytesIO(body), float, delimiter=",", quotechar='"', comments=None, usecols=columns, ndmin=2,
                          encoding="latin1")
    except ValueError as error:
        raise ValueError(_fault(body, path, line, columns) or f"{path}, from line {line} on: {error}") from None
    if len(found) != rows:
        raise ValueError(f"{path}, from line {line} on: rows that were counted: {rows}; rows that are there: {len(found)}")
    return found


def _refuse_open_quotes(body: bytes, path: str, line: int) -> None:
    for i, text in enumerate(body.split(b"\n")):
        if text.count(b'"') % 2:
            raise ValueError(f"{path}, line {line + i}: a quoted field must not contain a line break, because the file is "
                             "read by ranges")


def _fault(body: bytes, path: str, line: int, columns: Sequence[int]) -> str | None:
    """What is wrong with the first row that is not four numbers."""
    for i, raw in enumerate(body.split(b"\n")):
        text = raw.decode("latin1").removesuffix("\r")
        fields = _fields(text)
        if fields and not all(column < len(fields) and _is_number(fields[column]) for column in columns):
            return f"{path}, line {line + i}: four numbers are needed, but this is {_shown(text, 60)}"
    return None


def _shown(text: str, length: int) -> str:
    """A text of a file for a message: read as latin1, so that every byte is a character, but most files are UTF-8."""
    return repr(text.encode("latin1").decode("utf-8", "replace")[:length])


def _fields(text: str) -> list[str]:
    try:
        return next(csv.reader([text.replace("\0", " ")]), [])
    except csv.Error:  # a field that is too long
        return text.split(",")


def _is_number(field: str) -> bool:
    try:
        float(field)
    except ValueError:
        return False
    return "_" not in field
