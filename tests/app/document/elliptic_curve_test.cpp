// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/arc_curves.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <numbers>

#include "tests/test_class.h"

namespace document_elliptic_curve_test {

using namespace app;

namespace {

Bezier curveOf(const EllipseArc& arc)
{
    std::vector<PathSegment> segments;
    const Point from = arc.at(arc.angle), to = arc.at(arc.angle + arc.sweep);
    appendCurves(segments, arc, from, to);
    return {from, segments[0].control1, segments[0].control2, segments[0].to};
}

double far(const EllipseArc& arc, const EllipseArc& found)
{
    double most = 0;
    for (double angle = 0; angle < 6; angle += 0.25)
        most = std::max(most, glm::distance(arc.at(angle), onEllipse(found, arc.at(angle))));
    return most;
}

} // namespace

class EllipticCurveTest : public QObject {
    Q_OBJECT

private slots:
    void partsOfEllipses_data()
    {
        QTest::addColumn<double>("size");
        QTest::addColumn<double>("degrees");
        for (const double size : {1e-6, 1.0, 1e6})
            for (const double degrees : {10.0, 37.0, 89.9, 90.0, -45.0})
                QTest::addRow("%g, %g°", size, degrees) << size << degrees;
    }
    void partsOfEllipses()
    {
        QFETCH(double, size);
        QFETCH(double, degrees);
        const double sweep = degrees * std::numbers::pi / 180;
        const EllipseArc arc{size * Point(3, -2), size * Point(5, 1), size * Point(-0.5, 2), 0.3,
                             sweep};
        const auto found = ellipseOf(curveOf(arc));
        QVERIFY(found);
        QVERIFY2(far(arc, *found) < 1e-9 * size, QByteArray::number(far(arc, *found) / size));
    }

    void othersHaveNone()
    {
        const Bezier straight{{0, 0}, {1, 1}, {2, 2}, {3, 3}},
            point{{1, 1}, {1, 1}, {1, 1}, {1, 1}};
        const Bezier wave{{0, 0}, {1, 2}, {2, -2}, {3, 0}},
            uneven{{0, 0}, {0, 1}, {0.9, 2}, {2, 2}};
        const Bezier loop{{0, 0}, {5, 4}, {-3, 4}, {2, 0}},
            flat{{0, 0}, {0, 1e-300}, {1, 0}, {1, 0}};
        for (const Bezier& curve : {straight, point, wave, uneven, loop, flat})
            QVERIFY(!ellipseOf(curve));
    }
};

} // namespace document_elliptic_curve_test

TEST_CLASS(document_elliptic_curve_test::EllipticCurveTest, Core)
#include "tests/app/document/elliptic_curve_test.moc"
