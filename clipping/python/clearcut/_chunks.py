# SPDX-License-Identifier: MIT
from __future__ import annotations

from typing import Sequence

import numpy as np

from . import _clearcut
from ._clip import Clipped


class Chunks:
    """Boxes around short runs of segments, for a drawing that stays the same while the window moves. Clips like
    `clip` with "exact", bit for bit, but reads only the segments near the window's edges.

    segments: shape (n, 4), float64 or float32, contiguous. It is kept, not copied: after you have written to it, call
        `update`.

    >>> import numpy as np, clearcut
    >>> drawing = np.array([[-5., 5., 15., 5.], [1., 1., 2., 2.]])
    >>> chunks = clearcut.Chunks(drawing)
    >>> chunks.clip((0, 0, 10, 10)).segments
    array([[ 0.,  5., 10.,  5.],
           [ 1.,  1.,  2.,  2.]])
    """

    def __init__(self, segments: np.ndarray) -> None:
        self._chunks = _clearcut.Chunks(segments)
        self._count = len(segments)

    def clip(self, window: Sequence[float]) -> Clipped:
        """The pieces inside the window, in the order of the segments.

        window: (xmin, ymin, xmax, ymax), in the unit of the segments. For float32 it is rounded to float32.
        """
        return tuple.__new__(Clipped, self._chunks.clip(window))

    def update(self, first: int, last: int) -> None:
        """Call this after rows have been written to, and not while another thread clips.

        first, last: the rows from `first` up to, not including, `last`.
        """
        if not 0 <= first <= last <= self._count:
            raise ValueError(f"0 <= first <= last <= {self._count} must hold, but these are {first} and {last}")
        self._chunks.update(first, last)
