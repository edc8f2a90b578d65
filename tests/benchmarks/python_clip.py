#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""python_clip.py [MILLIONS]: the module clearcut against NumPy's vectorised Liang-Barsky and shapely, on the paper's
lines. The results are compared before anything is timed. Run it with PYTHONPATH=build/release/clipping/python."""
import sys
import time

import numpy as np

import clearcut

WINDOW = (-100.0, -75.0, 100.0, 75.0)


def liang_barsky(a, window):
    """The visible pieces and their sources, with whole arrays for each step."""
    xmin, ymin, xmax, ymax = window
    x1, y1 = a[:, 0], a[:, 1]
    dx, dy = a[:, 2] - x1, a[:, 3] - y1
    t0, t1 = np.zeros(len(a)), np.ones(len(a))
    with np.errstate(divide="ignore", invalid="ignore"):
        for p, q in ((-dx, x1 - xmin), (dx, xmax - x1), (-dy, y1 - ymin), (dy, ymax - y1)):
            r = q / p
            np.maximum(t0, r, out=t0, where=p < 0)
            np.minimum(t1, r, out=t1, where=p > 0)
            t1[(p == 0) & (q < 0)] = -1
    source = np.flatnonzero(t0 <= t1)
    t0, t1, x1, y1, dx, dy = (v[source] for v in (t0, t1, x1, y1, dx, dy))
    return np.column_stack([x1 + t0 * dx, y1 + t0 * dy, x1 + t1 * dx, y1 + t1 * dy]), source


def best(work, runs=7, clock=time.perf_counter):
    times = []
    for _ in range(runs):
        begin = clock()
        work()
        times.append(clock() - begin)
    return min(times)


def compare_with_numpy(a):
    found, (pieces, source) = clearcut.clip(a, WINDOW), liang_barsky(a, WINDOW)
    assert np.array_equal(found.source, source), "other lines are visible"
    assert np.allclose(found.segments, pieces, rtol=0, atol=1e-9), "other ends"


def shapely_times(a):
    from shapely.geometry import LineString
    from shapely.ops import clip_by_rect

    lines = [LineString(row.reshape(2, 2)) for row in a]
    found = clearcut.clip(a, WINDOW)
    lengths = np.zeros(len(a))
    s = found.segments
    lengths[found.source] = np.hypot(s[:, 2] - s[:, 0], s[:, 3] - s[:, 1])
    assert np.allclose(lengths, [clip_by_rect(line, *WINDOW).length for line in lines], atol=1e-9), "other lengths"
    return best(lambda: [clip_by_rect(line, *WINDOW) for line in lines], 3) / len(a)


def main():
    n = int(float(sys.argv[1] if len(sys.argv) > 1 else 10) * 1e6)
    a = np.random.default_rng(1).uniform(-1, 1, (n, 4)) * np.tile([200, 150], 2)
    compare_with_numpy(a[:200_000])
    all_threads, one = best(lambda: clearcut.clip(a, WINDOW)), best(lambda: clearcut.clip(a, WINDOW, threads=1))
    floats = a.astype(np.float32)
    single = best(lambda: clearcut.clip(floats, WINDOW))
    processor = best(lambda: clearcut.clip(a, WINDOW, threads=1), clock=time.process_time)
    numpy = best(lambda: liang_barsky(a, WINDOW), 2)
    numpy_processor = best(lambda: liang_barsky(a, WINDOW), 2, time.process_time)
    read = best(lambda: a.sum())
    print(f"{n} lines, seconds: clearcut {all_threads:.3f} (one thread {one:.3f}, float32 {single:.3f}), "
          f"NumPy {numpy:.3f}, a.sum() {read:.3f}")
    print(f"NumPy / clearcut: {numpy / all_threads:.1f} (one thread {numpy / one:.1f})")
    print(f"processor time: clearcut {processor:.3f}, NumPy {numpy_processor:.3f}")
    try:
        per_line = shapely_times(a[:100_000])
    except ImportError:
        return
    print(f"shapely.ops.clip_by_rect: {per_line * 1e6:.2f} us a line; / clearcut: {per_line / (all_threads / n):.0f}")


if __name__ == "__main__":
    main()
