// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/experiment.h"
#include "app/experiment/paper_scene.h"

#include <QTest>

#include <algorithm>

class ExperimentTest : public QObject {
    Q_OBJECT

private slots:
    void theSameSeedGivesTheSameLinesOnEveryMachine()
    {
        std::vector<clipping::Segment> lines(3), more(3);
        app::PaperScene(1).fill(lines);
        app::PaperScene again(1);
        for (auto& line : more)
            again.fill({&line, 1});
        QCOMPARE(lines, more);
        // std::mt19937_64(1) begins with 2469588189546311528, as the standard says of all machines.
        QCOMPARE(lines[0].a.x,
                 -960 + 1920 * (double(2469588189546311528 >> 11) / 9007199254740992));
        app::PaperScene(2).fill(more);
        QVERIFY(lines != more);
    }

    void theLinesFillTheSpace()
    {
        std::vector<clipping::Segment> lines(100'000);
        app::PaperScene(3).fill(lines);
        double sum = 0;
        glm::dvec2 low(1e9), high(-1e9);
        for (const auto& line : lines)
            for (const auto& p : {line.a, line.b}) {
                low = {std::min(low.x, p.x), std::min(low.y, p.y)};
                high = {std::max(high.x, p.x), std::max(high.y, p.y)};
                sum += p.x + p.y;
            }
        QVERIFY(low.x >= -960 && low.x < -959 && low.y >= -720 && low.y < -719);
        QVERIFY(high.x < 960 && high.x > 959 && high.y < 720 && high.y > 719);
        QVERIFY(std::abs(sum / 400'000) < 5);
    }

    void everyFormIsTimedInEveryRunAndCountsItsLines()
    {
        std::vector<const clipping::Algorithm*> algorithms;
        for (const auto& algorithm : clipping::algorithms())
            algorithms.push_back(&algorithm);
        const auto all = app::contestants(algorithms);
        QVERIFY(all.size() > algorithms.size());
        const app::ExperimentOptions options{
            .lines = 1'000'345, .runs = 2, .seed = 4}; // two blocks
        std::vector<clipping::Segment> lines(options.lines);
        app::PaperScene(options.seed).fill(lines);
        std::vector<clipping::Clipped> visible(lines.size());
        for (const app::Timing& timing : app::experiment(options, all)) {
            const auto& uses =
                *clipping::usesOf(*timing.contestant.algorithm, timing.contestant.form);
            QCOMPARE(timing.nanoseconds.size(), options.runs);
            QCOMPARE(timing.visible, uses.clipAll(lines, app::paperWindow, visible));
            QVERIFY(std::ranges::all_of(timing.nanoseconds, [](double ns) { return ns > 0.1; }));
        }
    }

    void medianAndSpread()
    {
        const app::Timing timing{{}, {5, 1, 4, 2, 3}, 0};
        QCOMPARE(timing.median(), 3.0);
        QCOMPARE(timing.spread(), 2.0);
        QCOMPARE((app::Timing{{}, {1, 2}, 0}).median(), 1.5);
        QCOMPARE((app::Timing{{}, {7}, 0}).spread(), 0.0);
    }
};

QTEST_APPLESS_MAIN(ExperimentTest)
#include "experiment_test.moc"
