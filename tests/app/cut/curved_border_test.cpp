// SPDX-License-Identifier: GPL-3.0-or-later
// Curves that run along the curves of a clip window: they are kept or removed as a whole.
#include "app/cut/curved_border.h"
#include "app/cut/cut.h"
#include "app/cut/occlude.h"
#include "app/document/document_builder.h"
#include "app/document/recipe_outline.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <numbers>
#include <random>

#include "tests/app/document/sheet.h"
#include "tests/deep.h"
#include "tests/test_class.h"

namespace cut_curved_border_test {

using namespace app;

namespace {

const Point centre(37, -12);

double between(std::mt19937_64& random, double low, double high)
{
    return low + (high - low) * double(random() >> 11) * 0x1p-53;
}

/// A closed path of so many arcs, which begins at an angle.
Subpath ellipse(const Point& axis1, const Point& axis2, int arcs, double angle)
{
    const EllipseArc all{centre, axis1, axis2, angle, 2 * std::numbers::pi};
    Subpath path{all.at(angle), {}, true};
    for (int i = 0; i < arcs; ++i) {
        const EllipseArc arc{centre, axis1, axis2, angle + 2 * std::numbers::pi * i / arcs,
                             2 * std::numbers::pi / arcs};
        appendCurves(path.segments, arc, i == 0 ? path.start : path.segments.back().to,
                     i + 1 == arcs ? path.start : arc.at(arc.angle + arc.sweep));
    }
    return path;
}
Subpath circle(double radius, int arcs, double angle)
{
    return ellipse({radius, 0}, {0, radius}, arcs, angle);
}

/// A part of an ellipse as a polyline with its corners on it; all of it is closed.
Subpath polyline(const EllipseArc& border, double angle, double sweep, int lines)
{
    const bool closed = sweep == 2 * std::numbers::pi;
    Subpath path{border.at(angle), {}, closed};
    for (int i = 1; i < lines + !closed; ++i)
        path.segments.push_back({border.at(angle + sweep * i / lines)});
    return path;
}

Subpath movedBy(Subpath path, const Point& by)
{
    forEachPoint(path, [&](Point& p) { p += by; });
    return path;
}

Subpath halved(const Subpath& path)
{
    Subpath halves{path.start, {}, path.closed};
    Point from = path.start;
    for (const PathSegment& s : path.segments) {
        const Bezier curve{from, s.control1, s.control2, s.to};
        for (const Bezier& half : {curve.part(0, 0.3), curve.part(0.3, 1)})
            halves.segments.push_back({half.to, half.control1, half.control2, true});
        halves.segments.back().to = from = s.to;
    }
    return halves;
}

ClipWindow windowOf(const Subpath& path, Recipe recipe = {})
{
    return {QString(), PathShape{Path(std::span(&path, 1)), FillRule::NonZero, recipe}};
}

ClipWindow roundWindow(const EllipseRecipe& ellipse)
{
    return windowOf(*outlineOf(ellipse), ellipse);
}

Sheet cutAt(const std::vector<ClipWindow>& windows, const std::vector<Subpath>& paths, Keep keep,
            bool filled, double tolerance = 0)
{
    Sheet sheet;
    Style style{.stroke = Colour{}};
    if (filled)
        style.fill = Colour{};
    for (const Subpath& path : paths)
        sheet.shapes.push_back({{path}, style, QString(), 0, false});
    Document document = documentOf(sheet);
    CutOptions options{.clipAll = clipping::exactAlgorithm().corrected.clipAll};
    options.tolerance = tolerance;
    app::cutAt(options, {windows, keep}, document.page());
    document.apply(cut(document, options).edit);
    return sheetOf(document);
}

Sheet cutAt(const ClipWindow& window, const std::vector<Subpath>& paths, Keep keep, bool filled)
{
    return cutAt(std::vector{window}, paths, keep, filled);
}

std::vector<Subpath> pathsOf(const Sheet& sheet)
{
    std::vector<Subpath> all;
    for (const Shape& shape : sheet.shapes)
        all.insert(all.end(), shape.paths.begin(), shape.paths.end());
    return all;
}

/// What areas without a stroke leave of paths below them.
std::vector<Subpath> covered(const std::vector<Subpath>& paths, const std::vector<Subpath>& areas)
{
    Sheet sheet;
    for (const Subpath& path : paths)
        sheet.shapes.push_back({{path}, {.stroke = Colour{}}, QString(), 0, false});
    for (const Subpath& area : areas)
        sheet.shapes.push_back({{area}, {.fill = Colour{}}, QString(), 0, false});
    Document document = documentOf(sheet);
    document.apply(occlude(document, {}).edit);
    return pathsOf(sheetOf(document));
}

/// The ends that are not those of the whole path.
std::vector<Point> cutEndsOf(const std::vector<Subpath>& parts, const Subpath& whole)
{
    std::vector<Point> ends;
    for (const Subpath& part : parts)
        for (const Point& end : {part.start, part.segments.back().to})
            if (end != whole.start && end != whole.segments.back().to)
                ends.push_back(end);
    return ends;
}

/// The least distance of a place, by all the valleys between evenly spread ones.
template <class At>
double leastDistance(const Point& p, double begin, double end, const At& at)
{
    constexpr int parts = 2048;
    const double step = (end - begin) / parts;
    const auto away = [&](double t) { return glm::distance(at(t), p); };
    std::vector<double> distances;
    for (int i = 0; i <= parts; ++i)
        distances.push_back(away(begin + i * step));
    double least = std::min(distances.front(), distances.back());
    for (std::size_t i = 0; i <= parts; ++i) {
        const std::size_t before = i > 0 ? i - 1 : 0, after = i < parts ? i + 1 : i;
        if (distances[i] > distances[before] || distances[i] > distances[after])
            continue;
        double low = begin + double(before) * step, high = begin + double(after) * step;
        for (int k = 0; k < 100; ++k) {
            const double a = low + (high - low) / 3, b = high - (high - low) / 3;
            const bool isLow = away(a) < away(b);
            (isLow ? high : low) = isLow ? b : a;
        }
        least = std::min(least, away((low + high) / 2));
    }
    return least;
}

double distanceTo(const Bezier& curve, const Point& p)
{
    return leastDistance(p, 0, 1, [&](double t) { return curve.at(t); });
}

double distanceTo(const EllipseArc& ellipse, const Point& p)
{
    return leastDistance(p, 0, 2 * std::numbers::pi, [&](double t) { return ellipse.at(t); });
}

/// Closed paths are parts of ellipses here, and count as these.
double distanceTo(const Subpath& path, const Point& p)
{
    double least = 1e9;
    Point from = path.start;
    for (const PathSegment& s : path.segments) {
        const Point along = s.to - from;
        const Bezier curve = s.curved ? Bezier{from, s.control1, s.control2, s.to}
                                      : Bezier{from, from + along / 3.0, s.to - along / 3.0, s.to};
        const auto ellipse = path.closed ? ellipseOf(curve) : std::nullopt;
        const double away = distanceTo(curve, p);
        least = std::min(least, ellipse && away < 0.05 ? distanceTo(*ellipse, p) : away);
        from = s.to;
    }
    return least;
}

double distanceTo(const ClipWindow& window, const Point& p)
{
    return distanceTo(std::get<PathShape>(window.shape).path.subpaths().front(), p);
}

/// Of closed paths, as polygons of very short edges.
double areaOf(const std::vector<Subpath>& paths)
{
    double area = 0;
    for (const Subpath& path : paths) {
        Point from = path.start;
        const auto go = [&](const Point& to) {
            area +=
                ((from.x - centre.x) * (to.y - centre.y) - (to.x - centre.x) * (from.y - centre.y))
                / 2;
            from = to;
        };
        for (const PathSegment& s : path.segments) {
            const Bezier curve{from, s.control1, s.control2, s.to};
            for (int i = 1; s.curved && i < 20'000; ++i)
                go(curve.at(i / 2e4));
            go(s.to);
        }
        go(path.start);
    }
    return std::abs(area);
}

bool isCornerOf(const std::vector<Subpath>& paths, const Point& p)
{
    return std::ranges::any_of(paths, [&](const Subpath& path) {
        return path.start == p
               || std::ranges::find(path.segments, p, &PathSegment::to) != path.segments.end();
    });
}

double lengthOf(const std::vector<Subpath>& paths)
{
    std::vector<Chord> chords;
    for (const Subpath& path : paths)
        flatten(path, 1e-7, chords);
    double length = 0;
    for (const Chord& chord : chords)
        length += glm::distance(chord.segment.a, chord.segment.b);
    return length;
}

} // namespace

class CurvedBorderTest : public QObject {
    Q_OBJECT

private slots:
    void anEqualCurveIsKeptOrRemovedAsAWhole_data()
    {
        QTest::addColumn<double>("radius");
        for (const double radius : {0.1, 1.0, 40.0, 1000.0})
            QTest::addRow("%g", radius) << radius;
    }
    void anEqualCurveIsKeptOrRemovedAsAWhole()
    {
        QFETCH(double, radius);
        const Subpath quarters = circle(radius, 4, 0),
                      tilted = ellipse({radius, radius / 5}, {-radius / 3, radius / 2}, 4, 0.4);
        const std::vector<std::pair<ClipWindow, Subpath>> windows{
            {windowOf(quarters, EllipseRecipe{centre, {radius, radius}}), quarters},
            {windowOf(quarters), quarters},
            {windowOf(circle(radius, 6, 0.2)), quarters},
            {windowOf(tilted), tilted}};
        for (const auto& [window, own] : windows) {
            const bool isCircle = own == quarters;
            std::vector<Subpath> others{own, reversedPath(own)};
            others.push_back(halved(own));
            if (isCircle) {
                others.push_back(circle(radius, 4, std::numbers::pi / 4));
                others.push_back(circle(radius, 5, 1));
            } else {
                others.push_back(ellipse({radius, radius / 5}, {-radius / 3, radius / 2}, 6, 2));
            }
            for (std::size_t i = 0; i < others.size(); ++i)
                for (const bool filled : {false, true}) {
                    const QByteArray which = QByteArray::number(qulonglong(i));
                    const Sheet inside = cutAt(window, {others[i]}, Keep::Inside, filled);
                    QVERIFY2(inside.shapes.size() == 1, which);
                    QVERIFY2(inside.shapes[0].paths == std::vector{others[i]}, which);
                    QVERIFY2(cutAt(window, {others[i]}, Keep::Outside, filled).shapes.empty(),
                             which);
                }
        }
    }

