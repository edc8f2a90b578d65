# SPDX-License-Identifier: GPL-3.0-or-later
"""Tiles that cannot be written."""
import json
import os
import pathlib
import tempfile
import unittest
import unittest.mock
import warnings

import numpy as np

import clearcut

warnings.simplefilter("default")  # Dask's own warnings are no errors
try:
    import dask.array as da
    import clearcut.dask
except ImportError:
    da = None
try:
    import distributed
except ImportError:
    distributed = None

WINDOW = (-100, -75, 100, 75)


def plain(n):
    return np.random.default_rng(1).uniform(-200, 200, (n, 4))


def die_at_tile_1(dask_worker=None):
    """Every process that writes tile 1 ends at once, with a file that is not complete."""
    import clearcut.dask._results as results

    save = results.save

    def save_or_die(name, **arrays):
        if name.endswith("tile-00001"):
            pathlib.Path(f"{name}-cut.npy.lost.unfinished").touch()
            os._exit(9)
        save(name, **arrays)

    results.save = save_or_die


@unittest.skipIf(da is None, "python3-dask is not installed")
class Tiles(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def lines(self):
        return da.from_array(plain(1000), chunks=(100, 4))

    def names(self):
        return sorted(os.listdir(self.folder))

    def test_a_tile_that_cannot_be_written(self):
        """It has an error and no files; all other tiles are there, and nothing else."""
        clearcut.dask.clip_to_tiles(self.lines(), self.folder, clearcut.dask.grid(WINDOW, 3, 1))
        save = np.save

        def save_or_fail(file, array):
            if "tile-00001-source" in file.name:
                raise OSError(28, "No space left on device")
            save(file, array)

        with unittest.mock.patch("numpy.save", save_or_fail):
            manifest = clearcut.dask.clip_to_tiles(self.lines(), self.folder, clearcut.dask.grid(WINDOW, 3, 1))
        self.assertEqual([tile["tile"] for tile in manifest["tiles"] if tile["error"] is None], [0, 2])
        self.assert_tile_1_is_missing(manifest, "tile 1: OSError: [Errno 28] No space left on device")

    @unittest.skipIf(distributed is None, "python3-distributed is not installed")
    def test_workers_that_die_at_a_tile(self):
        """It has an error. So may have others that Dask gave to the same workers."""
        with distributed.LocalCluster(n_workers=1, threads_per_worker=1, processes=True, dashboard_address=":0") as cluster, \
                distributed.Client(cluster) as client:
            client.register_worker_callbacks(die_at_tile_1)
            manifest = clearcut.dask.clip_to_tiles(self.lines(), self.folder, clearcut.dask.grid(WINDOW, 3, 1))
        self.assert_tile_1_is_missing(manifest, "tile 1: KilledWorker")

    def assert_tile_1_is_missing(self, manifest, error):
        self.assertEqual(manifest, json.loads((self.folder / "manifest.json").read_text()))
        self.assertTrue(manifest["tiles"][1]["error"].startswith(error), manifest["tiles"][1])
        self.assertEqual(manifest["tiles"][1]["pieces"], 0)
        good = [tile["tile"] for tile in manifest["tiles"] if tile["error"] is None]
        self.assertEqual(self.names(), ["manifest.json", *(f"tile-0000{i}-{key}.npy" for i in good
                                                          for key in ("cut", "segments", "source"))])


if __name__ == "__main__":
    unittest.main()
