# SPDX-License-Identifier: GPL-3.0-or-later
import pickle
import threading
import unittest

import numpy as np

import clearcut

try:
    import shapely
    from shapely import geometry as shapes
    from shapely.ops import clip_by_rect
except ImportError:
    shapely = None

WINDOW = (0, 0, 10, 10)


class Lines(unittest.TestCase):
    def test_runs_are_unbroken(self):
        line = np.array([[-5.0, 5], [5, 5], [5, 8], [20, 8], [20, 2], [5, 2]])
        parts, source = clearcut.clip_lines([line[:1] + 50, line], WINDOW, return_source=True)
        self.assertEqual(source, [1, 1])
        np.testing.assert_array_equal(parts[0], [[0, 5], [5, 5], [5, 8], [10, 8]])
        np.testing.assert_array_equal(parts[1], [[10, 2], [5, 2]])

    def test_any_layout(self):
        line = np.random.default_rng(2).uniform(-20, 20, (500, 2))
        expected = clearcut.clip_lines([line], WINDOW)
        wide = np.zeros((1000, 4))
        wide[::2, 1::2] = line
        for view in (np.asfortranarray(line), wide[::2, 1::2], line[::-1][::-1]):
            found = clearcut.clip_lines([view], WINDOW)
            self.assertEqual(len(found), len(expected))
            for a, b in zip(found, expected):
                np.testing.assert_array_equal(a, b)

    def test_complex_lines_and_generators(self):
        found = clearcut.clip_lines((line for line in [np.array([-5 + 1j, 5 + 1j])]), WINDOW)
        np.testing.assert_array_equal(found[0], [1j, 5 + 1j])

    def test_nothing(self):
        self.assertEqual(clearcut.clip_lines([], WINDOW), [])
        self.assertEqual(clearcut.clip_lines([np.zeros((0, 2)), np.full((3, 2), np.nan)], WINDOW), [])

    def test_closed(self):
        square = np.array([[-5.0, 2], [5, 2], [5, 5], [-5, 5]])
        found = clearcut.clip_lines([square], WINDOW, closed=True)
        self.assertEqual(len(found), 1)
        np.testing.assert_array_equal(found[0], [[0, 2], [5, 2], [5, 5], [0, 5]])


def polylines(chance, lengths):
    """Points of polylines with these lengths, and their offsets. Some stay near each other, some points are equal, on an
    edge, or not finite."""
    points = chance.uniform(-5, 15, (sum(lengths), 2))
    near = chance.random(len(points)) < 0.5
    points[1:][near[1:]] = points[:-1][near[1:]] + chance.uniform(-1, 1, (near[1:].sum(), 2))
    points = np.where(chance.random(points.shape) < 0.1, chance.choice([0, 10, -0.0, 10.5]), points)
    points[chance.random(len(points)) < 0.03] = np.nan
    same = np.flatnonzero(chance.random(len(points)) < 0.1)[1:]
    points[same] = points[same - 1]
    return points, np.cumsum([0, *lengths])


class Polylines(unittest.TestCase):
    def same(self, found, lines, closed):
        parts, source = clearcut.clip_lines(lines, WINDOW, closed=closed, return_source=True)
        self.assertEqual(found.source.tolist(), source)
        self.assertEqual(np.diff(found.offsets).tolist(), list(map(len, parts)))
        self.assertEqual(found.coordinates.tobytes(), b"".join(part.tobytes() for part in parts))
        return len(parts)

    def test_are_those_of_lists(self):
        chance, parts = np.random.default_rng(7), 0
        for _ in range(300):
            lengths = chance.choice([0, 1, 2, 3, 10, 400], chance.integers(0, 30), p=[.1, .2, .2, .2, .2, .1])
            points, offsets = polylines(chance, lengths)
            for closed in (False, True):
                found = clearcut.clip_polylines(points, offsets, WINDOW, closed=closed)
                parts += self.same(found, np.split(points, offsets[1:-1]) if len(lengths) else [], closed)
        self.assertGreater(parts, 10_000)

    def test_any_layout(self):
        points, offsets = polylines(np.random.default_rng(8), [10] * 1000)
        expected = clearcut.clip_polylines(points, offsets, WINDOW)
        wide = np.zeros((20_000, 5))
        wide[::2, 1::2][:, :2] = points
        complex_points = points.view(complex).reshape(-1)
        for view in (np.asfortranarray(points), wide[::2, 1:4:2], points[::-1].copy()[::-1], complex_points,
                     np.repeat(complex_points, 2)[::2]):
            for whole in (offsets, offsets.astype("i4"), np.repeat(offsets, 3)[::3], offsets[::-1].copy()[::-1]):
                found = clearcut.clip_polylines(view, whole, WINDOW)
                self.assertEqual((found.coordinates.dtype, found.offsets.dtype), (view.dtype, whole.dtype))
                self.assertEqual(found.coordinates.shape[1:], view.shape[1:])
                for one, other in zip(found, expected):
                    np.testing.assert_array_equal(one.view(float).reshape(-1) if one.dtype == complex else one.reshape(-1),
                                                  other.reshape(-1))

    def test_a_part_of_the_points(self):
        """Offsets that begin later, end earlier, and leave polylines empty."""
        points, _ = polylines(np.random.default_rng(9), [500])
        offsets = np.array([100, 100, 250, 250, 400, 400])
        found = clearcut.clip_polylines(points, offsets, WINDOW)
        self.assertEqual(set(found.source), {1, 3})
        self.same(found, np.split(points, offsets)[1:-1], False)

    def test_nothing(self):
        for points, offsets in ((np.zeros((0, 2)), [0]), (np.zeros((0, 2)), [0, 0]), (np.full((4, 2), 50.0), [0, 2, 4])):
            found = clearcut.clip_polylines(points, np.array(offsets), WINDOW)
            self.assertEqual((found.coordinates.shape, found.offsets.tolist(), len(found.source)), ((0, 2), [0], 0))

    def test_results_outlive_the_call(self):
        points, offsets = polylines(np.random.default_rng(10), [10] * 50_000)
        found = [clearcut.clip_polylines(points, offsets, WINDOW) for _ in range(3)]
        kept = found[0].offsets
        before = kept.copy()
        del found
        clearcut.clip_polylines(points + 1, offsets, WINDOW)
        np.testing.assert_array_equal(kept, before)


