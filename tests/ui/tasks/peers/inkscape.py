#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Plays ten of the forty tasks in Inkscape. Its y axis points down; lengths in mm."""
import math
import re
import sys
import time
import xml.etree.ElementTree as ElementTree

from player import Player, box, play, rotated

EMPTY = """<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"
xmlns:sodipodi="http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd" width="210mm" height="297mm" viewBox="0 0 210 297">
<sodipodi:namedview inkscape:document-units="mm"/><g id="layer1" inkscape:label="Layer 1" inkscape:groupmode="layer"/>
</svg>"""
PATH_DATA = (767, 510)  # the row "d" of the XML editor, in a maximised window of 1440 x 900
CLOSE_XML = (892, 187)
ALIGN_LEFT, EQUAL_GAPS_DOWN = (1198, 340), (1266, 470)


class Inkscape(Player):
    def __init__(self):
        super().__init__(["sh", "-c", 'cat > drawn.svg && exec inkscape drawn.svg'], stdin=EMPTY)
        window = self.wait_for("drawn.svg")
        time.sleep(3)
        self.send("windowactivate", "--sync", window)

    def path(self, data, copied=None):
        """Draws any path and types its data into the XML editor; `copied` is typed once and pasted 7 times."""
        self.key("b")
        self.click(500, 400)
        self.click(600, 500)
        self.key("Return", "ctrl+shift+x")
        self.wait_for("XML Editor")
        self.click(*PATH_DATA)
        time.sleep(1)
        self.key("ctrl+a")
        if copied:
            self.type(copied)
            self.key("ctrl+a", "ctrl+c", *["ctrl+v"] * 7, "ctrl+Home")
        self.type(data)
        self.key("Return")

    def to_canvas(self):
        self.key("F1")
        time.sleep(0.5)

    def fields(self, *values):
        """Types into the fields X, Y, W and H of the selection tool."""
        self.key("alt+x")
        for number, value in enumerate(values):
            if number:
                self.key("Tab")
            self.type(str(value))
        self.key("Return")

    def field(self, x, y, text):
        """Clicks a field and replaces what it holds."""
        self.click(x, y)
        self.key("ctrl+a")
        self.type(text)

    def saved(self):
        self.send("search", "--name", "drawn.svg - Inkscape", "windowactivate")
        self.send("key", "ctrl+s")
        time.sleep(3)
        return read_svg(ElementTree.parse(self.file("drawn.svg")).getroot())


def times(a, b):
    """The product of two matrices (a, b, c, d, e, f)."""
    return (a[0] * b[0] + a[2] * b[1], a[1] * b[0] + a[3] * b[1], a[0] * b[2] + a[2] * b[3],
            a[1] * b[2] + a[3] * b[3], a[0] * b[4] + a[2] * b[5] + a[4], a[1] * b[4] + a[3] * b[5] + a[5])


def matrix(text):
    result = (1, 0, 0, 1, 0, 0)
    for name, arguments in re.findall(r"(\w+)\(([^)]*)\)", text or ""):
        n = [float(x) for x in re.findall(r"[-+.\deE]+", arguments)]
        if name == "rotate":
            c, s = math.cos(math.radians(n[0])), math.sin(math.radians(n[0]))
            x, y = n[1:] or (0, 0)
            n = (c, s, -s, c, x - c * x + s * y, y - s * x - c * y)
        elif name == "translate":
            n = (1, 0, 0, 1, n[0], (n + [0])[1])
        elif name == "scale":
            n = (n[0], 0, 0, n[-1], 0, 0)
        result = times(result, n)
    return result


def read_path(data):
    """The nodes of each subpath."""
    paths, x, y, letter = [], 0, 0, ""
    words = re.findall(r"[A-Za-z]|[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?", data)
    while words:
        if words[0].isalpha():
            letter = words.pop(0)
        if letter in "zZ":
            paths[-1].append(paths[-1][0])
            x, y = paths[-1][0]
            continue
        relative = letter.islower()
        if letter in "hH":
            x = float(words.pop(0)) + x * relative
        elif letter in "vV":
            y = float(words.pop(0)) + y * relative
        else:
            del words[:{"C": 4, "A": 5}.get(letter.upper(), 0)]
            x, y = float(words.pop(0)) + x * relative, float(words.pop(0)) + y * relative
        if letter in "mM":
            paths.append([])
            letter = "l" if relative else "L"
        paths[-1].append((x, y))
    return [path for path in paths if len(path) > 1]


def circle(path):
    """The circle through nodes that are spread evenly on it."""
    nodes = list({(round(x, 9), round(y, 9)) for x, y in path})
    centre = [sum(values) / len(nodes) for values in zip(*nodes)]
    return (*centre, max(math.dist(centre, node) for node in nodes))


def read_svg(root, outer=(1, 0, 0, 1, 0, 0), start=None):
    """The straight paths as lists of points, circles as (x, y, radius)."""
    start = root if start is None else start
    shapes = []
    for element in start:
        m = times(outer, matrix(element.get("transform")))
        name = element.tag.split("}")[-1]

        def at(x, y):
            return m[0] * x + m[2] * y + m[4], m[1] * x + m[3] * y + m[5]

        def number(key):
            return float(element.get(key, 0))
        if name == "g":
            shapes += read_svg(root, m, element)
        elif name == "use":
            target = element.get("{http://www.w3.org/1999/xlink}href")[1:]
            source = ElementTree.Element("g")
            source.append(next(e for e in root.iter() if e.get("id") == target))
            shapes += read_svg(root, m, source)
        elif name == "rect":
            shapes.append([at(*p) for p in box(*map(number, ("x", "y", "width", "height")))])
        elif name in ("circle", "ellipse"):
            radius = number("r") or number("rx")
            shapes.append((*at(number("cx"), number("cy")), radius * math.hypot(m[0], m[1])))
        elif name == "path":
            data = element.get("d")
            paths = [[at(*p) for p in path] for path in read_path(data)]
            shapes += map(circle, paths) if re.search("[cCaA]", data) else paths
    return shapes


