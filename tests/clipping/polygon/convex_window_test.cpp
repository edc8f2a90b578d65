// SPDX-License-Identifier: GPL-3.0-or-later
// Polygons that are prepared once: which are taken, and that they clip as the catalogue's do.
#include "clipping/algorithm.h"

#include <QTest>

#include <clearcut/clip.h>
#include <cmath>

#include "tests/clipping/random.h"
#include "tests/clipping/same_bits.h"
#include "tests/test_class.h"

namespace polygon_convex_window_test {

using namespace clearcut;
using glm::dvec2;

namespace {

std::vector<dvec2> circle(std::size_t corners)
{
    std::vector<dvec2> all;
    for (std::size_t i = 0; i < corners; ++i) {
        const double angle = 6.283185307179586 * double(i) / double(corners);
        all.emplace_back(std::cos(angle), std::sin(angle));
    }
    return all;
}

std::vector<Segment> someSegments()
{
    Random r(3);
    std::vector<Segment> all(500);
    for (auto& [a, b] : all) {
        a = {r.between(-2, 2), r.between(-2, 2)};
        b = {r.between(-2, 2), r.between(-2, 2)};
    }
    return all;
}

std::vector<Clipped> byTheCatalogue(const std::vector<Segment>& in, const ConvexPolygon& polygon)
{
    std::vector<Clipped> out(in.size());
    out.resize(exactAlgorithm().polygon->clipAll(in, polygon, out));
    return out;
}

bool same(const std::vector<Clipped>& p, const std::vector<Clipped>& q)
{
    return std::ranges::equal(p, q, [](auto& a, auto& b) { return sameBits(a, b); });
}

} // namespace

class ConvexWindowTest : public QObject {
    Q_OBJECT

private slots:
    void itClipsAsTheCatalogueDoes()
    {
        const auto in = someSegments();
        for (const std::size_t corners : {1, 2, 3, 4, 7, 64, 200}) {
            const auto polygon = circle(corners);
            const ConvexWindow prepared = ConvexPolygon::from(polygon);
            QVERIFY2(bool(prepared), prepared.whyNot());
            QVERIFY(same(clipAll(in, prepared), byTheCatalogue(in, {polygon})));
            for (const Segment& s : in)
                QVERIFY(clip(s, prepared) == exactAlgorithm().polygon->clip(s, {polygon}));
        }
    }

    void aClockwiseOneIsTurnedRoundAndItsEdgesKeepTheirNumbers()
    {
        const auto in = someSegments();
        for (const std::size_t corners : {3, 4, 64}) {
            auto polygon = circle(corners);
            const auto expected = clipAll(in, ConvexPolygon::from(polygon));
            std::ranges::reverse(polygon);
            auto found = clipAll(in, ConvexPolygon::from(polygon));
            const auto n = static_cast<std::uint32_t>(corners);
            const auto other = [n](std::uint32_t number) { // edge i is edge n - 2 - i, modulo n
                return number == 0 ? 0 : 1 + (2 * n - 1 - number) % n;
            };
            for (Clipped& piece : found)
                piece.cut = polygonCutAt(other(polygonEdgeOfA(piece.cut)),
                                         other(polygonEdgeOfB(piece.cut)));
            QVERIFY(same(found, expected));
        }
    }

    void whatIsNoConvexPolygonIsRefusedWithItsReason_data()
    {
        QTest::addColumn<std::vector<dvec2>>("corners");
        QTest::addColumn<QString>("reason");
        QTest::newRow("nothing") << std::vector<dvec2>{} << "at least one corner";
        QTest::newRow("NaN") << std::vector<dvec2>{{0, 0}, {NAN, 0}} << "not finite";
        QTest::newRow("concave") << std::vector<dvec2>{{0, 0}, {4, 0}, {1, 1}, {0, 4}}
                                 << "not convex";
        QTest::newRow("pentagram")
            << std::vector<dvec2>{{0, 3}, {-2, -3}, {3, 1}, {-3, 1}, {2, -3}} << "more than once";
    }
    void whatIsNoConvexPolygonIsRefusedWithItsReason()
    {
        QFETCH(std::vector<dvec2>, corners);
        QFETCH(QString, reason);
        for (int turn = 0; turn < 2; ++turn, std::ranges::reverse(corners)) {
            const ConvexWindow refused = ConvexPolygon::from(corners);
            QVERIFY(!refused);
            QVERIFY2(QString(refused.whyNot()).contains(reason), refused.whyNot());
            QVERIFY(!clip(Segment{{-9, 1}, {9, 1}}, refused));
            QVERIFY(clipAll(someSegments(), refused).empty());
        }
    }

    void cornersOfAnyPointsWillDo()
    {
        const std::vector<QPointF> corners{{0, 0}, {1, 0}, {0, 1}};
        const auto piece = clip(Segment{{-1, 0.25}, {2, 0.25}}, ConvexPolygon::from(corners));
        QVERIFY(piece && *piece == (Segment{{0, 0.25}, {0.75, 0.25}}));
    }
};

} // namespace polygon_convex_window_test

TEST_CLASS(polygon_convex_window_test::ConvexWindowTest, None)
#include "tests/clipping/polygon/convex_window_test.moc"
