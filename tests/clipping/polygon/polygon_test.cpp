// SPDX-License-Identifier: GPL-3.0-or-later
// The contract of clipping/algorithm.h for convex polygons (polygonUlps), for every form of the
// catalogue, against whole numbers.
#include "clipping/algorithm.h"
#include "clipping/exact/turn.h"

#include <cmath>
#include <limits>

#include "tests/clipping/contract.h"
#include "tests/clipping/polygon/contract.h"
#include "tests/clipping/polygon/shapes.h"
#include "tests/deep.h"
#include "tests/test_class.h"
#include "tests/verify.h"

namespace polygon_polygon_test {

using namespace clipping;

namespace {

using Small = polygon_oracle::Truth<long long>;

std::vector<glm::dvec2> gridPoints(int low, int high)
{
    std::vector<glm::dvec2> all;
    for (int x = low; x <= high; ++x)
        for (int y = low; y <= high; ++y)
            all.push_back({x, y});
    return all;
}

std::vector<Segment> gridSegments(int low, int high)
{
    std::vector<Segment> all;
    for (const auto& a : gridPoints(low, high))
        for (const auto& b : gridPoints(low, high))
            all.push_back({a, b});
    return all;
}

/// Whether small whole numbers are a polygon that contains something: by the angles it turns.
bool isPolygon(const ConvexPolygon& polygon)
{
    std::vector<glm::dvec2> directions;
    const auto& c = polygon.corners;
    bool flat = true;
    for (std::size_t i = 0; i < c.size(); ++i) {
        const auto d = c[(i + 1) % c.size()] - c[i];
        if (d != glm::dvec2(0, 0))
            directions.push_back(d);
        for (const auto& p : c)
            flat = flat && d.x * (p.y - c[i].y) == d.y * (p.x - c[i].x);
    }
    double round = 0;
    for (std::size_t i = 0; i < directions.size(); ++i) {
        const auto &d = directions[i], &e = directions[(i + 1) % directions.size()];
        const double turn = std::atan2(d.x * e.y - d.y * e.x, d.x * e.x + d.y * e.y);
        if (!flat && (turn < 0 || turn > 3.1415))
            return false;
        round += turn;
    }
    return flat ? !c.empty() : round > 6 && round < 7;
}

/// On small whole numbers everything is known exactly: the visibility and the ends.
std::string gridFault(const Clipped* found, const Segment& s,
                      const std::optional<polygon_oracle::Interval<long long>>& part)
{
    if (part.has_value() != (found != nullptr))
        return part ? "lost" : "seen where there is nothing";
    if (!part)
        return {};
    const auto off = [&](const auto& t, const glm::dvec2& p) {
        const double share = double((long long)t.over) / double((long long)t.under);
        const glm::dvec2 d = p - (s.a + share * (s.b - s.a));
        return std::max(std::abs(d.x), std::abs(d.y));
    };
    const auto& [a, b] = found->segment;
    if (off(part->from, a) > 4e-15 || off(part->to, b) > 4e-15)
        return "not the right ends";
    if (!(part->from < part->to) && a != b)
        return "a contact that is no point";
    if ((polygonEdgeOfA(found->cut) != 0) != (a != s.a)
        || (polygonEdgeOfB(found->cut) != 0) != (b != s.b))
        return "not said to be cut, or said to be";
    return {};
}

void checkGrid(const PolygonUses& uses, const ConvexPolygon& polygon,
               const std::vector<Segment>& segments)
{
    if (QTest::currentTestFailed())
        return;
    std::vector<Clipped> out(segments.size());
    out.resize(uses.clipAll(segments, polygon, out));
    const bool legal = isPolygon(polygon);
    Small truth({}, polygon);
    auto next = out.begin();
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const bool seen = next != out.end() && next->source == i;
        truth.ask(segments[i]);
        const auto part = legal ? truth.inside(0) : std::nullopt;
        const auto wrong = gridFault(seen ? &*next : nullptr, segments[i], part);
        VERIFY_OR_SAY(wrong.empty(), (wrong + " for " + exactly(segments[i], polygon)).c_str());
        next += seen;
    }
}

/// A segment related to the polygon: through it, past a corner, along an edge, or to a corner.
Segment someSegment(RandomNumbers& random, const ConvexPolygon& polygon, double size)
{
    const auto& c = polygon.corners;
    const auto index = std::size_t(random.integer(0, int(c.size()) - 1));
    const auto &corner = c[index], &next = c[(index + 1) % c.size()];
    const auto anywhere = [&](double far) {
        const double x = random.uniform(-far, far);
        return glm::dvec2{x * size, random.uniform(-far, far) * size};
    };
    const auto nudged = [&](glm::dvec2 p) {
        for (double* x : {&p.x, &p.y})
            for (int i = random.integer(-2, 2); i != 0; i += i < 0 ? 1 : -1)
                *x = std::nextafter(*x, i < 0 ? -INFINITY : INFINITY);
        return p;
    };
    const auto between = [&](double t) { return corner + t * (next - corner); };
    const auto d = anywhere(1);
    switch (random.integer(0, 7)) {
    case 0:
        return {nudged(corner - random.uniform(0, 4) * d),
                nudged(corner + random.uniform(0, 4) * d)};
    case 1:
        return {nudged(between(random.uniform(-2, 2))), nudged(between(random.uniform(-2, 2)))};
    case 2:
        return {anywhere(2), nudged(corner)};
    case 3:
        return {nudged(between(random.uniform(0, 1))), anywhere(2)};
    case 4:
        return {corner - std::exp2(random.uniform(0, 40)) * d,
                corner + std::exp2(random.uniform(0, 40)) * d};
    case 5: {
        const auto p = nudged(between(random.uniform(-1, 2)));
        return {p, random.integer(0, 1) ? p : nudged(p)};
    }
    case 6:
        return {corner, c[std::size_t(random.integer(0, int(c.size()) - 1))]};
    default:
        return {anywhere(2), anywhere(2)};
    }
}

struct RandomInputs {
    int polygons, segments; ///< segments for each polygon
    int corners;            ///< at most
    double size;
    std::uint64_t seed;
};

void checkRandom(const PolygonUses& uses, bool decidesExactly, const RandomInputs& inputs)
{
    const auto& [polygons, segments, corners, size, seed] = inputs;
    RandomNumbers random(seed);
    for (int i = 0; i < polygons && !QTest::currentTestFailed(); ++i) {
        const auto polygon = somePolygon(random, random.integer(1, corners), size);
        for (int j = 0; j < segments; ++j) {
            const Segment s = someSegment(random, polygon, size);
            const auto wrong = fault(clipOne(uses, s, polygon), s, polygon, decidesExactly);
            VERIFY_OR_SAY(wrong.empty(), (wrong + " for " + exactly(s, polygon)).c_str());
        }
    }
}

} // namespace

