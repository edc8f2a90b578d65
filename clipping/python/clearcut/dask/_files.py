# SPDX-License-Identifier: MIT
"""Results as files of NumPy, with a manifest that says of each part whether it is there."""
from __future__ import annotations

import functools
import os
from typing import Any, Callable, Mapping, Sequence

import dask.array as da
import numpy as np

from .. import _clearcut
from . import _results as results
from ._arrays import chunks_of, clip_chunk, rows_of
from ._outcomes import Task, outcomes


def clip_to_files(lines: da.Array, folder: str, window: Sequence[float] | None = None, **options: Any) -> dict[str, Any]:
    """Clips as `clip` does, and writes the pieces of each chunk to files of NumPy in `folder`: part-00000-segments.npy,
    -source.npy and -cut.npy. No chunk passes through the caller. A file is there only when it is complete, and only if
    its part has no error.

    lines: shape (n, 4), float64 or float32, in chunks of rows.
    folder: made if it is missing. An earlier result in it is removed first. On a cluster all workers must see it.
    window and options: those of `clearcut.clip`, in the unit of the lines.

    Returns what it also writes, last of all, to manifest.json: "parts", a dict for each chunk with its number, the index
    of its first row, the number of its pieces, and "error": null, or why the chunk could not be loaded, clipped or
    written. The other chunks are written all the same. Without a cluster, if a chunk cannot be loaded, some of the others
    are clipped again.

    Raises a TypeError or ValueError for wrong arguments, also for a folder that holds a file that `lines` is read from by
    `read_csv` or `read_npy`, or a manifest.json of another program; an OSError if the folder or the manifest cannot be
    written.
    """
    rows = rows_of(lines, window, **options)
    folder = results.begin(folder, lines, {"parts": part_numbers(rows)})
    manifest = {"parts": write_parts(rows, functools.partial(_write, window=window, options=options), folder)}
    results.finish(folder, manifest)
    return manifest


def _write(chunk: np.ndarray, name: str, first: int, window: Any, options: dict[str, Any]) -> int:
    pieces = clip_chunk(chunk, first, window, options)
    results.save(name, **pieces._asdict())
    return len(pieces.source)


def part_numbers(rows: da.Array) -> list[dict[str, int]]:
    return [{"part": number} for number in range(rows.numblocks[0])]


def write_parts(rows: da.Array, write: Callable[..., int], folder: str, given: Sequence[Any] = (),
                more: Mapping[Any, Any] | None = None) -> list[dict[str, Any]]:
    """Computes write(chunk, "folder/part-NNNNN", first, *given), which returns the number of pieces, for each chunk of
    whole rows. given: keys in `more`. Returns the parts of a manifest. No files are left of parts with an error."""
    tasks = [Task((_checked, write, chunk, os.path.join(folder, f"part-{number:05}"), first, *given),
                  {"part": number, "first": first}, f"chunk {number}")
             for number, (chunk, first) in enumerate(chunks_of(rows))]
    return written("part", tasks, folder, [rows], more)


def _checked(write: Callable[..., int], chunk: Any, *given: Any) -> int:
    return write(_clearcut.checked_segments(chunk), *given)


def written(kind: str, tasks: Sequence[Task], folder: str, after: Sequence[da.Array] = (),
            more: Mapping[Any, Any] | None = None) -> list[dict[str, Any]]:
    """The entries of tasks that write the files KIND-NNNNN-*.npy. No files are left of those with an error."""
    try:
        entries = outcomes(f"write-{kind}", tasks, after, more)
    finally:
        results.remove_unfinished(folder)
    results.remove(folder, kind, [entry[kind] for entry in entries if entry["error"] is not None])
    return entries
