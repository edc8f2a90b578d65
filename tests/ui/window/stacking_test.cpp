// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/arrangement.h"

#include <QTest>

#include <vector>

#include "tests/test_class.h"

namespace window_stacking_test {

class StackingTest : public QObject {
    Q_OBJECT

private slots:
    void lowestPanelsShareAPlace_data()
    {
        QTest::addColumn<int>("room");
        QTest::addColumn<int>("tabs");
        QTest::newRow("all fit") << 1000 << 0;
        QTest::newRow("all just fit") << 500 << 0;
        QTest::newRow("the lowest two as high as the higher") << 499 << 2;
        QTest::newRow("the lowest two just fit") << 400 << 2;
        QTest::newRow("the lowest three") << 399 << 3;
        QTest::newRow("the lowest three just fit") << 350 << 3;
        QTest::newRow("all") << 349 << 4;
        QTest::newRow("all, which do not fit") << 10 << 4;
    }
    void lowestPanelsShareAPlace()
    {
        QFETCH(int, room);
        const std::vector needed{200, 50, 150, 100};
        QTEST(ui::lowerTabs(needed, room), "tabs");
    }
    void fewPanelsHaveNoTabs()
    {
        QCOMPARE(ui::lowerTabs({}, -1), 0);
        const int one = 100;
        QCOMPARE(ui::lowerTabs({&one, 1}, 10), 0);
        const std::vector two{300, 300};
        QCOMPARE(ui::lowerTabs(two, 600), 0);
        QCOMPARE(ui::lowerTabs(two, 599), 2);
    }
};

} // namespace window_stacking_test

TEST_CLASS(window_stacking_test::StackingTest, None)
#include "tests/ui/window/stacking_test.moc"
