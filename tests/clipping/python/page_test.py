# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the doctests of the package, and the programs of its page: each python block prints the text block after it."""
import contextlib
import doctest
import importlib
import io
import pathlib
import pkgutil
import re
import tempfile
import os
import unittest

import clearcut

PAGE = pathlib.Path(__file__).resolve().parents[3] / "clipping/python/README.md"
OPTIONAL = {"shapely", "dask", "matplotlib"}


class Page(unittest.TestCase):
    def test_doctests(self):
        tried = 0
        for module in [clearcut] + [importlib.import_module(f"clearcut.{m.name}")
                                    for m in pkgutil.iter_modules(clearcut.__path__) if m.name != "_clearcut"]:
            if module.__name__ == "clearcut._geometry" and not installed("shapely"):
                continue
            result = doctest.testmod(module)
            self.assertEqual(result.failed, 0, module.__name__)
            tried += result.attempted
        self.assertGreater(tried, 20)

    def test_programs(self):
        blocks = re.findall(r"```(\w+)\n(.*?)```", PAGE.read_text(), re.S)
        programs = [(i, text) for i, (kind, text) in enumerate(blocks) if kind == "python"]
        self.assertGreater(len(programs), 2)
        home = os.getcwd()
        for i, program in programs:
            if any(re.search(rf"^(import|from) {name}", program, re.M) and not installed(name) for name in OPTIONAL):
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