    /// Covered by an area with the same border, however that is drawn.
    void anEqualAreaCoversTheWholeCurve()
    {
        for (const double radius : {0.1, 40.0, 1000.0}) {
            const Subpath own = circle(radius, 4, 0);
            const std::vector all{
                own,         circle(radius, 4, 0.8), circle(radius, 5, 1), reversedPath(own),
                halved(own), circle(radius, 6, 0.2)};
            for (const Subpath& below : all)
                for (const Subpath& above : all) {
                    QVERIFY(covered({below}, {above}).empty());
                    QVERIFY(covered({below}, {above, circle(radius, 7, 3)}).empty());
                }
        }
    }

    /// What lies across an area is cut there, and its parts beside it are whole.
    void aCurveAlongAnAreaIsCutOnce()
    {
        const Subpath border = circle(40, 4, 0);
        const EllipseArc arc{centre, {40, 0}, {0, 40}, 0.5, 1};
        Subpath path{centre + 1.25 * (arc.at(0.5) - centre), {{arc.at(0.5)}}, false};
        appendCurves(path.segments, arc, arc.at(0.5), arc.at(1.5));
        path.segments.push_back({centre + 1.25 * (arc.at(1.5) - centre)});
        const auto left = covered({path}, {border, border, circle(40, 6, 1)});
        QCOMPARE(left.size(), std::size_t(2));
        for (const Subpath& part : left)
            QVERIFY(part.segments.size() == 1 && !part.segments[0].curved);
    }

