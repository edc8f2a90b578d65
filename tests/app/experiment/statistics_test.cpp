// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/statistics.h"

#include <QTest>

#include <bit>
#include <cmath>
#include <random>
#include <set>

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
        // 1 and 3 do not overlap, but 2 overlaps both.
        QCOMPARE(places[1].ties, (std::vector{0}));
        QCOMPARE(places[2].ties, (std::vector{0, 1}));
        QCOMPARE(places[3].ties, (std::vector{1}));
        QCOMPARE(places[5].ties, (std::vector{2}));
        QCOMPARE(places[6].ties, (std::vector{2}));
        for (const int i : {1, 2, 3, 5, 6})
            QVERIFY(!places[std::size_t(i)].rank);
        QVERIFY(places[0].ties.empty() && places[4].ties.empty());
        QCOMPARE(app::sortedByMedian(things), (std::vector<std::size_t>{4, 1, 2, 3, 0, 5, 6}));
    }

    void tiesAreTheLargestGroupsThatOverlapPairwise()
    {
        std::mt19937_64 random(2);
        std::uniform_real_distribution<double> anywhere(0, 10), size(0, 3);
        const auto overlap = [](const std::vector<Summary>& all, unsigned some) {
            for (std::size_t i = 0; i < all.size(); ++i)
                for (std::size_t j = 0; j < i; ++j)
                    if ((some >> i & 1) && (some >> j & 1)
                        && !all[i].confidence.overlaps(all[j].confidence))
                        return false;
            return true;
        };
        for (int round = 0; round < 200; ++round) {
            std::vector<Summary> things;
            for (int i = 0; i < 7; ++i) {
                const double low = anywhere(random);
                things.push_back(between(low, low + size(random)));
            }
            std::set<unsigned> expected, found; // a bit a thing
            for (unsigned some = 1; some < 128; ++some) {
                bool largest = std::popcount(some) > 1 && overlap(things, some);
                for (unsigned i = 0; i < 7; ++i)
                    largest = largest && ((some >> i & 1) || !overlap(things, some | 1u << i));
                if (largest)
                    expected.insert(some);
            }
            for (const auto& group : app::tieGroups(things)) {
                unsigned some = 0;
                for (const std::size_t i : group)
                    some |= 1u << i;
                QVERIFY(found.insert(some).second);
                QVERIFY(std::ranges::is_sorted(group, {},
                                               [&](std::size_t i) { return things[i].median; }));
            }
            QVERIFY(found == expected);
        }
    }
};

QTEST_APPLESS_MAIN(StatisticsTest)
#include "statistics_test.moc"
