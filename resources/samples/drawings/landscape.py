# SPDX-License-Identifier: CC0-1.0
"""Mountains at a lake, as a pen drawing: profiles with hidden lines removed, strokes down the slopes
that face away from the sun, a sky of horizontal lines with white clouds, water in dashes."""

from math import hypot

from .artwork import Artwork, simplified
from .noise import unit
from .forest import forest
from .lake import boat, sky, sun, water
from .terrain import ROWS, SHORE, STEP_DEPTH, STEP_X, TILT, WIDTH, Terrain, runs

INK, GREEN, GOLD, GREY, BLUE = "#22252B", "#2F5242", "#9A6A12", "#6F7782", "#2A6690"


def profiles(layer, terrain, every):
    """A line for every few rows; of the rows between them, the parts that stand out against a valley."""
    for j in range(ROWS):
        base = SHORE - TILT * STEP_DEPTH * j
        points = [(STEP_X * i, base - up) for i, up in enumerate(terrain.heights[j])]
        shown = [y < hidden for (_, y), hidden in zip(points, terrain.horizons[j])]
        if j % every:
            shown = [here and stands_out(terrain, i, j) for i, here in enumerate(shown)]
        for run in runs(points, shown):
            if len(run) > 3:
                layer.polyline(simplified(run, 0.06))


def skyline(layer, terrain):
    points = [(STEP_X * i, y) for i, y in enumerate(terrain.horizons[-1])]
    layer.polyline(simplified(points, 0.06))


def stands_out(terrain, i, j):
    y = SHORE - TILT * STEP_DEPTH * j - terrain.heights[j][i]
    beyond = min(j + 4, ROWS)
    return terrain.horizons[beyond][i] >= y


def stroke(terrain, x, depth, length, least):
    """A stroke down the slope from a place, as far as the slope is visible and shaded."""
    points = []
    run = 0
    while run < length and 0 <= x <= WIDTH and depth > 0:
        if not terrain.visible(x, depth) or terrain.shade(x, depth) < least:
            break
        points.append((x, terrain.on_page(x, depth)))
        right, back = terrain.slope(x, depth)
        steep = hypot(right, back) or 1
        x, depth = x - 0.45 * right / steep, depth - 0.45 * back / steep
        if len(points) > 1:
            run += hypot(points[-1][0] - points[-2][0], points[-1][1] - points[-2][1])
    return points


def hatching(layer, terrain, across, down):
    """Strokes from a jittered grid on the page; the darker the place, the more and longer strokes."""
    for i in range(int(WIDTH / across)):
        for j in range(int(150 / down)):
            x = across * (i + 0.9 * unit(i, j, 1))
            y = 50 + down * (j + (0.5 if i % 2 else 0) + 0.6 * unit(i, j, 2))
            depth = terrain.depth_at(x, y)
            if depth is None:
                continue
            shade = terrain.shade(x, depth)
            if shade > 0.16 + 0.45 * unit(i, j, 3):
                line = stroke(terrain, x, depth, 1.2 + 5 * shade, 0.12)
                if len(line) > 3:
                    layer.polyline(simplified(line, 0.08))


def landscape():
    art = Artwork("Hatched landscape", ("420mm", "297mm"), (0, 0, 420, 297), (140, 40, 210, 168))
    terrain = Terrain()
    firs = forest(terrain)
    terrain.hide_behind(firs)
    water(art.layer("Water", BLUE, 0.3), gold := art.layer("Sun", GOLD, 0.3), terrain)
    sun(gold, terrain)
    sky(art.layer("Sky", GREY, 0.2), terrain)
    mountains = art.layer("Mountains", INK, 0.25)
    skyline(mountains, terrain)
    profiles(mountains, terrain, 2)
    hatching(mountains, terrain, 0.75, 2.0)
    wood = art.layer("Forest", GREEN, 0.25)
    for fir in firs:
        for run in runs(*fir.drawn(terrain)):
            if len(run) > 3:
                wood.polyline(run)
    boat(art.layer("Boat", INK, 0.3))
    return art
