# SPDX-License-Identifier: MIT
from __future__ import annotations

from typing import NamedTuple, Sequence

import numpy as np

from . import _clearcut


class Clipped(NamedTuple):
    """The visible pieces of segments, in the order of the segments. The arrays are views of one memory."""

    #: Shape (m, 4), the dtype of the input: x1, y1, x2, y2 of each piece, in the direction of its segment.
    segments: np.ndarray
    #: Shape (m,), uint32: the index of each piece's segment.
    source: np.ndarray
    #: Shape (m,), uint32: which ends are new, and at which edges; 0 if both are the segment's. At a window, bits 0
    #: to 7 are the edge that cut the start and bits 8 to 15 that of the end: 1 left, 2 right, 3 bottom (ymin),
    #: 4 top (ymax). At a polygon they are 16 bits each: 1 + the index of the edge (65535 from index 65534 on).
    #: Edge i runs between the corners i and i + 1 of the polygon as given, the last one between the last and corner 0.
    cut: np.ndarray


def clip(segments: np.ndarray, window: Sequence[float] | None = None, *,
         polygon: Sequence[Sequence[float]] | None = None, kind: str = "segment", algorithm: str = "exact",
         form: str = "corrected", threads: int | None = None) -> Clipped:
    """Clips segments at a window or at a convex polygon.

    segments: shape (n, 4), float64 or float32, a row x1, y1, x2, y2 for each. It is read where it is, whatever its
        strides are (contiguous rows are fastest), and never copied. A row with a NaN or an infinity is not visible.
    window: (xmin, ymin, xmax, ymax), in the unit of the segments. For float32 it is rounded to float32.
    polygon: instead of a window, shape (m, 2), the corners of a convex polygon in either direction.
    kind: what a row means: the "segment" between two points, the infinite "line" through them, or the "ray" from the
        first through the second one.
    algorithm: a key or abbreviation of `algorithms()`. "exact" makes no wrong decision and is the fastest.
    form: "corrected", or "published", as its authors printed it, with its faults.
    threads: how many; None: all. Only "exact" at a window uses several.

    Other Python threads run meanwhile.

    >>> import numpy as np, clearcut
    >>> a = np.array([[-5, 5, 15, 5], [20, 20, 30, 30]], dtype=float)
    >>> clearcut.clip(a, (0, 0, 10, 10)).segments
    array([[ 0.,  5., 10.,  5.]])
    >>> clearcut.clip(a, polygon=[(0, 0), (10, 0), (5, 10)]).segments
    array([[2.5, 5. , 7.5, 5. ]])
    >>> clearcut.clip(a, (0, 0, 10, 10), kind="line", algorithm="liang-barsky").source
    array([0, 1], dtype=uint32)
    """
    return tuple.__new__(Clipped, _clearcut.clip(segments, window, polygon, kind, algorithm, form, threads))


def split(segments: np.ndarray, window: Sequence[float]) -> tuple[Clipped, Clipped]:
    """The pieces inside the window, and those outside it, which together are all segments.

    segments: shape (n, 4), float64; read where it is.
    window: (xmin, ymin, xmax, ymax), in the unit of the segments.

    >>> import numpy as np, clearcut
    >>> inside, outside = clearcut.split(np.array([[-5., 5., 15., 5.]]), (0, 0, 10, 10))
    >>> inside.segments
    array([[ 0.,  5., 10.,  5.]])
    >>> outside.segments
    array([[-5.,  5.,  0.,  5.],
           [10.,  5., 15.,  5.]])
    """
    inside, outside = _clearcut.split(segments, window)
    return tuple.__new__(Clipped, inside), tuple.__new__(Clipped, outside)