    /// Windows that are hardly larger than the tolerance of their polygons.
    void tinyWindows()
    {
        std::mt19937_64 random(11);
        const auto near = [&](double far) {
            const auto number = [&] { return far * (double(random() >> 11) * 0x1p-52 - 1); };
            return centre + Point(number(), number());
        };
        for (int i = 0; i < 600; ++i) {
            const double radius = 0.002 * (1 + i % 30);
            const Point a = near(radius), b = near(radius), c = near(4 * radius);
            const Subpath path{
                near(3), {{near(3), near(3), a, true}, {near(3), b, c, true}}, false};
            const ClipWindow window =
                windowOf(circle(radius, 4, 0.1),
                         i % 2 ? Recipe(EllipseRecipe{centre, {radius, radius}}) : Recipe());
            double length = 0;
            for (const Keep keep : {Keep::Inside, Keep::Outside})
                for (const Subpath& part : pathsOf(cutAt(window, {path}, keep, i % 4 == 0)))
                    for (const PathSegment& s : part.segments)
                        QVERIFY(std::isfinite(s.to.x + s.to.y));
            for (const Keep keep : {Keep::Inside, Keep::Outside})
                length += lengthOf(pathsOf(cutAt(window, {path}, keep, false)));
            QVERIFY2(std::abs(length - lengthOf({path})) < 0.05,
                     QByteArray::number(length - lengthOf({path})));
        }
    }

    /// Where a window cuts a filled area, its outline has the window's own curves; it ends where
    /// the lines do.
    void anAreaGetsTheWindowsCurves()
    {
        const Subpath strip{
            centre + Point(-60, -5),
            {{centre + Point(60, -9)}, {centre + Point(60, 9)}, {centre + Point(-60, 7)}},
            true};
        Subpath disc = circle(25, 32, 0.3); // hardly off the true circle
        for (PathSegment& s : disc.segments)
            s.to.x += 30, s.control1.x += 30, s.control2.x += 30;
        disc.start.x += 30;
        Subpath all = circle(90, 32, 0.1);
        const std::vector<ClipWindow> windows{roundWindow({centre, {40, 30}}),
                                              windowOf(circle(40, 4, 0)),
                                              windowOf(ellipse({50, 10}, {-12, 20}, 6, 0.4))};
        for (const ClipWindow& window : windows)
            for (const Subpath& area : {strip, disc, all}) {
                double sum = 0;
                for (const Keep keep : {Keep::Inside, Keep::Outside}) {
                    const Sheet left = cutAt(window, {area}, keep, true);
                    QCOMPARE(left.shapes.size(),
                             std::size_t(area == all ? 1 + (keep == Keep::Outside) : 2));
                    std::size_t curves = 0, lines = 0;
                    for (const Subpath& ring : left.shapes[0].paths)
                        for (const PathSegment& s : ring.segments)
                            ++(s.curved ? curves : lines);
                    QVERIFY(curves > 0 && curves <= 12 + area.segments.size() && lines <= 7);
                    sum += areaOf(left.shapes[0].paths);
                    for (std::size_t i = 1; i < left.shapes.size() && area != all; ++i)
                        for (const Point& end : cutEndsOf(left.shapes[i].paths, area))
                            QVERIFY(isCornerOf(left.shapes[0].paths, end));
                }
                QVERIFY(std::abs(sum / areaOf({area}) - 1) < 1e-9);
            }
    }

    void aLineBelowAnAreaEndsOnItsCurve()
    {
        const Subpath border = ellipse({50, 10}, {-12, 20}, 6, 0.4);
        const Subpath line{centre + Point(-70, 5), {{centre + Point(70, -8)}}, false};
        const auto left = covered({line}, {border});
        const auto ends = cutEndsOf(left, line);
        QCOMPARE(ends.size(), std::size_t(2));
        for (const Point& end : ends)
            QVERIFY(distanceTo(border, end) < 1e-9 && distanceTo(line, end) < 1e-9);
    }

    /// An arc of the border, which goes on away from it, outwards or inwards.
    void aCurveThatLeavesTheBorder()
    {
        const Subpath border = circle(40, 4, 0);
        for (const double angle : {0.5, 2.5, 4.0})
            for (const double factor : {1.25, 0.5}) {
                const EllipseArc arc{centre, {40, 0}, {0, 40}, angle, 1};
                Subpath path{centre + factor * (arc.at(angle) - centre), {{arc.at(angle)}}, false};
                appendCurves(path.segments, arc, arc.at(angle), arc.at(angle + 1));
                path.segments.push_back({centre + factor * (arc.at(angle + 1) - centre)});
                const ClipWindow window = windowOf(border, EllipseRecipe{centre, {40, 40}});
                const Sheet inside = cutAt(window, {path}, Keep::Inside, false);
                const Sheet outside = cutAt(window, {path}, Keep::Outside, false);
                QVERIFY(inside.shapes.size() == 1);
                if (factor < 1) {
                    QCOMPARE(inside.shapes[0].paths, std::vector{path});
                    QVERIFY(outside.shapes.empty());
                    continue;
                }
                QCOMPARE(inside.shapes[0].paths.size(), std::size_t(1));
                QVERIFY(inside.shapes[0].paths[0].segments
                        == std::vector(path.segments.begin() + 1, path.segments.end() - 1));
                QCOMPARE(outside.shapes[0].paths.size(), std::size_t(2));
                for (const Subpath& part : outside.shapes[0].paths)
                    QVERIFY(part.segments.size() == 1 && !part.segments[0].curved);
            }
    }

