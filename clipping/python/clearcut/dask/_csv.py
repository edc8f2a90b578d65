# SPDX-License-Identifier: MIT
"""Tables of segments by byte ranges: Dask reads and splits the files, NumPy reads the numbers."""
from __future__ import annotations

import csv
import functools
import glob
import io
from codecs import BOM_UTF8
from typing import Any, NamedTuple, Sequence

import dask.array as da
import numpy as np
from dask.bytes import read_bytes

from ._graph import alone, array_of, objects
from ._npy import matching

_NAMES = ("x1", "y1", "x2", "y2")


def read_csv(paths: str | Sequence[str], block_size: int | str = "64 MiB") -> da.Array:
    """The segments of tables, one file after the other, as a Dask array of shape (n, 4), float64: a chunk for each byte
    range. Row i of the array is row i of all files together; headers, blank lines, and lines that begin with # before
    the header are no rows.

    paths: a path, a pattern such as "lines-*.csv" (sorted), or a list of paths.
    block_size: the length of a range in bytes, or as text; a worker needs about four times as much memory.

    A file has a header that names the columns x1, y1, x2 and y2, in any order and among others, or none, and then they
    are its first four columns. Fields are separated by commas and may be in quotation marks, but not contain a line
    break, because a range can begin at any line.

    The files are read once now, on the cluster if there is one, to count their rows, and again when the array is
    computed. A range with a row that is not four numbers raises a ValueError then, which names the file and the line;
    `clip_to_files` writes that down and goes on.
    """
    found = matching(paths)
    for name in filter(glob.has_magic, found):
        raise ValueError(f"{name}: a table's name must not contain *, ? or [, which Dask would take for a pattern")
    _, files, names = read_bytes(found, delimiter=b"\n", blocksize=block_size, sample=False, include_path=True)
    reading = {key: task for blocks in files for block in blocks for key, task in block.dask.items()}
    if not reading:
        return da.zeros((0, 4))
    counting = objects("count", [(_count, block.key, i == 0) for blocks in files for i, block in enumerate(blocks)],
                       more=reading)
    counts = iter(counting.compute())
    tasks, lengths = [], []
    for blocks, name in zip(files, names):
        line, columns = 1, None
        for block in blocks:
            count = next(counts)
            columns = columns or _columns(count.head, name)
            of_block = functools.partial(_rows, name=name, line=line + count.head_lines, columns=columns, count=count)
            tasks.append((of_block, block.key))
            lengths.append(count.rows)
            line += count.head_lines + count.lines
    return array_of("read-csv", tasks, lengths, float, 4, more=reading)


class _Count(NamedTuple):
    rows: int
    lines: int  # with blank ones, without those of the head
    head: list[str] | None  # the fields of the first row of a file
    head_bytes: int  # before the first row of numbers
    head_lines: int


def _count(block: bytes, first: bool) -> np.ndarray:
    head, size, head_lines = _head(block) if first else (None, 0, 0)
    text = np.frombuffer(block, np.uint8)[size:]
    ends = np.flatnonzero(text == ord("\n"))
    if len(text) and text[-1] != ord("\n"):
        ends = np.append(ends, len(text))
    lengths = np.diff(ends, prepend=-1) - 1
    returns = text[ends - 1] == ord("\r") if len(text) else lengths  # line breaks of Windows
    blank = (lengths == 0) | ((lengths == 1) & (returns == 1))
    return alone(_Count(len(ends) - int(np.count_nonzero(blank)), len(ends), head, size, head_lines))


def _head(block: bytes) -> tuple[list[str] | None, int, int]:
    """The fields of the first row, and the bytes and lines before the first row of numbers."""
    size, lines = len(BOM_UTF8) * block.startswith(BOM_UTF8), 0
    file = io.BytesIO(block)
    file.seek(size)
    for line in file:
        text = line.decode("latin1").strip()
        if text and not text.startswith("#"):
            fields = _fields(text)
            is_header = not _is_number(fields[0])
            return fields, size + is_header * len(line), lines + is_header
        size += len(line)
        lines += 1
    return None, size, lines


def _columns(head: list[str] | None, name: str) -> list[int]:
    """Where x1, y1, x2 and y2 are."""
    if head is None or _is_number(head[0]):
        return [0, 1, 2, 3]
    names = [field.strip().lower() for field in head]
    if any(names.count(column) != 1 for column in _NAMES):
        raise ValueError(f"{name}: the first row must be four numbers or a header that names x1, y1, x2 and y2 once, "
                         f"but it is {','.join(head)[:100]!r}")
    return [names.index(column) for column in _NAMES]


def _rows(block: bytes, name: str, line: int, columns: list[int], count: _Count) -> np.ndarray:
    body = block[count.head_bytes:]
    if count.rows == 0:
        return np.zeros((0, 4))
    if b'"' in body:
        _refuse_open_quotes(body, name, line)
    try:
        rows = np.loadtxt(io.BytesIO(body), float, delimiter=",", quotechar='"', comments=None, usecols=columns, ndmin=2,
                          encoding="latin1")
    except ValueError as error:
        raise ValueError(_fault(body, name, line, columns) or f"{name}, from line {line} on: {error}") from None
    if len(rows) != count.rows:
        raise ValueError(f"{name}, from line {line} on: {len(rows)} rows are there, but {count.rows} were counted")
    return rows


def _refuse_open_quotes(body: bytes, name: str, line: int) -> None:
    for i, text in enumerate(body.split(b"\n")):
        if text.count(b'"') % 2:
            raise ValueError(f"{name}, line {line + i}: a quoted field must not contain a line break, because the file is "
                             "read by ranges")


def _fault(body: bytes, name: str, line: int, columns: list[int]) -> str | None:
    """What is wrong with the first row that is not four numbers."""
    for i, raw in enumerate(body.split(b"\n")):
        text = raw.decode("latin1").removesuffix("\r")
        fields = _fields(text)
        if fields and not all(column < len(fields) and _is_number(fields[column]) for column in columns):
            return f"{name}, line {line + i}: four numbers are needed, but this is {text[:60]!r}"
    return None


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
