# SPDX-License-Identifier: GPL-3.0-or-later
"""What is refused: always a TypeError or a ValueError that says what it got."""
import random
import unittest

import numpy as np

import clearcut

WINDOW = (0, 0, 1, 1)
A = np.zeros((3, 4))
SOME = np.random.default_rng(6).uniform(-10, 10, (20, 4))


class Refused(unittest.TestCase):
    def refuses(self, error, text, *arguments, call=clearcut.clip, **options):
        with self.assertRaises(error) as caught:
            call(*arguments, **options)
        self.assertIn(text, str(caught.exception))

    def test_shapes(self):
        for shape in [(4,), (3, 3), (2, 2, 2), (), (0,), (4, 3), (1, 4, 1)]:
            self.refuses(ValueError, f"shape {shape}", np.zeros(shape), WINDOW)

    def test_types(self):
        for dtype in ["i4", "f2", ">f8", "c16", "O", "S4", "?", "M8[s]"]:
            self.refuses(TypeError, "dtype", np.zeros((3, 4), dtype), WINDOW)
        for value in [[[0, 0, 1, 1]], None, "text", 3, memoryview(b"abcd")]:
            self.refuses(TypeError, "a " + type(value).__name__, value, WINDOW)
        self.refuses(TypeError, "longdouble" if np.dtype("g").name == "longdouble" else np.dtype("g").name,
                     np.zeros((3, 4), "g"), WINDOW)

    def test_masks(self):
        """A masked row would be clipped as if it were not masked."""
        masked = np.ma.masked_invalid([[0, 0, 1, 1], [np.nan, 0, 1, 1]])
        self.refuses(TypeError, "must not have a mask", masked, WINDOW)
        self.refuses(TypeError, "must not have a mask", masked, call=clearcut.Chunks)
        self.refuses(TypeError, "must not have a mask", masked, WINDOW, call=clearcut.split)
        for line in (masked[:, :2], masked[:, 0] * 1j):
            self.refuses(TypeError, "must not have a mask", [line], WINDOW, call=clearcut.clip_lines)

    def test_windows(self):
        self.refuses(TypeError, "either a window or a polygon", A)
        self.refuses(TypeError, "either a window or a polygon", A, WINDOW, polygon=[(0, 0), (1, 0), (0, 1)])
        self.refuses(ValueError, "these are 3", A, (0, 0, 1))
        self.refuses(TypeError, "a int", A, 5)
        self.refuses(TypeError, "a tuple", A, (0, 0, 1, "x"))
        for window in [np.array([0, 0, 1, 1j]), np.zeros((4, 1)), ("0", "0", "1", "1"), np.array(["0", "0", "1", "1"])]:
            self.refuses(TypeError, "window must be 4 numbers", A, window)
        self.refuses(ValueError, "finite", A, (0, 0, np.nan, 1))
        self.refuses(ValueError, "xmin <= xmax", A, (1, 0, 0, 1))

    def test_numbers_that_no_float_can_hold(self):
        self.refuses(TypeError, "window must be 4 numbers", A, (0, 0, 1, 10**400))
        self.refuses(TypeError, "points", A, polygon=[(0, 0), (9, 0), (0, 10**400)])

    def test_corners_of_any_kind(self):
        corners = np.array([[0, 0], [9, 0], [0, 9.5]])
        expected = clearcut.clip(SOME, polygon=corners)
        self.assertGreater(len(expected.source), 1)
        for given in (corners.tolist(), tuple(map(tuple, corners)), corners.astype("f4"), corners.astype(">f8"),
                      corners.astype("O"), corners[:, ::-1][:, ::-1], (pair for pair in corners), map(iter, corners)):
            for found, right in zip(clearcut.clip(SOME, polygon=given), expected):
                np.testing.assert_array_equal(found, right)

    def test_windows_of_any_kind(self):
        expected = clearcut.clip(SOME, (0, 0, 9, 9.5))
        for given in ([0, 0, 9, 9.5], (False, 0.0, 9, np.float32(9.5)), np.array([0, 0, 9, 9.5]), iter((0, 0, 9, 9.5)),
                      np.array([0, 0, 9, 9.5], "f2"), [np.array(0), np.int8(0), np.longdouble(9), 9.5]):
            for found, right in zip(clearcut.clip(SOME, given), expected):
                np.testing.assert_array_equal(found, right)

    def test_polygons(self):
        self.refuses(ValueError, "convex", A, polygon=[(0, 0), (9, 0), (1, 1), (0, 9)])
        self.refuses(ValueError, "not finite", A, polygon=[(0, 0), (9, 0), (np.nan, 1)])
        self.refuses(ValueError, "these are 2", A, polygon=[(0, 0), (9, 0)])
        self.refuses(TypeError, "points", A, polygon=[1, 2, 3])
        self.refuses(ValueError, "no form for convex polygons", A, polygon=[(0, 0), (9, 0), (0, 9)], algorithm="nln")

    def test_choices(self):
        for algorithm in ("x", "", "\udc80", "exact\0"):
            self.refuses(ValueError, f"no algorithm {algorithm!r}", A, WINDOW, algorithm=algorithm)
        self.refuses(TypeError, "algorithm must be a text", A, WINDOW, algorithm=3)
        self.refuses(ValueError, "kind must be one of", A, WINDOW, kind="spline")
        self.refuses(ValueError, "form must be one of", A, WINDOW, form="wrong")
        self.refuses(ValueError, "no published form", A, WINDOW, form="published")
        self.refuses(ValueError, "no form for infinite lines", A, WINDOW, kind="line")
        self.refuses(ValueError, "no form for rays", A, WINDOW, kind="ray", algorithm="cs")
        for threads in (1.5, True, "2", [], np.array([1, 2])):
            self.refuses(TypeError, "threads must be a whole number or None", A, WINDOW, threads=threads)
        for threads in (-1, 1025, 10**30, np.uint64(2**64 - 1)):
            self.refuses(ValueError, f"from 1 to 1024, but this is {threads}", A, WINDOW, threads=threads)
        self.refuses(ValueError, "from 1 to 1024", A, WINDOW, threads=0)
        self.refuses(TypeError, "float32", A.astype("f4"), WINDOW, kind="line")
        self.refuses(TypeError, "float64", A.astype("f4"), WINDOW, call=clearcut.split)

    def test_chunks(self):
        self.refuses(ValueError, "strides", np.zeros((4, 3)).T, call=clearcut.Chunks)
        chunks = clearcut.Chunks(A)
        self.refuses(ValueError, "0 <= first", 2, 9, call=chunks.update)
        self.refuses(ValueError, "xmin <= xmax", (1, 1, 0, 0), call=chunks.clip)

    def test_chunks_of_a_resized_array(self):
        for dtype in (np.float64, np.float32):
            for rows in (10, 200_000):
                drawing = np.zeros((100_000, 4), dtype)
                chunks = clearcut.Chunks(drawing)
                drawing.resize((rows, 4), refcheck=False)
                text = f"the array has {rows} rows, but had 100000 when its Chunks were made"
                self.refuses(ValueError, text, WINDOW, call=chunks.clip)
                self.refuses(ValueError, text, 0, 10, call=chunks.update)

    def test_lines(self):
        for lines in [[np.zeros(4)], [np.zeros((3, 3))]]:
            self.refuses((TypeError, ValueError), "shape", lines, WINDOW, call=clearcut.clip_lines)
        for lines in [[[(0, 0), (1, 1)]], 7, [np.zeros((2, 2), "f4")], "text"]:
            self.refuses(TypeError, "but this is", lines, WINDOW, call=clearcut.clip_lines)
        self.refuses(TypeError, "a int", 7, WINDOW, call=clearcut.clip_geometry)

    def test_polylines(self):
        points, offsets = np.zeros((5, 2)), np.array([0, 2, 5])

        def refuses(error, text, *arguments):
            self.refuses(error, text, *arguments, WINDOW, call=clearcut.clip_polylines)

        refuses(TypeError, "coordinates must be a float64 array", points.tolist(), offsets)
        refuses(TypeError, "dtype float32", points.astype("f4"), offsets)
        refuses(ValueError, "coordinates must have the shape (k, 2)", np.zeros((5, 3)), offsets)
        refuses(TypeError, "coordinates must not have a mask", np.ma.masked_invalid(points), offsets)
        for wrong in ([0, 2, 5], offsets.astype(float), offsets.astype(">i8"), offsets.astype("u8"), offsets.astype("i2"), None):
            refuses(TypeError, "offsets must be an int32 or int64 array", points, wrong)
        for wrong in (offsets[:0], offsets[None], np.array(0)):
            refuses(ValueError, "offsets must have the shape (m + 1,)", points, wrong)
        for wrong, text in (([0, 3, 2], "offset 2 is 2"), ([-1, 2, 5], "offset 0 is -1"), ([0, 2, 6], "offset 2 is 6"),
                            ([2**40, 2**40], f"offset 0 is {2**40}")):
            refuses(ValueError, text, points, np.array(wrong))
        refuses(TypeError, "offsets must not have a mask", points, np.ma.masked_equal(offsets, 2))
        self.refuses(ValueError, "xmin <= xmax", points, offsets, (1, 1, 0, 0), call=clearcut.clip_polylines)

    def test_traces(self):
        self.refuses(ValueError, "these are 3", (1, 2, 3), WINDOW, call=clearcut.trace)
        self.refuses(ValueError, "no published form", (1, 2, 3, 4), WINDOW, "exact", "published", call=clearcut.trace)

    def test_random_arguments(self):
        """Whatever is passed: a result, a TypeError or a ValueError."""
        chance = random.Random(11)
        dtypes = ["f8", "f4", ">f8", "i8", "c16", "O", "U3", "f2"]
        results = 0
        for _ in range(3000):
            shape = [chance.randrange(6) for _ in range(chance.randrange(4))]
            if chance.random() < 0.7:
                shape = [chance.randrange(50), 4]
            array = np.zeros(shape, chance.choice(dtypes[:2] * 4 + dtypes))
            if array.dtype.kind == "f" and array.size:
                array.flat[chance.randrange(array.size)] = chance.choice([np.nan, np.inf, 1e4, -0.0])
            if chance.random() < 0.3:
                array = array.T
            if chance.random() < 0.3 and array.ndim:
                array = array[::-2]
            window = chance.choice([WINDOW, (0, 0, 0, 0), (0, 0, 1), None, np.array([0, 0, 1, 1]), (-1e308, 0, 1e308, 1)])
            options = {}
            if chance.random() < 0.3:
                options["kind"] = chance.choice(["line", "ray", "segment"])
            if chance.random() < 0.3:
                options["algorithm"] = chance.choice(["lb", "exact", "skala", "?", None])
            if chance.random() < 0.2:
                options["polygon"] = np.random.default_rng(1).random((chance.randrange(6), chance.choice([2, 3])))
            try:
                results += len(clearcut.clip(array, window, **options)) == 3
            except (TypeError, ValueError) as error:
                self.assertGreater(len(str(error)), 20)
        self.assertGreater(results, 300)


if __name__ == "__main__":
    unittest.main()
