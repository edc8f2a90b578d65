// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/experiment.h"
#include "app/experiment/ranking.h"

#include <QTest>

#include <random>
#ifdef __x86_64__
#include <cpuid.h>
#endif

#include "tests/test_class.h"

namespace experiment_fairness_test {

// The same function under two names must come out equal, and a slower one must not. The clock is
// the test's: each call takes what the test says, with noise, with a machine that gets slower and
// slower, and with a cold start for whoever goes first.

namespace {

double now = 0;        // nanoseconds
std::mt19937_64 noise; // NOLINT: the seed is set by each test
int calls = 0;         // of all functions
int perRound = 1;      // variants

double slowness()
{
    std::lognormal_distribution<double> skewed(0, 0.05);
    const double cold = calls % perRound == 0 ? 1.1 : 1;
    return skewed(noise) * cold * (1 + 0.002 * calls++);
}

template <int nanosecondsALine>
std::size_t clipAll(std::span<const clipping::Segment> in, const clipping::Window&,
                    std::span<clipping::Clipped>)
{
    now += nanosecondsALine * double(in.size()) * slowness();
    return 0;
}

template <int nanosecondsALine>
clipping::Algorithm named(std::string_view key)
{
    clipping::Algorithm row = *clipping::findAlgorithm("cs");
    row.key = key;
    row.corrected.clipAll = clipAll<nanosecondsALine>;
    return row;
}

app::Ranking race(const std::vector<clipping::Algorithm>& rows, std::uint64_t seed)
{
    noise.seed(seed);
    now = calls = 0;
    perRound = int(rows.size());
    app::ExperimentOptions options;
    options.lines = 100;
    options.clock = {"the test's", [] { return now; }};
    std::vector<app::Variant> variants;
    for (const auto& row : rows)
        variants.push_back({&row, clipping::Form::Corrected});
    const auto timings = *app::experiment(options, variants);
    std::vector<std::vector<double>> runs;
    for (const app::Timing& timing : timings)
        runs.push_back(timing.clip);
    return app::rankingOf(runs);
}

#ifdef __x86_64__
/// Whether something is in the upper halves of the vector registers; nothing if it cannot be known.
std::optional<bool> upperHalvesInUse()
{
    unsigned a = 0, b = 0, c = 0, d = 0;
    if (!__get_cpuid_count(0xd, 1, &a, &b, &c, &d) || (a & 4) == 0)
        return std::nullopt;
    asm volatile("xgetbv" : "=a"(a), "=d"(d) : "c"(1));
    return (a & 4) != 0;
}
#endif

} // namespace

class FairnessTest : public QObject {
    Q_OBJECT

private slots:
    void oneFunctionUnderTwoNamesHasNoDifference()
    {
        const std::vector rows{named<50>("one"), named<50>("other")};
        int none = 0, ratios = 0;
        for (std::uint64_t seed = 1; seed <= 100; ++seed) {
            const app::Ranking ranking = race(rows, seed);
            QVERIFY(ranking.told);
            none += ranking.againstLowest(ranking.order[1]).outcome != app::Outcome::Different;
            ratios += ranking.againstLowest(ranking.order[1]).ratio > 1 + app::leastDifference;
        }
        QVERIFY2(none >= 94, qPrintable(QString::number(none)));
        QVERIFY2(ratios > 50, "the noise is so small that no difference could be seen anyway");
    }

    void aSlowerFunctionIsFound()
    {
        const std::vector rows{named<50>("one"), named<60>("other")};
        int found = 0;
        for (std::uint64_t seed = 1; seed <= 100; ++seed) {
            const app::Ranking ranking = race(rows, seed);
            found += ranking.ranks == std::vector<std::optional<int>>{1, 2};
        }
        QVERIFY2(found >= 94, qPrintable(QString::number(found)));
    }

