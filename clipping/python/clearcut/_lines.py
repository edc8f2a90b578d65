# SPDX-License-Identifier: MIT
from __future__ import annotations

from typing import Iterable, Literal, NamedTuple, Sequence, overload

import numpy as np

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
    parts, source = _clearcut.clip_lines(lines, window, closed)
    return (parts, source) if return_source else parts


class ClippedLines(NamedTuple):
    """The visible parts of polylines, in the order of the polylines. The arrays are views of one memory."""

    #: The points of all parts, one part after the other: shape (k, 2), or complex of shape (k,) if the input was.
    coordinates: np.ndarray
    #: Shape (m + 1,), the dtype of the input: part i has the points from offsets[i] up to, not including, offsets[i + 1].
    offsets: np.ndarray
    #: Shape (m,), uint32: the index of each part's polyline.
    source: np.ndarray


def clip_polylines(coordinates: np.ndarray, offsets: np.ndarray, window: Sequence[float], *,
                   closed: bool = False) -> ClippedLines:
    """The visible parts of many polylines, as `clip_lines` finds them, but without an array for each: given and returned
    as coordinates and offsets, the layout of GeoArrow and of shapely's `to_ragged_array`.

    coordinates: the points of all polylines, shape (n, 2), float64, or complex, shape (n,), whatever the strides are.
    offsets: shape (m + 1,), int32 or int64: polyline i has the points from offsets[i] up to, not including,
        offsets[i + 1].
    window: (xmin, ymin, xmax, ymax), in the unit of the coordinates.
    closed: each polyline continues from its last point to its first.

    Raises a TypeError or ValueError for other arrays, and for offsets that decrease or that no point has. Other Python
    threads run meanwhile.

    >>> import numpy as np, clearcut
    >>> points = np.array([[-5, 0], [5, 5], [5, 20], [1, 1], [2, 1]], dtype=float)
    >>> parts = clearcut.clip_polylines(points, np.array([0, 3, 5]), (0, 0, 10, 10))
    >>> parts.offsets
    array([0, 3, 5])
    >>> np.split(parts.coordinates, parts.offsets[1:-1])[0]
    array([[ 0. ,  2.5],
           [ 5. ,  5. ],
           [ 5. , 10. ]])
    """
    return tuple.__new__(ClippedLines, _clearcut.clip_polylines(coordinates, offsets, window, closed))
