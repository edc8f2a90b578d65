#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints COUNT scattered lines as CSV: make_lines.py COUNT [plain|layers|colours] > lines.csv

plain: all of one style; layers: ten layers, each of a colour; colours: every line of its own."""
import math
import random
import sys

count, kind = int(sys.argv[1]), sys.argv[2] if len(sys.argv) > 2 else "plain"
draw = random.Random(1)
print("x1,y1,x2,y2" + ("" if kind == "plain" else ",layer,colour,width"))
for i in range(count):
    x, y = draw.uniform(0, 1280), draw.uniform(0, 800)
    length, angle = draw.uniform(3, 17), draw.uniform(0, 2 * math.pi)
    row = f"{x:.3f},{y:.3f},{x + length * math.cos(angle):.3f},{y + length * math.sin(angle):.3f}"
    colour = i * 10 // count * 1500000 if kind == "layers" else draw.randrange(1 << 24)
    layer = i * 10 // count if kind == "layers" else 0
    print(row if kind == "plain" else f"{row},Layer {layer},#{colour:06x},0.5")
