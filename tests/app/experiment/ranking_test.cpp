// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/statistics.h"
#include "app/experiment/ranking.h"
#include "app/experiment/ranking_text.h"
#include "app/experiment/signed_rank.h"

#include <QTest>

#include <bit>
#include <cmath>
#include <random>
#include <set>

#include "tests/test_class.h"

namespace experiment_ranking_test {

using app::Outcome;
using app::Ranking;

namespace {

using Runs = std::vector<std::vector<double>>;

/// Times of things in the same rounds. A round slows all of them down alike, by up to three times,
/// and each by a noise of its own.
Runs inRounds(const std::vector<double>& times, std::size_t rounds, double noise,
              std::uint64_t seed)
{
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> slowness(1, 3);
    std::normal_distribution<double> own(0, noise);
    Runs runs(times.size());
    for (std::size_t r = 0; r < rounds; ++r) {
        const double all = slowness(random);
        for (std::size_t i = 0; i < times.size(); ++i)
            runs[i].push_back(times[i] * all * std::exp(own(random)));
    }
    return runs;
}

double uncorrectedP(const std::vector<double>& a, const std::vector<double>& b)
{
    std::vector<double> differences;
    for (std::size_t r = 0; r < a.size(); ++r)
        differences.push_back(a[r] - b[r]);
    return app::signedRankP(differences);
}

/// Holm's correction by its definition: the greatest of all smaller or equal p, each times the
/// number of tests whose p is not smaller.
double holm(double p, const std::vector<double>& family)
{
    double corrected = 0;
    for (const double one : family)
        if (one <= p)
            corrected =
                std::max(corrected, one * double(std::ranges::count_if(family, [&](double other) {
                                        return other >= one;
                                    })));
    return std::min(corrected, 1.0);
}

bool differ(const Ranking& ranking, std::size_t i, std::size_t j)
{
    return ranking.pairs[i][j].outcome == Outcome::Different;
}

} // namespace

class RankingTest : public QObject {
    Q_OBJECT

private slots:
    void theNumberOfRounds()
    {
        QCOMPARE(app::leastRounds(1), 1u);
        QCOMPARE(app::leastRounds(2), 6u);
        QCOMPARE(app::leastRounds(7), 10u);  // the paper's ten runs are just enough
        QCOMPARE(app::leastRounds(11), 12u); // 55 pairs
        QCOMPARE(app::usualRounds(2), 10u);
        for (std::size_t k = 2; k < 60; ++k) {
            const double pairs = double(k * (k - 1)) / 2, r = double(app::leastRounds(k));
            QVERIFY(std::pow(2, 1 - r) < 0.05 / pairs);
            QVERIFY(std::pow(2, 2 - r) >= 0.05 / pairs);
            QVERIFY(app::usualRounds(k) >= app::leastRounds(k));
        }
    }

    /// The rule before, of overlapping intervals, called those equal.
    void aDifferenceInEveryRoundIsSignificant()
    {
        const auto runs = inRounds({30, 31.5}, 10, 0, 1);
        const auto a = app::summaryOf(runs[0]).confidence, b = app::summaryOf(runs[1]).confidence;
        QVERIFY(b.low < a.high); // the intervals overlap
        const Ranking ranking = app::rankingOf(runs);
        QVERIFY(ranking.told && differ(ranking, 0, 1) && differ(ranking, 1, 0));
        QCOMPARE(ranking.ranks, (std::vector<std::optional<int>>{1, 2}));
        QCOMPARE(ranking.leaders(), (std::vector<std::size_t>{0}));
        QVERIFY(std::abs(ranking.againstLowest(1).ratio - 1.05) < 1e-12);
        QVERIFY(std::abs(ranking.pairs[0][1].ratio * 1.05 - 1) < 1e-12);
        QCOMPARE(ranking.againstLowest(1).p, 2.0 / 1024);
        QCOMPARE(app::lettersText(ranking, 0), "a");
        QCOMPARE(app::lettersText(ranking, 1), "b");
    }

