# SPDX-License-Identifier: MIT
from __future__ import annotations

import functools
import math
from typing import Any, Iterator, NamedTuple, Sequence

import dask.array as da
import numpy as np

from .. import _clip
from ._graph import array_of, objects


class Pieces(NamedTuple):
    """As `clearcut.Clipped`, but Dask arrays, whose lengths are not known before they are computed."""

    #: Shape (m, 4), the dtype of the input.
    segments: da.Array
    #: Shape (m,), int64: the index of each piece's segment in the whole array.
    source: da.Array
    #: Shape (m,), uint32: as in `clearcut.Clipped`.
    cut: da.Array


def clip(lines: da.Array, window: Sequence[float] | None = None, **options: Any) -> Pieces:
    """Clips a Dask array, chunk by chunk; nothing is computed yet.

    lines: shape (n, 4), float64 or float32, in chunks of rows, whose lengths must be known.
    window and options: those of `clearcut.clip`, in the unit of the lines; each chunk is clipped on one thread unless
        `threads` is given.

    The pieces are in the order of the rows, and chunk i of the result comes from chunk i of `lines`.
    """
    rows = rows_of(lines, window, **options)
    clip_here = functools.partial(clip_chunk, window=window, options=options)
    found = objects("clip", [(clip_here, chunk, first) for chunk, first in chunks_of(rows)], [rows])
    return pieces_of(found, range(found.numblocks[0]), lines.dtype)


def pieces_of(found: da.Array, numbers: Sequence[int], dtype: Any) -> Pieces:
    """The `Clipped`s that are the chunks with these numbers, one after the other, as one."""

    def joined(part: str, dtype: Any, columns: int = 0) -> da.Array:
        tasks = [(getattr, (found.name, i), part) for i in numbers]
        return array_of(part, tasks, [math.nan] * len(tasks), dtype, columns, [found])

    return Pieces(joined("segments", dtype, 4), joined("source", np.int64), joined("cut", np.uint32))


def rows_of(lines: da.Array, window: Any, **options: Any) -> da.Array:
    """The lines in chunks of whole rows. Refuses at once what `clearcut.clip` would."""
    if not isinstance(lines, da.Array):
        raise TypeError(f"lines must be a Dask array of shape (n, 4), but this is {_got(lines)}")
    if lines.ndim != 2 or lines.shape[1] != 4:
        raise ValueError(f"lines must have the shape (n, 4), a row x1, y1, x2, y2 for each, but this is a Dask array of "
                         f"shape {lines.shape} and dtype {lines.dtype}")
    _clip.clip(np.zeros((0, 4), lines.dtype), window, **options)
    if any(math.isnan(size) for size in lines.chunks[0]):
        raise ValueError("the lengths of the chunks must be known; call lines.compute_chunk_sizes() first")
    return lines.rechunk({1: 4})


def chunks_of(rows: da.Array) -> Iterator[tuple[tuple[str, int, int], int]]:
    """The key of each chunk, with the index of its first row."""
    first = 0
    for i, length in enumerate(rows.chunks[0]):
        yield (rows.name, i, 0), first
        first += length


def _got(value: Any) -> str:
    if isinstance(value, np.ndarray):
        return f"an array of shape {value.shape} and dtype {value.dtype}; use dask.array.from_array"
    return f"a {type(value).__name__}"


def clip_chunk(chunk: np.ndarray, first: int, window: Any, options: dict[str, Any]) -> _clip.Clipped:
    chosen: dict[str, Any] = {"threads": 1, **options}
    segments, source, cut = _clip.clip(chunk, window, **chosen)
    # Copies: views would carry the memory of the largest possible result from worker to worker.
    return _clip.Clipped(segments.copy(), source.astype(np.int64) + first, cut.copy())
