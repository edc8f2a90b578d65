// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/statistics.h"
#include "app/experiment/ranking_text.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <random>

#include "tests/test_class.h"

namespace base_statistics_test {

using app::Summary;

class StatisticsTest : public QObject {
    Q_OBJECT

private slots:
    void medianSpreadAndMean()
    {
        const Summary five = app::summaryOf(std::vector<double>{5, 1, 4, 2, 13});
        QCOMPARE(five.median, 4.0);
        QCOMPARE(five.spread, 3.0);
        QCOMPARE(five.mean, 5.0);
        QCOMPARE(app::summaryOf(std::vector<double>{1, 2}).median, 1.5);
        QCOMPARE(app::summaryOf(std::vector<double>{7}).spread, 0.0);
        const std::vector<Summary> things{five, {.median = 9}, {.median = 1}};
        QCOMPARE(app::sortedByMedian(things), (std::vector<std::size_t>{2, 0, 1}));
    }

    void theIntervalsAreThoseOfTheTables()
    {
        // Ranks of the 95 % interval of a median: any table of order statistics.
        for (const auto& [n, low] :
             {std::pair{6, 1}, {8, 1}, {9, 2}, {10, 2}, {20, 6}, {100, 40}}) {
            std::vector<double> numbers;
            for (int i = n; i > 0; --i)
                numbers.push_back(i);
            const auto interval = app::summaryOf(numbers).confidence;
            QCOMPARE(interval.low, double(low));
            QCOMPARE(interval.high, double(n + 1 - low));
        }
        // Logarithms 1, 2, 3: deviation 1, so 2 +- 4.303 / sqrt 3.
        const auto few =
            app::summaryOf(std::vector<double>{std::exp(1), std::exp(3), std::exp(2)}).confidence;
        QVERIFY(std::abs(std::log(few.low) - (2 - 2.4843)) < 1e-3);
        QVERIFY(std::abs(std::log(few.high) - (2 + 2.4843)) < 1e-3);
    }

    void twoTimesSayNothingOfWhereTheMiddleLies()
    {
        for (const auto& times : {std::vector<double>{7}, {7, 8}, {0, 0, 0}, {0, 3, 4, 5}}) {
            const auto interval = app::summaryOf(times).confidence;
            QVERIFY(std::isinf(interval.low) && std::isinf(interval.high));
        }
    }

    /// Student's t of the times themselves gave a lower bound below 0, which was told as 0.00 ns.
    void theMiddleOfTimesLiesAboveZero()
    {
        std::mt19937_64 random(4);
        std::lognormal_distribution<double> skewed(5, 2);
        for (const std::size_t n : {3u, 4u, 5u, 6u, 10u})
            for (int i = 0; i < 500; ++i) {
                std::vector<double> times(n);
                for (double& time : times)
                    time = skewed(random);
                const auto [low, high] = app::summaryOf(times).confidence;
                QVERIFY2(low > 0 && low < high, qPrintable(QString::number(low)));
                QVERIFY2(app::boundText(low).toDouble() > 0, qPrintable(app::boundText(low)));
            }
        QCOMPARE(app::boundText(0.0031), "0.0031");
        QCOMPARE(app::boundText(12.345), "12.35");
        QCOMPARE(app::boundText(-std::numeric_limits<double>::infinity()), "");
    }

    void nineteenIntervalsOfTwentyHoldTheTruth()
    {
        std::mt19937_64 random(1);
        std::lognormal_distribution<double> skewed(0, 1); // its median is 1
        for (const std::size_t n : {3u, 5u, 10u}) {
            int held = 0;
            for (int i = 0; i < 2000; ++i) {
                std::vector<double> numbers(n);
                for (double& number : numbers)
                    number = skewed(random);
                const auto interval = app::summaryOf(numbers).confidence;
                held += interval.low <= 1 && 1 <= interval.high;
            }
            QVERIFY2(held > 1880, qPrintable(QString::number(held)));
        }
    }
};

} // namespace base_statistics_test

TEST_CLASS(base_statistics_test::StatisticsTest, None)
#include "tests/app/base/statistics_test.moc"
