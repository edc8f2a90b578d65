# SPDX-License-Identifier: MIT
from __future__ import annotations

from typing import Iterable, Literal, Sequence, overload

import numpy as np

from . import _arguments as arguments
from . import _clearcut


@overload
def clip_lines(lines: Iterable[np.ndarray], window: Sequence[float], *, closed: bool = ...,
               return_source: Literal[False] = ...) -> list[np.ndarray]: ...


@overload
def clip_lines(lines: Iterable[np.ndarray], window: Sequence[float], *, closed: bool = ...,
               return_source: Literal[True]) -> tuple[list[np.ndarray], list[int]]: ...


def clip_lines(lines: Iterable[np.ndarray], window: Sequence[float], *, closed: bool = False,
               return_source: bool = False) -> list[np.ndarray] | tuple[list[np.ndarray], list[int]]:
    """The visible parts of polylines, unbroken at their corners.

    lines: arrays of shape (k, 2), float64, as of matplotlib's LineCollection, or complex arrays of shape (k,), as of
        vpype. The parts of complex lines are complex.
    window: (xmin, ymin, xmax, ymax), in the unit of the lines.
    closed: each line continues from its last point to its first.
    return_source: return also the index of each part's line.

    >>> import numpy as np, clearcut
    >>> zigzag = np.array([[-5, 0], [5, 5], [5, 20]], dtype=float)
    >>> clearcut.clip_lines([zigzag], (0, 0, 10, 10))
    [array([[ 0. ,  2.5],
           [ 5. ,  5. ],
           [ 5. , 10. ]])]
    >>> clearcut.clip_lines([np.array([-5 + 1j, 5 + 1j])], (0, 0, 10, 10))
    [array([0.+1.j, 5.+1.j])]
    """
    given = arguments.listed(lines)
    views = [arguments.polyline(line) for line in given]
    parts, source = _clearcut.clip_polylines(views, arguments.window(window), bool(closed))
    parts = [part.view(np.complex128).reshape(-1) if np.iscomplexobj(given[i]) else part
             for part, i in zip(parts, source)]
    return (parts, source) if return_source else parts