    /// Fine ones are within a micrometre of the border, coarse ones have their corners on it.
    void aPolylineAlongTheBorderIsWhole_data()
    {
        QTest::addColumn<double>("radius");
        QTest::addColumn<int>("corners");
        for (const double radius : {0.1, 1.0, 10.0, 50.0, 1000.0})
            for (const int corners : {7, 64, 512, 2048})
                QTest::addRow("%g, %d", radius, corners) << radius << corners;
    }
    void aPolylineAlongTheBorderIsWhole()
    {
        QFETCH(double, radius);
        QFETCH(int, corners);
        const EllipseArc round{centre, {radius, 0}, {0, radius}},
            tilted{centre, {radius, radius / 5}, {-radius / 3, radius / 2}};
        const Subpath quarters = circle(radius, 4, 0);
        const std::vector<std::pair<ClipWindow, EllipseArc>> windows{
            {windowOf(quarters, EllipseRecipe{centre, {radius, radius}}), round},
            {windowOf(quarters), round},
            {windowOf(circle(radius, 6, 0.2)), round},
            {windowOf(ellipse(tilted.axis1, tilted.axis2, 4, 0.4)), tilted}};
        for (const auto& [window, border] : windows) {
            const Subpath own = polyline(border, 0.1, 2 * std::numbers::pi, corners);
            std::vector<Subpath> separate;
            Point from = own.start;
            for (const PathSegment& s : own.segments)
                separate.push_back({std::exchange(from, s.to), {{s.to}}, false});
            for (const Subpath& path : {own, reversedPath(own)})
                for (const bool filled : {false, true}) {
                    const Sheet inside = cutAt(window, {path}, Keep::Inside, filled);
                    QVERIFY(inside.shapes.size() == 1 && pathsOf(inside) == std::vector{path});
                    QVERIFY(cutAt(window, {path}, Keep::Outside, filled).shapes.empty());
                }
            QVERIFY(pathsOf(cutAt(window, separate, Keep::Inside, false)) == separate);
            QVERIFY(cutAt(window, separate, Keep::Outside, false).shapes.empty());
        }
    }

    /// It keeps its own corners, and gets no others.
    void aPolylineThatLeavesTheBorder()
    {
        const EllipseArc border{centre, {40, 0}, {0, 40}};
        for (const ClipWindow& window :
             {windowOf(circle(40, 4, 0), EllipseRecipe{centre, {40, 40}}),
              windowOf(circle(40, 5, 0.3))})
            for (const bool filled : {false, true}) {
                Subpath path = polyline(border, 0.5, 1, 300);
                path.closed = false;
                const Subpath along = path;
                const Point out = centre + 1.25 * (path.start - centre);
                path.segments.push_back({centre + 1.25 * (path.segments.back().to - centre)});
                path.segments.push_back({out});
                const Sheet inside = cutAt(window, {path}, Keep::Inside, filled);
                const Sheet outside = cutAt(window, {path}, Keep::Outside, filled);
                const auto lines = inside.shapes.back().paths;
                QVERIFY(lines == std::vector{along});
                if (!filled) {
                    QCOMPARE(pathsOf(outside).size(), std::size_t(1));
                    QCOMPARE(pathsOf(outside)[0].segments.size(), std::size_t(2));
                    continue;
                }
                QCOMPARE(outside.shapes.size(), std::size_t(2));
                QVERIFY(outside.shapes[0].paths[0].segments.size() <= 304);
            }
    }

    /// And a circle along a polygon, as long as that is within a micrometre of it.
    void aCurveAlongAPolygonIsWhole()
    {
        for (const double radius : {0.1, 1.0, 10.0, 50.0}) {
            const EllipseArc round{centre, {radius, 0}, {0, radius}};
            for (const int corners : {512, 2048}) {
                const Subpath polygon = polyline(round, 0.1, 2 * std::numbers::pi, corners);
                for (const Subpath& own : {circle(radius, 4, 0), circle(radius, 5, 1)}) {
                    QVERIFY(pathsOf(cutAt(windowOf(polygon), {own}, Keep::Inside, false))
                            == std::vector{own});
                    QVERIFY(cutAt(windowOf(polygon), {own}, Keep::Outside, false).shapes.empty());
                    QVERIFY(covered({own, polygon}, {polygon}).empty());
                    QVERIFY(covered({own, polygon}, {own}).empty());
                }
            }
        }
    }

    /// Ends with three decimals, beside corners of its polygon and beside each other.
    void aWindowsOwnPathIsWholeWhateverEndsBesideIt()
    {
        std::mt19937_64 random(23);
        const auto number = [&](double low, double high) { return between(random, low, high); };
        for (int i = 0; i < 60; ++i) {
            const Bezier curve{{50, 100},
                               {number(60, 140), number(10, 95)},
                               {number(160, 240), number(10, 95)},
                               {250, 100}};
            const Subpath own{
                curve.from,
                {{curve.to, curve.control1, curve.control2, true}, {{250, 200}}, {{50, 200}}},
                true};
            std::vector<Subpath> paths{own};
            for (int k = 1; k < 128; ++k) {
                const Point p = curve.at(k % 2 ? k / 128.0 : number(0, 1));
                const Point end(std::round(p.x * 1e3) / 1e3, std::round(p.y * 1e3) / 1e3);
                paths.push_back({end, {{{end.x, k % 3 ? 0.0 : 190.0}}}, false});
            }
            QVERIFY(pathsOf(cutAt(windowOf(own), paths, Keep::Inside, false)).front() == own);
            for (const Subpath& part : pathsOf(cutAt(windowOf(own), paths, Keep::Outside, false)))
                QVERIFY(!part.segments[0].curved);
        }
    }

