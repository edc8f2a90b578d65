// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/numbers.h"

#include <QLocale>
#include <QTest>

#include "tests/deep.h"
#include "tests/test_class.h"

namespace base_numbers_test {

class NumbersTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale(QLocale::English)); }

    void groupsAndMinus()
    {
        QCOMPARE(app::numberText(1234567.891, 2), "1,234,567.89");
        QCOMPARE(app::numberText(-3, 2), QStringLiteral("−3.00"));
        QCOMPARE(app::numberText(-0.001, 2), "0.00");
        QCOMPARE(app::countText(49696), "49,696");
        QCOMPARE(app::linesText(0), "0 lines");
        QCOMPARE(app::linesText(1), "1 line");
        QCOMPARE(app::linesText(49696), "49,696 lines");
    }
    // The size of a window is the difference of its edges: 31.56499999999999773.
    void aHalfIsRoundedAwayFromZero()
    {
        QCOMPARE(app::numberText(131.565 - 100, 2), "31.57");
        QCOMPARE(app::numberText(31.565, 2), "31.57");
        QCOMPARE(app::numberText(2.675, 2), "2.68");
        QCOMPARE(app::numberText(-0.125, 2), QStringLiteral("−0.13"));
        QCOMPARE(app::numberText(0.5, 0), "1");
        QCOMPARE(app::numberText(1e9 + 0.565, 2), "1,000,000,000.57");
        QCOMPARE(app::numberText(31.5649, 2), "31.56");
        QCOMPARE(app::numberText(31.56499999, 2), "31.56");
        QCOMPARE(app::numberText(9007199254740992, 2), "9,007,199,254,740,992.00");
        QCOMPARE(app::numberText(0.1, 16), "0.1000000000000000");
    }
    void followsTheLocale()
    {
        QLocale::setDefault(QLocale(QLocale::German));
        QCOMPARE(app::numberText(1234.5, 2), "1.234,50");
        QLocale::setDefault(QLocale(QLocale::English));
    }
    void lengths()
    {
        QCOMPARE(app::lengthText(210, app::Unit::Mm, 1), QStringLiteral("210.00\u00a0mm"));
        QCOMPARE(app::lengthText(96, app::Unit::Inch, 25.4 / 96), QStringLiteral("1.000\u00a0in"));
        QCOMPARE(app::lengthNumber(1, app::Unit::Mm, 1, 1), "1.000");
        QCOMPARE(app::sizeText({210, 168}, app::Unit::Mm, 1),
                 QStringLiteral("210.00 × 168.00\u00a0mm"));
    }
    void thereAndBack()
    {
        for (const auto& unit : app::units())
            if (unit.unit != app::Unit::Percent)
                QCOMPARE(app::fromUnit(app::inUnit(12.5, unit.unit, 0.3), unit.unit, 0.3), 12.5);
    }
    void pixelsAreExactWhereAUnitIsOne()
    {
        for (int size = 1; size <= 5000; size += tests::caseStep()) {
            QCOMPARE(app::fromUnit(size, app::Unit::Px, 25.4 / 96), double(size));
            QCOMPARE(app::inUnit(size, app::Unit::Px, 25.4 / 96), double(size));
        }
    }
    void times()
    {
        QCOMPARE(app::millisecondsText(0.004), "< 0.01 ms");
        QCOMPARE(app::millisecondsText(0.417), "0.42 ms");
        QCOMPARE(app::millisecondsText(12.34), "12.3 ms");
        QCOMPARE(app::millisecondsText(1234.4), "1,234 ms");
    }
};

} // namespace base_numbers_test

TEST_CLASS(base_numbers_test::NumbersTest, None)
#include "tests/app/base/numbers_test.moc"
