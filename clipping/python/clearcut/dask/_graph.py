# SPDX-License-Identifier: MIT
from __future__ import annotations

import uuid
from typing import Any, Mapping, Sequence

import dask.array as da
import numpy as np
from dask.highlevelgraph import HighLevelGraph


def array_of(prefix: str, tasks: Sequence[tuple[Any, ...]], lengths: Sequence[float], dtype: Any, columns: int = 0,
             after: Sequence[da.Array] = (), more: Mapping[Any, Any] | None = None) -> da.Array:
    """An array whose chunk i, of lengths[i] rows, is the result of tasks[i], as one layer of a graph. (With a layer for
    each chunk, as dask.delayed makes them, the time to plan grows with the square of the number of chunks.)

    columns: how many a row has; 0 for an array of one dimension.
    after: the arrays whose chunks, as keys (name, i, ...), are arguments of the tasks.
    more: other keys that are arguments, with their tasks.
    """
    name = f"{prefix}-{uuid.uuid4().hex}"
    end = (0,) if columns else ()
    layer = dict(more or {}) | {(name, i, *end): task for i, task in enumerate(tasks)}
    graph = HighLevelGraph.from_collections(name, layer, dependencies=after)
    chunks = (tuple(lengths), (columns,)) if columns else (tuple(lengths),)
    return da.Array(graph, name, chunks, meta=np.zeros((0,) * len(chunks), dtype))


def objects(prefix: str, tasks: Sequence[tuple[Any, ...]], after: Sequence[da.Array] = (),
            more: Mapping[Any, Any] | None = None) -> da.Array:
    """An array whose chunk i is the result of tasks[i], which is not an array. Other tasks may use it; it cannot be
    computed itself unless each result is an array of one object, as of `alone`."""
    return array_of(prefix, tasks, [1] * len(tasks), object, after=after, more=more)


def alone(result: Any) -> np.ndarray:
    array = np.empty(1, object)
    array[0] = result
    return array
