// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/cut.h"
#include "app/document/bezier.h"
#include "app/document/document_builder.h"
#include "app/document/recipe_outline.h"

#include <QTest>

#include <cmath>
#include <numbers>
#include <random>

#include "tests/test_class.h"

namespace cut_cut_proof_test {

// What any cut must keep to, at windows of any shape: lengths, areas, curves, and that a second cut
// changes nothing.

using namespace app;

namespace {

constexpr double tolerance = 1e-3;

Point onCircle(double angle) { return {std::cos(angle), std::sin(angle)}; }

PathShape star()
{
    Subpath path{Point(8, 0), {}, true};
    for (int i = 1; i < 10; ++i)
        path.segments.push_back({onCircle(std::numbers::pi * i / 5) * (i % 2 ? 3.0 : 8.0)});
    return {Path({&path, 1})};
}

PathShape circle(const Point& centre, double radius)
{
    const EllipseRecipe recipe{centre, Point(radius)};
    const auto outline = outlineOf(recipe);
    return {Path({&*outline, 1}), FillRule::NonZero, recipe};
}

struct Case {
    const char* name;
    ClipWindows windows;
};

std::vector<Case> cases()
{
    const auto with = [](WindowShape shape, WindowOperation operation = WindowOperation::Add) {
        return ClipWindow{.shape = std::move(shape), .operation = operation};
    };
    const RectangleShape rotated{{{-4, -9}, {3, 5}}, 0.4}, upright{{{-3, -4}, {6, 2}}};
    return {{"rectangle", {{with(upright)}}},
            {"rotated rectangle", {{with(rotated)}}},
            {"circle", {{with(circle({1, 1}, 5))}}},
            {"star", {{with(star())}}},
            {"several windows",
             {{with(upright), with(rotated), with(circle({1, 1}, 2), WindowOperation::CutOut),
               with(star(), WindowOperation::Intersect)}}},
            {"windows that replace",
             {{with(star()), with(circle({1, 1}, 2), WindowOperation::Replace),
               with(circle({2, 0}, 3)), with(upright, WindowOperation::CutOut),
               with(circle({-1, 1}, 6), WindowOperation::Replace),
               with(star(), WindowOperation::CutOut)}}}};
}

// A closed curve around the origin that does not cross itself, filled and stroked.
Object blob(std::mt19937_64& random)
{
    std::uniform_real_distribution<double> radius(3, 9);
    constexpr int corners = 7;
    std::vector<Point> points;
    for (int i = 0; i < corners; ++i)
        points.push_back(onCircle(2 * std::numbers::pi * i / corners) * radius(random));
    Subpath path{points[0], {}, true};
    for (int i = 0; i < corners; ++i) {
        const Point from = points[std::size_t(i)], to = points[std::size_t((i + 1) % corners)];
        if (i % 3 == 2)
            path.segments.push_back({to});
        else
            path.segments.push_back(
                {to, from * 1.1 + (to - from) * 0.3, to * 1.1 - (to - from) * 0.3, true});
    }
    return {Path({&path, 1}), {.stroke = Colour{}, .fill = Colour{200, 0, 0}}, {.id = "blob"}};
}

Path straightened(const Path& path)
{
    std::vector<Subpath> all = path.subpaths();
    for (Subpath& each : all)
        for (PathSegment& segment : each.segments)
            segment = {segment.to};
    return Path(all);
}

Document documentOf(const Object& object)
{
    DocumentBuilder builder;
    builder.open({});
    builder.add(object);
    builder.close();
    return builder.take({});
}

Document cutAt(Document document, const ClipWindows& windows, Keep keep, bool close = false)
{
    CutOptions options{clipping::exactAlgorithm().corrected.clipAll};
    options.region = withKeep(regionOf(windows, tolerance), keep);
    options.tolerance = tolerance;
    options.closeAreas = close;
    document.apply(cut(document, options).edit);
    return document;
}

double cross(const Point& a, const Point& b) { return a.x * b.y - a.y * b.x; }

// The signed area under a cubic curve, exactly: the integral of cross(p, p') / 2.
double areaUnder(const Bezier& c)
{
    const Point &p = c.from, &q = c.control1, &r = c.control2, &s = c.to;
    return (6 * cross(p, q) + 3 * cross(p, r) + cross(p, s) + 3 * cross(q, r) + 3 * cross(q, s)
            + 6 * cross(r, s))
           / 20;
}

double areaOf(const Path& path)
{
    double area = 0;
    for (const Subpath& ring : path.subpaths()) {
        Point last = ring.start;
        for (const PathSegment& s : ring.segments) {
            area +=
                s.curved ? areaUnder({last, s.control1, s.control2, s.to}) : cross(last, s.to) / 2;
            last = s.to;
        }
        area += cross(last, ring.start) / 2;
    }
    return area;
}

double lengthOf(const Path& path)
{
    std::vector<Chord> chords;
    flatten(path, 1e-6, chords);
    double length = 0;
    for (const Chord& chord : chords)
        length += std::hypot(chord.segment.b.x - chord.segment.a.x,
                             chord.segment.b.y - chord.segment.a.y);
    return length;
}

struct Sums {
    double area = 0, length = 0;
    std::size_t ends = 0; ///< of open subpaths
};

Sums sumsOf(const Document& document)
{
    Sums sums;
    document.objects().forEach(0, document.objects().size(), [&](std::size_t, const ObjectView& o) {
        if (o.style().fill)
            sums.area += std::abs(areaOf(o.path()));
        if (o.style().stroke)
            sums.length += lengthOf(o.path());
        for (const Subpath& path : o.path().subpaths())
            sums.ends += path.closed ? 0 : 2;
    });
    return sums;
}

// The winding number of flattened rings, not for points on them.
int windingOf(std::span<const Chord> chords, const Point& p)
{
    int winding = 0;
    for (const auto& [line, segment, t0, t1] : chords) {
        const double side = cross(line.b - line.a, p - line.a);
        winding += line.a.y <= p.y && p.y < line.b.y && side > 0;
        winding -= line.b.y <= p.y && p.y < line.a.y && side < 0;
    }
    return winding;
}

double distanceTo(std::span<const Chord> chords, const Point& p)
{
    double least = std::numeric_limits<double>::infinity();
    for (const Chord& chord : chords) {
        const auto& [a, b] = chord.segment;
        const Point way = b - a;
        const double length = glm::dot(way, way);
        const double t = length > 0 ? std::clamp(glm::dot(p - a, way) / length, 0.0, 1.0) : 0;
        least = std::min(least, glm::distance(p, a + way * t));
    }
    return least;
}

std::vector<Chord> chordsOf(const Document& document)
{
    std::vector<Chord> chords;
    document.objects().forEach(0, document.objects().size(), [&](std::size_t, const ObjectView& o) {
        if (o.style().fill)
            flatten(o.path(), 1e-5, chords);
    });
    return chords;
}

/// With the windows' true curves, as a drawing is cut.
Cut cutTruly(const Document& document, const ClipWindows& windows, Keep keep)
{
    CutOptions options{clipping::exactAlgorithm().corrected.clipAll};
    app::cutAt(options, windows, document.page());
    options.region = withKeep(std::move(options.region), keep);
    return cut(document, options);
}

bool kept(const ClipRegion& region, const Point& p)
{
    return region.prepared ? !clipping::clip({p, p}, region.prepared->prepared()).empty()
                           : remainsOf(region, {p, p}) == Remains::Whole;
}

} // namespace

class CutProofTest : public QObject {
    Q_OBJECT

