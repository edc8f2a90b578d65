// SPDX-License-Identifier: GPL-3.0-or-later
// The contract of clipping/outside.h, for every algorithm of the catalogue.
#include "clipping/algorithm.h"
#include "clipping/outside.h"

#include <QTest>

#include <random>

#include "tests/test_class.h"

namespace outside_test {

using namespace clipping;

namespace {

constexpr Window window{{-1, -2}, {3, 2}};

std::vector<Clipped> insideOf(const std::vector<Segment>& in, const Algorithm& algorithm)
{
    std::vector<Clipped> inside(in.size());
    inside.resize(algorithm.corrected.clipAll(in, window, inside));
    return inside;
}

std::vector<Clipped> outsideOf(const std::vector<Segment>& in, const std::vector<Clipped>& inside)
{
    std::vector<Clipped> outside(in.size() + inside.size());
    outside.resize(outsideAll(in, inside, outside));
    return outside;
}

// Small integers, so that touches, edges, corners and points are frequent.
std::vector<Segment> segments(std::size_t count)
{
    std::mt19937 random(5);
    std::uniform_int_distribution<int> number(-4, 6);
    std::vector<Segment> all(count);
    for (Segment& s : all)
        s = {{number(random), number(random)}, {number(random), number(random)}};
    return all;
}

// The chain a = p0, p1, ... = b of the pieces of one segment, inside and outside, in order along
// it.
bool chains(const Segment& whole, std::vector<Segment> pieces)
{
    const auto along = [&](const Segment& s) {
        const auto d = whole.b - whole.a;
        return (s.a.x - whole.a.x) * d.x + (s.a.y - whole.a.y) * d.y;
    };
    std::ranges::stable_sort(pieces, {}, along);
    glm::dvec2 last = whole.a;
    for (const Segment& piece : pieces) {
        if (piece.a != last)
            return false;
        last = piece.b;
    }
    return last == whole.b;
}

} // namespace

class OutsideTest : public QObject {
    Q_OBJECT

private slots:
    void insideAndOutsideTogetherAreTheWhole_data()
    {
        QTest::addColumn<QByteArray>("key");
        for (const Algorithm& a : algorithms())
            QTest::newRow(a.key.data()) << QByteArray(a.key.data(), qsizetype(a.key.size()));
    }

    void insideAndOutsideTogetherAreTheWhole()
    {
        QFETCH(QByteArray, key);
        const Algorithm& algorithm =
            *findAlgorithm(std::string_view(key.data(), std::size_t(key.size())));
        const auto in = segments(20'000);
        const auto inside = insideOf(in, algorithm), outside = outsideOf(in, inside);
        auto i = inside.begin(), o = outside.begin();
        for (std::uint32_t source = 0; source < in.size(); ++source) {
            std::vector<Segment> pieces;
            bool touch = false;
            for (; i != inside.end() && i->source == source; ++i) {
                touch = i->segment.a == i->segment.b && in[source].a != in[source].b;
                if (!touch)
                    pieces.push_back(i->segment);
            }
            for (; o != outside.end() && o->source == source; ++o) {
                QVERIFY(o->segment.a != o->segment.b || in[source].a == in[source].b);
                pieces.push_back(o->segment);
            }
            QVERIFY2(chains(in[source], pieces), qPrintable(QString("segment %1").arg(source)));
            if (touch)
                QVERIFY(pieces == std::vector{in[source]});
        }
        QVERIFY(i == inside.end() && o == outside.end());
    }

    void namesTheEdgesOfItsCuts()
    {
        const std::vector<Segment> in{{{-5, 0}, {5, 0}}};
        const auto outside = outsideOf(in, insideOf(in, algorithms().back()));
        QCOMPARE(outside.size(), 2u);
        QVERIFY(outside[0].segment == (Segment{{-5, 0}, {-1, 0}}));
        QCOMPARE(outside[0].cut, cutAt(Edge::NoEdge, Edge::Left));
        QVERIFY(outside[1].segment == (Segment{{3, 0}, {5, 0}}));
        QCOMPARE(outside[1].cut, cutAt(Edge::Right, Edge::NoEdge));
    }

    void aReversedPieceIsStillCutOut()
    {
        const std::vector<Segment> in{{{-2, 0.5}, {7, 1}}, {{7, 1}, {-2, 0.5}}};
        const Algorithm& skala = *findAlgorithm("skala");
        std::vector<Clipped> inside(in.size());
        inside.resize(skala.published->clipAll(in, window, inside));
        QCOMPARE(inside.size(), 2u);
        QVERIFY(inside[0].segment.a.x > inside[0].segment.b.x); // reversed
        const auto outside = outsideOf(in, inside);
        QCOMPARE(outside.size(), 4u);
        for (const Clipped& piece : outside)
            QVERIFY((piece.segment.a.x <= -1 && piece.segment.b.x <= -1)
                    || (piece.segment.a.x >= 3 && piece.segment.b.x >= 3));
        QCOMPARE(outside[0].cut, cutAt(Edge::NoEdge, Edge::Left));
    }

    void aTouchLeavesTheSegmentWholeAnEdgeBelongsToTheInside()
    {
        const std::vector<Segment> in{
            {{2, 3}, {4, 1}}, {{-1, -9}, {-1, 9}}, {{0, 2}, {1, 2}}, {{7, 7}, {7, 7}}};
        const auto outside = outsideOf(in, insideOf(in, algorithms().back()));
        QCOMPARE(outside.size(), 4u);
        QVERIFY(outside[0].segment == in[0] && outside[0].cut == 0);
        QVERIFY(outside[1].segment == (Segment{{-1, -9}, {-1, -2}}));
        QVERIFY(outside[2].segment == (Segment{{-1, 2}, {-1, 9}}));
        QVERIFY(outside[3].segment == in[3] && outside[3].source == 3u);
    }
};

} // namespace outside_test

TEST_CLASS(outside_test::OutsideTest, None)
#include "tests/clipping/outside_test.moc"