def wall(p):
    p.path("M20,30v-3450")
    return [[(20, 30), (20, -3420)]]


def house_plan(p):
    """All walls as one path."""
    p.path("M112,140h68V20H20V140h72M112,134h62V26H26V134h66M65,26v24m0,18v66M101,26v24m0,18v66M137,26v24m0,18v66"
           "M137,80h37")
    shapes = [[(92, 140), (20, 140), (20, 20), (180, 20), (180, 140), (112, 140)],
              [(92, 134), (26, 134), (26, 26), (174, 26), (174, 134), (112, 134)], [(137, 80), (174, 80)]]
    for x in (65, 101, 137):
        shapes += [[(x, 26), (x, 50)], [(x, 68), (x, 134)]]
    return shapes


def stairs(p):
    """All steps as one path."""
    p.path("M20,190", copied="v-170h290")
    points = [(20, 190)]
    for i in range(7):
        points += [(20 + 290 * i, 20 - 170 * i), (310 + 290 * i, 20 - 170 * i)]
    return [points]


def hole_circle(p):
    """The path effect Rotate Copies makes six copies at 60 degrees unless it is told otherwise."""
    p.key("e")
    p.drag((300, 300), (400, 400))
    p.key("s")
    p.fields(10, 10, 80, 80)
    p.key("ctrl+d")
    p.fields(46.7, 6.7, 6.6, 6.6)
    p.key("ctrl+ampersand")
    time.sleep(2)
    p.click(1220, 774)
    time.sleep(2)
    p.type("rot")
    time.sleep(1)
    p.click(251, 273)
    time.sleep(2)
    p.field(1244, 647, "50\n")  # the origin
    p.field(1244, 680, "50\n")
    return [(50, 50, 40)] + [(*rotated([(50, 10)], 60 * i, (50, 50))[0], 3.3) for i in range(6)]


def hexagon(p):
    """Neither the centre nor the flat can be typed; the left end and the height can."""
    p.key("asterisk")
    p.drag((500, 400), (600, 400))
    time.sleep(1)
    p.click(85, 107)  # polygon
    p.field(226, 107, "6\n")
    p.key("s")
    p.fields(50.185, 41.5, 19.63, 17)
    corner = (60 + 17 / math.sqrt(3), 50)
    return [rotated([corner], 60 * i, (60, 50)) + rotated([corner], 60 * i + 60, (60, 50)) for i in range(6)]


def star(p):
    """Three lines by steps of 15 degrees, then all of them turned by 90 degrees."""
    p.path("M60,30v40")
    p.to_canvas()
    p.key(*["ctrl+d", "bracketright", "bracketright"] * 2, "ctrl+a", "ctrl+d", "ctrl+bracketright")
    return [rotated([(60, 70), (60, 30)], 30 * i, (60, 50)) for i in range(6)]


def mirrored_half(p):
    p.path("M40,50h20v20")
    p.to_canvas()
    p.key("ctrl+d", "h")
    p.field(560, 106, "60\n")  # X
    return [[(40, 50), (60, 50), (60, 70)], [(80, 50), (60, 50), (60, 70)]]


def labels(p):
    """Tiled clones with gaps of 10 % of the width and 20 % of the height; the original lies on the first one."""
    p.key("r")
    p.drag((300, 300), (400, 400))
    p.key("s")
    p.fields(10, 10, 30, 15)
    p.click(59, 31)  # menu Edit, Clone, Create Tiled Clones
    for x, y in ((86, 320), (88, 334), (250, 336), (484, 340)):
        p.move(x, y)
        time.sleep(0.3)
    p.click(484, 359)
    p.wait_for("Create Tiled Clones")
    time.sleep(1)
    p.field(624, 592, "4")  # rows
    p.field(744, 592, "5")
    p.click(575, 230)  # tab Shift
    p.field(675, 289, "10")
    p.field(573, 331, "20")
    p.click(942, 698)
    time.sleep(2)
    return [box(10, 10, 30, 15)] + [box(10 + 33 * i, 10 + 18 * j, 30, 15) for i in range(5) for j in range(4)]


def crossing(p):
    """Both lines as one path. Crossings are not snapped to by default: the circle's place is typed."""
    p.path("M20,20L80,60M20,60L80,0")
    p.click(*CLOSE_XML)
    p.key("e")
    p.drag((300, 300), (400, 400))
    p.key("s")
    p.fields(34, 26, 20, 20)
    return [[(20, 20), (80, 60)], [(20, 60), (80, 0)], (44, 36, 10)]


def aligned(p):
    p.key("r")
    p.drag((300, 300), (400, 400))
    p.key("s")
    p.fields(40, 20, 20, 10)
    for corner in ((50, 33), (20, 47), (60, 61), (35, 84), (80, 97), (45, 109), (70, 125)):
        p.key("ctrl+d")
        p.fields(*corner)
    p.key("ctrl+a", "ctrl+shift+a")
    time.sleep(2)
    p.click(*ALIGN_LEFT)
    p.click(*EQUAL_GAPS_DOWN)
    return [box(20, 20 + 15 * i, 20, 10) for i in range(8)]


TASKS = {task.__name__: task for task in (wall, house_plan, stairs, hole_circle, hexagon, star,
                                          mirrored_half, labels, aligned, crossing)}

if __name__ == "__main__":
    play(Inkscape, TASKS, sys.argv[1:])
