# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers near 0 in a process that takes them for 0, as one does that has loaded an extension linked with -ffast-math."""
import contextlib
import ctypes
import os
import pathlib
import platform
import shutil
import subprocess
import tempfile
import unittest

import numpy as np

import clearcut

COMPILER = shutil.which(os.environ.get("CC", "cc"))
MODE = 0x8040  # flush to zero, denormals are zero
SOURCE = "#include <xmmintrin.h>\nunsigned mode(void) { return _mm_getcsr(); }\nvoid set(unsigned m) { _mm_setcsr(m); }\n"
WINDOW = (-100, -75, 100, 75)


def denormals(dtype, n=5000):
    """Random segments that the window cuts after both are multiplied with the smallest number."""
    smallest = np.nextafter(dtype(0), dtype(1))
    lines = np.random.default_rng(3).integers(-200, 200, (n, 4)).astype(dtype)
    return lines * smallest, tuple(float(edge * smallest) for edge in np.array(WINDOW, dtype))


@unittest.skipIf(platform.machine() != "x86_64", "the test sets the mode of x86-64 processors")
@unittest.skipIf(COMPILER is None, "no C compiler is installed")
class Denormals(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as folder:
            library = pathlib.Path(folder, "mode.so")
            subprocess.run([COMPILER, "-shared", "-fPIC", "-x", "c", "-", "-o", library], input=SOURCE, text=True, check=True)
            cls.mode = ctypes.CDLL(str(library))

    @contextlib.contextmanager
    def flushed(self):
        before = self.mode.mode()
        self.mode.set(before | MODE)
        try:
            yield
            self.assertEqual(self.mode.mode() & MODE, MODE, "the caller's mode is not given back")
        finally:
            self.mode.set(before)

    def same(self, call):
        expected = call()
        with self.flushed():
            found = call()
        self.compare(found, expected)

    def compare(self, found, expected):
        if not isinstance(expected, (tuple, list)):
            return self.assertTrue(np.asarray(found).tobytes() == np.asarray(expected).tobytes(), "other bits")
        self.assertEqual(len(found), len(expected))
        for one, other in zip(found, expected):
            self.compare(one, other)

    def test_windows(self):
        for dtype in (np.float64, np.float32):
            lines, window = denormals(dtype)
            for algorithm in ("exact", "cs", "lb", "md", "nln"):
                with self.subTest(dtype=dtype, algorithm=algorithm):
                    self.same(lambda: clearcut.clip(lines, window, algorithm=algorithm))
        lines, window = denormals(np.float64)
        self.same(lambda: clearcut.clip(lines, window, algorithm="cs", form="published"))
        self.same(lambda: clearcut.split(lines, window))

    def test_lines_rays_and_polygons(self):
        lines, (xmin, ymin, xmax, ymax) = denormals(np.float64)
        for kind in ("line", "ray"):
            self.same(lambda: clearcut.clip(lines, (xmin, ymin, xmax, ymax), kind=kind, algorithm="lb"))
        for algorithm in ("exact", "cyrus-beck"):
            corners = [(xmin, ymin), (xmax, ymin), (0, ymax)]
            self.same(lambda: clearcut.clip(lines, polygon=corners, algorithm=algorithm))

    def test_chunks_and_polylines(self):
        for dtype in (np.float64, np.float32):
            lines, window = denormals(dtype)
            self.same(lambda: clearcut.Chunks(lines).clip(window))
        lines, window = denormals(np.float64)
        for closed in (False, True):
            self.same(lambda: clearcut.clip_lines([lines[:, :2].copy()], window, closed=closed))
            offsets = np.arange(0, len(lines), 10)
            self.same(lambda: clearcut.clip_polylines(lines[:, :2], offsets, window, closed=closed))

    def test_every_thread(self):
        few, window = denormals(np.float64)
        lines = np.ones((600_000, 4))  # so many that the work is divided
        lines[::120] = few
        for threads in (None, 2):
            self.same(lambda: clearcut.clip(lines, window, threads=threads))

    def test_traces(self):
        lines, window = denormals(np.float64)
        for line in lines[clearcut.clip(lines, window).source[:20]]:
            for key in ("cs", "lb", "exact"):
                self.same(lambda: [step["segment"] for step in clearcut.trace(line, window, key)])


if __name__ == "__main__":
    unittest.main()
