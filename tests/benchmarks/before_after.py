#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares what a benchmark prints in two builds: before_after.py BEFORE AFTER [ROUNDS] [-- ARGUMENTS]

BEFORE and AFTER are programs, run in turns (b a, a b, ...), so that a busy machine slows both. For each
figure that both print: the median of the rounds' ratios after / before, the middle half of them, and the
least of either. Less than 1: the second program needs less."""
import math
import re
import statistics
import subprocess
import sys

ROW = re.compile(r"^(.+?)\s+(?:median )?([\d.e+-]+) (ms|MB|bytes a segment)\b")


def figures(program, arguments):
    ended = subprocess.run([program, *arguments], check=True, text=True,
                           stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    rows = (ROW.match(line) for line in ended.stdout.splitlines())
    return {f"{row[1]}, {row[3]}": float(row[2]) for row in rows if row}


def quartiles(ratios):
    ratios = sorted(ratios)
    return statistics.median(ratios), ratios[len(ratios) // 4], ratios[len(ratios) * 3 // 4]


def main():
    split = sys.argv.index("--") if "--" in sys.argv else len(sys.argv)
    own, arguments = sys.argv[1:split], sys.argv[split + 1:]
    if len(own) not in (2, 3):
        sys.exit(__doc__)
    rounds = int(own[2]) if len(own) == 3 else 5
    runs = {0: [], 1: []}
    for i in range(rounds):
        for which in (0, 1) if i % 2 == 0 else (1, 0):
            runs[which].append(figures(own[which], arguments))
    print(f"{'':44} {'ratio':>7}  middle half      before       after")
    for name in runs[0][0]:
        before, after = ([run[name] for run in runs[i] if name in run] for i in (0, 1))
        if len(before) != rounds or len(after) != rounds:
            print(f"{name:44} only before")
            continue
        ratio, low, high = quartiles([a / b if b else (1.0 if a == 0 else math.inf) for b, a in zip(before, after)])
        print(f"{name:44} {ratio:7.3f}  {low:.3f}-{high:.3f} {min(before):11.6g} {min(after):11.6g}")
    for name in runs[1][0].keys() - runs[0][0].keys():
        print(f"{name:44} only after")


main()