    /// Intervals of 2.90 and 2.91 ns that do not overlap named the first one the fastest.
    void lessThanOnePerCentIsPracticallyEqual()
    {
        Runs runs(2);
        for (int r = 0; r < 12; ++r) {
            runs[0].push_back(2.90 + r * 1e-4);
            runs[1].push_back(2.91 + r * 1e-4);
        }
        const Ranking ranking = app::rankingOf(runs);
        QVERIFY(ranking.againstLowest(1).p < 0.001);
        QVERIFY(ranking.againstLowest(1).outcome == Outcome::PracticallyEqual);
        QCOMPARE(ranking.leaders().size(), 2u);
        QVERIFY(!ranking.ranks[0] && !ranking.ranks[1]);
        QCOMPARE(app::lettersText(ranking, 1), "a");
    }

    void tooFewRunsTellNothing()
    {
        const std::vector<double> times{1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024};
        for (std::size_t rounds = 1; rounds < 12; ++rounds) {
            const Ranking ranking = app::rankingOf(inRounds(times, rounds, 0, 1));
            QVERIFY(!ranking.told && ranking.groups.empty());
            for (std::size_t i = 0; i < times.size(); ++i) {
                QVERIFY(!ranking.ranks[i]);
                QCOMPARE(app::rankText(ranking, i) + app::lettersText(ranking, i)
                             + app::pToFastestText(ranking, i),
                         "");
            }
            QCOMPARE(
                app::rankingNotes(ranking),
                QStringList(
                    QString("Too few runs: 11 algorithms need 12 runs, but this experiment has %1.")
                        .arg(rounds)));
        }
        const Ranking ranking = app::rankingOf(inRounds(times, 12, 0, 1));
        QVERIFY(ranking.told);
        for (std::size_t i = 0; i < times.size(); ++i)
            QCOMPARE(ranking.ranks[i], std::optional(int(i) + 1));
    }

    void aSingleAlgorithmRanksFirst()
    {
        const Ranking ranking = app::rankingOf(Runs{{3}});
        QVERIFY(ranking.told);
        QCOMPARE(ranking.ranks[0], std::optional(1));
        QCOMPARE(app::lettersText(ranking, 0), "a");
        QVERIFY(app::rankingNotes(ranking).isEmpty());
    }

    void zeroTimesAreEqual() // of drawing, where nothing is visible
    {
        const Ranking ranking = app::rankingOf(Runs(3, std::vector<double>(10, 0.0)));
        QCOMPARE(ranking.groups.size(), 1u);
        QCOMPARE(ranking.againstLowest(2).ratio, 1.0);
    }

    void pIsCorrectedByHolm()
    {
        for (std::uint64_t seed = 1; seed <= 50; ++seed) {
            const auto runs = inRounds({10, 10.3, 10.6, 11, 12}, 11, 0.04, seed);
            const Ranking ranking = app::rankingOf(runs);
            const std::size_t first = ranking.order[0];
            std::vector<double> all;
            for (std::size_t i = 0; i < runs.size(); ++i)
                for (std::size_t j = 0; j < i; ++j)
                    all.push_back(uncorrectedP(runs[i], runs[j]));
            for (std::size_t i = 0; i < runs.size(); ++i)
                for (std::size_t j = 0; j < runs.size(); ++j)
                    if (i != j) {
                        const double p = holm(uncorrectedP(runs[i], runs[j]), all);
                        QVERIFY(std::abs(ranking.pairs[i][j].p - p) < 1e-12);
                        if (i == first)
                            QVERIFY(std::abs(ranking.againstLowest(j).p - p) < 1e-12);
                    }
        }
    }

    void lettersAreTheLargestGroupsWithoutADifference()
    {
        std::size_t several = 0;
        for (std::uint64_t seed = 1; seed <= 100; ++seed) {
            const auto runs = inRounds({10, 10.4, 10.8, 11.2, 11.6, 12, 12.4}, 12, 0.04, seed);
            const Ranking ranking = app::rankingOf(runs);
            const auto alike = [&](unsigned some) {
                for (std::size_t i = 0; i < 7; ++i)
                    for (std::size_t j = 0; j < i; ++j)
                        if ((some >> i & 1) && (some >> j & 1) && differ(ranking, i, j))
                            return false;
                return true;
            };
            std::set<unsigned> expected, found; // a bit a thing
            for (unsigned some = 1; some < 128; ++some) {
                bool largest = alike(some);
                for (unsigned i = 0; i < 7; ++i)
                    largest = largest && ((some >> i & 1) || !alike(some | 1u << i));
                if (largest)
                    expected.insert(some);
            }
            for (const auto& group : ranking.groups) {
                unsigned some = 0;
                for (const std::size_t i : group)
                    some |= 1u << i;
                QVERIFY(found.insert(some).second);
            }
            QVERIFY2(found == expected, qPrintable(QString::number(seed)));
            QVERIFY(ranking.groups.front().front() == ranking.order.front());
            several += ranking.groups.size() > 2;
            for (std::size_t place = 0; place < 7; ++place)
                if (const auto rank = ranking.ranks[ranking.order[place]])
                    QCOMPARE(*rank, int(place) + 1);
        }
        QVERIFY(several > 50);
    }

