# SPDX-License-Identifier: GPL-3.0-or-later
import json
import os
import pathlib
import signal
import tempfile
import unittest
import unittest.mock
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


def deadly(block, marks=None, block_id=None):
    """Counts how often each chunk is loaded, and kills its process when chunk 5 is loaded for the first time."""
    with open(pathlib.Path(marks, str(block_id[0])), "a") as mark:
        mark.write("x")
        first = mark.tell() == 1
    if block_id[0] == 5 and first:
        os.kill(os.getpid(), signal.SIGKILL)
    return block


def fail(error):
    raise error


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

    def test_many_chunks_are_one_layer(self):
        """With a layer for each chunk, planning would take a time that grows with the square of their number."""
        np.save(pathlib.Path(self.folder, "lines.npy"), plain(1000))
        lines = clearcut.dask.read_npy(os.path.join(self.folder, "lines.npy"), 1)
        self.assertEqual(lines.numblocks, (1000, 1))
        tiles = clearcut.dask.clip_at_windows(lines, clearcut.dask.grid(WINDOW, 2, 2))
        for pieces in (clearcut.dask.clip(lines, WINDOW), tiles[3]):
            self.assertLess(len(pieces.segments.dask.layers), 6)

    def test_workers_in_other_folders(self):
        """Relative paths mean the caller's folder."""
        a, home = plain(100), os.getcwd()
        os.chdir(self.folder)
        try:
            np.save("lines.npy", a)
            np.savetxt("lines.csv", a, delimiter=",", fmt="%r")
            both = [clearcut.dask.read_npy("lines.npy"), clearcut.dask.read_csv("lines.csv")]
        finally:
            os.chdir(home)
        for lines in both:
            np.testing.assert_array_equal(lines.compute(), a)

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

    def test_a_chunk_that_cannot_be_loaded(self):
        """Its part says why, and the files of an earlier run are not taken for its pieces."""
        a = plain(5000)
        chunks = [da.from_array(a[i:i + 1000]) for i in range(0, 5000, 1000)]
        clearcut.dask.clip_to_files(da.concatenate(chunks), self.folder, WINDOW)
        pathlib.Path(self.folder, "part-00001-cut.npy.lost.unfinished").touch()
        for error, text in [(OSError(5, "Input/output error"), "chunk 3: OSError: [Errno 5] Input/output error"),
                            (MemoryError(), "chunk 3: MemoryError")]:
            chunks[3] = da.from_delayed(dask.delayed(fail)(error), (1000, 4), float)
            manifest = clearcut.dask.clip_to_files(da.concatenate(chunks), self.folder, WINDOW)
            self.assertEqual(manifest, json.loads(pathlib.Path(self.folder, "manifest.json").read_text()))
            self.assertEqual([part["error"] for part in manifest["parts"]], [None, None, None, text, None])
            self.assertEqual([p for p in os.listdir(self.folder) if p.startswith("part-00003")], [])
            found = [np.load(pathlib.Path(self.folder, f"part-0000{i}-source.npy")) for i in (0, 1, 2, 4)]
            source = clearcut.clip(a, WINDOW).source
            np.testing.assert_array_equal(np.concatenate(found), source[source // 1000 != 3])
        self.assertEqual([p for p in os.listdir(self.folder) if p.endswith("unfinished")], [])

    def test_a_full_disk(self):
        """The error of the part whose file does not fit, and no half of a part."""
        save = np.save

        def save_or_fail(file, array):
            if "part-00001-source" in file.name:
                file.write(b"half")
                raise OSError(28, "No space left on device")
            save(file, array)

        a = plain(3000)
        with unittest.mock.patch("numpy.save", save_or_fail):
            manifest = clearcut.dask.clip_to_files(da.from_array(a, chunks=(1000, 4)), self.folder, WINDOW)
        self.assertEqual([part["error"] for part in manifest["parts"]],
                         [None, "chunk 1: OSError: [Errno 28] No space left on device", None])
        self.assertEqual(sorted({p[:10] for p in os.listdir(self.folder)}), ["manifest.j", "part-00000", "part-00002"])

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
        with distributed.LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=":0") as cluster, \
                distributed.Client(cluster):
            lines = da.from_array(a, chunks=(1000, 4)).map_blocks(deadly, marks=str(marks), dtype=float,
                                                                  meta=np.zeros((0, 4)))
            manifest = clearcut.dask.clip_to_files(lines, self.folder, WINDOW)
        self.assertGreaterEqual(len((marks / "5").read_text()), 2)
        self.assert_parts_are(clearcut.clip(a, WINDOW), manifest)


if __name__ == "__main__":
    unittest.main()
