# SPDX-License-Identifier: MIT
from __future__ import annotations

import functools
import os
import shutil
import uuid
from typing import Any, Sequence

import dask.array as da
import numpy as np

from .. import _arguments as arguments
from .. import _clip
from ._arrays import Pieces, chunks_of, pieces_of, rows_of
from ._graph import alone, objects
from ._files import save, says, write_manifest, write_parts


def grid(window: Sequence[float], columns: int, rows: int) -> np.ndarray:
    """The windows of a grid of tiles, shape (rows * columns, 4): row by row from ymin on, in each from xmin on.
    Neighbours share the numbers of their common edge.

    window: (xmin, ymin, xmax, ymax), which the tiles fill.
    columns, rows: how many tiles lie side by side, and one above the other.

    >>> import clearcut.dask
    >>> clearcut.dask.grid((0, 0, 4, 3), 2, 1)
    array([[0., 0., 2., 3.],
           [2., 0., 4., 3.]])
    """
    xmin, ymin, xmax, ymax = arguments.window(window)
    for name, count in (("columns", columns), ("rows", rows)):
        if isinstance(count, bool) or not isinstance(count, (int, np.integer)) or count < 1:
            raise ValueError(f"{name} must be a whole number from 1 on, but this is {count!r}")
    x, y = np.linspace(xmin, xmax, columns + 1), np.linspace(ymin, ymax, rows + 1)
    left, bottom = np.meshgrid(x[:-1], y[:-1])
    right, top = np.meshgrid(x[1:], y[1:])
    return np.stack([left, bottom, right, top], axis=-1).reshape(-1, 4)


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
    tile-00000-segments.npy, -source.npy and -cut.npy. Meanwhile the pieces are in the folder "parts" in it, so that a
    worker needs the memory of one chunk, or of one tile.

    lines: shape (n, 4), float64 or float32, in chunks of rows.
    folder: made if it is missing. On a cluster all workers must see it.
    windows: shape (t, 4), as of `grid`, in the unit of the lines.

    Returns what it also writes to manifest.json: "parts" as `clip_to_files` does, and "tiles", a dict for each window
    with its number, "window", the number of its pieces, and "error": null, or why its files could not be written. The
    pieces of chunks with an error are missing in the tiles.
    """
    edges = _windows(windows)
    rows = rows_of(lines, (0, 0, 1, 1))
    folder = os.path.abspath(folder)  # for workers in other folders
    between = os.path.join(folder, "parts")
    os.makedirs(between, exist_ok=True)
    shared = f"windows-{uuid.uuid4().hex}"
    parts = write_parts(rows, _write_part, between, [shared], {shared: edges})
    good = [os.path.join(between, f'part-{part["part"]:05}') for part in parts if part["error"] is None]
    write = functools.partial(_write_tile, parts=good, dtype=np.dtype(lines.dtype))
    tasks = [(write, os.path.join(folder, f"tile-{tile:05}"), tile) for tile in range(len(edges))]
    written = objects("tile", tasks).compute() if tasks else []
    tiles = [{"tile": tile, "window": window, **result}
             for tile, (window, result) in enumerate(zip(edges.tolist(), written))]
    if all(tile["error"] is None for tile in tiles):
        shutil.rmtree(between)
    manifest = {"parts": parts, "tiles": tiles}
    write_manifest(folder, manifest)
    return manifest


def _windows(value: Any) -> np.ndarray:
    try:
        windows = np.array(value, dtype=float)
    except (TypeError, ValueError):
        raise TypeError(f"windows must be numbers of shape (t, 4), but this is a {type(value).__name__}") from None
    if windows.ndim != 2 or windows.shape[1] != 4:
        raise ValueError(f"windows must have the shape (t, 4), but this is an array of shape {windows.shape}")
    for window in windows:
        arguments.window(window)
    return windows


def _by_tile(chunk: np.ndarray, first: int, windows: np.ndarray) -> dict[int, _clip.Clipped]:
    """The pieces of a chunk in each window that has any. A strip between two x is selected once for all its windows; what
    is selected is clipped whole, so the pieces are those of `clearcut.clip`, bit for bit."""
    segments = arguments.segments(chunk)
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
    save(name, **arrays._asdict(), ends=np.cumsum([0, *counts]))
    return sum(counts)


def _write_tile(name: str, tile: int, parts: list[str], dtype: np.dtype) -> np.ndarray:
    try:
        pieces = _clip.Clipped(*map(np.concatenate, zip(_none(dtype), *(_of_tile(part, tile) for part in parts))))
        save(name, **pieces._asdict())
    except Exception as error:  # also a full disk or too little memory
        return alone({"pieces": 0, "error": f"tile {tile}: {says(error)}"})
    return alone({"pieces": len(pieces.source), "error": None})


def _of_tile(part: str, tile: int) -> list[np.ndarray]:
    first, last = np.load(f"{part}-ends.npy", mmap_mode="r")[tile:tile + 2]
    return [np.load(f"{part}-{name}.npy", mmap_mode="r")[first:last] for name in _clip.Clipped._fields]
