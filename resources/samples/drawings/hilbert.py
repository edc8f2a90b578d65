# SPDX-License-Identifier: CC0-1.0
"""Six Hilbert curves joined to one closed curve, three above and three below, each in its own colour.
Every line is horizontal or vertical: special cases of clipping."""

from .artwork import Artwork

SIDE, CELL = 32, 2.85
INKS = ("#28405F", "#2A6690", "#3F5FA6", "#5A4A9C", "#6C2F79", "#8E2F66")


def cells(order, x=0, y=0, along=(1, 0), inward=(0, 1)):
    """The cells of a square of 2^order in the curve's order. It starts at (x, y), ends `along` the
    same side, and the square lies `inward` of it."""
    if order == 0:
        yield (x, y)
        return
    half = 2 ** (order - 1)
    (ax, ay), (ix, iy) = along, inward
    backwards = (-ix, -iy), (-ax, -ay)
    yield from cells(order - 1, x, y, inward, along)
    yield from cells(order - 1, x + half * ix, y + half * iy, along, inward)
    yield from cells(order - 1, x + half * (ax + ix), y + half * (ay + iy), along, inward)
    far = 2 * half - 1
    yield from cells(order - 1, x + far * ax + (half - 1) * ix, y + far * ay + (half - 1) * iy, *backwards)


def hilbert():
    art = Artwork("Hilbert curve", ("297mm", "210mm"), (0, 0, 297, 210), (63.5, 36.5, 170, 137))
    left, top = (297 - CELL * (3 * SIDE - 1)) / 2, (210 - CELL * (2 * SIDE - 1)) / 2
    order = SIDE.bit_length() - 1
    above = [list(cells(order, k * SIDE, SIDE - 1, (1, 0), (0, -1))) for k in range(3)]
    below = [list(cells(order, (k + 1) * SIDE - 1, SIDE, (-1, 0), (0, 1))) for k in (2, 1, 0)]
    parts = above + below
    for k, ink in enumerate(INKS):
        joined = parts[k] + parts[(k + 1) % 6][:1]
        art.layer(f"Part {k + 1}", ink, 0.45).polyline([(left + CELL * x, top + CELL * y) for x, y in joined])
    return art
