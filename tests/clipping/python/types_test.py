# SPDX-License-Identifier: GPL-3.0-or-later
"""What tells the types: the stub of the extension names all that the extension has, and every public function has
annotations and a docstring that explains each argument."""
import ast
import importlib.util
import inspect
import pathlib
import pydoc
import re
import unittest
import warnings

import clearcut
from clearcut import _clearcut

warnings.simplefilter("default")  # Dask's own warnings are no errors
PACKAGE = pathlib.Path(__file__).resolve().parents[3] / "clipping/python"
MODULES = [clearcut]
if importlib.util.find_spec("dask") is not None:
    import clearcut.dask

    MODULES.append(clearcut.dask)


def in_the_stub(nodes, prefix=""):
    """The name of each function, with the names of its arguments."""
    found = {}
    for node in nodes:
        if isinstance(node, ast.FunctionDef):
            found[prefix + node.name] = [argument.arg for argument in node.args.args]
        elif isinstance(node, ast.ClassDef):
            found |= in_the_stub(node.body, node.name + ".")
    return found


def in_the_extension(holder, prefix=""):
    found = {}
    for name, value in vars(holder).items():
        if inspect.isclass(value):
            found |= in_the_extension(value, name + ".")
        elif callable(value) and (not name.startswith("__") or name == "__init__"):
            [signature] = re.findall(rf"^{name}\((.*)\) -> ", value.__doc__, re.M)
            found[prefix + name] = re.findall(r"(?:^|, )(\w+): ", signature)
    return found


class Types(unittest.TestCase):
    def test_the_stub_is_the_extension(self):
        tree = ast.parse((PACKAGE / "clearcut/_clearcut.pyi").read_text())
        stub = in_the_stub(tree.body)
        self.assertGreater(len(stub), 9)
        self.assertEqual(stub, in_the_extension(_clearcut))

    def test_everything_public_is_explained(self):
        for module in MODULES:
            self.assertEqual(sorted(module.__all__), [name for name in sorted(module.__all__) if hasattr(module, name)])
            for name in module.__all__:
                value = getattr(module, name)
                with self.subTest(module=module.__name__, name=name):
                    self.assertGreater(len(value.__doc__), 40)
                    methods = [m for m in vars(value).values() if inspect.isfunction(m)] if inspect.isclass(value) else [value]
                    for method in methods:
                        if not hasattr(value, "_fields") and (not method.__name__.startswith("_") or method.__name__ == "__init__"):
                            self.explains(method, value.__doc__ if method.__name__ == "__init__" else method.__doc__)

    def explains(self, function, text):
        signature = inspect.signature(function)
        self.assertIsNot(signature.return_annotation, inspect.Signature.empty, function)
        for parameter in signature.parameters.values():
            if parameter.name != "self":
                self.assertIsNot(parameter.annotation, inspect.Parameter.empty, f"{function} {parameter}")
                self.assertRegex(text, rf"\b{parameter.name}\b", f"{function} does not explain {parameter.name}")

    def test_pydoc_shows_everything(self):
        for module in MODULES:
            text = pydoc.plain(pydoc.render_doc(module))
            for name in module.__all__:
                self.assertIn(name, text)


if __name__ == "__main__":
    unittest.main()
