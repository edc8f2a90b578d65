# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of NumPy that are read in chunks."""
import pathlib
import tempfile
import unittest
import warnings

import numpy as np

import clearcut

warnings.simplefilter("default")  # Dask's own warnings are no errors
try:
    import dask
    import clearcut.dask
except ImportError:
    dask = None

WINDOW = (-100, -75, 100, 75)


def plain(n):
    return np.random.default_rng(1).uniform(-200, 200, (n, 4))


@unittest.skipIf(dask is None, "python3-dask is not installed")
class Arrays(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_files_of_numpy(self):
        a = plain(2500)
        np.save(self.folder / "a-1.npy", a[:1100])
        np.save(self.folder / "a-2.npy", np.asfortranarray(a[1100:]))
        lines = clearcut.dask.read_npy(str(self.folder / "a-*.npy"), 400)
        self.assertEqual(max(lines.chunks[0]), 400)
        np.testing.assert_array_equal(lines.compute(), a)

    def test_what_is_refused(self):
        for name, array in [("shape", np.zeros((2, 3))), ("type", np.zeros((2, 4), int)),
                            ("objects", np.array([[None] * 4], object))]:
            np.save(self.folder / f"{name}.npy", array)
            with self.assertRaisesRegex(ValueError, f"{name}.npy: "):
                clearcut.dask.read_npy(str(self.folder / f"{name}.npy"))
        for name, text in [("empty", b""), ("text", b"1,2,3,4\n")]:
            (self.folder / f"{name}.npy").write_bytes(text)
            with self.assertRaisesRegex(ValueError, f"{name}.npy: "):
                clearcut.dask.read_npy(str(self.folder / f"{name}.npy"))
        np.save(self.folder / "double.npy", plain(3))
        np.save(self.folder / "single.npy", plain(3).astype(np.float32))
        with self.assertRaisesRegex(TypeError, "float32 and float64"):
            clearcut.dask.read_npy([str(self.folder / "double.npy"), str(self.folder / "single.npy")])
        for rows in (0, 1.5, True):
            self.assertRaisesRegex(ValueError, "rows", clearcut.dask.read_npy, str(self.folder / "double.npy"), rows)

    def test_an_array_that_has_changed(self):
        path, out = self.folder / "lines.npy", self.folder / "out"
        for changed in (plain(900), plain(1001), plain(1000).astype(np.float32)):
            np.save(path, plain(1000))
            lines = clearcut.dask.read_npy(path, 100)
            np.save(path, changed)
            self.assertRaisesRegex(ValueError, "lines.npy was an array of shape .1000, 4.", lines.compute)
            manifest = clearcut.dask.clip_to_files(lines, out, WINDOW)
            self.assertEqual([part["pieces"] for part in manifest["parts"] if "was an array" in part["error"]], [0] * 10)


if __name__ == "__main__":
    unittest.main()