    /// Two that end on both sides of a border, as far from it as counts as on it.
    void endsBesideEachOtherDoNotBreakWhatIsAlong()
    {
        const Subpath border{
            {50, 50}, {{{250, 250}, {100, 100}, {200, 200.01}, true}, {{50, 250}}}, true};
        const Point middle = Bezier{{50, 50}, {100, 100}, {200, 200.01}, {250, 250}}.at(0.6),
                    across = Point(-1, 1) / std::sqrt(2.0);
        for (const double far : {0.0004, 0.0009, 0.0012})
            for (const Point& end : {middle, border.segments[0].to})
                for (const Keep keep : {Keep::Inside, Keep::Outside}) {
                    const std::vector<Subpath> paths{
                        {end + far * across, {{end + 70.0 * across}}, false},
                        {end - far * across, {{end - 20.0 * across}}, false},
                        border};
                    std::size_t curves = 0;
                    for (const Subpath& part : pathsOf(cutAt(windowOf(border), paths, keep, false)))
                        curves += part.segments[0].curved;
                    QCOMPARE(curves, std::size_t(keep == Keep::Inside));
                }
    }

    /// A line along the borders of two windows has the edges of the first, in either direction.
    void aLineAlongTwoBorders()
    {
        const Bezier curve{{50, 100}, {116, 99.99893}, {184, 99.99893}, {250, 100}};
        const auto areaBy = [](const Bezier& one, const Bezier& two, double y) {
            return windowOf({one.from,
                             {{one.to, one.control1, one.control2, true},
                              {two.to, two.control1, two.control2, true},
                              {{two.to.x, y}},
                              {{one.from.x, y}}},
                             true});
        };
        const Bezier back{curve.to, curve.control2, curve.control1, curve.from};
        const ClipWindow below = areaBy(curve.part(0, 0.5), curve.part(0.5, 1), 200),
                         above = areaBy(back.part(0, 0.37), back.part(0.37, 1), 20);
        for (const auto operation : {WindowOperation::CutOut, WindowOperation::Intersect})
            for (const auto& [a, b] : {std::pair(curve.from, curve.to), {curve.to, curve.from}})
                for (const Keep keep : {Keep::Inside, Keep::Outside}) {
                    ClipWindow other = below;
                    other.operation = operation;
                    const Subpath line{a, {{b}}, false};
                    const auto left = pathsOf(cutAt({above, other}, {line}, keep, false));
                    const bool isIn = operation == WindowOperation::Intersect;
                    QVERIFY(isIn == (keep == Keep::Inside) ? left == std::vector{line}
                                                           : left.empty());
                }
    }

    /// Its corners are far apart, and ends on it do not bend it.
    void anEndOnAVeryLargeCircleMovesNothingElse()
    {
        constexpr double radius = 100'000;
        const Point middle(150, 100 + radius);
        const auto on = [&](double x) {
            return middle.y - std::sqrt(radius * radius - (x - middle.x) * (x - middle.x));
        };
        std::vector<Subpath> paths;
        for (double x = 60; x < 250; x += 5)
            paths.push_back({{x, on(x) + 0.005}, {{{x, on(x) + 10}}}, false});
        const std::vector<Subpath> below = paths;
        paths.push_back({{150, on(150)}, {{{150, 20}}}, false});
        const ClipWindow window = roundWindow({middle, {radius, radius}});
        QVERIFY(pathsOf(cutAt(window, paths, Keep::Inside, false)) == below);
    }

    /// What ends on a window's curve ends on it: nothing is left to cut.
    void cuttingAgainChangesNothing()
    {
        std::mt19937_64 random(17);
        const auto anywhere = [&] {
            const double x = between(random, -60, 60);
            return centre + Point(x, between(random, -60, 60));
        };
        const Subpath quarters = circle(40, 4, 0);
        for (const ClipWindow& window : {windowOf(quarters, EllipseRecipe{centre, {40, 40}}),
                                         windowOf(ellipse({50, 10}, {-12, 20}, 6, 0.4))}) {
            std::vector<Subpath> paths;
            for (int i = 0; i < 300; ++i)
                paths.push_back({anywhere(), {{anywhere()}, {anywhere()}}, i % 2 == 0});
            for (const Keep keep : {Keep::Inside, Keep::Outside}) {
                const auto once = pathsOf(cutAt(window, paths, keep, false));
                QVERIFY(pathsOf(cutAt(window, once, keep, false)) == once);
                const Keep other = keep == Keep::Inside ? Keep::Outside : Keep::Inside;
                QVERIFY(pathsOf(cutAt(window, once, other, false)).empty());
            }
        }
    }

    /// A circle that is moved by micrometres, however it is drawn, is the same, or crosses the
    /// border twice; one that is larger or smaller by some is the same, or crosses it nowhere.
    void micrometresBesideTheBorder_data()
    {
        QTest::addColumn<double>("radius");
        for (const double radius : {0.1, 1.0, 40.0, 1000.0})
            QTest::addRow("%g", radius) << radius;
    }
    void micrometresBesideTheBorder()
    {
        QFETCH(double, radius);
        const ClipWindow window = roundWindow({centre, {radius, radius}});
        const auto count = [&](const Subpath& path, Keep keep) {
            return pathsOf(cutAt(window, {path}, keep, false)).size();
        };
        for (const double micrometres : {0.0, 0.5, 1.0, 2.5, 3.0, 5.0, 10.0, 100.0}) {
            const double by = micrometres / 1000;
            const bool same = micrometres <= 1;
            if (by > radius / 2)
                continue;
            for (const double angle : {0.0, 0.4, 1.3})
                for (const Subpath& drawn : {circle(radius, 4, 0), circle(radius, 6, 0.2),
                                             reversedPath(circle(radius, 5, 0.2))}) {
                    const Subpath moved =
                        movedBy(drawn, by * Point(std::cos(angle), std::sin(angle)));
                    QCOMPARE(count(moved, Keep::Inside), std::size_t(1));
                    const std::size_t outside = count(moved, Keep::Outside);
                    QVERIFY(outside == std::size_t(!same) || (micrometres == 1 && outside == 1));
                }
            for (const double larger : {by, -by})
                for (const int arcs : {4, 5}) {
                    const Subpath other = circle(radius + larger, arcs, 0.3);
                    const bool inside = same || larger < 0;
                    QCOMPARE(count(other, Keep::Inside), std::size_t(inside));
                    QCOMPARE(count(other, Keep::Outside), std::size_t(!inside));
                }
        }
    }

