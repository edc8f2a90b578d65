# SPDX-License-Identifier: CC0-1.0
"""Mountains as a grid of heights, seen from the front and a little from above.

A place is (x, depth) in mm. The page shows it at (x, SHORE - TILT * depth - height).
"""

from bisect import bisect_left
from math import exp, fsum, hypot

from .noise import fractal, ridged

WIDTH, SHORE, TILT = 420, 197, 0.32
STEP_X, STEP_DEPTH = 0.7, 1.25
COLUMNS, ROWS = 601, 240

# Massifs: x, depth, half widths, height.
MASSIFS = (
    (262, 165, 62, 70, 92),
    (212, 120, 30, 40, 26),
    (322, 120, 42, 48, 34),
    (86, 205, 46, 60, 66),
    (385, 225, 44, 60, 60),
    (20, 240, 60, 50, 38),
    (150, 250, 60, 40, 30),
)


def height(x, depth):
    swell = fsum(h * exp(-(((x - mx) / wx) ** 2) - ((depth - md) / wd) ** 2) for mx, md, wx, wd, h in MASSIFS)
    warp = 14 * fractal(x / 70, depth / 70, 2, 40)
    crest = ridged((x + warp) / 64 + 11.5, (depth - warp) / 64 + 46.7, 6, 7)
    shoulder = fractal(x / 45, depth / 45, 4, 90)
    shore = min(1.0, max(0.0, depth / 22))
    rise = swell * (0.45 + 0.8 * crest) + 3.5 * shoulder + 2.5
    return max(0.0, rise) * shore * (2 - shore)


class Terrain:
    """Heights, and for every row the highest place on the page that the rows before it reach."""

    def __init__(self):
        self.heights = [[height(STEP_X * i, STEP_DEPTH * j) for i in range(COLUMNS)] for j in range(ROWS)]
        self.hide_behind([])

    def hide_behind(self, trees):
        """Computes what is hidden: mountains hide each other, and trees hide what is behind them."""
        self.seen = {}
        rows = {}
        for tree in trees:
            rows.setdefault(round(tree.depth / STEP_DEPTH), []).append(tree)
        self.horizons = [[SHORE + 1.0] * COLUMNS]
        for j, row in enumerate(self.heights):
            base = SHORE - TILT * STEP_DEPTH * j
            horizon = [min(h, base - up) for h, up in zip(self.horizons[-1], row)]
            for tree in rows.get(j, []):
                tree.hide(horizon)
            self.horizons.append(horizon)

    def skyline(self, x):
        """The y above which there is only sky."""
        i, u = cell(x / STEP_X, COLUMNS)
        sky = self.horizons[-1]
        return sky[i] + u * (sky[i + 1] - sky[i])

    def height(self, x, depth):
        return bilinear(self.heights, x / STEP_X, depth / STEP_DEPTH)

    def slope(self, x, depth):
        """The rise per mm to the right and per mm backwards."""
        right = self.height(x + 0.7, depth) - self.height(x - 0.7, depth)
        back = self.height(x, depth + 1.2) - self.height(x, depth - 1.2)
        return right / 1.4, back / 2.4

    def on_page(self, x, depth):
        return SHORE - TILT * depth - self.height(x, depth)

    def visible(self, x, depth):
        before = bilinear(self.horizons, x / STEP_X, depth / STEP_DEPTH)
        return self.on_page(x, depth) < before + 0.12

    def shade(self, x, depth):
        """0 where the sun at the left shines on it, up to 1 where it is turned away."""
        right, back = self.slope(x, depth)
        light = (0.78 * right + 0.10 * back + 0.55) / hypot(1, right, back)
        return min(1.0, max(0.0, 0.62 - light) / 1.0)

    def depth_at(self, x, y):
        """The depth of the point that is visible at a place of the page; None in the sky."""
        column = min(int(x / STEP_X), COLUMNS - 1)
        if column not in self.seen:
            self.seen[column] = self.see(column)
        ups, depths = self.seen[column]
        k = bisect_left(ups, -y)
        return depths[k] if 0 < k < len(ups) else None

    def see(self, column):
        """The visible points of a column from the bottom up: the negative y, and the depths."""
        ups, depths, top = [], [], SHORE + 1.0
        for j in range(ROWS):
            y = SHORE - TILT * STEP_DEPTH * j - self.heights[j][column]
            if y < min(top, self.horizons[j][column]):
                ups.append(-y)
                depths.append(STEP_DEPTH * j)
                top = y
        return ups, depths


def runs(points, shown):
    """The parts of a polyline whose points are shown, each of at least two points."""
    run = []
    for point, visible in zip(points, shown):
        if visible:
            run.append(point)
            continue
        if len(run) > 1:
            yield run
        run = []
    if len(run) > 1:
        yield run


def cell(place, count):
    """The grid cell of a place and the position in that cell, kept inside the grid."""
    place = min(max(place, 0.0), count - 1.001)
    return int(place), place - int(place)


def bilinear(grid, x, y):
    i, u = cell(x, len(grid[0]))
    j, v = cell(y, len(grid))
    low = grid[j][i] + u * (grid[j][i + 1] - grid[j][i])
    high = grid[j + 1][i] + u * (grid[j + 1][i + 1] - grid[j + 1][i])
    return low + v * (high - low)
