# SPDX-License-Identifier: GPL-3.0-or-later
"""`python3 -m clearcut.dask`: what it says, and its exit codes."""
import contextlib
import importlib.util
import io
import pathlib
import subprocess
import sys
import tempfile
import unittest
import unittest.mock
import warnings

import numpy as np

import clearcut

warnings.simplefilter("default")  # Dask's own warnings are no errors
try:
    import dask
    from clearcut.dask import __main__ as program
except ImportError:
    dask = None

WINDOW = (-100, -75, 100, 75)


def plain(n):
    return np.random.default_rng(1).uniform(-200, 200, (n, 4))


def table(rows, header=""):
    return header + "".join(",".join(map(repr, row)) + "\n" for row in rows.tolist())


@unittest.skipIf(dask is None, "python3-dask is not installed")
class Program(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def file(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return str(path)

    def run_on(self, *words):
        """Its exit code, and what it says on standard output and standard error."""
        said, errors = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(said), contextlib.redirect_stderr(errors):
            try:
                code = program.main(list(map(str, words)))
            except SystemExit as end:
                code = end.code
        return code, said.getvalue(), errors.getvalue()

    def test_on_workers(self):
        np.save(self.folder / "lines.npy", plain(1000))
        workers = ["-j", "1"] if importlib.util.find_spec("distributed") else []
        found = subprocess.run([sys.executable, "-m", "clearcut.dask", self.folder / "lines.npy", "-w", "-100,-75,100,75",
                                "-o", self.folder / "out", *workers], capture_output=True, text=True)
        self.assertEqual(found.returncode, 0, found.stderr)
        self.assertEqual(found.stdout, f"650 pieces of 1000 segments in {self.folder}/out, from 1 part\n")

    def test_parts_and_tiles(self):
        a = plain(1000)
        path = self.file("lines.csv", table(a, "x1,y1,x2,y2\n"))
        pieces = len(clearcut.clip(a, WINDOW).source)
        out = self.folder / "out"
        code, said, error = self.run_on(path, "-w", "-100,-75,100,75", "-o", out, "-b", "20 kB")
        self.assertEqual((code, error), (0, ""))
        self.assertRegex(said, rf"^{pieces} pieces of 1000 segments in {out}, from [2-5] parts\n$")
        np.save(self.folder / "lines.npy", a)
        code, said, error = self.run_on(self.folder / "lines.npy", "--window", "-100,-75,100,75", "-o", out, "-t", "3x2")
        self.assertEqual((code, error), (0, ""))
        self.assertIn("of 1000 segments", said)
        self.assertEqual(len(list(out.glob("tile-*-cut.npy"))), 6)

    def test_garbage_has_exit_code_1(self):
        path = self.file("lines.csv", "1,2,3,4\nfive,6,7,8\n")
        code, _, said = self.run_on(path, "-w", "0,0,9,9", "-o", self.folder / "out")
        self.assertEqual((code, said), (1, f"chunk 0: {path}, line 2: four numbers are needed, but this is 'five,6,7,8'\n"))
        self.assertEqual(self.run_on(self.folder / "none.csv", "-w", "0,0,9,9", "-o", self.folder / "out")[0], 1)

    def test_one_of_each(self):
        code, said, error = self.run_on(self.file("lines.csv", "1,2,3,4\n"), "-w", "0,0,9,9", "-o", self.folder / "out")
        self.assertEqual((code, said, error), (0, f"1 piece of 1 segment in {self.folder}/out, from 1 part\n", ""))

    def test_faults_of_files_have_exit_code_1(self):
        """They are named, and nothing is clipped, because the rows of later files could not be numbered."""
        good, bad, out = self.file("good.csv", "1,2,3,4\n"), self.file("bad.csv", "a,b\n"), self.folder / "out"
        np.save(self.folder / "shape.npy", np.zeros((2, 3)))
        for files in [(good, bad), (self.folder / "shape.npy",), (good, self.folder / "none.csv"),
                      (good, self.folder / "none-*.csv"), (self.file("text.npy", "1,2"),)]:
            code, said, error = self.run_on(*files, "-w", "0,0,9,9", "-o", out)
            self.assertEqual((code, said, error.count("\n")), (1, "", 1), error)
            self.assertIn(str(files[-1]), error)
        self.assertFalse(out.exists())

    def test_wrong_arguments_have_exit_code_2(self):
        """With a sentence that says what is right, before any file is read."""
        wrong = [(("-w", "0,0,9"), "window must be 4 numbers"), (("-w", "9,0,0,9"), "xmin <= xmax"),
                 (("-w", "0,0,nine,9"), "four numbers XMIN,YMIN,XMAX,YMAX"), (("-w", "0,0,nan,9"), "finite"), (("-w",), "expected one argument")]
        wrong += [(("-t", text), "two whole numbers from 1 on, such as 3x2") for text in ("0x2", "2", "2x", "2x3x4", "axb")]
        wrong += [(("-b", text), "a number of bytes from 1 B on") for text in ("-5", "0", "0.2", "wide", "-1 MiB", "nan", "inf")]
        wrong += [(("-j", text), "a whole number from 1 on") for text in ("0", "-1", "two", "1.5")]
        wrong += [(("-j", "1", "-m", text), "a number of bytes from 200 MB on") for text in ("0", "-1", "1 MB", "much")]
        wrong += [(("-o", self.folder), "must not hold an input")]
        path = self.file("lines.csv", "1,2,3,4\n")
        for words, text in wrong:
            code, said, error = self.run_on(path, "-w", "0,0,9,9", "-o", self.folder / "out", *words)
            self.assertEqual((code, said), (2, ""), words)
            self.assertRegex(error, f"\n[^\n]*error: [^\n]*{text}[^\n]*\n$")
            self.assertNotIn("invalid _", error)
        code, said, error = self.run_on(path, self.folder / "none.npy", "-w", "0,0,9,9", "-o", self.folder / "out")
        self.assertEqual((code, said), (2, ""))
        self.assertIn("error: the files must be all .csv or all .npy", error)

    @unittest.skipIf(importlib.util.find_spec("distributed") is None, "python3-distributed is not installed")
    def test_a_cluster_without_workers(self):
        from distributed import LocalCluster

        path = self.file("lines.csv", "1,2,3,4\n")
        with unittest.mock.patch.object(program, "_SECONDS", 1):
            with LocalCluster(n_workers=0, dashboard_address=":0") as cluster:
                address = cluster.scheduler_address
                found = self.run_on(path, "-w", "0,0,9,9", "-o", self.folder / "out", "-s", address)
            self.assertEqual(found[:2], (2, ""))
            self.assertIn(f"the scheduler has no workers after 1 seconds; start some, such as: dask worker {address}\n", found[2])
            for gone in (address, "nonsense://there", "there"):
                code, said, error = self.run_on(path, "-w", "0,0,9,9", "-o", self.folder / "out", "-s", gone)
                self.assertEqual((code, said), (2, ""))
                self.assertIn(f"error: no scheduler answers at {gone}\n", error)


if __name__ == "__main__":
    unittest.main()
