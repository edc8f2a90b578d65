# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the doctests of the package, and the programs of its pages: each python block, and each sh block before a text
block, prints the text block after it."""
import contextlib
import doctest
import importlib
import importlib.util
import io
import os
import pathlib
import pkgutil
import re
import subprocess
import sys
import tempfile
import unittest
import warnings

import clearcut

FOLDER = pathlib.Path(__file__).resolve().parents[3] / "clipping/python"
warnings.simplefilter("default")  # Dask's own warnings are no errors
NEEDS = {"clearcut._geometry": "shapely", "clearcut.dask": "dask", "clearcut.vpype": "vpype_cli"}


class Page(unittest.TestCase):
    def test_doctests(self):
        tried = {}
        for name in modules("clearcut", clearcut.__path__):
            result = doctest.testmod(importlib.import_module(name))
            self.assertEqual(result.failed, 0, name)
            tried[name] = result.attempted
        self.assertGreater(sum(tried.values()), 20)
        for name in filter(tried.get, ["clearcut", "clearcut._clip", "clearcut._chunks", "clearcut._lines"]):
            self.assertGreater(tried[name], 2, name)

    def test_programs(self):
        tried = 0
        for page in sorted(FOLDER.glob("*.md")):
            blocks = re.findall(r"```(\w+)\n(.*?)```", page.read_text(), re.S)
            for (kind, program), (after, printed) in zip(blocks, [*blocks[1:], ("", "")]):
                if kind not in ("python", "sh") or (kind == "sh" and after != "text") or lacking(program):
                    continue
                with self.subTest(page=page.name, program=program), tempfile.TemporaryDirectory() as folder:
                    self.assertEqual(run_in(folder, kind, program), printed if after == "text" else "")
                    tried += 1
        self.assertGreater(tried, 2)


def modules(package, path):
    yield package
    for module in pkgutil.iter_modules(path, package + "."):
        if module.name.endswith("__main__") or not installed(NEEDS.get(module.name, "numpy")):
            continue
        if module.ispkg:
            yield from modules(module.name, importlib.import_module(module.name).__path__)
        else:
            yield module.name


def installed(name):
    return importlib.util.find_spec(name) is not None


def lacking(program):
    needed = re.findall(r"^(?:import|from) (?:clearcut\.)?(\w+)|-m clearcut\.(\w+)", program, re.M)
    return not all(installed(one or other) for one, other in needed if "clearcut" not in (one, other))


def run_in(folder, kind, program):
    if kind == "sh":
        with tempfile.TemporaryDirectory() as programs:
            os.symlink(sys.executable, pathlib.Path(programs, "python3"))
            path = f"{programs}{os.pathsep}{os.environ['PATH']}"
            return subprocess.run(["sh", "-e"], input=program, cwd=folder, env={**os.environ, "PATH": path}, check=True,
                                  stdout=subprocess.PIPE, text=True).stdout
    home = os.getcwd()
    printed = io.StringIO()
    os.chdir(folder)
    try:
        with contextlib.redirect_stdout(printed):
            exec(compile(program, "page", "exec"), {"__name__": "__main__"})
    finally:
        os.chdir(home)
    return printed.getvalue()


if __name__ == "__main__":
    unittest.main()
