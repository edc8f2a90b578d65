# SPDX-License-Identifier: GPL-3.0-or-later
"""The module over arrays of every kind, against the same call on a plain copy."""
import random
import threading
import unittest

import numpy as np

import clearcut

WINDOW = (-100, -75, 100, 75)


def plain(n, dtype=np.float64, seed=1):
    return np.random.default_rng(seed).uniform(-200, 200, (n, 4)).astype(dtype)


def same(found, expected):
    for a, b in zip(found, expected):
        np.testing.assert_array_equal(a, b)


class Reading(unittest.TestCase):
    def test_any_strides_and_orders(self):
        """Random layouts of the same numbers: the result has the same bits."""
        chance = random.Random(5)
        for _ in range(60):
            n = chance.choice([0, 1, 3, 500, 4096, 9001])
            dtype = chance.choice([np.float64, np.float32])
            numbers = plain(n, dtype, chance.randrange(1000))
            if n and chance.random() < 0.5:
                numbers[chance.randrange(n), chance.randrange(4)] = chance.choice([np.nan, np.inf, -np.inf])
            expected = clearcut.clip(numbers.copy(), WINDOW, threads=1)
            for view in self.layouts(numbers):
                np.testing.assert_array_equal(view, numbers)
                same(clearcut.clip(view, WINDOW), expected)

    @staticmethod
    def layouts(numbers):
        n, dtype = len(numbers), numbers.dtype
        yield np.asfortranarray(numbers)
        wide = np.zeros((2 * n, 9), dtype)
        wide[::2, 1:9:2] = numbers
        yield wide[::2, 1:9:2]
        backwards = numbers[::-1, ::-1].copy()
        yield backwards[::-1, ::-1]
        record = np.zeros(n, [("tag", "u1"), ("line", dtype, 4)])  # not aligned
        record["line"] = numbers
        yield record["line"]
        readonly = numbers.copy()
        readonly.flags.writeable = False
        yield readonly
        if n:
            yield np.lib.stride_tricks.as_strided(numbers, numbers.shape, numbers.strides)

    def test_repeated_rows(self):
        row = np.array([[-200.0, 0, 200, 10]])
        same(clearcut.clip(np.broadcast_to(row, (5000, 4)), WINDOW), clearcut.clip(np.repeat(row, 5000, 0), WINDOW))

    def test_every_kind_reads_any_layout(self):
        a, f = plain(5000), np.asfortranarray(plain(5000))
        for options in [dict(kind="line", algorithm="lb"), dict(kind="ray", algorithm="md"),
                        dict(form="published", algorithm="cs"), dict(algorithm="nln")]:
            same(clearcut.clip(f, WINDOW, **options), clearcut.clip(a, WINDOW, **options))
        polygon = [(-100, -75), (100, -75), (0, 90)]
        same(clearcut.clip(f, polygon=polygon), clearcut.clip(a, polygon=polygon))
        for one, other in zip(clearcut.split(f, WINDOW), clearcut.split(a, WINDOW)):
            same(one, other)

    def test_input_is_never_written(self):
        a = plain(5000)
        before = a.copy()
        clearcut.clip(a, WINDOW)
        clearcut.split(a, WINDOW)
        np.testing.assert_array_equal(a, before)


class Results(unittest.TestCase):
    def test_views_outlive_each_other(self):
        for n in (1000, 300_000):  # the memory of large results is used again
            segments, source, cut = clearcut.clip(plain(n), WINDOW)
            copy = source.copy()
            del segments, cut
            for _ in range(3):
                clearcut.clip(plain(n, seed=9), WINDOW)
                np.testing.assert_array_equal(source, copy)

    def test_types_and_shapes(self):
        for dtype in (np.float64, np.float32):
            for n in (0, 1, 10):
                found = clearcut.clip(np.zeros((n, 4), dtype), (0, 0, 1, 1))
                self.assertEqual(found.segments.dtype, dtype)
                self.assertEqual(found.segments.shape, (n, 4))
                self.assertEqual(found.source.dtype, np.uint32)
                self.assertEqual(found.cut.shape, (n,))

    def test_threads_change_nothing(self):
        a = plain(700_000)
        expected = clearcut.clip(a, WINDOW, threads=1)
        for threads in (None, 2, 3):
            same(clearcut.clip(a, WINDOW, threads=threads), expected)
        same(clearcut.clip(a.astype(np.float32), WINDOW), clearcut.clip(a.astype(np.float32), WINDOW, threads=1))

    def test_many_python_threads(self):
        a = plain(150_000)
        expected, found = clearcut.clip(a, WINDOW), []
        threads = [threading.Thread(target=lambda: found.append(clearcut.clip(a, WINDOW))) for _ in range(8)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(len(found), 8)
        for each in found:
            same(each, expected)

    def test_inside_and_outside_are_the_whole(self):
        a = plain(3000)
        inside, outside = clearcut.split(a, WINDOW)
        same(inside, clearcut.clip(a, WINDOW))
        length = np.zeros(len(a))
        for part in (inside, outside):
            s = part.segments
            np.add.at(length, part.source, np.hypot(s[:, 2] - s[:, 0], s[:, 3] - s[:, 1]))
        np.testing.assert_allclose(length, np.hypot(a[:, 2] - a[:, 0], a[:, 3] - a[:, 1]), rtol=1e-12)

    def test_chunks_are_clip(self):
        for dtype in (np.float64, np.float32):
            a = plain(3000, dtype)
            chunks = clearcut.Chunks(a)
            for x in range(-150, 150, 70):
                same(chunks.clip((x, -40, x + 60, 60)), clearcut.clip(a, (x, -40, x + 60, 60)))
            a[100:200] = 1
            chunks.update(100, 200)
            same(chunks.clip(WINDOW), clearcut.clip(a, WINDOW))
            del a
            self.assertGreater(len(chunks.clip(WINDOW).source), 0)

    def test_polygons_in_either_direction(self):
        corners = [(0, 0), (80, 0), (90, 60), (20, 70)]
        a = plain(3000)
        for algorithm in ("exact", "cyrus-beck", "skala"):
            forwards = clearcut.clip(a, polygon=np.array(corners), algorithm=algorithm)
            backwards = clearcut.clip(a, polygon=corners[::-1], algorithm=algorithm)
            same(forwards[:2], backwards[:2])
            for shift in (0, 16):  # edge i runs between the corners i and i + 1 as given
                edge, mirrored = (found.cut >> shift & 0xffff for found in (forwards, backwards))
                np.testing.assert_array_equal(mirrored, np.array([0, 3, 2, 1, 4])[edge])
                self.assertEqual(set(edge), {0, 1, 2, 3, 4})
        square = clearcut.clip(a, polygon=[(-100, -75), (100, -75), (100, 75), (-100, 75)])
        window = clearcut.clip(a, WINDOW)
        np.testing.assert_array_equal(square.source, window.source)


if __name__ == "__main__":
    unittest.main()
