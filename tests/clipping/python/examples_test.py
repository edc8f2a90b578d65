# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the examples, with and without matplotlib: they write their pictures, and nothing is drawn outside the windows."""
import importlib.util
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

import numpy as np

EXAMPLES = sorted((pathlib.Path(__file__).resolve().parents[3] / "clipping/python/examples").glob("*.py"))
WITHOUT_MATPLOTLIB = "import sys; sys.modules['matplotlib'] = sys.modules['matplotlib.collections'] = None\n"


def run_in(folder, program):
    found = subprocess.run([sys.executable, "-W", "ignore", "-c", program], cwd=folder, capture_output=True, text=True,
                           env={**os.environ, "MPLCONFIGDIR": folder})
    if found.returncode:
        raise AssertionError(found.stderr)


def pictures(program):
    return re.findall(r'picture\("(\w+)"', program)


class Examples(unittest.TestCase):
    def test_as_svg(self):
        for example in EXAMPLES:
            program = example.read_text()
            with self.subTest(example=example.name), tempfile.TemporaryDirectory() as folder:
                run_in(folder, WITHOUT_MATPLOTLIB + program)
                self.assertEqual({path.stem for path in pathlib.Path(folder).glob("*.svg")}, set(pictures(program)))
                for path in pathlib.Path(folder).glob("*.svg"):
                    self.assertGreater(len(lines_of(path)), 5)

    def test_nothing_is_outside(self):
        [hatching] = [example for example in EXAMPLES if example.name == "hatching.py"]
        with tempfile.TemporaryDirectory() as folder:
            run_in(folder, WITHOUT_MATPLOTLIB + hatching.read_text())
            spiral = np.concatenate(lines_of(pathlib.Path(folder, "spiral.svg")))
            np.testing.assert_array_equal([spiral.min(0), spiral.max(0)], [(-60, -40), (60, 40)])
            hexagon = np.concatenate(lines_of(pathlib.Path(folder, "hexagon.svg")))
            self.assertLess(np.hypot(*hexagon.T).max(), 70.001)

    @unittest.skipIf(importlib.util.find_spec("matplotlib") is None, "python3-matplotlib is not installed")
    def test_with_matplotlib(self):
        for example in EXAMPLES:
            with self.subTest(example=example.name), tempfile.TemporaryDirectory() as folder:
                run_in(folder, example.read_text())
                for name in pictures(example.read_text()):
                    self.assertTrue(pathlib.Path(folder, f"{name}.png").read_bytes().startswith(b"\x89PNG"))

    def test_cells(self):
        """Text and code in turns, as notebooks show them."""
        self.assertTrue(EXAMPLES)
        for example in EXAMPLES:
            cells = re.findall(r"^# %%(.*)", example.read_text(), re.M)
            self.assertEqual(cells, [" [markdown]", ""] * (len(cells) // 2), example.name)


def lines_of(path):
    lines = []
    for element in xml.etree.ElementTree.parse(path).getroot():
        for line in element.get("d").split("M")[1:]:
            lines.append(np.array([point.split(",") for point in line.split()], float))
    return lines


if __name__ == "__main__":
    unittest.main()
