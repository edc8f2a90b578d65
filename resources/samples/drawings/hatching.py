# SPDX-License-Identifier: CC0-1.0
"""Parallel lines at 45 degrees."""

from .artwork import Artwork


def hatching():
    art = Artwork("Hatching", ("200mm", "150mm"), (0, 0, 200, 150), (50, 40, 100, 70))
    layer = art.layer("Lines", "#28405F", 0.35)
    for k in range(80):
        layer.polyline([(k, 20), (k + 110, 130)])
    return art
