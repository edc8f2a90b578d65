# SPDX-License-Identifier: GPL-3.0-or-later
"""Installing the module: the test installed.sh itself, and how setup.py calls CMake."""
import importlib.util
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
SETUP = HERE.parents[2] / "clipping/python/setup.py"
PYTHON = """#!/bin/sh
[ "$1" != -m ] || { echo "no space left"; exit 3; }
exec %s "$@"
"""
# Writes down how many jobs it may start.
CMAKE = """#!/bin/sh
case $1 in --build) echo "$* jobs=$CMAKE_BUILD_PARALLEL_LEVEL" > "$WRITTEN" ;; esac
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


@unittest.skipIf(importlib.util.find_spec("setuptools") is None, "python3-setuptools is not installed")
@unittest.skipUnless(hasattr(os, "sched_setaffinity"), "the system does not limit processors")
class Setup(unittest.TestCase):
    def build_command(self, **environment):
        """The command line of the build, and its jobs, where one processor may be used."""
        with tempfile.TemporaryDirectory() as folder:
            cmake, written = pathlib.Path(folder, "cmake"), pathlib.Path(folder, "written")
            cmake.write_text(CMAKE)
            cmake.chmod(0o755)
            inherited = {k: v for k, v in os.environ.items() if k not in ("CMAKE_BUILD_PARALLEL_LEVEL", "CLEARCUT_BUILD")}
            path = f"{folder}{os.pathsep}{os.environ['PATH']}"
            processor = min(os.sched_getaffinity(0))
            found = subprocess.run([sys.executable, SETUP, "build_ext", "--build-temp", f"{folder}/temp", "--build-lib", folder],
                                   cwd=folder, env={**inherited, "PATH": path, "WRITTEN": str(written), **environment},
                                   preexec_fn=lambda: os.sched_setaffinity(0, [processor]), capture_output=True, text=True)
            self.assertIn("There is no extension in", found.stderr)
            return written.read_text()

    def test_jobs_are_the_processors_that_may_be_used(self):
        command = self.build_command()
        self.assertIn("jobs=1\n", command)
        self.assertNotIn("--parallel", command)

    def test_the_environment_chooses_jobs(self):
        command = self.build_command(CMAKE_BUILD_PARALLEL_LEVEL="7")
        self.assertIn("jobs=7\n", command)
        self.assertNotIn("--parallel", command)


if __name__ == "__main__":
    unittest.main()
