# SPDX-License-Identifier: CC0-1.0
"""The map of a fictitious town: districts around an old centre, each with its own grid of
streets, on both banks of a river, with a railway, parks and every single house."""

import random
from math import atan2, cos, hypot, pi, sin

from .artwork import Artwork
from .noise import noise
from .polygon import apart, area, centre, cut, edges, extent, holds, inset

WIDTH, HEIGHT, MARGIN = 420, 297, 10
CENTRE = (196, 132)
INK, GREY, BLUE, GREEN, PLUM = "#2B2F36", "#8A9099", "#2A6690", "#3D6B4A", "#6C2F79"
RIVER_HALF, RAIL_HALF = 7.5, 1.6
BRIDGES = (46, 104, 150, 187, 231, 290, 352)


def river(x):
    return 205 + 24 * sin(x / 62 + 0.4) + 0.12 * (210 - x)


def railway(x):
    return 52 + 16 * sin(x / 95 + 2.2) + 0.10 * x


def warped(point):
    """Bends the town a little, less towards the frame, so that no street is straight."""
    x, y = point
    calm = min(1.0, (x - MARGIN) / 25, (WIDTH - MARGIN - x) / 25, (y - MARGIN) / 25, (HEIGHT - MARGIN - y) / 25)
    reach = 11 * max(0.0, calm)
    return x + reach * noise(x / 75, y / 75, 3), y + reach * noise(x / 75, y / 75, 4)


def distance_from_centre(point):
    return hypot(point[0] - CENTRE[0], point[1] - CENTRE[1])


def districts(uniform):
    """Voronoi cells of sites that are closer together in the centre: the polygon and the angle of its streets."""
    sites = [CENTRE]
    for ring, (count, radius) in enumerate(((6, 52), (10, 108), (14, 170), (16, 235))):
        for k in range(count):
            angle = 2 * pi * (k + 0.5 * (ring % 2) + 0.5 * (uniform() - 0.5)) / count
            reach = radius * (0.88 + 0.24 * uniform())
            sites.append((CENTRE[0] + reach * cos(angle), CENTRE[1] + 0.86 * reach * sin(angle)))
    frame = [(MARGIN, MARGIN), (WIDTH - MARGIN, MARGIN), (WIDTH - MARGIN, HEIGHT - MARGIN), (MARGIN, HEIGHT - MARGIN)]
    for sx, sy in sites:
        cell = frame
        for tx, ty in sites:
            if (tx, ty) != (sx, sy):
                cell = cut(cell, ((sx + tx) / 2, (sy + ty) / 2), (sx - tx, sy - ty))
        if cell:
            radial = atan2(sy - CENTRE[1], sx - CENTRE[0])
            yield cell, radial + 0.5 * (uniform() - 0.5)


def blocks(polygon, angle, wanted, uniform):
    """Divides a polygon by streets along and across the angle, until each block is small enough."""
    size = area(polygon)
    if size < wanted * (0.7 + 0.7 * uniform()):
        yield polygon
        return
    axes = [(cos(angle), sin(angle)), (-sin(angle), cos(angle))]
    spans = [extent(polygon, axis) for axis in axes]
    which = 0 if spans[0][1] - spans[0][0] > spans[1][1] - spans[1][0] else 1
    (ux, uy), (low, high) = axes[which], spans[which]
    place = low + (high - low) * (0.42 + 0.16 * uniform())
    half = 0.85 if size > 900 else 0.6 if size > 250 else 0.42
    turned = angle + 0.12 * (uniform() - 0.5)
    for side in (1, -1):
        start = place + side * half
        part = cut(polygon, (start * ux, start * uy), (side * ux, side * uy))
        if len(part) > 2 and area(part) > 3:
            yield from blocks(part, turned, wanted, uniform)


def beside(polygon, course, half):
    """The part of a polygon outside a strip along a course."""
    x, y = centre(polygon)
    slope = course(x + 0.5) - course(x - 0.5)
    length = hypot(1, slope)
    side = 1 if y > course(x) else -1
    normal = (-slope / length * side, side / length)
    place = (x + normal[0] * half, course(x) + normal[1] * half)
    return cut(polygon, place, normal)


def houses(block, closed, uniform):
    """Houses along every edge, wall to wall in the old town, apart in the suburbs, without overlaps."""
    built = []
    for edge in edges(block):
        for house in row_of_houses(edge, closed, uniform):
            if all(holds(block, corner) for corner in house) and all(apart(house, other) for other in built):
                built.append(house)
    return built


