# SPDX-License-Identifier: MIT
"""The folder of a result: files of NumPy, and a manifest that is written last. Nothing else in it is touched."""
from __future__ import annotations

import contextlib
import functools
import json
import os
import pathlib
import re
import shutil
import uuid
from typing import Any

import dask.array as da
import numpy as np

_KEYS = ("segments", "source", "cut", "ends")
_BETWEEN = re.compile(r"\.parts-[0-9a-f]{32}")
_UNFINISHED = re.compile(rf"(part|tile)-\d{{5,}}-({'|'.join(_KEYS)})\.npy\.\w+\.unfinished")


def begin(folder: str, lines: da.Array, plan: dict[str, Any]) -> str:
    """Makes the folder and returns its full path, for workers in other folders. Removes an earlier result in it, also of
    a run that was killed, which left its plan.

    plan: a manifest, of which entries need their number only; for tiles also "between", a name as of `between`.

    Raises a ValueError if the folder holds a file that is read, or a manifest.json of something else."""
    folder = os.path.abspath(folder)
    for path in _inputs(lines):
        if os.path.realpath(folder) in (os.path.realpath(os.path.dirname(path)), os.path.dirname(os.path.realpath(path))):
            raise ValueError(f"the output folder must not hold an input, but it holds {path}")
    os.makedirs(folder, exist_ok=True)
    for name in ("manifest.json", "manifest.json.unfinished"):
        _remove_result(os.path.join(folder, name))
    _write(os.path.join(folder, "manifest.json.unfinished"), plan)
    return folder


def finish(folder: str, manifest: dict[str, Any]) -> None:
    _write(os.path.join(folder, "manifest.json"), manifest)
    pathlib.Path(folder, "manifest.json.unfinished").unlink(missing_ok=True)


def between() -> str:
    """The name of a folder of our own, for files that only the next step needs."""
    return f".parts-{uuid.uuid4().hex}"


def save(name: str, **arrays: np.ndarray) -> None:
    """Writes each array to NAME-KEY.npy. A file is there only when it is complete."""
    for key, array in arrays.items():
        _replace(f"{name}-{key}.npy", lambda file, array=array: np.save(file, array))


def remove(folder: str, kind: str, numbers: Any) -> None:
    """Removes the files of parts or tiles. kind: "part" or "tile"."""
    for number in numbers:
        for key in _KEYS:
            with contextlib.suppress(FileNotFoundError, IsADirectoryError):  # a folder of this name is not ours
                os.remove(os.path.join(folder, f"{kind}-{number:05}-{key}.npy"))


def remove_unfinished(folder: str) -> None:
    """What workers left that were lost while they wrote."""
    for path in pathlib.Path(folder).iterdir():
        if _UNFINISHED.fullmatch(path.name):
            path.unlink(missing_ok=True)


def _inputs(lines: da.Array) -> set[str]:
    """The files of this computer that read_csv and read_npy read."""
    tasks = (task for name, layer in getattr(lines.dask, "layers", {}).items()
             if name.startswith(("read-csv-", "read-npy-")) for task in layer.values())
    found = {task[0].keywords["path"] for task in tasks if isinstance(task, tuple) and isinstance(task[0], functools.partial)}
    return {path for path in (path.removeprefix("file://") for path in found) if "://" not in path}


def _remove_result(path: str) -> None:
    """Removes a manifest or plan, and the files that it names."""
    try:
        manifest = json.loads(pathlib.Path(path).read_bytes())
        numbers = {kind: [int(entry[kind]) for entry in manifest.get(f"{kind}s", [])] for kind in ("part", "tile")}
        if "parts" not in manifest:
            raise KeyError
    except FileNotFoundError:
        return
    except (AttributeError, KeyError, TypeError, ValueError):
        raise ValueError(f"{path} is not a manifest of clearcut; choose another output folder") from None
    folder = os.path.dirname(path)
    for kind in numbers:
        remove(folder, kind, numbers[kind])
    remove_unfinished(folder)
    if _BETWEEN.fullmatch(str(manifest.get("between"))):
        shutil.rmtree(os.path.join(folder, manifest["between"]), ignore_errors=True)
    os.remove(path)


def _write(path: str, manifest: dict[str, Any]) -> None:
    text = json.dumps(manifest, indent=1).encode()
    _replace(path, lambda file: file.write(text))


def _replace(path: str, write: Any) -> None:
    unfinished = f"{path}.{uuid.uuid4().hex}.unfinished"  # a chunk may be clipped on two workers at once
    try:
        with open(unfinished, "wb") as file:
            write(file)
            file.flush()
            os.fsync(file.fileno())  # or a name could outlive a power failure without its content
        os.replace(unfinished, path)
    finally:
        pathlib.Path(unfinished).unlink(missing_ok=True)
