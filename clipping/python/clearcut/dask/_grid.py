# SPDX-License-Identifier: MIT
from __future__ import annotations

import math
from typing import Sequence

import numpy as np

from .. import _clearcut


def grid(window: Sequence[float], columns: int, rows: int) -> np.ndarray:
    """The windows of a grid of tiles, shape (rows * columns, 4): row by row from ymin on, in each from xmin on.
    Neighbours share the numbers of their common edge.

    window: (xmin, ymin, xmax, ymax), which the tiles fill.
    columns, rows: how many tiles lie side by side, and one above the other.

    >>> import clearcut.dask
    >>> clearcut.dask.grid((0, 0, 4, 3), 2, 1)
    array([[0., 0., 2., 3.],
           [2., 0., 4., 3.]])
    """
    xmin, ymin, xmax, ymax = _clearcut.checked_window(window)
    for name, count in (("columns", columns), ("rows", rows)):
        if isinstance(count, bool) or not isinstance(count, (int, np.integer)) or count < 1:
            raise ValueError(f"{name} must be a whole number from 1 on, but this is {count!r}")
    x, y = _divided(xmin, xmax, columns), _divided(ymin, ymax, rows)
    left, bottom = np.meshgrid(x[:-1], y[:-1])
    right, top = np.meshgrid(x[1:], y[1:])
    return np.stack([left, bottom, right, top], axis=-1).reshape(-1, 4)


def _divided(low: float, high: float, count: int) -> np.ndarray:
    """count + 1 numbers at equal distances, the first low and the last high."""
    if math.isfinite(high - low):
        numbers = np.linspace(low, high, count + 1)
    else:
        with np.errstate(over="ignore"):  # a rounded half of the largest number
            numbers = 2 * np.linspace(low / 2, high / 2, count + 1)
    numbers[0], numbers[-1] = low, high
    return np.clip(numbers, low, high)
