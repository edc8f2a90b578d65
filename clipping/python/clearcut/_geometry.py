# SPDX-License-Identifier: MIT
from __future__ import annotations

import functools
import threading
from typing import Any, NamedTuple, Sequence

from . import _clearcut


def clip_geometry(geometry: Any, window: Sequence[float]) -> Any:
    """The part of a line of shapely inside the window: a LineString, a MultiLineString, or an empty LineString. Where
    the line only touches the window, the part is a Point, and of several parts a GeometryCollection.

    geometry: a LineString, LinearRing or MultiLineString; only x and y are read. Many lines are clipped in much less
        time by `clip_polylines`.
    window: (xmin, ymin, xmax, ymax), in the unit of the geometry.

    >>> import clearcut
    >>> from shapely.geometry import LineString
    >>> print(clearcut.clip_geometry(LineString([(-5, 5), (15, 5)]), (0, 0, 10, 10)))
    LINESTRING (0 5, 10 5)
    """
    shapely = _shapely()
    if not isinstance(geometry, shapely.lines):
        raise TypeError(f"geometry must be a LineString, LinearRing or MultiLineString of shapely, but this is a "
                        f"{type(geometry).__name__}")
    return shapely.from_wkb(_clearcut.clip_wkb(shapely.to_wkb(geometry), window, isinstance(geometry, shapely.ring)))


class _Shapely(NamedTuple):
    lines: tuple[type, ...]
    ring: type
    to_wkb: Any  #: of two coordinates a point
    from_wkb: Any


@functools.lru_cache(maxsize=None)
def _shapely() -> _Shapely:
    try:
        import shapely
        from shapely import geometry as shapes
    except ImportError:
        raise ImportError("clip_geometry needs shapely") from None
    kinds = (shapes.LineString, shapes.MultiLineString), shapes.LinearRing
    if hasattr(shapely, "to_wkb"):
        return _Shapely(*kinds, functools.partial(shapely.to_wkb, output_dimension=2), shapely.from_wkb)
    old = _Shapely1()
    return _Shapely(*kinds, old.to_wkb, old.from_wkb)


class _Shapely1(threading.local):
    """Shapely before 2.0, which does not change any more. Its own functions make a writer or reader for each call, and
    find the class of a geometry by an import: that takes three times as long as all else."""

    def __init__(self) -> None:
        from shapely import geometry, geos
        self.writer, self.reader = geos.WKBWriter(geos.lgeos, output_dimension=2), geos.WKBReader(geos.lgeos)
        self.read = geos.lgeos.GEOSWKBReader_read
        self.kinds = {1: geometry.Point, 2: geometry.LineString, 5: geometry.MultiLineString, 7: geometry.GeometryCollection}

    def to_wkb(self, geometry: Any) -> bytes:
        return self.writer.write(geometry)

    def from_wkb(self, wkb: bytes) -> Any:
        kind = self.kinds[max(wkb[1], wkb[4])]  # the number's last byte, or its first one
        made = kind.__new__(kind)
        made.__dict__.update(__geom__=self.read(self.reader._reader, wkb, len(wkb)), _ndim=2, _is_empty=False)
        return made
