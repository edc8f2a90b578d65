#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares cut drawings with the same drawings behind an SVG clipPath, painted by Chromium.

    tests/pictures/foreign_cuts.py CLEARCUT FOLDER [NUMBER [REPORT]]

takes NUMBER (300) SVG files below FOLDER, cuts each at a window (upright, rotated, round, star-shaped, with a hole, or
kept outside) with the program CLEARCUT, and writes a report in Markdown. Needs Debian's chromium, librsvg2-bin,
python3-numpy, python3-pil, and for the files openclipart-svg. Not a part of ctest: Chromium has 300 MB.

Three pictures of each drawing, as fills alone and with strokes:
    reference   the file as it is, behind a clipPath
    import      the file converted by CLEARCUT, behind the same clipPath
    cut         the file cut by CLEARCUT
cut and import must agree (the cut is right). Where import and reference differ, the reason is what the import
reports, or a difference of Chromium and rsvg-convert. CLEARCUT cuts at the centre line, with butt ends, so strokes
are compared only where no window's edge is nearer than twice the widest stroke (its mitres).
"""

import math
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy
from PIL import Image, ImageDraw

WIDTH = 320  # of a picture, in pixels
ROWS = 8  # drawings on one page of Chromium
LEVELS = 40  # of 255: differences up to here are anti-aliasing
ALLOWED = 1e-4  # of a picture's pixels: hairs of anti-aliasing where a sliver is thinner than a pixel
NO_STROKES = "<style>*{stroke:none!important}</style>"


class Unusable(Exception):
    pass


def output(*command, text=True):
    return subprocess.run(command, capture_output=True, text=text, timeout=120)


class Window:
    """Rings of corners, even-odd, and the options that cut at them."""

    def __init__(self, kind, page, bounds):
        (x0, y0), (x1, y1) = ((max(page[i], bounds[i]) for i in (0, 1)), (min(page[i], bounds[i]) for i in (2, 3)))
        if x1 - x0 <= 0 or y1 - y0 <= 0:
            raise Unusable("nothing on the page")
        cx, cy, w, h = (x0 + x1) / 2 + (x1 - x0) / 50, (y0 + y1) / 2, (x1 - x0) / 2, (y1 - y0) / 2
        r = min(w, h) * 0.8
        self.kind, self.keep = kind, "inside"
        box = [(cx - 0.6 * w, cy - 0.6 * h), (cx + 0.6 * w, cy - 0.6 * h), (cx + 0.6 * w, cy + 0.6 * h), (cx - 0.6 * w, cy + 0.6 * h)]
        circle = lambda s: [(cx + s * math.cos(math.tau * i / 720), cy + s * math.sin(math.tau * i / 720)) for i in range(720)]
        star = [(cx + r * (1 - i % 2 * 0.6) * math.sin(math.tau * i / 10), cy - r * (1 - i % 2 * 0.6) * math.cos(math.tau * i / 10))
                for i in range(10)]
        upright = f"{box[0][0]!r},{box[0][1]!r},{box[2][0]!r},{box[2][1]!r}"
        if kind == "rectangle":
            self.rings, self.options = [box], ["-w", upright]
        elif kind == "rotated":
            a = math.radians(27)
            turn = lambda p: (cx + (p[0] - cx) * math.cos(a) - (p[1] - cy) * math.sin(a), cy + (p[0] - cx) * math.sin(a) + (p[1] - cy) * math.cos(a))
            self.rings, self.options = [[turn(p) for p in box]], ["-w", "polygon:" + text(map(turn, box))]
        elif kind == "circle":
            self.rings, self.options = [circle(r)], ["-w", f"circle:{cx!r},{cy!r},{r!r}"]
        elif kind == "star":
            self.rings, self.options = [star], ["-w", "polygon:" + text(star)]
        elif kind == "hole":
            self.rings, self.options = [box, circle(r * 0.5)], ["-w", upright, "--cut-out", f"circle:{cx!r},{cy!r},{r * 0.5!r}"]
        else:
            far = max(page[2] - page[0], page[3] - page[1]) * 10
            self.rings = [[(cx - far, cy - far), (cx + far, cy - far), (cx + far, cy + far), (cx - far, cy + far)], circle(r)]
            self.options, self.keep = ["-w", f"circle:{cx!r},{cy!r},{r!r}", "--keep", "outside"], "outside"

    def path(self):
        return " ".join("M" + " L".join(f"{x!r},{y!r}" for x, y in ring) + "Z" for ring in self.rings)


KINDS = ["rectangle", "rotated", "circle", "star", "hole", "outside"]


def text(points):
    return " ".join(f"{x!r},{y!r}" for x, y in points)


def masked(svg, window, page, style=""):
    """The text of an SVG file with all its content behind a clipPath."""
    start = re.search(r"<svg\b(?:[^>\"']|\"[^\"]*\"|'[^']*')*>", svg)
    end = svg.rfind("</svg>")
    if not start or end < 0 or start.group().endswith("/>"):
        raise Unusable("no root element")
    if "http://www.w3.org/2000/svg" not in svg:
        raise Unusable("no namespace: Chromium does not paint it")
    prefix = f'{style}<clipPath id="window-of-test"><path clip-rule="evenodd" d="{window.path()}"/></clipPath><g clip-path="url(#window-of-test)">'
    root = start.group()
    if "viewBox" not in root:  # without one, Chromium does not scale it
        root = f'{root[:-1]} viewBox="{page[0]} {page[1]} {page[2] - page[0]} {page[3] - page[1]}">'
    return svg[: start.start()] + root + prefix + svg[start.end() : end] + "</g></svg>"


def styled(svg, style):
    start = re.search(r"<svg\b(?:[^>\"']|\"[^\"]*\"|'[^']*')*>", svg)
    return svg[: start.end()] + style + svg[start.end() :]


class Drawing:
    def __init__(self, clearcut, file, kind, folder, number):
        self.file, self.number = file, number
        info = output(clearcut, "info", str(file))
        numbers = lambda key: re.search(rf"^\s*{key}\s+([-\d.,e]+)", info.stdout, re.M)
        if info.returncode or not numbers("bounds") or not numbers("page"):
            raise Unusable((info.stderr or "no bounds").strip().splitlines()[-1])
        page, bounds = ([float(n) for n in numbers(key).group(1).split(",")[:4]] for key in ("page", "bounds"))
        self.page = page
        self.window = Window(kind, page, bounds)
        cut, converted = folder / f"{number}-cut.svg", folder / f"{number}-import.svg"
        done = output(clearcut, "clip", str(file), *self.window.options, "-o", str(cut))
        if done.returncode:
            raise Unusable(done.stderr.strip().splitlines()[-1])
        self.losses = [line.strip() for line in done.stderr.splitlines() if re.search(r"not kept|not read|not support|ignored|missing|lost|left out", line)]
        done = output(clearcut, "convert", str(file), "-o", str(converted))
        if done.returncode:
            raise Unusable(done.stderr.strip().splitlines()[-1])
        source = file.read_text(encoding="utf-8", errors="strict")
        kept, whole = cut.read_text(), converted.read_text()
        self.widest = max([float(w) for w in re.findall(r'stroke-width="([\d.]+)', whole)] + [1.0 if 'stroke="' in whole else 0.0])
        self.height = max(1, round(WIDTH * (page[3] - page[1]) / (page[2] - page[0])))
        if self.height > 4 * WIDTH:
            raise Unusable("too tall for a row")
        self.files = []
        for name, content in (("reference", masked(source, self.window, page)), ("import", masked(whole, self.window, page)), ("cut", kept),
                              ("reference-fill", masked(source, self.window, page, NO_STROKES)), ("import-fill", masked(whole, self.window, page, NO_STROKES)),
                              ("cut-fill", styled(kept, NO_STROKES))):
            path = folder / f"{number}-{name}.svg"
            path.write_text(content)
            self.files.append(path)

    def band(self):
        """Where a window's edge is near enough for a stroke's width to matter."""
        scale = WIDTH / (self.page[2] - self.page[0])
        image = Image.new("L", (WIDTH, self.height), 0)
        draw = ImageDraw.Draw(image)
        for ring in self.window.rings:
            points = [((x - self.page[0]) * scale, (y - self.page[1]) * scale) for x, y in ring]
            draw.line(points + points[:1], fill=255, width=max(1, math.ceil(self.widest * scale * 4.4) + 4), joint="curve")
        return numpy.asarray(image) > 0


def painted(drawings, folder):
    """The pictures of some drawings, by one run of Chromium."""
    heights = [d.height for d in drawings]
    rows = "".join(
        f'<div style="height:{d.height}px">' + "".join(f'<img src="{f.name}" width="{WIDTH}" height="{d.height}">' for f in d.files) + "</div>"
        for d in drawings)
    page = folder / "page.html"
    page.write_text(f"<!doctype html><style>body{{margin:0;background:white}}div{{display:flex}}img{{display:block}}</style>{rows}")
    shot = folder / "page.png"
    shot.unlink(missing_ok=True)
    output("chromium", "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
           "--disable-component-update", "--disable-sync", "--hide-scrollbars", "--allow-file-access-from-files", "--force-device-scale-factor=1",
           f"--user-data-dir={folder}/profile", f"--window-size={WIDTH * 6},{sum(heights)}", f"--screenshot={shot}", page.as_uri())
    picture = numpy.asarray(Image.open(shot).convert("RGB")).astype(int)
    top = 0
    for d in drawings:
        yield d, [picture[top : top + d.height, WIDTH * i : WIDTH * (i + 1)] for i in range(6)]
        top += d.height


def rsvg(file, height):
    shot = file.with_suffix(".png")
    done = output("rsvg-convert", "-w", str(WIDTH), "-h", str(height), "-b", "white", str(file), "-o", str(shot))
    return None if done.returncode else numpy.asarray(Image.open(shot).convert("RGB")).astype(int)


def differing(a, b, but=None):
    """How many pixels of a or b have no like in the other within one pixel."""
    wrong = numpy.zeros(a.shape[:2], bool)
    for one, other in ((a, b), (b, a)):
        padded = numpy.pad(other, ((1, 1), (1, 1), (0, 0)), mode="edge")
        near = numpy.stack([padded[y : y + one.shape[0], x : x + one.shape[1]] for y in range(3) for x in range(3)])
        wrong |= ((one < near.min(0) - LEVELS) | (one > near.max(0) + LEVELS)).any(2)
    if but is not None:
        wrong &= ~but
    return int(wrong.sum()) if wrong.mean() > ALLOWED else 0


def judged(drawing, pictures):
    """The numbers of differing pixels, 0 where no more than ALLOWED differ."""
    reference, imported, cut, reference_fill, imported_fill, cut_fill = pictures
    band = drawing.band()
    result = {"fill": differing(cut_fill, imported_fill), "stroke": differing(cut, imported, band),
              "import": differing(imported_fill, reference_fill) + differing(imported, reference, band), "rsvg": None}
    if result["import"]:
        other = rsvg(drawing.files[0], drawing.height)
        result["rsvg"] = None if other is None else differing(other, reference, band)
    return result


def reason(drawing, result):
    if drawing.losses:
        return "; ".join(drawing.losses)[:160]
    if result["rsvg"] is None or result["rsvg"]:
        return "rsvg-convert differs from Chromium, too"
    return "**to be explained**"


def main():
    clearcut, root = sys.argv[1], Path(sys.argv[2])
    number = int(sys.argv[3]) if len(sys.argv) > 3 else 300
    files = sorted(p for p in root.rglob("*.svg") if 500 < p.stat().st_size < 400_000)
    chosen = files[:: max(1, len(files) // number)][:number]
    unusable, rows, waiting = [], [], []
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)

        def paint():
            for drawing, pictures in painted(waiting, folder):
                result = judged(drawing, pictures)
                rows.append((drawing, result))
                if len(sys.argv) > 5 and (result["fill"] or result["stroke"]):
                    keep = Path(sys.argv[5])
                    keep.mkdir(exist_ok=True)
                    Image.fromarray(numpy.concatenate(pictures, 1).astype("uint8")).save(keep / f"{drawing.number}.png")
                    for f in drawing.files:
                        (keep / f.name).write_text(f.read_text())
            waiting.clear()

        for i, file in enumerate(chosen):
            try:
                waiting.append(Drawing(clearcut, file, KINDS[i % len(KINDS)], folder, i))
            except (Unusable, UnicodeDecodeError, subprocess.TimeoutExpired) as why:
                unusable.append((file, str(why)))
            if len(waiting) == ROWS:
                paint()
        if waiting:
            paint()
    wrong = [(d, r) for d, r in rows if r["fill"] or r["stroke"]]
    foreign = [(d, r) for d, r in rows if r["import"]]
    lines = [f"{len(rows)} drawings; cut as behind a clipPath: {len(rows) - len(wrong)}; read as Chromium reads them: {len(rows) - len(foreign)}; not compared: {len(unusable)}.", ""]
    lines += ["| cut differs | window | pixels of fills | of strokes |", "|---|---|---|---|"]
    lines += [f"| {d.number} {d.file.relative_to(root)} | {d.window.kind} | {r['fill']} | {r['stroke']} |" for d, r in wrong]
    lines += ["", "| import differs | pixels | reason |", "|---|---|---|"]
    lines += [f"| {d.file.relative_to(root)} | {r['import']} | {reason(d, r)} |" for d, r in foreign]
    lines += ["", "| not compared | why |", "|---|---|"] + [f"| {f.relative_to(root)} | {w} |" for f, w in unusable]
    report = "\n".join(lines) + "\n"
    Path(sys.argv[4]).write_text(report) if len(sys.argv) > 4 else print(report)
    print(lines[0])


if __name__ == "__main__":
    main()
