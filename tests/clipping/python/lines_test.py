# SPDX-License-Identifier: GPL-3.0-or-later
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
        ring = shapes.LinearRing([(-5, 2), (5, 2), (5, 5), (-5, 5)])
        self.assertEqual(clearcut.clip_geometry(ring, WINDOW).wkt, "LINESTRING (0 2, 5 2, 5 5, 0 5)")


if __name__ == "__main__":
    unittest.main()
