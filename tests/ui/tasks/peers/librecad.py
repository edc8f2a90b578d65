#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Plays ten of the forty tasks in LibreCAD. Its y axis points up, so that the drawings are mirrored; x and y are mm."""
import math
import sys
import time

from player import Player, box, play, rotated

ORIGIN, SCALE = (92, 731), 4  # pixels, in a maximised window of 1440 x 900


def pixel(x, y):
    return ORIGIN[0] + SCALE * x, ORIGIN[1] - SCALE * y


SOMEWHERE = pixel(230, 20)
END_OF_STEP = (53, 757), (1104, 139)  # after zooming
ZOOM_ALL = (728, 61)
SNAP_ENDS, SNAP_CROSSINGS = (131, 816), (301, 816)  # buttons


class LibreCad(Player):
    def __init__(self):
        super().__init__(["librecad"])
        self.wait_for("Welcome")
        self.send("key", "Return")
        self.wait_for("unnamed document")
        self.move(*SOMEWHERE)
        self.send("key", "ctrl+m")

    def copies(self, number, angle=None):
        """Answers the dialog after a move or a rotation."""
        self.key("alt+m", "Tab")
        self.type(number)
        if angle:
            self.key("Tab", "Tab")
            self.type(angle)
        self.key("Return")

    def saved(self):
        self.send("key", "Escape", "key", "Escape", "key", "ctrl+s")
        self.wait_for("Save Drawing As")
        self.send("type", self.file("drawn.dxf"))
        self.send("key", "Return")
        for _ in range(20):
            time.sleep(0.5)
            try:
                with open(self.file("drawn.dxf"), encoding="utf-8") as file:
                    return read_dxf(file.read())
            except (OSError, IndexError):
                continue
        raise TimeoutError("no file was saved")


def read_dxf(text):
    """The paths of lines and polylines as lists of points, circles as (x, y, radius)."""
    lines = [line.strip() for line in text.splitlines()]
    pairs = list(zip(lines[::2], lines[1::2]))
    paths, current = [], None
    pairs = pairs[pairs.index(("2", "ENTITIES")):]
    for code, value in pairs:
        if code == "0":
            current = {"LINE": [], "LWPOLYLINE": [], "CIRCLE": ["circle"]}.get(value)
            if value == "ENDSEC":
                break
            if current is not None:
                paths.append(current)
        elif current is not None and code in ("10", "20", "11", "21", "40") and (code != "40" or "circle" in current):
            current.append(float(value))
        elif current is not None and code == "70" and value == "1":
            current.insert(0, "closed")
    shapes = []
    for path in paths:
        if path[0] == "circle":
            shapes.append(tuple(path[1:]))
            continue
        closed = path[0] == "closed"
        numbers = path[closed:]
        points = list(zip(numbers[::2], numbers[1::2]))
        shapes.append(points + points[:1] if closed else points)
    return shapes


def wall(p):
    p.type("l\n20,30\n@0,3450\n")
    return [[(20, 30), (20, 3480)]]


def house_plan(p):
    """The gaps are left out while drawing; the last two walls are copies of the third."""
    p.type("l\n20,20\n@160,0\n@0,120\n@-68,0\nl\n92,140\n@-72,0\n20,20\n")
    p.type("l\n26,26\n@148,0\n@0,108\n@-62,0\nl\n92,134\n@-66,0\n26,26\n")
    p.type("l\n65,26\n@0,24\nl\n65,68\n@0,66\nl\n137,80\n@37,0\n")
    p.type("mv\n")
    p.click(*pixel(65, 35))
    p.click(*pixel(65, 100))
    p.key("Return")
    p.click(*SOMEWHERE)
    p.type("@36,0\n")
    p.copies("2")
    shapes = [[(92, 140), (20, 140), (20, 20), (180, 20), (180, 140), (112, 140)],
              [(92, 134), (26, 134), (26, 26), (174, 26), (174, 134), (112, 134)], [(137, 80), (174, 80)]]
    for x in (65, 101, 137):
        shapes += [[(x, 26), (x, 50)], [(x, 68), (x, 134)]]
    return shapes