    /// As files have them, with so many decimals, and with a node that divides one of its curves.
    /// The window's own numbers have six.
    void roundedCurvesAreTheSame()
    {
        std::mt19937_64 random(23);
        const auto rounded = [](Subpath path, double decimals) {
            const double scale = std::pow(10, decimals);
            forEachPoint(path, [&](Point& p) { p = glm::round(p * scale) / scale; });
            return path;
        };
        for (int i = 0; i < 60; ++i) {
            const double r = between(random, 5, 35), ry = r * (i % 2 ? 1 : i % 4 ? 0.5 : 0.8);
            const Point by(between(random, 0, 1), between(random, 0, 1));
            const EllipseRecipe recipe{centre + by, {r, ry}};
            Subpath path = movedBy(ellipse({r, 0}, {0, ry}, 4 + 4 * (i % 3 == 0), 0), by);
            if (i % 5 == 0)
                path = halved(path);
            const ClipWindow window = windowOf(rounded(*outlineOf(recipe), 6));
            for (const double decimals : {4.0, 5.0, 6.0}) {
                const Subpath drawn = rounded(path, decimals);
                const QByteArray which =
                    QByteArray::number(i) + ": " + QByteArray::number(decimals);
                QVERIFY2(pathsOf(cutAt(window, {drawn}, Keep::Inside, false)) == std::vector{drawn},
                         which);
                QVERIFY2(pathsOf(cutAt(window, {drawn}, Keep::Outside, false)).empty(), which);
            }
        }
    }

    /// Where an area's own outline crosses itself, far from the cut, its curves stay.
    void anAreaThatCrossesItselfIsNotBent()
    {
        const Subpath first = circle(12.5, 4, 0), second = movedBy(first, {7.25, 0});
        Sheet sheet;
        sheet.shapes.push_back({{first, second},
                                {.fill = Colour{}, .fillRule = FillRule::EvenOdd},
                                QString(),
                                0,
                                false});
        Document document = documentOf(sheet);
        CutOptions options{.clipAll = clipping::exactAlgorithm().corrected.clipAll};
        const ClipWindow window{QString(),
                                RectangleShape{{centre - Point(5, 50), centre + Point(50, 50)}, 0}};
        app::cutAt(options, {{window}, Keep::Inside}, document.page());
        document.apply(cut(document, options).edit);
        std::size_t crossings = 0;
        for (const Subpath& ring : pathsOf(sheetOf(document)))
            for (const PathSegment& s : ring.segments) {
                const double one = std::abs(glm::distance(s.to, centre) - 12.5),
                             other = std::abs(glm::distance(s.to, centre + Point(7.25, 0)) - 12.5);
                QVERIFY(std::min(one, other) < 1e-9);
                crossings += std::max(one, other) < 1e-9;
            }
        QVERIFY(crossings >= 2);
    }

    /// A window that crosses itself: its loop is one curve, which ends where it begins.
    void theLoopOfAWindowIsCutOut()
    {
        const Subpath square{{5, 5}, {{{95, 5}}, {{95, 95}}, {{5, 95}}}, true};
        for (const bool closed : {true, false}) {
            const ClipWindow window =
                windowOf({{30, 80}, {{{70, 80}, {120, 10}, {-20, 10}, true}}, closed});
            double sum = 0;
            for (const Keep keep : {Keep::Inside, Keep::Outside})
                sum += areaOf(cutAt(window, {square}, keep, true).shapes[0].paths);
            QVERIFY(std::abs(sum - 8100) < 1e-6);
        }
    }

    /// What a cut leaves of a circle is still of it, at the same window and when cut again.
    void whatIsLeftOfACircleIsOnIt()
    {
        const Subpath own = circle(40, 4, 0);
        const ClipWindow round = roundWindow({centre, {40, 40}});
        for (const double x : {-39.99, -7.0, 0.001, 10.5, 39.99})
            for (const Keep keep : {Keep::Inside, Keep::Outside}) {
                const ClipWindow half{
                    QString(), RectangleShape{{centre - Point(99, 99), centre + Point(x, 99)}}};
                const auto left = pathsOf(cutAt(half, {own}, keep, false));
                QVERIFY(!left.empty());
                QVERIFY2(pathsOf(cutAt(round, left, Keep::Inside, false)) == left,
                         QByteArray::number(x));
                QVERIFY(pathsOf(cutAt(round, left, Keep::Outside, false)).empty());
                for (const Subpath& part : left)
                    for (const Point& end : cutEndsOf({part}, own))
                        QVERIFY(std::abs(glm::distance(end, centre) - 40) < 1e-12);
            }
    }

    // Further apart than usual: the same for whoever wants that.
    void howFarCurvesAreApartIsChosen()
    {
        const ClipWindow window = windowOf(circle(40, 4, 0));
        Sheet sheet;
        for (const double radius : {40.02, 39.98})
            sheet.shapes.push_back(
                {{circle(radius, 5, 1)}, {.stroke = Colour{}}, QString(), 0, false});
        for (const double coincident : {0.0, 0.05})
            for (const Keep keep : {Keep::Inside, Keep::Outside}) {
                Document document = documentOf(sheet);
                CutOptions options{.clipAll = clipping::exactAlgorithm().corrected.clipAll};
                options.coincident = coincident;
                app::cutAt(options, {{window}, keep}, document.page());
                document.apply(cut(document, options).edit);
                const std::size_t wanted = coincident == 0 ? 1 : keep == Keep::Inside ? 2 : 0;
                QCOMPARE(pathsOf(sheetOf(document)).size(), wanted);
            }
    }

