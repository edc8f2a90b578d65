# SPDX-License-Identifier: MIT
from __future__ import annotations

import functools
import os
import shutil
import uuid
from typing import Any, Sequence

import dask.array as da
import numpy as np

from .. import _clearcut
from .. import _clip
from . import _results as results
from ._arrays import Pieces, chunks_of, pieces_of, rows_of
from ._files import part_numbers, write_parts, written
from ._graph import objects
from ._outcomes import Task


def clip_at_windows(lines: da.Array, windows: np.ndarray) -> list[Pieces]:
    """The pieces inside each window, with "exact", in one graph; nothing is computed yet. Each chunk is read once for all
    windows, and every worker gets the windows once. All pieces together must fit into the memory of the workers;
    otherwise use `clip_to_tiles`.

    lines: shape (n, 4), float64 or float32, in chunks of rows.
    windows: shape (t, 4), a row xmin, ymin, xmax, ymax for each, as of `grid`, in the unit of the lines. Windows are
        closed: a piece on a common edge is in both tiles.

    >>> import dask.array as da, numpy as np, clearcut.dask
    >>> lines = da.from_array(np.array([[1., 1., 3., 1.]]))
    >>> tiles = clearcut.dask.clip_at_windows(lines, clearcut.dask.grid((0, 0, 4, 3), 2, 1))
    >>> [tile.segments.compute(scheduler="sync").tolist() for tile in tiles]
    [[[1.0, 1.0, 2.0, 1.0]], [[2.0, 1.0, 3.0, 1.0]]]
    """
    edges = _windows(windows)
    rows = rows_of(lines, (0, 0, 1, 1))
    if not len(edges):
        return []
    shared = f"windows-{uuid.uuid4().hex}"
    found = objects("clip", [(_by_tile, chunk, first, shared) for chunk, first in chunks_of(rows)], [rows], {shared: edges})
    keys = [(found.name, i) for i in range(found.numblocks[0])]
    join = functools.partial(_joined, dtype=np.dtype(lines.dtype))
    tiles = objects("join", [(join, keys, tile) for tile in range(len(edges))], [found])
    return [pieces_of(tiles, [tile], lines.dtype) for tile in range(len(edges))]


def clip_to_tiles(lines: da.Array, folder: str, windows: np.ndarray) -> dict[str, Any]:
    """Clips as `clip_at_windows` does, and writes the pieces of each window to files of NumPy in `folder`:
    tile-00000-segments.npy, -source.npy and -cut.npy. Meanwhile the pieces are in a hidden folder of its own in it, so
    that a worker needs the memory of one chunk, or of one tile.

    lines: shape (n, 4), float64 or float32, in chunks of rows.
    folder: made if it is missing. An earlier result in it is removed first. On a cluster all workers must see it.
    windows: shape (t, 4), as of `grid`, in the unit of the lines.

    Returns what it also writes, last of all, to manifest.json: "parts" as `clip_to_files` does, and "tiles", a dict for
    each window with its number, "window", the number of its pieces, and "error": null, or why its files could not be
    written, and then it has none. The pieces of chunks with an error are missing in the tiles. Raises what
    `clip_to_files` raises.
    """
    edges = _windows(windows)
    rows = rows_of(lines, (0, 0, 1, 1))
    between = results.between()
    folder = results.begin(folder, lines, {"parts": part_numbers(rows), "between": between,
                                           "tiles": [{"tile": tile} for tile in range(len(edges))]})
    between = os.path.join(folder, between)
    os.mkdir(between)
    try:
        shared = f"windows-{uuid.uuid4().hex}"
        parts = write_parts(rows, _write_part, between, [shared], {shared: edges})
        good = [os.path.join(between, f'part-{part["part"]:05}') for part in parts if part["error"] is None]
        write = functools.partial(_write_tile, parts=good, dtype=np.dtype(lines.dtype))
        tasks = [Task((write, os.path.join(folder, f"tile-{tile:05}"), tile), {"tile": tile, "window": window}, f"tile {tile}")
                 for tile, window in enumerate(edges.tolist())]
        manifest = {"parts": parts, "tiles": written("tile", tasks, folder)}
    finally:
        shutil.rmtree(between, ignore_errors=True)
    results.finish(folder, manifest)
    return manifest


def _windows(value: Any) -> np.ndarray:
    try:
        windows = np.array(value, dtype=float)
    except (TypeError, ValueError):
        raise TypeError(f"windows must be numbers of shape (t, 4), but this is a {type(value).__name__}") from None
    if windows.ndim != 2 or windows.shape[1] != 4:
        raise ValueError(f"windows must have the shape (t, 4), but this is an array of shape {windows.shape}")
    for window in windows:
        _clearcut.checked_window(window)
    return windows


def _by_tile(chunk: np.ndarray, first: int, windows: np.ndarray) -> dict[int, _clip.Clipped]:
    """The pieces of a chunk in each window that has any. A strip between two x is selected once for all its windows; what
    is selected is clipped whole, so the pieces are those of `clearcut.clip`, bit for bit."""
    segments = _clearcut.checked_segments(chunk)
    edges = windows.astype(segments.dtype)  # as clip rounds them
    strips: dict[tuple[float, float], list[int]] = {}
    for tile, (xmin, _, xmax, _) in enumerate(edges):
        strips.setdefault((xmin, xmax), []).append(tile)
    left, right = np.minimum(segments[:, 0], segments[:, 2]), np.maximum(segments[:, 0], segments[:, 2])
    found = {}
    for (xmin, xmax), tiles in strips.items():
        near = np.flatnonzero((right >= xmin) & (left <= xmax))
        strip = segments[near]
        for tile in tiles:
            pieces, source, cut = _clip.clip(strip, edges[tile], threads=1)
            if len(source):
                found[tile] = _clip.Clipped(pieces.copy(), near[source] + first, cut.copy())
    return found


def _joined(found: Sequence[dict[int, _clip.Clipped]], tile: int, dtype: np.dtype) -> _clip.Clipped:
    here = [pieces[tile] for pieces in found if tile in pieces]
    return _clip.Clipped(*map(np.concatenate, zip(_none(dtype), *here)))


def _none(dtype: np.dtype) -> _clip.Clipped:
    return _clip.Clipped(np.zeros((0, 4), dtype), np.zeros(0, np.int64), np.zeros(0, np.uint32))


def _write_part(chunk: np.ndarray, name: str, first: int, windows: np.ndarray) -> int:
    """The pieces of a chunk, tile after tile; those of tile t are the rows ends[t] to ends[t + 1]."""
    found = _by_tile(chunk, first, windows)
    counts = [len(found[tile].source) if tile in found else 0 for tile in range(len(windows))]
    arrays = _clip.Clipped(*map(np.concatenate, zip(_none(chunk.dtype), *(found[tile] for tile in sorted(found)))))
    results.save(name, **arrays._asdict(), ends=np.cumsum([0, *counts]))
    return sum(counts)


def _write_tile(name: str, tile: int, parts: list[str], dtype: np.dtype) -> int:
    pieces = _clip.Clipped(*map(np.concatenate, zip(_none(dtype), *(_of_tile(part, tile) for part in parts))))
    results.save(name, **pieces._asdict())
    return len(pieces.source)


def _of_tile(part: str, tile: int) -> list[np.ndarray]:
    first, last = np.load(f"{part}-ends.npy", mmap_mode="r")[tile:tile + 2]
    return [np.load(f"{part}-{name}.npy", mmap_mode="r")[first:last] for name in _clip.Clipped._fields]
