// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/painted_part.h"

#include <QTest>

#include "tests/test_class.h"

namespace view_gaps_test {

using clipping::Clipped;
using clipping::cutAt;
using clipping::Edge;

class GapsTest : public QObject {
    Q_OBJECT

private slots:
    void gapsAndPiecesAreTheLine()
    {
        const clipping::Segment line{{0, 0}, {10, 0}};
        const Clipped first{{{0, 0}, {2, 0}}, 7, cutAt(Edge::NoEdge, Edge::Right)};
        const Clipped middle{{{4, 0}, {5, 0}}, 7, cutAt(Edge::Left, Edge::Right)};
        const Clipped last{{{8, 0}, {10, 0}}, 7, cutAt(Edge::Left, Edge::NoEdge)};
        const Clipped touch{{{6, 0}, {6, 0}}, 7, cutAt(Edge::Left, Edge::Left)};
        QVERIFY(equal(gaps(line, {}), {{line, 7, 0}}));
        QVERIFY(equal(gaps(line, {{line, 7, 0}}), {}));
        QVERIFY(equal(gaps(line, {touch}), {{line, 7, 0}}));
        const std::vector<Clipped> between{{{{2, 0}, {4, 0}}, 7, cutAt(Edge::Right, Edge::Left)},
                                           {{{5, 0}, {8, 0}}, 7, cutAt(Edge::Right, Edge::Left)}};
        QVERIFY(equal(gaps(line, {first, middle, last}), between));
        QVERIFY(equal(gaps(line, {first, middle, touch, last}), between));
        QVERIFY(equal(gaps(line, {middle}),
                      {{{{0, 0}, {4, 0}}, 7, cutAt(Edge::NoEdge, Edge::Left)},
                       {{{5, 0}, {10, 0}}, 7, cutAt(Edge::Right, Edge::NoEdge)}}));
    }
    void aPieceThatRunsTheOtherWayIsTurned()
    {
        const clipping::Segment line{{0, 0}, {10, 0}};
        QVERIFY(equal(gaps(line, {{{{5, 0}, {0, 0}}, 7, cutAt(Edge::Right, Edge::NoEdge)}}),
                      {{{{5, 0}, {10, 0}}, 7, cutAt(Edge::Right, Edge::NoEdge)}}));
    }
    void aPointIsThereOrMissing()
    {
        const clipping::Segment point{{3, 3}, {3, 3}};
        QVERIFY(equal(gaps(point, {}), {{point, 7, 0}}));
        QVERIFY(equal(gaps(point, {{point, 7, 0}}), {}));
    }

private:
    static std::vector<Clipped> gaps(const clipping::Segment& line,
                                     const std::vector<Clipped>& kept)
    {
        std::vector<Clipped> all;
        app::appendGaps(line, 7, kept, all);
        return all;
    }
    static bool equal(const std::vector<Clipped>& a, const std::vector<Clipped>& b)
    {
        return std::ranges::equal(a, b, [](const Clipped& p, const Clipped& q) {
            return p.segment.a == q.segment.a && p.segment.b == q.segment.b && p.source == q.source
                   && p.cut == q.cut;
        });
    }
};

} // namespace view_gaps_test

TEST_CLASS(view_gaps_test::GapsTest, None)
#include "tests/app/view/gaps_test.moc"
