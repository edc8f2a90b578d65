// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/picking.h"
#include "app/view/simplify.h"

#include <QTest>

#include <cmath>

#include "tests/test_class.h"

namespace view_simplify_test {

class SimplifyTest : public QObject {
    Q_OBJECT

private slots:
    void fewPointsStayWithinTheTolerance()
    {
        std::vector<app::Point> wave;
        for (int i = 0; i <= 1000; ++i)
            wave.push_back({i * 0.5, 40 * std::sin(i * 0.02)});
        const auto few = app::simplified(wave, 0.5);
        QVERIFY(few.size() > 10 && few.size() < 100);
        QCOMPARE(few.front(), wave.front());
        QCOMPARE(few.back(), wave.back());
        for (const app::Point& p : wave) {
            double least = 1e9;
            for (std::size_t i = 1; i < few.size(); ++i)
                least = std::min(least, app::distance(p, {few[i - 1], few[i]}));
            QVERIFY(least <= 0.5);
        }
    }
    void shortOnesStay()
    {
        const std::vector<app::Point> two{{0, 0}, {1, 1}};
        QCOMPARE(app::simplified(two, 10), two);
        QVERIFY(app::simplified({}, 1).empty());
    }
};

} // namespace view_simplify_test

TEST_CLASS(view_simplify_test::SimplifyTest, None)
#include "tests/app/view/simplify_test.moc"
