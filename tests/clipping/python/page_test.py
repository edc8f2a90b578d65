# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the doctests of the package, and the programs of its page: each python block prints the text block after it."""
import contextlib
import doctest
import importlib
import importlib.util
import io
import os
import pathlib
import pkgutil
import re
import tempfile
import unittest
import warnings

import clearcut

PAGE = pathlib.Path(__file__).resolve().parents[3] / "clipping/python/README.md"
warnings.simplefilter("default")  # Dask's own warnings are no errors
OPTIONAL = {"shapely", "dask", "matplotlib"}


class Page(unittest.TestCase):
    def test_doctests(self):
        tried = 0
        needs = {"_geometry": "shapely", "dask": "dask"}
        names = [m.name for m in pkgutil.iter_modules(clearcut.__path__) if installed(needs.get(m.name, "numpy"))]
        for name in names:
            module = importlib.import_module(f"clearcut.{name}")
            result = doctest.testmod(module)
            self.assertEqual(result.failed, 0, name)
            tried += result.attempted
        tried += doctest.testmod(clearcut, raise_on_error=True).attempted
        self.assertGreater(tried, 20)

    def test_programs(self):
        blocks = re.findall(r"```(\w+)\n(.*?)```", PAGE.read_text(), re.S)
        programs = [(i, text) for i, (kind, text) in enumerate(blocks) if kind == "python"]
        self.assertGreater(len(programs), 2)
        home = os.getcwd()
        for i, program in programs:
            if any(re.search(rf"^(import|from) (clearcut\.)?{name}", program, re.M) and not installed(name) for name in OPTIONAL):
                continue
            printed = io.StringIO()
            with self.subTest(program=program), tempfile.TemporaryDirectory() as folder:
                os.chdir(folder)
                try:
                    with contextlib.redirect_stdout(printed):
                        exec(compile(program, "page", "exec"), {"__name__": "__main__"})
                finally:
                    os.chdir(home)
                self.assertEqual(blocks[i + 1], ("text", printed.getvalue()))


def installed(name):
    return importlib.util.find_spec(name) is not None


if __name__ == "__main__":
    unittest.main()
