# SPDX-License-Identifier: CC0-1.0
"""The figures of D. Matthes, V. Drakopoulos, Another Simple but Faster Method for 2D Line Clipping."""

import random

from .artwork import Artwork
from .stroke_letters import write

INK, MUTED, BLUE, PLUM = "#22252B", "#8A9099", "#2A6690", "#6C2F79"
VIEW = (0, 0, 240, 160)
WINDOW = (80, 50, 80, 60)
LEFT, TOP, RIGHT, BOTTOM = 80, 50, 160, 110


def random_lines():
    """The paper's experiment: its space, its window, and ends anywhere in the space."""
    art = Artwork("The paper's random lines", ("480mm", "360mm"), (-960, -720, 1920, 1440), (-100, -75, 200, 150))
    layer = art.layer("Lines", INK, 1)
    uniform = random.Random(2019).random
    for _ in range(1500):
        ends = [(-960 + 1920 * uniform(), -720 + 1440 * uniform()) for _ in range(2)]
        layer.polyline(ends)
    return art


def figure(title):
    """A page with the four lines that divide the plane into nine regions."""
    art = Artwork(title, ("240mm", "160mm"), VIEW, WINDOW)
    layer = art.layer("Regions", MUTED, 0.25, locked=True)
    for x in (LEFT, RIGHT):
        layer.polyline([(x, 6), (x, 154)])
    for y in (TOP, BOTTOM):
        layer.polyline([(6, y), (234, y)])
    return art


def named(layer, lines):
    """Lines with their letters: (letter, x1, y1, x2, y2, letter's x, letter's y)."""
    for letter, x1, y1, x2, y2, x, y in lines:
        layer.polyline([(x1, y1), (x2, y2)])
        write(layer, letter, x, y, 4)


def nine_regions():
    """The regions of Cohen and Sutherland with their outcodes: bits y > ymax, y < ymin, x > xmax, x < xmin."""
    art = figure("The nine regions")
    codes = art.layer("Outcodes", MUTED, 0.35)
    for row, (y, vertical) in enumerate(((14, "01"), (58, "00"), (146, "10"))):
        for x, horizontal in ((20, "01"), (120, "00"), (220, "10")):
            write(codes, vertical + horizontal, x, y, 5)
    named(art.layer("Inside", INK, 0.5), [("A", 92, 98, 128, 72, 88, 100)])
    named(
        art.layer("Cut", BLUE, 0.5),
        [
            ("B", 28, 96, 112, 68, 24, 98),
            ("C", 140, 22, 136, 92, 140, 18),
            ("D", 60, 134, 196, 66, 56, 137),
            ("E", 110, 100, 158, 140, 162, 142),
        ],
    )
    named(
        art.layer("Outside", PLUM, 0.5),
        [
            ("F", 52, 76, 72, 34, 50, 80),
            ("G", 92, 34, 176, 24, 88, 35),
            ("H", 196, 130, 226, 84, 193, 133),
            ("I", 34, 40, 106, 20, 30, 42),
        ],
    )
    return art


def rejected_lines():
    """A to D each lie beyond one edge, however many regions they cross. E to H lie beyond no single
    edge and still miss the window. I touches its corner in a single point."""
    art = figure("The rejected lines")
    named(
        art.layer("Rejected at once", INK, 0.5),
        [
            ("A", 56, 22, 30, 138, 57, 18),
            ("B", 34, 30, 206, 12, 30, 31),
            ("C", 212, 28, 184, 142, 213, 24),
            ("D", 46, 138, 202, 152, 42, 137),
        ],
    )
    named(
        art.layer("Rejected after cutting", PLUM, 0.5),
        [
            ("E", 56, 72, 98, 26, 53, 75),
            ("F", 150, 28, 186, 80, 147, 25),
            ("G", 148, 134, 188, 90, 145, 137),
            ("H", 54, 84, 92, 132, 51, 81),
        ],
    )
    named(art.layer("Touches a corner", BLUE, 0.5), [("I", 150, 120, 176, 94, 147, 122)])
    return art
