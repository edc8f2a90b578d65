# SPDX-License-Identifier: MIT
"""Clips files on all processors, or on a cluster."""
from __future__ import annotations

import argparse
import contextlib
import sys
from typing import Any

import dask.array as da

from . import clip_to_files, clip_to_tiles, grid, read_csv, read_npy

_ENDS = "Exit code: 0; 1 if a part could not be clipped, which is named, while all others are; 2 for wrong arguments."


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser("python3 -m clearcut.dask", description=__doc__, epilog=_ENDS)
    parser.add_argument("files", nargs="+", metavar="FILE", help="tables (.csv) or arrays of shape (n, 4) (.npy)")
    parser.add_argument("-w", "--window", type=_numbers, required=True, metavar="XMIN,YMIN,XMAX,YMAX")
    parser.add_argument("-o", "--output", required=True, metavar="FOLDER", help="for the parts and manifest.json")
    parser.add_argument("-t", "--tiles", type=_columns_and_rows, metavar="COLUMNSxROWS",
                        help="divide the window, and write one set of files for each tile")
    parser.add_argument("-b", "--block", default="64 MiB", help="the length of byte ranges; default: %(default)s")
    where = parser.add_mutually_exclusive_group()
    where.add_argument("-j", "--workers", type=int, metavar="N", help="start N processes here; default: threads")
    where.add_argument("-s", "--scheduler", metavar="ADDRESS", help="use a running cluster, such as tcp://host:8786")
    parser.add_argument("-m", "--memory", default="auto", help="the memory limit of each process of -j, such as 1GB")
    return parser


def _numbers(text: str) -> list[float]:
    return [float(number) for number in text.split(",")]


def _columns_and_rows(text: str) -> tuple[int, int]:
    columns, rows = text.split("x")
    return int(columns), int(rows)


def _lines(files: list[str], block: str) -> da.Array:
    from dask.utils import parse_bytes

    kinds = {file.rpartition(".")[2].lower() for file in files}
    if kinds == {"csv"}:
        return read_csv(files, block)
    if kinds == {"npy"}:
        return read_npy(files, max(1, parse_bytes(block) // 32))
    raise ValueError(f"the files must be all .csv or all .npy, but these are {', '.join('.' + kind for kind in sorted(kinds))}")


@contextlib.contextmanager
def _workers(options: argparse.Namespace) -> Any:
    if options.workers is None and options.scheduler is None:
        yield
        return
    from distributed import Client, LocalCluster

    if options.scheduler is not None:
        with Client(options.scheduler):
            yield
        return
    with LocalCluster(n_workers=options.workers, threads_per_worker=1, processes=True, memory_limit=options.memory,
                      dashboard_address=":0") as cluster, Client(cluster):
        yield


def main(arguments: list[str]) -> int:
    # argparse takes -100,-75,100,75 for an option unless it is joined to its own.
    joined = [f"-w{next(rest, '')}" if word in ("-w", "--window") else word for rest in [iter(arguments)] for word in rest]
    parser = _parser()
    options = parser.parse_args(joined)
    try:
        with _workers(options):
            lines = _lines(options.files, options.block)
            manifest = (clip_to_files(lines, options.output, options.window) if options.tiles is None else
                        clip_to_tiles(lines, options.output, grid(options.window, *options.tiles)))
    except (TypeError, ValueError) as error:
        parser.error(str(error))
    except (ImportError, OSError) as error:
        print(f"{parser.prog}: {error}", file=sys.stderr)
        return 1
    results = [*manifest["parts"], *manifest.get("tiles", [])]
    errors = [result["error"] for result in results if result["error"] is not None]
    for text in errors:
        print(text, file=sys.stderr)
    parts = manifest["parts"]
    print(f"{sum(part['pieces'] for part in parts)} pieces of {lines.shape[0]} segments in {options.output}, from "
          f"{len(parts)} part{'s' * (len(parts) != 1)}" + (f"; {len(errors)} failed" if errors else ""))
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
