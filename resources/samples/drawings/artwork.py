# SPDX-License-Identifier: CC0-1.0
"""A drawing of layers of polylines and circles, and its text as SVG.

Everything is in user units. Numbers are written with DECIMALS places and no more, so that the text
is short and the same on every machine, whatever the last bit of its sine.
"""

import math

DECIMALS = 2
CLEARCUT = "urn:clearcut:1"

HEAD = """<?xml version="1.0" encoding="UTF-8"?>
<!-- SPDX-License-Identifier: CC0-1.0 -->
<!-- Made by make_samples.py. -->
<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"\
 xmlns:sodipodi="http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd" xmlns:clearcut="{namespace}"
 width="{width}" height="{height}" viewBox="{view}" fill="none" stroke-linecap="round" stroke-linejoin="round">
<title>{title}</title>
<metadata><clearcut:window xmin="{window[0]}" ymin="{window[1]}" xmax="{window[2]}" ymax="{window[3]}"/></metadata>
"""


def number(value, decimals=DECIMALS):
    """The shortest text of a rounded number: -0.50 becomes -.5"""
    text = f"{value:.{decimals}f}"
    if "." in text:
        text = text.rstrip("0").rstrip(".")
    if text == "-0":
        return "0"
    return text.replace("0.", ".", 1) if text.lstrip("-").startswith("0.") else text


def pairs(points):
    """The points as text, without points that are equal to their predecessor after rounding."""
    texts = []
    for x, y in points:
        text = number(x) + ("" if number(y).startswith("-") else " ") + number(y)
        if not texts or texts[-1] != text:
            texts.append(text)
    return texts


class Layer:
    def __init__(self, name, ink, width, locked=False):
        self.name, self.ink, self.width, self.locked = name, ink, width, locked
        self.elements = []
        self.lines = 0

    def polyline(self, points, closed=False):
        """A closed polyline does not repeat its first point. One that rounds to a single point is left out."""
        texts = pairs(points)
        if closed and len(texts) > 1 and texts[0] == texts[-1]:
            texts.pop()
        if len(texts) < 2:
            return
        self.lines += len(texts) - (0 if closed else 1)
        self.elements.append(f'<path d="M{" ".join(texts)}{"z" if closed else ""}"/>')

    def circle(self, x, y, radius):
        self.lines += 1
        self.elements.append(f'<circle cx="{number(x)}" cy="{number(y)}" r="{number(radius)}"/>')

    def svg(self):
        lock = ' sodipodi:insensitive="true"' if self.locked else ""
        head = f'<g inkscape:groupmode="layer" inkscape:label="{self.name}"{lock}'
        head += f' stroke="{self.ink}" stroke-width="{number(self.width)}">'
        return "\n".join([head, *self.elements, "</g>"])


class Artwork:
    """view and window are (x, y, width, height); size is the size of the page on paper."""

    def __init__(self, title, size, view, window):
        self.title, self.size, self.view, self.window = title, size, view, window
        self.layers = []

    def layer(self, *arguments, **options):
        self.layers.append(Layer(*arguments, **options))
        return self.layers[-1]

    def lines(self):
        """The number of lines; a circle counts as one."""
        return sum(layer.lines for layer in self.layers)

    def svg(self):
        x, y, width, height = self.window
        head = HEAD.format(
            namespace=CLEARCUT,
            width=self.size[0],
            height=self.size[1],
            view=" ".join(number(value) for value in self.view),
            window=[number(value) for value in (x, y, x + width, y + height)],
            title=self.title,
        )
        return head + "\n".join(layer.svg() for layer in self.layers) + "\n</svg>\n"


def simplified(points, tolerance):
    """The polyline without the points that are nearer than the tolerance to the remaining polyline."""
    keep = [False] * len(points)
    keep[0] = keep[-1] = True
    open_runs = [(0, len(points) - 1)]
    while open_runs:
        first, last = open_runs.pop()
        (ax, ay), (bx, by) = points[first], points[last]
        length = math.hypot(bx - ax, by - ay) or 1e-9
        far, where = tolerance, None
        for k in range(first + 1, last):
            x, y = points[k]
            distance = abs((bx - ax) * (y - ay) - (by - ay) * (x - ax)) / length
            if length < 1e-6:
                distance = math.hypot(x - ax, y - ay)
            if distance > far:
                far, where = distance, k
        if where is not None:
            keep[where] = True
            open_runs += [(first, where), (where, last)]
    return [point for point, kept in zip(points, keep) if kept]