@unittest.skipIf(shapely is None, "python3-shapely is not installed")
class Geometry(unittest.TestCase):
    def test_as_shapely(self):
        chance = np.random.default_rng(4)
        for _ in range(300):
            line = shapes.LineString(chance.uniform(-10, 20, (chance.integers(2, 9), 2)))
            found, theirs = clearcut.clip_geometry(line, WINDOW), clip_by_rect(line, *WINDOW)
            self.assertAlmostEqual(found.length, theirs.length, 9)
            self.assertEqual(self.parts(found), self.parts(theirs))

    @staticmethod
    def parts(line):
        return 0 if line.is_empty else len(getattr(line, "geoms", [line]))

    def test_kinds(self):
        line = shapes.LineString([(-5, 5), (15, 5)])
        self.assertEqual(clearcut.clip_geometry(line, WINDOW).wkt, "LINESTRING (0 5, 10 5)")
        two = shapes.MultiLineString([line, shapes.LineString([(1, 1), (2, 2)])])
        self.assertEqual(clearcut.clip_geometry(two, WINDOW).geom_type, "MultiLineString")
        self.assertTrue(clearcut.clip_geometry(shapes.LineString(), WINDOW).is_empty)
        self.assertTrue(clearcut.clip_geometry(shapes.LineString([(50, 50), (60, 60)]), WINDOW).is_empty)
        touch = shapes.LineString([(-5, 5), (5, 15)])
        self.assertEqual(clearcut.clip_geometry(touch, WINDOW).wkt, "POINT (0 10)")
        mixed = shapes.LineString([(-5, 5), (5, 15), (5, 5)])
        self.assertEqual(clearcut.clip_geometry(mixed, WINDOW).wkt, "GEOMETRYCOLLECTION (POINT (0 10), LINESTRING (5 10, 5 5))")
        high = shapes.LineString([(-5, 5, 1), (15, 5, 2)])
        self.assertEqual(clearcut.clip_geometry(high, WINDOW).wkt, "LINESTRING (0 5, 10 5)")
        ring = shapes.LinearRing([(-5, 2), (5, 2), (5, 5), (-5, 5)])
        self.assertEqual(clearcut.clip_geometry(ring, WINDOW).wkt, "LINESTRING (0 2, 5 2, 5 5, 0 5)")
        inside = shapes.LinearRing([(1, 2), (5, 2), (5, 5)])
        self.assertEqual(clearcut.clip_geometry(inside, WINDOW).wkt, "LINESTRING (1 2, 5 2, 5 5, 1 2)")

    def test_results_are_geometries(self):
        """Also on other threads, and after the one that they come from is gone."""
        found = []

        def clip():
            for i in range(200):
                line = shapes.LineString([(-5, 1 + i % 9), (15, 1 + i % 9), (15, 5), (-5, 5.5)])
                found.append((i, clearcut.clip_geometry(line, WINDOW)))

        threads = [threading.Thread(target=clip) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(len(found), 800)
        for i, part in found:
            self.assertEqual(part.geoms[0].coords[:], [(0, 1 + i % 9), (10, 1 + i % 9)])
            self.assertTrue(part.is_valid and not part.is_empty and not part.has_z)
            self.assertTrue(pickle.loads(pickle.dumps(part)).equals(part))


if __name__ == "__main__":
    unittest.main()