    void twoNamesShareALetterAndTheSlowerOneHasAnother()
    {
        const std::vector rows{named<50>("one"), named<50>("other"), named<80>("slower")};
        int shared = 0;
        for (std::uint64_t seed = 1; seed <= 100; ++seed) {
            const app::Ranking ranking = race(rows, seed);
            shared += ranking.groupsOf(0) == ranking.groupsOf(1);
            QCOMPARE(ranking.ranks[2], std::optional(3));
        }
        QVERIFY2(shared >= 94, qPrintable(QString::number(shared)));
    }

    void drawingLeavesNothingThatSlowsClippingDown()
    {
#ifdef __x86_64__
        if (!upperHalvesInUse())
            QSKIP("this processor does not say what is in its vector registers");
        static int turns, slowed;
        turns = slowed = 0;
        clipping::Algorithm row = *clipping::findAlgorithm("cs");
        row.corrected.clipAll = [](std::span<const clipping::Segment> in, const clipping::Window&,
                                   std::span<clipping::Clipped> out) {
            ++turns;
            slowed += *upperHalvesInUse();
            for (std::size_t i = 0; i < in.size(); ++i)
                out[i] = {in[i], std::uint32_t(i), 0};
            return in.size();
        };
        app::ExperimentOptions options;
        options.lines = 1000;
        options.runs = 5;
        options.target = app::rasterTarget;
        const app::Variant one{&row, clipping::Form::Corrected};
        QVERIFY(app::experiment(options, {&one, 1}));
        QCOMPARE(turns, 6);
        QCOMPARE(slowed, 0);
#else
        QSKIP("only x86 has such registers");
#endif
    }

    void noAlgorithmIsAlwaysFirst()
    {
        static std::vector<int> order;
        const auto remember = []<int who>(std::integral_constant<int, who>) {
            clipping::Algorithm row = *clipping::findAlgorithm("cs");
            row.corrected.clipAll = [](std::span<const clipping::Segment>, const clipping::Window&,
                                       std::span<clipping::Clipped>) {
                order.push_back(who);
                return std::size_t(0);
            };
            return row;
        };
        race({remember(std::integral_constant<int, 0>()),
              remember(std::integral_constant<int, 1>()),
              remember(std::integral_constant<int, 2>())},
             1);
        QCOMPARE(order.size(), 33u); // one run to warm up, ten that count
        std::array<int, 3> first{};
        for (std::size_t run = 1; run <= 10; ++run)
            ++first[std::size_t(order[3 * run])];
        for (const int times : first)
            QVERIFY(times == 3 || times == 4);
    }

    void theWarmUpDoesNotCount()
    {
        noise.seed(1);
        now = 0;
        static int turns = 0;
        clipping::Algorithm row = *clipping::findAlgorithm("cs");
        row.corrected.clipAll = [](std::span<const clipping::Segment> in, const clipping::Window&,
                                   std::span<clipping::Clipped>) {
            now += double(in.size()) * (++turns <= 2 ? 1000 : 7);
            return std::size_t(0);
        };
        app::ExperimentOptions options;
        options.lines = 10;
        options.warmUps = 2;
        options.clock = {"the test's", [] { return now; }};
        const std::vector<app::Variant> one{{&row, clipping::Form::Corrected}};
        QCOMPARE(app::experiment(options, one)->front().clip, std::vector<double>(10, 7));
    }

    /// With the real clock, too: in one of five tries at least, for the machine may be busy.
    void aRealFunctionDoesNotDifferFromItself()
    {
        clipping::Algorithm copy = *clipping::findAlgorithm("md");
        copy.key = "copy";
        const std::vector<app::Variant> two{
            {clipping::findAlgorithm("md"), clipping::Form::Corrected},
            {&copy, clipping::Form::Corrected}};
        app::ExperimentOptions options;
        options.lines = 200'000;
        int none = 0;
        for (int i = 0; i < 5 && none == 0; ++i) {
            const auto timings = *app::experiment(options, two);
            const std::vector runs{timings[0].clip, timings[1].clip};
            none += app::rankingOf(runs).leaders().size() == 2;
        }
        QCOMPARE(none, 1);
    }
};

} // namespace experiment_fairness_test

TEST_CLASS(experiment_fairness_test::FairnessTest, None)
#include "tests/app/experiment/fairness_test.moc"
