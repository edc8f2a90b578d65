// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/judge/points.h"

#include <QTest>

#include <random>

#include "tests/test_class.h"

namespace judge_points_test {

using namespace app::plug_in;

namespace {

QString textOf(const CategoryCount& c)
{
    return QStringLiteral("%1 of %2 judged; %3 of %4 visible and %5 of %6 others wrong: %7 points")
        .arg(c.judged)
        .arg(c.lines)
        .arg(c.wrongVisible)
        .arg(c.visible)
        .arg(c.wrong - c.wrongVisible)
        .arg(c.judged - c.visible)
        .arg(pointsOf(c));
}

/// Whether at least so many tenths of the lines are right, and tested: in whole numbers.
bool reaches(const CategoryCount& c, std::size_t tenths, std::size_t wrong, std::size_t all)
{
    return all == 0 ? 10 * c.judged >= tenths * c.lines
                    : 10 * (all - wrong) * c.judged >= tenths * all * c.lines;
}

} // namespace

class PointsTest : public QObject {
    Q_OBJECT

private slots:
    void aPointIsAWholeTenthOfEachKindOfLine()
    {
        std::mt19937_64 random(1);
        const auto upTo = [&](std::size_t most) { return random() % (most + 1); };
        for (int i = 0; i < 20'000; ++i) {
            CategoryCount c;
            c.lines = 1 + upTo(i % 2 ? 30 : 100'000);
            c.judged = i % 3 ? c.lines : upTo(c.lines);
            c.visible = upTo(c.judged);
            c.wrongVisible = upTo(c.visible);
            c.wrong = c.wrongVisible + upTo(c.judged - c.visible);
            const auto points = std::size_t(pointsOf(c));
            const auto earns = [&](std::size_t tenths) {
                return reaches(c, tenths, c.wrongVisible, c.visible)
                       && reaches(c, tenths, c.wrong - c.wrongVisible, c.judged - c.visible);
            };
            const bool all = c.wrong == 0 && c.judged == c.lines;
            QVERIFY2(all == (points == fullPoints), qPrintable(textOf(c)));
            QVERIFY2(all || earns(points), qPrintable(textOf(c)));
            QVERIFY2(points + 1 >= fullPoints || !earns(points + 1), qPrintable(textOf(c)));
        }
    }

    void lineByLine_data()
    {
        QTest::addColumn<QList<int>>("count"); // lines, judged, visible, wrong visible, wrong
        QTest::addColumn<int>("points");
        QTest::newRow("all right") << QList{100, 100, 60, 0, 0} << 10;
        QTest::newRow("one wrong") << QList{100, 100, 60, 1, 1} << 9;
        QTest::newRow("one of ten right") << QList{10, 10, 10, 9, 9} << 1;
        QTest::newRow("no visible line right") << QList{100, 100, 60, 60, 60} << 0;
        QTest::newRow("no other line right") << QList{100, 100, 60, 0, 40} << 0;
        QTest::newRow("half tested, all of it right") << QList{100, 50, 30, 0, 0} << 5;
        QTest::newRow("half tested, half of it right") << QList{100, 50, 50, 25, 25} << 2;
        QTest::newRow("nothing tested") << QList{100, 0, 0, 0, 0} << 0;
    }
    void lineByLine()
    {
        QFETCH(QList<int>, count);
        CategoryCount c;
        c.lines = std::size_t(count[0]);
        c.judged = std::size_t(count[1]);
        c.visible = std::size_t(count[2]);
        c.wrongVisible = std::size_t(count[3]);
        c.wrong = std::size_t(count[4]);
        QTEST(pointsOf(c), "points");
    }
};

} // namespace judge_points_test

TEST_CLASS(judge_points_test::PointsTest, Gui)
#include "tests/app/judge/points_test.moc"
