// SPDX-License-Identifier: GPL-3.0-or-later
// The promise of the row `exact` on convex polygons (clipping/polygon/exact.cpp), against rational
// numbers: no wrong decision, every new coordinate rounded once, the same bits in both directions.
#include "clipping/algorithm.h"
#include "clipping/batch/kernels.h"
#include "clipping/polygon/edge_table.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "tests/clipping/polygon/contract.h"
#include "tests/clipping/polygon/shapes.h"
#include "tests/test_class.h"
#include "tests/verify.h"

namespace polygon_exact_test {

using namespace clipping;

namespace {

struct Fractions {
    Rational x, y;
};
struct Part {
    Fractions a, b;
};

Fractions fractions(const glm::dvec2& p) { return {rational(p.x), rational(p.y)}; }

/// The depth of p inside the edge from c to d, times the edge's length.
Rational depth(const Fractions& c, const Fractions& d, const Fractions& p)
{
    return (d.x - c.x) * (p.y - c.y) - (d.y - c.y) * (p.x - c.x);
}

/// The part of a segment inside a strictly convex polygon: Cyrus and Beck in rational numbers.
std::optional<Part> truth(const Segment& s, const ConvexPolygon& polygon)
{
    const Fractions a = fractions(s.a), b = fractions(s.b);
    Rational from(0), to(1);
    const auto& corners = polygon.corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Fractions c = fractions(corners[i]), d = fractions(corners[(i + 1) % corners.size()]);
        const Rational ofA = depth(c, d, a), ofB = depth(c, d, b), zero(0);
        if (ofA < zero && ofB < zero)
            return std::nullopt;
        if (ofA < zero)
            from = std::max(from, Rational(ofA / (ofA - ofB)));
        else if (ofB < zero)
            to = std::min(to, Rational(ofA / (ofA - ofB)));
    }
    if (from > to)
        return std::nullopt;
    const auto at = [&](const Rational& t) {
        return Fractions{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
    };
    return Part{at(from), at(to)};
}

/// Whether x is the double nearest to the exact value, the even one in a tie.
bool nearest(double x, const Rational& exact)
{
    const Rational value = rational(x);
    if (value == exact)
        return true;
    const double neighbour = std::nextafter(x, exact > value ? INFINITY : -INFINITY);
    if (!std::isfinite(neighbour))
        return true;
    const Rational own = abs(exact - value), others = abs(exact - rational(neighbour));
    return own < others || (own == others && (std::bit_cast<std::uint64_t>(x) & 1) == 0);
}
bool nearest(const glm::dvec2& p, const Fractions& exact)
{
    return nearest(p.x, exact.x) && nearest(p.y, exact.y);
}

/// What is wrong with a result; empty if nothing is.
std::string wrongEnds(const PolygonUses& uses, const Segment& s, const ConvexPolygon& polygon)
{
    const auto expected = truth(s, polygon);
    const auto found = clipOne(uses, s, polygon);
    if (found.has_value() != expected.has_value())
        return "seen, or not, wrongly";
    if (!found)
        return {};
    if (!nearest(found->segment.a, expected->a) || !nearest(found->segment.b, expected->b))
        return "not rounded once";
    const auto backwards = clipOne(uses, {s.b, s.a}, polygon);
    if (!backwards || !sameBits(found->segment, {backwards->segment.b, backwards->segment.a}))
        return "not the same bits backwards";
    if (polygonEdgeOfA(found->cut) != polygonEdgeOfB(backwards->cut)
        || polygonEdgeOfB(found->cut) != polygonEdgeOfA(backwards->cut))
        return "not the same edges backwards";
    return {};
}

bool hasArea(const ConvexPolygon& polygon)
{
    const auto& c = polygon.corners;
    return c.size() > 2 && std::ranges::any_of(c, [&](const glm::dvec2& p) {
               return depth(fractions(c[0]), fractions(c[1]), fractions(p)) != Rational(0);
           });
}

/// The result one segment after the other.
std::vector<Clipped> oneByOne(const std::vector<Segment>& segments, const ConvexPolygon& polygon)
{
    std::vector<Clipped> all;
    for (std::size_t i = 0; i < segments.size(); ++i)
        if (auto piece = clipOne(*exactAlgorithm().polygonBySearch, segments[i], polygon)) {
            piece->source = std::uint32_t(i);
            all.push_back(*piece);
        }
    return all;
}

bool sameBits(const std::vector<Clipped>& p, const std::vector<Clipped>& q)
{
    return std::ranges::equal(p, q, [](const Clipped& one, const Clipped& other) {
        return ::sameBits(one.segment, other.segment) && one.source == other.source
               && one.cut == other.cut;
    });
}

/// Regular, with its corners on a circle.
ConvexPolygon regular(int corners, double radius, double turn)
{
    std::vector<glm::dvec2> all;
    for (int i = 0; i < corners; ++i) {
        const double angle = turn + i * 6.283185307179586 / corners;
        all.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    return hullOf(all);
}

/// Every strictly convex polygon whose corners are points of a grid: the lowest left one first.
std::vector<ConvexPolygon> convexPolygons(int size)
{
    std::vector<glm::dvec2> points;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            points.push_back({x, y});
    const auto turn = [](const glm::dvec2& p, const glm::dvec2& q, const glm::dvec2& r) {
        return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    };
    const auto angleOf = [](const glm::dvec2& d) { return std::atan2(d.y, d.x); };
    std::vector<ConvexPolygon> all;
    std::vector<glm::dvec2> chain;
    const auto extend = [&](const auto& self) -> void {
        const auto first = chain.front(), last = chain.back();
        if (chain.size() > 2 && turn(*(chain.end() - 2), last, first) > 0
            && turn(last, first, chain[1]) > 0)
            all.push_back({chain});
        for (const auto& next : points) {
            const bool later = next.y > first.y || (next.y == first.y && next.x > first.x);
            if (!later || (chain.size() > 1 && turn(*(chain.end() - 2), last, next) <= 0))
                continue;
            auto before = chain.size() > 1 ? angleOf(last - *(chain.end() - 2)) : -0.1;
            auto after = angleOf(next - last);
            before += before < -0.2 ? 6.283185307179586 : 0;
            after += after < 0 ? 6.283185307179586 : 0;
            if (after <= before) // round once
                continue;
            chain.push_back(next);
            self(self);
            chain.pop_back();
        }
    };
    for (const auto& p : points) {
        chain = {p};
        extend(extend);
    }
    return all;
}

void everyExactForm()
{
    QTest::addColumn<const PolygonUses*>("uses");
    QTest::newRow("polygon") << exactAlgorithm().polygon;
    QTest::newRow("searched") << exactAlgorithm().polygonBySearch;
    QTest::newRow("winding number") << findAlgorithm("winding-number")->polygon;
}

} // namespace

class ExactPolygonTest : public QObject {
    Q_OBJECT

