# SPDX-License-Identifier: MIT
"""Tasks of which each may fail on its own."""
from __future__ import annotations

from typing import Any, Mapping, NamedTuple, Sequence

import dask
import dask.array as da
import numpy as np

from ._graph import alone, objects


class Task(NamedTuple):
    #: A function that returns a number of pieces, and its arguments, which may be keys of a graph.
    call: tuple[Any, ...]
    #: What the manifest says of the task besides "pieces" and "error".
    entry: dict[str, Any]
    #: What errors call it.
    name: str


def outcomes(prefix: str, tasks: Sequence[Task], after: Sequence[da.Array] = (),
             more: Mapping[Any, Any] | None = None) -> list[dict[str, Any]]:
    """Computes the tasks, and returns their entries of a manifest. after, more: as for `array_of`."""
    found = _computed(prefix, tasks, after, more) if tasks else []
    return [{**task.entry, "pieces": pieces, "error": None if error is None else f"{task.name}: {error}"}
            for task, (pieces, error) in zip(tasks, found)]


def _outcome(call: Any, *arguments: Any) -> np.ndarray:
    try:
        return alone((call(*arguments), None))
    except Exception as error:  # also a full disk or too little memory
        return alone(_failed(error))


def _failed(error: BaseException) -> tuple[int, str]:
    kind = [] if isinstance(error, (TypeError, ValueError)) else [type(error).__name__]
    return 0, ": ".join([*kind, *filter(None, [str(error)])])


def _computed(prefix: str, tasks: Sequence[Task], after: Sequence[da.Array],
              more: Mapping[Any, Any] | None) -> list[tuple[int, str | None]]:
    """A task may also fail before its call, because its chunk cannot be loaded. A cluster answers for each task. In one
    process Dask gives up all tasks; then each half is computed on its own, until the chunk is found."""
    running = objects(prefix, [(_outcome, *task.call) for task in tasks], after, more)
    client: Any = getattr(dask.base.get_scheduler(), "__self__", None)
    if hasattr(client, "futures"):
        return _gathered(client, running)
    try:
        return list(running.compute())
    except Exception as error:
        if len(tasks) == 1:
            return [_failed(error)]
    half = len(tasks) // 2
    return _computed(prefix, tasks[:half], after, more) + _computed(prefix, tasks[half:], after, more)


def _gathered(client: Any, running: da.Array) -> list[tuple[int, str | None]]:
    started = client.persist(running)
    futures = [started.dask[key] for key in started.__dask_keys__()]
    try:
        return [result[0] for result in client.gather(futures)]
    except Exception:
        return [_answer(future) for future in futures]


def _answer(future: Any) -> tuple[int, str | None]:
    try:
        return future.result()[0]
    except Exception as error:  # its chunk cannot be loaded, or its workers die
        return _failed(error)
