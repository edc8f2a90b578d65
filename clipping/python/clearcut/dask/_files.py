# SPDX-License-Identifier: MIT
"""Results as files of NumPy, with a manifest that says of each part whether it is there."""
from __future__ import annotations

import functools
import json
import os
import pathlib
import uuid
from typing import Any, Callable, Mapping, NamedTuple, Sequence

import dask
import dask.array as da
import numpy as np

from .. import _arguments as arguments
from ._arrays import chunks_of, clip_chunk, rows_of
from ._graph import alone, objects


def clip_to_files(lines: da.Array, folder: str, window: Sequence[float] | None = None, **options: Any) -> dict[str, Any]:
    """Clips as `clip` does, and writes the pieces of each chunk to files of NumPy in `folder`: part-00000-segments.npy,
    -source.npy and -cut.npy. No chunk passes through the caller. A file is there only when it is complete, and only if
    its part has no error.

    lines: shape (n, 4), float64 or float32, in chunks of rows.
    folder: made if it is missing. On a cluster all workers must see it.
    window and options: those of `clearcut.clip`, in the unit of the lines.

    Returns what it also writes to manifest.json: "parts", a dict for each chunk with its number, the index of its
    first row, the number of its pieces, and "error": null, or why the chunk could not be loaded, clipped or written.
    The other chunks are written all the same. Without a cluster, if a chunk cannot be loaded, some of the others are
    clipped again. Raises an error only for wrong arguments, or if the folder or the manifest cannot be written.
    """
    rows = rows_of(lines, window, **options)
    folder = os.path.abspath(folder)  # for workers in other folders
    os.makedirs(folder, exist_ok=True)
    manifest = {"parts": write_parts(rows, functools.partial(_write, window=window, options=options), folder)}
    write_manifest(folder, manifest)
    return manifest


def _write(chunk: np.ndarray, name: str, first: int, window: Any, options: dict[str, Any]) -> int:
    pieces = clip_chunk(chunk, first, window, options)
    save(name, **pieces._asdict())
    return len(pieces.source)


def write_parts(rows: da.Array, write: Callable[..., int], folder: str, given: Sequence[Any] = (),
                more: Mapping[Any, Any] | None = None) -> list[dict[str, Any]]:
    """Computes write(chunk, "folder/part-NNNNN", first, *given), which returns the number of pieces, for each chunk of
    whole rows. given: keys in `more`. Returns the parts of a manifest. No files are left of parts with an error."""
    tasks = [_Task(number, first, (_part, chunk, number, first, write, folder, *given))
             for number, (chunk, first) in enumerate(chunks_of(rows))]
    try:
        parts = _computed(tasks, rows, more)
    finally:
        _remove(folder, "part-*.unfinished")  # of workers that were lost
    for part in parts:
        if part["error"] is not None:
            _remove(folder, f'part-{part["part"]:05}-*.npy')
    return parts


class _Task(NamedTuple):
    number: int
    first: int
    part: tuple[Any, ...]


def _part(chunk: Any, number: int, first: int, write: Callable[..., int], folder: str, *given: Any) -> np.ndarray:
    try:
        pieces = write(arguments.segments(chunk), os.path.join(folder, f"part-{number:05}"), first, *given)
    except Exception as error:  # also a full disk or too little memory
        return alone(_failed(number, first, error))
    return alone({"part": number, "first": first, "pieces": pieces, "error": None})


def _failed(number: int, first: int, error: BaseException) -> dict[str, Any]:
    return {"part": number, "first": first, "pieces": 0, "error": f"chunk {number}: {says(error)}"}


def says(error: BaseException) -> str:
    kind = [] if isinstance(error, (TypeError, ValueError)) else [type(error).__name__]
    return ": ".join([*kind, *filter(None, [str(error)])])


def _computed(tasks: list[_Task], rows: da.Array, more: Mapping[Any, Any] | None) -> list[dict[str, Any]]:
    """The parts of the manifest, each of which may fail on its own, because its chunk cannot be loaded. A cluster
    answers for each task. In one process Dask gives up all tasks; then each half is computed on its own, until the
    chunk is found."""
    parts = objects("write", [task.part for task in tasks], [rows], more)
    client: Any = getattr(dask.base.get_scheduler(), "__self__", None)
    if hasattr(client, "futures"):
        return _gathered(client, tasks, parts)
    try:
        return list(parts.compute())
    except Exception as error:
        if len(tasks) == 1:
            return [_failed(tasks[0].number, tasks[0].first, error)]
    half = len(tasks) // 2
    return _computed(tasks[:half], rows, more) + _computed(tasks[half:], rows, more)


def _gathered(client: Any, tasks: list[_Task], parts: da.Array) -> list[dict[str, Any]]:
    running = client.persist(parts)
    futures = [running.dask[key] for key in running.__dask_keys__()]
    try:
        return [result[0] for result in client.gather(futures)]
    except Exception:
        return [_answer(task, future) for task, future in zip(tasks, futures)]


def _answer(task: _Task, future: Any) -> dict[str, Any]:
    try:
        return future.result()[0]
    except Exception as error:  # its chunk cannot be loaded, or its workers die
        return _failed(task.number, task.first, error)


def save(name: str, **arrays: np.ndarray) -> None:
    """Writes each array to NAME-KEY.npy."""
    for key, array in arrays.items():
        _replace(f"{name}-{key}.npy", lambda file, array=array: np.save(file, array))


def write_manifest(folder: str, manifest: dict[str, Any]) -> None:
    _replace(os.path.join(folder, "manifest.json"), lambda file: file.write(json.dumps(manifest, indent=1).encode()))


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