    /// Curves anywhere, arcs of the border, and curves that begin on it.
    void insideAndOutsideAreAll()
    {
        std::mt19937_64 random(5);
        const auto number = [&](double low, double high) { return between(random, low, high); };
        const auto anywhere = [&] { return centre + Point(number(-60, 60), number(-60, 60)); };
        for (int i = 0; i < 200; ++i) {
            const Point axis1(number(20, 50), number(-10, 10)),
                axis2(number(-10, 10), number(20, 50));
            const Subpath border = i % 2 ? circle(40, 4 + i % 3, number(0, 6))
                                         : ellipse(axis1, axis2, 4 + i % 3, number(0, 6));
            const ClipWindow window =
                i % 4 == 1 ? windowOf(border, EllipseRecipe{centre, {40, 40}}) : windowOf(border);
            const EllipseArc arc =
                i % 2 ? EllipseArc{centre, {40, 0}, {0, 40}, number(0, 6), number(-3, 3)}
                      : EllipseArc{centre, axis1, axis2, number(0, 6), number(-3, 3)};
            Subpath path{anywhere(), {}, random() % 2 == 0};
            path.segments.push_back({arc.at(arc.angle)});
            appendCurves(path.segments, arc, arc.at(arc.angle), arc.at(arc.angle + arc.sweep));
            path.segments.push_back({anywhere(), anywhere(), anywhere(), true});
            const Sheet inside = cutAt(window, {path}, Keep::Inside, false);
            const Sheet outside = cutAt(window, {path}, Keep::Outside, false);
            const double whole = lengthOf({path}),
                         sum = lengthOf(pathsOf(inside)) + lengthOf(pathsOf(outside));
            QVERIFY2(std::abs(sum - whole) < 1e-3,
                     QByteArray::number(i) + ": " + QByteArray::number(sum - whole));
            const std::size_t parts = pathsOf(inside).size() + pathsOf(outside).size();
            QVERIFY2(parts <= 9,
                     QByteArray::number(i) + ": " + QByteArray::number(qulonglong(parts)));
        }
    }

    // Divided otherwise, or a true circle: one of them less the other one is nothing.
    void windowsWithOneBorder()
    {
        for (const double radius : {5.0, 30.0, 400.0}) {
            std::vector<Subpath> paths{circle(radius, 5, 1), circle(radius / 2, 4, 0),
                                       halved(circle(radius, 4, 0.4))};
            for (int i = -10; i <= 10; ++i) {
                const double at = i / 10.3 * radius;
                paths.push_back({centre + Point(at, -2 * radius),
                                 {{{centre + Point(at + i * radius / 25, 2 * radius)}}}});
            }
            const ClipWindow exact = windowOf(circle(radius, 4, 0),
                                              EllipseRecipe{centre, {radius, radius}}),
                             six = windowOf(circle(radius, 6, 0.3)),
                             beside = windowOf(circle(radius, 5, 0.0002)),
                             back = windowOf(reversedPath(circle(radius, 4, 0.7))),
                             divided = windowOf(halved(circle(radius, 4, 1.1)));
            for (const auto& [first, second] :
                 {std::pair(exact, six), std::pair(six, exact), std::pair(six, back),
                  std::pair(exact, beside), std::pair(exact, divided), std::pair(divided, six),
                  std::pair(divided, exact), std::pair(back, exact)})
                for (const bool filled : {false, true}) {
                    if (filled && radius != 30)
                        continue;
                    ClipWindow less = second, common = second;
                    less.operation = WindowOperation::CutOut;
                    common.operation = WindowOperation::Intersect;
                    const auto count = [&](const std::vector<ClipWindow>& windows, Keep keep) {
                        return pathsOf(cutAt(windows, paths, keep, filled)).size();
                    };
                    QCOMPARE(count({first, less}, Keep::Inside), std::size_t(0));
                    QCOMPARE(count({first, less}, Keep::Outside), paths.size());
                    for (const Keep keep : {Keep::Inside, Keep::Outside}) {
                        QCOMPARE(count({first, common}, keep), count({first}, keep));
                        QCOMPARE(count({first, second}, keep), count({first}, keep));
                    }
                }
        }
    }
    /// Where two windows cross, the corner of what they leave is on both true borders.
    void cornersOfTwoWindowsAreOnBoth()
    {
        const Subpath all = circle(90, 4, 0.1);
        const ClipWindow round = roundWindow({centre, {40, 40}});
        const Point beside = centre + Point(31, 12);
        const RectangleShape upright{{centre + Point(11, -70), centre + Point(70, 70)}, 0};
        for (const auto operation : {WindowOperation::Intersect, WindowOperation::CutOut})
            for (const bool isRectangle : {false, true}) {
                ClipWindow other = roundWindow({beside, {33, 33}});
                if (isRectangle)
                    other.shape = upright;
                other.operation = operation;
                const Sheet left = cutAt({round, other}, {all}, Keep::Inside, true);
                std::size_t corners = 0;
                for (const PathSegment& s : left.shapes[0].paths[0].segments) {
                    const double off = isRectangle ? std::abs(s.to.x - upright.box.min.x)
                                                   : std::abs(glm::distance(s.to, beside) - 33);
                    corners += off < 1e-12 && std::abs(glm::distance(s.to, centre) - 40) < 1e-12;
                }
                QVERIFY(corners >= 1);
                const Point& start = left.shapes[0].paths[0].start;
                QVERIFY(std::abs(glm::distance(start, centre) - 40) < 1e-12
                        || std::abs(glm::distance(start, beside) - 33) < 1e-12
                        || start.x == upright.box.min.x);
            }
    }

