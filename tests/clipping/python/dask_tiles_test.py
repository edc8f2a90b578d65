# SPDX-License-Identifier: GPL-3.0-or-later
"""Tiles of a grid, each against clearcut.clip at its window."""
import json
import os
import pathlib
import signal
import tempfile
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

SHEET = (-100, -75, 100, 75)


def plain(n, dtype=np.float64):
    a = np.random.default_rng(1).uniform(-200, 200, (n, 4)).astype(dtype)
    a[::50] = np.nan
    a[1::50, 2] = np.inf
    a[2::50, 2:] = a[2::50, :2]  # points
    a[3::50] = [-100, -75, 100, 75]
    return a


def deadly(block, marks=None, block_id=None):
    """Kills its process when chunk 3 is loaded for the first time."""
    with open(pathlib.Path(marks, str(block_id[0])), "a") as mark:
        mark.write("x")
        first = mark.tell() == 1
    if block_id[0] == 3 and first:
        os.kill(os.getpid(), signal.SIGKILL)
    return block


@unittest.skipIf(da is None, "python3-dask is not installed")
class Tiles(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def assert_files_are(self, a, windows, manifest):
        self.assertEqual(manifest, json.loads((self.folder / "out/manifest.json").read_text()))
        for i, (window, tile) in enumerate(zip(windows, manifest["tiles"])):
            expected = clearcut.clip(a, window)
            self.assertEqual(tile, {"tile": i, "window": list(window), "pieces": len(expected.source), "error": None})
            for name, array in expected._asdict().items():
                np.testing.assert_array_equal(np.load(self.folder / f"out/tile-{i:05}-{name}.npy"), array)

    def test_each_tile_is_clip(self):
        for dtype in (np.float64, np.float32):  # windows are rounded to float32
            a = plain(3000, dtype)
            windows = clearcut.dask.grid(SHEET, 7, 3)
            for chunks in [(1000, 4), ((7, 0, 2993), 2)]:
                tiles = clearcut.dask.clip_at_windows(da.from_array(a, chunks=chunks), windows)
                for tile, window in zip(dask.compute(*map(tuple, tiles), scheduler="sync"), windows):
                    for one, other in zip(tile, clearcut.clip(a, window)):
                        np.testing.assert_array_equal(one, other)
                        self.assertEqual(one.dtype, np.int64 if one is tile[1] else other.dtype)

    def test_any_windows(self):
        a = plain(500)
        windows = np.array([[-1e308, -1, 1e308, 1], [0, 0, 0, 0], [-50, -50, 60, 60], [-50, 0, 60, 70], [500, 0, 600, 1]])
        manifest = clearcut.dask.clip_to_tiles(da.from_array(a, chunks=(200, 4)), str(self.folder / "out"), windows)
        self.assert_files_are(a, windows, manifest)
        self.assertEqual({path.name[:5] for path in (self.folder / "out").iterdir()}, {"manif", "tile-"})

    def test_grids_of_all_finite_windows(self):
        """The tiles fill the window: their outer edges are its edges, and none is inside out."""
        largest = np.finfo(float).max
        for low, high in [(-1.7e308, 1.7e308), (-largest, largest), (0, 5e-324), (-5e-324, 1e308), (1, 1), (1, 1 + 2e-16),
                          (-largest, -largest), (0.1, 0.7)]:
            for count in (1, 2, 3, 7, 1000):
                across = clearcut.dask.grid((low, 0, high, 1), count, 1)
                np.testing.assert_array_equal(clearcut.dask.grid((0, low, 1, high), 1, count)[:, [1, 0, 3, 2]], across)
                edges = np.append(across[:, 0], across[-1, 2])
                self.assertTrue(np.isfinite(edges).all(), (low, high, count))
                self.assertTrue((np.diff(edges / 2) >= 0).all(), (low, high, count))
                self.assertEqual((edges[0], edges[-1]), (low, high))
                np.testing.assert_array_equal(across[1:, 0], across[:-1, 2])
        np.testing.assert_array_equal(clearcut.dask.grid((-1.5e308, 0, 1.5e308, 1), 3, 1)[:, 0], [-1.5e308, -5e307, 5e307])

    def test_nothing(self):
        self.assertEqual(clearcut.dask.clip_at_windows(da.zeros((5, 4)), np.zeros((0, 4))), [])
        for lines in (da.zeros((0, 4)), da.from_array(np.zeros((0, 4)))):
            manifest = clearcut.dask.clip_to_tiles(lines, str(self.folder / "out"), clearcut.dask.grid(SHEET, 2, 1))
            self.assert_files_are(np.zeros((0, 4)), clearcut.dask.grid(SHEET, 2, 1).tolist(), manifest)

    def test_mistakes_are_refused_at_once(self):
        lines = da.zeros((5, 4))
        for error, text, windows in [(ValueError, r"shape \(4,\)", SHEET), (ValueError, r"shape \(2, 3\)", np.zeros((2, 3))),
                                     (TypeError, "a str", "wrong"), (ValueError, "xmin <= xmax", [(1, 0, 0, 1)]),
                                     (ValueError, "finite", [(0, 0, np.nan, 1)])]:
            self.assertRaisesRegex(error, text, clearcut.dask.clip_at_windows, lines, windows)
        for error, text, wrong in [(TypeError, "a list", []), (ValueError, r"shape \(5, 3\)", da.zeros((5, 3))),
                                   (TypeError, "int64", da.zeros((5, 4), dtype=int))]:
            self.assertRaisesRegex(error, text, clearcut.dask.clip_to_tiles, wrong, str(self.folder / "out"), [SHEET])
        for columns, rows in [(0, 1), (1, 1.5), (True, 1)]:
            self.assertRaisesRegex(ValueError, "whole number", clearcut.dask.grid, SHEET, columns, rows)

    @unittest.skipIf(distributed is None, "python3-distributed is not installed")
    def test_a_killed_worker_and_garbage(self):
        """Two processes read a table; one is killed, and a chunk cannot be read. All other rows are in their tiles."""
        a = np.random.default_rng(2).uniform(-200, 200, (4000, 4))
        rows = [",".join(map(repr, row)) for row in a.tolist()]
        rows[2345] = "garbage"
        (self.folder / "lines.csv").write_text("\n".join(rows))
        (self.folder / "marks").mkdir()
        windows = clearcut.dask.grid(SHEET, 3, 2)
        with distributed.LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=":0") as cluster, \
                distributed.Client(cluster):
            lines = clearcut.dask.read_csv(str(self.folder / "lines.csv"), "30 kB")
            mortal = lines.map_blocks(deadly, marks=str(self.folder / "marks"), dtype=float, meta=np.zeros((0, 4)))
            manifest = clearcut.dask.clip_to_tiles(mortal, str(self.folder / "out"), windows)
        self.assertGreaterEqual(len((self.folder / "marks/3").read_text()), 2)
        [bad] = [part for part in manifest["parts"] if part["error"] is not None]
        self.assertIn("lines.csv, line 2346: four numbers are needed, but this is 'garbage'", bad["error"])
        a[bad["first"]:bad["first"] + lines.chunks[0][bad["part"]]] = np.nan
        self.assert_files_are(a, windows, manifest)


if __name__ == "__main__":
    unittest.main()
