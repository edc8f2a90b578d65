#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints the table of frames in figures.md as Markdown: frames_table.py BUILD [DRAWING...]

BUILD is a build folder with the benchmarks; drawings as of drawings.h. Each column is a run of
benchmarks.frames at 1920 x 1080, then of benchmarks.opening with a CSV and an SVG file, and of KLayout, if it
is installed, with the same CSV file. Twenty minutes for all drawings."""
import os
import re
import shutil
import subprocess
import sys
import tempfile

DRAWINGS = "table1000000", "map1000000", "table10000000", "long100000", "long1000000", "colours1000000", "long10000000"
HERE = os.path.dirname(os.path.abspath(__file__))
ENVIRONMENT = dict(os.environ, QT_QPA_PLATFORM="offscreen")
ROWS = {  # in the table: what the programs print
    "first picture": "in full quality after",
    "pan, until it is seen": "panning, until it is seen",
    "zoom, the scaled picture": "frame while zooming",
    "the window moves: the interface held": "frame while the window moves",
    "the window moves: `exact`, until its cut is seen": "exact",
    "Cohen-Sutherland (clipping, processor time)": "cohen-sutherland",
    "Matthes-Drakopoulos": "matthes-drakopoulos",
    "KWC as published": "kodituwakku-wijeweera-chamikara:published",
    "midpoint subdivision": "midpoint-subdivision",
    "12 panes, until all cuts are seen": "the cut is seen in panes: 12",
    "sum of the rows' clip times": "sum of the algorithms' medians",
    "full quality after a zoom, worst": "full quality after rest",
    "memory at most, MB": "memory at most",
    "open CSV": "csv",
    "open SVG": "svg",
    "KLayout, a redraw": "KLayout, a redraw",
}


def lines_of(command):
    ended = subprocess.run(command, text=True, env=ENVIRONMENT, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    if ended.returncode != 0:
        print("failed:", *command, file=sys.stderr)
    return ended.stdout.splitlines()


def short(number):
    return f"{float(number):.{0 if float(number) >= 20 else 1}f}"


def figure(line):
    """The figure of a printed line as (name, text)."""
    if row := re.match(r"(.+?)(?: {2,}|(?<=published))([\d.e+-]+), ([\d.e+-]+), [\d.e+-]+, \d+$", line):
        return row[1].strip(), f"{short(row[3])} ({short(row[2])})"
    if row := re.match(r"(.+?) +median ([\d.e+-]+) ms, worst ([\d.e+-]+)", line):
        worst = row[1] == "full quality after rest"
        return row[1], short(row[3] if worst else row[2])
    if row := re.search(r"(in full quality after|all of that) +([\d.e+-]+) ms", line):
        return row[1], short(row[2])
    if row := re.match(r"(.+?) +([\d.e+-]+) (?:ms|MB)", line):
        return row[1], short(row[2])
    return None


def figures(build, drawing, folder):
    programs = os.path.join(build, "tests", "benchmarks", "benchmarks.")
    found = dict(filter(None, map(figure, lines_of([programs + "frames", drawing, "raster", "1920x1080"]))))
    for kind in "csv", "svg":
        path = os.path.join(folder, "lines." + kind)
        subprocess.run([programs + "opening", path, drawing], env=ENVIRONMENT, check=True, stderr=subprocess.DEVNULL)
        opened = dict(filter(None, map(figure, lines_of([programs + "opening", path]))))
        found[kind] = opened.get("all of that", "failed")
    if shutil.which("klayout"):
        script = os.path.join(HERE, "klayout_redraw.py")
        path = os.path.join(folder, "lines.csv")
        printed = lines_of(["klayout", "-z", "-nc", "-rx", "-r", script, "-rd", "path=" + path, "-rd", "size=1920x1080"])
        found.update(filter(None, map(figure, printed)))
    return found


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    drawings = sys.argv[2:] or DRAWINGS
    columns = []
    for drawing in drawings:
        with tempfile.TemporaryDirectory() as folder:
            columns.append(figures(sys.argv[1], drawing, folder))
        print(drawing, columns[-1], file=sys.stderr, flush=True)
    print("| ms | " + " | ".join(drawings) + " |\n|---" + "|---" * len(drawings) + "|")
    for row, name in ROWS.items():
        print(f"| {row} | " + " | ".join(column.get(name, "–") for column in columns) + " |")


main()