    /// One function under many names: whichever has the lowest median is hardly ever "the fastest".
    void ofManyNamesOfOneFunctionNoneIsTheFastest()
    {
        int fastest = 0, differences = 0, fewerLeaders = 0, anyP = 0;
        for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
            std::mt19937_64 random(seed);
            std::normal_distribution<double> time(20, 1);
            Runs runs(11, std::vector<double>(12));
            for (auto& times : runs)
                std::ranges::generate(times, [&] { return time(random); });
            const Ranking ranking = app::rankingOf(runs);
            fastest += ranking.hasFastest();
            fewerLeaders += ranking.leaders().size() < 11;
            differences += ranking.groups.size() > 1;
            anyP += std::ranges::any_of(ranking.order, [&](std::size_t i) {
                return ranking.againstLowest(i).p < app::significance;
            });
        }
        QCOMPARE(fastest, 0);
        QVERIFY2(differences <= 50, qPrintable(QString::number(differences))); // 5 %
        QVERIFY2(fewerLeaders <= 50, qPrintable(QString::number(fewerLeaders)));
        QVERIFY2(anyP <= 50, qPrintable(QString::number(anyP))); // by the tests of all pairs
    }

    /// Two equal things far ahead of the others: one of them is called the fastest by mistake in
    /// 5 % of all experiments at most.
    void theClaimOfAFastestKeepsToItsLevel()
    {
        int claims = 0;
        for (std::uint64_t seed = 1; seed <= 1000; ++seed)
            claims += app::rankingOf(inRounds({10, 10, 20, 30, 40}, 12, 0.05, seed)).hasFastest();
        QVERIFY2(claims <= 50, qPrintable(QString::number(claims)));
    }

    /// Ranks say what letters say: one alone in its group and in no other one.
    void ranksAreBasedOnPairs()
    {
        int fastest = 0;
        for (std::uint64_t seed = 1; seed <= 200; ++seed) {
            const Ranking ranking =
                app::rankingOf(inRounds({10, 10.4, 10.8, 11.2, 11.6, 12, 12.4}, 12, 0.03, seed));
            for (std::size_t i = 0; i < 7; ++i) {
                const auto groups = ranking.groupsOf(i);
                const bool alone = groups.size() == 1 && ranking.groups[groups[0]].size() == 1;
                QVERIFY2(ranking.ranks[i].has_value() == alone,
                         qPrintable(QStringLiteral("seed %1, thing %2").arg(seed).arg(i)));
            }
            QCOMPARE(ranking.hasFastest(), ranking.leaders().size() == 1);
            QCOMPARE(ranking.hasFastest(), ranking.ranks[ranking.order.front()].has_value());
            fastest += ranking.hasFastest();
        }
        QVERIFY(fastest > 0 && fastest < 200);
    }

    void theWords()
    {
        QCOMPARE(app::groupLetter(0), "a");
        QCOMPARE(app::groupLetter(27), "ab");
        const Ranking ranking = app::rankingOf(inRounds({5, 1, 5, 9}, 10, 0.01, 1));
        const QString told = app::rankingText({"A", "B", "C", "D"}, ranking);
        QVERIFY2(
            told.contains(": B (a), ") && told.contains("A (b)") && told.contains("C (b)")
                && told.contains("D (c). Algorithms that share no letter differ significantly"),
            qPrintable(told));
        const QString few =
            app::rankingText({"A", "B", "C", "D"}, app::rankingOf(inRounds({5, 1, 5, 9}, 3, 0, 1)));
        QVERIFY2(few.contains("Too few runs: 4 algorithms need 8 runs") && !few.contains('('),
                 qPrintable(few));
    }
};

} // namespace experiment_ranking_test

TEST_CLASS(experiment_ranking_test::RankingTest, None)
#include "tests/app/experiment/ranking_test.moc"