class PolygonTest : public QObject {
    Q_OBJECT

private slots:
    void trianglesOfTheGrid_data() { everyPolygonForm(); }
    void trianglesOfTheGrid()
    {
        QFETCH(const PolygonUses*, uses);
        const auto points = gridPoints(0, 3); // from left to right
        const auto segments = gridSegments(-1, 4);
        int number = 0;
        for (std::size_t p = 0; p < points.size(); ++p)
            for (std::size_t q = p; q < points.size(); ++q)
                for (std::size_t r = p; r < points.size(); ++r)
                    if (number++ % tests::caseStep() == 0)
                        checkGrid(*uses, {{points[p], points[q], points[r]}}, segments);
    }

    // Repeated corners, corners in one line, clockwise and crossed ones are among them.
    void fourCornersOfTheGrid_data() { everyPolygonForm(); }
    void fourCornersOfTheGrid()
    {
        QFETCH(const PolygonUses*, uses);
        const auto points = gridPoints(0, 2);
        const auto segments = gridSegments(-1, 3);
        int number = 0;
        for (const auto& p : points)
            for (const auto& q : points)
                for (const auto& r : points)
                    for (const auto& t : points)
                        if (number++ % tests::caseStep() == 0)
                            checkGrid(*uses, {{p, q, r, t}}, segments);
    }