    /// Between a curve and its chord, which is up to 0.05 mm from it, an edge cuts, too.
    void whatBulgesBeyondAStraightEdgeIsCut()
    {
        const auto count = [](const ClipWindow& window, const Subpath& path, Keep keep) {
            return pathsOf(cutAt(window, {path}, keep, false)).size();
        };
        for (const double by : {0.04, 0.01, 1e-3, 1e-5}) {
            const Point corner = centre + 40.0 * Point(std::cos(0.7), std::sin(0.7));
            const auto windowAt = [](const Point& min, const Point& max, double angle) {
                return ClipWindow{QString(), RectangleShape{{min, max}, angle}};
            };
            for (const Subpath& path : {circle(40, 4, 0.4), circle(40, 5, 1)}) {
                const ClipWindow side =
                    windowAt(centre - Point(90, 90), centre + Point(40 - by, 90), 0);
                const Subpath square{centre + Point(40 - by, -90),
                                     {{centre + Point(40 - by, 90)},
                                      {centre + Point(-90, 90)},
                                      {centre + Point(-90, -90)}},
                                     true};
                for (const ClipWindow& window : {side, windowOf(square)})
                    for (const Keep keep : {Keep::Inside, Keep::Outside}) {
                        QCOMPARE(count(window, path, keep), std::size_t(1));
                        for (const Subpath& part : pathsOf(cutAt(window, {path}, keep, false)))
                            for (const Point& end : cutEndsOf({part}, path)) {
                                QCOMPARE(end.x, centre.x + 40 - by);
                                QVERIFY(std::abs(glm::distance(end, centre) - 40) < 1e-9);
                            }
                    }
                for (const double in : {by, -by}) {
                    const ClipWindow window =
                        windowAt(corner - Point(in), corner + Point(90, 90), 0);
                    QCOMPARE(count(window, path, Keep::Inside), std::size_t(in > 0));
                    QCOMPARE(count(window, path, Keep::Outside), std::size_t(1));
                }
            }
        }
    }

    /// A polygon with its corners on a circle, far from it between them: they only touch.
    void aCircleAroundAPolygonTouchesIt()
    {
        const Subpath own = circle(40, 4, 0);
        for (const int corners : {5, 64}) {
            const EllipseArc border{centre, {40, 0}, {0, 40}};
            const ClipWindow polygon = windowOf(polyline(border, 0, 2 * std::numbers::pi, corners));
            QVERIFY(pathsOf(cutAt(polygon, {own}, Keep::Inside, false)).empty());
            QCOMPARE(pathsOf(cutAt(polygon, {own}, Keep::Outside, false)), std::vector{own});
        }
    }

    /// Lines alone at several windows, whose curves pass straight edges of each other.
    void linesAtCurvesBesideStraightEdges()
    {
        const Subpath line{centre - Point(90, 1), {{centre + Point(90, 1)}}, false};
        const ClipWindow round = roundWindow({centre, {40, 40}}),
                         beside = roundWindow({centre + Point(20, 0), {30, 30}}),
                         upright{QString(),
                                 RectangleShape{{centre - Point(60, 50), centre + Point(50, 30)}}};
        const auto parts = pathsOf(cutAt({round, beside, upright}, {line}, Keep::Inside, false));
        QCOMPARE(parts.size(), std::size_t(1));
        QCOMPARE(parts[0].start.x, centre.x - 60);
    }

    /// A window whose subpath is a point, or whose radius is 0.
    void windowsWithoutArea()
    {
        const Subpath own = circle(40, 4, 0), point{centre, {}, true};
        Subpath still = own;
        still.start = centre;
        for (PathSegment& s : still.segments)
            s.to = s.control1 = s.control2 = centre;
        const ClipWindow both{QString(), PathShape{Path(std::vector{point, still, own})}};
        QVERIFY(cutAt(both, {own, still}, Keep::Outside, false).shapes.empty());
        const ClipWindow none = windowOf(still, EllipseRecipe{centre, {0, 0}});
        QCOMPARE(cutAt(none, {own}, Keep::Outside, true).shapes[0].paths, std::vector{own});
        QVERIFY(cutAt(none, {own, still}, Keep::Inside, false).shapes.empty());
    }

    /// Ends of inside and outside are the same points, within a nanometre of both true curves, and
    /// there are as many as at the polygon.
    void cutsAreWhereTheTrueCurvesMeet()
    {
        std::mt19937_64 random(7);
        const auto anywhere = [&] {
            const double x = between(random, -60, 60);
            return centre + Point(x, between(random, -60, 60));
        };
        const Subpath quarters = circle(40, 4, 0);
        const std::vector<ClipWindow> windows{windowOf(quarters, EllipseRecipe{centre, {40, 40}}),
                                              windowOf(quarters),
                                              windowOf(ellipse({50, 10}, {-12, 20}, 6, 0.4))};
        std::size_t cuts = 0, missed = 0;
        const int pairs = tests::caseStep() == 1 ? 100'000 : 900;
        for (int i = 0; i < pairs; ++i) {
            const ClipWindow& window = windows[std::size_t(i % 3)];
            const bool isCurve = i % 2 == 0;
            const Subpath path{anywhere(), {{anywhere(), anywhere(), anywhere(), isCurve}}, false};
            const auto inside = pathsOf(cutAt(window, {path}, Keep::Inside, false));
            const auto outside = pathsOf(cutAt(window, {path}, Keep::Outside, false));
            ClipWindow straight = window;
            straight.shape = CurvedBorder({{window}}, Page{}).polygons().list[0].shape;
            constexpr double fine = 0.001;
            const auto atPolygon =
                pathsOf(cutAt(std::vector{straight}, {path}, Keep::Inside, false, fine));
            if (atPolygon.size() != inside.size()) // an end on the border is not cut off
                QVERIFY(distanceTo(window, path.start) < 0.002
                        || distanceTo(window, path.segments[0].to) < 0.002);
            for (const Point& end : cutEndsOf(inside, path)) {
                const auto others = cutEndsOf(outside, path);
                QVERIFY(std::ranges::find(others, end) != others.end());
                ++cuts;
                const double off = std::max(distanceTo(window, end), distanceTo(path, end));
                missed += off > 1e-6;
            }
        }
        QVERIFY(cuts > 500);
        QCOMPARE(missed, std::size_t(0));
    }
};

} // namespace cut_curved_border_test

TEST_CLASS(cut_curved_border_test::CurvedBorderTest, None)
#include "tests/app/cut/curved_border_test.moc"
