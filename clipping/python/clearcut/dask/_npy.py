# SPDX-License-Identifier: MIT
from __future__ import annotations

import functools
import glob
import os
from typing import Any, Sequence

import dask.array as da
import numpy as np

from .. import _clearcut
from ._graph import array_of


def read_npy(paths: str | Sequence[str], rows: int = 1_000_000) -> da.Array:
    """The segments of files of NumPy, one file after the other, as a Dask array of shape (n, 4). Only their headers are
    read now. Each chunk is read by the worker that clips it, so all workers must see the files.

    paths: a path, a pattern such as "lines-*.npy" (sorted), or a list of paths. Each file holds an array (n, 4), all of
        float64 or all of float32.
    rows: how many rows a chunk has at most; a row of float64 is 32 bytes.
    """
    if isinstance(rows, bool) or not isinstance(rows, (int, np.integer)) or rows < 1:
        raise ValueError(f"rows must be a whole number from 1 on, but this is {rows!r}")
    chunks = []
    for path in matching(paths):
        array = _opened(path)
        read = functools.partial(_rows, path=path, length=len(array), dtype=array.dtype)
        chunks += [(read, first, min(first + int(rows), len(array)), array.dtype)
                   for first in range(0, len(array), int(rows))]
    dtypes = {dtype for *_, dtype in chunks}
    if len(dtypes) > 1:
        raise TypeError("the files must be all float64 or all float32, but these are " +
                        " and ".join(sorted(map(str, dtypes))))
    if not chunks:
        return da.zeros((0, 4))
    return array_of("read-npy", [(read, first, last) for read, first, last, _ in chunks],
                    [last - first for _, first, last, _ in chunks], dtypes.pop(), 4)


def matching(paths: Any) -> list[str]:
    """The files that are meant, with paths for workers in other folders; FileNotFoundError for patterns without a file."""
    found: list[str] = []
    lost: list[str] = []
    for path in map(os.fspath, [paths] if isinstance(paths, (str, os.PathLike)) else paths):
        files = sorted(glob.glob(path)) if glob.has_magic(path) and not os.path.exists(path) else [path]
        found += files
        lost += [] if files else [path]
    if lost or not found:
        raise FileNotFoundError(f"no file matches {', '.join(map(repr, lost)) or repr(paths)}")
    return [path if "://" in path else os.path.abspath(path) for path in found]


def _opened(path: str) -> np.ndarray:
    try:
        return _clearcut.checked_segments(np.load(path, mmap_mode="r"))
    except (TypeError, ValueError, EOFError) as error:
        raise ValueError(f"{path}: {error}") from None


def _rows(first: int, last: int, path: str, length: int, dtype: np.dtype) -> np.ndarray:
    array = _opened(path)
    if len(array) != length or array.dtype != dtype:
        raise ValueError(f"{path} was an array of shape ({length}, 4) and dtype {dtype} when it was planned, but now it has "
                         f"the shape {array.shape} and dtype {array.dtype}")
    return np.array(array[first:last])
