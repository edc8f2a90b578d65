# SPDX-License-Identifier: GPL-3.0-or-later
"""Installing the module: the test installed.sh itself."""
import importlib.util
import pathlib
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
PYTHON = """#!/bin/sh
[ "$1" != -m ] || { echo "no space left"; exit 3; }
exec %s "$@"
"""


@unittest.skipIf(importlib.util.find_spec("setuptools") is None, "python3-setuptools is not installed")
@unittest.skipIf(importlib.util.find_spec("wheel") is None, "python3-wheel is not installed")
@unittest.skipIf(importlib.util.find_spec("ensurepip") is None, "python3-venv is not installed")
class Installed(unittest.TestCase):
    def test_a_failure_is_not_a_skip(self):
        """All packages are there, but no environment can be made."""
        with tempfile.TemporaryDirectory() as folder:
            python = pathlib.Path(folder, "python")
            python.write_text(PYTHON % sys.executable)
            python.chmod(0o755)
            found = subprocess.run(["bash", HERE / "installed.sh", python, HERE.parents[2], f"{folder}/work"],
                                   capture_output=True, text=True)
        self.assertEqual((found.returncode, found.stdout), (1, "no space left\n"))


if __name__ == "__main__":
    unittest.main()
