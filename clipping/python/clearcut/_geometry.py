# SPDX-License-Identifier: MIT
from __future__ import annotations

from typing import Any, Sequence

import numpy as np

from ._lines import clip_lines


def clip_geometry(geometry: Any, window: Sequence[float]) -> Any:
    """The part of a line of shapely inside the window: a LineString, a MultiLineString, or an empty LineString. Where
    the line only touches the window, the part is a Point, and of several parts a GeometryCollection.

    geometry: a LineString, LinearRing or MultiLineString; only x and y are read.
    window: (xmin, ymin, xmax, ymax), in the unit of the geometry.

    >>> import clearcut
    >>> from shapely.geometry import LineString
    >>> print(clearcut.clip_geometry(LineString([(-5, 5), (15, 5)]), (0, 0, 10, 10)))
    LINESTRING (0 5, 10 5)
    """
    try:
        from shapely.geometry import LineString, Point
        from shapely import geometry as shapes
    except ImportError:
        raise ImportError("clip_geometry needs shapely") from None
    if isinstance(geometry, LineString):
        lines, closed = [geometry], geometry.geom_type == "LinearRing"
    elif isinstance(geometry, shapes.MultiLineString):
        lines, closed = list(geometry.geoms), False
    else:
        raise TypeError(f"geometry must be a LineString, LinearRing or MultiLineString of shapely, but this is a "
                        f"{type(geometry).__name__}")
    points = [_points(line, closed) for line in lines if not line.is_empty]
    parts = [LineString(part) if len(part) > 1 else Point(part[0])
             for part in clip_lines(points, window, closed=closed)]
    if len(parts) < 2:
        return parts[0] if parts else LineString()
    return (shapes.MultiLineString if all(len(part.coords) > 1 for part in parts) else shapes.GeometryCollection)(parts)


def _points(line: Any, closed: bool) -> np.ndarray:
    points = np.asarray(line.coords, dtype=float)[:, :2]
    return points[:-1] if closed else points  # a ring repeats its first point
