# SPDX-License-Identifier: MIT
"""Clips arrays that are larger than memory, or on several computers, with Dask. Needs dask; clusters need distributed.

Each chunk is clipped on its own by `clearcut.clip`, on the worker that has it. So a worker that is lost loses nothing:
Dask clips its chunks again elsewhere, and the result has the same bits.

>>> import dask.array as da, numpy as np, clearcut.dask
>>> lines = da.from_array(np.array([[-5., 5., 15., 5.], [20., 20., 30., 30.], [1., 1., 2., 2.]]), chunks=(2, 4))
>>> pieces = clearcut.dask.clip(lines, (0, 0, 10, 10))
>>> pieces.segments.compute(scheduler="sync")
array([[ 0.,  5., 10.,  5.],
       [ 1.,  1.,  2.,  2.]])
>>> pieces.source.compute(scheduler="sync")
array([0, 2])
"""
from __future__ import annotations

import json
import math
import os
import pathlib
import uuid
from typing import Any, NamedTuple, Sequence

import numpy as np

from . import _arguments as arguments
from . import _clip

try:
    import dask
    import dask.array as da
except ImportError:
    raise ImportError("clearcut.dask needs dask (Debian: python3-dask)") from None


class Pieces(NamedTuple):
    """As `clearcut.Clipped`, but Dask arrays, whose lengths are not known before they are computed."""

    #: Shape (m, 4), the dtype of the input.
    segments: da.Array
    #: Shape (m,), int64: the index of each piece's segment in the whole array.
    source: da.Array
    #: Shape (m,), uint32: as in `clearcut.Clipped`.
    cut: da.Array


def clip(lines: da.Array, window: Sequence[float] | None = None, **options: Any) -> Pieces:
    """Clips a Dask array of shape (n, 4), float64 or float32, in chunks of rows; nothing is computed yet.

    window and options are those of `clearcut.clip`; each chunk is clipped on one thread unless `threads` is given.
    The pieces are in the order of the rows, and chunk i of the result comes from chunk i of `lines`.
    """
    found = [_pieces_of(chunk, first, window, options) for chunk, first in _chunks(lines, window, options)]

    def joined(part: str, shape: tuple[float, ...], dtype: Any) -> da.Array:
        arrays = [da.from_delayed(dask.delayed(getattr)(each, part), shape, dtype) for each in found]
        return da.concatenate(arrays) if arrays else da.zeros((0, *shape[1:]), dtype=dtype)

    return Pieces(joined("segments", (math.nan, 4), lines.dtype), joined("source", (math.nan,), np.int64),
                  joined("cut", (math.nan,), np.uint32))


def clip_to_files(lines: da.Array, folder: str, window: Sequence[float] | None = None, **options: Any) -> dict[str, Any]:
    """Clips as `clip` does, and writes the pieces of each chunk to files of NumPy in `folder`: part-00000-segments.npy,
    -source.npy and -cut.npy. No chunk passes through the caller. A file is there only when it is complete, and only if
    its part has no error.

    Returns what it also writes to manifest.json: "parts", a dict for each chunk with its number, the index of its
    first row, the number of its pieces, and "error": null, or why the chunk could not be loaded, clipped or written.
    The other chunks are written all the same; if a chunk cannot be loaded, some of them are clipped again for that.
    Raises an error only for wrong arguments, or if the folder or the manifest cannot be written.
    """
    os.makedirs(folder, exist_ok=True)
    tasks = [_Task(number, first, dask.delayed(_write)(chunk, number, first, folder, window, options))
             for number, (chunk, first) in enumerate(_chunks(lines, window, options))]
    try:
        manifest = {"parts": _computed(tasks)}
    finally:
        _remove(folder, "part-*.unfinished")  # of workers that were lost
    for part in manifest["parts"]:
        if part["error"] is not None:
            _remove(folder, f'part-{part["part"]:05}-*.npy')
    _replace(os.path.join(folder, "manifest.json"), lambda file: file.write(json.dumps(manifest, indent=1).encode()))
    return manifest


class _Task(NamedTuple):
    number: int
    first: int
    part: Any  # delayed


def _computed(tasks: list[_Task]) -> list[dict[str, Any]]:
    """The parts of the manifest. Dask gives up all tasks if one chunk cannot be loaded; then each half is computed on
    its own, until the chunk is found."""
    try:
        return list(dask.compute(*(task.part for task in tasks)))
    except Exception as error:
        if len(tasks) == 1:
            return [_failed(tasks[0].number, tasks[0].first, error)]
    half = len(tasks) // 2
    return _computed(tasks[:half]) + _computed(tasks[half:])


def _failed(number: int, first: int, error: Exception) -> dict[str, Any]:
    kind = [] if isinstance(error, (TypeError, ValueError)) else [type(error).__name__]
    says = ": ".join([f"chunk {number}", *kind, *filter(None, [str(error)])])
    return {"part": number, "first": first, "pieces": 0, "error": says}


def _chunks(lines: da.Array, window: Any, options: dict[str, Any]) -> list[tuple[Any, int]]:
    """Each chunk as a delayed array, with the index of its first row."""
    if not isinstance(lines, da.Array):
        raise TypeError(f"lines must be a Dask array of shape (n, 4), but this is a {type(lines).__name__}")
    _clip.clip(np.zeros((0, *lines.shape[1:]), lines.dtype), window, **options)  # refuses what is wrong at once
    if any(math.isnan(size) for size in lines.chunks[0]):
        raise ValueError("the lengths of the chunks must be known; call lines.compute_chunk_sizes() first")
    rows = lines.rechunk({1: 4})
    firsts = np.concatenate([[0], np.cumsum(rows.chunks[0], dtype=np.int64)])
    return [(chunk, int(first)) for chunk, first in zip(rows.to_delayed().reshape(-1), firsts)]


def _pieces_of(chunk: Any, first: int, window: Any, options: dict[str, Any]) -> Any:
    return dask.delayed(_clip_chunk)(chunk, first, window, options)


def _clip_chunk(chunk: np.ndarray, first: int, window: Any, options: dict[str, Any]) -> _clip.Clipped:
    segments, source, cut = _clip.clip(chunk, window, **{"threads": 1, **options})
    # Copies: views would carry the memory of the largest possible result from worker to worker.
    return _clip.Clipped(segments.copy(), source.astype(np.int64) + first, cut.copy())


def _write(chunk: Any, number: int, first: int, folder: str, window: Any, options: dict[str, Any]) -> dict[str, Any]:
    try:
        pieces = _clip_chunk(arguments.segments(chunk), first, window, options)
        for name, array in pieces._asdict().items():
            _replace(os.path.join(folder, f"part-{number:05}-{name}.npy"), lambda file, array=array: np.save(file, array))
    except Exception as error:  # also a full disk or too little memory
        return _failed(number, first, error)
    return {"part": number, "first": first, "pieces": len(pieces.source), "error": None}


def _replace(path: str, write: Any) -> None:
    unfinished = f"{path}.{uuid.uuid4().hex}.unfinished"  # a chunk may be clipped on two workers at once
    try:
        with open(unfinished, "wb") as file:
            write(file)
        os.replace(unfinished, path)
    finally:
        pathlib.Path(unfinished).unlink(missing_ok=True)


def _remove(folder: str, pattern: str) -> None:
    for path in pathlib.Path(folder).glob(pattern):
        path.unlink(missing_ok=True)
