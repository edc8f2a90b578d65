# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables that are read by byte ranges, against the rows that were written."""
import pathlib
import random
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


def plain(n, seed=1):
    return np.random.default_rng(seed).uniform(-200, 200, (n, 4))


def table(rows, header="", end="\n"):
    return header + "".join(",".join(map(repr, row)) + end for row in rows.tolist())


class Folder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        if dask is not None:
            scheduler = dask.config.set(scheduler="sync")
            self.addCleanup(scheduler.__exit__, None, None, None)

    def file(self, name, text):
        path = self.folder / name
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return str(path)


@unittest.skipIf(dask is None, "python3-dask is not installed")
class Rows(Folder):
    def read(self, text, block_size="64 MiB"):
        return clearcut.dask.read_csv(self.file("lines.csv", text), block_size)

    def test_ranges_are_the_whole(self):
        """Several files, each cut into ranges of any length, with every kind of head and line break."""
        a = plain(300)
        chance = random.Random(3)
        for _ in range(40):
            size = chance.choice([150, 333, 1000, 4096, "1 MiB"])
            end = chance.choice(["\n", "\r\n", "\n\n", "\r\n\r\n"])
            heads = ["", "\ufeff", "x1,y1,x2,y2" + end, "\n# a comment\n", "\ufeffX1, y1 ,x2,Y2" + end, "# a\n\nx1,y1,x2,y2" + end]
            parts = np.split(a, sorted(chance.choices(range(301), k=2)))
            paths = [self.file(f"{i}.csv", table(part, chance.choice(heads), end)) for i, part in enumerate(parts)]
            if chance.random() < 0.5:
                self.file("2.csv", pathlib.Path(paths[2]).read_bytes().rstrip())
            lines = clearcut.dask.read_csv(paths, size)
            self.assertEqual(lines.shape, a.shape)
            np.testing.assert_array_equal(lines.compute(), a)
        self.assertGreater(len(clearcut.dask.read_csv(paths, 333).chunks[0]), 50)

    def test_a_head_may_be_longer_than_a_range(self):
        """Comments, a header and rows of any length, in ranges that are shorter."""
        chance = random.Random(5)
        for _ in range(30):
            end, names, text = chance.choice(["\n", "\r\n"]), ["x1", "y1", "x2", "y2"], chance.choice(["", "\ufeff"])
            chance.shuffle(names)
            names.insert(chance.randrange(5), "n\u00e9" * chance.randrange(1, 60))
            text += "".join(chance.choice(["", "# " + "a licence " * chance.randrange(20)]) + end for _ in range(chance.randrange(5)))
            text += ",".join(names) + end
            rows = [dict(zip(names, np.round(row, 1).tolist())) for row in plain(chance.randrange(1, 30))[:, [0, 1, 2, 3, 0]]]
            for row in rows:
                text += ",".join(str(row[name]) if len(name) == 2 else "\u20ac" * chance.randrange(40) for name in names)
                text += end * chance.randrange(1, 3)
            expected = [[row[name] for name in ("x1", "y1", "x2", "y2")] for row in rows]
            for size in [10, 150, chance.randrange(10, 150)]:
                np.testing.assert_array_equal(self.read(text, size).compute(), expected, f"{size}: {text!r}")

    def test_lines_are_counted_from_the_first_of_the_file(self):
        for head in ["", "\ufeff", "\ufeff# a comment\r\n\r\n", "# a long comment\n" * 9 + "x1,y1,x2,y2\n"]:
            text = head + "1,2,3,4\n" * 9 + "five,6,7,8\n"
            for size in (10, 40, 1000):
                with self.assertRaisesRegex(ValueError, f"lines.csv, line {text.count(chr(10))}: four numbers"):
                    self.read(text, size).compute()

    def test_lengths_of_ranges_that_are_refused(self):
        for size in (0, -5, "0 B", "0.4 B", "-1 MiB", "wide", 1.5, True, None):
            with self.assertRaises(ValueError):
                self.read("1,2,3,4\n", size)

    def test_source_is_the_row_of_all_files(self):
        a = plain(2000)
        self.file("b-1.csv", table(a[:700], "x1,y1,x2,y2\n"))
        self.file("b-2.csv", table(a[700:]))
        found = dask.compute(*clearcut.dask.clip(clearcut.dask.read_csv(str(self.folder / "b-*.csv"), 5000), WINDOW))
        for one, other in zip(found, clearcut.clip(a, WINDOW)):
            np.testing.assert_array_equal(one, other)

    def test_columns_by_name_and_in_quotation_marks(self):
        text = 'layer,"y2",x1,x2,y1,colour\n"a, ""b""","4",1,3,2,red\n,8,5,"7",6,\n'
        np.testing.assert_array_equal(self.read(text).compute(), [[1, 2, 3, 4], [5, 6, 7, 8]])
        np.testing.assert_array_equal(self.read("1,2,3,4,walls\n5,6,7,8\n").compute(), [[1, 2, 3, 4], [5, 6, 7, 8]])

    def test_other_separators_names_and_decimal_commas(self):
        expected = [[1.5, 2, -3, 40], [5, 6, 7, 8.25]]
        for text in ["1,5;2;-3;4e1\n5;6;7;8,25\n", "x1;y1;x2;y2;a\r\n1,5;2;-3;40;b, c.d\r\n5;6;7;8,25;\r\n",
                     "1.5\t2\t-3\t40\n5\t6\t7\t8.25\n", "1,5 2 -3  40\n5\t6 7 8,25\n", '"1,5";2;"-3";40\n5;6;7;"8,25"\n',
                     "x0,y0,x1,y1\n1.5,2,-3,40\n5,6,7,8.25\n", "Start_X;Start Y;End-X;end.y\n1,5;2;-3;40\n5;6;7;8,25\n",
                     "y1;x0;note;y0;x1\n40;1,5;a;2;-3\n8,25;5;b;6;7\n"]:
            for size in (10, 1000):
                np.testing.assert_array_equal(self.read(text, size).compute(), expected, text)
        for text, error in [("1,5;2.5;3;4\n", "line 1: this has both decimal commas and points: '1,5;2.5;3;4'"),
                            ("1;2;3;4\n1.234,5;2;3;4\n", "line 2: this has both decimal commas and points"),
                            ("1;2;3;4\n1;2;3\n", "line 2: four numbers are needed, but this is '1;2;3'")]:
            with self.assertRaisesRegex(ValueError, error):
                self.read(text).compute()

    def test_nothing(self):
        for text in ["", "\n\n", "x1,y1,x2,y2\n", "# only a comment"]:
            self.assertEqual(self.read(text).compute().shape, (0, 4))

    def test_numbers_that_are_none(self):
        np.testing.assert_array_equal(self.read("nan,inf,-Infinity,1e400\n").compute(), [[np.nan, np.inf, -np.inf, np.inf]])

    def test_what_is_wrong_is_named(self):
        for text, error in [("1,2,3,4\n\n5,6,seven,8\n", "line 3: four numbers are needed, but this is '5,6,seven,8'"),
                            ("#\nx1,y1,x2,y2\n1,2,3\n", "line 3: four numbers are needed, but this is '1,2,3'"),
                            ("1,2,3,4\r\n1;2;3;4\r\n", "line 2: four numbers are needed, but this is '1;2;3;4'"),
                            ("1,2,3,4\n1_0,2,3,4\n", "line 2: four numbers"),
                            ("1,2,3,4\n  \n", "line 2: four numbers are needed, but this is '  '"),
                            (b"1,2,3,4\n\x00\xff\x89PNG\n", "line 2: four numbers"),
                            ("1,2,3,4\nf\u00fcnf,6,7,8\n", "line 2: four numbers are needed, but this is 'f\u00fcnf,6,7,8'"),
                            ('1,2,3,4,"two\nlines"\n', "line 1: a quoted field must not contain a line break")]:
            with self.assertRaises(ValueError) as caught:
                self.read(text).compute()
            self.assertTrue(str(caught.exception).startswith(f"{self.folder}/lines.csv, {error}"), str(caught.exception))

    def test_any_bytes(self):
        """Whatever is in a table: the same rows for ranges of any length, or a ValueError that names the file."""
        chance, results, errors = random.Random(8), 0, 0
        for _ in range(80):
            text = bytearray(table(plain(12).round(1), "x1,y1,x2,y2\n", chance.choice(["\n", "\r\n"])).encode())
            for _ in range(chance.choice([0, 1, 1, 2, 5])):
                at = chance.randrange(12, len(text))
                text[at:at + chance.choice([0, 1, 30])] = chance.choice([b"\n", b"\r", b'"', b'""', b",", b" ", b"\0", b"\xff", b"#",
                                                                         b"-", b"e9", b"nan", b'"1,2"', b"\n\n", b"_"])
            found = []
            for size in (chance.randrange(13, 200), 1 << 20):
                try:
                    found.append(self.read(bytes(text), size).compute().tolist())
                except ValueError as error:
                    self.assertIn("lines.csv, ", str(error))
                    found.append(None)
            np.testing.assert_equal(found[0], found[1], repr(bytes(text)))
            results += found[0] is not None
            errors += found[0] is None
        self.assertGreater(min(results, errors), 10)

    def test_what_is_refused_at_once(self):
        for text in ["a,b,c,d\n1,2,3,4\n", "\0" * 200_000, "x1,y1,x2\n", "x1,x1,y1,x2,y2\n"]:
            with self.assertRaisesRegex(ValueError, "lines.csv: the first row must be four numbers or a header that names"):
                self.read(text)
        self.assertRaises(FileNotFoundError, clearcut.dask.read_csv, str(self.folder / "none-*.csv"))
        self.file("a1.csv", "1,2,3,4\n")
        with self.assertRaisesRegex(ValueError, "must not contain"):  # a1.csv would be read
            clearcut.dask.read_csv(self.file("a[1].csv", "5,6,7,8\n"))
        self.assertRaises(OSError, clearcut.dask.read_csv, str(self.folder / "none.csv"))
        with self.assertRaisesRegex(ValueError, "must not contain"):  # Dask would read b::c.csv as two addresses
            clearcut.dask.read_csv(self.file("b::c.csv", "5,6,7,8\n"))

    def test_all_tables_without_a_head_are_named(self):
        paths = [self.file(f"{i}.csv", text) for i, text in enumerate(["a,b\n", "1,2,3,4\n", "caf\u00e9\n"])]
        with self.assertRaises(ValueError) as caught:
            clearcut.dask.read_csv(paths)
        first, second = str(caught.exception).split("\n")
        self.assertTrue(first.startswith(f"{paths[0]}: the first row must be"), first)
        self.assertTrue(second.startswith(f"{paths[2]}: the first row must be"), second)
        self.assertTrue(second.endswith("'caf\u00e9'"), second)

    def test_each_pattern_must_match(self):
        path = self.file("lines.csv", "1,2,3,4\n")
        for patterns in [[path, str(self.folder / "none-*.csv")], [str(self.folder / "none-*.csv"), path]]:
            with self.assertRaisesRegex(FileNotFoundError, "^no file matches '[^']*/none-[*].csv'$"):
                clearcut.dask.read_csv(patterns)

    def test_garbage_is_a_part_with_an_error(self):
        """The rows of all other ranges keep their indices."""
        a = plain(1000)
        texts = [table(a[i:i + 1]) for i in range(1000)]
        texts[512] = "\x00garbage\n"
        lines = clearcut.dask.read_csv(self.file("lines.csv", "".join(texts)), 8000)
        manifest = clearcut.dask.clip_to_files(lines, str(self.folder / "out"), WINDOW)
        errors = [part for part in manifest["parts"] if part["error"] is not None]
        self.assertEqual(len(errors), 1)
        self.assertIn("lines.csv, line 513: four numbers are needed", errors[0]["error"])
        lost = range(errors[0]["first"], errors[0]["first"] + lines.chunks[0][errors[0]["part"]])
        self.assertIn(512, lost)
        found = [np.load(path) for path in sorted((self.folder / "out").glob("part-*-source.npy"))]
        source = clearcut.clip(a, WINDOW).source
        np.testing.assert_array_equal(np.concatenate(found), source[~np.isin(source, lost)])


if __name__ == "__main__":
    unittest.main()
