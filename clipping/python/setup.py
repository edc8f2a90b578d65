# SPDX-License-Identifier: MIT
"""Builds the extension with CMake, from the library in the folder above, or takes it from the build folder
CLEARCUT_BUILD."""
import os
import pathlib
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

LIBRARY = pathlib.Path(__file__).resolve().parent.parent


def processors():
    """How many this process may use, which in a container can be fewer than there are."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


class BuildWithCMake(build_ext):
    def build_extension(self, ext):
        target = pathlib.Path(self.get_ext_fullpath(ext.name)).resolve()
        built = os.environ.get("CLEARCUT_BUILD")
        folder = pathlib.Path(built, "clipping/python/clearcut") if built else self.build_library()
        made = list(folder.glob(f"_clearcut.{sys.implementation.cache_tag}*.so"))
        if len(made) != 1:
            raise SystemExit(f"There is no extension in {folder}: install python3-dev and pybind11-dev, and build.")
        target.parent.mkdir(parents=True, exist_ok=True)
        self.copy_file(made[0], target)

    def build_library(self):
        build = pathlib.Path(self.build_temp).resolve()
        subprocess.run(["cmake", "-S", LIBRARY, "-B", build, "-DCMAKE_BUILD_TYPE=Release", "-DCLEARCUT_PYTHON=ON",
                        "-DCLEARCUT_INSTALL=OFF", f"-DPython3_EXECUTABLE={sys.executable}"], check=True)
        jobs = {"CMAKE_BUILD_PARALLEL_LEVEL": str(processors())}
        subprocess.run(["cmake", "--build", build, "--target", "clearcut_python"], env={**jobs, **os.environ}, check=True)
        return build / "python/clearcut"


setup(ext_modules=[Extension("clearcut._clearcut", sources=[])], cmdclass={"build_ext": BuildWithCMake})
