#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Streams segments from files into files, by clearcut.dask on one and on two processes with little memory each, and by a
plain loop over clearcut.clip in one process. dask_stream.py [MILLIONS [npy|csv [MB [ROUNDS [ROWS]]]]]

Writes MILLIONS (100) of the paper's segments into a folder, which is removed at the end: 32 bytes a segment, and 44 for
each piece. No process may have more than MB (330) of memory of its own (RLIMIT_DATA). A chunk has ROWS (1000000) segments; of a
table it is a range of 32 bytes for each. The results of all ways are compared."""
import functools
import glob
import itertools
import os
import resource
import shutil
import sys
import tempfile
import time

import numpy as np

import clearcut.dask

WINDOW = (-100, -75, 100, 75)
MILLION = 1_000_000


def write(folder, millions, kind):
    chance = np.random.default_rng(1)
    for i in range(0, millions, 10):
        name = f"{folder}/lines-{i:05}.{kind}"
        size = min(10, millions - i) * MILLION
        if kind == "csv":
            with open(name, "w") as file:
                for _ in range(0, size, MILLION):
                    np.savetxt(file, paper(chance, MILLION), fmt="%.3f", delimiter=",")
        else:
            lines = np.lib.format.open_memmap(name, "w+", float, (size, 4))
            for first in range(0, size, MILLION):
                lines[first:first + MILLION] = paper(chance, MILLION)


def paper(chance, count):
    return chance.uniform((-960, -720) * 2, (960, 720) * 2, (count, 4))


def plain_loop(rows, folder, kind, out):
    """The same work without Dask: chunk by chunk, one thread, the same files."""
    os.makedirs(out, exist_ok=True)
    first = part = pieces = 0
    for name in sorted(glob.glob(f"{folder}/lines-*.{kind}")):
        for lines in chunks(name, kind, rows):
            found = clearcut.clip(lines, WINDOW, threads=1)
            np.save(f"{out}/part-{part:05}-segments.npy", found.segments)
            np.save(f"{out}/part-{part:05}-source.npy", found.source.astype(np.int64) + first)
            np.save(f"{out}/part-{part:05}-cut.npy", found.cut)
            first, part, pieces = first + len(lines), part + 1, pieces + len(found.source)
    return pieces


def chunks(name, kind, rows):
    if kind == "npy":
        lines = np.load(name, mmap_mode="r")
        yield from (np.array(lines[first:first + rows]) for first in range(0, len(lines), rows))
        return
    with open(name) as file:
        while texts := list(itertools.islice(file, rows)):
            yield np.loadtxt(texts, delimiter=",", quotechar='"', comments=None, ndmin=2)


def with_dask(rows, folder, kind, out):
    pattern = f"{folder}/lines-*.{kind}"
    lines = clearcut.dask.read_npy(pattern, rows) if kind == "npy" else clearcut.dask.read_csv(pattern, 32 * rows)
    manifest = clearcut.dask.clip_to_files(lines, out, WINDOW)
    errors = [part["error"] for part in manifest["parts"] if part["error"] is not None]
    if errors:
        raise SystemExit(errors[0])
    return sum(part["pieces"] for part in manifest["parts"])


def limit(megabytes):
    resource.setrlimit(resource.RLIMIT_DATA, (megabytes << 20, megabytes << 20))


def used():
    """The processor time of this process in s, and its peak memory in MB."""
    times = os.times()
    with open("/proc/self/status") as file:  # getrusage would count what the parent had
        [peak] = [int(line.split()[1]) // 1024 for line in file if line.startswith("VmHWM")]
    return times.user + times.system, peak


def measured_loop(rows, folder, kind, out):
    """Seconds, seconds of processor time (of the scheduler, of the workers), peaks of memory in MB, pieces."""
    begin, before = time.perf_counter(), used()
    pieces = plain_loop(rows, folder, kind, out)
    after = used()
    return time.perf_counter() - begin, (0, after[0] - before[0]), [after[1]], pieces


def measured_workers(workers, megabytes, rows, folder, kind, out):
    from distributed import Client, LocalCluster

    with LocalCluster(n_workers=workers, threads_per_worker=1, processes=True, memory_limit=f"{megabytes}MB",
                      dashboard_address=":0") as cluster, Client(cluster) as client:
        client.run(limit, megabytes)
        before, own, begin = client.run(used), used()[0], time.perf_counter()
        pieces = with_dask(rows, folder, kind, out)
        seconds, own, after = time.perf_counter() - begin, used()[0] - own, client.run(used)
    working = sum(after[each][0] - before[each][0] for each in after)
    return seconds, (own, working), [each[1] for each in after.values()], pieces


def summary(out, pieces):
    """The same for the same pieces."""
    return pieces, *(sum(int(np.load(path, mmap_mode="r").sum()) for path in glob.glob(f"{out}/*-{name}.npy"))
                     for name in ("source", "cut"))


def main(millions="100", kind="npy", megabytes="330", rounds="2", rows="1000000"):
    millions, megabytes = int(millions), int(megabytes)
    ways = {"one process": measured_loop}
    for workers in (1, 2):
        ways[f"Dask, {workers} worker{'s' * (workers > 1)}"] = functools.partial(measured_workers, workers, megabytes)
    limit(megabytes)
    with tempfile.TemporaryDirectory(prefix="clearcut-") as folder:
        write(folder, millions, kind)
        out, times, found = f"{folder}/out", {way: [] for way in ways}, set()
        for _ in range(int(rounds)):
            for way, measured in ways.items():
                seconds, processor, peaks, pieces = measured(int(rows), folder, kind, out)
                print(f"{way}: {seconds:.1f} s; processor time: scheduler {processor[0]:.1f} s, work {processor[1]:.1f} s; "
                      f"peak of memory {peaks} MB", flush=True)
                times[way].append(seconds)
                found.add(summary(out, pieces))
                shutil.rmtree(out)
        assert len(found) == 1, found
        print(f"{found.pop()[0]} pieces of {millions * MILLION} segments, the same each time; the limit is {megabytes} MB a process")
        for way, seconds in times.items():
            print(f"{way}: best {millions / min(seconds):.2f} million segments/s, "
                  f"{min(times['one process']) / min(seconds):.2f} of one process")


if __name__ == "__main__":
    main(*sys.argv[1:])