    static void addCases()
    {
        QTest::addColumn<int>("number");
        const auto all = cases();
        for (int i = 0; i < int(all.size()); ++i)
            QTest::newRow(all[std::size_t(i)].name) << i;
    }
    static ClipWindows windows()
    {
        QFETCH(int, number);
        return cases()[std::size_t(number)].windows;
    }

private slots:
    // Areas to 1e-9. Where a line is cut, the two curves end at most a tolerance beside the curve.
    void insideAndOutsideAreTheWhole_data() { addCases(); }
    void insideAndOutsideAreTheWhole()
    {
        std::mt19937_64 random(1);
        std::size_t ends = 0;
        for (int i = 0; i < 40; ++i) {
            const Document whole = documentOf(blob(random));
            const Sums all = sumsOf(whole);
            const Sums inside = sumsOf(cutAt(whole, windows(), Keep::Inside)),
                       outside = sumsOf(cutAt(whole, windows(), Keep::Outside));
            QVERIFY(std::abs(inside.area + outside.area - all.area) < 1e-9 * all.area);
            const double bound = 2 * tolerance * double(inside.ends + outside.ends) + 1e-4;
            QVERIFY2(std::abs(inside.length + outside.length - all.length) < bound,
                     qPrintable(QStringLiteral("%1: %2 + %3, not %4")
                                    .arg(i)
                                    .arg(inside.length)
                                    .arg(outside.length)
                                    .arg(all.length)));
            const Sums closed = sumsOf(cutAt(whole, windows(), Keep::Inside, true));
            QVERIFY(std::abs(closed.area - inside.area) < 1e-9 * all.area);
            QCOMPARE(closed.ends, 0u);
            ends += inside.ends;
        }
        QVERIFY(ends > 80);
    }

