# SPDX-License-Identifier: MIT
"""Clips line segments at windows, exactly, over NumPy arrays and without copying them.

>>> import numpy as np, clearcut
>>> hatching = np.array([[-2, 1, 6, 5], [1, 1, 7, 2], [7, 8, 9, 8]], dtype=float)
>>> segments, source, cut = clearcut.clip(hatching, (0, 0, 8, 6))
>>> segments
array([[0., 2., 6., 5.],
       [1., 1., 7., 2.]])
>>> source
array([0, 1], dtype=uint32)

Coordinates are in any unit; a window is (xmin, ymin, xmax, ymax) in the same unit, and its edges belong to it.
"""
from ._chunks import Chunks
from ._clip import Clipped, clip, split
from ._geometry import clip_geometry
from ._lines import ClippedLines, clip_lines, clip_polylines
from ._tracing import algorithms, trace

__all__ = ["Chunks", "Clipped", "ClippedLines", "algorithms", "clip", "clip_geometry", "clip_lines", "clip_polylines",
           "split", "trace"]
__version__ = "0.1.0"
