# SPDX-License-Identifier: CC0-1.0
"""Firs on the lower slopes of a terrain."""

from dataclasses import dataclass
from math import hypot

from .noise import fractal, unit
from .terrain import COLUMNS, STEP_DEPTH, STEP_X, WIDTH

ACROSS, BACK, FARTHEST = 2.5, 3.75, 130


@dataclass
class Fir:
    x: float
    depth: float
    foot: float  # its y on the page
    size: float
    seed: int

    def half(self, down):
        """Half the width at a part of the height, from 0 at the tip to 1 at the foot."""
        return 0.2 * self.size * down

    def hide(self, horizon):
        reach = self.half(1)
        for i in range(max(0, int((self.x - reach) / STEP_X)), min(COLUMNS, int((self.x + reach) / STEP_X) + 2)):
            aside = abs(STEP_X * i - self.x) / reach
            if aside < 1:
                horizon[i] = min(horizon[i], self.foot - self.size * (1 - aside))

    def drawn(self, terrain):
        """A zigzag from tip to foot and, for each of its points, whether it is visible."""
        turns = max(5, int(self.size / 0.45))
        points = [(self.x, self.foot - self.size)]
        for k in range(1, turns):
            down = k / turns
            side = self.half(down) * (0.75 + 0.5 * unit(self.seed, k)) * (1 if k % 2 else -1)
            points.append((self.x + side, self.foot - self.size * (1 - down) + (0.12 if k % 2 else 0) * self.size / turns))
        points.append((self.x, self.foot))
        before = terrain.horizons[round(self.depth / STEP_DEPTH)]
        shown = [y < before[min(max(round(x / STEP_X), 0), COLUMNS - 1)] for x, y in points]
        return points, shown


def forest(terrain):
    """Trees, dense where the noise is high, and none on steep or high ground."""
    firs = []
    for j in range(1, int(FARTHEST / BACK)):
        for i in range(int(WIDTH / ACROSS)):
            x, depth = ACROSS * (i + unit(i, j, 11)), BACK * (j + 0.8 * unit(i, j, 12))
            steep = hypot(*terrain.slope(x, depth))
            wanted = 0.75 + 1.1 * fractal(x / 55, depth / 30, 3, 60) - terrain.height(x, depth) / 26 - 0.5 * steep
            if wanted > unit(i, j, 13):
                size = (8.5 - 5.5 * depth / FARTHEST) * (0.75 + 0.5 * unit(i, j, 14))
                firs.append(Fir(x, depth, terrain.on_page(x, depth), size, 997 * i + j))
    return firs
