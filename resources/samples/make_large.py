#!/usr/bin/env python3
# SPDX-License-Identifier: CC0-1.0
"""Makes a drawing for measurements: make_large.py LINES OUT.svg

Short lines, 3 to 17 pixels long when the whole drawing fits 1280 × 800 pixels. Polylines of ten to
forty lines follow a flow, so that neighbours in the file are neighbours on the page, as in real art.
"""

import random
import sys
from math import cos, pi, sin
from pathlib import Path

sys.dont_write_bytecode = True

from drawings.artwork import Artwork

WIDTH, HEIGHT = 400, 250
PIXEL = WIDTH / 1280


def direction(x, y):
    """The flow: whirls some 60 mm across."""
    return 2 * pi * (sin(x / 31 + 1.7 * sin(y / 43)) + cos(y / 29 - 1.3 * sin(x / 57))) / 2


def curl(uniform, count):
    x, y = WIDTH * uniform(), HEIGHT * uniform()
    points = [(x, y)]
    while len(points) <= count:
        angle, length = direction(x, y) + 0.3 * (uniform() - 0.5), PIXEL * (3.2 + 13.6 * uniform())
        x, y = x + length * cos(angle), y + length * sin(angle)
        if not (0 <= x <= WIDTH and 0 <= y <= HEIGHT):
            break
        points.append((x, y))
    return points


def large(lines):
    art = Artwork(f"{lines} short lines", ("400mm", "250mm"), (0, 0, WIDTH, HEIGHT), (100, 62.5, 200, 125))
    layer = art.layer("Lines", "#22252B", 0.2)
    uniform = random.Random(1).random
    while layer.lines < lines:
        layer.polyline(curl(uniform, min(10 + int(30 * uniform()), lines - layer.lines)))
    return art


if len(sys.argv) != 3 or not sys.argv[1].isdigit():
    sys.exit(__doc__.splitlines()[0])
Path(sys.argv[2]).write_text(large(int(sys.argv[1])).svg(), encoding="utf-8")
