# SPDX-License-Identifier: GPL-3.0-or-later
import json
import os
import pathlib
import signal
import tempfile
import threading
import time
import unittest
import warnings

import numpy as np

import clearcut

warnings.simplefilter("default")  # Dask's own warnings are no errors
try:
    import dask
    import dask.array as da
    import clearcut.dask
except ImportError:
    da = None
try:
    import distributed
except ImportError:
    distributed = None

WINDOW = (-100, -75, 100, 75)


def plain(n, dtype=np.float64):
    return np.random.default_rng(1).uniform(-200, 200, (n, 4)).astype(dtype)


def slow(block, marks=None):
    """Takes a while, and leaves a mark where its worker can be seen at work."""
    pathlib.Path(marks, str(os.getpid())).touch()
    time.sleep(0.2)
    return block


@unittest.skipIf(da is None, "python3-dask is not installed")
class Dask(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def same(self, pieces, a, **options):
        expected = clearcut.clip(a, WINDOW, **options)
        found = dask.compute(*pieces, scheduler="sync")
        self.assertEqual(found[1].dtype, np.int64)
        for one, other in zip(found, expected):
            np.testing.assert_array_equal(one, other)

    def test_chunks_are_the_whole(self):
        for dtype in (np.float64, np.float32):
            for chunks in [(1000, 4), (2999, 2), ((7, 0, 2993), 4)]:
                a = plain(3000, dtype)
                self.same(clearcut.dask.clip(da.from_array(a, chunks=chunks), WINDOW), a)
        self.same(clearcut.dask.clip(da.from_array(a.astype(float), chunks=700), WINDOW, kind="line", algorithm="lb"),
                  a.astype(float), kind="line", algorithm="lb")
        self.same(clearcut.dask.clip(da.zeros((0, 4)), WINDOW), np.zeros((0, 4)))

    def test_mistakes_are_refused_at_once(self):
        lines = da.from_array(plain(100), chunks=(10, 4))
        for error, call in [(TypeError, lambda: clearcut.dask.clip(plain(9), WINDOW)),
                            (ValueError, lambda: clearcut.dask.clip(lines[:, :3], WINDOW)),
                            (TypeError, lambda: clearcut.dask.clip(lines.astype(int), WINDOW)),
                            (ValueError, lambda: clearcut.dask.clip(lines, (0, 0, 1))),
                            (ValueError, lambda: clearcut.dask.clip(lines[lines[:, 0] > 0], WINDOW))]:
            self.assertRaises(error, call)

    def test_files_and_garbage(self):
        a = plain(3000)
        lines = da.concatenate([da.from_array(a[:2000], chunks=1000),
                                da.from_delayed(dask.delayed(lambda: "garbage")(), (1000, 4), float)])
        manifest = clearcut.dask.clip_to_files(lines, self.folder, WINDOW)
        self.assertEqual(manifest, json.loads(pathlib.Path(self.folder, "manifest.json").read_text()))
        self.assertEqual([part["error"] is None for part in manifest["parts"]], [True, True, False])
        self.assertTrue(manifest["parts"][2]["error"].startswith("chunk 2: segments must be a NumPy array"))
        self.assert_parts_are(clearcut.clip(a[:2000], WINDOW), manifest)

    def assert_parts_are(self, expected, manifest):
        for name, whole in expected._asdict().items():
            parts = [np.load(pathlib.Path(self.folder, f'part-{part["part"]:05}-{name}.npy'))
                     for part in manifest["parts"] if part["error"] is None]
            self.assertEqual(sum(part["pieces"] for part in manifest["parts"]), sum(map(len, parts)))
            np.testing.assert_array_equal(np.concatenate(parts), whole)
        self.assertEqual([p for p in os.listdir(self.folder) if p.endswith("unfinished")], [])

    @unittest.skipIf(distributed is None, "python3-distributed is not installed")
    def test_a_killed_worker_changes_nothing(self):
        a = plain(12_000)
        marks = pathlib.Path(self.folder, "marks")
        marks.mkdir()
        with distributed.LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None) as cluster, \
                distributed.Client(cluster):
            killed = []

            def kill():
                while not list(marks.iterdir()):
                    time.sleep(0.02)
                killed.append(int(next(marks.iterdir()).name))
                os.kill(killed[0], signal.SIGKILL)

            killer = threading.Thread(target=kill)
            killer.start()
            lines = da.from_array(a, chunks=(1000, 4)).map_blocks(slow, marks=str(marks), dtype=float,
                                                                 meta=np.zeros((0, 4)))
            manifest = clearcut.dask.clip_to_files(lines, self.folder, WINDOW)
            killer.join()
        self.assertEqual(len(killed), 1)
        self.assert_parts_are(clearcut.clip(a, WINDOW), manifest)


if __name__ == "__main__":
    unittest.main()
