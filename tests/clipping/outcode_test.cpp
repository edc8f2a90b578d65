// SPDX-License-Identifier: GPL-3.0-or-later
#include "clipping/counted.h"
#include "clipping/outcode.h"

#include <QTest>

#include <limits>

#include "tests/test_class.h"

namespace outcode_test {

using namespace clipping;

class OutcodeTest : public QObject {
    Q_OBJECT

private slots:
    void everyRegionHasItsBits()
    {
        const Window window{{0, 0}, {4, 3}};
        const double x[]{-1, 2, 5}, y[]{-1, 1, 4};
        const unsigned column[]{outcode::left, 0, outcode::right},
            row[]{outcode::bottom, 0, outcode::top};
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k < 3; ++k)
                QCOMPARE(outcodeOf(glm::dvec2(x[i], y[k]), window), column[i] | row[k]);
    }

    void theEdgesAreInside()
    {
        const Window window{{0, 0}, {4, 3}};
        for (const glm::dvec2 corner : {window.min, window.max, {0, 3}, {4, 0}, {-0.0, -0.0}})
            QCOMPARE(outcodeOf(corner, window), 0U);
        QCOMPARE(outcodeOf(glm::dvec2(std::nextafter(4.0, 5.0), -5e-324), window),
                 outcode::right | outcode::bottom);
    }

    void theThirdAxisHasTheNextTwoBits()
    {
        const Window3 box{{0, 0, 0}, {1, 1, 1}};
        QCOMPARE(outcodeOf(glm::dvec3(0, 0, -1), box), 16U);
        QCOMPARE(outcodeOf(glm::dvec3(2, 0, 2), box), outcode::right | 32U);
    }

    void aNumberThatIsNotOneIsBeyondNothing()
    {
        const double infinite = std::numeric_limits<double>::infinity();
        QCOMPARE(sideBeyond(std::numeric_limits<double>::quiet_NaN(), 0.0, 1.0), 0U);
        QCOMPARE(sideBeyond(-infinite, 0.0, 1.0), outcode::left);
        QCOMPARE(sideBeyond(infinite, 0.0, 1.0), outcode::right);
    }

    void countedNumbersHaveTheSameSides()
    {
        for (const double v : {-1.0, 0.0, 0.5, 1.0, 2.0})
            QCOMPARE(sideBeyond(Counted<double>(v), Counted<double>(0), Counted<double>(1)),
                     sideBeyond(v, 0.0, 1.0));
    }
};

} // namespace outcode_test

TEST_CLASS(outcode_test::OutcodeTest, None)
#include "tests/clipping/outcode_test.moc"