    void oneAndTwoCornersOfTheGrid_data() { everyPolygonForm(); }
    void oneAndTwoCornersOfTheGrid()
    {
        QFETCH(const PolygonUses*, uses);
        const auto segments = gridSegments(-1, 4);
        checkGrid(*uses, {}, segments);
        for (const auto& p : gridPoints(0, 3)) {
            checkGrid(*uses, {{p}}, segments);
            for (const auto& q : gridPoints(0, 3))
                checkGrid(*uses, {{p, q}}, segments);
        }
    }

    void manyCornersOfTheGrid_data() { everyPolygonForm(); }
    void manyCornersOfTheGrid()
    {
        QFETCH(const PolygonUses*, uses);
        const auto segments = gridSegments(-1, 7);
        checkGrid(*uses, {{{2, 0}, {4, 0}, {6, 2}, {6, 4}, {4, 6}, {2, 6}, {0, 4}, {0, 2}}},
                  segments);
        checkGrid(*uses, {{{6, 4}, {5, 5}, {4, 6}, {2, 6}, {0, 4}, {0, 3}, {0, 2}, {2, 0}, {2, 0}}},
                  segments);
        checkGrid(*uses, {{{3, 0}, {6, 1}, {5, 4}, {2, 6}, {0, 4}, {0, 3}, {1, 1}}}, segments);
        checkGrid(*uses, {{{3, 0}, {6, 6}, {0, 3}, {6, 1}, {2, 6}}},
                  segments); // a star: two rounds
    }

