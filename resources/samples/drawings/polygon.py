# SPDX-License-Identifier: CC0-1.0
"""Convex polygons as lists of points. The inside is to the right of each edge, with y down."""

from math import fsum, hypot


def area(polygon):
    around = zip(polygon, polygon[1:] + polygon[:1])
    return fsum(x1 * y2 - x2 * y1 for (x1, y1), (x2, y2) in around) / 2


def centre(polygon):
    return fsum(x for x, _ in polygon) / len(polygon), fsum(y for _, y in polygon) / len(polygon)


def cut(polygon, place, inward):
    """The part that lies on the inner side of the line through a place."""
    kept = []
    heights = [(x - place[0]) * inward[0] + (y - place[1]) * inward[1] for x, y in polygon]
    for k, (x2, y2) in enumerate(polygon):
        x1, y1 = polygon[k - 1]
        low, high = heights[k - 1], heights[k]
        if (low < 0) != (high < 0):
            t = low / (low - high)
            kept.append((x1 + t * (x2 - x1), y1 + t * (y2 - y1)))
        if high >= 0:
            kept.append((x2, y2))
    return kept


def edges(polygon):
    """Start, unit direction and length of each edge that is long enough to have a direction."""
    for k, (x, y) in enumerate(polygon):
        nextx, nexty = polygon[(k + 1) % len(polygon)]
        length = hypot(nextx - x, nexty - y)
        if length > 1e-6:
            yield (x, y), ((nextx - x) / length, (nexty - y) / length), length


def inset(polygon, distance):
    """The part with at least this distance from every edge; it may be empty."""
    left = polygon
    for (x, y), (ux, uy), _ in edges(polygon):
        left = cut(left, (x - distance * uy, y + distance * ux), (-uy, ux))
    return left


def extent(polygon, direction):
    along = [x * direction[0] + y * direction[1] for x, y in polygon]
    return min(along), max(along)


def apart(one, other, tolerance=1e-3):
    """Whether one polygon lies wholly beyond an edge of the other, so that they touch at most."""
    for first, second in ((one, other), (other, one)):
        for (x, y), (ux, uy), _ in edges(first):
            if all((py - y) * ux - (px - x) * uy < tolerance for px, py in second):
                return True
    return False


def holds(polygon, point, tolerance=1e-3):
    px, py = point
    return all((py - y) * ux - (px - x) * uy > -tolerance for (x, y), (ux, uy), _ in edges(polygon))
