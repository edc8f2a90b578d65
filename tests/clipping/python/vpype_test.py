# SPDX-License-Identifier: GPL-3.0-or-later
"""The plug-in for vpype: its work on a stand-in for vpype's LineCollection, its command in a pipeline of click like
vpype's, and, where vpype is installed, in vpype."""
import importlib
import importlib.metadata
import importlib.util
import pathlib
import re
import sys
import types
import unittest
import unittest.mock
import warnings

import numpy as np

import clearcut
from clearcut import _layers

warnings.simplefilter("default")  # vpype's own warnings are no errors
PACKAGE = pathlib.Path(__file__).resolve().parents[3] / "clipping/python"
try:
    import click
except ImportError:
    click = None


class LineCollection:
    """What vpype documents of its class: complex lines, metadata that a clone keeps, and no lines of one point."""

    def __init__(self, lines=(), metadata=None):
        self.lines, self.metadata = [], metadata or {}
        self.extend(lines)

    def append(self, line):
        self.lines.append(np.array(line, dtype=complex).reshape(-1))

    def extend(self, lines):
        for line in lines:
            self.append(line)

    def clone(self, lines=()):
        return LineCollection(lines, dict(self.metadata))

    def __iter__(self):
        return iter(self.lines)

    def __len__(self):
        return len(self.lines)


def stand_in():
    """A module vpype_cli with a decorator that makes processors of the one layer in the list that they get."""
    module = types.ModuleType("vpype_cli")

    class LengthType(click.ParamType):
        name = "length"

        def convert(self, value, param, ctx):
            number, unit = re.fullmatch(r"([-\d.]+)(mm)?", value).groups()
            return float(number) * (96 / 25.4 if unit else 1)

    def layer_processor(function):
        def of_arguments(*args, **kwargs):
            return lambda layers: layers.__setitem__(0, function(layers[0], *args, **kwargs))

        of_arguments.__doc__ = function.__doc__
        of_arguments.__name__ = function.__name__
        if hasattr(function, "__click_params__"):
            of_arguments.__click_params__ = function.__click_params__
        return of_arguments

    module.LengthType, module.layer_processor = LengthType, layer_processor
    return module


class Layers(unittest.TestCase):
    def crop(self, *lines):
        layer = LineCollection(lines, {"name": "walls"})
        found = _layers.cropped(layer, (0, 0, 10, 10))
        self.assertEqual(found.metadata, {"name": "walls"})
        self.assertEqual(len(layer), len(lines))
        return [line.tolist() for line in found]

    def test_paths(self):
        self.assertEqual(self.crop([-5 + 5j, 5 + 5j, 5 + 15j], [20, 30], [1 + 1j, 2 + 2j]),
                         [[5j, 5 + 5j, 5 + 10j], [1 + 1j, 2 + 2j]])

    def test_closed_paths_are_unbroken_at_their_start(self):
        square = [5 + 2j, 5 + 5j, -5 + 5j, -5 + 2j, 5 + 2j]
        self.assertEqual(self.crop(square), [[2j, 5 + 2j, 5 + 5j, 5j]])
        inside = [1, 2, 2 + 2j, 1]
        [found] = self.crop(inside)
        self.assertEqual((set(found), found[0], len(found)), (set(inside), found[-1], 4))

    def test_what_only_touches_or_is_nothing(self):
        self.assertEqual(self.crop([-5 + 5j, 5 + 15j], [-5 - 5j, -1j], [], [3]), [])
        self.assertEqual(self.crop([-1 + 5j, 5j, 5j], [-1 + 5j, 5j, 5j, -1 + 5j], [5j, 5j, -1]), [])
        self.assertEqual(self.crop([1 + 1j, 1 + 1j], [5j, 5j], [11, 11]), [[1 + 1j, 1 + 1j], [5j, 5j]])  # dots

    def test_one_call_for_many_paths(self):
        """Open and closed paths stay in their order, and each path's parts, too."""
        chance = np.random.default_rng(4)
        lines = [chance.uniform(-5, 15, (n, 2)).view(complex).reshape(-1) for n in chance.integers(2, 9, 300)]
        lines = [np.append(line, line[0]) if chance.random() < 0.5 else line for line in lines]
        calls = []

        def clip_lines(*given, **options):
            calls.append(options["closed"])
            return clearcut.clip_lines(*given, **options)

        with unittest.mock.patch.object(_layers, "clip_lines", clip_lines):
            found = self.crop(*lines)
        self.assertEqual(sorted(calls), [False, True])
        self.assertEqual(found, [part for line in lines for part in self.crop(line)])

    def test_any_layout(self):
        line = np.array([5 + 15j, 5 + 5j, -5 + 5j])
        layer = LineCollection()
        layer.lines = [line[::-1], np.repeat(line, 2)[::2][::-1], line[::-1].astype(np.complex64)]
        for found in _layers.cropped(layer, (0, 0, 10, 10)):
            self.assertEqual(found.tolist(), [5j, 5 + 5j, 5 + 10j])


@unittest.skipIf(click is None, "python3-click is not installed")
class Command(unittest.TestCase):
    def setUp(self):
        patch = unittest.mock.patch.dict(sys.modules, {"vpype_cli": stand_in()})
        patch.start()
        self.addCleanup(patch.stop)
        sys.modules.pop("clearcut.vpype", None)
        command = importlib.import_module("clearcut.vpype").clearcut
        self.assertEqual(command.help_group, "Plugins")
        self.layers = [LineCollection([[-5 + 5j, 500 + 5j]])]

        @click.group(chain=True)
        def cli():
            pass

        @cli.result_callback()
        def run(processors):
            for process in processors:
                process(self.layers)

        cli.add_command(command)
        self.cli = cli

    def run_with(self, *words):
        self.cli.main(["clearcut", *words], prog_name="vpype", standalone_mode=False)
        return [line.tolist() for line in self.layers[0]]

    def test_in_a_pipeline(self):
        self.assertEqual(self.run_with("crop", "0", "0", "25.4mm", "10", "clearcut", "crop", "10", "0", "500", "10"),
                         [[10 + 5j, 96 + 5j]])

    def test_what_is_refused(self):
        for words in [("crop", "0", "0", "10"), ("cut", "0", "0", "10", "10"), ("crop", "0", "0", "-1", "5")]:
            self.assertRaises(click.UsageError, self.run_with, *words)


class Installed(unittest.TestCase):
    def test_entry_point_names_the_command(self):
        entries = re.search(r'\[project.entry-points."vpype.plugins"\]\n(.*)\n', (PACKAGE / "pyproject.toml").read_text())
        self.assertEqual(entries[1], 'clearcut = "clearcut.vpype:clearcut"')

    @unittest.skipIf(importlib.util.find_spec("vpype_cli") is None, "vpype is not installed")
    def test_in_vpype(self):
        import vpype_cli

        plug_in = importlib.import_module("clearcut.vpype").clearcut
        vpype_cli.cli.add_command(plug_in)
        document = vpype_cli.execute("line -- -100 50 500 50 clearcut crop 0 0 200 100")
        [line] = document.layers[1]
        self.assertEqual(line.tolist(), [50j, 200 + 50j])


if __name__ == "__main__":
    unittest.main()
