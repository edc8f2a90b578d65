# SPDX-License-Identifier: MIT
from __future__ import annotations

from typing import Any, Iterable, Sequence

import numpy as np

from ._lines import clip_lines


def cropped(layer: Any, window: Sequence[float]) -> Any:
    """The part of a LineCollection of vpype inside the window, as a LineCollection with the same metadata. Paths that
    only touch the window are left out.

    layer: a LineCollection: complex lines, of which closed ones end with their first point.
    window: (xmin, ymin, xmax, ymax), in the unit of the layer (for vpype CSS pixels).
    """
    found = layer.clone()
    for line in layer:
        found.extend(_parts(line, window))
    return found


def _parts(line: Any, window: Sequence[float]) -> Iterable[np.ndarray]:
    points = np.asarray(line, dtype=complex)
    closed = len(points) > 2 and points[0] == points[-1]
    parts = clip_lines([points[:-1] if closed else points], window, closed=closed)
    return [part for part in parts if len(part) > 1]