def stairs(p):
    p.type("pl\n20,10\n@0,170\n@290,0\n")
    p.type("mv\n")
    p.click(*ZOOM_ALL)
    p.click(600, 139)
    p.type("\n")
    p.click(*SNAP_ENDS)
    p.click(*END_OF_STEP[0])
    p.click(*END_OF_STEP[1])
    p.copies("6")
    points = [(20, 10)]
    for i in range(7):
        points += [(20 + 290 * i, 180 + 170 * i), (310 + 290 * i, 180 + 170 * i)]
    return [points]


def hole_circle(p):
    p.type("ci\n50,50\n40\n50,90\n3.3\n")
    p.type("ro\n")
    p.click(*pixel(50 + 3.3, 90))
    p.type("\n50,50\n")
    p.click(*SOMEWHERE)
    p.click(*SOMEWHERE)
    p.copies("5", "60")
    return [(50, 50, 40)] + [(*rotated([(50, 90)], 60 * i, (50, 50))[0], 3.3) for i in range(6)]


def hexagon(p):
    p.click(301, 29)  # menu Tools, Line, Polygon (Cen,Tan)
    for position in ((320, 63), (330, 65), (520, 68)):
        p.move(*position)
        time.sleep(0.5)
    p.click(520, 413)
    p.type("60,50\nn\n6\n@0,8.5\n")
    corner = (60 + 17 / math.sqrt(3), 50)
    return [rotated([corner], 60 * i, (60, 50)) + rotated([corner], 60 * i + 60, (60, 50)) for i in range(6)]


def star(p):
    p.type("l\n60,70\n@0,-40\n")
    p.type("ro\n")
    p.click(*pixel(60, 40))
    p.type("\n60,50\n")
    p.click(*SOMEWHERE)
    p.click(*SOMEWHERE)
    p.copies("5", "30")
    return [rotated([(60, 70), (60, 30)], 30 * i, (60, 50)) for i in range(6)]


def mirrored_half(p):
    p.type("pl\n40,50\n@20,0\n@0,20\n")
    p.type("mi\n")
    p.click(*pixel(50, 50))
    p.type("\n60,0\n60,9\n")
    p.key("alt+k", "Return")
    return [[(40, 50), (60, 50), (60, 70)], [(80, 50), (60, 50), (60, 70)]]


def labels(p):
    p.type("rec\n10,10\n40,25\n")
    p.type("mv\n")
    p.click(*pixel(20, 10))
    p.type("\n")
    p.click(*SOMEWHERE)
    p.type("@33,0\n")
    p.copies("4")
    p.type("sa\nmv\n")
    p.click(*SOMEWHERE)
    p.type("@0,18\n")
    p.copies("3")
    return [box(10 + 33 * i, 10 + 18 * j, 30, 15) for i in range(5) for j in range(4)]


def aligned(p):
    """Nothing is aligned or spread evenly: each rectangle is moved by typed numbers."""
    corners = ((40, 20), (50, 33), (20, 47), (60, 61), (35, 84), (80, 97), (45, 109), (70, 125))
    p.type("rec\n")
    for x, y in corners:
        p.type(f"{x},{y}\n{x + 20},{y + 10}\n")
    for i, (x, y) in enumerate(corners):
        p.type("mv\n" if i == 0 else "tn\nmv\n")  # tn: select nothing
        p.click(*pixel(x + 13, y))
        p.type("\n")
        p.click(*SOMEWHERE)
        p.type(f"@{20 - x},{20 + 15 * i - y}\n\n")
    return [box(20, 20 + 15 * i, 20, 10) for i in range(8)]


def crossing(p):
    p.type("l\n20,20\n80,60\nl\n20,60\n80,0\nci\n")
    p.click(*SNAP_CROSSINGS)
    p.click(*pixel(44.4, 36.3))
    p.type("10\n")
    return [[(20, 20), (80, 60)], [(20, 60), (80, 0)], (44, 36, 10)]


TASKS = {task.__name__: task for task in (wall, house_plan, stairs, hole_circle, hexagon, star,
                                          mirrored_half, labels, aligned, crossing)}

if __name__ == "__main__":
    play(LibreCad, TASKS, sys.argv[1:])
