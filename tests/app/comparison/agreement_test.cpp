// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/agreement.h"

#include <QTest>

#include <random>

using namespace clipping;

class AgreementTest : public QObject {
    Q_OBJECT

private slots:
    void theyAgreeOnThePapersScene()
    {
        std::mt19937_64 random(1);
        std::uniform_real_distribution<double> x(-960, 960), y(-720, 720);
        std::vector<Segment> segments(20000);
        for (Segment& s : segments)
            s = {{x(random), y(random)}, {x(random), y(random)}};
        const auto found = app::dissents(segments, {{-100, -75}, {100, 75}}, *findAlgorithm("md"),
                                         Form::Corrected);
        QCOMPARE(app::sentence(found), "All algorithms, corrected, agree here");
    }
    /// Published KWC takes a line with |dx| < 1 for a vertical one at x1 (algorithms.md).
    void publishedFaultsAreCounted()
    {
        const std::vector<Segment> segments{{{-0.2, -10}, {0.6, 10}}, {{0, 0}, {1, 1}}};
        const Window window{{0, -5}, {10, 5}};
        const auto found = app::dissents(segments, window, *findAlgorithm("kwc"), Form::Published);
        QCOMPARE(found.size(), std::size_t(1));
        QCOMPARE(found[0].variant.form, Form::Published);
        QCOMPARE(found[0].lost + found[0].moved, std::size_t(1));
        QCOMPARE(found[0].segments, std::vector<std::uint32_t>{0});
        QVERIFY(app::sentence(found).startsWith("KWC as published "));
    }
    void nothingToCompare()
    {
        QVERIFY(app::dissents({}, {{0, 0}, {1, 1}}, algorithms()[0], Form::Published).empty());
    }
};

QTEST_APPLESS_MAIN(AgreementTest)
#include "agreement_test.moc"
