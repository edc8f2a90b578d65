# SPDX-License-Identifier: MIT
from __future__ import annotations

from typing import Any, Sequence

import numpy as np

from ._lines import clip_lines


def cropped(layer: Any, window: Sequence[float]) -> Any:
    """The part of a LineCollection of vpype inside the window, as a LineCollection with the same metadata. Where a path
    only touches the window, nothing is left of it; a path that is a dot itself, two or more equal points, stays.

    layer: a LineCollection: complex lines, of which closed ones end with their first point.
    window: (xmin, ymin, xmax, ymax), in the unit of the layer (for vpype CSS pixels).
    """
    lines = [np.asarray(line, dtype=complex) for line in layer]
    closed = [len(line) > 2 and line[0] == line[-1] for line in lines]
    parts: list[list[np.ndarray]] = [[] for _ in lines]
    for kind in (False, True):  # one call for all lines of a kind: it takes much longer for each line
        numbers = [i for i, is_closed in enumerate(closed) if is_closed == kind]
        chosen = [lines[i][:-1] if kind else lines[i] for i in numbers]
        for part, source in zip(*clip_lines(chosen, window, closed=kind, return_source=True)):
            if len(part) > 1 and (_is_long(part) or not _is_long(lines[numbers[source]])):
                parts[numbers[source]].append(part)
    found = layer.clone()
    found.extend([part for of_line in parts for part in of_line])
    return found


def _is_long(line: np.ndarray) -> bool:
    return bool(line[0] != line[1] or np.any(line != line[0]))