    void polygonsOfAllKinds_data() { everyPolygonForm(); }
    void polygonsOfAllKinds()
    {
        QFETCH(const PolygonUses*, uses);
        QFETCH(bool, decidesExactly);
        checkRandom(*uses, decidesExactly, {1'000, 20, 12, 1, 1});
        checkRandom(*uses, decidesExactly, {10, 60, 1'000, 100, 2});
    }

    void hugeAndTinyPolygons_data() { everyPolygonForm(); }
    void hugeAndTinyPolygons()
    {
        QFETCH(const PolygonUses*, uses);
        QFETCH(bool, decidesExactly);
        for (const double size :
             {0x1p-1070, 0x1p-1022, 0x1p-800, 0x1p-300, 0x1p300, 0x1p800, 0x1p980})
            checkRandom(*uses, decidesExactly, {200, 10, 12, size, 3});
    }

    void mixedNumbers_data() { everyPolygonForm(); }
    void mixedNumbers()
    {
        QFETCH(const PolygonUses*, uses);
        QFETCH(bool, decidesExactly);
        RandomNumbers random(4);
        const auto number = [&random] {
            return random.integer(0, 2) == 0 ? random.anyFinite<double>()
                                             : double(random.integer(-4, 4));
        };
        const auto point = [&] {
            const double x = number();
            return glm::dvec2{x, number()};
        };
        for (int i = 0; i < 5'000; ++i) {
            std::vector<glm::dvec2> points;
            for (int j = random.integer(1, 6); j > 0; --j)
                points.push_back(point());
            const auto polygon = hullOf(points);
            const Segment s{point(), random.integer(0, 2) ? point() : points[0]};
            const auto wrong = fault(clipOne(*uses, s, polygon), s, polygon, decidesExactly);
            VERIFY_OR_SAY(wrong.empty(), (wrong + " for " + exactly(s, polygon)).c_str());
        }
    }

    // The polygon is so small that, relative to the segment's ends, its corners differ by no digit.
    void polygonsSmallerThanTheSegmentsPrecision_data() { everyPolygonForm(); }
    void polygonsSmallerThanTheSegmentsPrecision()
    {
        QFETCH(const PolygonUses*, uses);
        QFETCH(bool, decidesExactly);
        RandomNumbers random(8);
        const auto whole = [&random] { return double(random.integer(-3, 3)); };
        const auto any = [&random] { return random.uniform(-3, 3); };
        const auto point = [](const auto& number) {
            const double x = number();
            return glm::dvec2(x, number());
        };
        for (int i = 0; i < 5'000; ++i) {
            const auto way = point(whole);
            const double digit = i % 2 == 0 ? 0x1p-1074 : 0x1p-60;
            std::vector<glm::dvec2> points{way * digit}; // a corner on the segment, mostly
            for (int j = random.integer(0, 4); j > 0; --j)
                points.push_back((i % 4 == 3 ? point(any) : point(whole)) * digit);
            const auto polygon = hullOf(points);
            const Segment s{way * -2.75, random.integer(0, 1) ? way * 2.75 : glm::dvec2(0, 0)};
            const auto wrong = fault(clipOne(*uses, s, polygon), s, polygon, decidesExactly);
            VERIFY_OR_SAY(wrong.empty(), (wrong + " for " + exactly(s, polygon)).c_str());
        }
    }

    // So thin that its long edges and their normals coincide; only the box tells them apart.
    void besideTheTipOfANeedle_data() { everyPolygonForm(); }
    void besideTheTipOfANeedle()
    {
        QFETCH(const PolygonUses*, uses);
        QFETCH(bool, decidesExactly);
        RandomNumbers random(9);
        for (int i = 0; i < 2'000; ++i) {
            const double at = random.uniform(0.5, 2), width = std::exp2(random.integer(-54, -50));
            const auto side = [&] { return at + width * random.integer(-6, 6); };
            const double low = side(), beyond = 1 + std::exp2(random.uniform(-52, 2));
            std::vector<glm::dvec2> points{{1, at}, {0, low}, {0, side()}};
            Segment s{{beyond, at + random.uniform(0.1, 2)}, {beyond, at - random.uniform(0.1, 2)}};
            if (i % 2 == 0)
                std::swap(s.a, s.b);
            if (i % 4 < 2)
                for (auto* point : {&points[0], &points[1], &points[2], &s.a, &s.b})
                    std::swap(point->x, point->y);
            const auto polygon = hullOf(points);
            const auto wrong = fault(clipOne(*uses, s, polygon), s, polygon, decidesExactly);
            VERIFY_OR_SAY(wrong.empty(), (wrong + " for " + exactly(s, polygon)).c_str());
        }
    }

    // "if tL < 1 and tE == tL: x1 = x2, y1 = y2" of the pseudo-code.
    void aContactTakesTheOtherEnd()
    {
        const ConvexPolygon square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
        const Trace trace = findAlgorithm("cyrus-beck")->polygon->trace({{0, 2}, {2, 0}}, square);
        QCOMPARE(trace.outcome, Outcome::Visible);
        QCOMPARE(trace.visible.a, trace.visible.b);
        QCOMPARE(std::ranges::count(trace.steps, "contact", &Step::label), 1);
    }

    // The products underflow, but the sign of a point on the line is known all the same.
    void anEndOnTheLineIsRecognisedByItsSign()
    {
        const Cross<double> beside{0, -1}, on{0, 0};
        QCOMPARE(shareBefore(beside, on), 1.0);
        QCOMPARE(shareBefore(on, beside), 0.0);
        const ConvexPolygon polygon{{{-2.75, -2.75}, {2.75, 2.75}, {-2.75, 2.75}}};
        const auto piece =
            findAlgorithm("cyrus-beck")->polygon->clip({{0x1p-1070, 0}, {}}, polygon);
        QVERIFY(piece && piece->a == glm::dvec2(0, 0) && piece->b == piece->a);
    }

    // The inner twelfths of an edge are whole numbers; what comes from outside only reaches them.
    void endsOnEdges_data() { everyPolygonForm(); }
    void endsOnEdges()
    {
        QFETCH(const PolygonUses*, uses);
        QFETCH(bool, decidesExactly);
        RandomNumbers random(7);
        const auto point = [&random](int most) {
            const int x = random.integer(-most, most);
            return glm::dvec2(x, random.integer(-most, most));
        };
        for (int i = 0; i < 5'000; ++i) {
            const auto origin = point(250);
            std::vector<glm::dvec2> points;
            for (int j = random.integer(2, 6); j > 0; --j)
                points.push_back(origin + 12.0 * point(20));
            const auto polygon = hullOf(points);
            const auto& c = polygon.corners;
            for (std::size_t j = 0; j < c.size(); ++j) {
                const auto step = (c[(j + 1) % c.size()] - c[j]) / 12.0;
                const auto end = c[j] + double(random.integer(1, 11)) * step, other = point(500);
                const Segment s = i % 2 == 0 ? Segment{end, other} : Segment{other, end};
                const auto wrong = fault(clipOne(*uses, s, polygon), s, polygon, decidesExactly);
                VERIFY_OR_SAY(wrong.empty(), (wrong + " for " + exactly(s, polygon)).c_str());
            }
        }
    }

    // A window is a polygon of four corners, or of fewer: the same hard inputs, another oracle.
    void windows_data() { everyPolygonForm(); }
    void windows()
    {
        QFETCH(const PolygonUses*, uses);
        QFETCH(bool, decidesExactly);
        for (const Family& family : families()) {
            const auto& inputs = family.inputs();
            const std::size_t step = 1 + inputs.size() / 20'001; // 20,000 of each family
            for (std::size_t i = 0; i < inputs.size(); i += step) {
                const auto& [s, w] = inputs[i];
                const ConvexPolygon polygon{{w.min, {w.max.x, w.min.y}, w.max, {w.min.x, w.max.y}}};
                const auto result = uses->clip(s, polygon);
                const auto truth = truthOf(inputs[i]);
                const auto wrong = !decidesExactly ? ::fault(result, inputs[i], truth, polygonUlps)
                                   : result.has_value() != truth.has_value()
                                       ? "seen, or not, wrongly"
                                       : fault(clipOne(*uses, s, polygon), s, polygon, true);
                VERIFY_OR_SAY(wrong.empty(), (wrong + " for " + exactly(inputs[i])).c_str());
            }
        }
    }

    void nonFiniteNumbersGiveNothing_data() { everyPolygonForm(); }
    void nonFiniteNumbersGiveNothing()
    {
        QFETCH(const PolygonUses*, uses);
        constexpr double infinity = std::numeric_limits<double>::infinity();
        for (const double by : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()})
            for (int index = 0; index < 10; ++index) {
                Segment s{{-1, 0.5}, {3, 0.5}};
                ConvexPolygon p{{{0, 0}, {2, 0}, {1, 2}}};
                QVERIFY(uses->clip(s, p));
                *std::array{&s.a.x,          &s.a.y,          &s.b.x,          &s.b.y,
                            &p.corners[0].x, &p.corners[0].y, &p.corners[1].x, &p.corners[1].y,
                            &p.corners[2].x, &p.corners[2].y}[std::size_t(index)] = by;
                QVERIFY(!uses->clip(s, p) && !clipOne(*uses, s, p));
                QVERIFY(uses->trace(s, p).outcome == Outcome::Invisible);
                QVERIFY(uses->count({&s, 1}, p) == OperationCounts{});
            }
    }

    void clipTraceAndCountAgree_data() { everyPolygonForm(); }
    void clipTraceAndCountAgree()
    {
        QFETCH(const PolygonUses*, uses);
        RandomNumbers random(5);
        for (int i = 0; i < 2'000; ++i) {
            const double size = i % 5 == 0 ? 0x1p900 : 1;
            const auto polygon = somePolygon(random, random.integer(1, 20), size);
            const Segment s = someSegment(random, polygon, size);
            const auto text = [&] { return exactly(s, polygon); };
            const auto piece = uses->clip(s, polygon);
            const auto one = clipOne(*uses, s, polygon);
            const Trace trace = uses->trace(s, polygon);
            VERIFY_OR_SAY(piece.has_value() == one.has_value(), text().c_str());
            VERIFY_OR_SAY(piece.has_value() == (trace.outcome == Outcome::Visible), text().c_str());
            if (piece)
                VERIFY_OR_SAY(sameBits(*piece, one->segment) && sameBits(*piece, trace.visible),
                              text().c_str());
            VERIFY_OR_SAY(!trace.steps.empty(), text().c_str());
            const auto cost = uses->count({&s, 1}, polygon);
            VERIFY_OR_SAY(cost.comparisons >= trace.steps.back().cost.comparisons, text().c_str());
            VERIFY_OR_SAY(cost.comparisons > 0, text().c_str());
        }
    }

    void searchingGivesTheSameAsTestingEveryCorner()
    {
        const Algorithm* skala = findAlgorithm("skala");
        RandomNumbers random(6);
        for (int i = 0; i < 3'000; ++i) {
            const double size = i % 10 == 0 ? 0x1p-600 : 1;
            const auto polygon =
                somePolygon(random, random.integer(1, i % 100 == 0 ? 1'000 : 12), size);
            std::vector<Segment> segments;
            for (int j = 0; j < 100; ++j)
                segments.push_back(someSegment(random, polygon, size));
            std::vector<Clipped> one(segments.size()), two(segments.size());
            one.resize(skala->polygon->clipAll(segments, polygon, one));
            two.resize(skala->polygonBySearch->clipAll(segments, polygon, two));
            QCOMPARE(one.size(), two.size());
            for (std::size_t j = 0; j < one.size(); ++j)
                VERIFY_OR_SAY(one[j].source == two[j].source && one[j].cut == two[j].cut
                                  && sameBits(one[j].segment, two[j].segment),
                              exactly(segments[one[j].source], polygon).c_str());
        }
    }

    // 16 times the corners: 16 times the work one by one, and a few questions more when searched.
    void searchingNeedsFewComparisons()
    {
        const Algorithm* skala = findAlgorithm("skala");
        const auto comparisons = [&](const PolygonUses& uses, int corners) {
            ConvexPolygon polygon;
            for (int i = 0; i < corners; ++i) // the same shape: a parabola
                polygon.corners.push_back(
                    {i * 4096.0 / corners, i * 4096.0 / corners * i / corners});
            const Segment s{{-100, 1'000}, {5'000, 1'500}};
            return uses.count({&s, 1}, polygon).comparisons;
        };
        QVERIFY(comparisons(*skala->polygon, 4'096) > 15 * comparisons(*skala->polygon, 256));
        QVERIFY(comparisons(*skala->polygonBySearch, 4'096)
                < 1.5 * double(comparisons(*skala->polygonBySearch, 256)));
        QVERIFY(comparisons(*skala->polygonBySearch, 4'096)
                < comparisons(*skala->polygon, 4'096) / 20);
    }

    // Of corners that are given twice, the last one starts the edge; at the end of a closed ring,
    // the first.
    void equalCornersHaveNoEdge_data() { everyPolygonForm(); }
    void equalCornersHaveNoEdge()
    {
        QFETCH(const PolygonUses*, uses);
        const ConvexPolygon polygon{{{0, 0}, {0, 0}, {2, 0}, {2, 2}, {2, 2}, {2, 2}, {0, 2}}};
        const auto upwards = clipOne(*uses, {{1, -1}, {1, 3}}, polygon);
        const auto rightwards = clipOne(*uses, {{-1, 1}, {3, 1}}, polygon);
        QVERIFY(upwards && rightwards);
        QCOMPARE(polygonEdgeOfA(upwards->cut), 2U);
        QCOMPARE(polygonEdgeOfB(upwards->cut), 6U);
        QCOMPARE(polygonEdgeOfA(rightwards->cut), 7U);
        QCOMPARE(polygonEdgeOfB(rightwards->cut), 3U);
        const ConvexPolygon ring{{{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 0}}};
        const auto down = clipOne(*uses, {{1, 3}, {1, -1}}, ring);
        QVERIFY(down);
        QCOMPARE(polygonEdgeOfA(down->cut), 3U);
        QCOMPARE(polygonEdgeOfB(down->cut), 1U);
    }

    void edgesOfLargePolygonsAreNumbered_data() { everyPolygonForm(); }
    void edgesOfLargePolygonsAreNumbered()
    {
        QFETCH(const PolygonUses*, uses);
        ConvexPolygon polygon; // on a parabola, whole numbers
        for (int i = 0; i < 70'000; ++i)
            polygon.corners.push_back({double(i), double(i) * i});
        for (const double x : {0.5, 1.5, 40'000.5, 65'533.5, 65'534.5, 69'000.5}) {
            const Segment s{{x, -1}, {x, 1e10}};
            const auto found = clipOne(*uses, s, polygon);
            QVERIFY(found);
            QCOMPARE(polygonEdgeOfA(found->cut), std::min(std::uint32_t(x) + 1, 0xffffU));
            QCOMPARE(polygonEdgeOfB(found->cut), 0xffffU);
        }
    }
};

} // namespace polygon_polygon_test

TEST_CLASS(polygon_polygon_test::PolygonTest, None)
#include "tests/clipping/polygon/polygon_test.moc"