    void whatIsReplacedChangesNothing_data() { addCases(); }
    void whatIsReplacedChangesNothing()
    {
        const ClipWindows alone = windows();
        ClipWindows after = cases().back().windows; // curves, which would divide the others
        const std::size_t first = after.list.size();
        after.list.insert(after.list.end(), alone.list.begin(), alone.list.end());
        after.list[first].operation = WindowOperation::Replace;
        // The same steps: no time is spent on what is replaced.
        QVERIFY(regionOf(after, tolerance) == regionOf(alone, tolerance));
        std::mt19937_64 random(3);
        std::size_t pieces = 0;
        for (int i = 0; i < 20; ++i)
            for (const Keep keep : {Keep::Inside, Keep::Outside}) {
                const Document whole = documentOf(blob(random));
                const Cut made = cutTruly(whole, after, keep),
                          expected = cutTruly(whole, alone, keep);
                Document left = whole, expectedLeft = whole;
                left.apply(made.edit);
                expectedLeft.apply(expected.edit);
                QVERIFY(left.objects() == expectedLeft.objects());
                QCOMPARE(made.counts.segmentsAfter, expected.counts.segmentsAfter);
                QCOMPARE(made.counts.cut, expected.counts.cut);
                pieces += made.counts.cut;
            }
        QVERIFY(pieces > 20);
    }

    void whatIsFilledIsInTheShapeAndInTheWindows_data() { addCases(); }
    void whatIsFilledIsInTheShapeAndInTheWindows()
    {
        std::mt19937_64 random(2);
        std::uniform_real_distribution<double> number(-10, 10);
        const ClipRegion region = regionOf(windows(), tolerance);
        int inside = 0;
        for (int i = 0; i < 40; ++i) {
            const Document whole = documentOf(blob(random));
            const auto before = chordsOf(whole),
                       after = chordsOf(cutAt(whole, windows(), Keep::Inside));
            for (int k = 0; k < 250; ++k) {
                const Point p(number(random), number(random));
                if (distanceTo(before, p) < 1e-4 || distanceTo(after, p) < 2 * tolerance)
                    continue;
                const bool expected = windingOf(before, p) != 0 && kept(region, p);
                QCOMPARE(std::abs(windingOf(after, p)), int(expected));
                inside += expected;
            }
        }
        QVERIFY(inside > 300);
    }

    // Of straight lines no end moves by more than some ulps. A curve is decided by its chords,
    // which a second cut divides elsewhere: at a corner of a window an end may move within the
    // tolerance. Nothing falls apart.
    void cuttingTwiceChangesNothing_data() { addCases(); }
    void cuttingTwiceChangesNothing()
    {
        std::mt19937_64 random(3);
        for (int i = 0; i < 120; ++i) {
            const bool straight = i % 2 == 0;
            Object object = blob(random);
            if (straight)
                object.path = straightened(object.path);
            if (i % 3 == 0)
                object.style.fill.reset();
            const double bound = straight ? 1e-12 : tolerance;
            const Document once = cutAt(documentOf(object), windows(), Keep::Inside);
            const Document twice = cutAt(once, windows(), Keep::Inside);
            QCOMPARE(twice.objects().size(), once.objects().size());
            QVERIFY(twice.containers() == once.containers());
            for (std::size_t k = 0; k < once.objects().size(); ++k) {
                const Path a = once.objects()[k].path(), b = twice.objects()[k].path();
                QCOMPARE(b.subpathCount(), a.subpathCount());
                const double longer = std::abs(lengthOf(b) - lengthOf(a));
                const double larger = std::abs(areaOf(b) - areaOf(a));
                QVERIFY2(longer < bound && larger < bound,
                         qPrintable(QStringLiteral("%1, object %2: length %3, area %4")
                                        .arg(i)
                                        .arg(k)
                                        .arg(longer)
                                        .arg(larger)));
            }
        }
    }

    // Every curve that is left is a part of a curve of the whole: of the same degree, and on it.
    void cutCurvesKeepTheirDegree_data() { addCases(); }
    void cutCurvesKeepTheirDegree()
    {
        std::mt19937_64 random(4);
        int curves = 0;
        for (int i = 0; i < 20; ++i) {
            const Object object = blob(random);
            std::vector<Chord> whole;
            flatten(object.path, 1e-5, whole);
            const Document left = cutAt(documentOf(object), windows(), Keep::Inside);
            for (std::size_t k = 0; k < left.objects().size(); ++k)
                for (const Subpath& path : left.objects()[k].path().subpaths()) {
                    Point from = path.start;
                    for (const PathSegment& s : path.segments) {
                        if (s.curved)
                            for (const double t : {0.25, 0.5, 0.75})
                                QVERIFY(distanceTo(whole,
                                                   Bezier{from, s.control1, s.control2, s.to}.at(t))
                                        < tolerance + 2e-5);
                        curves += s.curved;
                        from = s.to;
                    }
                    // A blob has five curves and two lines; a cut adds lines along the window.
                    QVERIFY(path.segments.size() < 200);
                }
        }
        QVERIFY(curves > 40);
    }
};

} // namespace cut_cut_proof_test

TEST_CLASS(cut_cut_proof_test::CutProofTest, Core)
#include "tests/app/cut/cut_proof_test.moc"
