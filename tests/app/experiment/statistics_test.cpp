// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/statistics.h"

#include <QTest>

#include <cmath>
#include <random>

using app::Summary;

namespace {

Summary between(double low, double high)
{
    return {.median = (low + high) / 2, .confidence = {low, high}};
}

} // namespace

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
        QVERIFY(std::isinf(app::summaryOf(std::vector<double>{7}).confidence.high));
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
        // 2, 4, 6: deviation 2, so 4 +- 4.303 * 2 / sqrt 3.
        const auto few = app::summaryOf(std::vector<double>{2, 4, 6}).confidence;
        QVERIFY(std::abs(few.low - (4 - 4.9687)) < 1e-3);
        QVERIFY(std::abs(few.high - (4 + 4.9687)) < 1e-3);
    }

    void nineteenIntervalsOfTwentyHoldTheTruth()
    {
        std::mt19937_64 random(1);
        std::lognormal_distribution<double> skewed(0, 1); // its median is 1
        int held = 0;
        for (int i = 0; i < 2000; ++i) {
            std::vector<double> numbers(10);
            for (double& number : numbers)
                number = skewed(random);
            const auto interval = app::summaryOf(numbers).confidence;
            held += interval.low <= 1 && 1 <= interval.high;
        }
        QVERIFY(held > 1900);
    }

    void whoOverlapsHasNoRank()
    {
        const std::vector<Summary> things{between(30, 31), between(10, 12), between(11, 20),
                                          between(19, 22), between(1, 2),   between(40, 50),
                                          between(45, 46)};
        const auto places = app::standings(things);
        QCOMPARE(places[4].rank, std::optional(1));
        QCOMPARE(places[0].rank, std::optional(5));
        for (const int i : {1, 2, 3}) { // 1 and 3 are linked by 2
            QVERIFY(!places[std::size_t(i)].rank);
            QCOMPARE(places[std::size_t(i)].tie, std::optional(0));
        }
        QCOMPARE(places[5].tie, std::optional(1));
        QCOMPARE(places[6].tie, std::optional(1));
        QVERIFY(!places[0].tie && !places[4].tie);
        QCOMPARE(app::sortedByMedian(things), (std::vector<std::size_t>{4, 1, 2, 3, 0, 5, 6}));
    }
};

QTEST_APPLESS_MAIN(StatisticsTest)
#include "statistics_test.moc"