def row_of_houses(edge, closed, uniform):
    (x, y), (ux, uy), length = edge
    depth = 1.9 if closed else 1.5
    along = 0.0
    while along < length - 1:
        front = (1.6 + 1.6 * uniform()) if closed else (1.2 + 0.7 * uniform())
        end = min(along + front, length)
        back = depth * (0.7 + 0.5 * uniform())
        set_back = 0 if closed else 0.35
        corners = [(along, set_back), (end, set_back), (end, back), (along, back)]
        if uniform() < (0.95 if closed else 0.86):
            yield [(x + a * ux - b * uy, y + a * uy + b * ux) for a, b in corners]
        along = end + (0 if closed else 0.6 + 0.8 * uniform())


def plant(layer, park, uniform):
    """Trees on a loose grid, and the park's edge."""
    layer.polyline([warped(point) for point in park], closed=True)
    inner = inset(park, 1.3)
    if len(inner) < 3:
        return
    (left, right), (top, bottom) = extent(inner, (1, 0)), extent(inner, (0, 1))
    for i in range(int((right - left) / 1.9) + 1):
        for j in range(int((bottom - top) / 1.9) + 1):
            x, y = left + 1.9 * (i + 0.7 * uniform()), top + 1.9 * (j + 0.7 * uniform())
            if holds(inner, (x, y)) and uniform() < 0.9:
                layer.circle(*warped((x, y)), 0.45 + 0.4 * uniform())


def build(art, uniform):
    parks = art.layer("Parks", GREEN, 0.2)
    kerbs = art.layer("Blocks", GREY, 0.2)
    buildings = art.layer("Houses", INK, 0.2)
    for district, angle in districts(uniform):
        away = distance_from_centre(centre(district))
        wanted = 75 + 0.55 * away
        for block in blocks(inset(district, 1.1), angle, wanted, uniform):
            for course, half in ((river, RIVER_HALF + 1), (railway, RAIL_HALF + 0.6)):
                block = beside(block, course, half) if len(block) > 2 else []
            if len(block) < 3 or area(block) < 6:
                continue
            here = centre(block)
            if noise(here[0] / 34, here[1] / 34, 8) > 0.31:
                plant(parks, block, uniform)
                continue
            kerbs.polyline([warped(point) for point in block], closed=True)
            closed = distance_from_centre(here) < 92 + 40 * noise(here[0] / 50, here[1] / 50, 9)
            for house in houses(inset(block, 0.3), closed, uniform):
                buildings.polyline([warped(point) for point in house], closed=True)


def street_map():
    art = Artwork("Street map", ("420mm", "297mm"), (0, 0, WIDTH, HEIGHT), (120, 64, 160, 120))
    uniform = random.Random(1839).random
    build(art, uniform)
    flow(art.layer("River", BLUE, 0.25), uniform)
    rails(art.layer("Railway", PLUM, 0.25))
    frame(art.layer("Frame", INK, 0.35, locked=True))
    return art


def flow(layer, uniform):
    """Both banks, the water between them in broken lines, and the bridges."""
    steps = [MARGIN + 1.6 * k for k in range(int((WIDTH - 2 * MARGIN) / 1.6) + 1)]
    for lane in range(-6, 7):
        bank = abs(lane) == 6
        run = []
        for x in steps:
            slope = river(x + 0.5) - river(x - 0.5)
            length = hypot(1, slope)
            offset = lane * RIVER_HALF / 6
            along = min(max(x - slope / length * offset, MARGIN), WIDTH - MARGIN)
            point = (along, river(x) + offset / length)
            open_water = not any(abs(point[0] - bridge) < 1.8 for bridge in BRIDGES)
            if bank or (open_water and uniform() > 0.09):
                run.append(warped(point))
            else:
                layer.polyline(run)
                run = []
        layer.polyline(run)
    for bridge in BRIDGES:
        for side in (-0.9, 0.9):
            x = bridge + side
            layer.polyline([warped((x, river(x) + s * (RIVER_HALF + 1.3))) for s in (-1, -0.33, 0.33, 1)])


def rails(layer):
    steps = [MARGIN + 1.2 * k for k in range(int((WIDTH - 2 * MARGIN) / 1.2) + 1)]
    for side in (-0.4, 0.4):
        layer.polyline([warped((x, railway(x) + side)) for x in steps])
    for x in steps:
        layer.polyline([warped((x, railway(x) - 0.85)), warped((x, railway(x) + 0.85))])


def frame(layer):
    """A double frame with a mark every 20 mm."""
    for inner in (MARGIN - 1, MARGIN - 4):
        right, bottom = WIDTH - inner, HEIGHT - inner
        layer.polyline([(inner, inner), (right, inner), (right, bottom), (inner, bottom)], closed=True)
    for x in range(20, WIDTH, 20):
        for y in (MARGIN - 4, HEIGHT - MARGIN + 1):
            layer.polyline([(x, y), (x, y + 3)])
    for y in range(20, HEIGHT, 20):
        for x in (MARGIN - 4, WIDTH - MARGIN + 1):
            layer.polyline([(x, y), (x + 3, y)])
