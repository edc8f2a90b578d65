# SPDX-License-Identifier: GPL-3.0-or-later
"""Plays events into a program on an X display and counts them as actions."""
import math
import os
import subprocess
import tempfile
import time


class Player:
    """Starts a program with its default settings in an empty home folder."""

    def __init__(self, command, stdin="", pause=0.25):
        self.home = tempfile.mkdtemp()
        self.actions, self.pause = 0, pause
        environment = dict(os.environ, HOME=self.home, LC_ALL="C.UTF-8", GTK_A11Y="none")
        for name in ("XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME"):
            environment.pop(name, None)
        self.program = subprocess.Popen(command, env=environment, cwd=self.home, stdin=subprocess.PIPE,
                                        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, text=True)
        self.program.stdin.write(stdin)
        self.program.stdin.close()

    def file(self, name):
        return os.path.join(self.home, name)

    def close(self):
        self.program.kill()
        self.program.wait()

    # Events that are not counted: what a task needs beside its actions.
    def send(self, *words):
        subprocess.run(["xdotool", *map(str, words)], check=False, stdout=subprocess.DEVNULL)
        time.sleep(self.pause)

    def wait_for(self, title, seconds=60):
        for _ in range(seconds * 2):
            found = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", title], capture_output=True)
            if found.stdout.strip():
                time.sleep(1)
                return found.stdout.split()[-1].decode()
            time.sleep(0.5)
        raise TimeoutError(title)

    def move(self, x, y):
        self.send("mousemove", x - 3, y - 3, "mousemove", x, y)

    # Actions.
    def key(self, *combinations):
        """One action for each key, with its modifiers."""
        for combination in combinations:
            self.send("key", combination)
        self.actions += len(combinations)

    def type(self, text):
        """One action for each character; a line break is Enter."""
        for number, line in enumerate(text.split("\n")):
            if number:
                self.send("key", "Return")
            if line:
                self.send("type", "--delay", "40", line)
        self.actions += len(text)

    def click(self, x, y, hold=None, times=1):
        self.move(x, y)
        around = (["keydown", hold], ["keyup", hold]) if hold else ([], [])
        self.send(*around[0], "click", "--repeat", times, "--delay", 60, 1, *around[1])
        self.actions += times

    def drag(self, start, end):
        self.move(*start)
        self.send("mousedown", 1)
        for part in (0.3, 0.7, 1):
            self.send("mousemove", *(round(a + (b - a) * part) for a, b in zip(start, end)))
        self.send("mouseup", 1)
        self.actions += 1


def rotated(points, degrees, centre=(0, 0)):
    """Counter-clockwise where y points up."""
    sine, cosine = math.sin(math.radians(degrees)), math.cos(math.radians(degrees))
    x0, y0 = centre
    return [(x0 + cosine * (x - x0) - sine * (y - y0), y0 + sine * (x - x0) + cosine * (y - y0)) for x, y in points]


def segments(shapes):
    """Each line as its two ends, each circle as its centre and radius."""
    result = []
    for shape in shapes:
        if isinstance(shape, tuple):
            result.append(shape)
        else:
            result += [(*min(pair), *max(pair)) for pair in zip(shape, shape[1:])]
    return result


def distance(a, b):
    """The largest difference in a coordinate; a segment may also be given backwards."""
    if len(a) != len(b):
        return math.inf
    both = [b, (*b[2:], *b[:2])] if len(b) == 4 else [b]
    return min(max(abs(p - q) for p, q in zip(a, c)) for c in both)


def difference(drawn, expected):
    """The largest error in mm; infinity if the number of segments differs."""
    left, worst = segments(drawn), 0.0
    wanted = segments(expected)
    if len(left) != len(wanted):
        return math.inf
    for one in wanted:
        nearest = min(left, key=lambda other: distance(one, other))
        worst = max(worst, distance(one, nearest))
        left.remove(nearest)
    return worst


def box(x, y, width, height):
    return [(x, y), (x + width, y), (x + width, y + height), (x, y + height), (x, y)]


def play(program, tasks, names):
    """Plays each task in a program of its own and prints its actions and its error."""
    for name in names or tasks:
        player = program()
        try:
            expected = tasks[name](player)
            actions = player.actions
            error = difference(player.saved(), expected)
            print(f"{name:15} {actions:4} actions, error {error:.1e} mm", flush=True)
        finally:
            player.close()
