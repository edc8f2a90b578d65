# SPDX-License-Identifier: MIT
"""Clips files on all processors, or on a cluster."""
from __future__ import annotations

import argparse
import contextlib
import gc
import sys
from typing import Any, Callable

import dask
import dask.array as da

from . import clip_to_files, clip_to_tiles, grid, read_csv, read_npy
from ._options import parser_of

_SECONDS = 30  # to wait for a worker


def _reader(files: list[str], block: int) -> Callable[[], da.Array]:
    kinds = {file.rpartition(".")[2].lower() for file in files}
    if kinds == {"csv"}:
        return lambda: read_csv(files, block)
    if kinds == {"npy"}:
        return lambda: read_npy(files, max(1, block // 32))
    raise ValueError(f"the files must be all .csv or all .npy, but these are {', '.join('.' + kind for kind in sorted(kinds))}")


@contextlib.contextmanager
def _workers(options: argparse.Namespace) -> Any:
    """Raises a ValueError if there are none."""
    if options.workers is None and options.scheduler is None:
        yield
        return
    from distributed import Client, LocalCluster, TimeoutError

    with contextlib.ExitStack() as stack:
        address = options.scheduler if options.workers is None else stack.enter_context(LocalCluster(
            n_workers=options.workers, threads_per_worker=1, processes=True, memory_limit=options.memory or "auto",
            dashboard_address=":0"))
        try:  # not as the default, which it would stay if there is no scheduler
            client = stack.enter_context(Client(address, timeout=_SECONDS, set_as_default=False))
        except (OSError, ValueError, TimeoutError):
            client = None
        if client is None:
            # The client that failed closes itself when it is collected. While another one starts, as in a program that
            # goes on after the error, it would wait for a lock that its own thread holds, for ever.
            gc.collect()
            raise ValueError(f"no scheduler answers at {address}")
        stack.enter_context(client.as_current())
        stack.enter_context(dask.config.set(scheduler="dask.distributed"))
        try:
            client.wait_for_workers(1, timeout=_SECONDS)
        except TimeoutError:
            raise ValueError(f"the scheduler has no workers after {_SECONDS} seconds; start some, such as: dask worker "
                             f"{client.scheduler.address}") from None
        yield


def main(arguments: list[str]) -> int:
    # argparse takes -100,-75,100,75 for an option unless it is joined to its own.
    joined = [f"-w{next(rest, '')}" if word in ("-w", "--window") else word for rest in [iter(arguments)] for word in rest]
    parser = parser_of(__doc__)
    options = parser.parse_args(joined)
    try:
        read = _reader(options.files, options.block)
        with _workers(options):
            try:
                lines = read()
            except (TypeError, ValueError, OSError) as error:
                return _fails(parser, error)
            manifest = (clip_to_files(lines, options.output, options.window) if options.tiles is None else
                        clip_to_tiles(lines, options.output, grid(options.window, *options.tiles)))
    except (TypeError, ValueError) as error:
        parser.error(str(error))
    except (ImportError, OSError) as error:
        return _fails(parser, error)
    return _report(manifest, lines.shape[0], options.output)


def _fails(parser: argparse.ArgumentParser, error: Exception) -> int:
    print(f"{parser.prog}: {error}", file=sys.stderr)
    return 1


def _report(manifest: dict[str, Any], segments: int, folder: str) -> int:
    parts = manifest["parts"]
    errors = [result["error"] for result in [*parts, *manifest.get("tiles", [])] if result["error"] is not None]
    for text in errors:
        print(text, file=sys.stderr)
    print(f"{_number_of('piece', sum(part['pieces'] for part in parts))} of {_number_of('segment', segments)} in {folder}, from "
          f"{_number_of('part', len(parts))}" + (f"; {len(errors)} failed" if errors else ""))
    return 1 if errors else 0


def _number_of(noun: str, count: int) -> str:
    return f"{count} {noun}{'s' * (count != 1)}"


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
