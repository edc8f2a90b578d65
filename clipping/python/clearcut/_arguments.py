# SPDX-License-Identifier: MIT
"""Checks of arguments. Every function returns what it was given in the extension's form, without copying
coordinates, or raises a TypeError or ValueError that says what it got."""
from __future__ import annotations

import math
from typing import Any, Sequence

import numpy as np

_FLOATS = (np.dtype(np.float64), np.dtype(np.float32))


def _got(value: Any) -> str:
    if isinstance(value, np.ndarray):
        return f"an array of shape {value.shape} and dtype {value.dtype}"
    return f"a {type(value).__name__}"


def _refuse_mask(value: Any, what: str) -> None:
    if isinstance(value, np.ma.MaskedArray):
        raise TypeError(f"{what} must not have a mask, because it would be ignored; numpy.ma.filled(..., numpy.nan) "
                        "makes its rows invisible")


def segments(value: Any) -> np.ndarray:
    """An array of shape (n, 4) of float64 or float32."""
    _refuse_mask(value, "segments")
    if not isinstance(value, np.ndarray):
        raise TypeError(f"segments must be a NumPy array of shape (n, 4), but this is {_got(value)}; "
                        "use numpy.asarray(..., dtype=float)")
    if value.dtype not in _FLOATS or not value.dtype.isnative:
        raise TypeError(f"segments must be float64 or float32, but this is {_got(value)}; use .astype(float)")
    if value.ndim != 2 or value.shape[1] != 4:
        raise ValueError(f"segments must have the shape (n, 4), a row x1, y1, x2, y2 for each, but this is {_got(value)}")
    if len(value) >= 1 << 32:
        raise ValueError(f"at most {(1 << 32) - 1} segments can be clipped at once, but this is {_got(value)}")
    return value


def doubles(value: Any, what: str) -> np.ndarray:
    """Segments of float64, for what has no form for float32."""
    array = segments(value)
    if array.dtype != np.float64:
        raise TypeError(f"{what} must be float64, but this is {_got(array)}; use .astype(float)")
    return array


def window(value: Any) -> tuple[float, float, float, float]:
    """(xmin, ymin, xmax, ymax), finite and not inverted."""
    xmin, ymin, xmax, ymax = _numbers(value, 4, "window", "(xmin, ymin, xmax, ymax)")
    if xmin > xmax or ymin > ymax:
        raise ValueError(f"window must be (xmin, ymin, xmax, ymax) with xmin <= xmax and ymin <= ymax, but this is "
                         f"{(xmin, ymin, xmax, ymax)}")
    return xmin, ymin, xmax, ymax


def segment(value: Any) -> tuple[float, float, float, float]:
    """(x1, y1, x2, y2), finite."""
    return _numbers(value, 4, "segment", "(x1, y1, x2, y2)")  # type: ignore[return-value]


def _numbers(value: Any, count: int, name: str, form: str) -> tuple[float, ...]:
    try:
        numbers = tuple(map(_number, value))
    except (TypeError, ValueError):
        raise TypeError(f"{name} must be {count} numbers {form}, but this is {_got(value)}") from None
    if len(numbers) != count:
        raise ValueError(f"{name} must be {count} numbers {form}, but these are {len(numbers)}")
    if not all(map(math.isfinite, numbers)):
        raise ValueError(f"{name} must be finite, but this is {numbers}")
    return numbers


def _number(value: Any) -> float:
    if np.ndim(value) or np.iscomplexobj(value) or isinstance(value, (str, bytes)):
        raise TypeError
    return float(value)


def corners(value: Any) -> list[tuple[float, float]]:
    """Three or more points (x, y) of a convex polygon, in either direction."""
    try:
        if type(value) is np.ndarray and value.dtype in _FLOATS and value.ndim == 2:
            points = [(x, y) for x, y in value.tolist()]
        else:
            points = [(_number(x), _number(y)) for x, y in value]
    except (TypeError, ValueError):
        raise TypeError(f"polygon must be points (x, y), shape (m, 2), but this is {_got(value)}") from None
    if len(points) < 3:
        raise ValueError(f"polygon must have three or more corners, but these are {len(points)}")
    return points


def polyline(value: Any) -> np.ndarray:
    """An array of shape (k, 2) of float64; a complex array is seen as one."""
    _refuse_mask(value, "a line")
    if isinstance(value, np.ndarray) and value.dtype == np.complex128 and value.ndim == 1:
        if value.flags.c_contiguous:
            return value.view(np.float64).reshape(-1, 2)
        return np.lib.stride_tricks.as_strided(value.real, (len(value), 2), (*value.strides, 8), writeable=False)
    if not isinstance(value, np.ndarray) or value.dtype != np.float64 or not value.dtype.isnative:
        raise TypeError(f"a line must be a float64 array of shape (k, 2) or a complex one of shape (k,), but this is "
                        f"{_got(value)}")
    if value.ndim != 2 or value.shape[1] != 2:
        raise ValueError(f"a line must have the shape (k, 2), a row x, y for each point, but this is {_got(value)}")
    return value


def listed(value: Any) -> list[Any]:
    """The lines of a list, or of anything that gives one after the other."""
    if isinstance(value, (str, bytes)) or not hasattr(value, "__iter__"):
        raise TypeError(f"lines must be a list of arrays, but this is {_got(value)}")
    return list(value)


def choice(value: Any, name: str, choices: Sequence[str]) -> str:
    if value not in choices:
        raise ValueError(f"{name} must be one of {', '.join(map(repr, choices))}, but this is {value!r}")
    return value


def text(value: Any, name: str) -> str:
    if not isinstance(value, str):
        raise TypeError(f"{name} must be a text, but this is {_got(value)}")
    return value


def threads(value: Any) -> int:
    """The number of threads; 0 for all."""
    if value is None:
        return 0
    if isinstance(value, bool) or not isinstance(value, (int, np.integer)):
        raise TypeError(f"threads must be a whole number or None, but this is {_got(value)}")
    if not 1 <= value <= 1024:
        raise ValueError(f"threads must be from 1 to 1024, but this is {value}")
    return int(value)
