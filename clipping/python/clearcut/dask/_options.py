# SPDX-License-Identifier: MIT
"""The arguments of the program."""
from __future__ import annotations

import argparse
import contextlib
from typing import Callable

from dask.utils import parse_bytes

from .. import _clearcut

_ENDS = ("All files are looked at first: if one cannot be read, has no rows of four numbers or has a wrong header, nothing "
         "is clipped. Exit code: 0; 1 for such a file, or if a part could not be clipped: it is named, and all others are "
         "written; 2 for wrong arguments or a cluster without workers.")
_LEAST_MEMORY = "200 MB"  # a process that only waits has 100 MB


def parser_of(description: str | None) -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser("python3 -m clearcut.dask", description=description, epilog=_ENDS)
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
        return _clearcut.checked_window(numbers)
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
