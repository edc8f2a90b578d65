# SPDX-License-Identifier: GPL-3.0-or-later
"""Times KLayout's redraw of the lines of a CSV file (x0,y0,x1,y1), fitted to a picture:
QT_QPA_PLATFORM=offscreen klayout -z -nc -rx -r klayout_redraw.py -rd path=FILE.csv -rd size=1920x1080"""
import time

import pya

layout = pya.Layout()
layout.dbu = 0.001
shapes = layout.create_cell("TOP").shapes(layout.layer(1, 0))
for row in open(path):  # noqa: F821: KLayout sets the names given with -rd
    try:
        x0, y0, x1, y1 = (round(float(number) * 1000) for number in row.split(",")[:4])
    except ValueError:  # the head
        continue
    shapes.insert(pya.Edge(x0, y0, x1, y1))
view = pya.LayoutView()
view.show_layout(layout, False)
view.max_hier()
view.add_missing_layers()
view.zoom_fit()
width, height = (int(side) for side in size.split("x"))  # noqa: F821
times = []
for _ in range(5):
    start = time.monotonic()
    view.get_pixels(width, height)
    times.append((time.monotonic() - start) * 1000)
print(f"{'KLayout, a redraw':34}median {sorted(times)[2]:.1f} ms, worst {max(times):.1f} ms", flush=True)
