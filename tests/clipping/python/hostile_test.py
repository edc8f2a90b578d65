# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrays of any dtype, byte order, layout and shape, in NumPy and Dask: each call gives the result of the same call on a
plain copy, or a TypeError or ValueError that names the shape or the dtype that it got."""
import random
import unittest
import warnings

import numpy as np

import clearcut

try:
    with warnings.catch_warnings():
        warnings.simplefilter("default")  # Dask's own warnings are no errors
        import dask
        import dask.array as da
        import clearcut.dask
except ImportError:
    da = None

WINDOW = (-1, -0.75, 1, 0.75)
GOOD = ["f8", "f4"]
BAD = [">f8", ">f4", "f2", "g", "i8", "u1", "?", "c16", ">c16", "O", "U3", "S2", "M8[s]", "m8[s]", "V16", [("x", "f8"), ("y", "f8")]]
NASTY = [np.nan, np.inf, -np.inf, -0.0, 5e-324, 1.7e308, -1.7e308, 1, -0.75]


def numbers(chance, shape, dtype):
    """Random values of any dtype; floats have some that are not finite, denormal or huge."""
    generator = np.random.default_rng(chance.randrange(1 << 30))
    values = np.where(generator.random(shape) < 0.1, generator.choice(NASTY, shape), generator.uniform(-2, 2, shape))
    dtype = np.dtype(dtype)
    if dtype.kind in "fc":
        with np.errstate(all="ignore"):
            return values.astype(dtype)
    return np.zeros(shape, dtype)


def shape_of_any_kind(chance, width):
    if chance.random() < 0.75:
        return (chance.choice([0, 1, 2, 7, 50, 5000]), width)
    return tuple(chance.choice([0, 1, 2, 4, 9]) for _ in range(chance.randrange(4)))


def laid_out(chance, array):
    """The same values in a random layout."""
    how = chance.choice(["plain", "order", "steps", "backwards", "unaligned", "repeated", "overlapping", "subclass"])
    if how == "order":
        array = np.asfortranarray(array)
    elif how == "steps" and array.ndim:
        wide = np.zeros([2 * n + 3 for n in array.shape], array.dtype)
        view = wide[tuple(slice(1, 1 + 2 * n, 2) for n in array.shape)]
        view[...] = array
        array = view
    elif how == "backwards" and array.ndim:
        array = np.flip(np.flip(array).copy())
    elif how == "unaligned" and not array.dtype.hasobject:
        memory = np.zeros(array.nbytes + 1, "u1")
        view = memory[1:].view(array.dtype).reshape(array.shape) if array.nbytes else array
        view[...] = array
        array = view
    elif how == "repeated" and array.ndim:
        array = np.broadcast_to(array[:1], array.shape) if len(array) else array
    elif how == "overlapping" and array.ndim == 2 and array.size > 8:
        array = np.lib.stride_tricks.sliding_window_view(array.reshape(-1), array.shape[1])
    elif how == "subclass":
        array = array.view(type("Derived", (np.ndarray,), {}))
    if chance.random() < 0.2:
        array = array.view()
        array.flags.writeable = False
    return array


def plain(array):
    return np.array(array, order="C", copy=True, subok=False)


class Property(unittest.TestCase):
    def check(self, call, array, is_right, call_plain=None):
        """Calls with the array, and with its plain copy. Returns 1 if there is a result."""
        before = plain(array)
        try:
            found = call(array)
        except (TypeError, ValueError) as error:
            self.assertFalse(is_right, f"{array.shape} {array.dtype} {array.strides}: {error}")
            self.assertTrue(str(array.shape) in str(error) or str(array.dtype) in str(error), str(error))
            return 0
        self.assertTrue(is_right, f"{array.shape} {array.dtype} is not refused")
        np.testing.assert_array_equal(array, before)
        self.same(found, (call_plain or call)(before))
        return 1

    def same(self, found, expected):
        if isinstance(expected, np.ndarray):
            self.assertEqual((found.dtype, found.shape), (expected.dtype, expected.shape))
            np.testing.assert_array_equal(found, expected)
        elif isinstance(expected, (tuple, list)) and not all(isinstance(each, int) for each in expected):
            self.assertEqual(len(found), len(expected))
            for one, other in zip(found, expected):
                self.same(one, other)
        else:
            self.assertEqual(found, expected)


class InNumPy(Property):
    def test_segments(self):
        chance, results = random.Random(17), 0
        triangle = [(-1, -1), (1, -1), (0, 1)]
        calls = [(GOOD, lambda a: clearcut.clip(a, WINDOW)),
                 (GOOD, lambda a: clearcut.clip(a, np.float32(WINDOW), algorithm="lb", threads=1)),
                 (["f8"], lambda a: clearcut.clip(a, WINDOW, kind="line", algorithm="lb")),
                 (["f8"], lambda a: clearcut.clip(a, WINDOW, kind="ray", algorithm="md")),
                 (["f8"], lambda a: clearcut.clip(a, polygon=triangle)),
                 (["f8"], lambda a: clearcut.split(a, WINDOW))]
        for _ in range(1200):
            dtype = chance.choice(GOOD + [chance.choice(BAD)])
            array = laid_out(chance, numbers(chance, shape_of_any_kind(chance, 4), dtype))
            dtypes, call = chance.choice(calls)
            results += self.check(call, array, dtype in dtypes and array.ndim == 2 and array.shape[1] == 4)
        self.assertGreater(results, 300)

    def test_chunks(self):
        """They keep the array, so it must be contiguous."""
        chance, results = random.Random(18), 0
        for _ in range(600):
            dtype = chance.choice(GOOD * 3 + [chance.choice(BAD)])
            array = laid_out(chance, numbers(chance, shape_of_any_kind(chance, 4), dtype))
            flat = array.flags.c_contiguous and array.flags.aligned
            results += self.check(lambda a: clearcut.Chunks(a).clip(WINDOW), array,
                                  dtype in GOOD and array.ndim == 2 and array.shape[1] == 4 and flat)
        self.assertGreater(results, 100)

    def test_lines(self):
        chance, results = random.Random(19), 0
        for _ in range(600):
            dtype = chance.choice(["f8", "f8", "c16", chance.choice([*BAD, "f4"])])
            shape = shape_of_any_kind(chance, 2)
            array = laid_out(chance, numbers(chance, shape[:1] if dtype == "c16" else shape, dtype))
            is_right = array.ndim == 1 if dtype == "c16" else dtype == "f8" and array.ndim == 2 and array.shape[1] == 2
            closed = chance.random() < 0.5

            def clip(lines):
                parts, source = clearcut.clip_lines([lines, lines], WINDOW, closed=closed, return_source=True)
                return np.concatenate([lines[:0], *parts]), list(map(len, parts)), source

            results += self.check(clip, array, is_right)
        self.assertGreater(results, 200)

    def test_polylines(self):
        """Coordinates and offsets, each of any kind."""
        chance, results = random.Random(22), 0
        for _ in range(900):
            dtype = chance.choice(["f8", "f8", "f8", "c16", chance.choice([*BAD, "f4"])])
            shape = shape_of_any_kind(chance, 2)
            points = laid_out(chance, numbers(chance, shape[:1] if dtype == "c16" else shape, dtype))
            size = len(points) if points.ndim else 0
            plain_offsets = sorted(chance.randrange(size + 1) for _ in range(chance.choice([1, 2, 9, 100])))
            offsets = laid_out(chance, np.array(plain_offsets, chance.choice(["i8", "i8", "i4", chance.choice(["u4", ">i4", "f8", "O"])])))
            closed = chance.random() < 0.5
            rows = points.ndim == 1 if dtype == "c16" else dtype == "f8" and points.ndim == 2 and points.shape[1] == 2
            counts = offsets.dtype in ("i8", "i4") and offsets.ndim == 1 and bool(np.all(np.diff(offsets) >= 0))

            def clip(points):
                return clearcut.clip_polylines(points, offsets, WINDOW, closed=closed)

            if counts:
                results += self.check(clip, points, rows)
            elif rows:
                self.assertRaisesRegex((TypeError, ValueError), "offsets must", clip, points)
        self.assertGreater(results, 300)

    def test_more_rows_than_can_be_numbered(self):
        rows = np.broadcast_to(np.zeros(4), (1 << 32, 4))
        for call in (lambda: clearcut.clip(rows, WINDOW), lambda: clearcut.split(rows, WINDOW)):
            self.assertRaisesRegex(ValueError, r"4294967296", call)

    def test_windows(self):
        """Whatever holds the four numbers: a result, or what a window is."""
        chance, a = random.Random(20), np.zeros((3, 4))
        results = 0
        for _ in range(400):
            window = laid_out(chance, numbers(chance, chance.choice([(4,), (4,), (3,), (2, 2), (4, 1), ()]),
                                              chance.choice(["f8", "i4", ">f4", "c16", "O", "U3"])))
            try:
                clearcut.clip(a, window)
                results += 1
            except (TypeError, ValueError) as error:
                self.assertIn("window must be", str(error))
        self.assertGreater(results, 30)


@unittest.skipIf(da is None, "python3-dask is not installed")
class InDask(Property):
    def lines(self, chance, array):
        """A Dask array of these values, in random chunks, of which some are empty, or none at all."""
        if array.ndim == 0 or array.size == 0:
            return da.from_array(array, chunks=array.shape)
        chunks = []
        for size in array.shape:
            cuts = sorted(chance.randrange(size + 1) for _ in range(chance.randrange(4)))
            chunks.append(tuple(np.diff([0, *cuts, size]).tolist()))
        blocks = da.from_array(array, chunks=tuple(tuple(c for c in each if c) for each in chunks))
        return blocks.rechunk(tuple(chunks)) if chance.random() < 0.5 else blocks

    def test_segments(self):
        chance, results = random.Random(21), 0
        grid = clearcut.dask.grid(WINDOW, 2, 2)

        def clip(array):
            lines = self.lines(chance, array)
            found = [clearcut.dask.clip(lines, WINDOW), *clearcut.dask.clip_at_windows(lines, grid)]
            return [(s, i.astype(np.uint32), c) for s, i, c in dask.compute(*map(tuple, found), scheduler="sync")]

        for _ in range(80):
            dtype = chance.choice(GOOD * 2 + [chance.choice(BAD)])
            array = laid_out(chance, numbers(chance, shape_of_any_kind(chance, 4), dtype))
            results += self.check(clip, array, dtype in GOOD and array.ndim == 2 and array.shape[1] == 4,
                                  lambda a: [tuple(clearcut.clip(a, window)) for window in [WINDOW, *grid]])
        self.assertGreater(results, 30)

    def test_no_chunks(self):
        for lines in (da.zeros((0, 4)), da.concatenate([da.zeros((0, 4))] * 3), da.zeros((0, 4), chunks=(1, 2))):
            pieces = dask.compute(*clearcut.dask.clip(lines, WINDOW), scheduler="sync")
            self.assertEqual([len(part) for part in pieces], [0, 0, 0])
        unknown = da.zeros((5, 4))
        self.assertRaisesRegex(ValueError, "lengths of the chunks must be known", clearcut.dask.clip,
                               unknown[unknown[:, 0] > 0], WINDOW)


if __name__ == "__main__":
    unittest.main()
