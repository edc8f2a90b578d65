# SPDX-License-Identifier: GPL-3.0-or-later
"""The folder of a result: what is removed from it, what stays, and what is refused."""
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
    import dask
    import dask.array as da
    import clearcut.dask
except ImportError:
    da = None

WINDOW = (-100, -75, 100, 75)


def plain(n):
    return np.random.default_rng(1).uniform(-200, 200, (n, 4))


@unittest.skipIf(da is None, "python3-dask is not installed")
class Folder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        scheduler = dask.config.set(scheduler="sync")
        self.addCleanup(scheduler.__exit__, None, None, None)

    def lines(self, chunk=100):
        return da.from_array(plain(1000), chunks=(chunk, 4))

    def names(self):
        return sorted(os.listdir(self.folder))

    def test_only_results_are_removed(self):
        """What a user has in the folder stays, whatever its name, and all numbers of an earlier result go."""
        names = ["parts/thesis.txt", "part-list.unfinished", "part-00003-mine.npy", "tile-00000-cut.npy/mine.txt",
                 "part-00500-cut.npy", ".parts-mine/mine.txt"]
        for name in names:
            (self.folder / name).parent.mkdir(exist_ok=True)
            (self.folder / name).write_text("precious")
        for _ in range(2):
            clearcut.dask.clip_to_files(self.lines(), self.folder, WINDOW)
            clearcut.dask.clip_to_tiles(self.lines(), self.folder, clearcut.dask.grid(WINDOW, 3, 2))
        clearcut.dask.clip_to_files(self.lines(500), self.folder, WINDOW)
        self.assertEqual({(self.folder / name).read_text() for name in names}, {"precious"})
        ours = [f"part-0000{i}-{key}.npy" for i in (0, 1) for key in ("cut", "segments", "source")]
        self.assertEqual(self.names(), sorted(["manifest.json", *ours, *{name.split("/")[0] for name in names}]))

    def test_a_killed_run_leaves_no_result(self):
        """No manifest says that it is complete; the next run removes what is there."""
        clearcut.dask.clip_to_files(self.lines(), self.folder, WINDOW)
        loaded = []

        def end(block):
            loaded.append(block)
            if len(loaded) == 6:
                (self.folder / "part-00006-cut.npy.lost.unfinished").touch()
                raise KeyboardInterrupt
            return block

        mortal = self.lines().map_blocks(end, dtype=float, meta=np.zeros((0, 4)))
        self.assertRaises(KeyboardInterrupt, clearcut.dask.clip_to_files, mortal, self.folder, WINDOW)
        self.assertNotIn("manifest.json", self.names())
        self.assertIn("part-00004-cut.npy", self.names())
        loaded.clear()
        self.assertRaises(KeyboardInterrupt, clearcut.dask.clip_to_tiles, mortal, self.folder, [WINDOW])
        self.assertEqual(self.names(), ["manifest.json.unfinished", "part-00006-cut.npy.lost.unfinished"])
        # As if this process had been killed: nothing was tidied.
        between = json.loads((self.folder / "manifest.json.unfinished").read_text())["between"]
        (self.folder / between).mkdir()
        (self.folder / between / "part-00000-ends.npy").touch()
        clearcut.dask.clip_to_files(self.lines(1000), self.folder, WINDOW)
        self.assertEqual(self.names(), ["manifest.json", *(f"part-00000-{key}.npy" for key in ("cut", "segments", "source"))])

    def test_a_manifest_of_another_program_is_refused(self):
        for text in ["", "[]", '{"name": "web page"}', '{"parts": 5}', '{"parts": [{"part": "../x"}]}', '{"parts": [7]}']:
            (self.folder / "manifest.json").write_text(text)
            with self.assertRaisesRegex(ValueError, "manifest.json is not a manifest of clearcut"):
                clearcut.dask.clip_to_files(self.lines(), self.folder, WINDOW)
            self.assertEqual((self.folder / "manifest.json").read_text(), text)

    def test_a_folder_with_an_input_is_refused(self):
        clearcut.dask.clip_to_files(self.lines(), self.folder, (-1e3, -1e3, 1e3, 1e3))
        (self.folder / "lines.csv").write_text("1,2,3,4\n")
        before = {name: (self.folder / name).read_bytes() for name in self.names()}
        table = clearcut.dask.read_csv(self.folder / "lines.csv")
        arrays = clearcut.dask.read_npy(str(self.folder / "part-*-segments.npy"), 30)
        with tempfile.TemporaryDirectory() as other:
            os.symlink(self.folder, f"{other}/folder")
            os.symlink(self.folder / "part-00007-segments.npy", f"{other}/link.npy")
            link = clearcut.dask.read_npy(f"{other}/link.npy")
            for lines, name in [(table, "lines.csv"), (arrays, "part-0000"), (arrays * 2, "part-0000"), (link, "link.npy")]:
                for folder in (self.folder, f"{other}/folder"):
                    with self.assertRaisesRegex(ValueError, f"must not hold an input, but it holds .*/{name}"):
                        clearcut.dask.clip_to_files(lines, folder, WINDOW)
                    with self.assertRaisesRegex(ValueError, f"must not hold an input, but it holds .*/{name}"):
                        clearcut.dask.clip_to_tiles(lines, folder, [WINDOW])
            clearcut.dask.clip_to_files(arrays, f"{other}/out", WINDOW)
        self.assertEqual({name: (self.folder / name).read_bytes() for name in self.names()}, before)

    def test_files_are_on_the_disk_before_they_have_their_name(self):
        done = []
        sync, replace = os.fsync, os.replace
        with unittest.mock.patch("os.fsync", lambda file: done.append("sync") or sync(file)), \
                unittest.mock.patch("os.replace", lambda *names: done.append("replace") or replace(*names)):
            clearcut.dask.clip_to_files(self.lines(1000), self.folder, WINDOW)
        self.assertEqual(done, ["sync", "replace"] * 5)


if __name__ == "__main__":
    unittest.main()
