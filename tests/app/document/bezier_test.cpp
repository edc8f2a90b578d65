// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/bezier.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <cmath>

#include "tests/test_class.h"

namespace document_bezier_test {

using namespace app;

class BezierTest : public QObject {
    Q_OBJECT

private slots:
    void theNearestParameter()
    {
        const Bezier curve{{0, 0}, {0, 4}, {6, 5}, {8, 1}};
        for (double t = 0; t <= 1; t += 0.0625)
            QVERIFY(std::abs(nearestParameter(curve, curve.at(t)) - t) < 1e-9);
        QCOMPARE(nearestParameter(curve, {9, -8}), 1.0);
        QVERIFY(nearestParameter(curve, {-1, -8}) < 1e-9);
    }
    void ofALoopTheNearerPartIsFound()
    {
        const Bezier loop{{0, 0}, {30, 20}, {-20, 20}, {10, 0}}; // crosses itself
        for (double t = 0; t <= 1; t += 0.03125) {
            const Point p = loop.at(t) + Point(0.01, 0.02);
            double least = 1;
            for (int i = 0; i <= 10'000; ++i)
                least = std::min(least, glm::distance(loop.at(i / 1e4), p));
            QVERIFY(glm::distance(loop.at(nearestParameter(loop, p, 32)), p) <= least + 1e-9);
        }
    }
    void itEnds()
    {
        const Bezier point{{1, 1}, {1, 1}, {1, 1}, {1, 1}}, cusp{{0, 0}, {4, 4}, {0, 4}, {4, 0}};
        for (const Point& p :
             {Point(1, 1), Point(NAN, 0), Point(INFINITY, 0), Point(1e300, -1e300)})
            for (const Bezier& curve : {point, cusp}) {
                const double t = nearestParameter(curve, p);
                QVERIFY(t >= 0 && t <= 1);
            }
    }
};

} // namespace document_bezier_test

TEST_CLASS(document_bezier_test::BezierTest, Core)
#include "tests/app/document/bezier_test.moc"
