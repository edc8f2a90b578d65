// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/random.h"
#include "app/comparison/line_class.h"
#include "app/experiment/test_scene.h"

#include <QSet>
#include <QTest>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

#include "tests/app/scene/scene_lines_of.h"
#include "tests/clipping/oracle.h"
#include "tests/test_class.h"

namespace experiment_test_scene_test {

using app::LineClass;
using clipping::Segment;

namespace {

const app::Field otherField{{{-20, -30}, {50, 10}}, {{0.1, -0.7}, {3.3, 0.2}}};

std::vector<Segment> linesOf(const app::TestScene& scene, const app::Field& field,
                             std::uint64_t seed, std::size_t count)
{
    std::vector<Segment> lines(count);
    scene.begin(field, seed)(lines);
    return lines;
}

/// By whole numbers, apart from everything that the scenes are made with.
LineClass trueClass(const Segment& s, const clipping::Window& w)
{
    const auto beyond = [&](double a, double b, double low, double high) {
        return (a < low && b < low) || (a > high && b > high);
    };
    const auto inside = [&](const glm::dvec2& p) {
        return p.x >= w.min.x && p.x <= w.max.x && p.y >= w.min.y && p.y <= w.max.y;
    };
    if (inside(s.a) && inside(s.b))
        return LineClass::Inside;
    if (beyond(s.a.x, s.b.x, w.min.x, w.max.x) || beyond(s.a.y, s.b.y, w.min.y, w.max.y))
        return LineClass::Rejected;
    return oracle::inside(oracle::Line{{s.a.x, s.a.y}, {s.b.x, s.b.y}},
                          oracle::Box{{w.min.x, w.min.y}, {w.max.x, w.max.y}})
               ? LineClass::Cut
               : LineClass::Missed;
}

/// How many of 20,000 lines are of each class.
std::array<int, 4> mix(const app::TestScene& scene, const app::Field& field)
{
    std::array<int, 4> counts{};
    for (const Segment& line : linesOf(scene, field, 9, 20'000)) {
        const LineClass lineClass = trueClass(line, field.window);
        if (lineClass != app::lineClassOf(line, field.window))
            qFatal("a line is of another class than the truth says");
        ++counts[std::size_t(lineClass)];
    }
    return counts;
}

} // namespace

class TestSceneTest : public QObject {
    Q_OBJECT

private slots:
    void scenesHaveKeysNamesAndMeanings()
    {
        QSet<QString> keys;
        for (const app::TestScene& scene : app::testScenes()) {
            keys << scene.key;
            QVERIFY(!scene.name.isEmpty() && scene.meaning.endsWith('.'));
            QCOMPARE(app::findTestScene(scene.key)->name, scene.name);
        }
        QCOMPARE(std::size_t(keys.size()), app::testScenes().size());
        QCOMPARE(app::testScenes()[0].key, "paper");
        QVERIFY(!app::findTestScene(u"nothing"));
    }

    void theSeedAloneSaysWhichLinesWhateverTheBlocks()
    {
        for (const app::TestScene& scene : app::testScenes()) {
            const auto lines = linesOf(scene, {}, 7, 1000);
            std::vector<Segment> again(1000);
            const auto source = scene.begin({}, 7);
            source(std::span(again).first(1));
            source(std::span(again).subspan(1, 500));
            source(std::span(again).subspan(501));
            QCOMPARE(again, lines);
            QVERIFY(linesOf(scene, {}, 8, 1000) != lines);
        }
    }

