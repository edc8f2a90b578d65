// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/ruler.h"

#include <QTest>

#include <cmath>

#include "tests/test_class.h"

namespace view_ruler_test {

class RulerTest : public QObject {
    Q_OBJECT

private slots:
    void numbersHaveRoomAndRoundValues()
    {
        for (int zoom = 0; zoom < 81; ++zoom) { // up to nearly a million
            const double pixels = 1e-5 * std::pow(1.37, zoom), length = 1280 / pixels;
            const auto all = app::ticks(-length / 3, length * 2 / 3, pixels);
            QVERIFY(all.size() > 20);
            double lastNumber = NAN;
            for (std::size_t i = 0; i < all.size(); ++i) {
                if (i > 0)
                    QVERIFY((all[i].value - all[i - 1].value) * pixels >= 3.999);
                if (all[i].rank != app::Tick::Rank::Numbered)
                    continue;
                if (!std::isnan(lastNumber)) {
                    const double step = all[i].value - lastNumber;
                    QVERIFY(step * pixels >= 63.99 && step * pixels <= 161);
                    const double digit = step / std::pow(10, std::floor(std::log10(step) + 1e-9));
                    QVERIFY2(std::abs(digit - 1) < 1e-6 || std::abs(digit - 2) < 1e-6
                                 || std::abs(digit - 5) < 1e-6,
                             qPrintable(QString::number(step)));
                }
                lastNumber = all[i].value;
            }
        }
    }
    void zeroIsExactlyZero()
    {
        int zeros = 0;
        for (const app::Tick& tick : app::ticks(-0.31, 0.33, 1000))
            if (std::abs(tick.value) < 1e-9) {
                QCOMPARE(tick.value, 0.0);
                ++zeros;
            }
        QCOMPARE(zeros, 1);
    }
    void nonsenseHasNoTicks()
    {
        QVERIFY(app::ticks(0, 0, 1).empty());
        QVERIFY(app::ticks(0, NAN, 1).empty());
        QVERIFY(app::ticks(0, 1, 0).empty());
    }
};

} // namespace view_ruler_test

TEST_CLASS(view_ruler_test::RulerTest, None)
#include "tests/app/view/ruler_test.moc"
