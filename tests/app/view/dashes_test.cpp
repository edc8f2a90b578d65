// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/caps.h"

#include <QLineF>
#include <QTest>

#include "tests/test_class.h"

namespace view_dashes_test {

class DashesTest : public QObject {
    Q_OBJECT

private slots:
    void goesRoundCorners()
    {
        const std::vector<QPointF> corner{{0, 0}, {10, 0}, {10, 10}};
        const std::vector<double> pattern{8, 2};
        const auto all = app::dashes(corner, pattern, 0, 0.1);
        QCOMPARE(all.size(), std::size_t(2));
        QCOMPARE(all[0], (std::vector<QPointF>{{0, 0}, {8, 0}}));
        QCOMPARE(all[1], (std::vector<QPointF>{{10, 0}, {10, 8}}));
    }
    void startsWithinThePattern()
    {
        const std::vector<QPointF> line{{0, 0}, {10, 0}};
        const std::vector<double> pattern{4, 2};
        const auto all = app::dashes(line, pattern, 3, 0.1); // 1 left of the dash, then 2 gap
        QCOMPARE(all.size(), std::size_t(3));
        QCOMPARE(all[0], (std::vector<QPointF>{{0, 0}, {1, 0}}));
        QCOMPARE(all[1], (std::vector<QPointF>{{3, 0}, {7, 0}}));
        QCOMPARE(all[2], (std::vector<QPointF>{{9, 0}, {10, 0}}));
        QCOMPARE(app::dashes(line, pattern, -3, 0.1), all); // the period is 6
    }
    void anOddPatternIsTakenTwice()
    {
        const std::vector<QPointF> line{{0, 0}, {9, 0}};
        const std::vector<double> pattern{2};
        const auto all = app::dashes(line, pattern, 0, 0.1);
        QCOMPARE(all.size(), std::size_t(3));
        QCOMPARE(all[2], (std::vector<QPointF>{{8, 0}, {9, 0}}));
    }
    void aDashMayHaveNoLength()
    {
        const std::vector<QPointF> line{{0, 0}, {4, 0}};
        const std::vector<double> dots{0, 2};
        QCOMPARE(app::dashes(line, dots, 0, 0.1).size(), std::size_t(3)); // at 0, 2 and 4
    }
    void whatIsTooFineOrWrongIsSolid()
    {
        const std::vector<QPointF> line{{0, 0}, {1e6, 0}};
        for (const std::vector<double>& pattern :
             {std::vector{1e-9, 1e-9}, {0.0, 0.0}, {-1.0, 3.0}, {}}) {
            const auto all = app::dashes(line, pattern, 0, 1);
            QCOMPARE(all.size(), std::size_t(1));
            QCOMPARE(all[0], line);
        }
    }
};

} // namespace view_dashes_test

TEST_CLASS(view_dashes_test::DashesTest, None)
#include "tests/app/view/dashes_test.moc"
