// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/agreement.h"
#include "app/comparison/difference.h"

#include <QTest>

#include <array>
#include <random>

#include "tests/app/scene/scene_lines_of.h"
#include "tests/test_class.h"

namespace comparison_agreement_test {

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
        const auto found = app::disagreements(sceneLinesOf(segments, 3'000),
                                              {{-100, -75}, {100, 75}}, {findAlgorithm("md")});
        QCOMPARE(app::sentence(found), "All corrected algorithms agree here");
    }
    /// Published KWC takes a line with |dx| < 1 for a vertical one at x1 (algorithms.md).
    void publishedFaultsAreCounted()
    {
        const std::vector<Segment> segments{{{-0.2, -10}, {0.6, 10}}, {{0, 0}, {1, 1}}};
        const Window window{{0, -5}, {10, 5}};
        const auto found = app::disagreements(sceneLinesOf(segments), window,
                                              {findAlgorithm("kwc"), Form::Published});
        QCOMPARE(found.size(), std::size_t(1));
        QCOMPARE(found[0].variant.form, Form::Published);
        QCOMPARE(found[0].lost + found[0].moved, std::size_t(1));
        QCOMPARE(found[0].segments, std::vector<std::uint32_t>{0});
        QVERIFY(app::sentence(found).startsWith("KWC as published "));
    }
    /// The panel Algorithm, the table Compare and the panes count alike.
    void theyAreCountedAsInOtherPlaces()
    {
        std::mt19937_64 random(3);
        std::uniform_real_distribution<double> x(-10, 10), little(-2, 2);
        std::vector<Segment> segments(20'000);
        for (Segment& s : segments) {
            s.a = {x(random), x(random)};
            s.b = s.a + app::Point(little(random), little(random));
        }
        const Window window{{-5, -5}, {5, 5}};
        const app::Variant exact{&exactAlgorithm()};
        for (const char* key : {"kwc", "skala", "cs"}) {
            const app::Variant published{findAlgorithm(key), Form::Published};
            const auto there = app::counted(app::differences(segments, window, published, exact,
                                                             app::contractUlps(published, exact)));
            const auto found = app::disagreements(sceneLinesOf(segments), window, published);
            QCOMPARE(found.empty(), there.all() == 0);
            if (found.empty())
                continue;
            QCOMPARE(found[0].lost, there.onlyB);
            QCOMPARE(found[0].shown, there.onlyA);
            QCOMPARE(found[0].moved, there.endsApart);
        }
    }
    /// In whichever blocks the lines are.
    void theyAreNumberedOverAllLines()
    {
        std::mt19937_64 random(2);
        std::uniform_real_distribution<double> x(-10, 10);
        std::vector<Segment> segments(1000);
        for (std::size_t i = 0; i < segments.size(); ++i) {
            const Segment any{{x(random), x(random)}, {x(random), x(random)}};
            segments[i] = i % 3 ? any : Segment{any.a, {any.a.x + 0.7, any.b.y}};
        }
        const Window window{{-5, -5}, {5, 5}};
        const auto found = [&](std::size_t inBlock) {
            return app::disagreements(sceneLinesOf(segments, inBlock), window,
                                      {findAlgorithm("kwc"), Form::Published});
        };
        const auto whole = found(1000);
        QCOMPARE(whole.front().variant.form, Form::Published);
        QVERIFY(whole.front().segments.size() > 50);
        for (const std::size_t inBlock : {1, 7, 999}) {
            const auto some = found(inBlock);
            QCOMPARE(some.size(), whole.size());
            for (std::size_t i = 0; i < some.size(); ++i) {
                QCOMPARE(some[i].variant, whole[i].variant);
                QCOMPARE(some[i].segments, whole[i].segments);
                QCOMPARE(some[i].lost, whole[i].lost);
                QCOMPARE(some[i].shown, whole[i].shown);
                QCOMPARE(some[i].moved, whole[i].moved);
            }
        }
    }
    /// A corner that was snapped to where two lines meet lies within an ulp of both: there most
    /// rows are wrong about one of them, and `exact` must not be told to be.
    void exactIsTheTruth()
    {
        std::mt19937_64 random(3);
        std::uniform_real_distribution<double> number(-100, 100);
        const auto point = [&] { return glm::dvec2(number(random), number(random)); };
        std::size_t wrong = 0;
        for (int i = 0; i < 300; ++i) {
            const std::array lines{Segment{point(), point()}, Segment{point(), point()}};
            const auto d = lines[0].b - lines[0].a, e = lines[1].b - lines[1].a;
            const auto from = lines[1].a - lines[0].a;
            const double t = (from.x * e.y - from.y * e.x) / (d.x * e.y - d.y * e.x);
            const glm::dvec2 corner = lines[0].a + t * d;
            const Window window{corner - glm::dvec2(50, 40), corner};
            const auto found =
                app::disagreements(sceneLinesOf(std::vector<Segment>(lines.begin(), lines.end())),
                                   window, {&algorithms()[0]});
            for (const app::Disagreement& one : found) {
                QVERIFY(one.variant.algorithm != &exactAlgorithm());
                wrong += one.segments.size();
            }
        }
        QVERIFY(wrong > 0);
    }
    void nothingToCompare()
    {
        QVERIFY(
            app::disagreements({}, {{0, 0}, {1, 1}}, {&algorithms()[0], Form::Published}).empty());
    }
};

} // namespace comparison_agreement_test

TEST_CLASS(comparison_agreement_test::AgreementTest, None)
#include "tests/app/comparison/agreement_test.moc"
