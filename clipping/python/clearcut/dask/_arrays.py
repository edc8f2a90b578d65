# SPDX-License-Identifier: MIT
from __future__ import annotations

import math
from typing import Any, Iterator, NamedTuple, Sequence

import dask
import dask.array as da
import numpy as np

from .. import _clip


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
    found = [dask.delayed(clip_chunk)(chunk, first, window, options)
             for chunk, first in chunks_of(lines, window, **options)]
    return pieces_of(found, lines.dtype)


def pieces_of(found: Sequence[Any], dtype: Any) -> Pieces:
    """Delayed `Clipped`s one after the other, as one."""

    def joined(part: str, shape: tuple[float, ...], dtype: Any) -> da.Array:
        arrays = [da.from_delayed(dask.delayed(getattr)(each, part), shape, dtype) for each in found]
        return da.concatenate(arrays) if arrays else da.zeros((0, *shape[1:]), dtype=dtype)

    return Pieces(joined("segments", (math.nan, 4), dtype), joined("source", (math.nan,), np.int64),
                  joined("cut", (math.nan,), np.uint32))


def chunks_of(lines: da.Array, window: Any, **options: Any) -> list[tuple[Any, int]]:
    """Each chunk as a delayed array, with the index of its first row. Refuses at once what `clearcut.clip` would."""
    if not isinstance(lines, da.Array):
        raise TypeError(f"lines must be a Dask array of shape (n, 4), but this is {_got(lines)}")
    if lines.ndim != 2 or lines.shape[1] != 4:
        raise ValueError(f"lines must have the shape (n, 4), a row x1, y1, x2, y2 for each, but this is a Dask array of "
                         f"shape {lines.shape} and dtype {lines.dtype}")
    _clip.clip(np.zeros((0, 4), lines.dtype), window, **options)
    if any(math.isnan(size) for size in lines.chunks[0]):
        raise ValueError("the lengths of the chunks must be known; call lines.compute_chunk_sizes() first")
    rows = lines.rechunk({1: 4})
    return list(zip(rows.to_delayed().reshape(-1), _firsts(rows.chunks[0])))


def _firsts(lengths: Sequence[int]) -> Iterator[int]:
    first = 0
    for length in lengths:
        yield first
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