    const ConvexPolygon polygonOfTheTest_{{{0, -2}, {3, -1}, {3, 1}, {1, 3}, {-2, 2}, {-2, -1}}};

    static void compareSets(const std::vector<Segment>& segments, const ConvexPolygon& polygon,
                            const std::string& name, bool ordinary)
    {
        const auto window = prepared(polygon);
        if (!window || window->flat || !window->ordinary)
            return;
        const auto expected = oneByOne(segments, polygon);
        const EdgeTable table(*window);
        for (const InstructionSet& set : instructionSets()) {
            if (!set.available)
                continue;
            std::vector<Clipped> out(segments.size());
            const auto result = set.clipPolygon(
                {segments.data(), 0, segments.size(), &*window, &table.table(), out.data()});
            out.resize(result.pieces);
            QVERIFY2(sameBits(out, expected), (name + ", " + std::string(set.name)).c_str());
            QVERIFY2(!ordinary || result.unsettled <= 1, name.c_str());
        }
        std::vector<Clipped> all(segments.size());
        all.resize(exactAlgorithm().polygon->clipAll(segments, polygon, all));
        QVERIFY2(sameBits(all, expected), name.c_str());
        all.resize(segments.size());
        all.resize(findAlgorithm("winding-number")->polygon->clipAll(segments, polygon, all));
        QVERIFY2(sameBits(all, expected), (name + ", winding number").c_str());
    }

private slots:
    // A fifth of all segments; polygons and segments are counted through, so that all pairs of
    // directions and corners occur.
    void everyConvexPolygonOfTheGrid_data() { everyExactForm(); }
    void everyConvexPolygonOfTheGrid()
    {
        QFETCH(const PolygonUses*, uses);
        const auto polygons = convexPolygons(4);
        QVERIFY(polygons.size() > 1'000);
        std::size_t next = 0;
        for (const auto& polygon : polygons)
            for (int i = 0; i < 24; ++i, next += 7) {
                const auto at = [](std::size_t n) {
                    return glm::dvec2(double(n % 6) - 1, double(n / 6 % 6) - 1);
                };
                const Segment s{at(next), at(next / 36)};
                const auto wrong = wrongEnds(*uses, s, polygon);
                VERIFY_OR_SAY(wrong.empty(), (wrong + " for " + exactly(s, polygon)).c_str());
            }
    }

    void randomPolygons_data() { everyExactForm(); }
    void randomPolygons()
    {
        QFETCH(const PolygonUses*, uses);
        RandomNumbers random(21);
        const auto anywhere = [&random](double size) {
            const double x = random.uniform(-2, 2);
            return glm::dvec2(x, random.uniform(-2, 2)) * size;
        };
        std::size_t seen = 0;
        for (int i = 0; i < 1'500; ++i) {
            const double size = std::array{1.0, 100.0, 0x1p-900, 0x1p-1070,
                                           0x1p900}[std::size_t(i % 10 < 6 ? i % 2 : i % 5)];
            const auto polygon = somePolygon(random, random.integer(3, 12), size);
            if (!hasArea(polygon))
                continue;
            const auto& c = polygon.corners;
            const auto corner = [&] {
                return c[std::size_t(random.integer(0, int(c.size()) - 1))];
            };
            for (const Segment& s :
                 {Segment{anywhere(size), anywhere(size)}, Segment{anywhere(size), corner()},
                  Segment{corner(), corner()}, Segment{anywhere(size) * 0x1p20, anywhere(size)}}) {
                const auto wrong = wrongEnds(*uses, s, polygon);
                VERIFY_OR_SAY(wrong.empty(), (wrong + " for " + exactly(s, polygon)).c_str());
                seen += truth(s, polygon).has_value();
            }
        }
        QVERIFY(seen > 1'000);
    }

    // Any finite numbers beside small whole ones: products overflow and underflow.
    void mixedNumbers_data() { everyExactForm(); }
    void mixedNumbers()
    {
        QFETCH(const PolygonUses*, uses);
        RandomNumbers random(22);
        const auto number = [&random] {
            return random.integer(0, 2) == 0 ? random.anyFinite<double>()
                                             : double(random.integer(-4, 4));
        };
        const auto point = [&] {
            const double x = number();
            return glm::dvec2(x, number());
        };
        for (int i = 0; i < 1'500; ++i) {
            std::vector<glm::dvec2> points;
            for (int j = random.integer(3, 6); j > 0; --j)
                points.push_back(point());
            const auto polygon = hullOf(points);
            const Segment s{point(), point()};
            const auto wrong = hasArea(polygon) ? wrongEnds(*uses, s, polygon) : "";
            VERIFY_OR_SAY(wrong.empty(), (wrong + " for " + exactly(s, polygon)).c_str());
        }
    }

    // As a polygon, an axis-aligned window gives the same ends as a window, bit for bit but for -0.
    void axisAlignedWindows_data() { everyExactForm(); }
    void axisAlignedWindows()
    {
        QFETCH(const PolygonUses*, uses);
        for (const auto& [name, w, segments] : hardScenes<double>(2'000))
            for (const Segment& s : segments) {
                const ConvexPolygon polygon{{w.min, {w.max.x, w.min.y}, w.max, {w.min.x, w.max.y}}};
                const auto expected = exactAlgorithm().corrected.clip(s, w);
                const auto found = uses->clip(s, polygon);
                VERIFY_OR_SAY(found == expected, (name + ": " + exactly(s, polygon)).c_str());
            }
    }

    // Every instruction set gives what the segments give one by one, bit for bit, edges included;
    // and of ordinary segments it leaves next to none to them.
    void vectorsGiveTheSameBits()
    {
        RandomNumbers random(23);
        for (const auto& [name, w, segments] : hardScenes<double>(700))
            for (const double size : {1.0, 90.0}) {
                std::vector<ConvexPolygon> polygons{
                    {{w.min, {w.max.x, w.min.y}, w.max, {w.min.x, w.max.y}}},
                    {{{-2, 0}, {0, -2}, {2, 0}, {0, 2}}},
                    {{{-size, -1}, {size, -1}, {1, size}}}};
                for (const int n : {3, 4, 7, 9, 64, 200})
                    polygons.push_back(regular(n, size, random.uniform(0, 6)));
                for (const auto& polygon : polygons)
                    compareSets(segments, polygon, name, name == "paper");
            }
        const auto& corners = polygonOfTheTest_.corners;
        std::vector<Segment> related{{{NAN, 0}, {1, 1}}, {{0, 0}, {INFINITY, 1}}};
        for (const auto& c : corners)
            for (const auto& d : corners)
                related.push_back({c, d}), related.push_back({2.0 * c - d, d});
        compareSets(related, polygonOfTheTest_, "corners", false);
    }

    // Small polygons far from the origin, whose coordinates have hardly more digits than their
    // size: segments through their corners, and past them by a last bit.
    void vectorsGiveTheSameBitsFarFromTheOrigin()
    {
        RandomNumbers random(24);
        for (int i = 0; i < 200; ++i) {
            const double x = random.uniform(-9, 9), y = random.uniform(-9, 9);
            const double width = std::ldexp(std::abs(x), -random.integer(10, 30));
            const double height = std::ldexp(std::abs(y), -random.integer(10, 30));
            const ConvexPolygon kite{
                {{x - width, y}, {x, y - height}, {x + width, y}, {x, y + height}}};
            const auto nearly = [&](double number) {
                const int bits = random.integer(-1, 1);
                return bits == 0 ? number : std::nextafter(number, bits * INFINITY);
            };
            std::vector<Segment> segments;
            for (int k = 0; k < 96; ++k) {
                const auto& c = kite.corners[std::size_t(random.integer(0, 3))];
                const glm::dvec2 d{random.uniform(-9, 9), random.uniform(-9, 9)};
                const double far = std::ldexp(1.0, random.integer(-6, 5));
                segments.push_back(
                    {{nearly(c.x + d.x), c.y + d.y}, {c.x - far * d.x, nearly(c.y - far * d.y)}});
            }
            compareSets(segments, kite, "far from the origin", false);
        }
    }

    // A new end at a corner is that corner, and has the number of the edge that begins there.
    void cornersKeepTheirNumber_data() { everyExactForm(); }
    void cornersKeepTheirNumber()
    {
        QFETCH(const PolygonUses*, uses);
        const ConvexPolygon diamond{{{0, -2}, {2, 0}, {0, 2}, {-2, 0}}};
        const auto edges = [&](const Segment& s) {
            const auto found = clipOne(*uses, s, diamond);
            return found ? std::pair(polygonEdgeOfA(found->cut), polygonEdgeOfB(found->cut))
                         : std::pair(99U, 99U);
        };
        QCOMPARE(edges({{-3, 0}, {3, 0}}), std::pair(4U, 2U));
        QCOMPARE(edges({{3, 0}, {-3, 0}}), std::pair(2U, 4U));
        QCOMPARE(edges({{3, 1}, {-1, -3}}), std::pair(2U, 1U)); // along edge 1
        QCOMPARE(edges({{2, -1}, {2, 1}}), std::pair(2U, 2U));  // a contact
        QCOMPARE(edges({{2, 1}, {2, -1}}), std::pair(2U, 2U));
        QCOMPARE(edges({{3, 0}, {2, 0}}), std::pair(2U, 0U)); // an end at the corner
    }
};

} // namespace polygon_exact_test

TEST_CLASS(polygon_exact_test::ExactPolygonTest, None)
#include "tests/clipping/polygon/exact_test.moc"
