# SPDX-License-Identifier: MIT
"""Clips files on all processors, or on a cluster."""
from __future__ import annotations

import argparse
import contextlib
import sys
from typing import Any, Callable

import dask
import dask.array as da
from dask.utils import parse_bytes

from .. import _arguments as arguments
from . import clip_to_files, clip_to_tiles, grid, read_csv, read_npy

_ENDS = ("All files are looked at first: if one cannot be read, has no rows of four numbers or has a wrong header, nothing "
         "is clipped. Exit code: 0; 1 for such a file, or if a part could not be clipped: it is named, and all others are "
         "written; 2 for wrong arguments or a cluster without workers.")
_SECONDS = 30  # to wait for a worker
_LEAST_MEMORY = "200 MB"  # a process that only waits has 100 MB


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser("python3 -m clearcut.dask", description=__doc__, epilog=_ENDS)
    parser.add_argument("files", nargs="+", metavar="FILE", help="tables (.csv) or arrays of shape (n, 4) (.npy)")
    parser.add_argument("-w", "--window", type=_numbers, required=True, metavar="XMIN,YMIN,XMAX,YMAX")
    parser.add_argument("-o", "--output", required=True, metavar="FOLDER",
                        help="for the parts and manifest.json; an earlier result in it is removed")
    parser.add_argument("-t", "--tiles", type=_columns_and_rows, metavar="COLUMNSxROWS",
                        help="divide the window, and write one set of files for each tile")
    parser.add_argument("-b", "--block", type=_bytes_from("1 B"), default="64 MiB", metavar="BYTES",
                        help="the length of byte ranges; default: %(default)s")
    where = parser.add_mutually_exclusive_group()
    where.add_argument("-j", "--workers", type=_count, metavar="N", help="start N processes here; default: threads")
    where.add_argument("-s", "--scheduler", metavar="ADDRESS", help="use a running cluster, such as tcp://host:8786")
    parser.add_argument("-m", "--memory", type=_bytes_from(_LEAST_MEMORY), metavar="BYTES",
                        help="the memory limit of each process of -j, such as 1GB")
    return parser


def _refused(text: str, form: str) -> argparse.ArgumentTypeError:
    return argparse.ArgumentTypeError(f"it must be {form}, but this is {text!r}")


def _numbers(text: str) -> tuple[float, ...]:
    try:
        numbers = [float(number) for number in text.split(",")]
    except ValueError:
        raise _refused(text, "four numbers XMIN,YMIN,XMAX,YMAX") from None
    try:
        return arguments.window(numbers)
    except ValueError as error:
        raise argparse.ArgumentTypeError(str(error)) from None


def _count(text: str) -> int:
    if not text.isdecimal() or int(text) < 1:
        raise _refused(text, "a whole number from 1 on")
    return int(text)


def _columns_and_rows(text: str) -> tuple[int, int]:
    try:
        columns, rows = map(_count, text.split("x"))
    except (ValueError, argparse.ArgumentTypeError):
        raise _refused(text, "two whole numbers from 1 on, such as 3x2") from None
    return columns, rows


def _bytes_from(least: str) -> Callable[[str], int]:
    def length(text: str) -> int:
        with contextlib.suppress(ValueError, OverflowError):
            if parse_bytes(text) >= parse_bytes(least):
                return parse_bytes(text)
        raise _refused(text, f"a number of bytes from {least} on, such as 1GB")

    return length


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
            raise ValueError(f"no scheduler answers at {address}") from None
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
    parser = _parser()
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