    void everySceneIsMadeOfWhatItSays()
    {
        for (const app::Field& field : {app::Field{}, otherField}) {
            const auto mixOf = [&](QStringView key) {
                return mix(*app::findTestScene(key), field);
            };
            QCOMPARE(mixOf(u"inside"), (std::array{20'000, 0, 0, 0}));
            QCOMPARE(mixOf(u"rejected"), (std::array{0, 20'000, 0, 0}));
            QCOMPARE(mixOf(u"crossing"), (std::array{0, 0, 20'000, 0}));
            QCOMPARE(mixOf(u"near-miss"), (std::array{0, 0, 0, 20'000}));
        }
    }

    void thePapersMixIsThePapers()
    {
        const auto counts = mix(*app::findTestScene(u"paper"), {}); // 0.01, 64.2, 16.4, 19.4 %
        QVERIFY(counts[0] < 10);
        QVERIFY(counts[1] > 12'500 && counts[1] < 13'200);
        QVERIFY(counts[2] > 3'100 && counts[2] < 3'450);
    }

    void onlyLongLinesLeaveTheSpace()
    {
        for (const app::TestScene& scene : app::testScenes())
            for (const Segment& line : linesOf(scene, otherField, 3, 5000)) {
                const auto& [min, max] = otherField.space;
                const bool within = std::min(line.a.x, line.b.x) >= min.x
                                    && std::max(line.a.x, line.b.x) <= max.x
                                    && std::min(line.a.y, line.b.y) >= min.y
                                    && std::max(line.a.y, line.b.y) <= max.y;
                QVERIFY(within || scene.key == "long");
                if (scene.key == "long")
                    QVERIFY(std::abs(glm::distance(line.a, line.b) / 70'000 - 1) < 1e-9);
            }
    }

    void nearMissesComeFromAllFourCornersAndLieClose()
    {
        std::array<int, 4> corners{};
        const auto window = app::paperWindow;
        for (const Segment& line : linesOf(*app::findTestScene(u"near-miss"), {}, 5, 4000)) {
            int nearest = -1;
            double least = 1e9;
            for (int i = 0; i < 4; ++i) {
                const glm::dvec2 corner{i & 1 ? window.max.x : window.min.x,
                                        i & 2 ? window.max.y : window.min.y};
                const glm::dvec2 d = line.b - line.a, c = corner - line.a;
                const double away = std::abs(d.x * c.y - d.y * c.x) / glm::length(d);
                if (away < least)
                    least = away, nearest = i;
            }
            QVERIFY(least < 25);
            ++corners[std::size_t(nearest)];
        }
        QVERIFY(std::ranges::all_of(corners, [](int count) { return count > 900; }));
    }

    void linesComeWhereverTheWindowIs()
    {
        std::vector<app::Field> fields{{app::paperSpace, {{-955, -716}, {955, 716}}}};
        app::Random random(11);
        for (int i = 0; i < 40; ++i) { // all sides of their own, down to a hundred-millionth
            const auto side = [&] { return 900 * std::pow(10, random.between(-8, 0)); };
            fields.push_back({{{-1000, -1000}, {1000, 1000}},
                              {{side() - 1000, side() - 1000}, {1000 - side(), 1000 - side()}}});
        }
        const std::array made{u"inside", u"rejected", u"crossing", u"near-miss"};
        for (const app::Field& field : fields)
            for (std::size_t c = 0; c < made.size(); ++c)
                for (const Segment& line : linesOf(*app::findTestScene(made[c]), field, 6, 300)) {
                    QCOMPARE(trueClass(line, field.window), app::lineClasses[c]);
                    for (const glm::dvec2& p : {line.a, line.b})
                        QCOMPARE(glm::clamp(p, field.space.min, field.space.max), p);
                }
        // There is no number between window and space: anything, but in no time.
        const double most = std::nextafter(1000.0, 0.0);
        const app::Field coarse{{{-1000, -1000}, {1000, 1000}}, {{-most, -most}, {most, most}}};
        for (const app::TestScene& scene : app::testScenes())
            QCOMPARE(linesOf(scene, coarse, 6, 10'000).size(), 10'000u);
    }

    void aDrawingIsRepeated()
    {
        const std::vector<Segment> lines{{{0, 1}, {2, 3}}, {{4, 5}, {6, 7}}, {{8, 9}, {9, 8}}};
        const auto scene = app::repeatedScene("Bee", lines);
        QCOMPARE(scene.lines, 3u);
        QCOMPARE(scene.name, "Bee");
        const auto all = linesOf(scene, {}, 1, 7);
        for (std::size_t i = 0; i < all.size(); ++i)
            QCOMPARE(all[i], lines[i % 3]);
    }

    void itsLinesMayLieInSeveralBlocks()
    {
        std::vector<Segment> lines(1000);
        for (std::size_t i = 0; i < lines.size(); ++i)
            lines[i] = {{double(i), 0}, {0, 1}};
        const auto scene = app::drawingScene("Bee", sceneLinesOf(lines, 70));
        QCOMPARE(scene.lines, 1000u);
        const auto next = scene.begin({}, 1);
        std::vector<Segment> some(333);
        for (std::size_t first = 0; first < 5000; first += some.size()) {
            next(some);
            for (std::size_t i = 0; i < some.size(); ++i)
                QCOMPARE(some[i], lines[(first + i) % lines.size()]);
        }
    }

    void thereMustBeRoomAroundTheWindow()
    {
        QVERIFY(app::hasRoom({}));
        QVERIFY(app::hasRoom(otherField));
        QVERIFY(!app::hasRoom({app::paperWindow, app::paperWindow}));
        QVERIFY(!app::hasRoom({app::paperSpace, {{5, 0}, {5, 1}}}));
    }
};

} // namespace experiment_test_scene_test

TEST_CLASS(experiment_test_scene_test::TestSceneTest, None)
#include "tests/app/experiment/test_scene_test.moc"
