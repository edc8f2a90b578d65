// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/signed_rank.h"

#include <QTest>

#include <cmath>
#include <random>

#include "tests/test_class.h"

namespace experiment_signed_rank_test {

namespace {

/// The ranks by their definition, doubled: of each number, how many sizes are smaller, and half of
/// those as large. Zeros take part (Pratt) and have none in the end.
std::vector<int> doubledRanks(const std::vector<double>& differences)
{
    std::vector<int> ranks;
    for (const double one : differences) {
        int rank = 0;
        for (const double other : differences)
            rank += 2 * (std::abs(other) < std::abs(one)) + (std::abs(other) == std::abs(one));
        ranks.push_back(one == 0 ? 0 : rank + 1);
    }
    return ranks;
}

/// All 2^n ways to give the differences signs, one by one.
double enumeratedP(const std::vector<double>& differences)
{
    const auto ranks = doubledRanks(differences);
    const auto imbalance = [&](auto isPositive) {
        int sum = 0;
        for (std::size_t i = 0; i < ranks.size(); ++i)
            sum += isPositive(i) ? ranks[i] : -ranks[i];
        return std::abs(sum);
    };
    const int found = imbalance([&](std::size_t i) { return differences[i] > 0; });
    int asFar = 0;
    for (unsigned signs = 0; signs < 1u << ranks.size(); ++signs)
        asFar += imbalance([&](std::size_t i) { return (signs >> i & 1) != 0; }) >= found;
    return double(asFar) / double(1u << ranks.size());
}

QByteArray textOf(const std::vector<double>& numbers)
{
    QByteArray text;
    for (const double number : numbers)
        text += QByteArray::number(number) + ' ';
    return text;
}

/// 1 to n, of which those in front are negative: so many that their ranks sum up to `smaller`.
std::vector<double> withSum(int n, int smaller)
{
    std::vector<double> differences(std::size_t(n), 0.0);
    for (int rank = n; rank > 0; --rank) {
        const bool negative = smaller >= rank;
        differences[std::size_t(rank) - 1] = negative ? -rank : rank;
        smaller -= negative ? rank : 0;
    }
    return differences;
}

} // namespace

class SignedRankTest : public QObject {
    Q_OBJECT

private slots:
    void itIsTheShareOfAllWaysToGiveSigns()
    {
        std::mt19937_64 random(1);
        int zeros = 0, equals = 0;
        for (std::size_t n = 1; n <= 12; ++n)
            for (int round = 0; round < 40; ++round) {
                // Few different numbers have many equal sizes and zeros, many have none.
                std::uniform_int_distribution<int> number(-3 - round, 3 + round);
                std::vector<double> differences(n);
                for (double& one : differences)
                    one = number(random) / 4.0;
                zeros += int(std::ranges::count(differences, 0.0));
                const auto ranks = doubledRanks(differences);
                equals += std::ranges::any_of(ranks, [](int rank) { return rank % 2 != 0; });
                const double p = app::signedRankP(differences), expected = enumeratedP(differences);
                QVERIFY2(std::abs(p - expected) < 1e-14, textOf(differences) + QByteArray::number(p)
                                                             + " is not "
                                                             + QByteArray::number(expected));
            }
        QVERIFY(zeros > 100 && equals > 100);
    }

    void onlyZerosSayNothing()
    {
        QCOMPARE(app::signedRankP(std::vector<double>(9, 0.0)), 1.0);
        QCOMPARE(app::signedRankP(std::vector<double>{0, -0.0, 0}), 1.0);
        QCOMPARE(app::signedRankP({}), 1.0);
    }

    void thePublishedCriticalValues()
    {
        // Two-sided, from McCornack, Extended Tables of the Wilcoxon Matched Pair Signed Rank
        // Statistic, JASA 60 (1965): the largest sum that is significant.
        struct Row {
            int n, fivePerCent, onePerCent;
        };
        constexpr Row rows[]{{6, 0, -1},   {7, 2, -1},   {8, 3, 0},     {9, 5, 1},    {10, 8, 3},
                             {11, 10, 5},  {12, 13, 7},  {13, 17, 9},   {14, 21, 12}, {15, 25, 15},
                             {20, 52, 37}, {25, 89, 68}, {30, 137, 109}};
        for (const Row& row : rows)
            for (const auto& [level, sum] :
                 {std::pair(0.05, row.fivePerCent), std::pair(0.01, row.onePerCent)}) {
                const auto text = QByteArray::number(row.n) + " at " + QByteArray::number(level);
                if (sum >= 0)
                    QVERIFY2(app::signedRankP(withSum(row.n, sum)) <= level, text);
                QVERIFY2(app::signedRankP(withSum(row.n, sum + 1)) > level, text);
            }
    }

    void darwinsPlants()
    {
        // Crossed less self-fertilised Zea mays, in eighths of an inch (Darwin 1876): W = 96, and
        // R's wilcox.test says p = 0.04126.
        const std::vector<double> heights{49, -67, 8,  16, 6,  23, 28, 41,
                                          14, 29,  56, 24, 75, 60, -48};
        QCOMPARE(QString::number(app::signedRankP(heights), 'f', 5), "0.04126");
    }

    void theOrderAndTheSideDoNotMatter()
    {
        std::mt19937_64 random(2);
        std::normal_distribution<double> number(0.3, 1);
        std::vector<double> differences(37);
        for (double& one : differences)
            one = number(random);
        const double p = app::signedRankP(differences);
        QVERIFY(p > 0 && p < 1);
        std::ranges::shuffle(differences, random);
        QCOMPARE(app::signedRankP(differences), p);
        for (double& one : differences)
            one = -3 * one;
        QCOMPARE(app::signedRankP(differences), p);
    }

    void manyDifferencesAreNearlyExact()
    {
        // The same distribution in long double, by another way: counts of sums, largest n.
        for (const int n : {201, 300}) {
            std::vector<long double> ways(std::size_t(n * (n + 1) / 2 + 1), 0.0L);
            ways[0] = 1;
            for (int rank = 1; rank <= n; ++rank)
                for (std::size_t sum = ways.size(); sum-- > std::size_t(rank);)
                    ways[sum] += ways[sum - std::size_t(rank)];
            long double all = 0;
            for (const long double one : ways)
                all += one;
            long double below = 0;
            for (int sum = 0; sum < n * (n + 1) / 4; ++sum) {
                below += ways[std::size_t(sum)];
                if (sum % 97 != 0)
                    continue;
                const double p = app::signedRankP(withSum(n, sum));
                QVERIFY2(std::abs(p - double(2 * below / all)) < 0.001,
                         QByteArray::number(n) + ' ' + QByteArray::number(sum));
            }
        }
    }

    void aLevelOfFivePerCentIsKept()
    {
        std::mt19937_64 random(3);
        std::cauchy_distribution<double> wild(0, 1); // symmetric, and nothing more
        for (const std::size_t n : {6u, 10u, 14u, 40u}) {
            int found = 0;
            constexpr int times = 4000;
            for (int i = 0; i < times; ++i) {
                std::vector<double> differences(n);
                for (double& one : differences)
                    one = wild(random);
                found += app::signedRankP(differences) <= 0.05;
            }
            QVERIFY2(found < 0.06 * times && found > 0.02 * times,
                     QByteArray::number(qulonglong(n)) + ' ' + QByteArray::number(found));
        }
    }
};

} // namespace experiment_signed_rank_test

TEST_CLASS(experiment_signed_rank_test::SignedRankTest, None)
#include "tests/app/experiment/signed_rank_test.moc"
