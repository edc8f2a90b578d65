# SPDX-License-Identifier: MIT
"""Tables of segments by byte ranges: Dask reads and splits the files, `_table` reads the ranges."""
from __future__ import annotations

import functools
import glob
from typing import Any, Iterable, Sequence

import dask.array as da
import numpy as np
from dask.bytes import read_bytes
from dask.utils import parse_bytes

from ._graph import array_of, objects
from ._npy import matching
from ._table import Count, Head, count, layout_of, rows_of_numbers


def read_csv(paths: str | Sequence[str], block_size: int | str = "64 MiB") -> da.Array:
    """The segments of tables, one file after the other, as a Dask array of shape (n, 4), float64: a chunk for each byte
    range. Row i of the array is row i of all files together; headers, blank lines, and lines that begin with # before
    the header are no rows.

    paths: a path, a pattern such as "lines-*.csv" (sorted), or a list of paths.
    block_size: the length of a range in bytes, from 1 on, or as text; a worker needs about four times as much memory.

    A file has a header that names the columns x1, y1, x2 and y2 (or x0, y0, x1, y1; start_x, start_y, end_x, end_y, and
    the like), in any order and among others, or none, and then they are its first four columns. Fields are separated by
    commas, or by semicolons, tabs or blanks, and then a comma in a number is a decimal comma. They may be in quotation
    marks, but not contain a line break, because a range can begin at any line.

    The files are read once now, on the cluster if there is one, to count their rows, and again when the array is
    computed. A first row that is neither a header nor four numbers raises a ValueError now, which names all such files.
    A range with another row that is not four numbers raises one when it is computed, which names the file and the line;
    `clip_to_files` writes that down and goes on.
    """
    found = matching(paths)
    for name in found:
        if glob.has_magic(name) or "::" in name:
            raise ValueError(f"{name}: a table's name must not contain *, ?, [ or ::, which have a meaning for Dask")
    _, files, names = read_bytes(found, delimiter=b"\n", blocksize=_length(block_size), sample=False, include_path=True)
    reading = {key: task for blocks in files for block in blocks for key, task in block.dask.items()}
    if not reading:
        return da.zeros((0, 4))
    counting = objects("count", [(count, block.key, i == 0) for blocks in files for i, block in enumerate(blocks)],
                       more=reading)
    counts = iter(counting.compute())
    planned: list[tuple[tuple[Any, ...], int]] = []
    faults: list[str] = []
    for blocks, name in zip(files, names):
        try:
            planned += _planned([block.key for block in blocks], [next(counts) for _ in blocks], name)
        except ValueError as error:
            faults.append(str(error))
    if faults:
        raise ValueError("\n".join(faults))
    return array_of("read-csv", [task for task, _ in planned], [rows for _, rows in planned], float, 4, more=reading)


def _length(block_size: Any) -> int:
    whole = isinstance(block_size, (int, np.integer)) and not isinstance(block_size, bool)
    length = int(block_size) if whole else parse_bytes(block_size) if isinstance(block_size, str) else 0
    if length < 1:
        raise ValueError(f"block_size must be a whole number of bytes from 1 on, or a text such as '64 MiB', but this is "
                         f"{block_size!r}")
    return length


def _planned(keys: Sequence[str], counts: Iterable[Count], path: str) -> list[tuple[tuple[Any, ...], int]]:
    """The tasks that read a file, with the number of rows of each. While there was no row, the head goes on."""
    line, layout = 1, None
    planned: list[tuple[tuple[Any, ...], int]] = []
    for key, block in zip(keys, counts):
        head = block.head if layout is None else Head(None, 0, 0, 0)
        if head.text is not None:
            layout = layout_of(head.text, path)
        rows = block.rows - head.rows
        read = functools.partial(rows_of_numbers, path=path, line=line + head.lines, layout=layout, size=head.size, rows=rows)
        planned.append(((read, key), rows))
        line += block.lines
    return planned
