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


def a_call(work, calls=2000):
    """Processor time of a call, in microseconds."""
    return 1e6 * best(lambda: [work() for _ in range(calls)], 15, time.process_time) / calls


def few(a):
    """Small calls, where reading the arguments and making arrays takes longer than clipping."""
    plain = a_call(lambda: np.add(a[:10], a[:10]))
    for n in (1, 10, 100):
        call = a_call(lambda: clearcut.clip(a[:n], WINDOW))
        print(f"{n} segments: {call:.2f} us a call, {call / plain:.1f} times numpy.add of 10 segments ({plain:.2f})")


def many_polylines(a):
    """100,000 polylines of 10 points: the points of the lines, and short steps from one of these to the next."""
    anywhere = a[:500_000].reshape(-1, 10, 2)
    steps = np.concatenate([anywhere[:, :1], anywhere[:, 1:] / 50], axis=1).cumsum(axis=1)
    offsets = np.arange(0, anywhere.size // 2 + 1, 10)
    for name, lines in (("long segments", anywhere), ("short segments", steps)):
        points, pairs = lines.reshape(-1, 2), np.concatenate([lines[:, :-1], lines[:, 1:]], axis=2).reshape(-1, 4)
        whole = 1e3 * best(lambda: clearcut.clip_polylines(points, offsets, WINDOW), 15, time.process_time)
        single = 1e3 * best(lambda: clearcut.clip(pairs, WINDOW, threads=1), 15, time.process_time)
        print(f"{len(lines)} polylines of 10 points, {name}: {whole:.2f} ms; / clip of their segments: {whole / single:.2f}")


def geometries():
    from shapely.geometry import LineString
    from shapely.ops import clip_by_rect

    for n in (2, 10, 100):
        line = LineString(np.random.default_rng(3).uniform(-40, 40, (n, 2)).cumsum(0))
        found, theirs = clearcut.clip_geometry(line, WINDOW), clip_by_rect(line, *WINDOW)
        assert abs(found.length - theirs.length) < 1e-9, "other lengths"
        ours, shapely = (a_call(work, 500) for work in (lambda: clearcut.clip_geometry(line, WINDOW),
                                                        lambda: clip_by_rect(line, *WINDOW)))
        print(f"a LineString of {n} points: {ours:.1f} us; / shapely.ops.clip_by_rect: {ours / shapely:.2f}")


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
    few(a)
    if n >= 500_000:
        many_polylines(a)
    try:
        geometries()
        per_line = shapely_times(a[:100_000])
    except ImportError:
        return
    print(f"shapely.ops.clip_by_rect: {per_line * 1e6:.2f} us a line; / clearcut: {per_line / (all_threads / n):.0f}")


if __name__ == "__main__":
    main()
