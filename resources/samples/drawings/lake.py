# SPDX-License-Identifier: CC0-1.0
"""The surroundings of the mountains: the sun, the sky and the water with their reflections."""

from math import cos, hypot, pi, sin

from .noise import fractal, unit
from .terrain import SHORE, WIDTH, runs

SUN_X, SUN_Y, SUN_RADIUS = 158, 60, 25
TOP, BOTTOM = 12, 289
BOAT_X, BOAT_Y = 306, 236


def sun(layer, terrain):
    """Circles. Where a ridge cuts a circle, only the arc above the ridge."""
    for k in range(17):
        radius = SUN_RADIUS - 1.45 * k
        count = max(48, int(2 * pi * radius / 0.7))
        angles = [pi / 2 + 2 * pi * i / count for i in range(count + 1)]
        points = [(SUN_X + radius * cos(a), SUN_Y + radius * sin(a)) for a in angles]
        shown = [y < terrain.skyline(x) for x, y in points]
        if all(shown):
            layer.circle(SUN_X, SUN_Y, radius)
        else:
            for run in runs(points, shown):
                layer.polyline(run)


def cloud(x, y):
    return fractal(x / 95 + 2.2, y / 24 + 0.6, 4, 120) > 0.10 + 0.10 * (y / 100 - 0.5)


def sky(layer, terrain):
    """Horizontal lines where there is no cloud, sun or mountain, with occasional gaps."""
    y, row = TOP, 0
    while y < 130:
        points = [(0.6 * i, y) for i in range(int(WIDTH / 0.6) + 1)]
        shown = [
            y < terrain.skyline(x) - 0.8
            and hypot(x - SUN_X, y - SUN_Y) > SUN_RADIUS + 2
            and not cloud(x, y)
            and unit(int((x + 37 * unit(row, 0, 5)) / 1.8), row, 6) > 0.03
            for x, _ in points
        ]
        for run in runs(points, shown):
            if run[-1][0] - run[0][0] > 2:
                layer.polyline([run[0], run[-1]])
        y, row = y + 1.5 + 0.009 * (130 - y), row + 1


def mirrored(terrain, x, y):
    """The darkness of the water at a point: 0 to 1."""
    up = SHORE - 1.12 * (y - SHORE)
    if up < terrain.skyline(x):
        return 0.06
    depth = terrain.depth_at(x, up)
    if depth is None or depth < 25:
        return 0.9
    return 0.36 + 0.6 * terrain.shade(x, depth)


def glitter(x, y):
    """The reflection of the sun: a lane that widens towards the viewer."""
    return abs(x - SUN_X) < 3 + 0.16 * (y - SHORE) and y > SHORE + 14


def on_boat(x, y):
    return abs(x - BOAT_X) < 11 and -20 < y - BOAT_Y < 2.5


def water(blue, gold, terrain):
    """Dashes, longer and farther apart towards the viewer."""
    y, row = SHORE + 2.2, 0
    while y < BOTTOM:
        near = (y - SHORE) / (BOTTOM - SHORE)
        x, k = 2 + 6 * unit(row, 0, 21), 0
        while x < WIDTH - 3:
            length = (2.5 + 8 * near) * (0.5 + unit(row, k, 22))
            end = min(x + length, WIDTH - 2)
            middle = (x + end) / 2
            layer, dark = blue, mirrored(terrain, middle + 3 * (unit(row, k, 23) - 0.5), y)
            if glitter(middle, y):
                layer, dark = gold, 0.66
            if dark > unit(row, k, 24) and not on_boat(x, y) and not on_boat(end, y):
                layer.polyline([(x, y), (end, y)])
            x, k = end + 0.8 + 1.5 * near, k + 1
        y, row = y + 0.95 + 1.05 * near, row + 1


def boat(layer):
    """A small sailing boat and its image in the water."""
    x, y = BOAT_X, BOAT_Y
    layer.polyline([(x - 8, y - 1.6), (x + 8, y - 1.6), (x + 6, y + 0.8), (x - 5.6, y + 0.8)], closed=True)
    layer.polyline([(x - 7, y - 0.6), (x + 7, y - 0.6)])
    layer.polyline([(x, y - 1.6), (x, y - 19)])
    layer.polyline([(x - 0.8, y - 18), (x - 7, y - 2.8), (x - 0.8, y - 2.8)], closed=True)
    layer.polyline([(x + 0.8, y - 17), (x + 6.4, y - 2.8), (x + 0.8, y - 2.8)], closed=True)
    for k in range(1, 12):
        part = k / 12
        layer.polyline([(x + 0.8, y - 17 + 14.2 * part), (x + 0.8 + 5.6 * part, y - 17 + 14.2 * part)])
    for k in range(7):
        reach = (5.5 - 0.6 * k) * (0.7 + 0.5 * unit(k, 0, 31))
        layer.polyline([(x - reach, y + 2.6 + 1.7 * k), (x + 0.8 * reach, y + 2.6 + 1.7 * k)])
