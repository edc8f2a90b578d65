// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/direction.h"
#include "app/drawing/frame_measures.h"

#include <QTest>

#include <glm/geometric.hpp>

#include "tests/test_class.h"

namespace drawing_frame_measures_test {

using namespace app;

namespace {

const Point from(10, 20), x = directionOf(30), y(-x.y, x.x);
const GestureStart start{from, from + x * 7.0};

bool same(const Point& a, const Point& b) { return glm::distance(a, b) < 1e-12; }

} // namespace

class FrameMeasuresTest : public QObject {
    Q_OBJECT

private slots:
    void sidesAreMeasuredAlongTheRotatedAxes()
    {
        const Point to = from + x * 30.0 - y * 40.0;
        const auto& box = rotatedWidthAndHeight(Anchor::Opposite);
        QVERIFY(std::abs(box.values(start, to)[0] - 30) < 1e-12);
        QVERIFY(std::abs(box.values(start, to)[1] - 40) < 1e-12);
        const auto& centred = rotatedWidthAndHeight(Anchor::Centre);
        QVERIFY(std::abs(centred.values(start, to)[0] - 60) < 1e-12);
        QVERIFY(same(box.end(start, to, {}), to));
        QVERIFY(same(box.end(start, to, {12}), from + x * 12.0 - y * 40.0));
        QVERIFY(same(centred.end(start, to, {12, 8}), from + x * 6.0 - y * 4.0));
    }
    void oneSideLeavesTheOther()
    {
        const Point to = from - x * 30.0 + y * 5.0;
        QVERIFY(same(rotatedSideLength(0, Anchor::Opposite).end(start, to, {12}),
                     from - x * 12.0 + y * 5.0));
        QVERIFY(same(rotatedSideLength(1, Anchor::Centre).end(start, to, {12}),
                     from - x * 30.0 + y * 6.0));
        QVERIFY(std::abs(rotatedSideLength(1, Anchor::Centre).values(start, to)[0] - 10) < 1e-12);
        QCOMPARE(rotatedSideLength(0, Anchor::Opposite).fields.size(), 1u);
    }
};

} // namespace drawing_frame_measures_test

TEST_CLASS(drawing_frame_measures_test::FrameMeasuresTest, Core)
#include "tests/app/drawing/frame_measures_test.moc"
