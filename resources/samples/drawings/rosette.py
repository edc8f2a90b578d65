# SPDX-License-Identifier: CC0-1.0
"""A guilloche rosette as on banknotes: waves that run between two scalloped circles."""

from math import cos, pi, sin

from .artwork import Artwork, simplified

CENTRE = 148.5
TAU = 2 * pi
INK, BLUE, PLUM = "#22252B", "#2A6690", "#6C2F79"


def scallop(radius, depth=0, lobes=1, turn=0.0):
    """A circle whose radius grows and shrinks; `turn` is in lobes."""
    return lambda angle: radius + depth * cos(lobes * (angle - TAU * turn / lobes))


def strand(inner, outer, waves, phase, points):
    """One closed wave between the two circles."""
    line = []
    for k in range(points):
        angle = TAU * k / points
        low, high = inner(angle), outer(angle)
        radius = (low + high) / 2 + (high - low) / 2 * sin(waves * angle + phase)
        line.append((CENTRE + radius * sin(angle), CENTRE - radius * cos(angle)))
    return line


def band(layer, inner, outer, waves, strands, points=2400):
    for k in range(strands):
        line = strand(inner, outer, waves, TAU * k / strands, points)
        layer.polyline(simplified(line + line[:1], 0.03), closed=True)


def rosette():
    art = Artwork("Guilloche rosette", ("297mm", "297mm"), (0, 0, 297, 297), (48.5, 73.5, 200, 150))
    plum = art.layer("Plum", PLUM, 0.2)
    blue = art.layer("Blue", BLUE, 0.2)
    ink = art.layer("Black", INK, 0.2)
    band(plum, scallop(132), scallop(137.5), 96, 3)
    band(ink, scallop(95, 5, 24, 0.5), scallop(127, 3, 24), 12, 20)
    band(blue, scallop(63, 4, 24, 0.5), scallop(91, 4, 24, 0.5), 18, 14)
    band(plum, scallop(25, 3, 12), scallop(62, 4, 24, 0.5), 12, 15)
    band(ink, scallop(6), scallop(24, 3, 12), 12, 6)
    return art
