# SPDX-License-Identifier: MIT
# %% [markdown]
# # Cutting line art with clearcut
# Each cell makes lines, cuts them, and draws what is left into a picture in the current folder: with matplotlib if it is
# installed, otherwise as SVG. Editors such as VS Code, Spyder and Jupyter (jupytext) run this file cell by cell.

# %%
import numpy as np

import clearcut

try:
    from matplotlib.collections import LineCollection
    from matplotlib.figure import Figure
except ImportError:
    LineCollection = None


def picture(name, bounds, *layers):
    """Draws layers (polylines, colour, width) at the scale of the bounds (xmin, ymin, xmax, ymax). Returns the figure."""
    xmin, ymin, xmax, ymax = bounds
    if LineCollection is None:
        with open(f"{name}.svg", "w") as file:
            print(f'<svg xmlns="http://www.w3.org/2000/svg" width="800" viewBox="{xmin} {-ymax} {xmax - xmin} {ymax - ymin}">', file=file)
            for lines, colour, width in layers:
                d = " ".join("M" + " ".join(f"{x:.3f},{-y:.3f}" for x, y in line) for line in lines)
                print(f'<path fill="none" stroke="{colour}" stroke-width="{width / 4}" d="{d}"/>', file=file)
            print("</svg>", file=file)
        return None
    figure = Figure(figsize=(8, 8 * (ymax - ymin) / (xmax - xmin)))
    axes = figure.add_axes((0, 0, 1, 1), xlim=(xmin, xmax), ylim=(ymin, ymax), aspect="equal")
    axes.set_axis_off()
    for lines, colour, width in layers:
        axes.add_collection(LineCollection(lines, colors=colour, linewidths=width))
    figure.savefig(f"{name}.png", dpi=100)
    return figure


def outline(corners):
    return np.vstack([corners, corners[:1]])


# %% [markdown]
# ## A hexagon filled with hatching
# Hatching is one array of segments, shape (n, 4). A convex polygon cuts it; the pieces are views, ready for LineCollection
# after `reshape(-1, 2, 2)`.

# %%
PAGE = (-110, -80, 110, 80)
angles = np.radians(np.arange(0, 360, 60))
hexagon = 70 * np.column_stack([np.cos(angles), np.sin(angles)])
offsets = np.arange(-250, 250, 2.0)
hatching = np.column_stack([offsets - 200, np.full_like(offsets, -200), offsets + 200, np.full_like(offsets, 200)])

filled = clearcut.clip(hatching, polygon=hexagon)
print(len(filled.segments), "of", len(hatching), "hatch lines cross the hexagon")
picture("hexagon", PAGE, (filled.segments.reshape(-1, 2, 2), "#2a6f97", 1), ([outline(hexagon)], "black", 2))

# %% [markdown]
# ## The inside and the outside
# `split` gives both. Together they are all lines, so the outside can be drawn pale, or with another pen.

# %%
window = (-60, -40, 60, 40)
radii, turns = np.linspace(5, 100, 120), np.linspace(0, 2 * np.pi, 181)
star = np.array([(r * (1 + 0.3 * np.cos(5 * turns))) * [np.cos(turns), np.sin(turns)] for r in radii]).transpose(0, 2, 1)
segments = np.concatenate([star[:, :-1], star[:, 1:]], axis=2).reshape(-1, 4)

inside, outside = clearcut.split(segments, window)
print(len(inside.segments), "pieces inside,", len(outside.segments), "outside")
picture("inside_and_outside", PAGE, (outside.segments.reshape(-1, 2, 2), "#cccccc", 0.7),
        (inside.segments.reshape(-1, 2, 2), "#c1121f", 0.7))

# %% [markdown]
# ## Polylines that stay whole
# A plotter lifts its pen between lines. `clip_lines` keeps a line in one part from where it enters to where it leaves.

# %%
t = np.linspace(0, 60 * np.pi, 6000)
spiral = np.column_stack([t * np.cos(t), 0.7 * t * np.sin(t)]) / 1.8
parts = clearcut.clip_lines([spiral], window)
print("the spiral has", len(parts), "parts, the longest of", max(map(len, parts)), "points")
picture("spiral", PAGE, (parts, "#386641", 1), ([outline(np.array([(-60, -40), (60, -40), (60, 40), (-60, 40)]))], "black", 1))

# %% [markdown]
# ## One drawing, many sheets
# For panning and for tiles the window moves and the drawing stays: `Chunks` reads only what is near the window's edges.

# %%
chunks = clearcut.Chunks(segments)
sheets = [(x, y, x + 50, y + 50) for x in (-100, -50, 0, 50) for y in (-75, -25, 25)]
gap = np.array([6.0, 6.0])
layers = []
for i, (xmin, ymin, xmax, ymax) in enumerate(sheets):
    pieces = chunks.clip((xmin, ymin, xmax, ymax)).segments.reshape(-1, 2, 2)
    layers.append((pieces + gap * divmod(i, 3), "#6a4c93", 0.7))
print([len(pieces) for pieces, _, _ in layers], "pieces on the sheets")
picture("sheets", (-105, -80, 125, 95), *layers)
